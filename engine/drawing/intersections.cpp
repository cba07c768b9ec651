#include "engine/drawing/intersections.hpp"

#include <algorithm>
#include <cmath>

#include "engine/number/geometry.hpp"
#include "lang/keys/drawing.hpp"

namespace kinegraph::drafting {

std::optional<Candidates> Intersections::meet(const Ray& a, const Ray& b, const std::string& where) {
    const Exact slant = cross(a.along, b.along);
    const ProjectiveLine first = finite_line_through(point_at(a.through), a.along);
    const bool inexact = a.touched || b.touched || !a.rational_angle || !b.rational_angle;
    const Exact doubt = inexact ? Exact::power_of_two(2 * (bits_in_doubt - draft_.pose.bits)) : Exact();
    if (square(slant) <= doubt * squared_length(a.along) * squared_length(b.along)) {
        const bool same = squared_distance(b.through, first) <= doubt * square(draft_.estimated_size);
        const Words apart = same ? Words(lang::drawing::they_are_one_and_the_same)
                                 : Words(lang::drawing::apart, draft_.in_file_units(distance(b.through, first)));
        draft_.fail(where, {lang::drawing::the_lines_and_do_not_meet, a.name, b.name, apart}, ErrorCode::cannot_meet);
        return std::nullopt;
    }
    const ProjectivePoint common = finite_meet(first, finite_line_through(point_at(b.through), b.along));
    Candidates found{{common.place()}, 0, inexact};
    if (!a.rational_angle || !b.rational_angle) {
        // An error of 2^-bits in a tangent turns a line by at most that. The error of the meet is this times the lever,
        // over the sine between the lines.
        const double lever = length(found.places[0] - a.through) + length(found.places[0] - b.through);
        const double sine = std::abs(slant.to_double()) / (length(a.along) * length(b.along));
        found.leftover = Exact::power_of_two(-draft_.pose.bits +
                                             static_cast<int>(std::ceil(std::log2(std::max(lever, 1e-300) / sine))));
    }
    return found;
}

std::optional<Candidates> Intersections::meet(const Ray& line, const Disc& circle, const std::string& where) {
    const Exact squared = squared_length(line.along);
    const Exact foot = dot(circle.centre - line.through, line.along) / squared;
    const Vector to_line = line.through + foot * line.along - circle.centre;
    const Exact room = square(circle.radius) - squared_length(to_line);  // square of half the chord
    const bool inexact = line.touched || circle.touched || !line.rational_angle;
    const Exact angle_miss =
        line.rational_angle ? Exact() : Exact::power_of_two(1 - draft_.pose.bits) * reach_of(line, circle);
    if (touches(room, circle.radius, 1) || (inexact && is_doubtful(room, circle.radius))) {
        return Candidates{{draft_.on_line(line.through, line.along, foot, inexact)},
                          inexact ? draft_.grid_step() + angle_miss : Exact(),
                          inexact};
    }
    if (room.sign() < 0) {
        const double distance = length(to_line);
        draft_.fail(where,
                    {lang::drawing::the_circle_about_and_the_line, circle.name, line.name,
                     draft_.in_file_units(distance), draft_.in_file_units(distance - circle.radius.to_double())},
                    ErrorCode::cannot_meet);
        return std::nullopt;
    }
    const int scale = magnitude_of_length(line.along) + 1;
    const Root half = square_root(room / squared, std::max(draft_.grid + scale, 1));
    const bool rounds = !half.leftover.is_zero();
    return Candidates{{draft_.on_line(line.through, line.along, foot - half.value, rounds),
                       draft_.on_line(line.through, line.along, foot + half.value, rounds)},
                      (rounds ? half.leftover * Exact::power_of_two(scale) + draft_.grid_step() : Exact()) + angle_miss,
                      inexact};
}

std::optional<Candidates> Intersections::meet(const Disc& a, const Disc& b, const std::string& where) {
    const Vector across = b.centre - a.centre;
    const bool inexact = a.touched || b.touched;
    if (inexact ? draft_.is_small(across) : across.is_zero()) {
        draft_.fail(where,
                    {lang::drawing::the_circles_about_and_do_not, a.name, b.name,
                     a.radius == b.radius ? Words(lang::drawing::and_radius)
                                          : Words(lang::drawing::and_radii_apart,
                                                  draft_.in_file_units(abs(a.radius - b.radius).to_double()))},
                    ErrorCode::cannot_meet);
        return std::nullopt;
    }
    const Exact squared = squared_length(across);
    const Exact foot = (square(a.radius) - square(b.radius) + squared) / (2 * squared);
    const Exact room = square(a.radius) - square(foot) * squared;
    const Exact lever = std::max(Exact(1), square(b.radius) / squared);
    if (touches(room, a.radius, lever) || (inexact && is_doubtful(room, a.radius))) {
        return Candidates{
            {draft_.on_line(a.centre, across, foot, inexact)}, inexact ? draft_.grid_step() : Exact(), inexact};
    }
    if (room.sign() < 0) {
        const double distance = length(across);
        const double sum = (a.radius + b.radius).to_double();
        const double difference = std::abs((a.radius - b.radius).to_double());
        const bool far = distance > sum;
        draft_.fail(where,
                    {lang::drawing::the_circles_about_and_do_not_meet, a.name, b.name, draft_.in_file_units(distance),
                     draft_.in_file_units(far ? distance - sum : difference - distance),
                     far ? Words(lang::drawing::too_far) : Words(lang::drawing::too_near)},
                    ErrorCode::cannot_meet);
        return std::nullopt;
    }
    const int scale = magnitude_of_length(across) + 1;
    const Root half = square_root(room / squared, std::max(draft_.grid + scale, 1));
    const Vector middle = a.centre + foot * across;
    const Vector sideways = half.value * quarter_turn(across);
    Candidates found{{middle + sideways, middle - sideways}, 0, inexact};
    if (!half.leftover.is_zero()) {
        found.leftover = half.leftover * Exact::power_of_two(scale) + draft_.grid_step();
        for (Vector& place : found.places)
            place =
                inexact ? corner_of_parallelogram(a.centre, b.centre, draft_.on_grid(place)) : draft_.on_grid(place);
    }
    return found;
}

Exact Intersections::reach_of(const Ray& line, const Disc& circle) const {
    const Vector apart = circle.centre - line.through;
    return abs(apart.x) + abs(apart.y) + circle.radius;
}

bool Intersections::is_doubtful(const Exact& room, const Exact& radius) const {
    return abs(room) < Exact::power_of_two(bits_in_doubt - draft_.pose.bits) * radius * draft_.estimated_size;
}

bool Intersections::touches(const Exact& room, const Exact& radius, const Exact& lever) const {
    return room.is_zero() || square(room) <= lever * square(2 * radius * draft_.slack);
}

Vector Intersections::corner_of_parallelogram(const Vector& a, const Vector& b, const Vector& place) const {
    const Vector opposite = a + b - place;
    const double x = opposite.x.to_double();
    const double near = std::ldexp(draft_.estimated_size.to_double(), -30);  // a first estimate in doubles
    for (std::size_t i = 0; i < draft_.pose.points.size(); ++i) {
        if (!draft_.is_placed[i] || std::abs(draft_.rough_x[i] - x) > near + std::ldexp(std::abs(x), -50)) continue;
        if (draft_.is_small(opposite - draft_.pose.points[i])) return a + b - draft_.pose.points[i];
    }
    return place;
}

}  // namespace kinegraph::drafting
