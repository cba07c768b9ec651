#include "engine/reading/sections.hpp"

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
    if (cycle.size() > most_named)
        chain += Words(" → … ({0} points)", " → … ({0} punti)", std::to_string(cycle.size()));
    chain += " → " + name(cycle.front());
    file_.fault(
        places[at_index(cycle.front())],
        cycle.size() == 1
            ? Words("the point {0} is placed by itself; place it by others or by coordinates",
                    "il punto {0} è definito per mezzo di se stesso; definirlo con altri o con coordinate",
                    name(cycle.front()))
            : Words(
                  "these points are placed by each other in a cycle: {0}; place one of them by others or by "
                  "coordinates",
                  "questi punti si definiscono l’un l’altro in cerchio: {0}; definirne uno con altri o con coordinate",
                  chain));
}

Placement PointsSection::placement(JsonValue value) {
    if (value.is_array())
        return Coordinates{file_
                               .vector(value, QuantityKind::length,
                                       {"a pair of coordinates [x, y]", "una coppia di coordinate [x, y]"})
                               .value_or(Vector{})};
    if (!value.is_object()) {
        file_.fault(value, {"a point is [x, y] or an object that says how to place it, not {0}",
                            "un punto è [x, y] o un oggetto che dice come si trova, non {0}", described(value)});
        return Coordinates{};
    }
    if (value["meet"] || value["near"] || value["side"]) return meet(value);
    if (value["to"] || value["ratio"]) return point_on_line(value);
    if (value["circle"] || value["line"]) {
        file_.fault(value, {"a curve alone is no point; write {\"meet\": [curve, curve]}",
                            "una curva sola non è un punto; scrivere {\"meet\": [curva, curva]}"});
        return Coordinates{};
    }
    const Members form = file_.members(value, {"from", "distance", "angle", "relative to", "to", "ratio", "meet"},
                                       {"a point", "un punto"});
    if (form.has_or_misspells("meet") || form.has_or_misspells("to") || form.has_or_misspells("ratio"))
        return Coordinates{};
    Polar polar;
    polar.from = file_.point(file_.required(
        form, "from", {"the point from which the distance is taken", "il punto da cui si misura la distanza"}));
    polar.distance = file_.quantity_or_zero(
        file_.required(form, "distance", {"how far from there the point lies", "quanto dista di lì il punto"}),
        QuantityKind::length);
    polar.angle =
        file_
            .angle(file_.required(form, "angle",
                                  {"in which direction (or give \"to\")", "in quale direzione (o assegnare \"to\")"}))
            .value_or(Angle{});
    if (const JsonValue base = form["relative to"]) {
        if (base.is_array() && base.size() == 2) {
            polar.relative_to = file_.between(base);
        } else {
            file_.fault(base, {"the names of two points [\"P\", \"Q\"] are wanted here, not {0}",
                               "qui servono i nomi di due punti [\"P\", \"Q\"], non {0}", described(base)});
        }
    }
    return polar;
}

Placement PointsSection::point_on_line(JsonValue value) {
    const Members form =
        file_.members(value, {"from", "to", "distance", "ratio"}, {"a point on a line", "un punto su una retta"});
    Along along;
    along.from = file_.point(file_.required(
        form, "from", {"the point from which the distance is taken", "il punto da cui si misura la distanza"}));
    along.to = file_.point(
        file_.required(form, "to", {"the point towards which it is taken", "il punto verso cui si misura"}));
    if (along.from != none && along.from == along.to)
        file_.fault(form["to"], {"a point and itself give no line; name another",
                                 "un punto e se stesso non danno una retta; indicarne un altro"});
    if (const JsonValue amount = file_.one_of(form, {"distance", "ratio"})) {
        along.is_ratio = amount.key() == "ratio";
        along.amount = along.is_ratio ? file_.bare_number(amount).value_or(Exact())
                                      : file_.quantity_or_zero(amount, QuantityKind::length);
    }
    return along;
}

Placement PointsSection::meet(JsonValue value) {
    const Members form = file_.members(value, {"meet", "near", "side"}, {"a meet", "un’intersezione"});
    Meet meet;
    if (const JsonValue curves = file_.required(form, "meet", {"two curves", "due curve"}); curves) {
        if (curves.is_array() && curves.size() == 2) {
            meet.first = curve(*curves.begin());
            meet.second = curve(*++curves.begin());
        } else {
            file_.fault(curves,
                        {"two curves are wanted here, not {0}", "qui servono due curve, non {0}", described(curves)});
        }
    }
    file_.one_of(form, {"near", "side"}, false);
    meet.near = file_.vector(form["near"], QuantityKind::length, {"a place [x, y]", "un luogo [x, y]"});
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
        file_.fault(value,
                    {"{0} is a side on a line; of two circles take \"left\" or \"right\"",
                     "{0} è un lato su una retta; per due circonferenze scegliere \"left\" o \"right\"", quoted(word)});
        return Side::either;
    }
    file_.wrong(value, on_line ? Words("\"behind\" or \"ahead\"", "\"behind\" o \"ahead\"")
                               : Words("\"left\" or \"right\"", "\"left\" o \"right\""));
    return Side::either;
}

Curve PointsSection::curve(JsonValue value) {
    if (!file_.expect(value, Kind::object,
                      {"a curve, {\"circle\": …} or {\"line\": …},", "una curva, {\"circle\": …} o {\"line\": …},"}))
        return CircleCurve{};
    if (value["circle"] || value["radius"]) {
        const Members form = file_.members(value, {"circle", "radius"}, {"a circle", "una circonferenza"});
        CircleCurve circle;
        if (const JsonValue centre =
                file_.required(form, "circle", {"the circle's centre", "il centro della circonferenza"}))
            circle.centre = file_.place(centre);
        circle.radius =
            file_.positive(file_.required(form, "radius", {"the circle's radius", "il raggio della circonferenza"}),
                           QuantityKind::length, {"a radius", "un raggio"});
        return circle;
    }
    const Members form =
        file_.members(value, {"line", "angle", "to", "parallel", "perpendicular", "circle"}, {"a line", "una retta"});
    LineCurve line;
    if (form.has_or_misspells("circle")) return line;
    if (const JsonValue through = file_.required(form, "line", {"a point on the line", "un punto della retta"}))
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
            file_.fault(how, {"a point and itself give no line; name another",
                              "un punto e se stesso non danno una retta; indicarne un altro"});
    } else {
        line.by = how.key() == "parallel" ? LineCurve::By::parallel : LineCurve::By::perpendicular;
        line.bearing = file_.bearing_or_default(how);
    }
    return line;
}

}  // namespace kinegraph
