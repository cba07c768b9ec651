#include "engine/reading/problem_sections.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>

#include "engine/drawing/pose.hpp"
#include "engine/file/expression.hpp"

namespace kinegraph {
namespace {

constexpr std::array<std::string_view, 6> law_keys{"x", "y", "r", "theta", "path", "s"};

const Words& an_expression() {
    static const Words wanted("an expression in t, as \"v0*t\"", "un’espressione in t, come \"v0*t\"");
    return wanted;
}

}  // namespace

bool PointMotionSection::is_stated_by(JsonValue motion) {
    if (!motion || !motion.is_object() || motion["body"] || motion["velocities"]) return false;
    return motion["point"] ||
           std::any_of(law_keys.begin(), law_keys.end(), [&](std::string_view key) { return bool(motion[key]); });
}

std::optional<PointProblem> PointMotionSection::read(JsonValue section) {
    const Members form =
        file_.members(section, {"point", "x", "y", "r", "theta", "path", "s", "at", "from", "to", "constants"},
                      {"the motion of a point", "il moto di un punto"});
    PointProblem problem;
    problem.where = section.pointer();
    problem.point = "P";
    if (form["point"]) problem.point = file_.new_name(form["point"], {"the point’s name", "il nome del punto"});
    constants_.read(form["constants"]);
    read_laws(form, problem);
    read_times(form, problem);
    return problem;
}

void PointMotionSection::read_laws(const Members& form, PointProblem& problem) {
    const JsonValue leading = file_.one_of(form, {"x", "r", "path"});
    if (!leading) return;
    const auto alone = [&](std::initializer_list<std::string_view> others) {
        for (const std::string_view key : others)
            if (form[key]) file_.not_together(form[key], leading.key());
    };
    const auto law = [&](JsonValue value, const char* symbol, QuantityKind is) {
        problem.laws.push_back(read_law(value, symbol, QuantityKind::time, is, problem.constants));
    };
    if (leading.key() == "x") {
        alone({"theta", "s"});
        law(leading, "x", QuantityKind::length);
        law(form["y"], "y", QuantityKind::length);
    } else if (leading.key() == "r") {
        problem.form = PointProblem::Form::polar;
        alone({"y", "s"});
        law(leading, "r", QuantityKind::length);
        law(file_.required(form, "theta",
                           {"the angle of the radius, an expression in t", "l’angolo del raggio, un’espressione in t"}),
            "θ", QuantityKind::angle);
    } else {
        problem.form = PointProblem::Form::path;
        alone({"y", "theta"});
        read_path(leading, problem);
        law(file_.required(form, "s",
                           {"the way along the path, an expression in t", "l’ascissa curvilinea, un’espressione in t"}),
            "s", QuantityKind::length);
    }
}

StatedLaw PointMotionSection::read_law(JsonValue value, const std::string& symbol, QuantityKind of, QuantityKind is,
                                       NamedConstants& constants) {
    StatedLaw law;
    law.symbol = symbol;
    if (!value) return law;
    law.where = value.pointer();
    if (!value.is_string() && !value.is_number()) {
        file_.wrong(value, of == QuantityKind::time
                               ? an_expression()
                               : Words("an expression in x, as \"x^2/p\"", "un’espressione in x, come \"x^2/p\""));
        return law;
    }
    law.text = value.text();
    const std::string_view variable = of == QuantityKind::time ? "t" : "x";
    const ExpressionForm form{variable, of, is, file_.bare_unit(QuantityKind::length).si};
    auto read = read_expression(
        law.text, form, [&](std::string_view name) { return constants_.look_up(name, variable); }, constants);
    if (read)
        law.law = *std::move(read);
    else if (!read.error().empty())
        file_.fault(value, std::move(read.error()));
    return law;
}

void PointMotionSection::read_path(JsonValue value, PointProblem& problem) {
    if (!file_.expect(value, Kind::object,
                      {"{\"y\": …}, {\"circle\": …} or {\"line\": …}", "{\"y\": …}, {\"circle\": …} o {\"line\": …}"}))
        return;
    const Members form = file_.members(value, {"y", "circle", "line", "start"}, {"a path", "una traiettoria"});
    const JsonValue kind = file_.one_of(form, {"y", "circle", "line"});
    if (!kind) return;
    const JsonValue start = form["start"];
    if (kind.key() == "y") {
        GraphPath path;
        path.f = read_law(kind, "f", QuantityKind::length, QuantityKind::length, problem.constants);
        if (start) path.start = file_.quantity_or_zero(start, QuantityKind::length);
        problem.path = std::move(path);
    } else if (kind.key() == "circle") {
        CirclePath path;
        if (start) path.start = file_.quantity_or_zero(start, QuantityKind::angle);
        if (!file_.expect(kind, Kind::object,
                          {"{\"centre\": [x, y], \"radius\": …}", "{\"centre\": [x, y], \"radius\": …}"}))
            return;
        const Members circle = file_.members(kind, {"centre", "radius"}, {"a circle", "una circonferenza"});
        path.centre = file_.vector(circle["centre"], QuantityKind::length, {"a place [x, y]", "un luogo [x, y]"})
                          .value_or(Vector{});
        path.radius =
            file_.positive(file_.required(circle, "radius", {"the circle's radius", "il raggio della circonferenza"}),
                           QuantityKind::length, {"a radius", "un raggio"});
        problem.path = path;
    } else {
        if (start)
            file_.fault(start, {"a line starts where it is \"from\"; take \"start\" out",
                                "una retta parte da \"from\"; togliere \"start\""});
        if (!file_.expect(kind, Kind::object, {"{\"from\": [x, y], \"along\": X}", "{\"from\": [x, y], \"along\": X}"}))
            return;
        const Members line = file_.members(kind, {"from", "along"}, {"a line", "una retta"});
        LinePath path;
        path.from =
            file_.vector(line["from"], QuantityKind::length, {"a place [x, y]", "un luogo [x, y]"}).value_or(Vector{});
        path.direction = own_direction(file_.required(
            line, "along", {"its direction, an angle or [dx, dy]", "la sua direzione, un angolo o [dx, dy]"}));
        problem.path = path;
    }
}

Vector PointMotionSection::own_direction(JsonValue value) {
    if (value && value.is_array()) return file_.sense(value).value_or(Vector{1, 0});
    if (const auto given = file_.angle(value)) return direction_of(*given, 100);
    return {1, 0};
}

void PointMotionSection::read_times(const Members& form, PointProblem& problem) {
    const JsonValue at =
        file_.required(form, "at", {"the instant that is looked at, a time", "l’istante considerato, un tempo"});
    const JsonValue to = file_.required(
        form, "to", {"the time up to which the motion is followed", "il tempo fino al quale si segue il moto"});
    problem.at = file_.quantity_or_zero(at, QuantityKind::time);
    problem.from = form["from"] ? file_.quantity_or_zero(form["from"], QuantityKind::time) : Exact();
    problem.to = file_.quantity_or_zero(to, QuantityKind::time);
    if (!at || !to) return;
    problem.where_at = at.pointer();
    problem.where_from = form["from"] ? form["from"].pointer() : to.pointer();
    if (problem.from >= problem.to) {
        file_.fault(to, {"the interval must end after it begins; \"to\" is later than \"from\"",
                         "l’intervallo deve finire dopo il suo inizio; \"to\" è dopo \"from\""});
        return;
    }
    if (problem.at < problem.from || problem.at > problem.to)
        file_.fault(at, {"the instant lies outside \"from\" … \"to\"; move it, or widen the interval",
                         "l’istante è fuori da \"from\" … \"to\"; spostarlo, o allargare l’intervallo"});
}

}  // namespace kinegraph
