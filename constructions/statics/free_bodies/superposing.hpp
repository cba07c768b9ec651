// Superposition: loads that act alone, member by member, each with its free bodies; and for each action the polygon in
// which its parts are added.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

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

    /// None if a load alone is not in equilibrium.
    std::optional<Superposition> superpose(const Run& run);

private:
    std::optional<Superposition::Part> cut_part(const PartRun& part);
    /// For one action on a moving body: adds forces tip to tail, and couples.
    void sum_parts(std::size_t b, const Run& run, Superposition& found);
    /// The polygon of one member under all loads, for three forces or more.
    void join_parts(MemberIndex member, const Run& run, Superposition& found);
    /// The partial forces of a bond on a member, those of the member's own loads first.
    std::vector<Side> parts_on(MemberIndex member, int b, const Run& run);

    ForceModel& model_;
    Board& board_;
    const Mechanism& mechanism_;
    const Mobility& mobility_;
    const NamedMeets& meets_;
    ForcePolygons polygons_;
};

}  // namespace kinegraph::statics
