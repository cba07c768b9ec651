// What no order of bodies resolves: an unknown gets two trial values, each is drawn by the rules, and what does not
// close tells the true one, for all is linear.
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
    /// `origin`: about which moments that do not close are measured.
    Trials(ForceModel& model, Board& board, const KnownForces& known, ForceSentences& said, Rules& rules,
           PlaceOnDrawing origin)
        : model_(model),
          board_(board),
          known_(known),
          said_(said),
          rules_(rules),
          sums_(model, board, known, said),
          origin_(origin) {}

    /// The last rule. One unknown gets two trial values; each is drawn; what does not close
    /// then tells in which proportion they must be added, for everything is linear. Several unknowns nest.
    void close_by_trial(const std::vector<Load>& loads, Run& run, int depth);

private:
    /// A force along the bond's own line, or its couple.
    bool try_value(const std::vector<Load>& loads, Run& run, int b, int depth);
    /// Of what does not close in the first trial that which changes most to the second: components before moments.
    std::pair<ScalarHandle, std::optional<ScalarHandle>> clearest_gap(const std::vector<Load>& loads, const Run& first,
                                                                      const Run& second);
    /// A couple as long as a force of so many newtons, to be compared with forces.
    Force as_force(ScalarHandle couple) { return board_.scale<Plane::force>(couple, board_.own_direction({1, 0})); }
    std::optional<Force> largest_of(const std::vector<Load>& loads);
    /// Declares a bond known, of a trial size along its line or as a couple; of the order of the largest load.
    void give(Run& run, int b, int size, const std::optional<Force>& largest);
    /// What does not close at a member: components along x and y, and the moment about one fixed place.
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
