// Key of a figure: a name that has no room beside its object is replaced by a number there, and listed below the
// figure. Owns the numbers and the lines of the key; places nothing in the figure itself.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "render/page/figure.hpp"

namespace kinegraph::render {

class LabelKey {
public:
    explicit LabelKey(const Fonts& fonts) : fonts_(fonts) {}

    /// Moves the requests with these indices (increasing) to the key. Neighbouring ones share a number, whose request
    /// replaces theirs. If a number itself is moved, it is dropped, and the key lists its names without one.
    void take(std::vector<LabelRequest>& requests, const std::vector<std::size_t>& placeless);
    bool empty() const { return entries_.empty(); }

    /// The lines with their top left corner at a given place, no wider than `measure` mm, and their size.
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
        const LabelRequest* label = nullptr;  ///< null: a number
        double before = 0;                    ///< gap to the previous word of the line, mm
        double ring = 0;                      ///< radius of the circle round a body's number, mm
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
