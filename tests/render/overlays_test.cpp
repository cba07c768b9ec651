// Overlays: of the merged text each number reads as its own text again.
#include "render/backends/overlays.hpp"

#include <gtest/gtest.h>

#include <random>
#include <sstream>

namespace overlays_test {
namespace {

using namespace kinegraph::render;

bool is_in(const std::string& ranges, std::size_t number) {
    std::istringstream parts(ranges);
    std::string part;
    while (std::getline(parts, part, ',')) {
        const std::size_t first = std::stoul(part), dash = part.find('-');
        const std::size_t last = dash == std::string::npos ? first : std::stoul(part.substr(dash + 1));
        if (number >= first && number <= last) return true;
    }
    return false;
}

/// What of a merged text belongs to one of the texts.
std::string read_back(const std::string& merged, std::size_t number) {
    std::istringstream lines(merged);
    std::string line, text;
    bool shown = true;
    while (std::getline(lines, line)) {
        if (line.starts_with("\\only<"))
            shown = is_in(line.substr(6, line.find('>') - 6), number);
        else if (line == "}%")
            shown = true;
        else if (shown)
            text += line + "\n";
    }
    return text;
}

TEST(Overlays, WriteRanges) {
    EXPECT_EQ(overlay_ranges({1}), "1");
    EXPECT_EQ(overlay_ranges({1, 2, 3, 5, 7, 8}), "1-3,5,7-8");
}

TEST(Overlays, HaveWhatIsCommonOnce) {
    Overlays overlays;
    overlays.add("a\nb\nc\n");
    overlays.add("a\nnew\nc\n");
    EXPECT_EQ(overlays.text(), "a\n\\only<1>{%\nb\n}%\n\\only<2>{%\nnew\n}%\nc\n");
}

TEST(Overlays, GiveEachTextBack) {
    std::mt19937 random(7);
    for (int round = 0; round < 50; ++round) {
        Overlays overlays;
        std::vector<std::string> texts;
        for (int i = 0; i < 6; ++i) {
            std::string text;
            for (unsigned long k = random() % 12; k > 0; --k)
                text += std::string(1, static_cast<char>('a' + random() % 4)) + "\n";
            overlays.add(text);
            texts.push_back(text);
        }
        const std::string merged = overlays.text();
        for (std::size_t i = 0; i < texts.size(); ++i) EXPECT_EQ(read_back(merged, i + 1), texts[i]);
    }
}

}  // namespace
}  // namespace overlays_test
