// Places of a text as editors count them.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace kinegraph::app {

/// A place in a text. Both from 0; a character beyond the first 65536 counts as two.
struct LinePlace {
    std::size_t line = 0, utf16 = 0;
};

/// The lines of a text (UTF-8), which must outlive it. They end with \n, \r\n or \r.
class Lines {
public:
    explicit Lines(std::string_view text);
    LinePlace place(std::size_t offset) const;
    /// The byte at a place, of a place behind the end of its line or of the text that end.
    std::size_t offset(LinePlace place) const;
    /// The end of the line in which the byte stands, without its line ending.
    std::size_t end_of_line(std::size_t offset) const;

private:
    std::size_t line_of(std::size_t offset) const;
    std::string_view text_;
    std::vector<std::size_t> begins_;
};

}  // namespace kinegraph::app
