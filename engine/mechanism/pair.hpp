// Pairs of the plane: each kind of joint is a row of one table. A row states how the bodies of a pair meet at the
// joint's point P, and which of the three freedoms of planar motion the pair removes there: across the guide or the
// common tangent, along it, and the rotation. Everything else follows: the remaining freedoms, the force it transmits,
// where its instant centre lies, its use by the planner and its symbol. So other code queries properties ("has a
// guide", "holds the rotation") and never the kind. Only the check, which is independent on purpose, has its own rules
// for each kind.
//
// A table, not a variant of types with visitors: the kinds differ in data only. The code that uses them is in other
// folders and usually depends on two or three properties, rarely on all seven kinds.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "lang/words.hpp"

namespace kinegraph {

enum class JointKind { revolute, prismatic, pin_slot, rolling, contact, gear, weld };

/// A pair of the plane as the file states it. Its class is the number of its freedoms; a weld is no pair.
struct PlanePair {
    /// How the bodies meet at P.
    enum class Meeting {
        common_point,  ///< P is one point of all of them
        guide,         ///< P of bodies[0] lies on a guide of bodies[1]
        profiles       ///< two profiles touch in P
    };
    enum class Centre { at_point, at_infinity, on_normal, everywhere };

    JointKind kind;
    std::string_view key;  ///< key in the file: "revolute" …
    /// In tables and on the sheet of pairs; a weld, which leaves no freedom, has no text for it.
    struct Texts {
        Key name, reaction, fixed, centre, found, freedoms = {};
    } texts;
    std::string_view form;  ///< as the file writes it
    Meeting meeting;
    bool holds_normal;   ///< no relative velocity at P across the guide or the common tangent …
    bool holds_tangent;  ///< … nor along it …
    bool holds_rotation;
    bool joins_many;  ///< more than two bodies may share it

    /// Unknowns of its reaction: one for each freedom that it removes.
    int reactions() const { return (holds_normal ? 1 : 0) + (holds_tangent ? 1 : 0) + (holds_rotation ? 1 : 0); }
    int freedoms() const { return 3 - reactions(); }
    /// P of one body and P of the other have the same velocity, so the force between them may have any direction.
    bool holds_point() const { return holds_normal && holds_tangent; }
    bool turns() const { return !holds_rotation; }

    bool has_common_point() const { return meeting == Meeting::common_point; }
    bool has_guide() const { return meeting == Meeting::guide; }
    bool touches() const { return meeting == Meeting::profiles; }

    bool is_hinge() const { return has_common_point() && turns(); }
    bool is_clamp() const { return has_common_point() && holds_rotation; }
    bool is_sleeve() const { return has_guide() && holds_rotation; }
    bool is_slot() const { return has_guide() && turns(); }
    bool rolls() const { return touches() && holds_point(); }
    /// Pitch curves: they roll on each other, and another pair fixes the distance of their centres.
    bool meshes() const { return touches() && !holds_normal; }

    /// The bodies slide on each other at P.
    bool slides() const { return holds_normal && !holds_tangent; }
    /// They rotate about a pin at P, which may itself slide.
    bool has_pin() const { return !touches() && turns(); }
    /// Accelerations there depend on the curvatures of the profiles.
    bool asks_curvatures() const { return touches() && !meshes(); }

    Centre centre() const {
        if (holds_rotation) return slides() ? Centre::at_infinity : Centre::everywhere;
        return slides() ? Centre::on_normal : Centre::at_point;
    }
    /// Besides the force, it transmits a couple about P, which prevents rotation.
    bool transmits_couple() const { return holds_rotation; }
};

/// In the order of JointKind.
extern const std::array<PlanePair, 7> plane_pairs;

inline const PlanePair& plane_pair(JointKind kind) { return plane_pairs[static_cast<std::size_t>(kind)]; }

}  // namespace kinegraph
