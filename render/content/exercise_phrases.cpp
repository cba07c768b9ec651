#include "render/content/exercise_phrases.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>
#include <variant>

#include "engine/number/functions.hpp"
#include "engine/results/result_names.hpp"
#include "engine/solution/sliding.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/data.hpp"
#include "lang/keys/sheet.hpp"
#include "render/mechanism/sketch.hpp"
#include "render/text/bound_blank.hpp"

namespace kinegraph::render {

RichText ExercisePhrases::name(PointIndex point) const {
    return typeset(Symbol{Symbol::Letter::point, mechanism_.point(point).name, ""}, language());
}

RichText ExercisePhrases::number_of(double value) const {
    return with_powers(drawing::given_number(value, language()));
}

RichText ExercisePhrases::ratio(const Exact& value) const {
    constexpr int longest = 30;
    for (int below = 3; below <= longest; ++below) {
        int rest = below;
        while (rest % 2 == 0) rest /= 2;
        while (rest % 5 == 0) rest /= 5;
        const double above = value.to_double() * below;
        const bool is_lowest = std::gcd(std::lround(above), static_cast<long>(below)) == 1;
        if (rest == 1 || !is_lowest || std::abs(above) > 100 || !(value == Exact::ratio(std::lround(above), below)))
            continue;
        return one_piece((above < 0 ? "−" : "") + std::to_string(std::lround(std::abs(above))) + "/" +
                         std::to_string(below));
    }
    return number_of(value.to_double());
}

RichText ExercisePhrases::angle(const Angle& angle) const {
    RichText text = number_of(angle.value.to_double());
    append(text, angle.in_degrees ? "°" : with_unit("", "rad"));
    return text;
}

RichText ExercisePhrases::pair(double x, double y) const {
    RichText text = one_piece("(");
    append(text, number_of(x));
    append(text, bound(notation(language()).between_numbers));
    append(text, number_of(y));
    append(text, ")");
    return text;
}

RichText ExercisePhrases::vector(const Vector& si, const Unit& unit) const {
    RichText text = pair((si.x / unit.si).to_double(), (si.y / unit.si).to_double());
    append(text, with_powers(with_unit("", unit.symbol)));
    return text;
}

RichText ExercisePhrases::join(PointIndex from, PointIndex to) const {
    RichText text = name(from);
    append(text, name(to));
    return text;
}

RichText ExercisePhrases::bearing(const Bearing& bearing) const {
    if (const auto* as_angle = std::get_if<Angle>(&bearing.form)) return angle(*as_angle);
    if (const auto* between = std::get_if<Bearing::Between>(&bearing.form)) return join(between->from, between->to);
    const auto& along = std::get<Vector>(bearing.form);
    return pair(along.x.to_double(), along.y.to_double());
}

RichText ExercisePhrases::place(const kinegraph::Place& place) const {
    if (const auto* point = std::get_if<PointIndex>(&place)) return name(*point);
    return vector(std::get<Vector>(place), units_.length);
}

RichText ExercisePhrases::equation(RichText left, const RichText& right) {
    append(left, one_piece(" = "));
    append(left, right);
    return left;
}

RichText ExercisePhrases::direction(const Bearing& of) const {
    return std::holds_alternative<Bearing::Between>(of.form) ? bearing(of)
                                                             : filled(lang::data::the_direction, {bearing(of)});
}

std::string ExercisePhrases::listed(BodyIndex body) const {
    if (const std::string* bar = name_of_bar(solution_, body)) return *bar;
    return body == frame ? word(lang::common::frame, language()) : mechanism_.body(body).name;
}

RichText ExercisePhrases::subject(BodyIndex body) const {
    if (const std::string* bar = name_of_bar(solution_, body))
        return filled(lang::data::the_bar, {one_piece(*bar, Face::italic)});
    return called(body, lang::data::the_frame, lang::data::the_body);
}

RichText ExercisePhrases::owner(BodyIndex body) const {
    if (const std::string* bar = name_of_bar(solution_, body))
        return filled(lang::data::of_the_bar, {one_piece(*bar, Face::italic)});
    return called(body, lang::data::of_the_frame, lang::data::of_the_body);
}

RichText ExercisePhrases::called(BodyIndex body, Key as_frame, Key as_body) const {
    return body == frame ? filled(as_frame, {}) : filled(as_body, {plain_words(mechanism_.body(body).name)});
}

RichText ExercisePhrases::way(const Bearing& of) const {
    return std::holds_alternative<Vector>(of.form) ? direction(of) : bearing(of);
}

RichText ExercisePhrases::course(const Bearing& of) const {
    return filled(std::holds_alternative<Angle>(of.form) ? lang::sheet::along_an_angle : lang::sheet::along_a_line,
                  {way(of)});
}

RichText ExercisePhrases::letter(Symbol::Letter letter, const std::string& about, const std::string& term) const {
    RichText text = typeset(Symbol{letter, about, term}, language());
    for (Piece& piece : text)
        if (piece.face == Face::bold_italic) piece.face = Face::italic;
    return text;
}

RichText ExercisePhrases::symbol_of_force(const std::string& given, Symbol::Letter letter) const {
    return typeset(Symbol{letter, given, ""}, language());
}

std::string ExercisePhrases::bar(BodyIndex body) const {
    if (solution_.truss)
        for (const TrussStructure::Bar& each : solution_.truss->structure.bars)
            if (each.body == body) return each.name;
    return mechanism_.body(body).name;
}

RichText ExercisePhrases::positive_sense(JointIndex index) const {
    const Joint& joint = mechanism_.joint(index);
    if (joint.along && std::holds_alternative<Bearing::Between>(joint.along->form)) return positive_sense(*joint.along);
    const VectorOf<double> way = direction_of_sliding(solution_.pose, index);
    const double degrees = std::round(nearest::atan2(way.y, way.x) * 1800 / std::numbers::pi) / 10;
    RichText angle = number_of(degrees == 0 ? 0 : degrees);
    append(angle, "°");
    return filled(lang::sheet::positive_along, {angle});
}

RichText ExercisePhrases::positive_sense(const Bearing& of) const {
    if (const auto* between = std::get_if<Bearing::Between>(&of.form))
        return filled(lang::sheet::positive_from, {name(between->from), name(between->to)});
    return filled(lang::sheet::positive_along, {way(of)});
}

RichText ExercisePhrases::acting_on(BodyIndex body) const {
    return called(body, lang::sheet::on_the_frame, lang::sheet::on_the_body);
}
RichText ExercisePhrases::acting_from(BodyIndex body) const {
    return called(body, lang::sheet::from_the_frame, lang::sheet::from_the_body);
}

}  // namespace kinegraph::render
