// How far a plan has come: its steps, and which nodes and bodies they reach. Knows how a point of a known body is
// reached, no rule.
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

    /// The frame is known.
    KnownMotion(Structure& structure, Board& board);

    Plan& plan() { return plan_; }
    const Plan& plan() const { return plan_; }
    SpaceDiagram& diagram() { return diagram_; }
    /// By NodeIndex: how many loci it had when all were found parallel.
    std::vector<std::size_t>& parallel_at() { return parallel_at_; }

    bool known(NodeIndex node) const { return at(node) < plan_.nodes.size() && plan_.nodes[at(node)]; }
    bool body_known(BodyIndex body) const { return plan_.bodies[at(body)]; }
    bool spin_known(BodyIndex body) const { return plan_.spins[at(body)]; }
    /// Makes room for nodes added since.
    void sync();
    /// The node of a point on a body, known if it can be: on a body wholly known by an image step of its own.
    NodeIndex known_on(PointIndex point, BodyIndex body);
    void add_step(const Step& step) { plan_.steps.push_back(step); }
    /// The best node to turn the image about: one at rest, else the first known.
    NodeIndex base_of(BodyIndex body, NodeIndex except) const;
    bool apart(NodeIndex a, NodeIndex b) { return !board_.coincide(diagram_.place(a), diagram_.place(b)); }
    bool are_parallel(const Locus& one, const Locus& other);
    void add_image(BodyIndex body, NodeIndex node);
    void learn_body(BodyIndex body);
    State state() const { return {plan_, parallel_at_, structure_.mark()}; }
    void restore(const State& state);

private:
    Structure& structure_;
    Board& board_;  ///< the scratch paper
    SpaceDiagram diagram_;
    Plan plan_;
    std::vector<std::size_t> parallel_at_;
};

}  // namespace kinegraph::planning
