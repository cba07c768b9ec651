// A line of `kinegraph batch`: what it asks, read and held against its form (docs/batch.md). Solves and writes
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
    std::vector<Format> want;  ///< each once, in the line's order
    std::string to;            ///< where files go, without the ending; empty: all goes into the answer
    Errors errors;             ///< every fault of the line; where there is one the rest is not to be used

    /// Where what is wanted goes: TO.json, TO.svg …; of a line without "to" a name for each, under which nothing is
    /// written.
    std::vector<Target> targets() const;
};

/// Reads a line; what it does not say is as in `defaults`.
BatchLine read_batch_line(std::string_view line, const SolveRequest& defaults);

}  // namespace kinegraph::app
