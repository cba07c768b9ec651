// The outcome of a request to solve, before anything is written or reported: shared by `solve` and by the commands that
// execute many requests in one run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "app/commands/commands.hpp"
#include "app/commands/outputs.hpp"

namespace kinegraph::app {

struct Solved {
    /// A result that could not be found: the file or position, the name, the reason.
    struct Missing {
        Words where;
        std::string line;
    };
    std::vector<Output>
        outputs;  ///< the targets' files with their bytes; without targets the table, for standard output
    std::vector<std::string> remarks;  ///< in the language of the request, each once
    std::vector<Missing> unsolved;
    Status status() const { return unsolved.empty() ? Status::done : Status::unsolved; }
};

/// Reads, solves and draws `request` for `targets` (the caller has already resolved its outputs and theme). Opens the
/// output writer if something is drawn and it is not open yet. A status after an error was reported.
tl::expected<Solved, Status> solved(const SolveRequest& request, const std::vector<Target>& targets,
                                    const render::Theme& theme, std::optional<OutputWriter>& press);

}  // namespace kinegraph::app
