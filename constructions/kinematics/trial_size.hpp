// The size of a trial value is free, so it is of the order of what is drawn already. On paper a much larger or smaller
// trial could not be read off, and in doubles it would be lost in rounding.
#pragma once

#include "engine/board/board.hpp"

namespace kinegraph {

/// The power of ten for which the length of `times(power)`, which is proportional to it, is between `longest` / 10 and
/// `longest`. Both must not be zero.
template <Plane plane, class Times>
Exact power_of_ten_reaching(Board& board, VectorOn<plane> longest, Times times) {
    Exact power = 1;
    while (!board.choose_longer(times(10 * power), longest)) power = 10 * power;
    while (board.choose_longer(times(power), longest)) power = power / 10;
    return power;
}

}  // namespace kinegraph
