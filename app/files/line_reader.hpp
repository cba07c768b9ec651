// Lines from standard input, one at a time, until its end or until the run is to stop. Owns the signals that stop it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "app/files/files.hpp"

namespace kinegraph::app {

/// Reads lines while it lives; SIGINT and SIGTERM end the reading, also where input is always ready and where lines
/// wait in the buffer. Further signals change nothing while it lives.
class LineReader {
public:
    enum class Event { line, end, stopped, failed };

    LineReader();
    LineReader(const LineReader&) = delete;
    LineReader& operator=(const LineReader&) = delete;
    ~LineReader();

    /// The next line, without its line feed. Of one longer than `largest_input` so much and one character more.
    Event next(std::string& line);
    /// Why reading failed.
    Words why() const { return why_; }
    /// The signal that came; 0: none. Any thread may ask.
    static int signal();

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
