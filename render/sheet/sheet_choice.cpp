// Squares are asked of the ink map of a whole page; sizes count by their logarithms, as steps of a scale do.
#include "render/sheet/sheet_choice.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "render/page/ink_map.hpp"

namespace kinegraph::render {
namespace {

/// What can be read to a hundredth or better gains little by being larger.
double use_of(double size) {
    constexpr double long_enough = 80, of_more = 0.3;
    return std::log(std::min(size, long_enough) + of_more * std::max(0.0, size - long_enough));
}

bool is_polygon(const Figure& figure) {
    constexpr std::string_view kinds[] = {"velocity", "acceleration", "forces", "closure"};
    return std::find(std::begin(kinds), std::end(kinds), figure.kind) != std::end(kinds);
}

}  // namespace

double fill_of(const Page& page, const Box& frame, const Fonts& fonts) {
    constexpr double square = 10;
    InkMap map(frame);
    for (const Mark& mark : page.marks)
        if (const auto* path = std::get_if<Path>(&mark)) {
            map.ink(*path);
            if (path->filled && path->tinted) map.fill(outline_of(*path));
        } else if (const auto* text = std::get_if<TextMark>(&mark)) {
            if (const auto ink = ink_of(*text, fonts)) map.fill(*ink);
        }
    constexpr double off_frame = 1;  // its own line is no filling
    int squares = 0, inked = 0;
    for (double y = frame.min.y + off_frame; y + square < frame.max.y - off_frame; y += square)
        for (double x = frame.min.x + off_frame; x + square < frame.max.x - off_frame; x += square) {
            ++squares;
            inked += map.touches({{x + square / 2, y + square / 2}, {square / 2, square / 2}}) ? 1 : 0;
        }
    return squares > 0 ? static_cast<double>(inked) / squares : 1;
}

/// On average; or one of the polygons, which are read.
bool SheetChoice::is_much_smaller(const Sizes& sizes) const {
    constexpr double least = 0.58, least_of_polygon = 0.4;
    constexpr double most_gained = 2;  // one that is much larger makes up for no other
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
    constexpr double price_of_a_page = 1, price_of_lack = 20;
    constexpr double dot = 1;  // mm
    Sizes sizes;
    for (const Figure& figure : sheet.figures)
        sizes[figure.id] = {std::max({figure.box.width(), figure.box.height(), dot}), is_polygon(figure)};
    double worth = -price_of_a_page * static_cast<double>(sheet.pages.size());
    for (const auto& [id, own] : sizes) worth += use_of(own.size);
    double least = 1;
    for (std::size_t p = 0; p + 1 < sheet.pages.size(); ++p) {
        const double fill = fill_of(sheet.pages[p], frame_, fonts_);
        least = std::min(least, fill);
        worth -= price_of_lack * std::max(0.0, full - fill);
    }
    if (best_ && (sheet.pages.size() > best_->pages.size() || is_much_smaller(sizes) || worth <= worth_)) return;
    if (!best_) first_ = std::move(sizes);
    best_ = std::move(sheet);
    worth_ = worth;
    is_well_filled_ = least >= well_filled;
}

}  // namespace kinegraph::render
