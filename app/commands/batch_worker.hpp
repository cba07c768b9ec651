// One worker of `kinegraph batch`: computes the answer to a line. The first line that draws opens the fonts and
// modules; they stay open.
#pragma once

#include <array>
#include <atomic>
#include <optional>
#include <string>
#include <utility>

#include "app/commands/commands.hpp"
#include "app/commands/solved.hpp"
#include "app/files/json_text.hpp"

namespace kinegraph::app {

/// Counts how the lines of a run ended; shared by the workers.
struct BatchTally {
    std::atomic<long> answered = 0;
    std::atomic<long> refused = 0;  ///< answered with a status other than 0 and 3
    std::atomic<long> resumed = 0;  ///< skipped, because an earlier run had done them
};

class BatchWorker {
public:
    BatchWorker(const BatchRequest& request, BatchTally& tally) : request_(request), tally_(tally) {}

    /// The answer: one line with its line feed. It reports every failure, also our own faults.
    std::string answer(const std::string& line);

private:
    struct Answer {
        Status status = Status::done;
        JsonLine members = {};    ///< "files": […] …
        bool has_status = false;  ///< the members have their own
    };
    Answer carry_out(SolveRequest& line);
    Answer made(const SolveRequest& line);
    Answer written(const SolveRequest& line);
    /// Sets the theme that the line names; false after an error was reported.
    bool set_look(SolveRequest& line);

    const BatchRequest& request_;
    BatchTally& tally_;
    std::string theme_name_;               ///< of the last line
    std::optional<DrawingOptions> theme_;  ///< the last line's theme; none if it could not be read
};

}  // namespace kinegraph::app
