// One worker of `kinegraph batch`: a line to its answer. Fonts and modules are opened by the first line that draws and
// stay.
#pragma once

#include <array>
#include <atomic>
#include <optional>
#include <string>
#include <utility>

#include "app/commands/batch_line.hpp"
#include "app/commands/commands.hpp"
#include "app/commands/solved.hpp"

namespace kinegraph::app {

/// How the lines of a run came out; shared by its workers.
struct BatchTally {
    std::atomic<long> answered = 0;
    std::atomic<long> refused = 0;  ///< answered with a status other than 0 and 3
    std::atomic<long> resumed = 0;  ///< done before
};

class BatchWorker {
public:
    BatchWorker(const BatchRequest& request, BatchTally& tally) : request_(request), tally_(tally) {}

    /// The answer, a line with its line feed. What goes wrong is said in it, faults of ours too.
    std::string answer(const std::string& line);

private:
    struct Answer {
        Status status = Status::done;
        std::string members = {};  ///< JSON: ", \"files\": […]" …
    };
    Answer carry_out(BatchLine& line);
    Answer made(const BatchLine& line);
    Answer written(const BatchLine& line);
    /// The look that is asked for; else it has been said what is wrong.
    const render::Theme* look(const SolveRequest& request);

    const BatchRequest& request_;
    BatchTally& tally_;
    std::optional<Press> press_;
    std::string theme_name_, theme_text_;
    std::optional<render::Theme> theme_;
};

}  // namespace kinegraph::app
