// What a request to solve comes to, before anything is written or said: for the command, and for those that carry out
// many requests in one run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "app/commands/commands.hpp"
#include "app/commands/outputs.hpp"

namespace kinegraph::app {

struct Solved {
    /// A result that was sought and could not be found: in which file or position, what, and why.
    struct Missing {
        Words where;
        std::string line;
    };
    std::vector<Output> outputs;  ///< the targets' files with their bytes; of no targets the table, for standard output
    std::vector<std::string> remarks;  ///< in the language of the request, each once
    std::vector<Missing> unsolved;
    Status status() const { return unsolved.empty() ? Status::done : Status::unsolved; }
};

/// Reads, solves and draws what `request` asks, for `targets` (its own outputs and theme have been made targets and
/// theme). The press is opened where something is drawn and it is not open yet. Else it has been said what is wrong.
tl::expected<Solved, Status> solved(const SolveRequest& request, const std::vector<Target>& targets,
                                    const render::Theme& theme, std::optional<Press>& press);

}  // namespace kinegraph::app
