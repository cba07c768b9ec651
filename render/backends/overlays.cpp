#include "render/backends/overlays.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace kinegraph::render {
namespace {

std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

}  // namespace

void Overlays::add(std::string_view text) {
    const std::vector<std::string_view> more = lines_of(text);
    const std::size_t number = ++texts_, rows = lines_.size(), columns = more.size();
    // Longest common subsequence, of what is left from each place on.
    std::vector<std::uint32_t> common((rows + 1) * (columns + 1), 0);
    const auto at = [&](std::size_t i, std::size_t j) -> std::uint32_t& { return common[i * (columns + 1) + j]; };
    for (std::size_t i = rows; i-- > 0;)
        for (std::size_t j = columns; j-- > 0;)
            at(i, j) = lines_[i].text == more[j] ? at(i + 1, j + 1) + 1 : std::max(at(i + 1, j), at(i, j + 1));
    std::vector<Line> merged;
    std::size_t i = 0, j = 0;
    while (i < rows || j < columns) {
        if (i < rows && j < columns && lines_[i].text == more[j]) {
            merged.push_back(std::move(lines_[i++]));
            merged.back().on.push_back(number);
            ++j;
        } else if (j == columns || (i < rows && at(i + 1, j) >= at(i, j + 1))) {
            merged.push_back(std::move(lines_[i++]));
        } else {
            merged.push_back({std::string(more[j++]), {number}});
        }
    }
    lines_ = std::move(merged);
}

std::string Overlays::text() const {
    std::string text;
    for (std::size_t i = 0; i < lines_.size();) {
        std::size_t end = i;
        while (end < lines_.size() && lines_[end].on == lines_[i].on) ++end;
        const bool everywhere = lines_[i].on.size() == texts_;
        if (!everywhere) text += "\\only<" + overlay_ranges(lines_[i].on) + ">{%\n";
        for (; i < end; ++i) text += lines_[i].text + "\n";
        if (!everywhere) text += "}%\n";
    }
    return text;
}

std::string overlay_ranges(const std::vector<std::size_t>& numbers) {
    std::string text;
    for (std::size_t i = 0; i < numbers.size();) {
        std::size_t last = i;
        while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
        text += (text.empty() ? "" : ",") + std::to_string(numbers[i]);
        if (last > i) text += "-" + std::to_string(numbers[last]);
        i = last + 1;
    }
    return text;
}

}  // namespace kinegraph::render
