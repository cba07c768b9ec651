// The circle diagram: the bookkeeping of the instant centres. Bodies stand on a circle, a full chord is a centre given by a pair,
// a dashed one a centre found by Kennedy's theorem, numbered in the order found where there is room. Computes nothing.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/figures/figure.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render {

namespace {

constexpr double node = 2.3;  // radius of a body's circle, mm

class CircleDiagram {
public:
    CircleDiagram(const DrawingContext& context, double room)
        : context_(context), theme_(context.theme), count_(static_cast<int>(context.solution.mechanism.bodies.size())) {
        const double most = 0.5 * room - node - 4;
        radius_ = std::clamp(4.2 * count_, std::min(12.0, most), std::max(12.0, most));
    }

    Figure draw() {
        figure_.kind = "centres";
        figure_.id = "circle-diagram";
        figure_.unit = "mm";
        figure_.caption = one_piece(word("circle diagram", context_.language));
        figure_.marks.emplace_back(
            GroupBegin{"figure", figure_.id, plain(figure_.caption), {{"data-figure", figure_.kind}}});
        draw_circle();
        const std::vector<const InstantCentre*> found = draw_chords();
        for (int body = 0; body < count_; ++body) draw_body(body);
        number_chords(found);
        figure_.marks.emplace_back(GroupEnd{});
        figure_.box = box_of(figure_.marks);
        return std::move(figure_);
    }

private:
    /// The frame at the top, then clockwise in the file's order.
    double angle(int body) const { return -std::numbers::pi / 2 + 2 * std::numbers::pi * body / count_; }
    Spot place(int body) const { return radius_ * polar_spot(angle(body)); }

    /// The circle between the bodies.
    void draw_circle() {
        const double half = 2 * std::asin(std::min(1.0, (node + 0.2) / (2 * radius_)));
        for (int body = 0; body < count_; ++body)
            if (const double from = angle(body) + half, to = angle(body + 1) - half; to > from)
                figure_.marks.emplace_back(arc({0, 0}, radius_, from, to, {theme_.thin, theme_.faint, {}, false}));
    }

    /// All centres; those that were found, in their order.
    std::vector<const InstantCentre*> draw_chords() {
        std::vector<const InstantCentre*> found;
        for (const InstantCentre& centre : context_.solution.centres) {
            if (centre.how == InstantCentre::How::unknown || (!centre.at && !centre.everywhere)) continue;
            const Spot from = place(centre.first), to = place(centre.second), along = unit(to - from);
            const bool given = centre.how == InstantCentre::How::primary;
            if (!given) found.push_back(&centre);
            const Pen pen = given ? Pen{theme_.outline, theme_.text, {}, false} : Pen{theme_.thin, theme_.text, dashes(), false};
            figure_.marks.emplace_back(line(from + node * along, to - node * along, pen));
            belong(figure_.marks, figure_.marks.size() - 1, centre.statement);
        }
        std::stable_sort(found.begin(), found.end(),
                         [](const InstantCentre* a, const InstantCentre* b) { return a->order < b->order; });
        return found;
    }

    void draw_body(int body) {
        const BodyColour colour = theme_.colour_of(body);
        const std::vector<double> kind = going_round(colour.dashes, 2 * std::numbers::pi * node);
        figure_.marks.emplace_back(ring(place(body), node, theme_.paper, {theme_.outline, colour.line, kind, false}));
        const ShapedLine name =
            context_.fonts.shape(one_piece(context_.solution.mechanism.body(body).name), theme_.derived);
        Spot middle = place(body);
        if (name.width >= 3.7) {
            // A long name stands outside its circle.
            const Spot out = unit(place(body));
            figure_.marks.emplace_back(disc(place(body), 0.8, colour.line));
            middle = middle + (node + 1 + std::abs(out.x) * name.width / 2 + std::abs(out.y) * name.ascent / 2) * out;
        }
        set_text(figure_.marks, name, middle + Spot{-name.width / 2, (name.ascent - name.descent) / 2}, colour.letter, "label");
    }

    /// In a circle too small for its bodies the numbers would only crowd what they count.
    void number_chords(const std::vector<const InstantCentre*>& found) {
        constexpr double numbers_need = 3.6;  // mm of radius for each body
        if (radius_ < numbers_need * count_ - 1e-9) return;
        for (std::size_t i = 0; i < found.size(); ++i) {
            const Spot from = place(found[i]->first), to = place(found[i]->second);
            figure_.labels.push_back({.text = one_piece(std::to_string(i + 1)),
                                      .size = theme_.small,
                                      .colour = theme_.secondary,
                                      .anchor = 0.5 * (from + to),
                                      .toward = to,
                                      .clearance = 0.7,
                                      .statement = found[i]->statement});
        }
    }

    const DrawingContext& context_;
    const Theme& theme_;
    int count_;
    double radius_;
    Figure figure_;
};

}  // namespace

Figure circle_diagram(const DrawingContext& context, double room_x, double room_y) {
    Figure figure = CircleDiagram(context, std::min(room_x, room_y)).draw();
    place_labels(figure, context.fonts, Spot{room_x, room_y});
    figure.move(-figure.box.min.x, -figure.box.min.y);
    return figure;
}

}  // namespace kinegraph::render
