// Input forces and couples by virtual work, in successive positions. The displacements of one position are records, one
// for each freedom, replayed in doubles while their guards hold. Does not plan.
#pragma once

#include <list>
#include <optional>
#include <vector>

#include "constructions/positions/givens_here.hpp"
#include "engine/board/replay.hpp"
#include "engine/solution/displacements.hpp"

namespace kinegraph {

class EffortRows {
public:
    /// Acceleration of a mass: of its centre (m/s²) and of its body (rad/s²); gives the inertia forces.
    struct Acceleration {
        VectorOf<double> centre;
        double alpha = 0;
    };
    /// By Mechanism::efforts, N or N m; none if not determined in this position.
    using Efforts = std::vector<std::optional<double>>;

    /// Keeps references to both.
    EffortRows(const Mechanism& mechanism, const GivensHere& givens) : mechanism_(mechanism), givens_(givens) {}

    /// Keeps the displacements of a planned position for replay.
    void keep(const Displacements& found);
    /// Values at `places`; none if no kept record is valid there. `masses`: by Mechanism::masses, if the file has
    /// inertia forces.
    std::optional<Efforts> here(const Places& places, const Positions& positions,
                                const std::vector<Acceleration>& masses);
    /// Values of a planned position.
    static Efforts of(const Displacements& found);

private:
    struct Share {
        int effort = -1;
        ElementIndex power;  ///< none if it does no work
    };
    struct Record {
        Replay replay;
        std::vector<std::pair<int, Given>> moving;  ///< with their index in the program
        std::vector<Share> shares;
        ElementIndex total;                 ///< the work of the given loads; none if there are none
        std::vector<ElementIndex> entries;  ///< its terms
    };
    static std::vector<ElementIndex> wanted(const VirtualWork& work);
    Record record_of(const Solution& moved) const;
    bool is_inertia(const Given& given) const;
    ValueOf<double> inertia(const Given& given, const std::vector<Acceleration>& masses) const;
    /// Replays the freedom's records until one is valid here; null if none is.
    const Record* replayed(std::list<Record>& kept, const Places& places, const Positions& positions,
                           const std::vector<Acceleration>& masses) const;

    const Mechanism& mechanism_;
    const GivensHere& givens_;
    std::vector<std::list<Record>> kept_;  ///< by freedom
};

}  // namespace kinegraph
