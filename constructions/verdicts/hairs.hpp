// Hairs: where nothing is degenerate, but a result hangs on a small difference of the data: which coincidence is nearly
// one, and what moving a point a little does. Changes nothing; a remark each.
#pragma once

#include <vector>

#include "engine/sentences/statement.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {

/// Of the finished solution. A coincidence counts as nearly one where it is missed by less than a thousandth of what it
/// stands beside; a result hangs on a hair where a move of a given point by 1e-4 of the size changes it by a tenth and
/// more.
std::vector<Message> remarks_on_hairs(const Solution& solution);

}  // namespace kinegraph
