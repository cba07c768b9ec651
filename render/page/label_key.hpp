// The key of a figure: what has no room beside its object gets a number there, and under the figure stands what the
// number is for. Owns the numbers and the lines of the key; places nothing in the figure itself.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "render/page/figure.hpp"

namespace kinegraph::render {

class LabelKey {
public:
    explicit LabelKey(const Fonts& fonts) : fonts_(fonts) {}

    /// Moves the requests with these indices (increasing) to the key. Those near each other share a number, which is
    /// asked for in their stead; a number that is itself moved goes, and the key lists what it was for without one.
    void take(std::vector<LabelRequest>& requests, const std::vector<std::size_t>& placeless);
    bool empty() const { return entries_.empty(); }

    /// The lines, their top left corner at a place, no wider than `measure` mm, and what they take.
    struct Lines {
        std::vector<Mark> marks;
        double width = 0, height = 0;
    };
    Lines lines(Spot at, double measure) const;

private:
    struct Entry {
        Spot anchor;
        std::vector<LabelRequest> labels;
        bool numbered = true;
    };
    struct Word {
        ShapedLine shaped;
        const LabelRequest* label = nullptr;  ///< none: a number
        double before = 0;                    ///< from the word before, where they share a line
        double ring = 0;                      ///< radius, round a body's number
        double width() const { return shaped.width > 2 * ring ? shaped.width : 2 * ring; }
    };
    static RichText number(int count);
    std::vector<Word> words(double measure) const;
    static std::size_t end_of_line(const std::vector<Word>& words, std::size_t first, double measure);
    static void set_word(std::vector<Mark>& marks, const Word& word, const LabelRequest& looks, Spot origin);

    const Fonts& fonts_;
    std::vector<Entry> entries_;
};

}  // namespace kinegraph::render
