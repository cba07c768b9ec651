#include "constructions/kinematics/plan.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "constructions/kinematics/planning/closing_conditions.hpp"
#include "constructions/kinematics/planning/inputs.hpp"
#include "constructions/kinematics/planning/meets.hpp"
#include "constructions/kinematics/planning/propagation.hpp"

namespace kinegraph {
namespace planning {
namespace {

/// Limit on nested trials: three unknowns need 27 drawings, and no known mechanism needs more.
constexpr int deepest_nesting = 3;

/// Applies the rules in order; if none applies, assumes one unknown.
class Planner {
public:
    Planner(Structure& structure, Board& board, const std::vector<bool>& drivers, const std::vector<bool>& determined)
        : structure_(structure),
          mechanism_(structure.mechanism()),
          determined_(determined),
          known_(structure, board),
          propagation_(structure, drivers, known_),
          loci_(structure, drivers, known_),
          meets_(structure, board, known_, loci_),
          conditions_(structure, board, drivers, known_, loci_) {}

    Plan run() {
        propagation_.add_places_of_higher_pairs();
        known_.sync();
        for (const NodeIndex node : structure_.nodes_of(frame)) known_.plan().nodes[at(node)] = true;
        advance();
        while (!complete() && assume_something()) {
        }
        prune();
        known_.sync();
        return std::move(known_.plan());
    }

private:
    void advance() {
        do {
            do {
                propagation_.propagate();
            } while (propagation_.slide_by_driver() || meets_.meet_some_node());
        } while (advance_by_auxiliaries());
    }

    /// Auxiliary points are drawn only if they lead to a point or a body of the mechanism.
    bool advance_by_auxiliaries() {
        const KnownMotion::State before = known_.state();
        const std::size_t reached = gains();
        while (meets_.find_auxiliary()) {
            propagation_.propagate();
            while (meets_.meet_some_node()) propagation_.propagate();
            if (gains() > reached) return true;
        }
        known_.restore(before);
        return false;
    }

    std::size_t gains() const {
        std::size_t count = 0;
        for (std::size_t node = 0; node < known_.plan().nodes.size(); ++node) {
            const bool of_mechanism = structure_.node(NodeIndex(node)).carried;
            count += of_mechanism && known_.plan().nodes[node] ? 1 : 0;
        }
        for (const bool spin : known_.plan().spins) count += spin ? 1 : 0;
        return count;
    }

    /// Removes steps without effect: auxiliary points and places seen on a body that no later step uses.
    void prune() {
        Quantities wanted;
        for (const NodeIndex node : indices_of(structure_.nodes())) {
            if (structure_.node(node).carried || structure_.node(node).of_interest) wanted.tips.insert(node);
        }
        for (const BodyIndex body : indices_of(mechanism_.bodies)) wanted.spins.insert(body);
        known_.plan().steps = leading_to(std::move(wanted), known_.plan().steps, 0);
    }

    bool complete() const {
        for (std::size_t body = 1; body < determined_.size(); ++body) {
            if (determined_[body] && !known_.plan().bodies[body]) return false;
        }
        return true;
    }

    /// Assumes as few unknowns together as possible.
    bool assume_something() {
        for (int depth = 1; depth <= deepest_nesting; ++depth) {
            if (assume_something(depth)) return true;
        }
        return false;
    }

    /// Of all unknowns whose trial closes, takes the one with the shortest drawing.
    bool assume_something(int depth) {
        const KnownMotion::State before = known_.state();
        std::optional<Step> best;
        std::size_t shortest = 0;
        for (const Step& guess : guesses()) {
            const std::size_t first = known_.plan().steps.size();
            if (attempt(guess, depth)) {
                const std::size_t length = known_.plan().steps[first].trial.size();
                if (!best || length < shortest) {
                    best = guess;
                    shortest = length;
                }
            }
            known_.restore(before);
            if (best && depth > 1) break;
        }
        return best && attempt(*best, depth);
    }

    bool attempt(const Step& guess, int depth) {
        const std::size_t assumed = known_.plan().steps.size();
        known_.add_step(guess);
        if (guess.node != none) {
            known_.plan().nodes[at(guess.node)] = true;
        } else {
            known_.plan().spins[at(guess.body)] = true;
        }
        advance();
        while (!close(assumed)) {
            if (depth == 1 || !assume_something(depth - 1)) return false;
        }
        return true;
    }

    /// Candidates for a trial: a node with a known line, then the ω of a body.
    std::vector<Step> guesses() {
        std::vector<Step> found;
        loci_.look_at_carried_places_alone(true);
        const std::vector<NodeIndex> nodes = meets_.candidates();
        for (const NodeIndex node : nodes) {
            const std::vector<Locus> loci = loci_.loci_of(node);
            if (loci.empty()) continue;
            // A line from a point at rest is the easiest to understand.
            const auto at_rest = [&](const Locus& locus) {
                return locus.base != none && structure_.node(locus.base).bodies.front() == frame;
            };
            const auto best = std::find_if(loci.begin(), loci.end(), at_rest);
            Step guess;
            guess.kind = Step::Kind::assume;
            guess.node = node;
            guess.first = best == loci.end() ? loci.front() : *best;
            found.push_back(std::move(guess));
        }
        for (const BodyIndex body : mechanism_.moving_bodies()) {
            if (known_.spin_known(body) || known_.base_of(body, none) != none) continue;
            Step guess;
            guess.kind = Step::Kind::assume;
            guess.body = body;
            found.push_back(std::move(guess));
        }
        return found;
    }

    /// Finds a condition that the assumption changes, and the steps from the assumption to it.
    bool close(std::size_t assumed) {
        std::optional<Closing> closing = conditions_.moved_condition(assumed);
        for (const JointIndex joint : indices_of(mechanism_.joints))
            if (!closing) closing = conditions_.moved_condition_at(joint, assumed);
        if (!closing) return false;
        Quantities wanted;
        add_inputs(*closing, wanted);
        known_.plan().steps[assumed].trial = leading_to(std::move(wanted), known_.plan().steps, assumed + 1);
        known_.plan().steps[assumed].closing = *closing;
        return true;
    }

    Structure& structure_;
    const Mechanism& mechanism_;
    const std::vector<bool>& determined_;
    KnownMotion known_;
    Propagation propagation_;
    Loci loci_;
    Meets meets_;
    ClosingConditions conditions_;
};

}  // namespace
}  // namespace planning

bool is_seen_from(const Structure& structure, BodyIndex observer, PointIndex point, const Locus& locus) {
    if (locus.kind != Locus::Kind::sleeve && locus.kind != Locus::Kind::slot) return false;
    if (locus.base == none || !locus.carries.empty()) return false;
    const auto& first = structure.node(locus.node);
    const auto& second = structure.node(locus.base);
    if (first.point != point || second.point != point) return false;
    const auto on = [&](const Node& node) {
        return std::find(node.bodies.begin(), node.bodies.end(), observer) != node.bodies.end();
    };
    return on(first) != on(second);
}

Plan plan_motion(Structure& structure, Board& scratch, const std::vector<bool>& drivers,
                 const std::vector<bool>& determined) {
    return planning::Planner(structure, scratch, drivers, determined).run();
}

}  // namespace kinegraph
