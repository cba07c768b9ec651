// The catalogue of pairs: what each allows, what it can transmit, where its instant centre lies. Data, from which `kinegraph
// pairs` and docs/pairs.md are printed; words are the sheet's business.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "engine/mechanism.hpp"

namespace kinegraph {

/// A pair of the plane as the file knows it.
struct PlanePair {
    JointKind kind;
    std::string_view key;   ///< of its words: "revolute" …
    std::string_view form;  ///< as the file writes it
    int freedoms;           ///< of one body against the other; its class is the same number, a weld is no pair
    bool turns;             ///< whether relative rotation is left
    enum class Force { any_direction, normal_to_guide, along_normal, line_of_action } force;
    bool couple;  ///< whether it transmits a couple about its point
    int reactions() const { return 3 - freedoms; }
};
/// In the order of JointKind.
inline constexpr std::array plane_pairs{
    PlanePair{JointKind::revolute, "revolute", R"({"revolute": P, "bodies": [i, j]})", 1, true, PlanePair::Force::any_direction,
              false},
    PlanePair{JointKind::prismatic, "prismatic", R"({"prismatic": P, "bodies": [i, j], "along": X})", 1, false,
              PlanePair::Force::normal_to_guide, true},
    PlanePair{JointKind::pin_slot, "pin-slot", R"({"pin-slot": P, "bodies": [i, j], "along": X})", 2, true,
              PlanePair::Force::normal_to_guide, false},
    PlanePair{JointKind::rolling, "rolling", R"({"rolling": P, "bodies": [i, j], "profiles": {…}})", 1, true,
              PlanePair::Force::any_direction, false},
    PlanePair{JointKind::contact, "contact", R"({"contact": P, "bodies": [i, j], "profiles": {…}})", 2, true,
              PlanePair::Force::along_normal, false},
    PlanePair{JointKind::gear, "gear", R"({"gear": P, "bodies": [i, j], "profiles": {…}, "pressure angle": a})", 2, true,
              PlanePair::Force::line_of_action, false},
    PlanePair{JointKind::weld, "weld", R"({"weld": P, "bodies": [i, j]})", 0, false, PlanePair::Force::any_direction, true},
};
constexpr const PlanePair& plane_pair(JointKind kind) { return plane_pairs[static_cast<std::size_t>(kind)]; }

/// A lower pair in space: surfaces in contact (Reuleaux). Axis z; the planar pair's normal is z.
struct SpacePair {
    std::string_view key;
    int freedoms;
    std::string_view motions;    ///< freedoms left: translations t_x …, rotations r_x …
    std::string_view reactions;  ///< components it can transmit: forces F_x …, couples M_x …
    int reaction_count() const { return 6 - freedoms; }
};
inline constexpr std::array space_pairs{
    SpacePair{"revolute", 1, "r_z", "F_x F_y F_z M_x M_y"},
    SpacePair{"prismatic", 1, "t_z", "F_x F_y M_x M_y M_z"},
    SpacePair{"helical", 1, "r_z, t_z = p r_z", "F_x F_y M_x M_y, p F_z = −M_z"},
    SpacePair{"cylindrical", 2, "t_z r_z", "F_x F_y M_x M_y"},
    SpacePair{"planar", 3, "t_x t_y r_z", "F_z M_x M_y"},
    SpacePair{"spherical", 3, "r_x r_y r_z", "F_x F_y F_z"},
};

/// A hinge of n bodies stands for n − 1 binary ones: each scheme is a tree on the bodies, an edge a binary hinge.
struct BinaryScheme {
    std::vector<std::array<int, 2>> hinges;  ///< positions in the hinge's list of bodies, smaller first
};
/// All n^(n−2) of them (Cayley, 1889), by their Prüfer sequences in order, 2 ≤ n. The n stars, in which one body carries all the
/// hinges, are among them; for n = 3 there are no others.
std::vector<BinaryScheme> binary_schemes(int bodies);

}  // namespace kinegraph
