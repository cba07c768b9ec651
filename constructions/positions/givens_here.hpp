// Givens here: what the givens of a record are in another position of the mechanism, in doubles, for whoever replays
// the record.
#pragma once

#include <vector>

#include "engine/board/program.hpp"
#include "engine/motion/positions.hpp"

namespace kinegraph {

class GivensHere {
public:
    /// `pose` is the drawn one. The mechanism is kept by reference.
    GivensHere(const Mechanism& mechanism, const Pose& pose);

    /// Whether a given hangs on the position. Rates do not: those of a law hang on the time.
    bool hangs(const Given& given) const;
    /// Its value, where it hangs on the position.
    ValueOf<double> value(const Given& given, const Places& places, const Positions& positions) const;
    /// Of a torsion spring: how far it is turned from where it is slack, rad.
    static double turned(const TorsionLoad& torsion, const Positions& positions);

private:
    ValueOf<double> value_of_load(const Given& given, const Places& places, const Positions& positions) const;

    const Mechanism& mechanism_;
    std::vector<double> senses_;  ///< by joint: −1 where it pushes against its normal as drawn
};

}  // namespace kinegraph
