#include "engine/drawing/placing.hpp"

#include <utility>
#include <variant>

#include "engine/number/assert.hpp"
#include "engine/number/geometry.hpp"
#include "lang/keys/drawing.hpp"

namespace kinegraph::drafting {

bool Placing::drawn(PointIndex point) {
    State& state = state_[at_index(point)];
    if (state == State::done) return true;
    if (state == State::failed) return false;
    KG_ASSERT(state == State::waiting, "the reader refuses points that need each other in a circle");
    state = State::under_way;
    const NamedPoint& named = draft_.mechanism.point(point);
    PositionStep step{point, PositionStep::How::given, {}};
    const bool placed =
        std::visit([&](const auto& placement) { return place(named, placement, step); }, named.placement);
    state_[at_index(point)] = placed ? State::done : State::failed;
    if (placed) draft_.pose.steps.push_back(std::move(step));
    return placed;
}

bool Placing::drawn(const Place& place) {
    const auto* point = std::get_if<PointIndex>(&place);
    return point == nullptr || drawn(*point);
}

bool Placing::drawn(const Bearing& bearing) {
    const auto* between = std::get_if<Bearing::Between>(&bearing.form);
    return between == nullptr || drawn(*between);
}

bool Placing::drawn(const Bearing::Between& between) {
    const bool from = drawn(between.from);
    return drawn(between.to) && from;
}

bool Placing::place(const NamedPoint& named, const Coordinates& placement, PositionStep&) {
    draft_.set(named, placement.at, 0, false);
    return true;
}

bool Placing::place(const NamedPoint& named, const Polar& placement, PositionStep& step) {
    step.how = PositionStep::How::polar;
    bool ready = drawn(placement.from);
    if (placement.relative_to) ready = drawn(*placement.relative_to) && ready;
    if (!ready) return false;
    const Vector& from = draft_.pose.at(placement.from);
    step.arcs.push_back({from, abs(placement.distance)});
    const Vector angle = direction_of(placement.angle, draft_.pose.bits);
    Vector direction = angle;
    bool is_touched = draft_.touched(placement.from);
    if (placement.relative_to) {
        const auto base = draft_.direction_between(*placement.relative_to, named.where);
        if (!base) return false;
        direction = turned(angle, *base);
        is_touched = is_touched || draft_.touched(*placement.relative_to);
    }
    const auto [reach, miss] = draft_.along(direction, placement.distance);
    Vector place = from + reach;
    Exact leftover = miss;
    if (!is_rational(placement.angle)) leftover += abs(placement.distance) * Exact::power_of_two(-draft_.pose.bits);
    // The point stays exactly on its ray where other points may lie on it too: a ray of an angle of the file, or along
    // or perpendicular to P→Q. Elsewhere it is rounded to the nearest point of the grid, so that numbers in chains stay
    // short.
    const bool square_to_base = angle.x.is_zero() || angle.y.is_zero();
    if (placement.relative_to && !square_to_base && !leftover.is_zero()) {
        place = draft_.on_grid(place);
        leftover += draft_.grid_step();
    }
    draft_.set(named, place, leftover, is_touched);
    return true;
}

bool Placing::place(const NamedPoint& named, const Along& placement, PositionStep& step) {
    step.how = PositionStep::How::along;
    if (!drawn(Bearing::Between{placement.from, placement.to})) return false;
    const Vector& from = draft_.pose.at(placement.from);
    const Bearing::Between between{placement.from, placement.to};
    if (placement.is_ratio) {
        draft_.set(named, from + placement.amount * (draft_.pose.at(placement.to) - from), 0, draft_.touched(between));
        return true;
    }
    const auto direction = draft_.direction_between(between, named.where);
    if (!direction) return false;
    step.arcs.push_back({from, abs(placement.amount)});
    const auto [reach, miss] = draft_.along(*direction, placement.amount);
    draft_.set(named, from + reach, miss, draft_.touched(between));
    return true;
}

bool Placing::place(const NamedPoint& named, const Meet& placement, PositionStep& step) {
    const auto draw_stroke = [&](const Curve& curve) {
        return std::visit([&](const auto& form) { return stroke(form, named.where); }, curve);
    };
    const auto first = draw_stroke(placement.first);
    const auto second = draw_stroke(placement.second);
    if (!first || !second) return false;
    std::optional<Candidates> found;
    const auto* first_line = std::get_if<Ray>(&*first);
    const auto* second_line = std::get_if<Ray>(&*second);
    for (const auto& each : {&*first, &*second}) {
        if (const auto* disc = std::get_if<Disc>(each)) step.arcs.push_back({disc->centre, disc->radius});
    }
    if (first_line != nullptr && second_line != nullptr) {
        step.how = PositionStep::How::lines;
        found = intersections_.meet(*first_line, *second_line, named.where);
    } else if (first_line != nullptr || second_line != nullptr) {
        step.how = PositionStep::How::line_and_circle;
        found = first_line != nullptr ? intersections_.meet(*first_line, std::get<Disc>(*second), named.where)
                                      : intersections_.meet(*second_line, std::get<Disc>(*first), named.where);
    } else {
        step.how = PositionStep::How::circles;
        found = intersections_.meet(std::get<Disc>(*first), std::get<Disc>(*second), named.where);
    }
    if (!found) return false;
    const auto chosen = choose(*found, placement, step.how, named);
    if (!chosen) return false;
    draft_.set(named, *chosen, found->leftover, found->touched);
    return true;
}

std::optional<Stroke> Placing::stroke(const CircleCurve& circle, const std::string&) {
    if (!drawn(circle.centre)) return std::nullopt;
    return Disc{
        draft_.at(circle.centre),
        circle.radius,
        draft_.touched(circle.centre),
        {lang::drawing::radius, draft_.name_of(circle.centre), draft_.in_file_units(circle.radius.to_double())}};
}

std::optional<Stroke> Placing::stroke(const LineCurve& line, const std::string& where) {
    bool ready = drawn(line.through);
    if (line.by == LineCurve::By::to) ready = drawn(line.to) && ready;
    const bool by_bearing = line.by == LineCurve::By::parallel || line.by == LineCurve::By::perpendicular;
    if (by_bearing) ready = drawn(line.bearing) && ready;
    if (!ready) return std::nullopt;
    Ray ray{draft_.at(line.through),
            {},
            true,
            draft_.touched(line.through),
            {lang::drawing::through, draft_.name_of(line.through)}};
    if (line.by == LineCurve::By::angle) {
        ray.along = direction_of(line.angle, draft_.pose.bits);
        ray.rational_angle = is_rational(line.angle);
    } else if (line.by == LineCurve::By::to) {
        ray.along = draft_.pose.at(line.to) - ray.through;
        ray.touched = ray.touched || draft_.touched(line.to);
        ray.name += Words(lang::drawing::and_word, draft_.name_of(line.to));
        if (ray.touched ? draft_.is_small(ray.along) : ray.along.is_zero()) {
            draft_.fail(where, {lang::drawing::and_coincide_so_they_give_no_line, draft_.name_of(line.through),
                                draft_.name_of(line.to)});
            return std::nullopt;
        }
    } else {
        if (const auto* angle = std::get_if<Angle>(&line.bearing.form)) ray.rational_angle = is_rational(*angle);
        if (const auto* between = std::get_if<Bearing::Between>(&line.bearing.form)) {
            if (!draft_.direction_between(*between, where)) return std::nullopt;
            ray.touched = ray.touched || draft_.touched(*between);
        }
        ray.along = direction_of(line.bearing, draft_.pose);
        if (ray.along.is_zero()) {
            draft_.fail(where, {lang::drawing::the_vector_0_0_gives_no});
            return std::nullopt;
        }
        if (line.by == LineCurve::By::perpendicular) ray.along = quarter_turn(ray.along);
    }
    return ray;
}

std::optional<Vector> Placing::choose(const Candidates& found, const Meet& meet, PositionStep::How how,
                                      const NamedPoint& named) {
    if (found.places.size() == 1) return found.places.front();
    if (meet.near) {
        const Exact first = squared_distance(found.places[0], *meet.near);
        const Exact second = squared_distance(found.places[1], *meet.near);
        const Exact apart = abs(first - second);
        const bool tie = found.touched ? apart < Exact::power_of_two(bits_in_doubt - draft_.pose.bits) *
                                                     square(draft_.estimated_size)
                                       : apart.is_zero();
        if (!tie) return found.places[first < second ? 0 : 1];
        draft_.fail(named.where, {lang::drawing::both_intersections_for_are_equally_far, named.name});
        return std::nullopt;
    }
    if (meet.side != Meet::Side::either) {
        // Circles: left and right of first centre → second. On a line both intersections lie on the line itself. The
        // side is as seen with the line's direction pointing to the right, so that "right" is the one further along it.
        // (Seen from the centre the sides would swap whenever the centre crosses the line, as a crank pin does.)
        const bool first = meet.side == Meet::Side::left || meet.side == Meet::Side::behind;
        return found.places[first ? 0 : 1];
    }
    draft_.fail(named.where, {lang::drawing::meet_twice_choose_the_intersection,
                              how == PositionStep::How::circles ? Words(lang::drawing::the_circles)
                                                                : Words(lang::drawing::the_line_and_the_circle),
                              named.name});
    return std::nullopt;
}

}  // namespace kinegraph::drafting
