// A line of `kinegraph batch`: reads the request and checks it against the format (docs/batch.md). Solves and writes
// nothing.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/commands/commands.hpp"
#include "app/commands/outputs.hpp"
#include "engine/file/error.hpp"

namespace kinegraph::app {

struct BatchLine {
    std::string id = "null";   ///< as JSON, as the line gives it
    SolveRequest request;      ///< of a mechanism in the line: its text, under the name "mechanism"
    std::vector<Format> want;  ///< each once, in the order of the line
    std::string to;            ///< path of the files without extension; empty: everything goes into the answer
    Errors errors;             ///< every fault of the line; if there is one, ignore the other members

    /// The output files: TO.json, TO.svg … For a line without "to": a name for each, under which nothing is written.
    std::vector<Target> targets() const;
};

/// Reads a line; missing keys are taken from `defaults`.
BatchLine read_batch_line(std::string_view line, const SolveRequest& defaults);

}  // namespace kinegraph::app
