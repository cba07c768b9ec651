// Names of points, and the compass arcs that determine them.
#include <algorithm>
#include <cmath>

#include "render/mechanism/sketch.hpp"

namespace kinegraph::render::drawing {

std::optional<RichText> name_of_point_at(const Sketch& sketch, Spot at) {
    for (const PointIndex point : indices_of(sketch.mechanism.points))
        if (sketch.subject.shows(point) && coincide(sketch.spot(point), at)) return sketch.name_of_point(point);
    return std::nullopt;
}

void name_points(Sketch& sketch) {
    const std::size_t count = sketch.mechanism.points.size();
    std::vector<bool> named(count, false);
    for (const PointIndex p : indices_of(sketch.mechanism.points)) {
        if (!sketch.subject.shows(p) || named[at_index(p)]) continue;
        const Spot at = sketch.spot(p);
        const double clearance = sketch.measures.pin_radius + 0.8;
        LabelRequest names;
        for (const PointIndex q : indices(count, p)) {
            if (!sketch.subject.shows(q) || named[at_index(q)] || length(sketch.spot(q) - at) > same_place) continue;
            named[at_index(q)] = true;
            if (names.text.empty()) {
                names.text = sketch.name_of_point(q);
                names.in_file = sketch.mechanism.point(q).name;
            } else {
                names.add_name(sketch.name_of_point(q));
            }
        }
        const auto there = std::find_if(sketch.labels.begin(), sketch.labels.end(), [&](const LabelRequest& label) {
            return label.balloon == 0 && !label.toward && coincide(label.anchor, at);
        });
        if (there != sketch.labels.end()) {
            // A point that coincides with an instant centre: "B ≡ P_13".
            names.add_name(there->text);
            there->text = std::move(names.text);
            there->in_file.clear();
            there->clearance = std::max(there->clearance, clearance);
        } else {
            sketch.add_label(std::move(names.text), sketch.theme.text, at, clearance).in_file = names.in_file;
        }
    }
}

RichText how_far(const Sketch& sketch, const RichText& from, const RichText& to, double millimetres) {
    const Unit& unit = sketch.mechanism.units.length;
    const double metres = millimetres * sketch.scale();
    RichText text = one_piece("  (");
    append(text, from);
    append(text, to);
    append(text, with_powers(" = " + number(metres / unit.si.to_double(), 3, sketch.context.language) + " " +
                             unit.symbol + ")"));
    return text;
}

void draw_compass(Sketch& sketch) {
    for (const PositionStep& step : sketch.subject.solution.pose.steps) {
        if (step.point == none || !sketch.subject.shows(step.point)) continue;
        const Spot at = sketch.spot(step.point);
        for (const PositionStep::Arc& found_by : step.arcs) {
            const Spot centre = sketch.spot(found_by.centre);
            const double radius = found_by.radius.to_double() / sketch.scale();
            if (radius < 2 || std::abs(length(at - centre) - radius) > 0.1) continue;
            const double middle = angle_of(at - centre);
            const double half = std::clamp(6 * pi_number / 180, 4.0 / radius, 9.0 / radius);
            sketch.construction.emplace_back(arc({centre, radius, middle - half, middle + half}, sketch.thin()));
        }
    }
}

}  // namespace kinegraph::render::drawing
