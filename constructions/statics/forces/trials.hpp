// Solution by trial values, if no order of bodies gives all forces. An unknown gets two values, each is drawn by the
// rules, and the closing errors give the true value, since the problem is linear.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "constructions/statics/forces/rules.hpp"
#include "constructions/statics/forces/sums.hpp"

namespace kinegraph::statics {

class Trials {
public:
    /// `origin`: place about which closing moments are measured.
    Trials(ForceModel& model, Board& board, const KnownForces& known, ForceSentences& said, Rules& rules,
           PlaceOnDrawing origin)
        : model_(model),
          board_(board),
          known_(known),
          said_(said),
          rules_(rules),
          sums_(model, board, known, said),
          origin_(origin) {}

    /// Gives one unknown two trial values and combines the two runs in the proportion that closes. If one unknown is
    /// not enough, the run stays as it was.
    void close_by_trial(const std::vector<Load>& loads, Run& run);

private:
    /// Tries a force along the bond's own line, or its couple.
    bool try_value(const std::vector<Load>& loads, Run& run, int b);
    /// The closing error that changes most between the trials; components are preferred to moments.
    std::pair<ScalarHandle, std::optional<ScalarHandle>> clearest_gap(const std::vector<Load>& loads, const Run& first,
                                                                      const Run& second);
    /// A couple in N m as a force vector of the same number of N, to compare it with forces.
    Force as_force(ScalarHandle couple) { return board_.scale<Plane::force>(couple, board_.own_direction({1, 0})); }
    std::optional<Force> largest_of(const std::vector<Load>& loads);
    /// Makes a bond known, with a trial force along its line or couple, of the order of the largest load.
    void give(Run& run, int b, int size, const std::optional<Force>& largest);
    /// Closing error at a member: components along x and y, and the moment about one fixed place.
    std::array<ScalarHandle, 3> gaps(MemberIndex member, const std::vector<Load>& loads, const Run& run);

    ForceModel& model_;
    Board& board_;
    const KnownForces& known_;
    ForceSentences& said_;
    Rules& rules_;
    Sums sums_;
    PlaceOnDrawing origin_;
};

}  // namespace kinegraph::statics
