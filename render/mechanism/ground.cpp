// Ground: walls, hatched arcs, fixed pins and the guides of the frame.
#include <array>
#include <cmath>

#include "engine/number/functions.hpp"
#include "render/mechanism/symbols.hpp"

namespace kinegraph::render::drawing {

void draw_wall(Sketch& sketch, const Bar& wall, Spot away) {
    const Spot along = direction(wall);
    const double whole = length(wall), depth = sketch.measures.hatch_depth;
    Path strokes;
    strokes.stroked = true;
    strokes.pen = {sketch.theme.thin, sketch.theme.text, {}, false};
    const int count = std::max(2, static_cast<int>(std::floor(whole / sketch.measures.hatch_pitch)));
    const double pitch = whole / count;
    for (int i = 1; i <= count; ++i) {
        const double t = i * pitch, back = std::min(depth, t);
        strokes.segments.emplace_back(MoveTo{wall.from + t * along});
        strokes.segments.emplace_back(LineTo{wall.from + (t - back) * along + back * away});
    }
    sketch.ground.emplace_back(std::move(strokes));
    sketch.ground.emplace_back(line(wall.from, wall.to, sketch.outline()));
}

void hatch_arc(Sketch& sketch, const Arc& along, bool outwards) {
    const auto& [centre, radius, from, to] = along;
    Path hatching;
    hatching.stroked = true;
    hatching.pen = {sketch.theme.thin, sketch.theme.text, {}, false};
    const double depth = (outwards ? 1 : -1) * std::min(sketch.measures.hatch_depth, 0.4 * radius);
    const int count = std::max(4, static_cast<int>((to - from) * radius / sketch.measures.hatch_pitch));
    for (int i = 0; i < count; ++i) {
        const double angle = from + (to - from) * i / count, lean = angle + std::abs(depth) / radius;
        hatching.segments.emplace_back(MoveTo{along.at(angle)});
        hatching.segments.emplace_back(LineTo{centre + (radius + depth) * polar_spot(lean)});
    }
    sketch.ground.emplace_back(std::move(hatching));
}

namespace {

/// The share of the wall of a fixed pin and of its hatching that moving bodies pass over. Those that leave the pin are
/// judged by their directions.
double passed_over(const Sketch& sketch, Spot at, Spot down) {
    constexpr int pieces = 4;  // on each side
    const Measures& measures = sketch.measures;
    const Spot across = (measures.base_half / pieces) * turned(down);
    const double clear = sketch.theme.link / 2 + 0.4;
    int passed = 0;
    for (const double depth : {measures.triangle_height, measures.triangle_height + measures.hatch_depth})
        for (int i = -pieces; i <= pieces; ++i) {
            const Spot spot = at + depth * down + i * across;
            const auto passes = [&](const Bar& stroke) { return distance(spot, stroke) < clear; };
            for (const BodyIndex body : sketch.mechanism.moving_bodies()) {
                const std::vector<Bar>& strokes = sketch.shape(body).strokes;
                if (std::none_of(strokes.begin(), strokes.end(), passes)) continue;
                ++passed;
                break;
            }
        }
    return passed / (2.0 * (2 * pieces + 1));
}

/// Direction of the triangle of a fixed pin: down if possible, then sideways, then up; away from links.
Spot side_of_ground(const Sketch& sketch, PointIndex point) {
    const Spot at = sketch.spot(point);
    const double reach = sketch.measures.triangle_height + sketch.measures.hatch_depth + 2;
    std::vector<Spot> links = sketch.leaving(point);
    for (const Joint& joint : sketch.mechanism.joints)
        if (const Spot d = sketch.spot(joint) - at; length(d) > same_place && length(d) < reach)
            links.push_back(unit(d));  // a pin where the triangle would be
    const auto nearness = [](Spot a, Spot b) {
        return std::max(0.0, 1.2 - nearest::acos(std::clamp(dot(a, b), -1.0, 1.0)));
    };
    constexpr std::array<std::pair<Spot, double>, 4> choices{
        {{Spot{0, 1}, 0.0}, {Spot{1, 0}, 0.35}, {Spot{-1, 0}, 0.35}, {Spot{0, -1}, 0.6}}};
    Cheapest<Spot> best;
    for (const auto& [down, bias] : choices) {
        constexpr double under_bodies = 4;  // a wall that half lies under a bar costs more than any other direction
        double price = bias + under_bodies * passed_over(sketch, at, down);
        for (const Spot link : links) price += 2.5 * nearness(link, down);
        best.offer(price, down);
    }
    return best.choice;
}

/// The intervals of a wall beside a guide that links leave free. If a link passing beside the block would leave only a
/// stub, that side stays open.
std::vector<Interval> open_where_links_pass(const std::vector<Spot>& links, Interval wall, Spot along, Spot away,
                                            double aside, double block_half) {
    std::vector<Interval> pieces{wall};
    for (const Spot link : links) {
        const double rise = dot(link, away), run = dot(link, along);
        if (rise < 0.08) continue;
        const double crossing = aside * run / rise, gap = 2.6 / rise + 1.2 * std::abs(run) / rise;
        if (std::abs(crossing) - gap < block_half) return {};
        std::vector<Interval> rest;
        for (const Interval piece : pieces) {
            if (piece.from < crossing - gap) rest.push_back({piece.from, std::min(piece.to, crossing - gap)});
            if (piece.to > crossing + gap) rest.push_back({std::max(piece.from, crossing + gap), piece.to});
        }
        pieces = rest;
    }
    return pieces;
}

void draw_walls(Sketch& sketch, const Joint& guide, double aside, double half, bool heed_links) {
    const Spot at = sketch.spot(guide), along = sketch.guide(guide);
    const std::vector<Spot> links = heed_links ? sketch.leaving(guide.point) : std::vector<Spot>{};
    for (const double side : {1.0, -1.0}) {
        const Spot away = side * turned(along);
        for (const auto& [from, to] :
             open_where_links_pass(links, {-half, half}, along, away, aside, sketch.measures.slider_half))
            if (to - from > 6)
                draw_wall(sketch, {at + from * along + aside * away, at + to * along + aside * away}, away);
    }
}

void draw_axis_of_guide(Sketch& sketch, const Joint& guide) {
    const double half = sketch.measures.slider_half + sketch.measures.axis_beyond;
    const Spot at = sketch.spot(guide), along = sketch.guide(guide);
    sketch.construction.emplace_back(line(at - half * along, at + half * along, sketch.axis()));
}

/// A wall ends before the next pin.
double reach_of_wall(const Sketch& sketch, const Joint& guide) {
    const double half = sketch.measures.slider_half;
    double reach = half + sketch.measures.wall_beyond;
    for (const Joint& other : sketch.mechanism.joints) {
        const Spot d = sketch.spot(other) - sketch.spot(guide), along = sketch.guide(guide);
        const double ahead = std::abs(dot(d, along));
        if (ahead > half && std::abs(cross(d, along)) < sketch.measures.slider_side + 3)
            reach = std::min(reach, std::max(ahead - 3.5, half + 2));
    }
    return reach;
}

}  // namespace

void draw_fixed_pin(Sketch& sketch, PointIndex point) {
    const Measures& measures = sketch.measures;
    const Spot at = sketch.spot(point), down = side_of_ground(sketch, point), across = turned(down);
    const Spot base = at + measures.triangle_height * down;
    sketch.ground.emplace_back(
        panel({at, base + measures.triangle_half * across, base - measures.triangle_half * across}, sketch.theme.paper,
              sketch.outline()));
    draw_wall(sketch, {base + measures.base_half * across, base - measures.base_half * across}, down);
}

void draw_guides(Sketch& sketch) {
    const Theme& theme = sketch.theme;
    const Measures& measures = sketch.measures;
    for (const Joint& joint : sketch.mechanism.joints) {
        if (joint.bodies.size() != 2 || length(sketch.guide(joint)) == 0) continue;
        const bool on_frame = joint.bodies[1] == frame;
        if (joint.pair().is_sleeve() && on_frame) {
            draw_axis_of_guide(sketch, joint);
            draw_walls(sketch, joint, measures.slider_side + theme.vector / 2 + theme.outline / 2,
                       reach_of_wall(sketch, joint), true);
        } else if (joint.pair().is_sleeve() && joint.bodies[0] == frame) {
            draw_walls(sketch, joint, theme.link / 2 + 0.5, measures.sleeve_half, false);
        } else if (joint.pair().is_slot() && on_frame) {
            draw_axis_of_guide(sketch, joint);
            draw_walls(sketch, joint, measures.slot_side, measures.slot_half + 3, false);
        }
    }
}

}  // namespace kinegraph::render::drawing
