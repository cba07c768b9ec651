// The progress of a plan: its steps, and the nodes and bodies they determine.
#pragma once

#include <cstddef>
#include <vector>

#include "constructions/kinematics/plan.hpp"
#include "constructions/kinematics/space_diagram.hpp"

namespace kinegraph::planning {

inline std::size_t at(auto index) { return at_index(index); }

class KnownMotion {
public:
    struct State {
        Plan plan;
        std::vector<std::size_t> parallel_at;
        Structure::Mark mark;
    };

    /// Starts with only the frame known.
    KnownMotion(Structure& structure, Board& board);

    Plan& plan() { return plan_; }
    const Plan& plan() const { return plan_; }
    SpaceDiagram& diagram() { return diagram_; }
    /// By NodeIndex: number of loci when all were found parallel; none is tried again before there are more.
    std::vector<std::size_t>& parallel_at() { return parallel_at_; }

    bool known(NodeIndex node) const { return at(node) < plan_.nodes.size() && plan_.nodes[at(node)]; }
    bool body_known(BodyIndex body) const { return plan_.bodies[at(body)]; }
    bool spin_known(BodyIndex body) const { return plan_.spins[at(body)]; }
    /// Resizes the plan for nodes added since.
    void sync();
    /// The node of a point on a body. If the body's motion is known, adds an image step that makes the node known.
    NodeIndex known_on(PointIndex point, BodyIndex body);
    void add_step(const Step& step) { plan_.steps.push_back(step); }
    /// The node about which to draw the image: one at rest if there is one, else the first known.
    NodeIndex base_of(BodyIndex body, NodeIndex except) const;
    bool apart(NodeIndex a, NodeIndex b) { return !board_.coincide(diagram_.place(a), diagram_.place(b)); }
    bool are_parallel(const Locus& one, const Locus& other);
    void add_image(BodyIndex body, NodeIndex node);
    void learn_body(BodyIndex body);
    State state() const { return {plan_, parallel_at_, structure_.mark()}; }
    void restore(const State& state);

private:
    Structure& structure_;
    Board& board_;  ///< the scratch board
    SpaceDiagram diagram_;
    Plan plan_;
    std::vector<std::size_t> parallel_at_;
};

}  // namespace kinegraph::planning
