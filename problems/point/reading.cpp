#include "problems/point/point.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/drawing/pose.hpp"
#include "engine/file/expression.hpp"
#include "engine/reading/form_reader.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/laws.hpp"
#include "lang/keys/point_motion.hpp"

namespace kinegraph {
namespace {

constexpr std::array<std::string_view, 6> law_keys{"x", "y", "r", "theta", "path", "s"};

constexpr FormRow law_row(std::string_view key) { return FormRow(key, "…", values::expression); }
constexpr FormRow pair_of_lengths(std::string_view key, std::string_view says) {
    return FormRow(key, "[x, y]", values::list(values::length, 2, 2), says).called(lang::common::a_place);
}
constexpr std::array path_circle_rows{pair_of_lengths("centre", "The circle's centre [x, y]."), values::radius};
constexpr Form path_circle{lang::common::a_circle, path_circle_rows};
constexpr std::array path_line_rows{
    pair_of_lengths("from", "Where s = 0: [x, y]."),
    FormRow("along", "…", values::json(R"("type": ["number", "string", "array"])"), "An angle or [dx, dy].")
        .needed(lang::point_motion::its_direction_an_angle_or_dx)};
constexpr Form path_line{lang::common::a_line, path_line_rows};
constexpr std::array path_rows{
    law_row("y").one_of(),
    FormRow("circle", "{…}", values::object(path_circle), "A circle.")
        .one_of()
        .called(lang::point_motion::centre_x_y_radius),
    FormRow("line", "{…}", values::object(path_line), "A straight line.")
        .one_of()
        .called(lang::point_motion::from_x_y_along_x),
    FormRow("start", "…", values::number_or_text, "Where s = 0: x of a curve, an angle of a circle. Default: 0.")};
constexpr Form path_form{lang::point_motion::a_path, path_rows, "What the point moves along; s is its law."};
constexpr std::array point_motion_rows{
    FormRow("point", "P", values::some_text, "The point's name. Default: P.")
        .called(lang::point_motion::the_point_name),
    law_row("x").one_of(),
    law_row("y"),
    law_row("r").one_of(),
    law_row("theta"),
    FormRow("path", "{…}", values::object(path_form)).one_of().called(lang::point_motion::y_circle_or_line),
    law_row("s"),
    FormRow("at", "t", values::time, "The instant.").needed(lang::point_motion::the_instant_that_is_looked),
    FormRow("from", "t", values::time, "Where the interval begins. Default: 0 s."),
    FormRow("to", "t", values::time, "Where the interval ends.").needed(lang::point_motion::the_time_up),
    FormRow("constants", "{…}", values::map(values::number_or_text), "Name → number, quantity or formula.")
        .called(lang::laws::an_object_of_constants_by_name)};
constexpr Form point_motion_form{lang::point_motion::the_motion_of_a_point, point_motion_rows,
                                 "The motion of a point by its laws in time, instead of all else."};

const Words& an_expression() {
    static const Words wanted(lang::point_motion::an_expression_in_t_as_v0);
    return wanted;
}

/// A quantity in a compound unit without a name, "2 m/s^3", "0.4 1/s", as a formula: "= 2*(1 m)/(1 s)^3". Empty for any
/// other text.
std::optional<std::string> with_unit_put_together(std::string_view text) {
    const std::size_t space = text.find(' ');
    if (space == std::string_view::npos || is_formula(text)) return std::nullopt;
    constexpr auto spelt = std::to_array<std::pair<std::string_view, std::string_view>>(
        {{"²", "^2"}, {"³", "^3"}, {"·", "*"}, {" ", "*"}});
    std::string formula = "= " + std::string(text.substr(0, space)) + "*";
    std::string_view rest = text.substr(space + 1);
    while (!rest.empty()) {
        const auto* const other =
            std::find_if(spelt.begin(), spelt.end(), [&](const auto& each) { return rest.starts_with(each.first); });
        const auto letters = static_cast<std::size_t>(
            std::find_if_not(rest.begin(), rest.end(), [](unsigned char c) { return std::isalpha(c) != 0; }) -
            rest.begin());
        if (other != spelt.end()) {
            formula += other->second;
            rest.remove_prefix(other->first.size());
        } else if (letters > 0) {
            formula += "(1 " + std::string(rest.substr(0, letters)) + ")";
            rest.remove_prefix(letters);
        } else if (std::string_view("0123456789/*^-()").find(rest.front()) != std::string_view::npos) {
            formula += rest.front();
            rest.remove_prefix(1);
        } else {
            return std::nullopt;
        }
    }
    return formula;
}

/// The "constants" of the laws of a point's motion, by name: numbers, quantities of any dimension, formulas of
/// earlier constants.
class LawConstants {
public:
    explicit LawConstants(FormReader& file) : file_(file) {}

    void read(JsonValue member);
    /// A constant or a parameter of the file; an error without words has already been reported. `variable`: what else
    /// an expression may name, for the remedy.
    tl::expected<Measured, Words> look_up(std::string_view name, std::string_view variable);

private:
    std::optional<Measured> read_one(JsonValue member);

    FormReader& file_;
    std::vector<std::pair<std::string_view, std::optional<Measured>>> constants_;  ///< none: faulty
};

void LawConstants::read(JsonValue member) {
    std::optional<Measured> value;
    if (!is_parameter_name(member.key()) || member.key() == "t" || member.key() == "x" ||
        elementary_called(member.key()))
        file_.fault(member, {lang::laws::can_be_no_constant_name, quoted(member.key())});
    else if (file_.has_parameter(member.key()))
        file_.fault(member, {lang::laws::is_a_parameter_already_rename, quoted(member.key())});
    else
        value = read_one(member);
    constants_.emplace_back(member.key(), std::move(value));
}

std::optional<Measured> LawConstants::read_one(JsonValue member) {
    if (!FormReader::is_numeric(member) && !member.is_string()) {
        file_.wrong(member, {lang::laws::a_number_a_quantity_as_20});
        return std::nullopt;
    }
    const auto known = [this](std::string_view name) { return look_up(name, "t"); };
    auto value = read_measured(member.text(), known);
    if (!value && member.is_string())
        if (const auto formula = with_unit_put_together(member.text()))
            if (auto read = read_measured(*formula, known)) value = std::move(read);
    if (value && member.is_string() && !is_formula(member.text()) && value->is_bare)
        value = tl::make_unexpected(Words(lang::common::has_no_unit, quoted(member.text())));
    if (value) return *std::move(value);
    if (!value.error().empty()) file_.fault(member, std::move(value.error()));
    return std::nullopt;
}

tl::expected<Measured, Words> LawConstants::look_up(std::string_view name, std::string_view variable) {
    const auto found =
        std::find_if(constants_.begin(), constants_.end(), [&](const auto& each) { return each.first == name; });
    if (found != constants_.end()) {
        if (!found->second) return tl::make_unexpected(Words());
        return *found->second;
    }
    if (file_.has_parameter(name)) {
        auto value = file_.look_up_parameter(name);
        if (value) file_.note(*value);
        return value;
    }
    std::vector<std::string_view> known(file_.parameter_names());
    for (const auto& each : constants_) known.push_back(each.first);
    known.push_back(variable);
    return tl::make_unexpected(
        Words(lang::laws::no_constant_is_named_give, quoted(name), did_you_mean(file_.speller().nearest(name, known))));
}

/// The "motion" of a point: its laws as expressions in t, along axes, by radius and angle, or along a path.
class PointMotionSection {
public:
    explicit PointMotionSection(FormReader& file) : file_(file), constants_(file) {}

    std::optional<PointProblem> read(JsonValue section);

private:
    void read_laws(const Members& form, PointProblem& problem);
    StatedLaw read_law(JsonValue value, const std::string& symbol, QuantityKind of, QuantityKind is,
                       NamedConstants& constants);
    void read_path(const Members& form, PointProblem& problem);
    /// An angle or a vector: these problems have no points to define a direction.
    Vector own_direction(JsonValue value);
    void read_times(const Members& form, PointProblem& problem);

    FormReader& file_;
    LawConstants constants_;
};

std::optional<PointProblem> PointMotionSection::read(JsonValue section) {
    const Members form = file_.members(section, point_motion_form);
    PointProblem problem;
    problem.where = section.pointer();
    problem.point = form["point"] ? form.name("point") : "P";
    form.each("constants", [&](JsonValue member) { constants_.read(member); });
    read_laws(form, problem);
    read_times(form, problem);
    return problem;
}

void PointMotionSection::read_laws(const Members& form, PointProblem& problem) {
    const JsonValue leading = form.one_of();
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
        if (const Members path = form.form("path")) read_path(path, problem);
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

void PointMotionSection::read_path(const Members& form, PointProblem& problem) {
    const JsonValue kind = form.one_of();
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
        const Members circle = form.form("circle");
        if (!circle) return;
        path.centre = circle.vector("centre").value_or(Vector{});
        path.radius = circle.quantity_or_default("radius");
        problem.path = path;
    } else {
        if (start) file_.fault(start, {lang::point_motion::a_line_starts});
        const Members line = form.form("line");
        if (!line) return;
        LinePath path;
        path.from = line.vector("from").value_or(Vector{});
        path.direction = own_direction(line.value("along"));
        problem.path = path;
    }
}

Vector PointMotionSection::own_direction(JsonValue value) {
    if (value && value.is_array()) return file_.sense(value).value_or(Vector{1, 0});
    if (const auto given = file_.angle(value)) return direction_of(*given, 100);
    return {1, 0};
}

void PointMotionSection::read_times(const Members& form, PointProblem& problem) {
    problem.at = form.quantity_or_default("at");
    problem.from = form.quantity_or_default("from");
    problem.to = form.quantity_or_default("to");
    const JsonValue at = form["at"], to = form["to"];
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

}  // namespace

constinit const FormValue point_motion_section = values::object(point_motion_form);

bool is_point_motion(JsonValue motion) {
    if (!motion || !motion.is_object() || motion["body"] || motion["velocities"]) return false;
    return motion["point"] ||
           std::any_of(law_keys.begin(), law_keys.end(), [&](std::string_view key) { return bool(motion[key]); });
}

std::any read_point_motion(FormReader& file, Mechanism&, JsonValue section) {
    if (!file.expect(section, JsonValue::Kind::object, {lang::common::an_object})) return {};
    auto problem = PointMotionSection(file).read(section);
    return problem ? std::any(*std::move(problem)) : std::any();
}

}  // namespace kinegraph
