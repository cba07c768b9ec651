#include "engine/reading/problem_sections.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>

#include "engine/drawing/pose.hpp"
#include "engine/file/expression.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/point_motion.hpp"

namespace kinegraph {
namespace {

constexpr std::array<std::string_view, 6> law_keys{"x", "y", "r", "theta", "path", "s"};

const Words& an_expression() {
    static const Words wanted(lang::point_motion::an_expression_in_t_as_v0);
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
                      {lang::point_motion::the_motion_of_a_point});
    PointProblem problem;
    problem.where = section.pointer();
    problem.point = "P";
    if (form["point"]) problem.point = file_.new_name(form["point"], {lang::point_motion::the_point_name});
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
        law(file_.required(form, "theta", {lang::point_motion::the_angle_of_the_radius}), "θ", QuantityKind::angle);
    } else {
        problem.form = PointProblem::Form::path;
        alone({"y", "theta"});
        read_path(leading, problem);
        law(file_.required(form, "s", {lang::point_motion::the_way_along_the_path}), "s", QuantityKind::length);
    }
}

StatedLaw PointMotionSection::read_law(JsonValue value, const std::string& symbol, QuantityKind of, QuantityKind is,
                                       NamedConstants& constants) {
    StatedLaw law;
    law.symbol = symbol;
    if (!value) return law;
    law.where = value.pointer();
    if (!value.is_string() && !value.is_number()) {
        file_.wrong(value,
                    of == QuantityKind::time ? an_expression() : Words(lang::point_motion::an_expression_in_x_as_x));
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
    if (!file_.expect(value, Kind::object, {lang::point_motion::y_circle_or_line})) return;
    const Members form = file_.members(value, {"y", "circle", "line", "start"}, {lang::point_motion::a_path});
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
        if (!file_.expect(kind, Kind::object, {lang::point_motion::centre_x_y_radius})) return;
        const Members circle = file_.members(kind, {"centre", "radius"}, {lang::common::a_circle});
        path.centre = file_.vector(circle["centre"], QuantityKind::length, {lang::common::a_place}).value_or(Vector{});
        path.radius = file_.positive(file_.required(circle, "radius", {lang::common::the_radius_of_the_circle}),
                                     QuantityKind::length, {lang::common::a_radius});
        problem.path = path;
    } else {
        if (start) file_.fault(start, {lang::point_motion::a_line_starts});
        if (!file_.expect(kind, Kind::object, {lang::point_motion::from_x_y_along_x})) return;
        const Members line = file_.members(kind, {"from", "along"}, {lang::common::a_line});
        LinePath path;
        path.from = file_.vector(line["from"], QuantityKind::length, {lang::common::a_place}).value_or(Vector{});
        path.direction =
            own_direction(file_.required(line, "along", {lang::point_motion::its_direction_an_angle_or_dx}));
        problem.path = path;
    }
}

Vector PointMotionSection::own_direction(JsonValue value) {
    if (value && value.is_array()) return file_.sense(value).value_or(Vector{1, 0});
    if (const auto given = file_.angle(value)) return direction_of(*given, 100);
    return {1, 0};
}

void PointMotionSection::read_times(const Members& form, PointProblem& problem) {
    const JsonValue at = file_.required(form, "at", {lang::point_motion::the_instant_that_is_looked});
    const JsonValue to = file_.required(form, "to", {lang::point_motion::the_time_up});
    problem.at = file_.quantity_or_zero(at, QuantityKind::time);
    problem.from = form["from"] ? file_.quantity_or_zero(form["from"], QuantityKind::time) : Exact();
    problem.to = file_.quantity_or_zero(to, QuantityKind::time);
    if (!at || !to) return;
    problem.where_at = at.pointer();
    problem.where_from = form["from"] ? form["from"].pointer() : to.pointer();
    if (problem.from >= problem.to) {
        file_.fault(to, {lang::point_motion::the_interval_must_end_after});
        return;
    }
    if (problem.at < problem.from || problem.at > problem.to)
        file_.fault(at, {lang::point_motion::the_instant_lies_outside});
}

}  // namespace kinegraph
