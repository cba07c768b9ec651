// Subject of a drawing: the data that a figure takes from the solution, extracted once, in metres with y downwards, and
// shared by all scales that are tried.
#pragma once

#include <string_view>
#include <vector>

#include "engine/solution/solution.hpp"
#include "render/mechanism/paper.hpp"

namespace kinegraph::render::drawing {

inline bool is_fixed_pin(const Joint& joint) { return joint.pair().is_hinge() && joint.connects(frame); }
inline bool is_slide(const Joint& joint) { return joint.pair().is_sleeve() && joint.bodies.size() == 2; }
/// Whether the joint is a pin in a slot curved about a point, with the pin on its first body.
inline bool is_curved_slot(const Joint& joint) {
    return joint.pair().is_slot() && joint.arc != none && joint.bodies.size() == 2;
}
/// The profile of a body at a contact, if it has that type; else null.
template <class Form>
const Form* profile_of(const Joint& joint, BodyIndex body) {
    const auto profile = joint.profiles.find(body);
    return profile == joint.profiles.end() ? nullptr : std::get_if<Form>(&profile->second);
}
inline bool is_tip(const Joint& joint, BodyIndex body) { return profile_of<TipProfile>(joint, body) != nullptr; }

struct Subject {
    const Solution& solution;
    const Mechanism& mechanism;
    std::vector<Spot> points;
    std::vector<Spot> guides, normals;             // unit vectors, by joint
    std::vector<bool> shown;                       // by point: some body contains it
    std::vector<bool> mass_centre;                 // by point
    std::vector<std::vector<PointIndex>> corners;  // by body: the points that its strokes join
    Box box;                                       // bounding box of the mechanism, m
    double shortest = 1e300;                       // length of the shortest link, m

    explicit Subject(const Solution& s);

    double size() const { return std::max(box.width(), box.height()); }
    bool shows(PointIndex point) const { return shown[at_index(point)]; }
    /// Whether a body only has a contact or a guide at a point, so that no stroke leads there.
    bool touches_there(BodyIndex body, PointIndex point) const;
    /// Unit vector along the common tangent of a contact.
    Spot tangent(const Joint& joint) const {
        return paper_direction(solution.pose.tangents[at_index(mechanism.index_of(joint))]);
    }

private:
    void add_corner(BodyIndex body, PointIndex point);
    void show_points();
    void join_corners();
    void measure();
};

}  // namespace kinegraph::render::drawing
