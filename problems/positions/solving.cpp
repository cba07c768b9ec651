#include "problems/positions/positions.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "engine/number/functions.hpp"
#include "lang/keys/finite_positions.hpp"

namespace kinegraph {
namespace {

using DrawnPlace = PointOn<Plane::drawing>;
using Line = LineOn<Plane::drawing>;
using By = Displacement::By;

double angle_between(const Vector& from, const Vector& to) {
    return nearest::atan2(cross(from, to).to_double(), dot(from, to).to_double());
}

/// The board of all positions. Each bisector is drawn once and serves poles and pivots.
class BoardOfPositions {
public:
    BoardOfPositions(const PositionsProblem& problem, const Mechanism& mechanism, const Pose& pose)
        : problem_(problem), board_(mechanism, pose, [&pose]() -> const Pose& { return pose; }) {
        for (const PositionsProblem::Position& position : problem.positions)
            places_.push_back({laid_off(position.places[0]), laid_off(position.places[1])});
    }

    PositionsSolution solution() && {
        const std::size_t count = places_.size();
        displace(0, 1);
        if (count == 3) {
            displace(1, 2);
            displace(0, 2);
            for (std::size_t point = 0; point < 2; ++point) pivot(point);
        }
        found_.record = std::move(board_).finish();
        read();
        return std::move(found_);
    }

private:
    DrawnPlace laid_off(const Vector& place) {
        const DrawnPlace origin = board_.pole<Plane::drawing>();
        if (place.is_zero()) return origin;
        return board_.carry(origin, board_.scale<Plane::drawing>(board_.number(1), board_.own_direction(place)));
    }
    DrawnPlace middle(std::size_t point, std::size_t from, std::size_t to) {
        const DrawnPlace &a = places_[from].at(point), &b = places_[to].at(point);
        return board_.carry(a, board_.scale<Plane::drawing>(board_.number(Exact::ratio(1, 2)), board_.vector(a, b)));
    }
    Line bisector(std::size_t point, std::size_t from, std::size_t to) {
        const auto way = board_.vector(places_[from].at(point), places_[to].at(point));
        return board_.through(middle(point, from, to), board_.perpendicular(board_.direction(way)));
    }
    bool stays(std::size_t point, std::size_t from, std::size_t to) {
        return board_.coincide(places_[from].at(point), places_[to].at(point));
    }

    void displace(std::size_t from, std::size_t to) {
        Displacement displacement;
        displacement.from = from;
        displacement.to = to;
        poles_.emplace_back(none);
        const std::array<bool, 2> stay{stays(0, from, to), stays(1, from, to)};
        if (stay[0] && stay[1]) {
            displacement.kind = Displacement::Kind::rest;
        } else if (stay[0] || stay[1]) {
            displacement.kind = Displacement::Kind::rotation;
            displacement.by = By::point;
            poles_.back() = places_[from].at(stay[0] ? 0 : 1).element;
        } else {
            meet_bisectors(displacement);
        }
        found_.displacements.push_back(displacement);
    }
    void meet_bisectors(Displacement& displacement) {
        const std::size_t from = displacement.from, to = displacement.to;
        const auto meet = board_.meet(bisector(0, from, to), bisector(1, from, to));
        if (meet && !board_.is_at_infinity(*meet)) {
            poles_.back() = meet->element;
        } else if (meet) {
            displacement.kind = Displacement::Kind::translation;
        } else {
            on_one_bisector(displacement);
        }
    }
    /// Both bisectors coincide. The joins of both points meet in the pole. If these coincide too, it is a half turn
    /// about the common middle; if they are parallel, the body did not turn.
    void on_one_bisector(Displacement& displacement) {
        const std::size_t from = displacement.from, to = displacement.to;
        const Line before = board_.join(places_[from][0], places_[from][1]),
                   after = board_.join(places_[to][0], places_[to][1]);
        const auto meet = board_.meet(before, after);
        if (!meet) {
            displacement.by = By::middle;
            const auto way_a = board_.vector(places_[from][0], places_[to][0]);
            const auto way_b = board_.vector(places_[from][1], places_[to][1]);
            if (board_.is_zero(board_.subtract(way_a, way_b)))
                displacement.kind = Displacement::Kind::translation;
            else
                poles_.back() = middle(0, from, to).element;
        } else if (board_.is_at_infinity(*meet)) {
            displacement.kind = Displacement::Kind::translation;
        } else {
            displacement.by = By::joins;
            poles_.back() = meet->element;
        }
    }

    void pivot(std::size_t point) {
        FixedPivot pivot;
        pivots_.emplace_back(none);
        const std::array<bool, 3> same{stays(point, 0, 1), stays(point, 1, 2), stays(point, 0, 2)};
        if (same[0] && same[1]) {
            pivot.kind = FixedPivot::Kind::fixed;
        } else if (same[0] || same[1] || same[2]) {
            pivot.kind = FixedPivot::Kind::free;
        } else {
            const auto meet = board_.meet(bisector(point, 0, 1), bisector(point, 1, 2));
            if (meet && !board_.is_at_infinity(*meet)) {
                pivots_.back() = meet->element;
            } else {
                pivot.kind = FixedPivot::Kind::straight;
                pivot.direction = place(1, point) - place(0, point);
            }
        }
        found_.pivots.push_back(pivot);
    }

    const Vector& place(std::size_t position, std::size_t point) const {
        return problem_.positions[position].places.at(point);
    }
    void read() {
        for (std::size_t i = 0; i < poles_.size(); ++i) {
            Displacement& displacement = found_.displacements[i];
            const std::size_t from = displacement.from, to = displacement.to;
            displacement.way = place(to, 0) - place(from, 0);
            if (poles_[i] == none) continue;
            displacement.pole = found_.record.point(poles_[i]).place();
            displacement.angle = angle_between(place(from, 1) - place(from, 0), place(to, 1) - place(to, 0));
        }
        for (std::size_t i = 0; i < pivots_.size(); ++i) {
            if (pivots_[i] == none) continue;
            found_.pivots[i].centre = found_.record.point(pivots_[i]).place();
            found_.pivots[i].radius = length(place(0, i) - *found_.pivots[i].centre);
        }
    }

    const PositionsProblem& problem_;
    Board board_;
    std::vector<std::array<DrawnPlace, 2>> places_;
    std::vector<ElementIndex> poles_, pivots_;
    PositionsSolution found_;
};

// ----- values for tables and results

std::string both_of(const Displacement& displacement) {
    return std::to_string(displacement.from + 1) + std::to_string(displacement.to + 1);
}

std::vector<ProblemValue> values_of(const PositionsProblem& problem, const PositionsSolution& found) {
    using enum QuantityKind;
    std::vector<ProblemValue> values;
    const auto add = [&](std::string key, Words name, const std::string& symbol, QuantityKind kind, double value,
                         double numeric) {
        values.push_back({std::move(key), std::move(name), symbol, kind, value, numeric, false});
    };
    for (const Displacement& each : found.displacements) {
        const DisplacementCheck check = check_displacement(problem, each.from, each.to);
        const std::string both = both_of(each);
        if (each.kind == Displacement::Kind::translation) {
            add("translation " + both + " x", {lang::finite_positions::translation_x, both}, "d_" + both + "x", length,
                each.way.x.to_double(), check.way.x);
            add("translation " + both + " y", {lang::finite_positions::translation_y, both}, "d_" + both + "y", length,
                each.way.y.to_double(), check.way.y);
        }
        if (!each.pole) continue;
        add("pole " + both + " x", {lang::finite_positions::pole_x, both}, "x_P" + both, length,
            each.pole->x.to_double(), check.pole.x);
        add("pole " + both + " y", {lang::finite_positions::pole_y, both}, "y_P" + both, length,
            each.pole->y.to_double(), check.pole.y);
        add("angle " + both, {lang::finite_positions::angle, both}, "φ_" + both, angle, each.angle, check.angle);
    }
    for (std::size_t i = 0; i < found.pivots.size(); ++i) {
        const FixedPivot& pivot = found.pivots[i];
        if (!pivot.centre) continue;
        const auto [centre, radius] = check_pivot(problem, i);
        const std::string& point = problem.points.at(i);
        add("pivot " + point + " x", {lang::finite_positions::pivot_x, point}, "x_" + point + "0", length,
            pivot.centre->x.to_double(), centre.x);
        add("pivot " + point + " y", {lang::finite_positions::pivot_y, point}, "y_" + point + "0", length,
            pivot.centre->y.to_double(), centre.y);
        add("crank " + point, {lang::finite_positions::crank, point}, "r_" + point, length, pivot.radius, radius);
    }
    return values;
}

/// "0.012 mm".
Words said(double si, const Mechanism& mechanism) {
    const Unit& unit = mechanism.units.length;
    std::array<char, 40> digits{};
    constexpr int most = 3;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), si / unit.si.to_double(),
                                   std::chars_format::general, most)
                         .ptr;
    const std::string text = std::string(digits.data(), end) + " " + unit.symbol;
    return decimal_words(text);
}

std::vector<Words> remarks_on(const PositionsProblem& problem, const PositionsSolution& found,
                              const Mechanism& mechanism) {
    std::vector<Words> remarks;
    for (std::size_t i = 0; i < problem.positions.size(); ++i)
        if (problem.positions[i].moved > 0)
            remarks.emplace_back(lang::finite_positions::was_moved_by_along, problem.points[1], std::to_string(i + 1),
                                 said(problem.positions[i].moved, mechanism), problem.points[0]);
    for (const Displacement& each : found.displacements)
        if (each.kind == Displacement::Kind::rest)
            remarks.emplace_back(lang::finite_positions::positions_and_are_the_same_nothing,
                                 std::to_string(each.from + 1), std::to_string(each.to + 1));
    for (std::size_t i = 0; i < found.pivots.size(); ++i) {
        const std::string& point = problem.points.at(i);
        if (found.pivots[i].kind == FixedPivot::Kind::straight)
            remarks.emplace_back(lang::finite_positions::the_three_places_of_lie, point);
        if (found.pivots[i].kind == FixedPivot::Kind::free)
            remarks.emplace_back(lang::finite_positions::two_places_of_coincide_every_point, point);
        if (found.pivots[i].kind == FixedPivot::Kind::fixed)
            remarks.emplace_back(lang::finite_positions::keeps_its_place_it_is_itself, point);
    }
    return remarks;
}

}  // namespace

Result<ProblemSolution> solve_positions(const PositionsProblem& problem, const Mechanism& mechanism, const Pose& pose) {
    ProblemSolution solution;
    solution.subject = problem.positions.size() == 2
                           ? Words(lang::finite_positions::finite_displacement_its_pole)
                           : Words(lang::finite_positions::three_positions_poles_and_fixed_pivots);
    PositionsSolution found = BoardOfPositions(problem, mechanism, pose).solution();
    solution.values = values_of(problem, found);
    if (auto why = why_no_numbers(solution.values, problem.where)) return tl::unexpected(*std::move(why));
    solution.remarks = remarks_on(problem, found, mechanism);
    solution.of = std::move(found);
    return solution;
}

}  // namespace kinegraph
