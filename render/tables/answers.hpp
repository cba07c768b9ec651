// Answers: what is sought with its value, its direction, and by how much a careful drawing may miss it. Owns which results are
// answers and how far a reading is good; computes no mechanics.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/column.hpp"
#include "render/page/block.hpp"
#include "render/page/figure.hpp"
#include "render/scene/drawing_context.hpp"

namespace kinegraph::render {

/// Places are set and read off a drawing by hand to this, mm on paper.
constexpr double reading_by_hand = 0.5;

struct Answer {
    Symbol symbol;
    Topic section = Topic::unnamed;
    double value = 0;  ///< in `unit`; of a vector its length, of what turns counter-clockwise positive
    std::string unit;
    std::optional<double> tolerance{};          ///< in `unit`; none: no figure says how large it is drawn
    std::optional<double> direction{};          ///< of a vector, degrees counter-clockwise from +x
    std::optional<std::array<double, 2>> at{};  ///< of an instant centre, in `unit`; at infinity it has a direction only
    Quantity quantity{};                        ///< none of an instant centre
};

/// In the order of the solution. `drawn`: the figures of its sheet, from whose scales the tolerances follow: of a vector half a
/// millimetre at its scale, of ω and α that of the vector and the length that they are found from, of a couple that of force and
/// arm. `with_centres`: with the instant centres that are sought. What the file gives (drivers, loads) is no answer.
std::vector<Answer> answers_of(const DrawingContext& context, const std::vector<Figure>& drawn, bool with_centres = true);
/// By how much a result by name (SI) may be off, in SI: the tolerance of its answer, a component's that of its vector, that of a
/// length on the figures where it is no answer; half a degree of an angle; one per cent of what is not read off a drawing.
double reading_tolerance(const std::vector<Answer>& answers, const std::vector<Figure>& drawn, const Column& column, double value,
                         const Units& units);
/// A tolerance as it is told: rounded up to one digit.
double rounded_up(double tolerance);
/// As the lines of a table `width` mm wide, its head first.
std::vector<Block> answer_lines(const DrawingContext& context, const std::vector<Answer>& answers, double width);

}  // namespace kinegraph::render
