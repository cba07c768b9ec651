// Formulas as values: letters with dots and scripts, fractions, roots, powers, matrices in brackets. A formula prints
// itself as plain text and as LaTeX; setting it in type is page's (render/page/set_formula.hpp). Knows no quantity.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "render/text/rich_text.hpp"

namespace kinegraph::render {

/// A letter by its name in Latin script: "alpha" is α. Unknown names are themselves.
std::string unicode_letter(std::string_view name);
/// The name of "α"; others are themselves.
std::string letter_spelt(std::string_view unicode);

class Formula {
public:
    enum class Kind {
        row,       ///< its parts, side by side
        text,      ///< as it stands
        sign,      ///< +, −, =: a line may break before it
        fraction,  ///< parts[0] over parts[1]
        root,      ///< square root of parts[0]
        power,     ///< parts[0] with parts[1] raised
        matrix,    ///< `columns` wide, in square brackets
        fence      ///< parts[0] in round brackets
    };

    Formula() = default;
    /// "beta" with dots and a subscript, in italics.
    static Formula letter(std::string_view name, const std::string& sub = "", int dots = 0);
    /// The same with primes, before the subscript.
    static Formula primed(std::string_view name, const std::string& sub, int primes);
    /// Upright: numbers with their units, names of functions, words.
    static Formula upright(const std::string& text);
    /// A function's name, which stands close to what follows: "cos".
    static Formula function(const std::string& name);
    static Formula sign(const std::string& text);
    static Formula fraction(Formula above, Formula below);
    static Formula root(Formula of);
    static Formula power(Formula base, Formula exponent);
    static Formula fenced(Formula inside);
    /// Row by row, `columns` in each. `between`: entries of a row in plain text; "; ", as in Italian, where a comma is
    /// the decimal sign, then has rows in brackets of their own.
    static Formula matrix(std::vector<Formula> entries, std::size_t columns, const char* between = ", ");

    Formula& operator+=(Formula more);
    friend Formula operator+(Formula a, Formula b) { return a += std::move(b); }

    bool empty() const { return kind == Kind::row && parts.empty(); }
    /// "b cos(β)", "[1, 2; 3, 4]", "a/b".
    std::string plain() const;
    std::string latex() const;

    /// Whether it brings its own distance from what stands before: " m/s", ", ".
    bool stands_close() const;
    /// An upright d or ∂, or a power of it, to which what follows stands close.
    bool is_differential() const;

    Kind kind = Kind::row;
    RichText text;         ///< of text and sign
    std::string as_latex;  ///< the same in LaTeX
    std::string as_plain;  ///< the same in plain text; of a matrix what stands between entries
    std::vector<Formula> parts;
    std::size_t columns = 1;
};

}  // namespace kinegraph::render
