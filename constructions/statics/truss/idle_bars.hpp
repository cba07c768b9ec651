// Bars that carry nothing, as is seen without drawing.
#pragma once

#include "constructions/statics/truss/known_truss.hpp"

namespace kinegraph::statics {

/// Settles them one after another, with a sentence each: at an unloaded pin two bars not in line, the third of three
/// with two in line, one alone; other bars that are known to carry nothing do not count.
void settle_idle_bars(KnownTruss& truss);

}  // namespace kinegraph::statics
