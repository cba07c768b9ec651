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

#include "render/ink/path.hpp"
#include "render/text/text.hpp"

namespace kinegraph::render {

/// The invisible axis of a vector from tail to tip (`<line class="axis" stroke="none">`): the drawing is measured
/// there.
struct Axis {
    Spot tail, tip;
};

/// Shaped text in one colour, turned about nothing: glyphs stand where they say. A line in several colours is several
/// marks, the first of which has the words and the rich text of all. `angle` turns them all (radians, clockwise on
/// paper) about `pivot`.
struct TextMark {
    std::vector<Glyph> glyphs;
    Colour colour;
    std::string words;  ///< what the text says, for `aria-label`
    RichText text;      ///< with its faces and scripts, for a backend that sets type itself or speaks
    std::string cls;    ///< "label" for labels of a drawing; "text" for prose and tables
    double angle = 0;
    Spot pivot;
    std::vector<Path> extras;          ///< dots over letters, fraction bars
    StatementIndex statement = none;   ///< as a Path's
    std::vector<std::string> names{};  ///< of the quantities that a label names, as `data-name` has them
    Holds holds{};                     ///< as a Path's
};

/// Opens a group (`<g>`): class, id (already legal), title and data attributes in order.
struct GroupBegin {
    std::string cls;
    std::string id;
    std::string title;
    std::vector<std::pair<std::string, std::string>> attributes;
    StatementIndex statement = none;  ///< as a Path's; of all that is in the group and has none of its own
    Holds holds{};                    ///< as a Path's, of all that is in the group

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
    bool tells_holds = false;  ///< an SVG of it says what its marks go with (`data-on`)
};

}  // namespace kinegraph::render
