// Text: from words and symbols to positioned glyphs, in the four faces of one font. Independent of mechanics and pages.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "lang/words.hpp"
#include "render/ink/path.hpp"
#include "render/text/glyphs.hpp"
#include "render/text/rich_text.hpp"
#include "render/text/typeface.hpp"

namespace kinegraph::render {

/// One glyph of a face (an index into Fonts). Its origin lies on the baseline; size in mm (em).
struct Glyph {
    std::uint8_t face = 0;
    std::uint32_t index = 0;
    double size = 0;
    Spot origin;
    std::uint32_t at = 0;  ///< byte offset of its character in plain(as_set(text)) of the line's text; for a ligature,
                           ///< of the first one
    bool coded = false;    ///< part of the boxed code that replaces a character missing from the font
};

/// A shaped line. Origin at the left end of the baseline, mm, y downwards.
struct ShapedLine {
    double width = 0;    ///< advance
    double ascent = 0;   ///< ink above the baseline (positive upwards)
    double descent = 0;  ///< ink below the baseline (positive downwards)
    std::string words;   ///< the complete text, even if the line is shortened
    RichText text;       ///< the text as shaped
    /// One part per colour; glyph origins are relative to the line's origin.
    struct Part {
        std::vector<Glyph> glyphs;
        std::vector<Path> extras;
        bool coloured = false;
        Colour colour;
    };
    std::vector<Part> parts;
};

/// Height of the em box of a letter above and below its baseline, em. Approximate; for the edges of text blocks.
constexpr double letter_over = 0.72, letter_under = 0.22;

/// Text whose words are measured once, for line breaking at several widths. Valid as long as its Fonts, and until
/// Fonts::start_anew().
class MeasuredText {
public:
    /// A line: its range of pieces, and the height of its em boxes above and below the baseline, mm.
    struct Line {
        std::size_t first = 0, end = 0;
        double over = 0, under = 0;
    };
    /// Breaks lines as Fonts::wrap does.
    std::vector<Line> lines(double measure) const;

private:
    friend class Fonts;
    struct Parts;
    explicit MeasuredText(std::shared_ptr<const Parts> parts) : parts_(std::move(parts)) {}

    std::shared_ptr<const Parts> parts_;
};

/// The font's four faces, opened once. Shaping is deterministic. Results are cached without locks: use a Fonts from one
/// thread at a time; each thread opens its own.
class Fonts final : public Glyphs {
public:
    explicit Fonts(Typefaces faces);
    /// Uses the faces of open_typefaces().
    static tl::expected<Fonts, Words> open();
    Fonts(Fonts&&) noexcept;
    Fonts& operator=(Fonts&&) noexcept;
    ~Fonts() override;

    /// Shapes one line at `size_points`. A character missing from all faces is drawn as its boxed code (U+XXXX) and
    /// reported by missing().
    ShapedLine shape(RichText text, double size_points) const;
    /// The width that shape() returns, mm.
    double width(const RichText& text, double size_points) const;
    /// Breaks at spaces into lines no wider than `measure` mm. A word longer than that stands alone.
    std::vector<ShapedLine> wrap(const RichText& text, double size_points, double measure) const;
    /// The same in two steps, for text that is tried at several widths before it is set at one of them.
    MeasuredText measured(RichText text, double size_points) const;
    ShapedLine set(const MeasuredText& text, const MeasuredText::Line& line) const;
    const Outline& outline(std::uint8_t face, std::uint32_t index) const override;
    std::string_view file(std::uint8_t face) const override;
    /// Characters so far that the font lacks, in Unicode order ("U+4E2D").
    std::vector<std::string> missing() const;
    /// Prepares for the next of many sheets: clears the list of missing characters, and the cache of shaped words if it
    /// is large.
    void start_anew();

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// A line of text no wider than `measure` mm. If necessary, pieces are removed from the end, then characters of the
/// first piece, and an ellipsis is added. ShapedLine::words stays complete.
ShapedLine shaped_within(const RichText& text, double size, const Fonts& fonts, double measure);

/// Points to millimetres.
constexpr double millimetres(double points) { return points * 25.4 / 72.0; }

}  // namespace kinegraph::render
