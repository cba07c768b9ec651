// The outcome of a request to solve, before anything is written or reported: shared by `solve` and by the commands that
// execute many requests in one run.
#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "app/commands/commands.hpp"
#include "app/commands/outputs.hpp"

namespace kinegraph::app {

struct Outcome {
    /// A result that could not be found: the file or position, the result, the reason.
    struct Missing {
        Words where;
        Text what, why;
    };
    std::vector<Output>
        outputs;                ///< the targets' files with their bytes; without targets the table, for standard output
    std::vector<Text> remarks;  ///< each once
    std::vector<Missing> unsolved;
    Status status() const { return unsolved.empty() ? Status::done : Status::unsolved; }
};

/// Reads, solves and draws `request` for `targets`. The caller has resolved its outputs, and its theme by set_theme().
/// A status after an error was reported.
tl::expected<Outcome, Status> outcome_of(const SolveRequest& request, const std::vector<Target>& targets);

}  // namespace kinegraph::app
