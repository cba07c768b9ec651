// Memory ahead: what a sheet is going to take, asked of the system at once. A page that is first touched costs a process that
// lives for ten milliseconds more than all that is written to it.
#pragma once

namespace kinegraph::app {

/// Some megabytes that the next allocations take, in pages as large as the system has them; nothing where it cannot. (Memory that
/// is given back must stay the process's.)
void take_memory_ahead();

}  // namespace kinegraph::app
