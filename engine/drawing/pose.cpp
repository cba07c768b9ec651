// Draws the pose: places the points in the order of their dependencies, with square roots where a compass is needed,
// then computes the directions of guides and contacts. Every choice between two intersections is made here. Without
// motion and forces.
#include "engine/drawing/pose.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "engine/drawing/directions.hpp"
#include "engine/drawing/placing.hpp"
#include "engine/mechanism/rounding.hpp"
#include "engine/number/assert.hpp"
#include "lang/keys/drawing.hpp"
#include "lang/keys/sentences.hpp"

namespace kinegraph {
namespace {

using drafting::Directions;
using drafting::Draft;
using drafting::length_text;
using drafting::magnitude;
using drafting::magnitude_of_length;
using drafting::Placing;

/// `slack` (m): a miss up to this fits, because the data are rounded; 0 where they are exact.
Result<Pose> drawn_on_grid(const Mechanism& mechanism, int bits, int size_exponent, std::size_t longest_given,
                           const Exact& slack) {
    Draft draft(mechanism, bits, size_exponent, longest_given, slack);
    Placing placing(draft);
    for (const PointIndex point : indices_of(mechanism.points)) placing.drawn(point);
    if (!draft.errors.empty()) return tl::unexpected(draft.in_order_of_file());
    draft.measure();
    Directions(draft).read_joints();
    if (!draft.errors.empty()) return tl::unexpected(std::move(draft.errors));
    for (const Exact& leftover : draft.pose.leftover) draft.pose.exact = draft.pose.exact && leftover.is_zero();
    return std::move(draft.pose);
}

/// Statistics of the lengths in a file.
struct Lengths {
    int size = 0;             ///< power of two near the largest
    std::size_t longest = 0;  ///< bits of the longest number
};
Lengths lengths_of(const Mechanism& mechanism) {
    Exact largest;
    std::size_t longest = 0;
    std::optional<Vector> first;
    const auto number_given = [&](const Exact& value) { longest = std::max(longest, value.bits()); };
    const auto size_given = [&](const Exact& value) { largest = std::max(largest, abs(value)); };
    const auto length_given = [&](const Exact& value) {
        size_given(value);
        number_given(value);
    };
    const auto place_given = [&](const Vector& at) {
        number_given(at.x);
        number_given(at.y);
        if (!first) first = at;
        size_given(at.x - first->x);
        size_given(at.y - first->y);
    };
    const auto curve_given = [&](const Curve& curve) {
        if (const auto* circle = std::get_if<CircleCurve>(&curve)) length_given(circle->radius);
    };
    for (const NamedPoint& point : mechanism.points) {
        if (const auto* given = std::get_if<Coordinates>(&point.placement)) place_given(given->at);
        if (const auto* polar = std::get_if<Polar>(&point.placement)) length_given(polar->distance);
        if (const auto* along = std::get_if<Along>(&point.placement))
            along->is_ratio ? number_given(along->amount) : length_given(along->amount);
        if (const auto* meet = std::get_if<Meet>(&point.placement)) {
            curve_given(meet->first);
            curve_given(meet->second);
        }
    }
    return {largest.is_zero() ? 0 : magnitude(largest), longest};
}

Result<Pose> draw_within(const Mechanism& mechanism, int bits, const Exact& slack) {
    // The grid must suit the drawing's size, which is unknown before it is drawn: two spare bits, and a second drawing
    // where the given lengths are much larger than the result (a long radius about a far centre).
    constexpr int spare = 2;
    const Lengths given = lengths_of(mechanism);
    const int estimate = given.size - spare;
    auto pose = drawn_on_grid(mechanism, bits, estimate, given.longest, slack);
    if (!pose || pose->exact) return pose;
    const int true_size = magnitude(pose->size);
    if (true_size >= estimate) return pose;
    return drawn_on_grid(mechanism, bits, true_size, given.longest, slack);
}

/// A construction that fits as given must also fit in the shifted drawings, whose error is as large again.
constexpr int slack_as_given = 4, slack_when_shifted = 2 * slack_as_given;

/// A drawing that does not close with shifted numbers is skipped.
std::shared_ptr<const std::vector<ShiftedDrawing>> shifted_drawings_of(const Mechanism& mechanism, const Pose& pose) {
    auto drawings = std::make_shared<std::vector<ShiftedDrawing>>();
    for (int sample = 0; sample < shifted_drawings; ++sample) {
        Mechanism moved = shifted(mechanism, pose.precision, pose.precision / pose.size, sample);
        if (auto drawn = draw_within(moved, pose.bits, slack_when_shifted * pose.precision))
            drawings->push_back({std::move(moved), std::move(*drawn)});
    }
    return drawings;
}

}  // namespace

Result<Pose> draw_pose(const Mechanism& mechanism, int bits) {
    const bool inferred = looks_rounded(mechanism);
    const Exact expected = inferred ? inferred_share() * Exact::power_of_two(lengths_of(mechanism).size)
                                    : mechanism.precision.value_or(Exact());
    auto pose = draw_within(mechanism, bits, slack_as_given * expected);
    if (!pose || expected.is_zero()) return pose;
    pose->precision = inferred ? inferred_share() * pose->size : expected;
    const Unit& unit = mechanism.units.length;
    if (constexpr int coarsest = 100; coarsest * pose->precision > pose->size)
        return tl::unexpected(
            Errors{{ErrorCode::bad_input,
                    "/precision",
                    {lang::drawing::is_too_coarse_for_a_drawing, length_text(pose->precision.to_double(), unit),
                     length_text(pose->size.to_double(), unit)}}});
    if (inferred)
        pose->remarks.insert(pose->remarks.begin(), {lang::sentences::taken_as_rounded,
                                                     {Amount{(pose->precision / unit.si).to_double(), unit.symbol}}});
    pose->shifted = shifted_drawings_of(mechanism, *pose);
    return pose;
}

Vector direction_of(const Angle& angle, int bits) {
    const Exact half_turns = angle.in_degrees ? angle.value / 180 : angle.value / pi();
    // Quarter turns first, then the octant: the tangent is computed once, and all its images differ only by swaps and
    // signs.
    const Exact quarters = 2 * half_turns;
    mpz_class whole;
    mpz_fdiv_q(whole.get_mpz_t(), quarters.rational().get_num_mpz_t(), quarters.rational().get_den_mpz_t());
    const Exact rest = half_turns - Exact(mpq_class(whole)) / 2;
    const bool lower_octant = rest <= Exact::ratio(1, 4);
    const Exact tangent = tangent_in_first_octant(lower_octant ? rest : Exact::ratio(1, 2) - rest, bits);
    Vector direction = lower_octant ? Vector{1, tangent} : Vector{tangent, 1};
    const auto turns = mpz_fdiv_ui(whole.get_mpz_t(), 4);
    for (unsigned long i = 0; i < turns; ++i) direction = quarter_turn(direction);
    return direction;
}

Vector direction_of(const Bearing& bearing, const Pose& pose) {
    if (const auto* angle = std::get_if<Angle>(&bearing.form)) return direction_of(*angle, pose.bits);
    if (const auto* between = std::get_if<Bearing::Between>(&bearing.form))
        return pose.at(between->to) - pose.at(between->from);
    return std::get<Vector>(bearing.form);
}

Vector unit_along(const Vector& direction, int bits) {
    KG_ASSERT(!direction.is_zero(), "a zero vector has no direction");
    const Root factor =
        square_root(1 / squared_length(direction), std::max(bits + magnitude_of_length(direction) + 2, 1));
    return factor.value * direction;
}

Vector without_sense(Vector direction, bool is_exact) {
    const Exact x = abs(direction.x), y = abs(direction.y);
    const Exact& largest = x > y ? x : y;
    KG_ASSERT(!largest.is_zero(), "a direction is not zero");
    direction = {direction.x / largest, direction.y / largest};
    const Exact noise = Exact::power_of_two(-80);
    if (!is_exact && abs(direction.x) < noise) direction.x = 0;
    if (!is_exact && abs(direction.y) < noise) direction.y = 0;
    return direction.x.sign() < 0 || (direction.x.is_zero() && direction.y.sign() < 0) ? -direction : direction;
}

}  // namespace kinegraph
