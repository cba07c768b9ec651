// The motion of a point and positions of a body, read.
#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "engine/pose.hpp"
#include "engine/problem_reader.hpp"

namespace kinegraph {
namespace {

constexpr std::array<std::string_view, 6> law_keys{"x", "y", "r", "theta", "path", "s"};

/// "5.657 mm", with the comma in Italian.
Words length_words(double si, const KnownUnit& unit) {
    std::array<char, 40> text{};
    constexpr int digits = 6;
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), si / unit.si.to_double(), std::chars_format::general, digits).ptr;
    std::string value(text.data(), end);
    value += " " + std::string(unit.symbol);
    std::string with_comma = value;
    std::replace(with_comma.begin(), with_comma.end(), '.', ',');
    return {value, with_comma};
}

/// A quantity whose unit is no one's own, "2 m/s^3", "0.4 1/s", as a formula: "= 2*(1 m)/(1 s)^3". Nothing where it is no such
/// thing.
std::optional<std::string> with_unit_put_together(std::string_view text) {
    const std::size_t space = text.find(' ');
    if (space == std::string_view::npos || is_formula(text)) return std::nullopt;
    constexpr auto spelt =
        std::to_array<std::pair<std::string_view, std::string_view>>({{"²", "^2"}, {"³", "^3"}, {"·", "*"}, {" ", "*"}});
    std::string formula = "= " + std::string(text.substr(0, space)) + "*";
    std::string_view rest = text.substr(space + 1);
    while (!rest.empty()) {
        const auto* const other =
            std::find_if(spelt.begin(), spelt.end(), [&](const auto& each) { return rest.starts_with(each.first); });
        const auto letters = static_cast<std::size_t>(
            std::find_if_not(rest.begin(), rest.end(), [](unsigned char c) { return std::isalpha(c) != 0; }) - rest.begin());
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

const Words& an_expression() {
    static const Words wanted("an expression in t, as \"v0*t\"", "un’espressione in t, come \"v0*t\"");
    return wanted;
}

}  // namespace

bool ProblemReader::is_motion_of_a_point(JsonValue motion) {
    if (!motion || !motion.is_object() || motion["body"] || motion["velocities"]) return false;
    return motion["point"] ||
           std::any_of(law_keys.begin(), law_keys.end(), [&](std::string_view key) { return bool(motion[key]); });
}

// ----- the motion of a point

tl::expected<Measured, Words> ProblemReader::look_up_constant(std::string_view name) {
    const auto found =
        std::find_if(law_constants_.begin(), law_constants_.end(), [&](const auto& each) { return each.first == name; });
    if (found != law_constants_.end()) {
        if (!found->second) return tl::make_unexpected(Words());
        return *found->second;
    }
    if (parameters_.contains(name)) return look_up_parameter(name);
    std::vector<std::string_view> known(parameter_names_);
    for (const auto& each : law_constants_) known.push_back(each.first);
    known.push_back(law_variable_);
    return tl::make_unexpected(Words("no constant is named {0}{1}; give it in \"constants\"",
                                     "nessuna costante si chiama {0}{1}; assegnarla in \"constants\"", quoted(name),
                                     did_you_mean(speller_.nearest(name, known))));
}

void ProblemReader::read_constants(JsonValue constants) {
    if (!constants || !expect(constants, Kind::object, {"an object of constants by name", "un oggetto con le costanti per nome"}))
        return;
    for (const JsonValue member : constants) {
        std::optional<Measured> value;
        if (!is_parameter_name(member.key()) || member.key() == "t" || member.key() == "x" || elementary_called(member.key()))
            fault(
                member,
                {"{0} can be no constant’s name: a letter, then letters, digits and _; not t, x, pi nor a function",
                 "{0} non può essere il nome di una costante: una lettera, poi lettere, cifre e _; non t, x, pi né una funzione",
                 quoted(member.key())});
        else if (parameters_.contains(member.key()))
            fault(member, {"{0} is a parameter already; rename one of them", "{0} è già un parametro; rinominare uno dei due",
                           quoted(member.key())});
        else
            value = read_constant(member);
        law_constants_.emplace_back(member.key(), std::move(value));
    }
}

std::optional<Measured> ProblemReader::read_constant(JsonValue member) {
    if (!is_numeric(member) && !member.is_string()) {
        wrong(member,
              {"a number, a quantity as \"20 m/s\" or a formula", "un numero, una grandezza come \"20 m/s\" o una formula"});
        return std::nullopt;
    }
    const auto look_up = [this](std::string_view name) { return look_up_constant(name); };
    auto value = read_measured(member.text(), look_up);
    if (!value && member.is_string())
        if (const auto formula = with_unit_put_together(member.text()))
            if (auto read = read_measured(*formula, look_up)) value = std::move(read);
    if (value && member.is_string() && !is_formula(member.text()) && value->is_bare)
        value = tl::make_unexpected(Words("{0} has no unit; add one, or write the number without quotes",
                                          "{0} non ha unità; aggiungerla, o scrivere il numero senza virgolette",
                                          quoted(member.text())));
    if (value) return *std::move(value);
    if (!value.error().empty()) fault(member, std::move(value.error()));
    return std::nullopt;
}

StatedLaw ProblemReader::read_law(JsonValue value, const std::string& symbol, QuantityKind of, QuantityKind is,
                                  NamedConstants& constants) {
    StatedLaw law;
    law.symbol = symbol;
    if (!value) return law;
    law.where = value.pointer();
    if (!value.is_string() && !value.is_number()) {
        wrong(value, of == QuantityKind::time ? an_expression()
                                              : Words("an expression in x, as \"x^2/p\"", "un’espressione in x, come \"x^2/p\""));
        return law;
    }
    law.text = value.text();
    law_variable_ = of == QuantityKind::time ? "t" : "x";
    const ExpressionForm form{law_variable_, of, is, bare_unit(QuantityKind::length).si};
    auto read = read_expression(
        law.text, form, [this](std::string_view name) { return look_up_constant(name); }, constants);
    if (read)
        law.law = *std::move(read);
    else if (!read.error().empty())
        fault(value, std::move(read.error()));
    return law;
}

std::optional<PointProblem> ProblemReader::read_point_motion(JsonValue section) {
    const Members form = members(section, {"point", "x", "y", "r", "theta", "path", "s", "at", "from", "to", "constants"},
                                 {"the motion of a point", "il moto di un punto"});
    PointProblem problem;
    problem.where = section.pointer();
    problem.point = "P";
    if (form["point"]) problem.point = new_name(form["point"], {"the point’s name", "il nome del punto"});
    read_constants(form["constants"]);
    read_laws(form, problem);
    read_times(form, problem);
    return problem;
}

void ProblemReader::read_laws(const Members& form, PointProblem& problem) {
    const JsonValue leading = one_of(form, {"x", "r", "path"});
    if (!leading) return;
    const auto alone = [&](std::initializer_list<std::string_view> others) {
        for (const std::string_view key : others)
            if (form[key])
                fault(form[key], {"{0} and {1} do not go together; take one of them out",
                                  "{0} e {1} non stanno insieme; toglierne una", quoted(key), quoted(leading.key())});
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
        law(required(form, "theta", {"the angle of the radius, an expression in t", "l’angolo del raggio, un’espressione in t"}),
            "θ", QuantityKind::angle);
    } else {
        problem.form = PointProblem::Form::path;
        alone({"y", "theta"});
        read_path(leading, problem);
        law(required(form, "s", {"the way along the path, an expression in t", "l’ascissa curvilinea, un’espressione in t"}), "s",
            QuantityKind::length);
    }
}

void ProblemReader::read_path(JsonValue value, PointProblem& problem) {
    if (!expect(value, Kind::object,
                {"{\"y\": …}, {\"circle\": …} or {\"line\": …}", "{\"y\": …}, {\"circle\": …} o {\"line\": …}"}))
        return;
    const Members form = members(value, {"y", "circle", "line", "start"}, {"a path", "una traiettoria"});
    const JsonValue kind = one_of(form, {"y", "circle", "line"});
    if (!kind) return;
    const JsonValue start = form["start"];
    if (kind.key() == "y") {
        GraphPath path;
        path.f = read_law(kind, "f", QuantityKind::length, QuantityKind::length, problem.constants);
        if (start) path.start = quantity_or_zero(start, QuantityKind::length);
        problem.path = std::move(path);
    } else if (kind.key() == "circle") {
        CirclePath path;
        if (start) path.start = quantity_or_zero(start, QuantityKind::angle);
        if (!expect(kind, Kind::object, {"{\"centre\": [x, y], \"radius\": …}", "{\"centre\": [x, y], \"radius\": …}"})) return;
        const Members circle = members(kind, {"centre", "radius"}, {"a circle", "una circonferenza"});
        path.centre = vector(circle["centre"], QuantityKind::length, {"a place [x, y]", "un luogo [x, y]"}).value_or(Vector{});
        path.radius = positive(required(circle, "radius", {"the circle's radius", "il raggio della circonferenza"}),
                               QuantityKind::length, {"a radius", "un raggio"});
        problem.path = path;
    } else {
        if (start)
            fault(start,
                  {"a line starts where it is \"from\"; take \"start\" out", "una retta parte da \"from\"; togliere \"start\""});
        if (!expect(kind, Kind::object, {"{\"from\": [x, y], \"along\": X}", "{\"from\": [x, y], \"along\": X}"})) return;
        const Members line = members(kind, {"from", "along"}, {"a line", "una retta"});
        LinePath path;
        path.from = vector(line["from"], QuantityKind::length, {"a place [x, y]", "un luogo [x, y]"}).value_or(Vector{});
        path.direction = own_direction(
            required(line, "along", {"its direction, an angle or [dx, dy]", "la sua direzione, un angolo o [dx, dy]"}));
        problem.path = path;
    }
}

Vector ProblemReader::own_direction(JsonValue value) {
    if (value && value.is_array()) return sense(value).value_or(Vector{1, 0});
    if (const auto given = angle(value)) return direction_of(*given, 100);
    return {1, 0};
}

void ProblemReader::read_times(const Members& form, PointProblem& problem) {
    const JsonValue at = required(form, "at", {"the instant that is looked at, a time", "l’istante considerato, un tempo"});
    const JsonValue to =
        required(form, "to", {"the time up to which the motion is followed", "il tempo fino al quale si segue il moto"});
    problem.at = quantity_or_zero(at, QuantityKind::time);
    problem.from = form["from"] ? quantity_or_zero(form["from"], QuantityKind::time) : Exact();
    problem.to = quantity_or_zero(to, QuantityKind::time);
    if (!at || !to) return;
    problem.where_at = at.pointer();
    problem.where_from = form["from"] ? form["from"].pointer() : to.pointer();
    if (problem.from >= problem.to) {
        fault(to, {"the interval must end after it begins; \"to\" is later than \"from\"",
                   "l’intervallo deve finire dopo il suo inizio; \"to\" è dopo \"from\""});
        return;
    }
    if (problem.at < problem.from || problem.at > problem.to)
        fault(at, {"the instant lies outside \"from\" … \"to\"; move it, or widen the interval",
                   "l’istante è fuori da \"from\" … \"to\"; spostarlo, o allargare l’intervallo"});
}

// ----- positions of a body

std::optional<PositionsProblem> ProblemReader::read_positions(JsonValue section) {
    const Words wanted("two or three positions {\"A\": [x, y], \"B\": [x, y]}",
                       "due o tre posizioni {\"A\": [x, y], \"B\": [x, y]}");
    if (section.size() != 2 && section.size() != 3) {
        fault(section, {"two positions of a body, or three; {0} are given", "due posizioni di un corpo, o tre; ne sono date {0}",
                        std::to_string(section.size())});
        return std::nullopt;
    }
    PositionsProblem problem;
    problem.where = section.pointer();
    const std::size_t before = faults_.size();
    for (const JsonValue position : section) {
        if (!expect(position, Kind::object, wanted)) return std::nullopt;
        if (problem.positions.empty()) {
            if (position.size() != 2) {
                fault(position,
                      {"the first position gives the places of two points; {0} are given",
                       "la prima posizione dà i luoghi di due punti; ne sono dati {0}", std::to_string(position.size())});
                return std::nullopt;
            }
            std::size_t i = 0;
            for (const JsonValue place : position) {
                check_name(place, place.key());
                problem.points.at(i++) = place.key();
            }
        }
        read_position(position, problem);
    }
    if (faults_.size() > before) return std::nullopt;
    return problem;
}

void ProblemReader::read_position(JsonValue value, PositionsProblem& problem) {
    const bool first = problem.positions.empty();
    const Members form = first
                             ? members(value, {problem.points[0], problem.points[1]}, {"a position", "una posizione"})
                             : members(value, {problem.points[0], problem.points[1], "turned"}, {"a position", "una posizione"});
    PositionsProblem::Position position;
    position.where = value.pointer();
    const Words place("a place [x, y]", "un luogo [x, y]");
    position.places[0] = vector(required(form, problem.points[0], place), QuantityKind::length, place).value_or(Vector{});
    const JsonValue second = first ? required(form, problem.points[1], place) : one_of(form, {problem.points[1], "turned"});
    if (!second) return;
    if (second.key() == "turned" && !first) {
        const auto& start = problem.positions[0].places;
        const auto turned = angle(second);
        if (!turned) return;
        // The square of the direction of half the angle is a unit vector, exactly.
        const Vector half = direction_of(Angle{turned->value / 2, turned->in_degrees}, 100);
        const Exact size = squared_length(half);
        const Exact cosine = (square(half.x) - square(half.y)) / size, sine = 2 * half.x * half.y / size;
        const Vector arm = start[1] - start[0];
        position.places[1] = position.places[0] + Vector{cosine * arm.x - sine * arm.y, sine * arm.x + cosine * arm.y};
    } else {
        position.places[1] = vector(second, QuantityKind::length, place).value_or(Vector{});
        if (!first) keep_distance(second, problem, position);
    }
    if (first && position.places[0] == position.places[1])
        fault(value,
              {"both points lie at the same place; they must lie apart", "i due punti coincidono; devono essere distinti"});
    problem.positions.push_back(std::move(position));
}

void ProblemReader::keep_distance(JsonValue at, const PositionsProblem& problem, PositionsProblem::Position& position) {
    const auto& start = problem.positions[0].places;
    const Exact wanted = squared_length(start[1] - start[0]);
    const Vector arm = position.places[1] - position.places[0];
    if (squared_length(arm) == wanted || wanted.is_zero()) return;
    constexpr double rounded_away = 1e-3;
    const double here = length(arm), there = length(start[1] - start[0]);
    if (arm.is_zero() || std::abs(here - there) > rounded_away * there) {
        const KnownUnit& unit = bare_unit(QuantityKind::length);
        const auto said = [&](double si) { return length_words(si, unit); };
        fault(
            at,
            {"a rigid body keeps distances: here {0} and {1} are {2} apart, in the first position {3}; correct one, or give \"turned\"",
             "un corpo rigido conserva le distanze: qui {0} e {1} distano {2}, nella prima posizione {3}; correggere, o dare \"turned\"",
             problem.points[0], problem.points[1], said(here), said(there)});
        return;
    }
    position.places[1] = position.places[0] + square_root(wanted / squared_length(arm), 200).value * arm;
    position.moved = std::abs(here - there);
}

}  // namespace kinegraph
