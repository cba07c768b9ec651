// sweep FILE --over r: the results for a sequence of values of a parameter.
#pragma once

#include "app/commands/commands.hpp"

namespace kinegraph::app {

/// For every row the file is solved again with that value, in its drawn position.
Status sweep_parameter(const SweepRequest& request);

}  // namespace kinegraph::app
