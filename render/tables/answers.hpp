// Answers: what is sought with its value, its direction, and by how much a careful drawing may miss it. Owns which
// results are answers and how far a reading is good; computes no mechanics.
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

/// Places are set and read off a drawing by hand to this, mm on paper.
constexpr double reading_by_hand = 0.5;

struct Answer {
    Symbol symbol;
    Topic section = Topic::unnamed;
    double value = 0;  ///< in `unit`; of a vector its length, of what turns counter-clockwise positive
    std::string unit;
    std::optional<double> tolerance{};  ///< in `unit`; none: no figure says how large it is drawn
    std::optional<double> direction{};  ///< of a vector, degrees counter-clockwise from +x; of what slides that in
                                        ///< which its value is positive
    std::optional<std::array<double, 2>>
        at{};                          ///< of an instant centre, in `unit`; at infinity it has a direction only
    Quantity quantity{};               ///< none of an instant centre
    std::optional<Symbol> read_off{};  ///< the vector that tells its length, or the quotient or product that it is
    std::string detail{};              ///< letter of the detail in which that is read; empty: the figure itself
    RichText words{};                  ///< in place of the symbol: a component, an angle, a place
};

/// A result that is asked for by name, in SI, and the unit in which it is to be told.
struct AskedValue {
    Column column;
    double value = 0;
    std::string unit;      ///< its symbol; empty: a bare number
    double unit_size = 1;  ///< SI
    RichText symbol = {};  ///< as it is typeset
};

/// In the order of the solution. `drawn`: the figures of its sheet, from whose scales the tolerances follow: of a
/// vector half a millimetre at its scale, of ω and α that of the vector and the length that they are found from, of a
/// couple that of force and arm. `with_centres`: with the instant centres that are sought. What the file gives
/// (drivers, loads) is no answer.
std::vector<Answer> answers_of(const DrawingContext& context, const std::vector<Figure>& drawn,
                               bool with_centres = true);
/// Of these what the file asks for by name, or what that is a component of; all where it asks for nothing by name.
std::vector<Answer> answers_sought(const Mechanism& mechanism, std::vector<Answer> answers);
/// The key: answers_of without what is found on the way to what `find` states; where the file asks for results by name
/// those alone, section by section in the order of the solution, actions and reactions as they are asked for. `asked`:
/// their values; what no vector of the solution holds whole (components, places, angles) is told from these.
std::vector<Answer> key_of(const DrawingContext& context, const std::vector<Figure>& drawn,
                           const std::vector<AskedValue>& asked);
/// Those of which a reading says nothing: it may be off by as much as they are large.
std::vector<Answer> unreadable(const std::vector<Answer>& answers);
/// By how much a result by name (SI) may be off, in SI: the tolerance of its answer, a component's that of its vector,
/// that of a length on the figures where it is no answer; half a degree of an angle; one per cent of what is not read
/// off a drawing.
double reading_tolerance(const std::vector<Answer>& answers, const std::vector<Figure>& drawn, const Column& column,
                         double value, const Mechanism& mechanism);
/// A tolerance as it is told: rounded up to one digit.
double rounded_up(double tolerance);
/// As the lines of a table `width` mm wide, its head first.
std::vector<Block> answer_lines(const DrawingContext& context, const std::vector<Answer>& answers, double width);

}  // namespace kinegraph::render
