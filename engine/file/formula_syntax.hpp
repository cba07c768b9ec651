// The syntax of formulas, of expressions of laws and of expressions of results: one parser for one grammar. It makes a
// tree; what names, functions and units mean is left to the reader of the tree.
//
//   sum      = product { ("+" | "-") product }
//   product  = factor { ("*" | "/") factor }
//   factor   = ("+" | "-") factor | power
//   power    = operand [ "^" factor ]
//   operand  = number [ unit ] | name | function "(" sum { "," sum } ")" | "(" sum ")" | "'" name "'" | "|" sum "|"
//
// The last two are read only where the grammar allows them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "engine/file/units.hpp"
#include "lang/words.hpp"

namespace kinegraph {

/// A node of the tree. Its texts are parts of the text that was read, which must outlive it.
struct Syntax {
    enum class Kind : std::uint8_t {
        number,    ///< `text`, perhaps with a `unit`
        name,      ///< `text`, without quotes
        function,  ///< `text`, of its parts; |a| is abs(a)
        sum,       ///< of two parts or more
        product,   ///< of two parts or more
        power,     ///< parts[0] to parts[1]
        negative,  ///< −parts[0]
        fault      ///< the reading ended here, behind `parts`; `text` is the rest
    };
    enum class Fault : std::uint8_t {
        no_fault,
        ends,             ///< where an operand is wanted
        foreign_minus,    ///< "−"
        foreign_times,    ///< "·" or "×"
        unexpected,       ///< something else
        behind_number,    ///< a name behind parts[0], a number without a unit
        behind_value,     ///< a value behind another
        bracket_open,     ///< not closed
        bar_open,         ///< not closed
        quote_open,       ///< not closed
        nested_brackets,  ///< too many within each other
        nested_powers,    ///< too many upon each other
        too_long          ///< the whole text, of which nothing was read
    };
    Kind kind = Kind::fault;
    Fault fault = Fault::no_fault;
    bool is_inverse = false;     ///< part of a sum: it is subtracted; of a product: it divides
    std::size_t at = 0;          ///< where it begins, in bytes
    std::string_view text = {};  ///< of a sum, product, power or negative: all of it
    std::string_view unit_text = {};
    const KnownUnit* unit = nullptr;
    std::vector<Syntax> parts = {};
};

/// What a text is: how messages call it and how long it may be.
enum class SyntaxOf : std::uint8_t { formula, expression };

/// Length of the word at the beginning: a letter, then letters, digits and underscores; 0: none. Greek and accented
/// letters are letters, signs of units (`°`, `²`, `·`) are none.
std::size_t word_length(std::string_view text);

/// What texts differ in.
struct Grammar {
    SyntaxOf text = SyntaxOf::expression;
    /// Length of the name at the beginning, which may be that of a function; 0: none.
    std::function<std::size_t(std::string_view rest)> name_length = word_length;
    /// Whether the spelling of a unit is a unit behind a number; not given: always.
    std::function<bool(std::string_view spelt)> is_unit = {};
    bool has_quoted_names = false, has_bars = false;
};

/// The tree of a text. Faults are nodes of it: a reader that evaluates parts from left to right meets the text's first
/// fault, be it one of syntax or of values. The limits: 100 brackets and powers within each other; 1000 characters in
/// an expression, 100,000 in a formula.
Syntax read_syntax(std::string_view text, const Grammar& grammar);
/// The first fault of syntax; none: nullptr.
const Syntax* first_fault(const Syntax& of);
/// The message of a fault of syntax.
Words words_of(const Syntax& fault, SyntaxOf text);

/// Length of the longest unit at the beginning; 0: none. It ends where a word ends, and is no beginning of a longer
/// name. A product sign belongs to the text: "N*m" begins with the unit N.
std::size_t unit_length(std::string_view text, const Grammar& grammar);

}  // namespace kinegraph
