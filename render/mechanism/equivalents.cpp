// Equivalent linkages of contacts on the mechanism: the imaginary link between two centres of curvature, or the centre
// as a pin on its straight path. Thin and dashed, so that they do not look like bodies. The solution provides them.
#include <utility>

#include "engine/solution/bindings.hpp"
#include "render/mechanism/sketch.hpp"

namespace kinegraph::render::drawing {

using Form = Holds::Form;

void draw_equivalent_linkages(Sketch& sketch) {
    const Theme& theme = sketch.theme;
    const Pen broken{theme.thin, theme.text, dashes(), false}, edge{theme.thin, theme.text, {}, false};
    const double radius = 0.6 * sketch.measures.pin_radius;
    for (const EquivalentLinkage& linkage : sketch.subject.solution.equivalent_linkages) {
        const Joint& joint = sketch.mechanism.joint(linkage.joint);
        const Spot first = sketch.spot(linkage.places[0]), second = sketch.spot(linkage.places[1]);
        const bool is_link = linkage.kind == EquivalentLinkage::Kind::link;
        // A tip is already drawn as the pin of its slot, and the slot belongs to the other body.
        if (!is_link && coincide(first, sketch.spot(joint))) continue;
        const Spot along = sketch.measures.slot_half * turned(sketch.subject.normals[at_index(linkage.joint)]);
        sketch.centres.emplace_back(GroupBegin{"equivalent", sketch.id("equivalent", joint.name), joint.name, {}});
        const auto mark = [&](Path path, Holds holds) {
            path.holds = std::move(holds);
            sketch.centres.emplace_back(std::move(path));
        };
        const std::string one = point_binding(linkage.places[0]), other = point_binding(linkage.places[1]);
        if (is_link)
            mark(line(first, second, broken), {Form::segment, {one, other}});
        else
            mark(line(first - along, first + along, broken), {Form::with, {one, tangent_binding(linkage.joint)}});
        mark(ring(first, radius, theme.paper, edge), {Form::at, {one}});
        if (is_link) mark(ring(second, radius, theme.paper, edge), {Form::at, {other}});
        sketch.centres.emplace_back(GroupEnd{});
    }
}

}  // namespace kinegraph::render::drawing
