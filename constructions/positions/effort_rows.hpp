// Effort rows: the efforts that virtual work finds, in one position after another. The displacements of one position
// are records, one for each freedom; they are replayed in doubles for as long as their guards hold. Plans nothing
// itself.
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
    /// Of a mass: the acceleration of its centre (m/s²) and of its body (rad/s²), which make its forces of inertia.
    struct Acceleration {
        VectorOf<double> centre;
        double alpha = 0;
    };
    /// By Mechanism::efforts, N or N m; none where the position leaves an effort open.
    using Efforts = std::vector<std::optional<double>>;

    /// Both are kept by reference.
    EffortRows(const Mechanism& mechanism, const GivensHere& givens) : mechanism_(mechanism), givens_(givens) {}

    /// The displacements of a position that was planned serve for those like it.
    void keep(const Displacements& found);
    /// In the position of `places`; nothing where none of the records kept holds there. `masses`: by Mechanism::masses,
    /// where the file has forces of inertia.
    std::optional<Efforts> here(const Places& places, const Positions& positions,
                                const std::vector<Acceleration>& masses);
    /// The efforts of a position that was planned.
    static Efforts of(const Displacements& found);

private:
    struct Share {
        int effort = -1;
        ElementIndex power;  ///< none: it does no work
    };
    struct Record {
        Replay replay;
        std::vector<std::pair<int, Given>> moving;  ///< with their index in the program
        std::vector<Share> shares;
        ElementIndex total;                 ///< the work of what is given; none: nothing is
        std::vector<ElementIndex> entries;  ///< the works that it is made of
    };
    static std::vector<ElementIndex> wanted(const VirtualWork& work);
    Record record_of(const Solution& moved) const;
    bool is_inertia(const Given& given) const;
    ValueOf<double> inertia(const Given& given, const std::vector<Acceleration>& masses) const;
    /// The one of a freedom's records whose guards hold here, replayed.
    const Record* replayed(std::list<Record>& kept, const Places& places, const Positions& positions,
                           const std::vector<Acceleration>& masses) const;

    const Mechanism& mechanism_;
    const GivensHere& givens_;
    std::vector<std::list<Record>> kept_;  ///< by freedom
};

}  // namespace kinegraph
