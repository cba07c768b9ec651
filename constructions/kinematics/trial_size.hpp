// The size of a trial: free to choose, so of the order of what is drawn already. On paper a trial in another order of
// size could not be read off, and in doubles it would drown in rounding.
#pragma once

#include "engine/board/board.hpp"

namespace kinegraph {

/// The power of ten for which `times(power)`, a vector proportional to it, is as long as `longest` or less than ten
/// times shorter. Both are not zero.
template <Plane plane, class Times>
Exact power_of_ten_reaching(Board& board, VectorOn<plane> longest, Times times) {
    Exact power = 1;
    while (!board.choose_longer(times(10 * power), longest)) power = 10 * power;
    while (board.choose_longer(times(power), longest)) power = power / 10;
    return power;
}

}  // namespace kinegraph
