// Expressions of results: "omega 4 / omega 2", "|v B|", "'F A 3 on 2' * v A", "ratio = y B - y A". Their grammar is
// that of formulas (engine/file/formula_syntax.hpp), with names of results as operands. A product of two vectors is
// their dot product. Independent of where values come from: a position, a row of a sweep, a tolerance.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "engine/file/formula.hpp"
#include "engine/sentences/column.hpp"

namespace kinegraph {

/// A value in SI units with a bound on its error: of rounding, or of reading it in a drawing.
struct ValueWithin {
    double value = 0, error = 0;
};

class ResultExpression {
public:
    /// `known`: the columns of a sweep or of a position, with their SI units where they have no kind; a vector is known
    /// by its components: "v B" by "vx B" and "vy B". A name that contains a sign of the grammar stands between single
    /// quotes. Errors, in words that quote the place: syntax, unknown names, dimensions that do not go together, a
    /// value that is a vector.
    static tl::expected<ResultExpression, Words> read(std::string_view text, std::span<const Column> known);

    /// Its own name, or its text, of the kind Column::Kind::named.
    const Column& column() const { return column_; }
    /// What readers call it.
    void call(Key said) { column_.said = said; }
    /// The columns whose values it is made of, none twice.
    const std::vector<Column>& parts() const { return parts_; }
    /// From the values of the parts, in their order. None: a divisor is zero within its error, or a root or a quotient
    /// is not determined.
    std::optional<ValueWithin> value(std::span<const ValueWithin> of_parts) const;

    /// A node of the tree, for those who print it.
    struct Node {
        enum class Kind : std::uint8_t {
            number,
            scalar,  ///< parts()[x]
            vector,  ///< of parts()[x] and parts()[y]
            sum,
            product,
            power,  ///< of its part to `number`
            negative,
            function
        } kind = Kind::number;
        double number = 0;
        std::size_t x = 0, y = 0;
        std::string text = {};  ///< the function, or the number or exponent as written
        std::vector<Node> parts = {};
        std::vector<bool> is_inverse = {};  ///< by part: subtracted, or a divisor
    };

    const Node& tree() const { return root_; }
    bool is_named() const { return is_named_; }  ///< has a name of its own

private:
    Node root_;
    Column column_;
    bool is_named_ = false;
    std::vector<Column> parts_;
};

/// Whether a text that is no name of a result is meant as an expression: it contains a sign of the grammar.
bool is_expression(std::string_view text);
/// "ratio", "omega 4/omega 2" of "ratio = omega 4/omega 2"; without a name of its own, the text twice.
struct NamedExpression {
    std::string_view name, text;
};
NamedExpression named_expression(std::string_view text);
/// The expression that has this name: a defined result (engine/results/operands.hpp), or one that the exercise of the
/// mechanism asks for. None: it is no expression.
std::optional<ResultExpression> expression_called(std::string_view name, const Mechanism& mechanism);

}  // namespace kinegraph
