// Squares are asked of the ink map of a whole page.
#include "render/sheet/page_fill.hpp"

#include <algorithm>

#include "render/page/ink_map.hpp"

namespace kinegraph::render {

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

Fill fill_of(const std::vector<Page>& pages, const Box& frame, const Fonts& fonts) {
    Fill fill{pages.size()};
    if (pages.size() < 2) return fill;
    double sum = 0;
    for (std::size_t p = 0; p + 1 < pages.size(); ++p) {
        const double own = fill_of(pages[p], frame, fonts);
        fill.least = std::min(fill.least, own);
        sum += own;
    }
    fill.mean = sum / static_cast<double>(pages.size() - 1);
    return fill;
}

bool is_better(const Fill& one, const Fill& other) {
    return one.pages != other.pages ? one.pages < other.pages : one.mean > other.mean;
}

}  // namespace kinegraph::render
