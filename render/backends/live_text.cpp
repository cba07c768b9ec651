#include "render/backends/live_text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/number/functions.hpp"
#include "render/text/utf8.hpp"

namespace kinegraph::render {
namespace {

bool is_blank(char32_t c) {
    return c <= 0x20 || (c >= 0x7F && c <= 0xA0) || (c >= 0x2000 && c <= 0x200A) || c == 0x2028 || c == 0x2029 ||
           c == 0x202F || c == 0x205F || c == 0x3000;
}

/// Characters without width: joiners, bidirectional marks, variation selectors.
bool is_without_width(char32_t c) {
    return c == 0xAD || c == 0x34F || c == 0x61C || c == 0xFEFF || (c >= 0x200B && c <= 0x200F) ||
           (c >= 0x202A && c <= 0x202E) || (c >= 0x2060 && c <= 0x206F) || (c >= 0xFE00 && c <= 0xFE0F) ||
           (c >= 0xE0000 && c <= 0xE0FFF);
}

/// Maps white space of a file to a printable space.
char32_t written_blank(char32_t c) {
    const bool control = c < 0x20 || (c >= 0x7F && c < 0xA0) || c == 0x2028 || c == 0x2029;
    return control ? U' ' : c;
}

struct Coloured {
    Glyph glyph;
    Colour colour;
};

/// Reads the text of a line and its glyphs in parallel.
class Reader {
public:
    Reader(std::string_view words, std::vector<Coloured> glyphs, std::vector<LiveRun>& runs)
        : words_(words), glyphs_(std::move(glyphs)), runs_(runs) {}

    void read(const RichText& text) {
        for (const Piece& piece : text) {
            read(piece.text.size());
            const std::size_t dots = piece.dots == 2 ? 2 : 2 * static_cast<std::size_t>(std::max(piece.dots, 0));
            say(dots, LiveRun::Kind::dots);
            for (const std::string* script : {&piece.sub, &piece.sup}) {
                if (script->empty()) continue;
                say(1, LiveRun::Kind::said);
                read(script->size());
            }
        }
        while (next_ < glyphs_.size()) take_letter({}, true);
    }

private:
    void say(std::size_t bytes, LiveRun::Kind kind) {
        is_open_ = false;
        if (bytes > 0) runs_.push_back({kind, std::string(words_.substr(at_, bytes)), {}, {}});
        at_ += bytes;
    }

    /// The next bytes, which glyphs may represent.
    void read(std::size_t bytes) {
        is_open_ = false;
        const std::size_t end = at_ + bytes;
        while (at_ < end) {
            const std::size_t begin = at_;
            // A script may end inside a malformed sequence, which must not continue into the bytes of the next piece.
            const char32_t c = next_code_point(words_.substr(0, end), at_);
            std::string text;
            append_utf8(text, c);
            text = well_formed(text);
            if (next_ < glyphs_.size() && glyphs_[next_].glyph.at == begin) {
                for (bool first = true; next_ < glyphs_.size() && glyphs_[next_].glyph.at == begin; first = false)
                    take_letter(first ? text : std::string(), false);
            } else if (is_blank(c)) {
                blank(written_blank(c));
            } else if (!is_without_width(c)) {
                if (is_open_ && runs_.back().kind == LiveRun::Kind::set) {
                    // The rest of a ligature, or an accent composed with its letter.
                    runs_.back().letters.back().text += text;
                    runs_.back().text += text;
                } else {
                    runs_.push_back({LiveRun::Kind::said, text, {}, {}});
                }
            }
        }
        is_open_ = false;
    }

    void blank(char32_t c) {
        is_open_ = false;
        if (runs_.empty() || runs_.back().kind != LiveRun::Kind::blank)
            runs_.push_back({LiveRun::Kind::blank, {}, {}, {}});
        append_utf8(runs_.back().text, c);
    }

    void take_letter(const std::string& text, bool lost) {
        const Glyph& glyph = glyphs_[next_].glyph;
        const Colour colour = glyphs_[next_++].colour;
        const LiveRun::Kind kind = glyph.coded || lost ? LiveRun::Kind::coded : LiveRun::Kind::set;
        const auto goes_on = [&](const LiveRun& run) {
            constexpr double joined = 1e-6;  // mm
            const Glyph& last = run.letters.back().glyph;
            return run.kind == kind && last.face == glyph.face && std::abs(last.size - glyph.size) < joined &&
                   std::abs(last.origin.y - glyph.origin.y) < joined && run.colour == colour;
        };
        const bool within = is_open_ && goes_on(runs_.back()) && (kind == LiveRun::Kind::set || text.empty());
        if (!within) runs_.push_back({kind, {}, {}, colour});
        is_open_ = true;
        runs_.back().letters.push_back({glyph, text});
        runs_.back().text += text;
    }

    std::string_view words_;
    std::vector<Coloured> glyphs_;
    std::vector<LiveRun>& runs_;
    std::size_t at_ = 0, next_ = 0;
    bool is_open_ = false;  // the last run consists of letters and can be extended
};

}  // namespace

RichText text_of(const TextMark& mark) { return as_set(mark.text.empty() ? one_piece(mark.words) : mark.text); }

LiveLine live_line(std::span<const Mark> marks) {
    LiveLine line;
    std::vector<Coloured> glyphs;
    for (const Mark& mark : marks) {
        const auto* text = std::get_if<TextMark>(&mark);
        if (text == nullptr || (line.first != nullptr && !(text->words.empty() && text->text.empty()))) break;
        if (line.first == nullptr) line.first = text;
        line.marks.push_back(text);
        for (const Glyph& glyph : text->glyphs) glyphs.push_back({glyph, text->colour});
    }
    if (line.first == nullptr) return line;
    std::stable_sort(glyphs.begin(), glyphs.end(),
                     [](const Coloured& a, const Coloured& b) { return a.glyph.at < b.glyph.at; });
    const RichText text = text_of(*line.first);
    const std::string words = plain(text);
    Reader(words, std::move(glyphs), line.runs).read(text);
    return line;
}

std::string reading_of(const LiveLine& line) {
    std::string text;
    for (const LiveRun& run : line.runs) text += run.text;
    return text;
}

double width_of(const Outline& outline) {
    constexpr double least_white = 0.03;
    double left = std::numeric_limits<double>::infinity(), right = -left;
    const auto take = [&](Spot spot) {
        left = std::min(left, spot.x);
        right = std::max(right, spot.x);
    };
    for (const Segment& segment : outline.segments) {
        if (const auto* m = std::get_if<MoveTo>(&segment)) take(m->to);
        if (const auto* l = std::get_if<LineTo>(&segment)) take(l->to);
        if (const auto* c = std::get_if<CurveTo>(&segment)) take(c->to);
    }
    return left > right ? 0 : right + std::max(left, least_white);
}

Spot turned(const TextMark& mark, Spot spot) {
    const double c = nearest::cos(mark.angle), s = nearest::sin(mark.angle);
    const Spot from = spot - mark.pivot;
    return mark.pivot + Spot{from.x * c - from.y * s, from.x * s + from.y * c};
}

Path filled_glyph(const TextMark& mark, const Glyph& glyph, const Outline& outline, Colour colour) {
    const auto at = [&](Spot em) { return turned(mark, glyph.origin + glyph.size * Spot{em.x, -em.y}); };
    Path path;
    path.filled = true;
    path.fill = colour;
    for (const Segment& segment : outline.segments) {
        if (const auto* m = std::get_if<MoveTo>(&segment)) path.segments.emplace_back(MoveTo{at(m->to)});
        if (const auto* l = std::get_if<LineTo>(&segment)) path.segments.emplace_back(LineTo{at(l->to)});
        if (const auto* c = std::get_if<CurveTo>(&segment))
            path.segments.emplace_back(CurveTo{at(c->control_1), at(c->control_2), at(c->to)});
        if (std::holds_alternative<Close>(segment)) path.segments.emplace_back(Close{});
    }
    return path;
}

}  // namespace kinegraph::render
