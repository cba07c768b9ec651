// Links: their strokes, their stacking order, gaps at crossings, and body numbers.
#include <algorithm>
#include <cmath>

#include "lang/keys/notation.hpp"
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

/// A pin or a block already shows what is connected.
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

/// The piece of `over` that interrupts `under`, if the two cross well inside both and are not connected.
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

/// Where a link passes over others that it is not connected to, the lower one is interrupted on both sides.
void draw_crossings(Sketch& sketch, BodyIndex body, const std::vector<BodyIndex>& below, std::vector<Mark>& marks) {
    constexpr double gap = 0.7;
    for (const BodyIndex lower : below) {
        std::vector<Path> gaps;
        for (const Bar& under : sketch.shape(lower).strokes)
            for (const Bar& over : sketch.shape(body).strokes)
                if (const auto bar = gap_at_crossing(sketch, under, over, gap))
                    gaps.push_back(
                        line(bar->from, bar->to, {sketch.theme.link + 2 * gap, sketch.theme.paper, {}, false}));
        if (gaps.empty()) continue;
        const std::string names = sketch.mechanism.body(lower).name + "." + sketch.mechanism.body(body).name;
        marks.emplace_back(GroupBegin{"crossing", sketch.id("crossing", names), {}, {}});
        for (Path& path : gaps) marks.emplace_back(std::move(path));
        marks.emplace_back(GroupEnd{});
    }
}

/// Of two links in line (a dead point) the shorter one lies on top and is narrower, so that both are visible.
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
        if (next == n)  // the orders are cyclic: take the first
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
    if (!shape.plate.empty() && !shape.slender) sketch.tints.emplace_back(tinted(filled(shape.plate, colour.tint)));
    // Ink in any theme, so that no name stands elsewhere in one with line kinds.
    if (shape.slender && !shape.solid) marks.emplace_back(filled(shape.plate, colour.tint));
    draw_strokes(shape, {width_of(sketch, body), colour.line, {}, true}, marks);
    draw_line_kind(marks, 0, 0.5 * theme.link, colour, theme);
    for (const Cylinder& cylinder : sketch.cylinders())
        if (sketch.mechanism.joint(cylinder.joint).bodies[1] == body) draw_barrel(sketch, cylinder, marks);
    // The block covers the end of its own rod, because they are one piece.
    draw_sliding_parts(sketch, body, marks);
    const std::string& words = in(data.label, sketch.context.language);
    const std::string title =
        words.empty() ? data.name : data.name + in(lang::notation::colon, sketch.context.language) + words;
    sketch.bodies.emplace_back(GroupBegin{"link", sketch.id("link", data.name), title, {}});
    for (Mark& mark : marks) sketch.bodies.push_back(std::move(mark));
    sketch.bodies.emplace_back(GroupEnd{});
}

namespace {

constexpr double balloon_radius = 2.3;

/// Preferred position of a body's number: about an anchor, or beside a line through it.
struct Stand {
    Spot anchor;
    std::optional<Spot> toward = std::nullopt;
    double clearance = 6.4;
};

/// Whether a number there would stand on the tint of another body's wheel, and so seem to belong to that.
bool is_on_other_wheel(const Layout& layout, BodyIndex body, Spot at) {
    for (const BodyIndex other : layout.mechanism.moving_bodies())
        for (const Rim& rim : layout.shape(other).rims) {
            if (other == body || rim.form == Rim::Form::arc || rim.hollow) continue;
            if (length(at - rim.centre) < rim.radius + balloon_radius) return true;
        }
    return false;
}

/// Whether a leader that ends there would seem to name a contact or a pin instead.
bool is_at_a_joint(const Layout& layout, Spot at) {
    constexpr double near = 4;  // mm
    return std::any_of(layout.mechanism.joints.begin(), layout.mechanism.joints.end(),
                       [&](const Joint& joint) { return length(layout.spot(joint) - at) < near; });
}

/// Beside the rim, preferably above on the right; else further round, or on the wheel's own tint.
Stand stand_at_wheel(const Layout& layout, BodyIndex body, Spot centre, double radius) {
    constexpr double off = 1.8, least_within = 9, foreign = 3;
    const auto price_of = [&](Spot at) { return is_on_other_wheel(layout, body, at) ? foreign : 0; };
    Cheapest<Stand> best;
    for (const int step : {0, 1, -1, 2, -2, 3, -3, 4}) {
        const Spot out = polar_spot((step - 1) * pi_number / 4), on_rim = centre + radius * out;
        const double price = 0.1 * std::abs(step) + (is_at_a_joint(layout, on_rim) ? 1 : 0);
        const Spot beside = on_rim + (off + balloon_radius) * out;
        // The first place needs no price for its surroundings: the placement of labels handles these.
        best.offer(price + price_of(beside) + (step == 0 ? 0 : layout.crowding(beside, centre)),
                   {on_rim, on_rim + 4 * std::sqrt(2.0) * turned(out), off});
        if (radius < least_within) continue;
        const Spot within = centre + 0.6 * radius * out;
        best.offer(price + 0.25 + price_of(within) + layout.crowding(within, centre), {within, std::nullopt, 0.3});
    }
    return best.choice;
}

/// Beside the longest line, at its middle unless another wheel covers both sides there.
Stand stand_at_line(const Layout& layout, BodyIndex body, const Bar& longest) {
    constexpr double off = 2.1;
    const Spot across = (off + balloon_radius) * turned(direction(longest));
    Cheapest<Stand> best;
    for (const double share : {0.5, 0.35, 0.65, 0.2, 0.8}) {
        const Spot at = middle(longest) + (share - 0.5) * (longest.to - longest.from);
        const bool is_free =
            !is_on_other_wheel(layout, body, at + across) || !is_on_other_wheel(layout, body, at - across);
        best.offer(std::abs(share - 0.5) + (is_free ? 0 : 1), {at, longest.to, off});
    }
    return best.choice;
}

Stand stand_of(const Sketch& sketch, BodyIndex body) {
    const Body& data = sketch.mechanism.body(body);
    const Shape& shape = sketch.shape(body);
    if (!shape.strokes.empty() && length(longest_of(shape.strokes)) > 6)
        return stand_at_line(sketch, body, longest_of(shape.strokes));
    // A block or a wheel: beside it.
    if (data.circle)
        return stand_at_wheel(sketch, body, sketch.spot(data.circle->centre),
                              data.circle->radius.to_double() / sketch.scale());
    Stand stand{shape.middle};
    for (const Joint& joint : sketch.mechanism.joints) {
        if (!joint.pair().is_sleeve() || joint.bodies[0] != body) continue;
        const auto [half, side] = sketch.block(joint);
        stand = {sketch.spot(joint), sketch.spot(joint) + (half + 2) * sketch.guide(joint), side + 2.2};
    }
    return stand;
}

/// The body's tint identifies its number, unless another body has the same tint.
BalloonGround ground_of(const Sketch& sketch, BodyIndex body) {
    const Theme& theme = sketch.theme;
    const Colour own = theme.body(body).tint;
    for (const BodyIndex other : sketch.mechanism.moving_bodies())
        if (other != body && theme.body(other).tint == own) return {theme.paper, std::nullopt, body};
    return {theme.paper, own, body};
}

}  // namespace

void draw_balloon(Sketch& sketch, BodyIndex body) {
    const Body& data = sketch.mechanism.body(body);
    const Theme& theme = sketch.theme;
    const Stand stand = stand_of(sketch, body);
    LabelRequest request{.text = one_piece(data.name),
                         .size = data.name.size() > 1 ? theme.small : theme.derived,
                         .colour = theme.colour_of(body).letter,
                         .anchor = stand.anchor,
                         .toward = stand.toward,
                         .clearance = stand.clearance,
                         .body = body,
                         .dashes = theme.body(body).dashes};
    if (sketch.context.fonts.shape(request.text, request.size).width < 3.7) {
        request.balloon = balloon_radius;
        request.ground = ground_of(sketch, body);
    } else {
        request.size = theme.derived;
    }
    sketch.labels.push_back(std::move(request));
}

}  // namespace kinegraph::render::drawing
