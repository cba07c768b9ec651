// Links: their strokes, which lies above which, the gaps where one passes over another, their numbers.
#include <algorithm>
#include <cmath>

#include "render/mechanism/symbols.hpp"

namespace kinegraph::render::drawing {

void draw_strokes(const Shape& shape, const Pen& stroke, std::vector<Mark>& marks) {
    if (shape.solid) marks.emplace_back(filled(shape.plate, stroke.colour));
    if (!shape.plate.empty()) marks.emplace_back(polyline(shape.plate, stroke, true));
    for (const Bar& bar : shape.bars)
        if (length(bar) > 1e-6) marks.emplace_back(line(bar.from, bar.to, stroke));
    for (const Bar& edge : shape.edges) {
        const Spot across = (stroke.width / 2) * turned(direction(edge));
        marks.emplace_back(filled({edge.from + across, edge.to, edge.from - across}, stroke.colour));
    }
}

namespace {

/// above[a][b]: a is drawn after b.
std::vector<std::vector<bool>> stacking(const Layout& layout) {
    const std::size_t n = layout.mechanism.bodies.size();
    std::vector<std::vector<bool>> above(n, std::vector<bool>(n, false));
    for (const Joint& joint : layout.mechanism.joints) {
        if (!is_slide(joint)) continue;
        const std::size_t block = at_index(joint.bodies[0]), guide = at_index(joint.bodies[1]);
        above[block][guide] = true;
        for (const Joint& other : layout.mechanism.joints) {
            if (other.point != joint.point || !other.pair().is_hinge()) continue;
            for (const BodyIndex body : other.bodies)
                if (at_index(body) != block && at_index(body) != guide) above[at_index(body)][block] = true;
        }
    }
    for (std::size_t a = 1; a < n; ++a)
        for (std::size_t b = 1; b < n; ++b)
            if (layout.lies_on(BodyIndex(a), BodyIndex(b)) && !above[b][a]) above[a][b] = true;
    return above;
}

/// A pin or a block says by itself what is joined.
bool is_joined(const Layout& layout, Spot at) {
    for (const Joint& joint : layout.mechanism.joints) {
        const Spot d = at - layout.spot(joint);
        const double link = layout.theme.link;
        if (length(d) < layout.measures.pin_radius + link) return true;
        if (joint.pair().is_sleeve() && std::abs(dot(d, layout.guide(joint))) < layout.measures.slider_half + link &&
            std::abs(cross(d, layout.guide(joint))) < layout.measures.slider_side + link)
            return true;
    }
    return false;
}

/// The piece of `over` that parts `under` where the two cross well within both and are not joined.
std::optional<Bar> gap_at_crossing(const Layout& layout, const Bar& under, const Bar& over, double gap) {
    constexpr double least_sine = 0.25;
    const double link = layout.theme.link;
    const Spot u = over.to - over.from, v = under.to - under.from, d = under.from - over.from;
    const double whole_u = length(u), whole_v = length(v), turn = cross(u, v);
    if (std::abs(turn) < least_sine * whole_u * whole_v) return std::nullopt;
    const double t = cross(d, v) / turn * whole_u, w = cross(d, u) / turn * whole_v;
    if (t < link || t > whole_u - link || w < link || w > whole_v - link) return std::nullopt;
    const Spot at = over.from + (t / whole_u) * u;
    if (is_joined(layout, at)) return std::nullopt;
    const double sine = std::abs(turn) / (whole_u * whole_v), cosine = std::abs(dot(u, v)) / (whole_u * whole_v);
    const double half = (0.5 * link + (0.5 * link + gap) * cosine) / sine + 0.1;
    const Spot along = half * unit(u);
    return Bar{at - along, at + along};
}

/// Where a link passes over others that it does not join: the lower one is interrupted on both sides of it.
void draw_crossings(Sketch& sketch, BodyIndex body, const std::vector<BodyIndex>& below, std::vector<Mark>& marks) {
    constexpr double gap = 0.7;
    for (const BodyIndex lower : below) {
        std::vector<Path> gaps;
        for (const Bar& under : sketch.shape(lower).strokes)
            for (const Bar& over : sketch.shape(body).strokes)
                if (const auto bar = gap_at_crossing(sketch, under, over, gap))
                    gaps.push_back(line(bar->from, bar->to, {sketch.theme.link + 2 * gap, sketch.theme.paper, {}, false}));
        if (gaps.empty()) continue;
        const std::string names = sketch.mechanism.body(lower).name + "." + sketch.mechanism.body(body).name;
        marks.emplace_back(GroupBegin{"crossing", sketch.id("crossing", names), {}, {}});
        for (Path& path : gaps) marks.emplace_back(std::move(path));
        marks.emplace_back(GroupEnd{});
    }
}

/// Of two links in line (a dead point) the shorter one lies on top, narrower, so that both are seen.
double width_of(const Sketch& sketch, BodyIndex body) {
    for (const BodyIndex other : sketch.mechanism.moving_bodies())
        if (sketch.lies_on(body, other)) return 0.5 * sketch.theme.link;
    return sketch.theme.link;
}

}  // namespace

std::vector<BodyIndex> drawing_order(const Layout& layout) {
    const std::vector<std::vector<bool>> above = stacking(layout);
    const std::size_t n = above.size();
    std::vector<BodyIndex> order;
    std::vector<bool> done(n, false);
    const auto is_free = [&](std::size_t body) {
        for (std::size_t below = 0; below < n; ++below)
            if (!done[below] && above[body][below]) return false;
        return true;
    };
    while (order.size() < n) {
        std::size_t next = 0;
        while (next < n && (done[next] || !is_free(next))) ++next;
        if (next == n)  // the orders contradict each other: take the first
            next = static_cast<std::size_t>(std::find(done.begin(), done.end(), false) - done.begin());
        done[next] = true;
        order.emplace_back(next);
    }
    return order;
}

void draw_link(Sketch& sketch, BodyIndex body, const std::vector<BodyIndex>& below) {
    const Body& data = sketch.mechanism.body(body);
    const Theme& theme = sketch.theme;
    const BodyColour colour = theme.colour_of(body);
    const Shape& shape = sketch.shape(body);
    std::vector<Mark> marks;
    draw_profiles(sketch, body, marks);
    draw_crossings(sketch, body, below, marks);
    if (!shape.plate.empty() && !shape.solid) sketch.tints.emplace_back(tinted(filled(shape.plate, colour.tint)));
    draw_strokes(shape, {width_of(sketch, body), colour.line, {}, true}, marks);
    draw_line_kind(marks, 0, 0.5 * theme.link, colour, theme);
    for (const Cylinder& cylinder : sketch.cylinders())
        if (sketch.mechanism.joint(cylinder.joint).bodies[1] == body) draw_barrel(sketch, cylinder, marks);
    // The block covers the end of its own rod: they are one piece.
    draw_sliding_parts(sketch, body, marks);
    const std::string& words = in(data.label, sketch.context.language);
    sketch.bodies.emplace_back(
        GroupBegin{"link", sketch.id("link", data.name), words.empty() ? data.name : data.name + ": " + words, {}});
    for (Mark& mark : marks) sketch.bodies.push_back(std::move(mark));
    sketch.bodies.emplace_back(GroupEnd{});
}

void draw_balloon(Sketch& sketch, BodyIndex body) {
    const Body& data = sketch.mechanism.body(body);
    const Shape& shape = sketch.shape(body);
    const Theme& theme = sketch.theme;
    LabelRequest request{.text = one_piece(data.name),
                         .size = data.name.size() > 1 ? theme.small : theme.derived,
                         .colour = theme.colour_of(body).letter,
                         .anchor = shape.middle,
                         .clearance = 6.4,
                         .dashes = theme.body(body).dashes};
    if (sketch.context.fonts.shape(request.text, request.size).width < 3.7)
        request.balloon = 2.3;
    else
        request.size = theme.derived;
    const auto stand_at = [&](Spot anchor, Spot toward, double clearance) {
        request.anchor = anchor;
        request.toward = toward;
        request.clearance = clearance;
    };
    if (!shape.strokes.empty() && length(longest_of(shape.strokes)) > 6) {
        const Bar& longest = longest_of(shape.strokes);
        stand_at(middle(longest), longest.to, 2.7);
    } else {
        // A block or a wheel: beside it.
        for (const Joint& joint : sketch.mechanism.joints) {
            if (!joint.pair().is_sleeve() || joint.bodies[0] != body) continue;
            const auto [half, side] = sketch.block(joint);
            stand_at(sketch.spot(joint), sketch.spot(joint) + (half + 2) * sketch.guide(joint), side + 2.2);
        }
        if (data.circle) {
            const double radius = data.circle->radius.to_double() / sketch.scale();
            const Spot on_rim = sketch.spot(data.circle->centre) + (radius * std::sqrt(0.5)) * Spot{1, -1};
            stand_at(on_rim, on_rim + 4.0 * Spot{1, 1}, 1.8);
        }
    }
    sketch.labels.push_back(std::move(request));
}

}  // namespace kinegraph::render::drawing
