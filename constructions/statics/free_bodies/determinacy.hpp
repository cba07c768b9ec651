// Whether a run found all forces, which members are not in equilibrium, and why forces are not determined.
#pragma once

#include <set>

#include "constructions/statics/forces.hpp"
#include "constructions/statics/free_bodies/intermediate_constructions.hpp"

namespace kinegraph::statics {

class ForceDeterminacy {
public:
    ForceDeterminacy(ForceModel& model, Board& board, const Mechanism& mechanism, const Mobility& mobility,
                     const UnderLoads& under)
        : model_(model), board_(board), mechanism_(mechanism), mobility_(mobility), under_(under) {}

    /// Members that do not balance though all their bonds are known, and those connected to them by known bonds (not
    /// through the frame). Their forces are discarded.
    std::set<MemberIndex> out_of_equilibrium(const Run& run);
    /// Whether all forces are known, except those between members out of equilibrium.
    bool is_complete(const Run& run, const std::set<MemberIndex>& unbalanced) const;
    void explain(const Run& run, bool balanced, ForceResults& results);
    void remark_teeth(const Run& run, ForceResults& results);
    /// Reports contacts that would have to pull.
    void remark_lift_off(const Run& run, ForceResults& results);
    /// The part of a reaction that equilibrium leaves open: all of it, the component perpendicular to the known one,
    /// its couple.
    static Symbols open_symbols(const Bond& bond, const Reaction& reaction, bool reversed);

private:
    /// Why the forces are not determined; `open`: which ones, if only some are.
    Message reason(Symbols open);
    /// Whether some motion does no work against any joint, input force or couple, by the rank.
    bool moves_freely();

    ForceModel& model_;
    Board& board_;
    const Mechanism& mechanism_;
    const Mobility& mobility_;
    const UnderLoads& under_;
};

}  // namespace kinegraph::statics
