// Stable names that bind marks of the figures of forces, curvature and Joukowsky's lever to program elements, in every
// plan of a moving mechanism. A name identifies an object (a load on a body, the reaction of a joint, a point of
// concurrency), never a position.
#pragma once

#include <string>

#include "engine/solution/forces.hpp"

namespace kinegraph {

/// `load`: whose loads act alone (the name of a body or a pin); empty: all loads act.
std::string force_binding(const std::string& load, const FreeBody& body, const AppliedForce& applied);
/// A sum of forces on a body, or on bodies taken together (`of`: their index).
std::string sum_binding(const std::string& load, const FreeBody& body, const AppliedForce& sum);
std::string sum_binding(const std::string& load, std::size_t of, const AppliedForce& sum);
/// The couple of any of these. Where a body has a force and a separate couple, two names are needed.
std::string couple_of(const std::string& held);
/// A point of concurrency.
std::string meet_binding(const std::string& load, const std::string& name);
/// The end of a moment arm: the centre of moments, or the foot.
std::string arm_binding(const std::string& load, const FreeBody& body, std::size_t arm, bool is_foot);
/// Force and couple of a joint at its own point.
std::string pair_binding(const JointForce& pair);
/// A vertex of a funicular polygon, identified by the reactions that it finds; the one past the last is the
/// intersection of the outer strings.
std::string string_binding(const std::string& load, const FreeBody::Funicular& funicular, std::size_t vertex);
/// A place of a body's curvature: "pole", "axis", "J", …
std::string curvature_binding(BodyIndex body, const std::string& what);
/// A force on Joukowsky's lever and the velocity of its place.
std::string work_binding(const VirtualWork::Entry& entry);
/// A point of the mechanism, which depends on the position only.
std::string point_binding(PointIndex point);
/// A place that a body carries, given as drawn, m.
std::string place_binding(BodyIndex body, const Vector& drawn);
/// The tip of a vector that begins at a place; `scale`: units of the vector for a metre of the mechanism.
std::string tip_binding(const std::string& place, const std::string& vector, double scale);
/// The tip of the virtual displacement of a point in a freedom; `scale`: displacement for a metre of the mechanism.
std::string displaced_binding(PointIndex point, std::size_t freedom, double scale);
/// The directions of a joint's common tangent and of its guide.
std::string tangent_binding(JointIndex joint);
std::string guide_binding(JointIndex joint);
/// A part of the relative motion with this index: "v", "v along", …
std::string relative_binding(std::size_t index, const std::string& what);
/// The velocity of a point in a given instantaneous motion, and what else that motion has: "centre", "omega", …
std::string velocity_binding(PointIndex point);
std::string instantaneous_binding(const std::string& what);
/// The force of a truss's bar on its first pin, and an external force.
std::string bar_binding(const Truss& truss, std::size_t bar);
std::string external_binding(const Truss::External& external);
/// The resultant of the loads on a truss.
std::string whole_binding();
/// The pole of the lever, and the foot of the perpendicular from it on the line of a force.
std::string pole_binding();
std::string foot_binding(const VirtualWork::Entry& entry);

}  // namespace kinegraph
