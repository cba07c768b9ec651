// Memory ahead: what a sheet is going to take, asked of the system at once. A page that is first touched costs a
// process that lives for ten milliseconds more than all that is written to it.
#pragma once

namespace kinegraph::app {

enum class Ahead { of_a_sheet, of_its_figures };

/// Some megabytes that the next allocations of this thread take, in pages as large as the system has them; nothing
/// where it cannot. (Memory that is given back must stay the process's.)
void take_memory_ahead(Ahead ahead);

}  // namespace kinegraph::app
