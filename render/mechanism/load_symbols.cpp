// Symbols of loads that are part of the mechanism's drawing: gas springs, torsion springs, distributed loads. Owns
// their geometry.
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/mechanism/compound_units.hpp"
#include "render/mechanism/clutter.hpp"
#include "render/mechanism/symbols.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render::drawing {

void draw_gas_spring(Sketch& sketch, const SpringLoad& spring) {
    const Spot from = sketch.spot(spring.between[0]), to = sketch.spot(spring.between[1]);
    const Spot along = unit(to - from), across = turned(along);
    const double whole = length(to - from), eye = std::min(1.1, 0.2 * whole), bore = std::clamp(0.09 * whole, 1.2, 2.6);
    const Spot bottom = from + eye * along, top = from + 0.55 * whole * along, head = top - 0.12 * whole * along;
    const Pen pen = sketch.outline();
    sketch.ground.emplace_back(
        GroupBegin{"gas-spring", sketch.id("spring", spring.name), spring.name, {}, none, between_ends(spring)});
    sketch.ground.emplace_back(
        line(head, to - eye * along, {1.6 * sketch.theme.outline, sketch.theme.text, {}, false}));
    sketch.ground.emplace_back(
        panel({bottom + bore * across, top + bore * across, top - bore * across, bottom - bore * across},
              sketch.theme.paper, pen));
    sketch.ground.emplace_back(line(head + bore * across, head - bore * across, pen));
    sketch.ground.emplace_back(line(head, top, pen));
    for (const Spot end : {from, to}) sketch.ground.emplace_back(ring(end, eye, sketch.theme.paper, pen));
    sketch.ground.emplace_back(GroupEnd{});
}

void draw_torsion_spring(Sketch& sketch, const TorsionLoad& torsion) {
    constexpr double inner = 1.8, outer = 5.2, turns = 2.25;
    constexpr int steps = 54;
    const Spot at = sketch.spot(torsion.at);
    std::vector<Spot> spots;
    for (int i = 0; i <= steps; ++i) {
        const double share = static_cast<double>(i) / steps;
        spots.push_back(at + (inner + share * (outer - inner)) * polar_spot(share * turns * 2 * pi_number));
    }
    sketch.ground.emplace_back(GroupBegin{"torsion-spring",
                                          sketch.id("spring", torsion.name),
                                          torsion.name,
                                          {},
                                          none,
                                          Holds{Holds::Form::at, {point_binding(torsion.at)}}});
    sketch.ground.emplace_back(polyline(spots, sketch.outline()));
    sketch.ground.emplace_back(GroupEnd{});
}

void draw_distributed(Sketch& sketch, const DistributedLoad& load, std::vector<Mark>& layer) {
    constexpr double highest = 9, apart = 4.5, off = 1.3, level = 0.1;
    const Spot from = sketch.spot(load.from), to = sketch.spot(load.to);
    const double whole = length(to - from);
    const std::array<double, 2> ends{load.intensity[0].to_double(), load.intensity[1].to_double()};
    const double largest = std::max(std::abs(ends[0]), std::abs(ends[1]));
    if (whole == 0 || largest == 0) return;
    const Spot along = paper_direction(direction_of(load.along, sketch.subject.solution.pose)), run = unit(to - from);
    // Arrows along the loaded line would overlap, so they are displaced sideways, one behind the other.
    const bool lies = std::abs(cross(along, run)) < level;
    const BodyColour colour = sketch.theme.colour_of(load.body);
    const Pen thin{sketch.theme.thin, colour.line, {}, false};
    const int count = std::max(2, static_cast<int>(whole / apart));
    layer.emplace_back(GroupBegin{"distributed", sketch.id("load", load.name), load.name, {}});
    std::vector<Spot> tails;
    for (int i = 0; i <= count; ++i) {
        const double share = static_cast<double>(i) / count;
        const double size = highest * (ends[0] + share * (ends[1] - ends[0])) / largest;
        const Spot foot = from + share * whole * run;
        if (lies) {
            const Spot tail = foot + 3.0 * turned(run);
            if (std::abs(size) > 1) draw_arrow(layer, tail, tail + 0.4 * size * along, sketch.theme.thin, colour.line);
            continue;
        }
        const Spot tip = foot - (size < 0 ? -off : off) * along, tail = tip - size * along;
        tails.push_back(tail);
        if (std::abs(size) > 1) draw_arrow(layer, tail, tip, sketch.theme.thin, colour.line);
    }
    if (tails.size() > 1) layer.emplace_back(line(tails.front(), tails.back(), thin));
    layer.emplace_back(GroupEnd{});
}

void name_intensities(Sketch& sketch, const DistributedLoad& load) {
    constexpr double over_tails = 10.5;  // mm
    const Unit unit = unit_of_force_per_length(sketch.mechanism.units);
    const Spot from = sketch.spot(load.from), to = sketch.spot(load.to);
    const Spot along = paper_direction(direction_of(load.along, sketch.subject.solution.pose));
    const bool even = load.intensity[0] == load.intensity[1];
    for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
        if (load.intensity[end].is_zero() || (even && end == 1)) continue;
        RichText text = one_piece(load.name, Face::italic);
        append(text,
               with_powers(" = " + given_number((load.intensity[end] / unit.si).to_double(), sketch.context.language) +
                           " " + unit.symbol));
        const Spot foot = even ? 0.5 * (from + to) : end == 0 ? from : to;
        sketch.add_label(std::move(text), sketch.theme.colour_of(load.body).letter, foot - over_tails * along, 1.0);
    }
}

}  // namespace kinegraph::render::drawing
