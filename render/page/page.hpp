// A Page: one sheet with nothing left to decide. Flat, in drawing order, every length in millimetres,
// the origin at the top left, y downwards, as the backends want it. It knows nothing of mechanics.
//
// What a Page promises:
//  - coordinates are snapped to 1e-8 mm, so that the same page is the same bytes everywhere;
//  - text is shaped: a backend fills outlines and never looks for a font;
//  - groups nest properly, ids are unique within the page, and attribute values are still unescaped text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace kinegraph::render {

/// A place on the sheet, mm.
struct Spot {
    double x = 0;
    double y = 0;
    bool operator==(const Spot&) const = default;
};

/// An sRGB colour.
struct Colour {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
    friend bool operator==(const Colour&, const Colour&) = default;
};

/// How a path is stroked; width and dashes in mm, an empty dash list is a full line.
struct Pen {
    double width = 0.18;
    Colour colour;
    std::vector<double> dashes;
    bool round_ends = false;
    friend bool operator==(const Pen&, const Pen&) = default;
};

/// Segments of a path. An arc runs from `from` to `to` (radians, y downwards, so positive angles turn clockwise on paper).
struct MoveTo {
    Spot to;
};
struct LineTo {
    Spot to;
};
struct CurveTo {
    Spot control_1, control_2, to;
};
struct ArcTo {
    Spot centre;
    double radius = 0;
    double from = 0;
    double to = 0;
};
struct Close {};
using Segment = std::variant<MoveTo, LineTo, CurveTo, ArcTo, Close>;

/// A path, filled, stroked or both.
struct Path {
    std::vector<Segment> segments;
    bool filled = false;
    Colour fill;
    bool stroked = false;
    Pen pen;
    int statement = -1;   ///< of the solution, that it is drawn by; −1: it is there from the beginning
    bool tinted = false;  ///< the fill is a body's tint or the paper: no ink, letters may stand on it
};

/// Round ends go with round corners; and a dash that runs round a sharp corner must leave no spike there.
inline bool has_round_corners(const Path& path) {
    return path.pen.round_ends || (!path.pen.dashes.empty() && path.segments.size() > 3);
}

/// The invisible axis of a vector from tail to tip (`<line class="axis" stroke="none">`): the drawing is measured there.
struct Axis {
    Spot tail, tip;
};

/// One glyph of a face (an index into Fonts), its origin on the baseline; size in mm (em).
struct Glyph {
    std::uint8_t face = 0;
    std::uint32_t index = 0;
    double size = 0;
    Spot origin;
};

/// Shaped text in one colour, turned about nothing: glyphs stand where they say. `angle` turns them all (radians, clockwise on
/// paper) about `pivot`.
struct TextMark {
    std::vector<Glyph> glyphs;
    Colour colour;
    std::string words;  ///< what the text says, for `aria-label`
    std::string cls;    ///< "label" for labels of a drawing; "text" for prose and tables
    double angle = 0;
    Spot pivot;
    std::vector<Path> extras;          ///< dots over letters, fraction bars
    int statement = -1;                ///< as a Path's
    std::vector<std::string> names{};  ///< of the quantities that a label names, as `data-name` has them
};

/// Opens a group (`<g>`): class, id (already legal), title and data attributes in order.
struct GroupBegin {
    std::string cls;
    std::string id;
    std::string title;
    std::vector<std::pair<std::string, std::string>> attributes;
    int statement = -1;  ///< as a Path's; of all that is in the group and has none of its own

    /// The value of the attribute of that name, if there is one.
    const std::string* attribute(std::string_view name) const {
        for (const auto& [own, value] : attributes)
            if (own == name) return &value;
        return nullptr;
    }
};
struct GroupEnd {};

using Mark = std::variant<Path, Axis, TextMark, GroupBegin, GroupEnd>;

/// One sheet of paper.
struct Page {
    double width = 297;
    double height = 210;
    Colour paper{255, 255, 255};
    std::string title;
    std::string language = "en";
    std::vector<Mark> marks;
};

}  // namespace kinegraph::render
