// The engine behind the workbench: one request in, one answer out, both JSON (protocol.d.ts has their types). The
// native program serves it over HTTP, the static site calls it in a worker. It uses the library only: no file system,
// no threads, no server.
#pragma once

#include <string>
#include <string_view>

namespace kinegraph::app {

/// Answers a request about the text of a mechanism file. What the text lacks is part of the answer ("faults",
/// "remarks", "unsolved"), so an answer never fails. Documents and drawings have the bytes that `kinegraph solve`
/// writes for a file of this name and the same options.
std::string workbench_answer(std::string_view request_json);

}  // namespace kinegraph::app
