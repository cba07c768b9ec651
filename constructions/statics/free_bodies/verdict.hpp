// Whether a run found all forces, which members are out of equilibrium, and the reason where something is not
// determined.
#pragma once

#include <set>

#include "constructions/statics/forces.hpp"
#include "constructions/statics/free_bodies/way.hpp"

namespace kinegraph::statics {

class Verdict {
public:
    Verdict(ForceModel& model, const Mechanism& mechanism, const Mobility& mobility, const UnderLoads& under)
        : model_(model), mechanism_(mechanism), mobility_(mobility), under_(under) {}

    /// Members that do not balance though all their bonds are known, and what hangs on them by known bonds (not through
    /// the frame): of these nothing is known.
    std::set<MemberIndex> out_of_equilibrium(const Run& run);
    /// All but what bodies exert on each other that are not in equilibrium.
    bool is_complete(const Run& run, const std::set<MemberIndex>& unbalanced) const;
    void explain(const Run& run, bool balanced, ForceResults& results);
    /// A contact that would have to pull.
    void remark_lift_off(const Run& run, ForceResults& results);
    /// What of a reaction equilibrium leaves open: all of it, the component across that which is known, its couple.
    static Symbols open_symbols(const Bond& bond, const Reaction& reaction, bool reversed);

private:
    /// Why the forces are not determined; `open`: which ones, where some are.
    Message reason(const Run& run, Symbols open) const;

    ForceModel& model_;
    const Mechanism& mechanism_;
    const Mobility& mobility_;
    const UnderLoads& under_;
};

}  // namespace kinegraph::statics
