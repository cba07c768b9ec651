// Filling of the ink map and its queries: a convex shape is one run of bits per row; paths are chords.
#include "render/page/ink_map.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "engine/number/functions.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render {

namespace {

constexpr double most_bits = 3000;  // per side

/// The next whole number of a number that is not negative: std::ceil is a call on processors of 2003, for which the
/// program is built.
inline std::size_t whole_above(double number) {
    const auto below = static_cast<std::size_t>(number);
    return below + (static_cast<double>(below) < number ? 1 : 0);
}
inline std::size_t whole_below(double number) { return static_cast<std::size_t>(number); }

/// The number of bits of a word that are set: std::popcount is a call on such processors.
inline int bits_in(std::uint64_t word) {
    if (word == 0) return 0;  // most are
    constexpr std::uint64_t ones = 0x5555555555555555, pairs = 0x3333333333333333, fours = 0x0f0f0f0f0f0f0f0f;
    word -= (word >> 1) & ones;
    word = (word & pairs) + ((word >> 2) & pairs);
    word = (word + (word >> 4)) & fours;
    return static_cast<int>((word * 0x0101010101010101) >> 56);
}

/// The run of a box in each row of a map, for the rows whose centre line meets the box.
class Runs {
public:
    Runs(const InkBox& box, double top, double pitch, int rows) : centre_(box.centre), top_(top), pitch_(pitch) {
        const double reach = box.reach().y;
        const double low = (box.centre.y - reach - top) / pitch - 0.5,
                     high = (box.centre.y + reach - top) / pitch - 0.5;
        if (!(high >= 0 && low <= rows - 1)) return;
        first = static_cast<int>(std::ceil(std::max(0.0, low)));
        last = static_cast<int>(std::floor(std::min(rows - 1.0, high)));
        // The box is the intersection of two strips; a strip cuts runs of equal length from all rows.
        constexpr double endless = 1e300, least = 1e-9;
        const double cosine = std::abs(box.axis.x) < least ? 0 : box.axis.x,
                     sine = std::abs(box.axis.y) < least ? 0 : box.axis.y;
        along_ = cosine != 0 ? box.half.x / std::abs(cosine) : endless;
        across_ = sine != 0 ? box.half.y / std::abs(sine) : endless;
        lean_along_ = cosine != 0 ? -sine / cosine : 0;
        lean_across_ = sine != 0 ? cosine / sine : 0;
    }

    struct Run {
        double from, to;  // empty if from > to
    };
    Run of(int row) const {
        const double y = below_centre(row);
        return at(std::max(lean_along_ * y - along_, lean_across_ * y - across_),
                  std::min(lean_along_ * y + along_, lean_across_ * y + across_));
    }
    /// Whether all rows have the same run.
    bool is_upright() const { return lean_along_ == 0 && lean_across_ == 0; }

    int first = 0, last = -1;  ///< rows

private:
    double below_centre(int row) const { return top_ + (row + 0.5) * pitch_ - centre_.y; }
    Run at(double from, double to) const { return from <= to ? Run{centre_.x + from, centre_.x + to} : Run{1, 0}; }

    Spot centre_;
    double top_, pitch_;
    double along_ = 0, across_ = 0, lean_along_ = 0, lean_across_ = 0;
};

constexpr double largest_dot = 3;  // radius, mm

/// Walks along a path in straight pieces: begin(at) where the pen is set down, stroke(from, to) for each piece.
template <class Begin, class Stroke>
void go_along(const Path& path, Begin begin, Stroke stroke) {
    Spot pen, start;
    bool down = false;
    const auto stroke_to = [&](Spot to) {
        stroke(pen, to);
        pen = to;
    };
    const auto set_down = [&](Spot at) {
        pen = start = at;
        down = true;
        begin(at);
    };
    for (const Segment& segment : path.segments) {
        if (const auto* m = std::get_if<MoveTo>(&segment)) {
            set_down(m->to);
        } else if (const auto* l = std::get_if<LineTo>(&segment)) {
            stroke_to(l->to);
        } else if (const auto* c = std::get_if<CurveTo>(&segment)) {
            const Spot p0 = pen;
            for (int i = 1; i <= 8; ++i) {
                const double t = i / 8.0, u = 1 - t;
                stroke_to((u * u * u) * p0 + (3 * u * u * t) * c->control_1 + (3 * u * t * t) * c->control_2 +
                          (t * t * t) * c->to);
            }
        } else if (const auto* a = std::get_if<ArcTo>(&segment)) {
            const double sweep = a->to - a->from;
            const double step =
                std::clamp(2 * nearest::acos(std::max(0.0, 1 - 0.05 / std::max(a->radius, 0.06))), 0.05, 0.8);
            const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / step)));
            for (int i = 0; i <= parts; ++i) {
                const double angle = a->from + sweep * i / parts;
                const Spot at = a->centre + a->radius * Spot{nearest::cos(angle), nearest::sin(angle)};
                if (i == 0 && !down) set_down(at);
                stroke_to(at);
            }
        } else {
            stroke_to(start);
        }
    }
}

}  // namespace

std::optional<InkBox> ink_of(const TextMark& text, const Fonts& fonts) {
    Box box{{1e300, 1e300}, {-1e300, -1e300}};
    for (const Glyph& glyph : text.glyphs) {
        const auto add = [&](Spot spot) {
            const Spot at = glyph.origin + glyph.size * Spot{spot.x, -spot.y};
            box = {{std::min(box.min.x, at.x), std::min(box.min.y, at.y)},
                   {std::max(box.max.x, at.x), std::max(box.max.y, at.y)}};
        };
        for (const Segment& segment : fonts.outline(glyph.face, glyph.index).segments) {
            if (const auto* m = std::get_if<MoveTo>(&segment)) add(m->to);
            if (const auto* l = std::get_if<LineTo>(&segment)) add(l->to);
            if (const auto* c = std::get_if<CurveTo>(&segment)) add(c->control_1), add(c->control_2), add(c->to);
        }
    }
    if (box.min.x > box.max.x) return std::nullopt;
    const Spot axis{nearest::cos(text.angle), nearest::sin(text.angle)}, arm = 0.5 * (box.min + box.max) - text.pivot;
    return InkBox{text.pivot + arm.x * axis + arm.y * turned(axis), 0.5 * (box.max - box.min), axis};
}

std::vector<Spot> outline_of(const Path& path) {
    std::vector<Spot> outline;
    go_along(
        path, [&](Spot at) { outline.push_back(at); }, [&](Spot /*from*/, Spot to) { outline.push_back(to); });
    return outline;
}

bool is_dot(const Path& path) {
    if (!path.filled || path.segments.size() != 3) return false;
    const auto* arc = std::get_if<ArcTo>(&path.segments[1]);
    return arc != nullptr && arc->radius <= largest_dot;
}

Spot InkBox::local(Spot spot) const {
    const Spot d = spot - centre;
    return {dot(d, axis), cross(axis, d)};
}
Spot InkBox::reach() const {
    return {std::abs(axis.x) * half.x + std::abs(axis.y) * half.y,
            std::abs(axis.y) * half.x + std::abs(axis.x) * half.y};
}

InkMap::InkMap(const Box& area) : origin_(area.min) {
    pitch_ = std::max(pitch, std::max(area.width(), area.height()) / most_bits);
    columns_ = std::max(1, static_cast<int>(std::ceil(area.width() / pitch_)) + 1);
    rows_ = std::max(1, static_cast<int>(std::ceil(area.height() / pitch_)) + 1);
    words_ = (static_cast<std::size_t>(columns_) + 63) / 64;
    bits_.assign(words_ * static_cast<std::size_t>(rows_), 0);
    any_.assign(words_ * (static_cast<std::size_t>(rows_) / rows_at_once + 1), 0);
}

template <class Look>
bool InkMap::words_of(std::size_t base, double from, double to, Look look) const {
    const double first_bit = (from - origin_.x) / pitch_ - 0.5, last_bit = (to - origin_.x) / pitch_ - 0.5;
    if (!(last_bit >= 0 && first_bit <= columns_ - 1)) return true;
    const auto first = whole_above(std::max(0.0, first_bit));
    const auto last = whole_below(std::min(columns_ - 1.0, last_bit));
    for (std::size_t word = first / 64; word <= last / 64 && first <= last; ++word) {
        std::uint64_t mask = ~std::uint64_t{0};
        if (word == first / 64) mask &= ~std::uint64_t{0} << (first % 64);
        if (word == last / 64) mask &= ~std::uint64_t{0} >> (63 - last % 64);
        if (!look(base + word, mask)) return false;
    }
    return true;
}

void InkMap::ink_row(int row, double from, double to) {
    words_of(0, from, to, [&](std::size_t word, std::uint64_t mask) {
        set(static_cast<std::size_t>(row), word, mask);
        return true;
    });
}

void InkMap::stroke(Spot from, Spot to, double half) {
    // Half a bit more, so that the thinnest line leaves no gap. Round ends only where they are visible.
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

void InkMap::ink(const Path& path) {
    const double half = path.stroked ? path.pen.width / 2 : 0;
    if (is_dot(path)) {
        const auto& arc = std::get<ArcTo>(path.segments[1]);
        stroke(arc.centre, arc.centre, arc.radius + half);
        return;
    }
    go_along(
        path, [](Spot /*at*/) {}, [&](Spot from, Spot to) { stroke(from, to, half); });
    if (path.filled && !path.tinted) fill(outline_of(path));
}

void InkMap::fill(const InkBox& box) {
    const Runs runs(box, origin_.y, pitch_, rows_);
    if (!runs.is_upright()) {
        for (int row = runs.first; row <= runs.last; ++row)
            if (const auto [from, to] = runs.of(row); from <= to) ink_row(row, from, to);
        return;
    }
    if (runs.first > runs.last) return;
    const auto [from, to] = runs.of(runs.first);
    words_of(0, from, to, [&](std::size_t word, std::uint64_t mask) {
        for (auto row = static_cast<std::size_t>(runs.first); row <= static_cast<std::size_t>(runs.last); ++row)
            set(row, word, mask);
        return true;
    });
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

void InkMap::clear(const Box& box) {
    const int first = static_cast<int>(std::clamp((box.min.y - origin_.y) / pitch_ - 1, 0.0, rows_ - 1.0));
    const int last = static_cast<int>(std::clamp((box.max.y - origin_.y) / pitch_, 0.0, rows_ - 1.0));
    for (int row = first; row <= last; ++row)
        words_of(static_cast<std::size_t>(row) * words_, box.min.x - pitch_, box.max.x + pitch_,
                 [&](std::size_t word, std::uint64_t mask) {
                     bits_[word] &= ~mask;
                     return true;
                 });
}

inline std::uint64_t InkMap::Bits::mask(std::size_t word) const {
    std::uint64_t mask = ~std::uint64_t{0};
    if (word == left / 64) mask &= ~std::uint64_t{0} << (left % 64);
    if (word == right / 64) mask &= ~std::uint64_t{0} >> (63 - right % 64);
    return mask;
}

inline std::optional<InkMap::Bits> InkMap::bits_of(const InkBox& upright) const {
    const double first = (upright.centre.y - upright.half.y - origin_.y) / pitch_ - 0.5;
    const double last = (upright.centre.y + upright.half.y - origin_.y) / pitch_ - 0.5;
    const double left = (upright.centre.x - upright.half.x - origin_.x) / pitch_ - 0.5;
    const double right = (upright.centre.x + upright.half.x - origin_.x) / pitch_ - 0.5;
    if (!(last >= 0 && first <= rows_ - 1 && right >= 0 && left <= columns_ - 1)) return std::nullopt;
    const Bits bits{whole_above(std::max(0.0, left)), whole_below(std::min(columns_ - 1.0, right)),
                    whole_above(std::max(0.0, first)), whole_below(std::min(rows_ - 1.0, last))};
    if (bits.left > bits.right || bits.top > bits.bottom) return std::nullopt;
    return bits;
}

template <class Look>
void InkMap::rows_of(const InkBox& box, Look look) const {
    if (box.axis.y != 0) return rows_of_turned(Runs(box, origin_.y, pitch_, rows_), look);
    const auto bits = bits_of(box);
    if (!bits) return;
    // Axis-aligned: the same words in every row. Column by column of words: most boxes have one or two.
    for (std::size_t word = bits->left / 64; word <= bits->right / 64; ++word) {
        const std::uint64_t mask = bits->mask(word);
        for (std::size_t row = bits->top; row <= bits->bottom;) {
            const std::size_t next = (row / rows_at_once + 1) * rows_at_once;
            if ((any_[row / rows_at_once * words_ + word] & mask) != 0)
                for (const std::size_t end = std::min(next, bits->bottom + 1); row < end; ++row)
                    if (!look(bits_[row * words_ + word] & mask)) return;
            row = next;
        }
    }
}

template <class Turned, class Look>
void InkMap::rows_of_turned(const Turned& runs, Look look) const {
    for (int row = runs.first; row <= runs.last; ++row)
        if (const auto [from, to] = runs.of(row);
            from <= to && !words_of(static_cast<std::size_t>(row) * words_, from, to,
                                    [&](std::size_t word, std::uint64_t mask) { return look(bits_[word] & mask); }))
            return;
}

double InkMap::inked(const InkBox& box, double most) const {
    const double bit = pitch_ * pitch_;
    const int enough = static_cast<int>(std::min(most / bit, 1e9)) + 1;
    int bits = 0;
    rows_of(box, [&](std::uint64_t word) {
        bits += bits_in(word);
        return bits < enough;
    });
    return bits * bit;
}

bool InkMap::touches(const InkBox& box) const {
    bool met = false;
    rows_of(box, [&](std::uint64_t word) { return !(met = word != 0); });
    return met;
}

std::optional<double> InkMap::way_right(const InkBox& box) const {
    const auto bits = bits_of(box);
    if (!bits) return std::nullopt;
    for (std::size_t word = bits->right / 64 + 1; word-- > bits->left / 64;) {
        const std::uint64_t mask = bits->mask(word);
        std::uint64_t met = 0;
        for (std::size_t row = bits->top; row <= bits->bottom;) {
            const std::size_t end = std::min((row / rows_at_once + 1) * rows_at_once, bits->bottom + 1);
            if ((any_[row / rows_at_once * words_ + word] & mask & ~met) != 0)
                for (; row < end; ++row) met |= bits_[row * words_ + word] & mask;
            row = end;
        }
        if (met != 0) {
            const std::size_t column = 64 * word + static_cast<std::size_t>(63 - std::countl_zero(met));
            return origin_.x + (static_cast<double>(column) + 0.5) * pitch_ - (box.centre.x - box.half.x);
        }
    }
    return std::nullopt;
}

std::optional<double> InkMap::way_down(const InkBox& box) const {
    const auto bits = bits_of(box);
    if (!bits) return std::nullopt;
    std::optional<std::size_t> lowest;
    for (std::size_t word = bits->left / 64; word <= bits->right / 64; ++word) {
        const std::uint64_t mask = bits->mask(word);
        const std::size_t top = lowest ? *lowest + 1 : bits->top;
        for (std::size_t row = bits->bottom + 1; row > top;) {
            const std::size_t end = std::max((row - 1) / rows_at_once * rows_at_once, top);
            if ((any_[(row - 1) / rows_at_once * words_ + word] & mask) == 0) {
                row = end;
                continue;
            }
            while (row > end && (bits_[(row - 1) * words_ + word] & mask) == 0) --row;
            if (row == end) continue;
            lowest = row - 1;
            break;
        }
    }
    if (!lowest) return std::nullopt;
    return origin_.y + (static_cast<double>(*lowest) + 0.5) * pitch_ - (box.centre.y - box.half.y);
}

int InkMap::crossings(Spot from, Spot to, int most) const {
    const int steps = std::max(1, static_cast<int>(std::ceil(length(to - from) / pitch_)));
    // Fixed point, in units of 2⁻³² bits: integer sums are the same on every machine.
    constexpr double one = 4294967296.0, far = 1e6;
    const auto place = [&](double at, double origin) {
        return static_cast<std::int64_t>(std::clamp((at - origin) / pitch_, -far, far) * one);
    };
    std::int64_t x = place(from.x, origin_.x), y = place(from.y, origin_.y);
    const std::int64_t dx = (place(to.x, origin_.x) - x) / steps, dy = (place(to.y, origin_.y) - y) / steps;
    const auto inked = [&] {
        const auto column = static_cast<std::uint64_t>(x >> 32), row = static_cast<std::uint64_t>(y >> 32);
        return column < static_cast<std::uint64_t>(columns_) && row < static_cast<std::uint64_t>(rows_) &&
               ((bits_[static_cast<std::size_t>(row * words_ + column / 64)] >> (column % 64)) & 1U) != 0;
    };
    // The ink at the start belongs to the leader's own object, but it must end soon.
    constexpr double soon = 3;  // mm
    int i = 0;
    for (; i <= steps && i * pitch_ < soon && inked(); ++i, x += dx, y += dy) {
    }
    int count = 0;
    int run = 0;                   // length of the current ink run, in steps
    constexpr double broad = 0.8;  // mm; crossing a broad link counts more than crossing a thin line
    const int broad_run = std::max(1, static_cast<int>(broad / pitch_));
    for (; i <= steps && count < most; ++i, x += dx, y += dy) {
        if (!inked()) {
            run = 0;
            continue;
        }
        ++run;
        if (run == 1 || run % broad_run == 0) ++count;
    }
    return count;
}

}  // namespace kinegraph::render
