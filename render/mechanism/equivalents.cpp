// The equivalent linkages of contacts on the mechanism: the imaginary link between two centres of curvature, or the centre as a
// pin on its straight path, thin and broken, so that they are not taken for bodies. Which there are is the solution's to say.
#include "render/mechanism/sketch.hpp"

namespace kinegraph::render::drawing {

void Sketch::draw_equivalent_linkages() {
    const Pen broken{theme_.thin, theme_.text, dashes(), false};
    const Pen edge{theme_.thin, theme_.text, {}, false};
    const double radius = 0.6 * pin_radius_;
    for (const EquivalentLinkage& linkage : s_.solution.equivalent_linkages) {
        const Joint& joint = m_.joints[at_index(linkage.joint)];
        Spot from = spot(linkage.places[0]), to = spot(linkage.places[1]);
        const bool is_link = linkage.kind == EquivalentLinkage::Kind::link;
        if (!is_link) {
            // A tip is the pin of its slot already, and the slot the body's own side.
            if (length(from - spot(joint.point)) < same_place) continue;
            const Spot along = slot_half_ * turned(s_.normals[at_index(linkage.joint)]);
            to = from + along;
            from = from - along;
        }
        centres.emplace_back(GroupBegin{"equivalent", id("equivalent", joint.name), joint.name, {}});
        centres.emplace_back(line(from, to, broken));
        if (is_link) {
            centres.emplace_back(ring(from, radius, theme_.paper, edge));
            centres.emplace_back(ring(to, radius, theme_.paper, edge));
        } else {
            centres.emplace_back(ring(spot(linkage.places[0]), radius, theme_.paper, edge));
        }
        centres.emplace_back(GroupEnd{});
    }
}

}  // namespace kinegraph::render::drawing
