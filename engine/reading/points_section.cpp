#include "engine/reading/sections.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/points.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <variant>

namespace kinegraph {
namespace {

constexpr std::array polar_rows{
    FormRow("from", "P", values::point_name).needed(lang::points::the_point_from_which_the_distance),
    FormRow("distance", "d", values::length).needed(lang::points::how_far_from_there_the_point),
    FormRow("angle", "a", values::angle).needed(lang::points::in_which_direction_or_give),
    FormRow("relative to", "[P, Q]", values::two_points, "The angle counts from this direction instead of +x.")};
constexpr std::array<std::string_view, 3> other_points{"to", "ratio", "meet"};
constexpr Form polar_point{lang::points::a_point, polar_rows, "At a distance and an angle from a point.", other_points};

constexpr std::array point_on_line_rows{
    FormRow("from", "P", values::point_name).needed(lang::points::the_point_from_which_the_distance),
    FormRow("to", "Q", values::point_name).needed(lang::points::the_point_towards),
    FormRow("distance", "d", values::length).one_of(),
    FormRow("ratio", "r", values::number, "In lengths of the join from → to; negative allowed.").one_of()};
constexpr Form point_on_line_form{lang::points::a_point_on_a_line, point_on_line_rows,
                                  "On the line from → to, at a distance or a ratio; negative allowed."};

constexpr std::array circle_curve_rows{
    FormRow("circle", "P", values::place, "The centre.").needed(lang::common::the_centre_of_the_circle),
    values::radius};
constexpr Form circle_curve{lang::common::a_circle, circle_curve_rows};
constexpr std::array line_curve_rows{
    FormRow("line", "P", values::place, "A point on the line.").needed(lang::points::a_point_on_the_line),
    FormRow("angle", "a", values::angle).one_of(),
    FormRow("to", "Q", values::point_name, "Another point on the line.").one_of(),
    FormRow("parallel", "X", values::direction).one_of(), FormRow("perpendicular", "X", values::direction).one_of()};
constexpr std::array<std::string_view, 1> other_curves{"circle"};
constexpr Form line_curve{lang::common::a_line, line_curve_rows, {}, other_curves};
constexpr FormValue circle_value = values::object(circle_curve).named("circleCurve", "A circle."),
                    line_value = values::object(line_curve).named("lineCurve", "A line through a point.");
constexpr std::array curve_choices{circle_value, line_value};
constexpr FormValue curve_value = values::any(curve_choices).named("curve", "A circle or a line.");

constexpr std::array<std::string_view, 4> sides_of_meet{"left", "right", "behind", "ahead"};
constexpr std::array meet_rows{
    FormRow("meet", "[curve, curve]", values::list(curve_value, 2, 2), "The two curves.")
        .needed(lang::points::two_curves),
    FormRow("near", "[x, y]", values::coordinates, "Of two intersections, the nearer to this place.")
        .called(lang::common::a_place)
        .at_most_one(),
    FormRow("side", "…", values::word(sides_of_meet),
            "Of two intersections: of circles the one left or right of first centre → second; on a line the one behind "
            "or ahead in the line's direction (left is behind, right ahead).")
        .at_most_one()};
constexpr Form meet_form{lang::points::a_meet, meet_rows, "The intersection of two curves."};

constexpr std::array point_choices{values::coordinates, values::object(polar_point), values::object(point_on_line_form),
                                   values::object(meet_form)};

}  // namespace

constinit const FormValue forms::point = values::any(point_choices).named("point", "How a point is placed.");

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
    const Members form = file_.members(value, polar_point);
    if (form.is_of_another_form()) return Coordinates{};
    Polar polar;
    polar.from = form.point("from");
    polar.distance = form.quantity_or_default("distance");
    polar.angle = form.angle("angle");
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
    const Members form = file_.members(value, point_on_line_form);
    Along along;
    along.from = form.point("from");
    along.to = form.point("to");
    if (along.from != none && along.from == along.to)
        file_.fault(form["to"], {lang::points::a_point_and_itself_give_no});
    if (const JsonValue amount = form.one_of()) {
        along.is_ratio = amount.key() == "ratio";
        along.amount = along.is_ratio ? form.number("ratio").value_or(Exact()) : form.quantity_or_default("distance");
    }
    return along;
}

Placement PointsSection::meet(JsonValue value) {
    const Members form = file_.members(value, meet_form);
    Meet meet;
    if (const JsonValue curves = form.value("meet")) {
        if (curves.is_array() && curves.size() == 2) {
            meet.first = curve(*curves.begin());
            meet.second = curve(*++curves.begin());
        } else {
            file_.fault(curves, {lang::points::two_curves_are_wanted_here_not, described(curves)});
        }
    }
    form.one_of();
    meet.near = form.vector("near");
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
        const Members form = file_.members(value, circle_curve);
        CircleCurve circle;
        circle.centre = form.place("circle");
        circle.radius = form.quantity_or_default("radius");
        return circle;
    }
    const Members form = file_.members(value, line_curve);
    LineCurve line;
    if (form.is_of_another_form()) return line;
    line.through = form.place("line");
    const JsonValue how = form.one_of();
    if (!how) return line;
    if (how.key() == "angle") {
        line.angle = form.angle("angle");
    } else if (how.key() == "to") {
        line.by = LineCurve::By::to;
        line.to = file_.point(how);
        const auto* through = std::get_if<PointIndex>(&line.through);
        if (through != nullptr && *through != none && *through == line.to)
            file_.fault(how, {lang::points::a_point_and_itself_give_no});
    } else {
        line.by = how.key() == "parallel" ? LineCurve::By::parallel : LineCurve::By::perpendicular;
        line.bearing = form.bearing_or_default(how.key());
    }
    return line;
}

}  // namespace kinegraph
