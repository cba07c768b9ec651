// The circle diagram: the bookkeeping of the instant centres. Bodies stand on a circle, a full chord is a centre given by a pair,
// a dashed one a centre found by Kennedy's theorem, numbered in the order found where there is room. Computes nothing.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/figures/figure.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render {

Figure circle_diagram(const DrawingContext& context, double room_x, double room_y) {
    const Solution& solution = context.solution;
    const Mechanism& mechanism = solution.mechanism;
    const Theme& theme = context.theme;
    const std::size_t count = mechanism.bodies.size();

    Figure figure;
    figure.kind = "centres";
    figure.id = "circle-diagram";
    figure.unit = "mm";
    figure.caption = one_piece(word("circle diagram", context.language));

    constexpr double node = 2.3;
    const double most = 0.5 * std::min(room_x, room_y) - node - 4;
    const double radius = std::clamp(4.2 * static_cast<double>(count), std::min(12.0, most), std::max(12.0, most));
    // The frame at the top, then clockwise in the file's order.
    const auto angle_of = [&](double body) {
        return -std::numbers::pi / 2 + 2 * std::numbers::pi * body / static_cast<double>(count);
    };
    const auto place = [&](int body) { return radius * Spot{std::cos(angle_of(body)), std::sin(angle_of(body))}; };

    std::vector<Mark>& marks = figure.marks;
    marks.emplace_back(GroupBegin{"figure", figure.id, plain(figure.caption), {{"data-figure", figure.kind}}});
    for (std::size_t b = 0; b < count; ++b) {
        const double half = 2 * std::asin(std::min(1.0, (node + 0.2) / (2 * radius)));
        const double from = angle_of(static_cast<double>(b)) + half, to = angle_of(static_cast<double>(b + 1)) - half;
        if (to <= from) continue;
        Path arc;
        arc.segments = {MoveTo{radius * Spot{std::cos(from), std::sin(from)}}, ArcTo{{0, 0}, radius, from, to}};
        arc.stroked = true;
        arc.pen = {theme.thin, theme.faint, {}, false};
        marks.emplace_back(std::move(arc));
    }

    std::vector<const InstantCentre*> found;
    for (const InstantCentre& centre : solution.centres) {
        if (centre.how == InstantCentre::How::unknown || (!centre.at && !centre.everywhere)) continue;
        const Spot from = place(centre.first), to = place(centre.second), along = unit(to - from);
        Pen pen{theme.outline, theme.text, {}, false};
        if (centre.how != InstantCentre::How::primary) {
            found.push_back(&centre);
            pen = {theme.thin, theme.text, dashes(), false};
        }
        marks.emplace_back(line(from + node * along, to - node * along, pen));
        belong(marks, marks.size() - 1, centre.statement);
    }
    for (std::size_t b = 0; b < count; ++b) {
        const int body = static_cast<int>(b);
        const Colour ink = body == 0 ? theme.text : theme.body(body).letter;
        const Colour rim = body == 0 ? theme.text : theme.body(body).line;
        const std::vector<double> kind = body == 0 ? std::vector<double>{} : theme.body(body).dashes;
        marks.emplace_back(
            ring(place(body), node, theme.paper, {theme.outline, rim, going_round(kind, 2 * std::numbers::pi * node), false}));
        // A long name stands outside its circle.
        const ShapedLine name = context.fonts.shape(one_piece(mechanism.bodies[b].name), theme.derived);
        if (name.width < 3.7) {
            set_text(marks, name, place(body) + Spot{-name.width / 2, (name.ascent - name.descent) / 2}, ink, "label");
        } else {
            const Spot out = unit(place(body));
            const double reach = node + 1 + std::abs(out.x) * name.width / 2 + std::abs(out.y) * name.ascent / 2;
            const Spot middle = place(body) + reach * out;
            marks.emplace_back(disc(place(body), 0.8, rim));
            set_text(marks, name, middle + Spot{-name.width / 2, (name.ascent - name.descent) / 2}, ink, "label");
        }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const InstantCentre* a, const InstantCentre* b) { return a->order < b->order; });
    // In a circle too small for its bodies the numbers would only crowd what they count.
    constexpr double numbers_need = 3.6;  // mm of radius for each body
    const bool numbered = radius >= numbers_need * static_cast<double>(count) - 1e-9;
    for (std::size_t i = 0; numbered && i < found.size(); ++i) {
        const Spot from = place(found[i]->first), to = place(found[i]->second);
        LabelRequest request;
        request.text = one_piece(std::to_string(i + 1));
        request.size = theme.small;
        request.colour = theme.secondary;
        request.anchor = 0.5 * (from + to);
        request.toward = to;
        request.clearance = 0.7;
        request.statement = found[i]->statement;
        figure.labels.push_back(std::move(request));
    }
    marks.emplace_back(GroupEnd{});
    figure.box = box_of(marks);
    place_labels(figure, context.fonts, Spot{room_x, room_y});
    figure.move(-figure.box.min.x, -figure.box.min.y);
    return figure;
}

}  // namespace kinegraph::render
