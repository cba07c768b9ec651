// What a thread that has computed with exact numbers gives back when it ends: libraries below keep constants for each
// thread.
#pragma once

namespace kinegraph {

/// To be called last by a thread other than the first.
void end_thread();

}  // namespace kinegraph
