#include "render/figures/problem_figure.hpp"

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

}  // namespace kinegraph::render
