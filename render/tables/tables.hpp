// Tables: vector equations with what is known of each term, the results table, the list of centres and the key of
// bodies, as marks with a size, their origin at the top left. Owns columns and rules; chooses no place on the sheet and
// computes no mechanics beyond moduli of what was found.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/page/block.hpp"
#include "render/page/figure.hpp"
#include "render/scene/drawing_context.hpp"

namespace kinegraph::render {

/// One vector equation above its table: magnitude and direction (✓ or ?), and the line of each term. Not wider than
/// `most` mm: its terms are set closer and smaller, down to `least` points, and where that is not enough it goes on in
/// a further row.
Block equation_block(const DrawingContext& context, const Equation& equation, double most, double least = 9);

/// What stands between two rules of the table of results.
struct RowGroup {
    Topic section = Topic::unnamed;
    int polygon = -1;      ///< relative motion: one of Protocol::polygons
    bool couples = false;  ///< after the forces

    // clang-tidy 14 takes the 0 that the compiler compares with for a pointer.
    friend auto operator<=>(const RowGroup&, const RowGroup&) = default;  // NOLINT(modernize-use-nullptr)
};
/// One row of the results: a vector as drawn or a scalar of a body.
struct ResultRow {
    Quantity quantity;
    Symbol symbol;
    std::string name;                   ///< plain, for the tests and the terminal
    std::optional<double> millimetres;  ///< measured on the drawing
    std::string detail;                 ///< letter of the detail that it was measured in; empty: the figure itself
    double drawing = 0;                 ///< by the construction, in `unit`
    std::optional<double> numeric;      ///< by the check, in `unit`
    std::string unit;
    RowGroup group;
};
/// Rows for the vectors drawn on `figures` (their axes are measured) and for ω and α of the bodies.
std::vector<ResultRow> result_rows(const DrawingContext& context, const std::vector<Figure>& figures);
/// Rows as a table: read off the drawing to 0.1 mm, that times the scale, the number of the check, and by how much the
/// reading misses it. Its words are measured once, for the widths at which it is tried; its context outlives it.
class ResultsTable {
public:
    ResultsTable(const DrawingContext& context, const std::vector<ResultRow>& rows);
    /// Its lines where it stands in `width` mm, the head first.
    std::vector<SharedBlock> lines(double width) const;

private:
    struct Parts;
    std::shared_ptr<const Parts> parts_;
};

/// Instant centres in the order in which they were found: symbol, how, where. Shaped once; their context outlives them.
class CentresTable {
public:
    explicit CentresTable(const DrawingContext& context);
    std::vector<SharedBlock> lines(double width) const;

private:
    struct Parts;
    std::shared_ptr<const Parts> parts_;
};
/// Key of the bodies: colour, number, what it is. Said once; their context outlives it.
class BodiesTable {
public:
    explicit BodiesTable(const DrawingContext& context);
    std::vector<SharedBlock> lines(double width) const;

private:
    struct Parts;
    std::shared_ptr<const Parts> parts_;
};

/// The table of Joukowsky's lever: force, its arm h about the pole by the scale of velocities, power; couples with ω;
/// the sum, and what it says. Not wider than `most` mm as far as its columns can be set closer.
Block joukowsky_block(const DrawingContext& context, double most);

}  // namespace kinegraph::render
