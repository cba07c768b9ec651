#include "problems/positions/positions.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "engine/drawing/pose.hpp"
#include "engine/reading/form_reader.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/finite_positions.hpp"
#include "lang/keys/problems.hpp"

namespace kinegraph {
namespace {

/// "5.657 mm", with the comma in Italian.
Words length_words(double si, const KnownUnit& unit) {
    std::array<char, 40> text{};
    constexpr int digits = 6;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), si / unit.si.to_double(),
                                   std::chars_format::general, digits)
                         .ptr;
    return decimal_words(std::string(text.data(), end) + " " + std::string(unit.symbol));
}

/// The keys of a position are the names of the two points, or "turned".
constexpr std::array place_or_angle{values::list(values::length, 2, 2), values::angle};
constexpr FormValue place_or_turn = values::any(place_or_angle), one_position = values::map(place_or_turn, 2, 2);

/// "positions": two or three positions of a body, by the places of two of its points.
class PositionsSection {
public:
    explicit PositionsSection(FormReader& file) : file_(file) {}

    std::optional<PositionsProblem> read(JsonValue section);

private:
    using Kind = FormReader::Kind;

    void read_position(JsonValue value, PositionsProblem& problem);
    /// Moves the point along the join if the distances differ by rounding only; a larger difference is a fault.
    void keep_distance(JsonValue at, const PositionsProblem& problem, PositionsProblem::Position& position);

    FormReader& file_;
};

std::optional<PositionsProblem> PositionsSection::read(JsonValue section) {
    const Words wanted(lang::finite_positions::two_or_three_positions_a_x);
    if (section.size() != 2 && section.size() != 3) {
        file_.fault(section, {lang::finite_positions::two_positions_of_a_body, std::to_string(section.size())});
        return std::nullopt;
    }
    PositionsProblem problem;
    problem.where = section.pointer();
    const std::size_t before = file_.fault_count();
    for (const JsonValue position : section) {
        if (!file_.expect(position, Kind::object, wanted)) return std::nullopt;
        if (problem.positions.empty()) {
            if (position.size() != 2) {
                file_.fault(position, {lang::finite_positions::the_first_position_gives_the_places,
                                       std::to_string(position.size())});
                return std::nullopt;
            }
            std::size_t i = 0;
            for (const JsonValue place : position) {
                file_.check_name(place, place.key());
                problem.points.at(i++) = place.key();
            }
        }
        read_position(position, problem);
    }
    if (file_.fault_count() > before) return std::nullopt;
    return problem;
}

void PositionsSection::read_position(JsonValue value, PositionsProblem& problem) {
    const bool first = problem.positions.empty();
    const std::array<std::string_view, 3> keys{problem.points[0], problem.points[1], "turned"};
    const Members form =
        file_.members(value, std::span(keys).first(first ? 2 : 3), {lang::finite_positions::a_position});
    PositionsProblem::Position position;
    position.where = value.pointer();
    const Words place(lang::common::a_place);
    position.places[0] =
        file_.vector(file_.required(form, problem.points[0], place), QuantityKind::length, place).value_or(Vector{});
    const JsonValue second =
        first ? file_.required(form, problem.points[1], place) : file_.one_of(form, {problem.points[1], "turned"});
    if (!second) return;
    if (second.key() == "turned" && !first) {
        const auto& start = problem.positions[0].places;
        const auto turned = file_.angle(second);
        if (!turned) return;
        // The square of the direction of half the angle is a unit vector, exactly.
        const Vector half = direction_of(Angle{turned->value / 2, turned->in_degrees}, 100);
        const Exact size = squared_length(half);
        const Exact cosine = (square(half.x) - square(half.y)) / size, sine = 2 * half.x * half.y / size;
        const Vector arm = start[1] - start[0];
        position.places[1] = position.places[0] + Vector{cosine * arm.x - sine * arm.y, sine * arm.x + cosine * arm.y};
    } else {
        position.places[1] = file_.vector(second, QuantityKind::length, place).value_or(Vector{});
        if (!first) keep_distance(second, problem, position);
    }
    if (first && position.places[0] == position.places[1])
        file_.fault(value, {lang::finite_positions::both_points_lie_at_the_same});
    problem.positions.push_back(std::move(position));
}

void PositionsSection::keep_distance(JsonValue at, const PositionsProblem& problem,
                                     PositionsProblem::Position& position) {
    const auto& start = problem.positions[0].places;
    const Exact wanted = squared_length(start[1] - start[0]);
    const Vector arm = position.places[1] - position.places[0];
    if (squared_length(arm) == wanted || wanted.is_zero()) return;
    constexpr double rounded_away = 1e-3;
    const double here = length(arm), there = length(start[1] - start[0]);
    if (arm.is_zero() || std::abs(here - there) > rounded_away * there) {
        const KnownUnit& unit = file_.bare_unit(QuantityKind::length);
        const auto said = [&](double si) { return length_words(si, unit); };
        file_.fault(at, {lang::finite_positions::a_rigid_body_keeps_distances_here, problem.points[0],
                         problem.points[1], said(here), said(there)});
        return;
    }
    position.places[1] = position.places[0] + square_root(wanted / squared_length(arm), 200).value * arm;
    position.moved = std::abs(here - there);
}

}  // namespace

constinit const FormValue positions_section =
    values::list(one_position, 2, 3)
        .named({},
               "Two or three positions of a body by the places of two of its points; further ones also by the first "
               "point and \"turned\".");

std::any read_positions(FormReader& file, Mechanism&, JsonValue section) {
    if (!file.expect(section, JsonValue::Kind::array, {lang::problems::an_array_of_positions})) return {};
    auto problem = PositionsSection(file).read(section);
    return problem ? std::any(*std::move(problem)) : std::any();
}

}  // namespace kinegraph
