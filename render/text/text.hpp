// Text: from words and symbols to glyph outlines, in the four faces of one font. Knows no mechanics and no page.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "engine/file/words.hpp"
#include "render/ink/path.hpp"
#include "render/text/glyphs.hpp"
#include "render/text/rich_text.hpp"
#include "render/text/typeface.hpp"

namespace kinegraph::render {

/// One glyph of a face (an index into Fonts), its origin on the baseline; size in mm (em).
struct Glyph {
    std::uint8_t face = 0;
    std::uint32_t index = 0;
    double size = 0;
    Spot origin;
    std::uint32_t at =
        0;  ///< where its character begins in plain(as_set(text)) of its line's text; a ligature: its first one
    bool coded = false;  ///< of the code in a box that stands for a character which the font has not
};

/// A shaped line, its origin at the left of the baseline, mm, y downwards.
struct ShapedLine {
    double width = 0;    ///< advance
    double ascent = 0;   ///< ink above the baseline (positive upwards)
    double descent = 0;  ///< ink below the baseline (positive downwards)
    std::string words;   ///< what the line says, whole
    RichText text;       ///< as it stands there
    /// One part for each colour used; glyph origins relative to the line's origin.
    struct Part {
        std::vector<Glyph> glyphs;
        std::vector<Path> extras;
        bool coloured = false;
        Colour colour;
    };
    std::vector<Part> parts;
};

/// How far the em box of a letter reaches over and under its baseline, em: near enough for the edge of what is set.
constexpr double letter_over = 0.72, letter_under = 0.22;

/// Text whose words are measured, to be broken into lines at one width after the other. Good as long as its fonts are,
/// and until they start anew.
class MeasuredText {
public:
    /// A line of it: its stretches, and how far the em boxes of its letters reach over and under the baseline, mm.
    struct Line {
        std::size_t first = 0, end = 0;
        double over = 0, under = 0;
    };
    /// As Fonts::wrap breaks it.
    std::vector<Line> lines(double measure) const;

private:
    friend class Fonts;
    struct Parts;
    explicit MeasuredText(std::shared_ptr<const Parts> parts) : parts_(std::move(parts)) {}

    std::shared_ptr<const Parts> parts_;
};

/// The font's four faces, opened once. Shaping is deterministic; what was shaped is kept, so only one thread at a time
/// may use a Fonts: threads open one each.
class Fonts final : public Glyphs {
public:
    explicit Fonts(Typefaces faces);
    /// With the faces that open_typefaces() opens.
    static tl::expected<Fonts, Words> open();
    Fonts(Fonts&&) noexcept;
    Fonts& operator=(Fonts&&) noexcept;
    ~Fonts() override;

    /// Sets one line at `size` points. A character that no face has is drawn as its code in a box (U+XXXX) and reported
    /// through `missing()`.
    ShapedLine shape(RichText text, double size_points) const;
    /// What shape() gives as its width.
    double width(const RichText& text, double size_points) const;
    /// Breaks at spaces so that no line is wider than `measure` mm (a word longer than that stands alone).
    std::vector<ShapedLine> wrap(const RichText& text, double size_points, double measure) const;
    /// The same in two steps, for text that is tried at several widths before it is set at one of them.
    MeasuredText measured(RichText text, double size_points) const;
    ShapedLine set(const MeasuredText& text, const MeasuredText::Line& line) const;
    const Outline& outline(std::uint8_t face, std::uint32_t index) const override;
    std::string_view file(std::uint8_t face) const override;
    /// Characters met so far that the font has not, in the order of Unicode ("U+4E2D").
    std::vector<std::string> missing() const;
    /// For a further sheet of many: forgets the missing characters, and the words set so far where they have become
    /// very many.
    void start_anew();

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// A line of text no wider than `measure` mm: pieces go from the end, then characters of the first, for an ellipsis.
/// What the line says stays whole.
ShapedLine shaped_within(const RichText& text, double size, const Fonts& fonts, double measure);

/// Points to millimetres.
constexpr double millimetres(double points) { return points * 25.4 / 72.0; }

}  // namespace kinegraph::render
