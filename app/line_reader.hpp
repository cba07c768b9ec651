// Lines from standard input, one at a time, until its end or until the run is to stop. Owns the signals that stop it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "app/files.hpp"

namespace kinegraph::app {

/// Reads lines while it lives; SIGINT and SIGTERM end the reading, and what was read is still to be answered. Seen to once, a
/// second signal ends the run as always.
class LineReader {
public:
    enum class Event { line, end, stopped, failed };

    LineReader();
    LineReader(const LineReader&) = delete;
    LineReader& operator=(const LineReader&) = delete;
    ~LineReader();

    /// The next line, without its line feed. Of one longer than `largest_input` so much and one character more.
    Event next(std::string& line);
    /// Why reading failed, and the signal that stopped it.
    Words why() const { return why_; }
    int signal() const;

private:
    /// More of the input; false: there is none, or no more is to be read.
    bool fill();
    Event last_ = Event::end;
    std::string buffer_;
    std::size_t at_ = 0;
    bool ended_ = false;
    Words why_;
};

}  // namespace kinegraph::app
