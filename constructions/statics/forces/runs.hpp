// How the forces of a mechanism are found: all loads together by the rules. If this does not give all forces: the
// values that every equilibrium has in common, or load by load, or by trials.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "constructions/statics/forces/every_equilibrium.hpp"
#include "constructions/statics/forces/hanging_groups.hpp"
#include "constructions/statics/forces/trials.hpp"

namespace kinegraph::statics {

class Runs {
public:
    /// `adrift`: members that are skipped because the given forces on them are not in equilibrium. `redundant`:
    /// equilibrium does not determine all forces.
    Runs(ForceModel& model, Board& board, const Mechanism& mechanism, std::set<MemberIndex> adrift, bool redundant)
        : model_(model),
          redundant_(redundant),
          known_(model, std::move(adrift), mechanism.efforts.empty() ? hung_on_frame(model) : std::vector<Group>{}),
          said_(model, board, mechanism, known_),
          rules_(model, board, known_, said_),
          sums_(model, board, known_, said_),
          alike_(model, board, known_, said_, rules_, board.place(PointIndex(0))),
          trials_(model, board, known_, said_, rules_, board.place(PointIndex(0))) {}
    Runs(const Runs&) = delete;
    Runs& operator=(const Runs&) = delete;

    const NamedMeets& meets() const { return said_.meets(); }
    /// As Rules::whole.
    Run whole(const Group& hung, std::map<MemberIndex, std::string> bars) {
        return rules_.whole(hung, std::move(bars));
    }

    Run run();

private:
    Run solve(const std::vector<Load>& loads);

    ForceModel& model_;
    bool redundant_;
    KnownForces known_;
    ForceSentences said_;
    Rules rules_;
    Sums sums_;
    EveryEquilibrium alike_;
    Trials trials_;
};

}  // namespace kinegraph::statics
