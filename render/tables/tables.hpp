// Tables: vector equations with the known and sought properties of each term, results, instant centres, and the key of
// bodies, as marks with a size and the origin at the top left. Owns columns and rules; independent of positions on the
// sheet, and computes no mechanics beyond moduli of results.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/page/block.hpp"
#include "render/page/figure.hpp"
#include "render/scene/drawing_context.hpp"

namespace kinegraph::render {

/// One vector equation above its table: magnitude and direction (✓ or ?), and the line of each term. To fit into `most`
/// mm, its terms are set closer and smaller, down to `least` points, and then continued in further rows.
Block equation_block(const DrawingContext& context, const Equation& equation, double most, double least = 9);

/// The rows between two rules of the results table.
struct RowGroup {
    Topic section = Topic::unnamed;
    int polygon = -1;      ///< relative motion: index in Protocol::polygons
    bool couples = false;  ///< couples follow the forces

    // clang-tidy 14 takes the 0 that the compiler compares with for a pointer.
    friend auto operator<=>(const RowGroup&, const RowGroup&) = default;  // NOLINT(modernize-use-nullptr)
};
/// One row of the results: a drawn vector or a scalar of a body.
struct ResultRow {
    Quantity quantity;
    Symbol symbol;
    std::string name;                   ///< plain text, for the tests and the terminal
    std::optional<double> millimetres;  ///< measured on the drawing
    std::string detail;                 ///< letter of the detail in which it was measured; empty: the figure itself
    double drawing = 0;                 ///< by the construction, in `unit`
    std::optional<double> numeric;      ///< by the check, in `unit`
    std::string unit;
    RowGroup group;
    std::size_t arrow = 0;  ///< the same for rows of one arrow, or one turning: they share a line of the table; 0: none
};
/// Rows for the vectors drawn on `figures` (measured along their axes) and for ω and α of the bodies.
std::vector<ResultRow> result_rows(const DrawingContext& context, const std::vector<Figure>& figures);
/// The results as a table: the length read off the drawing to 0.1 mm, that times the scale, the number of the check,
/// and the deviation of the reading. What is one arrow stands in one line, as far as the names have room. Words are
/// measured once, so several widths can be tried. The context must outlive the table.
class ResultsTable {
public:
    ResultsTable(const DrawingContext& context, const std::vector<ResultRow>& rows);
    /// Its lines for a width of `width` mm, head first.
    std::vector<SharedBlock> lines(double width) const;

private:
    struct Parts;
    std::shared_ptr<const Parts> parts_;
};

/// Instant centres in the order in which they were found: symbol, construction, position. Shaped once; the context must
/// outlive the table.
class CentresTable {
public:
    explicit CentresTable(const DrawingContext& context);
    std::vector<SharedBlock> lines(double width) const;

private:
    struct Parts;
    std::shared_ptr<const Parts> parts_;
};
/// Key of the bodies: colour, number, description. Shaped once; the context must outlive the table.
class BodiesTable {
public:
    explicit BodiesTable(const DrawingContext& context);
    std::vector<SharedBlock> lines(double width) const;

private:
    struct Parts;
    std::shared_ptr<const Parts> parts_;
};

/// The table of Joukowsky's lever: force, arm h about the pole at the velocity scale, power; couples with ω; the sum
/// and the conclusion. As narrow as `most` mm if its columns can be set that close.
Block joukowsky_block(const DrawingContext& context, double most);

}  // namespace kinegraph::render
