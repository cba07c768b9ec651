// Formulas as values: letters with dots and scripts, fractions, roots, powers, matrices in brackets. A formula prints
// as plain text and as LaTeX; render/page/set_formula.hpp typesets it. Independent of quantities.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "render/text/rich_text.hpp"

namespace kinegraph::render {

/// The letter with that Latin name: "alpha" gives α. Other names are returned unchanged.
std::string unicode_letter(std::string_view name);
/// The Latin name of a letter: "α" gives "alpha". Others are returned unchanged.
std::string letter_spelt(std::string_view unicode);

class Formula {
public:
    enum class Kind {
        row,       ///< its parts, side by side
        text,      ///< upright or italic text
        sign,      ///< +, −, =: a line may break before it
        fraction,  ///< parts[0] over parts[1]
        root,      ///< square root of parts[0]
        power,     ///< parts[0] with parts[1] raised
        matrix,    ///< `columns` wide, in square brackets
        fence      ///< parts[0] in round brackets
    };

    Formula() = default;
    /// A letter by its name, in italics, with dots and a subscript: "beta".
    static Formula letter(std::string_view name, const std::string& sub = "", int dots = 0);
    /// The same with primes before the subscript.
    static Formula primed(std::string_view name, const std::string& sub, int primes);
    /// Upright text: numbers with their units, names of functions, words.
    static Formula upright(const std::string& text);
    /// The name of a function, such as "cos", set close to what follows.
    static Formula function(const std::string& name);
    static Formula sign(const std::string& text);
    static Formula fraction(Formula above, Formula below);
    static Formula root(Formula of);
    static Formula power(Formula base, Formula exponent);
    static Formula fenced(Formula inside);
    /// A matrix from its entries row by row, `columns` per row. `between` separates the entries of a row in plain text.
    /// With "; " (as in Italian, where the comma is the decimal mark) every row gets brackets of its own.
    static Formula matrix(std::vector<Formula> entries, std::size_t columns, const char* between = ", ");

    Formula& operator+=(Formula more);
    friend Formula operator+(Formula a, Formula b) { return a += std::move(b); }

    bool empty() const { return kind == Kind::row && parts.empty(); }
    /// "b cos(β)", "[1, 2; 3, 4]", "a/b".
    std::string plain() const;
    std::string latex() const;

    /// Whether it includes its own space from what precedes: " m/s", ", ".
    bool stands_close() const;
    /// Whether it is an upright d or ∂, or a power of one, which what follows is set close to.
    bool is_differential() const;

    Kind kind = Kind::row;
    RichText text;         ///< for the kinds text and sign
    std::string as_latex;  ///< the same in LaTeX
    std::string as_plain;  ///< the same in plain text; for a matrix the separator of entries
    std::vector<Formula> parts;
    std::size_t columns = 1;
};

}  // namespace kinegraph::render
