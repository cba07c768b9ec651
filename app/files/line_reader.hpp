// Reads lines from standard input until its end or a signal. Owns the handlers of the signals that stop a run.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "app/files/files.hpp"

namespace kinegraph::app {

/// While it exists, SIGINT and SIGTERM end the reading, also if input is always ready or lines wait in the buffer.
/// Further signals have no effect.
class LineReader {
public:
    enum class Event { line, end, stopped, failed };

    LineReader();
    LineReader(const LineReader&) = delete;
    LineReader& operator=(const LineReader&) = delete;
    ~LineReader();

    /// The next line, without its line feed. A longer line is cut to `largest_input` + 1 characters.
    Event next(std::string& line);
    /// Why reading failed.
    Words why() const { return why_; }
    /// The signal that arrived; 0: none. May be called from any thread.
    static int signal();

private:
    /// Reads more input; false: there is none, or reading has ended.
    bool fill();
    Event last_ = Event::end;
    std::string buffer_;
    std::size_t at_ = 0;
    bool ended_ = false;
    Words why_;
};

}  // namespace kinegraph::app
