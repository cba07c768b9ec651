#include "engine/drawing/directions.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "engine/number/geometry.hpp"
#include "lang/keys/drawing.hpp"
#include "lang/keys/sentences.hpp"

namespace kinegraph::drafting {

void Directions::read_joints() {
    const std::size_t count = mechanism_.joints.size();
    draft_.pose.guides.resize(count);
    draft_.pose.guide_units.resize(count);
    draft_.pose.normals.resize(count);
    draft_.pose.tangents.resize(count);
    // A contact moves its point, so contacts precede all joints that measure from it.
    for (std::size_t i = 0; i < count; ++i) {
        const Joint& joint = mechanism_.joints[i];
        if (joint.pair().touches()) read_contact(joint, i);
    }
    for (std::size_t i = 0; i < count; ++i) {
        const Joint& joint = mechanism_.joints[i];
        if (joint.along) {
            if (const auto guide = direction(*joint.along, joint.where + "/along")) {
                draft_.pose.guides[i] = *guide;
                draft_.pose.guide_units[i] = unit_along(*guide, draft_.pose.bits);
                draft_.pose.normals[i] = quarter_turn(*guide);
            }
        } else if (joint.arc != none) {
            if (const auto normal = draft_.direction_between({joint.arc, joint.point}, joint.where + "/arc"))
                draft_.pose.normals[i] = *normal;
        }
    }
    // Directions of drivers and loads also contain roots, on which the following values depend.
    const auto note = [&](const Bearing& bearing, const std::string& where) {
        return direction(bearing, where + "/along");
    };
    draft_.pose.driver_directions.resize(mechanism_.drivers.size());
    draft_.pose.driver_units.resize(mechanism_.drivers.size());
    for (std::size_t i = 0; i < mechanism_.drivers.size(); ++i) {
        const auto* point = std::get_if<PointDriver>(&mechanism_.drivers[i]);
        if (point == nullptr) continue;
        if (const auto along = note(point->along, point->where)) {
            draft_.pose.driver_directions[i] = *along;
            draft_.pose.driver_units[i] = unit_along(*along, draft_.pose.bits);
        }
    }
    if (mechanism_.motion) {
        for (const auto* values : {&mechanism_.motion->velocities, &mechanism_.motion->accelerations}) {
            for (const GivenMotion& given : *values) {
                if (const auto* along = std::get_if<Bearing>(&given.value)) direction(*along, mechanism_.motion->where);
            }
        }
    }
    for (const Load& load : mechanism_.loads) {
        const auto* force = std::get_if<ForceLoad>(&load);
        if (force != nullptr && force->magnitude) note(force->magnitude->second, force->where);
        if (const auto* distributed = std::get_if<DistributedLoad>(&load)) note(distributed->along, distributed->where);
    }
    for (const Effort& effort : mechanism_.efforts) {
        if (const auto* force = std::get_if<ForceEffort>(&effort)) note(force->along, force->where);
    }
}

std::optional<Vector> Directions::direction(const Bearing& bearing, const std::string& where) {
    if (const auto* between = std::get_if<Bearing::Between>(&bearing.form))
        return draft_.direction_between(*between, where);
    if (const auto* angle = std::get_if<Angle>(&bearing.form))
        draft_.pose.exact = draft_.pose.exact && is_rational(*angle);
    Vector result = direction_of(bearing, draft_.pose);
    if (draft_.rounds && std::max(result.x.bits(), result.y.bits()) > most_bits) {
        const int grid = draft_.pose.bits - magnitude_of_length(result);
        result = {rounded(result.x, grid), rounded(result.y, grid)};
        draft_.pose.exact = false;
    }
    if (!result.is_zero()) return result;
    draft_.fail(where, {lang::drawing::the_vector_0_0_gives_no});
    return std::nullopt;
}

void Directions::read_contact(const Joint& joint, std::size_t index) {
    std::vector<PointIndex> centres;
    std::optional<Vector> tangent;
    for (const BodyIndex body : joint.bodies) {
        const auto profile = joint.profiles.find(body);
        if (profile == joint.profiles.end()) continue;
        if (const auto* line = std::get_if<LineProfile>(&profile->second)) {
            tangent = direction(line->along, joint.where + "/profiles/" + mechanism_.body(body).name + "/line");
            if (!tangent) return;
        } else if (const auto* circle = std::get_if<CircleProfile>(&profile->second)) {
            centres.push_back(circle->centre);
            if (!draft_.direction_between({circle->centre, joint.point}, joint.where)) return;
        }
    }
    if (!tangent && centres.empty()) {
        if (!joint.tangent) {
            draft_.fail(joint.where, {lang::drawing::nothing_says_how_the_bodies_touch, draft_.name_of(joint.point)});
            return;
        }
        tangent = direction(*joint.tangent, joint.where + "/tangent");
        if (!tangent) return;
    } else if (tangent && !centres.empty()) {
        const ProjectiveLine line = finite_line_through(point_at(draft_.pose.at(joint.point)), *tangent);
        if (!move(joint, foot_of_perpendicular(draft_.pose.at(centres[0]), line), {centres[0]})) return;
    } else if (centres.size() == 2) {
        const Vector& base = draft_.pose.at(centres[0]);
        const Vector across = draft_.pose.at(centres[1]) - base;
        if (!across.is_zero()) {
            const Exact factor = dot(draft_.pose.at(joint.point) - base, across) / squared_length(across);
            if (!move(joint, draft_.on_line(base, across, factor, draft_.touched(joint.point)),
                      {centres[0], centres[1]})) {
                return;
            }
        }
    }
    for (const auto& [body, profile] : joint.profiles) {
        const auto* circle = std::get_if<CircleProfile>(&profile);
        if (circle != nullptr && circle->of_body && !fits_radius(joint, body, circle->centre)) return;
    }
    const Vector normal = tangent ? quarter_turn(*tangent) : draft_.pose.at(centres[0]) - draft_.pose.at(joint.point);
    if (!tangent) tangent = -quarter_turn(normal);
    draft_.pose.tangents[index] = *tangent;
    draft_.pose.normals[index] = normal;
    if (joint.pair().meshes()) {
        // The line of action makes the pressure angle with the common tangent. Of the two such lines this is the one
        // turned counter-clockwise. The line on which the teeth push depends on the forces; motion does not depend on
        // it.
        const Angle pressure = joint.pressure_angle.value_or(Angle{});
        draft_.pose.exact = draft_.pose.exact && is_rational(pressure);
        draft_.pose.normals[index] = turned(direction_of(pressure, draft_.pose.bits), *tangent);
    }
}

bool Directions::claimed_twice(PointIndex point) const {
    return std::count_if(mechanism_.joints.begin(), mechanism_.joints.end(),
                         [&](const Joint& joint) { return joint.point == point && !joint.profiles.empty(); }) > 1;
}

bool Directions::is_noise(double misfit) const {
    constexpr double roundings = 1e-15;
    return misfit <= std::max(draft_.slack.to_double(), roundings * draft_.pose.size.to_double());
}

bool Directions::is_refused(double misfit) const {
    constexpr double fit = 1e-9;
    return misfit > std::max(fit * draft_.pose.size.to_double(), draft_.slack.to_double());
}

bool Directions::fits_radius(const Joint& joint, BodyIndex body, PointIndex centre) {
    const auto& circle = mechanism_.body(body).circle;
    if (!circle || circle->centre != centre) return true;
    // |PC| − r | = | |PC|² − r² | / (|PC| + r), which avoids a root of a value that may be exact
    const Vector arm = draft_.pose.at(joint.point) - draft_.pose.at(centre);
    const Exact excess = squared_length(arm) - square(circle->radius);
    const double misfit = std::abs(excess.to_double()) / (length(arm) + circle->radius.to_double());
    if (is_refused(misfit)) {
        return draft_.fail(joint.where,
                           {lang::drawing::lies_from_but_the_circle, draft_.name_of(joint.point),
                            draft_.in_file_units(length(arm)), draft_.name_of(centre), mechanism_.body(body).name,
                            draft_.in_file_units(circle->radius.to_double()), draft_.in_file_units(misfit)});
    }
    if (!is_noise(misfit)) {
        draft_.pose.remarks.push_back(
            {lang::sentences::off_its_circle,
             {PointName{draft_.name_of(joint.point)}, draft_.amount(misfit), BodyName{mechanism_.body(body).name}}});
    }
    return true;
}

bool Directions::move(const Joint& joint, const Vector& place, const std::vector<PointIndex>& centres) {
    const std::size_t point = at_index(joint.point);
    const Vector shift = place - draft_.pose.points[point];
    if (shift.is_zero()) return true;
    const double misfit = length(shift);
    const std::string& name = draft_.name_of(joint.point);
    const auto remark = [&](Key sentence) {
        Message message{sentence, {PointName{name}, draft_.amount(misfit)}};
        for (const PointIndex centre : centres) message.arguments.emplace_back(PointName{draft_.name_of(centre)});
        draft_.pose.remarks.push_back(std::move(message));
    };
    if (is_refused(misfit)) {
        const Words onto =
            centres.size() == 1
                ? Words(lang::drawing::the_foot_of_on_the_line, draft_.name_of(centres[0]))
                : Words(lang::drawing::the_line_of_the_centres, draft_.name_of(centres[0]), draft_.name_of(centres[1]));
        return draft_.fail(joint.where,
                           {lang::drawing::is_off_where_the_bodies_touch, name, draft_.in_file_units(misfit), onto});
    }
    if (claimed_twice(joint.point)) {
        if (!is_noise(misfit))
            remark(centres.size() == 1 ? lang::sentences::off_its_foot : lang::sentences::off_its_centres);
        return true;
    }
    draft_.pose.points[point] = place;
    draft_.pose.steps.push_back({joint.point, PositionStep::How::moved_onto_curve, {}});
    if (!is_noise(misfit))
        remark(centres.size() == 1 ? lang::sentences::moved_to_foot : lang::sentences::moved_to_centres);
    return true;
}

}  // namespace kinegraph::drafting
