// Chains: loci as they are drawn, each from the tip of its base along known vectors, then a line on which the tip
// sought lies. Contains the theorems of two points of a body (Rivals), of relative motion (Coriolis) and of rolling
// (Euler, Savary). The recipes decide which loci meet, and in what order.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "constructions/kinematics/motion.hpp"
#include "constructions/kinematics/plan.hpp"
#include "constructions/kinematics/polygon_pen.hpp"
#include "constructions/kinematics/space_diagram.hpp"
#include "constructions/kinematics/structure.hpp"
#include "engine/board/board.hpp"
#include "engine/solution/sliding.hpp"

namespace kinegraph {

/// One known or sought vector of a chain, with its term in the equation.
template <Plane plane>
struct Link {
    Term term;
    VectorOn<plane> vector;
    DrawnVector::Role role = DrawnVector::Role::relative;
    bool shift = false;  ///< carries the locus from one node of a body to another
    Seen seen;
};

/// A locus as drawn: from the base's tip along known vectors, then a line on which the tip sought lies.
template <Plane plane>
struct Chain {
    NodeIndex base = none;
    PointOn<plane> start, end;
    std::vector<Link<plane>> known;  ///< set off one after the other from `start`; in an inverse chain backwards
    LineOn<plane> line;
    LineReason reason;
    Term sought;
    Seen seen;  ///< the vector sought
    DrawnVector::Role role = DrawnVector::Role::relative;
    bool from_rest = false;
    bool inverse = false;
    bool absolute = false;  ///< the sought vector is the node's absolute velocity (acceleration)
};

/// Builds chains; shared by the recipes of motion.
class Chains {
public:
    Chains(Structure& structure, Board& board)
        : structure_(structure), board_(board), diagram_(structure, board), mechanism_(structure.mechanism()) {}

    const Node& node(NodeIndex index) const { return structure_.node(index); }
    PointOn<Plane::drawing> place(NodeIndex index) { return diagram_.place(index); }
    bool at_rest(NodeIndex index) const { return node(index).bodies.front() == frame; }
    /// The body whose colour is used for a node's vector.
    BodyIndex colour_of(NodeIndex index) const {
        const std::vector<BodyIndex>& bodies = node(index).bodies;
        if (at_rest(index)) return frame;
        // If the node is on several bodies, the one guided by the frame, whose locus has that colour in the velocity
        // polygon.
        const auto guided = std::find_if(bodies.begin(), bodies.end(),
                                         [&](BodyIndex each) { return structure_.is_guided_by_frame(each); });
        return guided == bodies.end() ? bodies.front() : *guided;
    }
    template <Plane plane>
    Symbol absolute(NodeIndex index, std::string term = {}) const {
        return motion_symbol<plane>(node(index).label, std::move(term));
    }
    template <Plane plane>
    Symbol relative(NodeIndex of, NodeIndex to, std::string term = {}) const {
        return motion_symbol<plane>(relative_name(node(of).label, node(to).label), std::move(term));
    }
    CarriedPlace carried(NodeIndex index) { return carried(index, node(index).bodies.front()); }
    CarriedPlace carried(NodeIndex index, BodyIndex body) { return {place(index).element, body, node(index).point}; }
    Seen seen(NodeIndex of) { return {carried(of), {}, none}; }
    /// Seen from a place about which it turns.
    Seen turning(NodeIndex of, NodeIndex to) { return {carried(of), carried(to), place(to).element}; }
    /// Seen from a place of the guide in which it slides. In a curved guide it turns, which affects only accelerations.
    /// At a hinge the place is on several bodies; `guide_body` has the guide.
    template <Plane plane>
    Seen sliding(JointIndex joint, NodeIndex slider, NodeIndex guide, BodyIndex guide_body) {
        const PointIndex arc = is_velocity<plane> ? none : mechanism_.joint(joint).arc;
        return {carried(slider), carried(guide, guide_body), arc != none ? board_.place(arc).element : none};
    }
    Segment segment(NodeIndex from, NodeIndex to) const { return {node(from).label, node(to).label}; }
    /// The driver's velocity or acceleration; zero in a response, where all drivers rest.
    template <Plane plane>
    ScalarHandle driven(int driver) {
        if (drivers_rest_) return board_.number(0);
        return is_velocity<plane> ? board_.driver_velocity(driver) : board_.driver_acceleration(driver);
    }
    static bool is_backwards(bool inverse, bool is_shift) { return inverse && !is_shift; }
    template <Plane plane>
    PointOn<plane> set_off(const Chain<plane>& drawn, const Link<plane>& link, PointOn<plane> from) {
        return board_.carry(from, is_backwards(drawn.inverse, link.shift) ? board_.negate(link.vector) : link.vector);
    }

    bool rolls_known(JointIndex index) const;
    /// a_P − a_P*, P on `body_of`. With c₁, c₂ from the contact to the centres of curvature: ω_rel² c₁ · c₂/(c₂ − c₁);
    /// on a line ω_rel² c.
    VectorOn<Plane::acceleration> rolling_offset(JointIndex index, BodyIndex body_of);
    LineReason reason_of(const Locus& locus) const;
    template <Plane plane>
    bool ready(const Track<plane>& track, const Locus& locus) const;
    template <Plane plane>
    Chain<plane> chain(Track<plane>& track, const Locus& locus);
    /// The equation that the two chains close, without minus signs: terms of an inverse chain change sides.
    template <Plane plane>
    Equation equation(NodeIndex sought, const Chain<plane>& first, const Chain<plane>& second) const;
    /// −ω² · (from → to).
    VectorOn<Plane::acceleration> normal_of(BodyIndex turning, NodeIndex from, NodeIndex to);
    /// 2 ω_j ∧ v_rel; none if it vanishes.
    std::optional<Link<Plane::acceleration>> coriolis_of(BodyIndex guide_body, NodeIndex slider, NodeIndex guide);

    Structure& structure() { return structure_; }
    SpaceDiagram& diagram() { return diagram_; }
    const Mechanism& mechanism() const { return mechanism_; }
    /// What is drawn so far.
    Motion& motion() { return motion_; }
    /// Sets all drivers to zero, to compute the response to an assumption.
    void rest_drivers() { drivers_rest_ = true; }

private:
    Structure& structure_;
    Board& board_;
    SpaceDiagram diagram_;
    const Mechanism& mechanism_;
    Motion motion_;
    bool drivers_rest_ = false;

    /// Known base, direction ⟂ to the join: v_BA ⟂ BA, a_BA = a_BA^n + a_BA^t (Rivals). Also for an equivalent link.
    template <Plane plane>
    void start_rotation(const Track<plane>& track, const Locus& locus, Chain<plane>& result);
    /// Known place of the other body, direction ∥ guide: v_X = v_X* + v_XX*, a_X = a_X* + a_XX*^cor + a_XX*^rel
    /// (Coriolis).
    template <Plane plane>
    void start_slide(const Track<plane>& track, const Locus& locus, Chain<plane>& result);
    LineReason line_reason(const Locus& locus) const;
    LineReason normal_reason(const Locus& locus) const;
    LineReason component_reason(const Locus& locus) const;
    /// A driver gives the component along X: set it off from the pole, then ⟂ to X.
    template <Plane plane>
    void start_component(const Track<plane>&, const Locus& locus, Chain<plane>& result);
    /// ω of the body is known: the image of the node from the base, and the line along the join on which it lies.
    template <Plane plane>
    void start_image(const Track<plane>& track, const Locus& locus, Chain<plane>& result);
    /// A driven slide: the component along the guide is given.
    template <Plane plane>
    void start_driven_slide(const Track<plane>& track, const Locus& locus, Chain<plane>& result);
    /// In rolling contact with the base: from its tip by the difference of accelerations.
    template <Plane plane>
    void start_roll(const Track<plane>& track, const Locus& locus, Chain<plane>& result);
    /// Carries the locus of another node to the one sought: by ω ∧ YX (and −ω² YX) on a body with known spin; over a
    /// rolling contact by zero (and the difference of accelerations).
    template <Plane plane>
    void shift(const Track<plane>& track, const Carry& carry, Chain<plane>& result);
    /// The tip of a node; if it was not drawn, from the image of a body that carries it.
    PointOn<Plane::velocity> velocity_tip(NodeIndex index);
    bool has_velocity(NodeIndex index) const;
    /// v_rel of the slider relative to the guide.
    VectorOn<Plane::velocity> sliding_velocity(NodeIndex slider, NodeIndex guide);
    /// In a slot curved about C the pin turns about C relative to the slot: −ω_r² · CP.
    std::optional<Link<Plane::acceleration>> centripetal_of(JointIndex joint, NodeIndex slider, NodeIndex guide,
                                                            BodyIndex guide_body);
    /// −ω_r² · CX. Relative to the base's body, X turns about C, a place that moves as `base` does.
    VectorOn<Plane::acceleration> centripetal_about(PointOn<Plane::drawing> centre, NodeIndex base, NodeIndex index);

    std::map<BodyIndex, ScalarHandle> squares_;
};

}  // namespace kinegraph
