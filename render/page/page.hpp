// Page: one sheet, completely laid out. Flat, in drawing order, lengths in millimetres, origin at the top left, y
// downwards, as the backends expect. Independent of mechanics.
//
// Invariants:
//  - coordinates are snapped to 1e-8 mm, so that the same page gives the same bytes everywhere;
//  - text is shaped: a backend fills outlines and never searches for a font;
//  - groups nest properly, ids are unique within the page, and attribute values are unescaped text.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "render/ink/path.hpp"
#include "render/text/text.hpp"

namespace kinegraph::render {

/// The invisible axis of a vector from tail to tip (`<line class="axis" stroke="none">`). Programs measure the drawing
/// by it.
struct Axis {
    Spot tail, tip;
};

/// Shaped text in one colour, with absolute glyph positions. A line in several colours is several marks; the first one
/// carries the words and the rich text of all. `angle` (radians, clockwise on paper) rotates the mark about `pivot`.
struct TextMark {
    std::vector<Glyph> glyphs;
    Colour colour;
    std::string words;  ///< the text for `aria-label`
    RichText text;      ///< with faces and scripts, for backends that typeset it themselves or provide readable text
    std::string cls;    ///< "label" for labels of a drawing; "text" for prose and tables
    double angle = 0;
    Spot pivot;
    std::vector<Path> extras;          ///< dots over letters, fraction bars
    StatementIndex statement = none;   ///< see Path::statement
    std::vector<std::string> names{};  ///< the quantities that a label names, as in `data-name`
    std::string in_file{};  ///< the name in the file of the one point or joint that a label names; empty: it names else
    Holds holds{};          ///< see Path::holds
    std::size_t detail = 0;  ///< the number of the detail whose letter it has; 0: none
};

/// Which group it is: an element of a figure, or of one of its details; without an element the figure or the detail
/// itself. Backends write it as text.
struct GroupId {
    std::string figure{};    ///< empty: the element has one name for all figures
    std::string detail{};    ///< the letter of the detail of that figure
    std::string element{};   ///< already legal
    std::string shown_in{};  ///< the figure of the page that shows it, where two of them show it

    GroupId() = default;
    explicit GroupId(std::string of_figure, std::string of_element = {}, std::string in_detail = {})
        : figure(std::move(of_figure)), detail(std::move(in_detail)), element(std::move(of_element)) {}

    bool empty() const { return figure.empty() && element.empty(); }
    /// "velocity-detail-I-v_A"
    std::string text() const {
        std::string all = shown_in;
        const auto add = [&](const std::string& part) {
            if (!part.empty()) all += (all.empty() ? "" : "-") + part;
        };
        add(figure);
        if (!detail.empty()) add("detail-" + detail);
        add(element);
        return all;
    }
    friend bool operator==(const GroupId&, const GroupId&) = default;
    friend bool operator<(const GroupId& one, const GroupId& other) {
        return std::tie(one.figure, one.detail, one.element, one.shown_in) <
               std::tie(other.figure, other.detail, other.element, other.shown_in);
    }
};

/// Opens a group (`<g>`): class, id, title and data attributes in order.
struct GroupBegin {
    std::string cls;
    GroupId id;
    std::string title;
    std::vector<std::pair<std::string, std::string>> attributes;
    StatementIndex statement = none;  ///< see Path::statement; for everything in the group that has none of its own
    Holds holds{};                    ///< see Path::holds; for everything in the group
    std::size_t detail = 0;           ///< the number of the detail that its title names; 0: none
    std::string cited_as{};           ///< the name that sentences give a centre; others have it as `data-name`

    /// The value of an attribute; null if absent.
    const std::string* attribute(std::string_view name) const {
        for (const auto& [own, value] : attributes)
            if (own == name) return &value;
        return nullptr;
    }
};
struct GroupEnd {};

using Mark = std::variant<Path, Axis, TextMark, GroupBegin, GroupEnd>;

/// What a page of a sequence of steps says, for output that sets it by itself: LaTeX, the captions of a film. On a
/// slide the marks of sentences stand in groups of class "sentence".
struct StepText {
    std::string figure;  ///< pages with the same one show the same figures, in the same places
    std::string heading;
    std::vector<RichText> sentences;
    Spot corner;         ///< where the sentences begin, mm
    double width = 0;    ///< of the sentences, mm
    double size = 9;     ///< of their type, points
    bool grows = false;  ///< a picture of a film before the page itself: its new lines are drawn in part
};

/// One sheet of paper.
struct Page {
    double width = 297;
    double height = 210;
    Colour paper{255, 255, 255};
    std::string title;
    std::string language = "en";
    std::vector<Mark> marks;
    bool tells_holds = false;        ///< its SVG contains bindings (`data-on`)
    std::optional<StepText> step{};  ///< none: it is no page of a sequence
};

}  // namespace kinegraph::render
