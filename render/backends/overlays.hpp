// Overlays: several texts that have most of their lines in common, as one text that says which line belongs to which of
// them. Independent of what the lines mean.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace kinegraph::render {

class Overlays {
public:
    /// The next text. Lines end in a line break.
    void add(std::string_view text);
    /// All lines, those of some texts only as `\only<2-3,5>{…}`, by the numbers of the texts from 1. Each text alone
    /// has its lines in their order.
    std::string text() const;

private:
    struct Line {
        std::string text;
        std::vector<std::size_t> on;  // numbers of the texts that have it, ascending
    };
    std::vector<Line> lines_;
    std::size_t texts_ = 0;
};

/// Numbers in ascending order as beamer writes them: "1-3,5".
std::string overlay_ranges(const std::vector<std::size_t>& numbers);

}  // namespace kinegraph::render
