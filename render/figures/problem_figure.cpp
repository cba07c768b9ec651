#include "render/figures/problem_figure.hpp"

#include <algorithm>
#include <utility>

#include "render/page/labels.hpp"
#include "render/page/scale.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render {

Figure begun(const char* kind, const char* id, const Words& caption, double scale, const std::string& unit,
             Language language) {
    Figure figure;
    figure.data_figure = kind;
    figure.id = id;
    figure.caption = one_piece(in(caption, language));
    figure.scale = scale;
    figure.unit = unit;
    figure.marks.emplace_back(group_of(figure));
    return figure;
}

Figure finished(Figure figure, const DrawingContext& context, Spot room) {
    figure.marks.emplace_back(GroupEnd{});
    figure.box = box_of(figure.marks);
    place_labels(figure, context.fonts, room, Labelling::strict, context.theme.secondary);
    figure.move(-figure.box.min.x, -figure.box.min.y);
    return figure;
}

void draw_pivot_on_frame(std::vector<Mark>& marks, Spot pin, Spot down, Colour colour, const Theme& theme) {
    // As the ground of mechanisms: hatching at 45° that is thinner than the line over it and ends with it.
    constexpr double height = 5.5, half = 3.2, wall = 4.8, pitch = 1.6, depth = 2;  // mm
    const Spot foot = pin + height * down, along = turned(down), end = foot - wall * along;
    const Pen outline{theme.outline, theme.text, {}, false};
    marks.emplace_back(polyline({pin, foot - half * along, foot + half * along}, outline, true));
    marks.emplace_back(line(end, foot + wall * along, outline));
    for (double at = pitch; at <= 2 * wall; at += pitch) {
        const double back = std::min(depth, at);
        marks.emplace_back(
            line(end + at * along, end + (at - back) * along + back * down, {theme.thin, theme.text, {}, false}));
    }
    marks.emplace_back(ring(pin, 1.3, theme.paper, {theme.outline, colour, {}, false}));
}

}  // namespace kinegraph::render
