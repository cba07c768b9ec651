#include "engine/reading/sections.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/points.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <variant>

namespace kinegraph {

void PointsSection::register_point(JsonValue member) {
    if (file_.add_point(member.key())) file_.check_name(member, member.key());
}

void PointsSection::read_points(JsonValue points) {
    Dependencies graph;
    std::vector<JsonValue> places;
    graph.first.push_back(0);
    file_.collect_points(&graph.targets);
    for (const JsonValue member : points) {
        const bool again = file_.index_of_point(member.key()) != PointIndex(mechanism_.points.size());
        if (again) {
            // A duplicate name: its own faults are reported, but it is not in the drawing.
            const std::size_t kept = graph.targets.size();
            placement(member);
            graph.targets.resize(kept);
            continue;
        }
        mechanism_.points.push_back({std::string(member.key()), placement(member), member.pointer()});
        places.push_back(member);
        graph.first.push_back(graph.targets.size());
    }
    file_.collect_points(nullptr);
    for (const auto& cycle : cycles(graph)) report_cycle(cycle, places);
}

void PointsSection::report_cycle(const std::vector<PointIndex>& cycle, const std::vector<JsonValue>& places) {
    constexpr std::size_t most_named = 12;
    const auto name = [&](PointIndex i) { return quoted(mechanism_.point(i).name); };
    Words chain = name(cycle.front());
    for (std::size_t i = 1; i < std::min(cycle.size(), most_named); ++i) chain += " → " + name(cycle[i]);
    if (cycle.size() > most_named) chain += Words(lang::points::points, std::to_string(cycle.size()));
    chain += " → " + name(cycle.front());
    file_.fault(places[at_index(cycle.front())],
                cycle.size() == 1 ? Words(lang::points::the_point_is_placed_by_itself, name(cycle.front()))
                                  : Words(lang::points::these_points_are_placed_by_each, chain));
}

Placement PointsSection::placement(JsonValue value) {
    if (value.is_array())
        return Coordinates{
            file_.vector(value, QuantityKind::length, {lang::points::a_pair_of_coordinates_x_y}).value_or(Vector{})};
    if (!value.is_object()) {
        file_.fault(value, {lang::points::a_point_is_x_y, described(value)});
        return Coordinates{};
    }
    if (value["meet"] || value["near"] || value["side"]) return meet(value);
    if (value["to"] || value["ratio"]) return point_on_line(value);
    if (value["circle"] || value["line"]) {
        file_.fault(value, {lang::points::a_curve_alone_is_no_point});
        return Coordinates{};
    }
    const Members form = file_.members(value, {"from", "distance", "angle", "relative to", "to", "ratio", "meet"},
                                       {lang::points::a_point});
    if (form.has_or_misspells("meet") || form.has_or_misspells("to") || form.has_or_misspells("ratio"))
        return Coordinates{};
    Polar polar;
    polar.from = file_.point(file_.required(form, "from", {lang::points::the_point_from_which_the_distance}));
    polar.distance = file_.quantity_or_zero(
        file_.required(form, "distance", {lang::points::how_far_from_there_the_point}), QuantityKind::length);
    polar.angle =
        file_.angle(file_.required(form, "angle", {lang::points::in_which_direction_or_give})).value_or(Angle{});
    if (const JsonValue base = form["relative to"]) {
        if (base.is_array() && base.size() == 2) {
            polar.relative_to = file_.between(base);
        } else {
            file_.fault(base, {lang::points::the_names_of_two_points_p, described(base)});
        }
    }
    return polar;
}

Placement PointsSection::point_on_line(JsonValue value) {
    const Members form = file_.members(value, {"from", "to", "distance", "ratio"}, {lang::points::a_point_on_a_line});
    Along along;
    along.from = file_.point(file_.required(form, "from", {lang::points::the_point_from_which_the_distance}));
    along.to = file_.point(file_.required(form, "to", {lang::points::the_point_towards}));
    if (along.from != none && along.from == along.to)
        file_.fault(form["to"], {lang::points::a_point_and_itself_give_no});
    if (const JsonValue amount = file_.one_of(form, {"distance", "ratio"})) {
        along.is_ratio = amount.key() == "ratio";
        along.amount = along.is_ratio ? file_.bare_number(amount).value_or(Exact())
                                      : file_.quantity_or_zero(amount, QuantityKind::length);
    }
    return along;
}

Placement PointsSection::meet(JsonValue value) {
    const Members form = file_.members(value, {"meet", "near", "side"}, {lang::points::a_meet});
    Meet meet;
    if (const JsonValue curves = file_.required(form, "meet", {lang::points::two_curves}); curves) {
        if (curves.is_array() && curves.size() == 2) {
            meet.first = curve(*curves.begin());
            meet.second = curve(*++curves.begin());
        } else {
            file_.fault(curves, {lang::points::two_curves_are_wanted_here_not, described(curves)});
        }
    }
    file_.one_of(form, {"near", "side"}, false);
    meet.near = file_.vector(form["near"], QuantityKind::length, {lang::common::a_place});
    if (const JsonValue side = form["side"]) meet.side = side_of(side, meet);
    return meet;
}

Meet::Side PointsSection::side_of(JsonValue value, const Meet& meet) {
    using Side = Meet::Side;
    const bool first = std::holds_alternative<LineCurve>(meet.first),
               second = std::holds_alternative<LineCurve>(meet.second);
    const bool on_line = first != second;
    constexpr std::array sides{std::pair{"left", Side::left}, std::pair{"right", Side::right},
                               std::pair{"behind", Side::behind}, std::pair{"ahead", Side::ahead}};
    for (const auto& [word, side] : sides) {
        if (!value.is_string() || value.text() != word) continue;
        if (side == Side::left || side == Side::right || first || second) return side;
        file_.fault(value, {lang::points::is_a_side_on_a_line, quoted(word)});
        return Side::either;
    }
    file_.wrong(value, on_line ? Words(lang::points::behind_or_ahead) : Words(lang::points::left_or_right));
    return Side::either;
}

Curve PointsSection::curve(JsonValue value) {
    if (!file_.expect(value, Kind::object, {lang::points::a_curve_circle_or_line})) return CircleCurve{};
    if (value["circle"] || value["radius"]) {
        const Members form = file_.members(value, {"circle", "radius"}, {lang::common::a_circle});
        CircleCurve circle;
        if (const JsonValue centre = file_.required(form, "circle", {lang::common::the_centre_of_the_circle}))
            circle.centre = file_.place(centre);
        circle.radius = file_.positive(file_.required(form, "radius", {lang::common::the_radius_of_the_circle}),
                                       QuantityKind::length, {lang::common::a_radius});
        return circle;
    }
    const Members form =
        file_.members(value, {"line", "angle", "to", "parallel", "perpendicular", "circle"}, {lang::common::a_line});
    LineCurve line;
    if (form.has_or_misspells("circle")) return line;
    if (const JsonValue through = file_.required(form, "line", {lang::points::a_point_on_the_line}))
        line.through = file_.place(through);
    const JsonValue how = file_.one_of(form, {"angle", "to", "parallel", "perpendicular"});
    if (!how) return line;
    if (how.key() == "angle") {
        line.angle = file_.angle(how).value_or(Angle{});
    } else if (how.key() == "to") {
        line.by = LineCurve::By::to;
        line.to = file_.point(how);
        const auto* through = std::get_if<PointIndex>(&line.through);
        if (through != nullptr && *through != none && *through == line.to)
            file_.fault(how, {lang::points::a_point_and_itself_give_no});
    } else {
        line.by = how.key() == "parallel" ? LineCurve::By::parallel : LineCurve::By::perpendicular;
        line.bearing = file_.bearing_or_default(how);
    }
    return line;
}

}  // namespace kinegraph
