// How the ink map is filled and asked: convex shapes as one run of bits in each row.
#include "render/ink_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/shapes.hpp"

namespace kinegraph::render {

namespace {

constexpr double most_bits = 3000;  // on a side

/// Calls look(row, from, to) with the run of a convex polygon in each row; rows are those whose middle it meets.
template <class Look>
void runs_of(const std::array<Spot, 4>& corners, double top, double pitch, int rows, Look look) {
    double low = corners[0].y, high = corners[0].y;
    for (const Spot& corner : corners) low = std::min(low, corner.y), high = std::max(high, corner.y);
    const int first = std::max(0, static_cast<int>(std::ceil(std::max(0.0, (low - top) / pitch - 0.5))));
    const int last = static_cast<int>(std::floor(std::min(rows - 1.0, (high - top) / pitch - 0.5)));
    for (int row = first; row <= last; ++row) {
        const double y = top + (row + 0.5) * pitch;
        double from = 1e300, to = -1e300;
        for (std::size_t k = 0; k < 4; ++k) {
            const Spot a = corners[k], b = corners[(k + 1) % 4];
            if ((a.y < y) == (b.y < y)) continue;
            const double x = a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y);
            from = std::min(from, x), to = std::max(to, x);
        }
        if (from <= to) look(row, from, to);
    }
}

/// Bits that are set. The baseline of x86-64 has no instruction for it, and std::popcount calls a function.
int count(std::uint64_t word) {
    word -= (word >> 1) & 0x5555555555555555U;
    word = (word & 0x3333333333333333U) + ((word >> 2) & 0x3333333333333333U);
    word = (word + (word >> 4)) & 0x0F0F0F0F0F0F0F0FU;
    return static_cast<int>((word * 0x0101010101010101U) >> 56);
}

std::array<Spot, 4> corners_of(const InkBox& box) {
    const Spot along = box.half.x * box.axis, across = box.half.y * turned(box.axis);
    return {box.centre - along - across, box.centre + along - across, box.centre + along + across, box.centre - along + across};
}

}  // namespace

Spot InkBox::local(Spot spot) const {
    const Spot d = spot - centre;
    return {dot(d, axis), cross(axis, d)};
}
Spot InkBox::reach() const {
    return {std::abs(axis.x) * half.x + std::abs(axis.y) * half.y, std::abs(axis.y) * half.x + std::abs(axis.x) * half.y};
}

InkMap::InkMap(const Box& area) : origin_(area.min) {
    pitch_ = std::max(pitch, std::max(area.width(), area.height()) / most_bits);
    columns_ = std::max(1, static_cast<int>(std::ceil(area.width() / pitch_)) + 1);
    rows_ = std::max(1, static_cast<int>(std::ceil(area.height() / pitch_)) + 1);
    words_ = (static_cast<std::size_t>(columns_) + 63) / 64;
    bits_.assign(words_ * static_cast<std::size_t>(rows_), 0);
}

template <class Look>
void InkMap::words_of(int row, double from, double to, Look look) const {
    const double first_bit = std::max(0.0, std::ceil((from - origin_.x) / pitch_ - 0.5));
    const double last_bit = std::min(columns_ - 1.0, std::floor((to - origin_.x) / pitch_ - 0.5));
    if (!(first_bit <= last_bit)) return;
    const auto first = static_cast<std::size_t>(first_bit), last = static_cast<std::size_t>(last_bit);
    const std::size_t base = static_cast<std::size_t>(row) * words_;
    for (std::size_t word = first / 64; word <= last / 64; ++word) {
        std::uint64_t mask = ~std::uint64_t{0};
        if (word == first / 64) mask &= ~std::uint64_t{0} << (first % 64);
        if (word == last / 64) mask &= ~std::uint64_t{0} >> (63 - last % 64);
        if (!look(base + word, mask)) return;
    }
}

void InkMap::ink_row(int row, double from, double to) {
    words_of(row, from, to, [&](std::size_t word, std::uint64_t mask) {
        bits_[word] |= mask;
        return true;
    });
}

void InkMap::stroke(Spot from, Spot to, double half) {
    // Half a bit more, so that the thinnest line leaves no gap; round ends only where they show.
    const double reach = half + pitch_ / 2;
    const bool round = half >= 0.3;
    fill(InkBox{0.5 * (from + to), {length(to - from) / 2 + (round ? 0 : reach), reach}, unit(to - from)});
    if (!round) return;
    for (const Spot end : {from, to}) {
        const int first = static_cast<int>(std::max(0.0, (end.y - reach - origin_.y) / pitch_ - 0.5));
        const int last = static_cast<int>(std::min(rows_ - 1.0, (end.y + reach - origin_.y) / pitch_));
        for (int row = first; row <= last; ++row) {
            const double y = origin_.y + (row + 0.5) * pitch_ - end.y, left = reach * reach - y * y;
            if (left >= 0) ink_row(row, end.x - std::sqrt(left), end.x + std::sqrt(left));
        }
    }
}

void InkMap::fill(const InkBox& box) {
    runs_of(corners_of(box), origin_.y, pitch_, rows_, [&](int row, double from, double to) { ink_row(row, from, to); });
}

void InkMap::fill(const std::vector<Spot>& corners) {
    if (corners.size() < 3) return;
    double low = corners[0].y, high = corners[0].y;
    for (const Spot& corner : corners) low = std::min(low, corner.y), high = std::max(high, corner.y);
    const int first = static_cast<int>(std::max(0.0, (low - origin_.y) / pitch_ - 0.5));
    const int last = static_cast<int>(std::min(rows_ - 1.0, (high - origin_.y) / pitch_));
    std::vector<double> met;
    for (int row = first; row <= last; ++row) {
        const double y = origin_.y + (row + 0.5) * pitch_;
        met.clear();
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const Spot a = corners[k], b = corners[(k + 1) % corners.size()];
            if ((a.y < y) != (b.y < y)) met.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
        }
        std::sort(met.begin(), met.end());
        for (std::size_t k = 0; k + 1 < met.size(); k += 2) ink_row(row, met[k], met[k + 1]);
    }
}

template <class Look>
void InkMap::rows_of(const InkBox& box, Look look) const {
    if (box.axis.y != 0) {
        bool go_on = true;
        runs_of(corners_of(box), origin_.y, pitch_, rows_, [&](int row, double from, double to) {
            if (go_on)
                words_of(row, from, to, [&](std::size_t word, std::uint64_t mask) { return go_on = look(bits_[word] & mask); });
        });
        return;
    }
    const double first = std::max(0.0, std::ceil((box.centre.y - box.half.y - origin_.y) / pitch_ - 0.5));
    const double last = std::min(rows_ - 1.0, std::floor((box.centre.y + box.half.y - origin_.y) / pitch_ - 0.5));
    const double left = std::max(0.0, std::ceil((box.centre.x - box.half.x - origin_.x) / pitch_ - 0.5));
    const double right = std::min(columns_ - 1.0, std::floor((box.centre.x + box.half.x - origin_.x) / pitch_ - 0.5));
    if (!(first <= last && left <= right)) return;
    // Upright: the same words in every row.
    const auto from = static_cast<std::size_t>(left), to = static_cast<std::size_t>(right);
    const std::uint64_t head = ~std::uint64_t{0} << (from % 64), tail = ~std::uint64_t{0} >> (63 - to % 64);
    for (auto row = static_cast<std::size_t>(first); row <= static_cast<std::size_t>(last); ++row) {
        const std::uint64_t* words = bits_.data() + row * words_;
        if (from / 64 == to / 64) {
            if (!look(words[from / 64] & head & tail)) return;
            continue;
        }
        if (!look(words[from / 64] & head)) return;
        for (std::size_t word = from / 64 + 1; word < to / 64; ++word)
            if (!look(words[word])) return;
        if (!look(words[to / 64] & tail)) return;
    }
}

double InkMap::inked(const InkBox& box, double most) const {
    const double bit = pitch_ * pitch_;
    const int enough = static_cast<int>(std::min(most / bit, 1e9)) + 1;
    int bits = 0;
    rows_of(box, [&](std::uint64_t word) {
        if (word != 0) bits += count(word);
        return bits < enough;
    });
    return bits * bit;
}

bool InkMap::touches(const InkBox& box) const {
    bool met = false;
    rows_of(box, [&](std::uint64_t word) { return !(met = word != 0); });
    return met;
}

int InkMap::crossings(Spot from, Spot to, int most) const {
    const int steps = std::max(1, static_cast<int>(std::ceil(length(to - from) / pitch_)));
    // In bits, and these in 2⁻³²: whole numbers add up alike everywhere.
    constexpr double one = 4294967296.0, far = 1e6;
    const auto place = [&](double at, double origin) {
        return static_cast<std::int64_t>(std::clamp((at - origin) / pitch_, -far, far) * one);
    };
    std::int64_t x = place(from.x, origin_.x), y = place(from.y, origin_.y);
    const std::int64_t dx = (place(to.x, origin_.x) - x) / steps, dy = (place(to.y, origin_.y) - y) / steps;
    bool inside = true;  // what it starts in is its own object's
    int count = 0;
    for (int i = 0; i <= steps && count < most; ++i, x += dx, y += dy) {
        const auto column = static_cast<std::uint64_t>(x >> 32), row = static_cast<std::uint64_t>(y >> 32);
        const bool inked = column < static_cast<std::uint64_t>(columns_) && row < static_cast<std::uint64_t>(rows_) &&
                           ((bits_[row * words_ + column / 64] >> (column % 64)) & 1U) != 0;
        count += inked && !inside;
        inside = inked;
    }
    return count;
}

}  // namespace kinegraph::render
