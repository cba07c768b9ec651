// The circle diagram of the instant centres. Bodies stand on a circle; a thick chord is a centre given by a pair, a
// thin one a centre found by Kennedy's theorem, numbered in the order found if there is space. Computes nothing.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/number/functions.hpp"
#include "lang/keys/sheet.hpp"
#include "render/figures/figure.hpp"
#include "render/figures/figure_table.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render {
namespace {

constexpr double node = 2.3;          // radius of a body's circle, mm
constexpr double numbers_need = 3.6;  // mm of radius for each body, or the chords could not be distinguished

class CircleDiagram {
public:
    CircleDiagram(const DrawingContext& context, double room_x, double room_y)
        : context_(context), theme_(context.theme), count_(context.solution.mechanism.bodies.size()) {
        const double most = 0.5 * std::min(room_x, room_y) - node - 4;
        radius_ = std::clamp(6.3 * static_cast<double>(count_), std::min(12.0, most), std::max(12.0, most));
        for (const InstantCentre& centre : context.solution.centres)
            if (centre.how != InstantCentre::How::unknown && (centre.at || centre.everywhere))
                chords_.push_back(&centre);
    }

    Figure figure() const {
        Figure figure = begun(context_, {FigureKind::circle_diagram});
        figure.unit = "mm";
        figure.has_scale = false;
        figure.marks.emplace_back(group_of(figure, false));
        draw_circle(figure.marks);
        draw_chords(figure.marks);
        draw_bodies(figure.marks);
        if (radius_ >= numbers_need * static_cast<double>(count_) - 1e-9) number_chords(figure.labels);
        figure.marks.emplace_back(GroupEnd{});
        figure.box = box_of(figure.marks);
        return figure;
    }

private:
    /// The frame at the top, then clockwise in the order of the file.
    double angle_of(std::size_t body) const {
        return -std::numbers::pi / 2 + 2 * std::numbers::pi * static_cast<double>(body) / static_cast<double>(count_);
    }
    Spot at(double angle) const { return radius_ * Spot{nearest::cos(angle), nearest::sin(angle)}; }
    Spot place(BodyIndex body) const { return at(angle_of(at_index(body))); }

    void draw_circle(std::vector<Mark>& marks) const {
        for (std::size_t b = 0; b < count_; ++b) {
            const double half = 2 * nearest::asin(std::min(1.0, (node + 0.2) / (2 * radius_)));
            const double from = angle_of(b) + half, to = angle_of(b + 1) - half;
            if (to <= from) continue;
            Path arc;
            arc.segments = {MoveTo{at(from)}, ArcTo{{0, 0}, radius_, from, to}};
            arc.stroked = true;
            arc.pen = {theme_.thin, theme_.faint, {}, false};
            marks.emplace_back(std::move(arc));
        }
    }
    void draw_chords(std::vector<Mark>& marks) const {
        for (const InstantCentre* centre : chords_) {
            const Spot from = place(centre->first), to = place(centre->second), along = unit(to - from);
            const bool primary = centre->how == InstantCentre::How::primary;
            const Pen pen =
                primary ? Pen{theme_.outline, theme_.text, {}, false} : Pen{theme_.thin, theme_.secondary, {}, false};
            marks.emplace_back(line(from + node * along, to - node * along, pen));
            belong(marks, marks.size() - 1, centre->statement);
        }
    }
    void draw_bodies(std::vector<Mark>& marks) const {
        for (std::size_t b = 0; b < count_; ++b) {
            const BodyIndex body(b);
            const BodyColour colour = theme_.colour_of(body);
            marks.emplace_back(
                ring(place(body), node, theme_.paper,
                     {theme_.outline, colour.line, going_round(colour.dashes, 2 * std::numbers::pi * node), false}));
            // A long name stands outside its circle.
            const ShapedLine name =
                context_.fonts.shape(one_piece(context_.solution.mechanism.bodies[b].name), theme_.derived);
            Spot middle = place(body);
            if (nearest::hypot(name.width / 2, name.ascent / 2) > node - theme_.outline / 2 - 0.4) {
                const Spot out = unit(middle);
                marks.emplace_back(disc(middle, 0.8, colour.line));
                middle =
                    middle + (node + 1 + std::abs(out.x) * name.width / 2 + std::abs(out.y) * name.ascent / 2) * out;
            }
            set_text(marks, name, middle + Spot{-name.width / 2, (name.ascent - name.descent) / 2}, colour.letter,
                     "label");
        }
    }
    void number_chords(std::vector<LabelRequest>& labels) const {
        std::vector<const InstantCentre*> found = chords_;
        std::erase_if(found, [](const InstantCentre* centre) { return centre->how == InstantCentre::How::primary; });
        std::stable_sort(found.begin(), found.end(),
                         [](const InstantCentre* a, const InstantCentre* b) { return a->order < b->order; });
        for (std::size_t i = 0; i < found.size(); ++i) {
            const Spot from = place(found[i]->first), to = place(found[i]->second);
            LabelRequest& request = labels.emplace_back();
            request.text = one_piece(std::to_string(i + 1));
            request.size = theme_.small;
            request.colour = theme_.secondary;
            request.anchor = 0.5 * (from + to);
            request.toward = to;
            request.clearance = 0.7;
            request.statement = found[i]->statement;
        }
    }

    const DrawingContext& context_;
    const Theme& theme_;
    std::size_t count_;  // of bodies
    double radius_ = 0;
    std::vector<const InstantCentre*> chords_;
};

}  // namespace

Figure circle_diagram(const DrawingContext& context, double room_x, double room_y) {
    Figure figure = CircleDiagram(context, room_x, room_y).figure();
    place_labels(figure, context.fonts, Spot{room_x, room_y}, Labelling::free, context.theme.secondary);
    figure.move(-figure.box.min.x, -figure.box.min.y);
    return figure;
}

namespace {

/// It shows the order of Kennedy's theorem. It is useful if there are more centres than can be followed directly, and
/// readable if its chords can be distinguished.
std::vector<int> has_circle(const Shown& shown, const LoadCase& /*all*/) {
    constexpr std::size_t most = 16;
    const std::size_t bodies = shown.solution().mechanism.bodies.size();
    return once(bodies >= 3 && bodies <= most && !shown.solution().centres.empty() && !shown.is_brief);
}
void measure_circle(const Shown& shown, FigureId /*one*/, SizeWanted& size) {
    const double diameter = 8.4 * static_cast<double>(shown.solution().mechanism.bodies.size());
    size.extent_x = size.extent_y = size.enough = std::clamp(diameter, 24.0, 56.0);
}
Figure draw_circle_diagram(const Shown& shown, FigureId /*one*/, Spot room, const ScaleWish& /*none*/) {
    return circle_diagram(shown.context, room.x, room.y);
}

}  // namespace

constinit const FigureFunctions circle_diagram_functions{has_circle, measure_circle, draw_circle_diagram};

}  // namespace kinegraph::render
