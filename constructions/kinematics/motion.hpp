// The recipes of motion: draws a plan in the velocity plane and in the acceleration plane. The theorems are Rivals' for
// two points of a body, relative motion (Coriolis) for a place on two bodies, Mehmke's and Burmester's images for
// further points, Assur's auxiliary point. All numbers come from the board.
//
// Sources: Rivals 1853; Burmester, Lehrbuch der Kinematik (1888), velocity and acceleration images; Assur (1914) for
// the auxiliary point; Euler and Savary for the centres of curvature of profiles that roll or slide on each other; the
// trial values ("regula falsi" of graphical kinematics) as in Rosenauer and Willis, Kinematics of Mechanisms (1953).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "constructions/kinematics/plan.hpp"
#include "constructions/kinematics/structure.hpp"
#include "engine/board/board.hpp"
#include "engine/solution/motion.hpp"

namespace kinegraph {

/// What has been drawn in one plane (velocity: spins are ω; acceleration: spins are α).
template <Plane plane>
struct Track {
    int polygon = -1;
    std::vector<std::optional<PointOn<plane>>> tips;                        ///< by NodeIndex
    std::vector<std::optional<ScalarHandle>> spins;                         ///< by BodyIndex
    std::map<std::pair<NodeIndex, NodeIndex>, VectorOn<plane>> tangential;  ///< (base, node): v_BA or a_BA^t as drawn

    bool has(NodeIndex node) const { return at_index(node) < tips.size() && tips[at_index(node)].has_value(); }
    PointOn<plane> tip(NodeIndex node) const { return tips[at_index(node)].value(); }
    bool turns(BodyIndex body) const { return spins[at_index(body)].has_value(); }
    ScalarHandle spin(BodyIndex body) const { return spins[at_index(body)].value(); }
};

/// Two known points of one body whose velocities have different projections on their join, as no rigid motion has.
struct Contradiction {
    BodyIndex body = none;
    NodeIndex first = none, second = none;
};

struct Motion {
    Track<Plane::velocity> velocity;
    Track<Plane::acceleration> acceleration;
    int velocities_settled = 0;  ///< number of board operations once the velocities were drawn
    std::vector<Contradiction> contradictions;
    std::vector<EquivalentLinkage> equivalents;  ///< of contacts, in the order of their use
};

/// Draws the velocity polygon and, where `with_accelerations`, the acceleration polygon.
Motion draw_motion(Structure& structure, Board& board, const Plan& plan, bool with_accelerations);

/// The velocities if the assumption `plan.steps[assumed]` has the value one and all drivers and other open assumptions
/// are zero. Draws and writes nothing; shows the planner which condition the assumption changes.
Track<Plane::velocity> draw_response(Structure& structure, Board& board, const Plan& plan, std::size_t assumed);
/// Whether these velocities break a condition.
bool is_broken(Structure& structure, Board& board, const Track<Plane::velocity>& response, const Closing& condition);

/// How a sentence names a joint's guide: parallel to a segment if the file gives two points, else as the joint's guide.
LineReason along_guide(const Mechanism& mechanism, JointIndex joint, bool perpendicular);

}  // namespace kinegraph
