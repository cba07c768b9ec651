// Zero-force bars, found without drawing.
#pragma once

#include "constructions/statics/truss/known_truss.hpp"

namespace kinegraph::statics {

/// Sets them to zero one after another, with a sentence each. At an unloaded pin: two bars not in line, the third of
/// three of which two are in line, or a single bar. Bars already known to be zero do not count.
void settle_idle_bars(KnownTruss& truss);

}  // namespace kinegraph::statics
