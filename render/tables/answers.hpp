// Answers: the sought results with value, direction and the reading error that a careful drawing may have. Owns which
// results are answers and their tolerances; computes no mechanics.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/sentences/column.hpp"
#include "render/page/block.hpp"
#include "render/page/figure.hpp"
#include "render/scene/drawing_context.hpp"

namespace kinegraph::render {

/// Accuracy of placing and reading by hand, mm on paper.
constexpr double reading_by_hand = 0.5;

struct Answer {
    Symbol symbol;
    Topic section = Topic::unnamed;
    double value = 0;  ///< in `unit`; the magnitude of a vector; rotations are positive counter-clockwise
    std::string unit;
    std::optional<double> tolerance{};  ///< in `unit`; none: no figure determines the scale
    std::optional<double> direction{};  ///< vectors: degrees counter-clockwise from +x; slides: that of positive values
    std::optional<std::array<double, 2>>
        at{};                          ///< of an instant centre, in `unit`; a centre at infinity has only a direction
    Quantity quantity{};               ///< empty for an instant centre
    std::optional<Symbol> read_off{};  ///< the vector whose length it is, or the quotient or product that gives it
    std::string detail{};              ///< letter of the detail in which it is read; empty: the figure itself
    RichText words{};                  ///< instead of the symbol: a component, an angle, a place
};

/// A result requested by name, in SI, with the unit in which to print it.
struct RequestedResult {
    Column column;
    double value = 0;
    std::string unit;      ///< symbol of the unit; empty: dimensionless
    double unit_size = 1;  ///< size of the unit in SI
    RichText symbol = {};  ///< typeset symbol
};

/// Answers in the order of the solution. The tolerances follow from the scales of `drawn`, the figures of the sheet. A
/// vector: half a millimetre at its scale. ω and α: from the vector and the length of which they are the quotient. A
/// couple: from force and arm. `with_centres`: include the sought instant centres. Data of the file (drivers, loads)
/// are not answers.
std::vector<Answer> answers_of(const DrawingContext& context, const std::vector<Figure>& drawn,
                               bool with_centres = true);
/// The answers that the file requests by name, and the vectors of requested components. All answers if the file
/// requests nothing by name.
std::vector<Answer> answers_sought(const Mechanism& mechanism, std::vector<Answer> answers);
/// The key: answers_of without the intermediate results of what `find` states. If the file requests results by name,
/// only those, section by section in the order of the solution, with actions and reactions as requested. `asked`: their
/// values, used where no vector of the solution gives the result as a whole (components, places, angles).
std::vector<Answer> key_of(const DrawingContext& context, const std::vector<Figure>& drawn,
                           const std::vector<RequestedResult>& asked);
/// Answers that cannot be read meaningfully: the tolerance is as large as the value.
std::vector<Answer> unreadable(const std::vector<Answer>& answers);
/// Tolerance of a result requested by name, in SI (`value` too). An answer: its own tolerance; a component: that of its
/// vector; a length: that of the figures; an angle: half a degree; a result that is not read off a drawing: one per
/// cent.
double reading_tolerance(const std::vector<Answer>& answers, const std::vector<Figure>& drawn, const Column& column,
                         double value, const Mechanism& mechanism);
/// A tolerance for printing: rounded up to one digit.
double rounded_up(double tolerance);
/// The lines of a table `width` mm wide, head first.
std::vector<Block> answer_lines(const DrawingContext& context, const std::vector<Answer>& answers, double width);

}  // namespace kinegraph::render
