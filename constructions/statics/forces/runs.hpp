// How the forces of a mechanism are found: all loads together by the rules. If this does not give all forces: load by
// load, or one force after the other by moments, components or virtual work, or in a large structure by the joint
// equations of several bodies; and what remains open, by the values that every equilibrium has in common.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "constructions/statics/forces/every_equilibrium.hpp"
#include "constructions/statics/forces/hanging_groups.hpp"
#include "constructions/statics/forces/joint_equations.hpp"
#include "constructions/statics/forces/sums.hpp"

namespace kinegraph::statics {

/// What the counts say of equilibrium: it determines all forces; it leaves some open; the loads move the mechanism,
/// since there are fewer efforts than freedoms.
enum class Determinacy { determinate, redundant, unbalanced };

class Runs {
public:
    /// `adrift`: members that are skipped because the given forces on them are not in equilibrium.
    Runs(ForceModel& model, Board& board, const Mechanism& mechanism, std::set<MemberIndex> adrift,
         Determinacy determinacy)
        : model_(model),
          board_(board),
          determinacy_(determinacy),
          known_(model, std::move(adrift), mechanism.efforts.empty() ? hung_on_frame(model) : std::vector<Group>{}),
          said_(model, board, mechanism, known_),
          rules_(model, board, known_, said_),
          sums_(board, known_, said_),
          alike_(model, board, known_, said_, rules_, board.place(PointIndex(0))),
          joint_(model, board, known_, said_) {}
    Runs(const Runs&) = delete;
    Runs& operator=(const Runs&) = delete;

    const NamedMeets& meets() const { return said_.meets(); }
    /// As Rules::whole.
    Run whole(const Group& hung, std::map<MemberIndex, std::string> bars) {
        return rules_.whole(hung, std::move(bars));
    }

    Run run();

private:
    /// Joint equilibrium equations and rules in turn.
    Run jointly(const std::vector<Load>& loads, Run run);
    /// In an indeterminate structure: where groups are too large for virtual motions.
    Run jointly_where_large(const std::vector<Load>& loads, Run run);
    /// Load by load; none if this does not give all forces.
    std::optional<Run> in_parts(const std::vector<Load>& loads);

    ForceModel& model_;
    Board& board_;
    Determinacy determinacy_;
    KnownForces known_;
    ForceSentences said_;
    Rules rules_;
    Sums sums_;
    EveryEquilibrium alike_;
    JointEquations joint_;
};

}  // namespace kinegraph::statics
