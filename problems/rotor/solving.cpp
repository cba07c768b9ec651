#include "problems/rotor/rotor.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/number/functions.hpp"
#include "lang/keys/rotor.hpp"

namespace kinegraph {
namespace {

using Tip = PointOn<Plane::force>;
using Side = VectorOn<Plane::force>;

/// Directions are drawn within 2^-direction_bits; a sum of vectors that is smaller than rounding_bits of their lengths
/// is zero: a hundredfold margin above what rounding can leave.
constexpr int direction_bits = 200, rounding_bits = 190;

/// A unit vector, rational; `exact`: no rounding.
struct UnitVector {
    Vector along;
    bool exact = true;
};
UnitVector unit_vector_of(const Bearing& bearing) {
    const auto* angle = std::get_if<Angle>(&bearing.form);
    if (angle == nullptr) {
        const Vector& given = std::get<Vector>(bearing.form);
        const Vector along = unit_along(given, direction_bits);
        return {along, squared_length(along) == Exact(1)};
    }
    // The square of the direction of half the angle, as a complex number, is a unit vector.
    const Vector half = direction_of(Angle{angle->value / 2, angle->in_degrees}, direction_bits);
    const Exact size = squared_length(half);
    const Vector along{(square(half.x) - square(half.y)) / size, 2 * half.x * half.y / size};
    return {along, along.x.is_zero() || along.y.is_zero()};
}

/// Components within the rounding of the directions become zero, so that an angle is 0 and not nearly a whole turn.
Vector settled(const Vector& sum, const Exact& lengths) {
    const Exact least = lengths * Exact::power_of_two(-rounding_bits);
    return {abs(sum.x) <= least ? Exact() : sum.x, abs(sum.y) <= least ? Exact() : sum.y};
}

/// In 0 … 2π.
double angle_in_turn(const Vector& v) {
    const double angle = nearest::atan2(v.y.to_double(), v.x.to_double());
    return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

class BoardOfRotor {
public:
    BoardOfRotor(const RotorProblem& problem, const Mechanism& mechanism, const Pose& pose)
        : problem_(problem), board_(mechanism, pose, [&pose]() -> const Pose& { return pose; }) {
        for (const RotorMass& each : problem.masses) {
            const UnitVector direction = unit_vector_of(each.angle);
            found_.exact = found_.exact && direction.exact;
            const Exact size = each.mass * each.radius;
            found_.unbalances.push_back({direction.along, size, problem.z_of(each.plane) - reference()});
            sides_.push_back(board_.scale<Plane::force>(board_.number(size), board_.own_direction(direction.along)));
        }
    }

    RotorSolution solution() && {
        const auto plane = [&](std::size_t i) { return problem_.z_of(problem_.corrections[i].plane); };
        RotorBalance& balance = found_.balance;
        Held corrections = problem_.is_dynamic() ? held(plane(0), plane(1), balance) : held_in_one(balance);
        std::optional<Tip> left;
        if (!problem_.is_dynamic() && problem_.has_planes()) left = couples(plane(0), found_.couples_left);
        Held bearings;
        if (problem_.bearings) {
            found_.held.emplace();
            bearings = held(problem_.planes[problem_.bearings->at(0)].z, problem_.planes[problem_.bearings->at(1)].z,
                            *found_.held);
        }
        found_.record = std::move(board_).finish();
        read(corrections, balance);
        if (problem_.bearings) read(bearings, *found_.held);
        read_corrections();
        if (left) read_couple_left(*left);
        read_reactions();
        return std::move(found_);
    }

private:
    /// The closing sides in the order of the planes, and the sum of the lengths of what they close, over the distance
    /// of the planes: the scale of their rounding.
    struct Held {
        std::vector<ElementIndex> closing;
        Exact lengths;
    };

    Exact reference() const { return problem_.z_of(problem_.corrections.front().plane); }

    Tip side(RotorPolygon& polygon, Tip from, Side along, std::optional<std::size_t> mass, std::size_t balancing = 0) {
        const Tip to = board_.carry(from, along);
        polygon.sides.push_back({mass, balancing, from.element, to.element});
        return to;
    }
    /// The couples about a plane, of the masses outside it; returns the tip of the last.
    Tip couples(const Exact& z, RotorPolygon& polygon) {
        Tip tip = board_.pole<Plane::force>();
        for (std::size_t i = 0; i < sides_.size(); ++i) {
            const Exact arm = problem_.z_of(problem_.masses[i].plane) - z;
            if (!arm.is_zero()) tip = side(polygon, tip, board_.scale<Plane::force>(board_.number(arm), sides_[i]), i);
        }
        return tip;
    }
    Tip forces(RotorPolygon& polygon) {
        Tip tip = board_.pole<Plane::force>();
        for (std::size_t i = 0; i < sides_.size(); ++i) tip = side(polygon, tip, sides_[i], i);
        return tip;
    }
    /// The last side, back to the pole.
    Side close(RotorPolygon& polygon, Tip tip, std::size_t balancing) {
        const Tip pole = board_.pole<Plane::force>();
        polygon.sides.push_back({std::nullopt, balancing, tip.element, pole.element});
        return board_.vector(tip, pole);
    }

    /// Plane a is the reference plane: in it, a force has no couple.
    Held held(const Exact& a, const Exact& b, RotorBalance& balance) {
        const Side couple = close(balance.couples, couples(a, balance.couples), 1);
        const Side in_b = board_.scale<Plane::force>(board_.number(Exact(1) / (b - a)), couple);
        const Tip tip = side(balance.forces, forces(balance.forces), in_b, std::nullopt, 1);
        const Side in_a = close(balance.forces, tip, 0);
        Exact lengths;
        for (std::size_t i = 0; i < sides_.size(); ++i) {
            const Exact& z = problem_.z_of(problem_.masses[i].plane);
            lengths += found_.unbalances[i].size * (abs(z - a) + abs(z - b)) / abs(b - a);
        }
        return {{in_a.element, in_b.element}, lengths};
    }
    Held held_in_one(RotorBalance& balance) {
        const Side in_a = close(balance.forces, forces(balance.forces), 0);
        Exact lengths;
        for (const RotorSolution::Unbalance& each : found_.unbalances) lengths += each.size;
        return {{in_a.element}, lengths};
    }

    void read(const Held& held, RotorBalance& balance) const {
        for (const ElementIndex each : held.closing)
            balance.closing.push_back(settled(found_.record.vector(each), held.lengths));
    }
    void read_corrections() {
        for (std::size_t i = 0; i < problem_.corrections.size(); ++i) {
            const RotorCorrection& given = problem_.corrections[i];
            const Vector& unbalance = found_.balance.closing[i];
            RotorSolution::Correction correction;
            correction.vanishes = unbalance.is_zero();
            correction.unbalance = length(unbalance);
            if (!correction.vanishes) correction.angle = angle_in_turn(unbalance);
            if (given.radius) correction.mass = correction.unbalance / given.radius->to_double();
            if (given.mass) correction.radius = correction.unbalance / given.mass->to_double();
            found_.corrections.push_back(correction);
        }
    }
    void read_couple_left(Tip tip) {
        Exact lengths;
        for (const RotorSolution::Unbalance& each : found_.unbalances) lengths += each.size * abs(each.arm);
        found_.couple_left = settled(found_.record.point(tip.element).place(), lengths);
    }
    void read_reactions() {
        if (!problem_.bearings) return;
        const double square = (problem_.omega * problem_.omega).to_double();
        for (const Vector& each : found_.held->closing) {
            RotorSolution::Reaction reaction{square * length(each), 0, each.is_zero()};
            if (!reaction.vanishes) reaction.angle = angle_in_turn(each);
            found_.reactions.push_back(reaction);
        }
        if (!found_.couple_left) return;
        const Exact span =
            abs(problem_.planes[problem_.bearings->at(1)].z - problem_.planes[problem_.bearings->at(0)].z);
        found_.reaction_left = square * length(*found_.couple_left) / span.to_double();
    }

    const RotorProblem& problem_;
    Board board_;
    std::vector<Side> sides_;  ///< the unbalances of the masses
    RotorSolution found_;
};

/// The results as values, each with that of the check.
class RotorValues {
public:
    RotorValues(const RotorProblem& problem, const RotorSolution& found, const Units& units)
        : problem_(problem), found_(found), check_(check_rotor(problem)), units_(units) {}

    std::vector<ProblemValue> all() {
        for (std::size_t i = 0; i < problem_.corrections.size(); ++i) add_correction(i);
        if (found_.couple_left) add_couple_left();
        for (std::size_t i = 0; i < found_.reactions.size(); ++i) add_reaction(i);
        if (found_.reaction_left)
            add("reaction left", {lang::rotor::reaction_left_of_each_bearing}, "R′", QuantityKind::force,
                *found_.reaction_left, check_.reaction_left);
        return std::move(values_);
    }

private:
    static double size(const VectorOf<double>& v) { return nearest::hypot(v.x, v.y); }
    /// The angle of the check, in the turn in which the found one lies.
    static double angle_near(const VectorOf<double>& v, double found) {
        return found + std::remainder(nearest::atan2(v.y, v.x) - found, 2 * std::numbers::pi);
    }
    ProblemValue& add(std::string key, Words name, std::string symbol, QuantityKind kind, double value,
                      double numeric) {
        values_.push_back({std::move(key), std::move(name), std::move(symbol), kind, value, numeric, false});
        return values_.back();
    }
    void add_correction(std::size_t i) {
        const RotorCorrection& given = problem_.corrections[i];
        const RotorSolution::Correction& found = found_.corrections[i];
        const std::string letter = problem_.name_of(given), key = given.plane ? " " + letter : "";
        const Words plane = given.plane ? Words(lang::rotor::in_plane, letter) : Words();
        const VectorOf<double>& checked = check_.corrections[i];
        ProblemValue& unbalance = add("unbalance" + key, {lang::rotor::unbalance_of_the_correction, plane},
                                      "U_" + letter, QuantityKind::dimensionless, found.unbalance, size(checked));
        unbalance.unit = "kg m";
        unbalance.shown_in = unit_of_unbalance(units_);
        if (!found.vanishes)
            add("angle" + key, {lang::rotor::angle_of_the_correction, plane}, "θ_" + letter, QuantityKind::angle,
                found.angle, angle_near(checked, found.angle));
        if (found.mass)
            add("mass" + key, {lang::rotor::mass_of_the_correction, plane}, "m_" + letter, QuantityKind::mass,
                *found.mass, size(checked) / given.radius->to_double());
        if (found.radius)
            add("radius" + key, {lang::rotor::radius_of_the_correction, plane}, "r_" + letter, QuantityKind::length,
                *found.radius, size(checked) / given.mass->to_double());
    }
    void add_couple_left() {
        ProblemValue& couple = add("couple left", {lang::rotor::couple_that_is_left}, "C", QuantityKind::dimensionless,
                                   length(*found_.couple_left), size(check_.couple_left));
        couple.unit = "kg m²";
        couple.shown_in = unit_of_couple(units_);
    }
    void add_reaction(std::size_t i) {
        const RotorSolution::Reaction& found = found_.reactions[i];
        const std::string& name = problem_.planes[problem_.bearings->at(i)].name;
        const VectorOf<double>& checked = check_.reactions[i];
        add("reaction " + name, {lang::rotor::reaction_of_the_bearing, name}, "R_" + name, QuantityKind::force,
            found.force, size(checked));
        if (!found.vanishes)
            add("reaction angle " + name, {lang::rotor::angle_of_the_reaction, name}, "φ_" + name, QuantityKind::angle,
                found.angle, angle_near(checked, found.angle));
    }

    const RotorProblem& problem_;
    const RotorSolution& found_;
    RotorCheck check_;
    const Units& units_;
    std::vector<ProblemValue> values_;
};

std::vector<Words> remarks_on_rotor(const RotorProblem& problem, const RotorSolution& found) {
    std::vector<Words> remarks;
    if (found.is_balanced_already())
        remarks.emplace_back(problem.is_dynamic() ? Words(lang::rotor::it_is_balanced_already)
                                                  : Words(lang::rotor::it_is_balanced_statically));
    if (found.couple_left && !found.couple_left->is_zero()) remarks.emplace_back(lang::rotor::a_couple_is_left);
    return remarks;
}

}  // namespace

Result<ProblemSolution> solve_rotor(const RotorProblem& problem, const Mechanism& mechanism, const Pose& pose) {
    RotorSolution found = BoardOfRotor(problem, mechanism, pose).solution();
    ProblemSolution solution;
    solution.subject =
        problem.is_dynamic() ? Words(lang::rotor::balancing_in_two_planes) : Words(lang::rotor::balancing_in_one_plane);
    solution.values = RotorValues(problem, found, mechanism.units).all();
    if (auto why = why_no_numbers(solution.values, problem.where)) return tl::unexpected(*std::move(why));
    solution.remarks = remarks_on_rotor(problem, found);
    solution.of = std::move(found);
    return solution;
}

}  // namespace kinegraph
