// Fill is measured in squares with ink; the score of sizes is logarithmic, like the steps of scales.
#include "render/layout/sheet_choice.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "engine/number/index.hpp"
#include "render/page/ink_map.hpp"

namespace kinegraph::render {
namespace {

/// Above a certain size lengths can be read to a hundredth or better, and a larger figure gains little.
double use_of_square(double size) {
    constexpr double long_enough = 80, of_more = 0.3;
    return std::log(std::min(size, long_enough) + of_more * std::max(0.0, size - long_enough));
}

/// A grid of squares of 10 mm within a frame that records which have ink.
class Squares {
public:
    explicit Squares(const Box& frame)
        : corner_(frame.min + Spot{off_frame, off_frame}),
          columns_(count(frame.width())),
          rows_(count(frame.height())),
          inked_(at_index(columns_ * rows_), false) {}

    void ink(const Path& path) {
        const std::vector<Spot> outline = outline_of(path);
        for (std::size_t i = 0; i < outline.size(); ++i) {
            ink(outline[i]);
            if (i > 0) ink_between(outline[i - 1], outline[i]);
        }
        if (path.filled) fill(outline);
    }
    /// Letters are much smaller than a square: only the origin and the middle of each are marked.
    void ink(const TextMark& text) {
        constexpr double half = 0.35;  // em
        for (const Glyph& glyph : text.glyphs)
            for (const Spot spot : {glyph.origin, glyph.origin - Spot{0, half * glyph.size}})
                ink(text.angle == 0 ? spot : text.pivot + at_angle(spot - text.pivot, text.angle));
    }
    /// 1 if the frame is smaller than a square.
    double share() const {
        const auto count = static_cast<double>(std::count(inked_.begin(), inked_.end(), true));
        return inked_.empty() ? 1 : count / static_cast<double>(inked_.size());
    }

private:
    static constexpr double square = 10, off_frame = 1;  // the line of the frame does not count

    static Spot at_angle(Spot spot, double angle) { return std::cos(angle) * spot + std::sin(angle) * turned(spot); }
    static int count(double length) { return std::max(0, static_cast<int>((length - 2 * off_frame) / square)); }
    void ink(Spot spot) {
        const int column = column_of(spot.x), row = row_of(spot.y);
        if (column >= 0 && column < columns_ && row >= 0 && row < rows_)
            inked_[at_index(row * columns_ + column)] = true;
    }
    void ink_between(Spot from, Spot to) {
        constexpr double apart = 2;  // mm; a corner that is only touched does not count
        const auto steps = static_cast<int>(std::min(length(to - from), 1e4) / apart);
        for (int i = 1; i <= steps; ++i) ink(from + (static_cast<double>(i) / (steps + 1)) * (to - from));
    }
    int column_of(double x) const {
        return static_cast<int>(std::floor(std::clamp((x - corner_.x) / square, -1.0, 1e3)));
    }
    int row_of(double y) const { return static_cast<int>(std::floor(std::clamp((y - corner_.y) / square, -1.0, 1e3))); }
    /// Marks the squares whose centre is inside.
    void fill(const std::vector<Spot>& corners) {
        if (corners.size() < 3) return;
        Box box{corners.front(), corners.front()};
        for (const Spot& corner : corners) box.include(corner);
        for (int row = std::max(0, row_of(box.min.y)); row <= std::min(rows_ - 1, row_of(box.max.y)); ++row)
            for (int column = std::max(0, column_of(box.min.x)); column <= std::min(columns_ - 1, column_of(box.max.x));
                 ++column) {
                const Spot middle = corner_ + square * Spot{column + 0.5, row + 0.5};
                if (is_inside(corners, middle)) ink(middle);
            }
    }
    /// Even-odd rule.
    static bool is_inside(const std::vector<Spot>& corners, Spot spot) {
        bool inside = false;
        for (std::size_t i = 0, before = corners.size() - 1; i < corners.size(); before = i++) {
            const Spot &a = corners[i], &b = corners[before];
            if ((a.y > spot.y) != (b.y > spot.y) && spot.x < a.x + (spot.y - a.y) / (b.y - a.y) * (b.x - a.x))
                inside = !inside;
        }
        return inside;
    }

    Spot corner_;
    int columns_, rows_;
    std::vector<bool> inked_;
};

bool is_polygon(const Figure& figure) {
    constexpr std::string_view kinds[] = {"velocity", "acceleration", "forces", "closure"};
    return std::find(std::begin(kinds), std::end(kinds), figure.kind) != std::end(kinds);
}

/// The number of entries in the tables of known and unknown quantities. Tables of forces are omitted if columns are
/// narrow.
std::size_t known_and_unknown(const std::vector<Page>& pages) {
    std::size_t count = 0;
    for (const Page& page : pages)
        for (const Mark& mark : page.marks)
            if (const auto* text = std::get_if<TextMark>(&mark); text && (text->words == "✓" || text->words == "?"))
                ++count;
    return count;
}

}  // namespace

double fill_of(const Page& page, const Box& frame) {
    Squares squares(frame);
    for (const Mark& mark : page.marks)
        if (const auto* path = std::get_if<Path>(&mark))
            squares.ink(*path);
        else if (const auto* text = std::get_if<TextMark>(&mark))
            squares.ink(*text);
    return squares.share();
}

/// On average, or for a single polygon, because polygons are measured.
bool SheetChoice::is_much_smaller(const Sizes& sizes) const {
    constexpr double least = 0.58, least_of_polygon = 0.4;
    constexpr double most_gained = 2;  // limits the effect of a single large figure
    double sum = 0;
    for (const auto& [id, own] : sizes) {
        const auto found = first_.find(id);
        if (found == first_.end()) continue;
        const double ratio = own.size / found->second.size;
        if (own.is_read && ratio < least_of_polygon) return true;
        sum += std::log(std::min(ratio, most_gained));
    }
    return sum < std::log(least) * static_cast<double>(sizes.size());
}

void SheetChoice::offer(DrawnSheet sheet) {
    constexpr double well_filled = 0.72, full = 0.78;
    if (best_ && (!sheet.keeps_to_rooms || sheet.pages.size() > best_->pages.size())) return;
    const std::size_t told = known_and_unknown(sheet.pages);
    if (best_ && told < told_by_first_) return;
    constexpr double price_of_a_page = 1, price_of_lack = 20;
    constexpr double dot = 1;  // mm
    Sizes sizes;
    std::map<std::string, int> times;  // several pages may have a figure "mechanism"
    for (const Figure& figure : sheet.figures)
        sizes[{figure.id, times[figure.id]++}] = {std::max({figure.box.width(), figure.box.height(), dot}),
                                                  is_polygon(figure)};
    double score = -price_of_a_page * static_cast<double>(sheet.pages.size());
    for (const auto& [id, own] : sizes) score += use_of_square(own.size);
    double least = 1;
    for (std::size_t p = 0; p + 1 < sheet.pages.size(); ++p) {
        const double fill = fill_of(sheet.pages[p], frame_);
        least = std::min(least, fill);
        score -= price_of_lack * std::max(0.0, full - fill);
    }
    if (best_ && (is_much_smaller(sizes) || score <= score_)) return;
    if (!best_) first_ = std::move(sizes), told_by_first_ = told;
    best_ = std::move(sheet);
    score_ = score;
    is_settled_ = least >= well_filled || !best_->keeps_to_rooms;
}

}  // namespace kinegraph::render
