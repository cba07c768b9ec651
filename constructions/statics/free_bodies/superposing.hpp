// Loads that act alone, member by member, each with its bodies cut free; and of each action the polygon in which they
// add up.
#pragma once

#include <cstddef>
#include <optional>

#include "constructions/statics/free_bodies/cut_bodies.hpp"

namespace kinegraph::statics {

class Superposing {
public:
    Superposing(ForceModel& model, Board& board, const Mechanism& mechanism, const Mobility& mobility,
                const NamedMeets& meets)
        : model_(model),
          board_(board),
          mechanism_(mechanism),
          mobility_(mobility),
          meets_(meets),
          polygons_(model, board) {}

    /// Nothing: what acts alone is not in equilibrium by itself.
    std::optional<Superposition> superpose(const Run& run);

private:
    std::optional<Superposition::Part> cut_part(const PartRun& part);
    /// Of one action, on a body that moves: forces tip to tail, and couples.
    void sum_parts(std::size_t b, const Run& run, Superposition& found);

    ForceModel& model_;
    Board& board_;
    const Mechanism& mechanism_;
    const Mobility& mobility_;
    const NamedMeets& meets_;
    ForcePolygons polygons_;
};

}  // namespace kinegraph::statics
