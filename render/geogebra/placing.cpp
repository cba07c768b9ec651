#include "render/geogebra/placing.hpp"

#include <utility>
#include <variant>

#include "engine/mechanism/drivers.hpp"
#include "lang/keys/library.hpp"

namespace kinegraph::render {
namespace {

std::string sum(const std::string& point, const std::string& factor, const std::string& vector) {
    return point + " + " + factor + " * " + vector;
}
std::string cross_text(const std::string& a, const std::string& b) {
    return "x(" + a + ") * y(" + b + ") - y(" + a + ") * x(" + b + ")";
}
double radians_of(const Angle& angle) {
    return (angle.in_degrees ? angle.value * pi() / Exact(180) : angle.value).to_double();
}

}  // namespace

GeoGebraPlacing::GeoGebraPlacing(GeoGebraConstruction& construction, const Mechanism& mechanism, const Pose& pose,
                                 GeoGebraLook look_of_points)
    : construction_(construction),
      mechanism_(mechanism),
      pose_(pose),
      look_(std::move(look_of_points)),
      points_(mechanism.points.size()) {}

std::string GeoGebraPlacing::vector(const std::string& text) {
    return construction_.expression(text, GeoGebraType::vector, construction_.label("u"));
}
std::string GeoGebraPlacing::constant(const Vector& value) {
    return vector('(' + GeoGebraConstruction::number(value.x.to_double()) + ", " +
                  GeoGebraConstruction::number(value.y.to_double()) + ')');
}
std::string GeoGebraPlacing::between(PointIndex from, PointIndex to) {
    const std::string a = point(from), b = point(to);
    return construction_.command("Vector", {a, b}, GeoGebraType::vector, construction_.label("u"));
}
std::string GeoGebraPlacing::direction(const Angle& angle) {
    const std::string turn = number(radians_of(angle));
    return vector("(cos(" + turn + "), sin(" + turn + "))");
}
std::string GeoGebraPlacing::direction(const Bearing& bearing) {
    if (const auto* ends = std::get_if<Bearing::Between>(&bearing.form)) return between(ends->from, ends->to);
    if (const auto* angle = std::get_if<Angle>(&bearing.form)) return direction(*angle);
    return constant(std::get<Vector>(bearing.form));
}
std::string GeoGebraPlacing::quarter_turn_of(const std::string& direction) {
    return construction_.command("PerpendicularVector", {direction}, GeoGebraType::vector, construction_.label("u"));
}
std::string GeoGebraPlacing::unit(const std::string& direction) {
    return construction_.command("UnitVector", {direction}, GeoGebraType::vector, construction_.label("u"));
}

std::string GeoGebraPlacing::place(const Place& place) {
    if (const auto* index = std::get_if<PointIndex>(&place)) return point(*index);
    const auto& at = std::get<Vector>(place);
    return construction_.free_point(construction_.label("Z"), at.x.to_double(), at.y.to_double());
}

std::string GeoGebraPlacing::point(PointIndex index) {
    std::string& label = points_[at_index(index)];
    if (!label.empty()) return label;
    const NamedPoint& named = mechanism_.points[at_index(index)];
    // A capital letter makes it a point; digits stand below it, or it would be a cell of a table.
    const bool is_letter = named.name[0] >= 'A' && named.name[0] <= 'Z';
    const std::string stem(1, is_letter ? named.name[0] : 'P');
    const std::string own = construction_.label(stem, is_letter ? named.name.substr(1) : named.name);
    label = placed(named, own, pose_.at(index));
    return label;
}

std::string GeoGebraPlacing::placed(const NamedPoint& named, const std::string& label, const Vector& at) {
    look_.caption = named.name;
    if (const auto* form = std::get_if<Polar>(&named.placement)) return polar(*form, label);
    if (const auto* form = std::get_if<Along>(&named.placement)) return along(*form, label);
    if (const auto* form = std::get_if<Meet>(&named.placement)) return meet(*form, label, at);
    return construction_.free_point(label, at.x.to_double(), at.y.to_double(), look_);
}

std::string GeoGebraPlacing::polar(const Polar& polar, const std::string& label) {
    const GeoGebraLook look = look_;
    const std::string from = point(polar.from), distance = number(polar.distance.to_double());
    std::string way = direction(polar.angle);
    if (polar.relative_to) {
        const std::string base = unit(between(polar.relative_to->from, polar.relative_to->to));
        const std::string across = quarter_turn_of(base);
        way = vector("x(" + way + ") * " + base + " + y(" + way + ") * " + across);
    }
    return construction_.expression(sum(from, distance, way), GeoGebraType::point, label, look);
}

std::string GeoGebraPlacing::along(const Along& along, const std::string& label) {
    const GeoGebraLook look = look_;
    const std::string from = point(along.from), amount = number(along.amount.to_double());
    const std::string way = between(along.from, along.to);
    return construction_.expression(sum(from, amount, along.is_ratio ? way : unit(way)), GeoGebraType::point, label,
                                    look);
}

GeoGebraPlacing::Drawn GeoGebraPlacing::curve(const Curve& curve) {
    if (const auto* circle = std::get_if<CircleCurve>(&curve)) {
        const std::string centre = place(circle->centre), radius = number(circle->radius.to_double());
        return {construction_.command("Circle", {centre, radius}, GeoGebraType::circle, construction_.label("c")), {}};
    }
    const auto& line = std::get<LineCurve>(curve);
    const std::string through = place(line.through);
    std::string way;
    switch (line.by) {
        case LineCurve::By::angle: way = direction(line.angle); break;
        case LineCurve::By::to:
            way = construction_.command("Vector", {through, point(line.to)}, GeoGebraType::vector,
                                        construction_.label("u"));
            break;
        case LineCurve::By::parallel: way = direction(line.bearing); break;
        case LineCurve::By::perpendicular: way = quarter_turn_of(direction(line.bearing)); break;
    }
    return {construction_.command("Line", {through, way}, GeoGebraType::line, construction_.label("l")), way};
}

/// Of two intersections GeoGebra's order says nothing: the side that the file names decides.
std::string GeoGebraPlacing::meet(const Meet& meet, const std::string& label, const Vector& at) {
    const GeoGebraLook look = look_;
    const Drawn first = curve(meet.first), second = curve(meet.second);
    if (!first.direction.empty() && !second.direction.empty())
        return construction_.command("Intersect", {first.label, second.label}, GeoGebraType::point, label, look);
    std::array<std::string, 2> both;
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}})
        both.at(i) = construction_.command("Intersect", {first.label, second.label, std::to_string(i + 1)},
                                           GeoGebraType::point, construction_.label("Z"));
    std::string condition;
    const std::string step = "(" + both[0] + " - " + both[1] + ")";
    using Side = Meet::Side;
    if (!first.direction.empty() || !second.direction.empty()) {
        const std::string& way = first.direction.empty() ? second.direction : first.direction;
        const bool ahead = meet.side == Side::right || meet.side == Side::ahead;
        condition = std::string(ahead ? "" : "-") + "(" + step + " * " + way + ") > 0";
    } else {
        const std::string a = place(std::get<CircleCurve>(meet.first).centre);
        const std::string b = place(std::get<CircleCurve>(meet.second).centre);
        condition = (meet.side == Side::left ? "" : "-(") + cross_text("(" + b + " - " + a + ")", step) +
                    (meet.side == Side::left ? "" : ")") + " > 0";
    }
    if (meet.near || meet.side == Side::either) {
        // The nearer one; without a choice the curves touch, and both are near the place drawn.
        const Vector near = meet.near.value_or(at);
        const std::string target =
            construction_.free_point(construction_.label("Z"), near.x.to_double(), near.y.to_double());
        condition = "Distance(" + both[0] + ", " + target + ") < Distance(" + both[1] + ", " + target + ")";
    }
    return construction_.expression("If(" + condition + ", " + both[0] + ", " + both[1] + ")", GeoGebraType::point,
                                    label, look);
}

std::string GeoGebraPlacing::tangent(const Joint& joint) {
    for (const BodyIndex body : joint.bodies) {
        const auto profile = joint.profiles.find(body);
        if (profile == joint.profiles.end()) continue;
        if (const auto* line = std::get_if<LineProfile>(&profile->second)) return direction(line->along);
    }
    for (const BodyIndex body : joint.bodies) {
        const auto profile = joint.profiles.find(body);
        if (profile == joint.profiles.end()) continue;
        if (const auto* circle = std::get_if<CircleProfile>(&profile->second))
            return vector("-1 * " + quarter_turn_of(between(joint.point, circle->centre)));
    }
    return joint.tangent ? direction(*joint.tangent) : std::string();
}

std::string GeoGebraPlacing::normal(const Joint& joint) {
    if (joint.along) return quarter_turn_of(direction(*joint.along));
    if (joint.arc != none) return between(joint.arc, joint.point);
    const std::string common = tangent(joint);
    if (!joint.pair().meshes()) return quarter_turn_of(common);
    const std::string pressure = direction(joint.pressure_angle.value_or(Angle{}));
    return vector("x(" + pressure + ") * " + common + " + y(" + pressure + ") * " + quarter_turn_of(common));
}

std::string GeoGebraPlacing::given(const Given& given) {
    using Kind = Given::Kind;
    const std::size_t i = given.index < 0 ? 0 : at_index(given.index);
    const auto motion = [&](const GivenMotion& value) {
        if (const auto* along = std::get_if<Bearing>(&value.value)) return direction(*along);
        return constant(std::get<Vector>(value.value));
    };
    switch (given.kind) {
        case Kind::guide: return direction(*mechanism_.joints[i].along);
        case Kind::guide_unit: return unit(direction(*mechanism_.joints[i].along));
        case Kind::normal: return normal(mechanism_.joints[i]);
        case Kind::tangent: return tangent(mechanism_.joints[i]);
        case Kind::driver_direction: return direction(std::get<PointDriver>(mechanism_.drivers[i]).along);
        case Kind::driver_unit: return unit(direction(std::get<PointDriver>(mechanism_.drivers[i]).along));
        case Kind::driver_velocity: return number(rates_of(mechanism_.drivers[i]).first.to_double());
        case Kind::driver_acceleration: return number(rates_of(mechanism_.drivers[i]).second.to_double());
        case Kind::act_velocity: return motion(mechanism_.motion->velocities[i]);
        case Kind::act_acceleration: return motion(mechanism_.motion->accelerations[i]);
        case Kind::number: return number(given.constant.x.to_double());
        case Kind::direction: return constant(given.constant);
        default: break;
    }
    if (!fault_) fault_ = Words(lang::library::geogebra_has_no_command, given.name);
    return {};
}

}  // namespace kinegraph::render
