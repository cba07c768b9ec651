// sweep FILE --over r: the results with one value of a parameter after another.
#pragma once

#include "app/commands/commands.hpp"

namespace kinegraph::app {

/// Every row is the file solved anew with that value, in the position that it then draws.
Status sweep_parameter(const SweepRequest& request);

}  // namespace kinegraph::app
