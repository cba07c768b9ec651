// Converts a run to results: joint forces, input forces and couples, and the virtual motions that gave forces of
// redundant constraints.
#pragma once

#include "constructions/statics/forces.hpp"
#include "constructions/statics/free_bodies/intermediate_constructions.hpp"

namespace kinegraph::statics {

class FoundValues {
public:
    FoundValues(ForceModel& model, Board& board, const Mechanism& mechanism, IntermediateConstructions& constructions,
                ForceResults& results)
        : model_(model), board_(board), mechanism_(mechanism), constructions_(constructions), results_(results) {}

    void collect_bond(const Bond& bond, const Reaction& reaction, bool valid);
    /// The virtual motion of a sentence, and the arms of the forces that do work in it.
    void virtual_motion(const VirtualMotion& drawn);

private:
    void take_moments(const VirtualMotion& drawn, const VirtualMotion::Turning& turning);

    ForceModel& model_;
    Board& board_;
    const Mechanism& mechanism_;
    IntermediateConstructions& constructions_;
    ForceResults& results_;
};

}  // namespace kinegraph::statics
