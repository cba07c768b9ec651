#include "engine/reading/form_reader.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/forms.hpp"
#include "lang/keys/notation.hpp"

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace kinegraph {

// ----- faults and forms

void FormReader::fault(JsonValue at, Words message) {
    faults_.emplace_back(at.order(), Error{ErrorCode::bad_input, at.pointer(), std::move(message)});
}

void FormReader::wrong(JsonValue value, const Words& wanted) {
    fault(value, {lang::forms::is_wanted_here_not, wanted, described(value)});
}

bool FormReader::expect(JsonValue value, Kind kind, const Words& wanted) {
    if (value.kind() == kind) return true;
    wrong(value, wanted);
    return false;
}

Members FormReader::members(JsonValue object, std::span<const std::string_view> known, const Words& form) {
    Members result;
    result.object_ = object;
    for (const JsonValue member : object) {
        if (std::find(known.begin(), known.end(), member.key()) != known.end()) {
            if (!result[member.key()]) result.known_.push_back(member);
            continue;
        }
        const auto meant = speller_.nearest(member.key(), known);
        Words message(lang::forms::unknown_key, quoted(member.key()));
        if (meant) {
            message += did_you_mean(meant);
            result.misspelt_.push_back(*meant);
        } else {
            message += Words(lang::forms::the_keys, form, listed(known));
        }
        fault(member, std::move(message));
    }
    return result;
}

Members FormReader::members(JsonValue object, const Form& form) {
    std::vector<std::string_view> keys;
    for (const FormRow& row : form.rows) keys.push_back(row.key);
    keys.insert(keys.end(), form.others.begin(), form.others.end());
    Members result = members(object, keys, {form.called, form.rows.front().key});
    result.file_ = this;
    result.form_ = &form;
    return result;
}

JsonValue FormReader::required(const Members& of, std::string_view key, const Words& meaning) {
    if (of[key]) return of[key];
    if (!of.has_or_misspells(key)) fault(of.object_, {lang::forms::is_missing, key, meaning});
    return {};
}

void FormReader::not_together(JsonValue at, std::string_view other) {
    fault(at, {lang::forms::and_do_not_go_together_take, quoted(at.key()), quoted(other)});
}

JsonValue FormReader::one_of(const Members& of, std::span<const std::string_view> keys, bool needed) {
    JsonValue only;
    for (const std::string_view key : keys) {
        if (!of[key]) continue;
        if (only) {
            const JsonValue later = only.order() < of[key].order() ? of[key] : only;
            const JsonValue earlier = only.order() < of[key].order() ? only : of[key];
            not_together(later, earlier.key());
            return {};
        }
        only = of[key];
    }
    const bool misspelt =
        std::any_of(keys.begin(), keys.end(), [&](std::string_view key) { return of.has_or_misspells(key); });
    if (!only && needed && !misspelt) {
        fault(of.object_, {lang::forms::one_of_is_missing, listed(keys)});
    }
    return only;
}

// ----- names

void FormReader::check_name(JsonValue at, std::string_view name) {
    if (name.empty()) {
        fault(at, {lang::forms::a_name_must_not_be_empty});
    } else if (name.find(',') != std::string_view::npos) {
        fault(at, {lang::forms::the_name_has_a_comma_names, quoted(name)});
    } else if (name.find(" on ") != std::string_view::npos) {
        fault(at, {lang::forms::the_name, quoted(name)});
    } else if (has_control_character(name, true)) {
        fault(at, {lang::forms::the_name_has_a_control_character, quoted(name)});
    }
}

std::string FormReader::new_name(JsonValue value, const Words& wanted) {
    if (!expect(value, Kind::string, wanted)) return {};
    check_name(value, value.text());
    return std::string(value.text());
}

bool FormReader::add_point(std::string_view name) {
    if (!points_by_name_.emplace(name, PointIndex(point_names_.size())).second) return false;
    point_names_.push_back(name);
    return true;
}

bool FormReader::add_body(std::string_view name) {
    if (!bodies_by_name_.emplace(name, BodyIndex(body_names_.size())).second) return false;
    body_names_.push_back(name);
    return true;
}

PointIndex FormReader::look_up_point(JsonValue at, std::string_view name) {
    const auto found = points_by_name_.find(name);
    if (found != points_by_name_.end()) {
        if (collected_ != nullptr) collected_->push_back(found->second);
        return found->second;
    }
    if (points_known_)
        fault(at, {lang::forms::no_point_is_named, quoted(name), did_you_mean(speller_.nearest(name, point_names_))});
    return none;
}

PointIndex FormReader::point(JsonValue value, bool in_array) {
    if (!value) return none;
    if (value.is_string() || (in_array && is_whole_number(value))) return look_up_point(value, value.text());
    wrong(value, {lang::forms::a_point_name});
    return none;
}

BodyIndex FormReader::look_up_body(JsonValue at, std::string_view name) {
    const auto found = bodies_by_name_.find(name);
    if (found != bodies_by_name_.end()) return found->second;
    if (bodies_known_)
        fault(at, {lang::forms::no_body_is_named, quoted(name), did_you_mean(speller_.nearest(name, body_names_))});
    return none;
}

BodyIndex FormReader::body(JsonValue value) {
    if (!value) return none;
    if (value.is_string() || is_whole_number(value)) return look_up_body(value, value.text());
    wrong(value, {lang::common::a_name_of_a_body});
    return none;
}

BodyIndex FormReader::moving_body(JsonValue value, const Words& why) {
    const BodyIndex found = body(value);
    if (found == frame) fault(value, why);
    return found;
}

Words FormReader::words(JsonValue value) {
    const auto line = [&](JsonValue text) -> std::string {
        if (!expect(text, Kind::string, {lang::common::a_text})) return {};
        if (has_control_character(text.text(), false))
            fault(text, {lang::forms::a_control_character_cannot_be_drawn, quoted(text.text())});
        std::string clean(text.text());
        std::replace_if(
            clean.begin(), clean.end(), [](char c) { return c == '\t' || c == '\n' || c == '\r'; }, ' ');
        return clean;
    };
    Words result;
    if (value.is_string()) {
        result = line(value);
    } else if (value.is_object()) {
        std::vector<std::string_view> codes;
        for (const Language language : languages) codes.push_back(lang::notation::code.in(language));
        const Members by_language = members(value, codes, {lang::forms::a_text_in_several_languages});
        // A language that lacks it takes the first of the others.
        std::string otherwise;
        Text text;
        for (std::size_t i = codes.size(); i-- > 0;)
            if (by_language[codes[i]]) otherwise = text.by_language.at(i) = line(by_language[codes[i]]);
        require_a_language(by_language);
        for (std::size_t i = 0; i < codes.size(); ++i)
            if (!by_language[codes[i]]) text.by_language.at(i) = otherwise;
        result = text;
    } else {
        std::string each;
        for (const Language language : languages) each += (each.empty() ? "{\"" : ", \"") + code_of(language) + "\": …";
        wrong(value, {lang::forms::a_text_or_one_of_each_language, each + "}"});
    }
    return result;
}

void FormReader::require_a_language(const Members& by_language) {
    const bool has_one = std::any_of(languages.begin(), languages.end(), [&](Language language) {
        return by_language.has_or_misspells(lang::notation::code.in(language));
    });
    if (has_one) return;
    std::string codes;
    for (const Language language : languages) codes += (codes.empty() ? "\"" : ", \"") + code_of(language) + "\"";
    fault(by_language.object_, {lang::forms::no_language_is_given, codes});
}

// ----- parameters

void FormReader::read_parameters(JsonValue parameters, std::span<const Setting> set) {
    if (parameters && !expect(parameters, Kind::object, {lang::forms::an_object_of_parameters_by_name})) return;
    if (parameters) {
        for (const JsonValue member : parameters) {
            if (!is_parameter_name(member.key()))
                fault(member, {lang::forms::can_be_no_parameter_name, quoted(member.key())});
            if (parameters_.try_emplace(member.key(), Parameter{.at = member, .set = {}}).second)
                parameter_names_.push_back(member.key());
        }
    }
    for (const Setting& setting : set) {
        const auto found = parameters_.find(setting.name);
        if (found == parameters_.end()) {
            faults_.emplace_back(0, Error{ErrorCode::bad_input,
                                          {},
                                          {lang::forms::set_the_file_has_no_parameter, quoted(setting.name),
                                           did_you_mean(speller_.nearest(setting.name, parameter_names_))}});
        } else {
            found->second.set = setting.value;
        }
    }
    for (const std::string_view name : parameter_names_)
        if (Parameter& parameter = parameters_.at(name); parameter.state == Parameter::State::unread)
            read_parameter(name, parameter);
}

void FormReader::read_parameter(std::string_view name, Parameter& parameter) {
    parameter.state = Parameter::State::being_read;
    ++parameters_being_read_;
    Parameter* const outer = std::exchange(being_read_, &parameter);
    const bool of_the_file = parameter.set.empty();
    tl::expected<Measured, Words> value = tl::make_unexpected(Words());
    if (of_the_file && !parameter.at.is_number() && !parameter.at.is_string()) {
        wrong(parameter.at, {lang::common::a_number_a_quantity_or_a_formula});
    } else {
        value = read_measured(of_the_file ? parameter.at.text() : parameter.set,
                              [this](std::string_view other) { return look_up_parameter(other); });
    }
    // "40" is a number in quotes: it lacks its unit, as everywhere in a file.
    if (value && of_the_file && parameter.at.is_string() && !is_formula(parameter.at.text()) && value->is_bare)
        value = tl::make_unexpected(Words(lang::common::has_no_unit, quoted(parameter.at.text())));
    --parameters_being_read_;
    being_read_ = outer;
    parameter.state = value ? Parameter::State::read : Parameter::State::faulty;
    if (value) parameter.value = std::move(*value);
    if (value || value.error().empty()) return;
    fault(parameter.at, of_the_file ? value.error() : Words(lang::forms::set, name, value.error()));
}

tl::expected<Measured, Words> FormReader::look_up_parameter(std::string_view name) {
    constexpr int most_within_each_other = 100;
    const auto found = parameters_.find(name);
    if (found == parameters_.end()) {
        std::vector<std::string_view> known = parameter_names_;
        for (const std::string_view word : formula_words()) known.push_back(word);
        return tl::make_unexpected(
            Words(lang::forms::no_parameter_is_named, quoted(name), did_you_mean(speller_.nearest(name, known))));
    }
    Parameter& parameter = found->second;
    if (being_read_ != nullptr)
        being_read_->uses.push_back(found->first);
    else
        parameter.is_used = true;
    if (parameter.state == Parameter::State::being_read)
        return tl::make_unexpected(Words(lang::forms::the_parameter_is_given_by_itself, quoted(name)));
    if (parameter.state == Parameter::State::unread && parameters_being_read_ > most_within_each_other)
        return tl::make_unexpected(
            Words(lang::forms::more_than_parameters_are_given, std::to_string(most_within_each_other)));
    if (parameter.state == Parameter::State::unread) read_parameter(name, parameter);
    if (parameter.state == Parameter::State::faulty) return tl::make_unexpected(Words());
    return parameter.value;
}

bool FormReader::is_used(std::string_view parameter) const {
    // Backwards from the values that the file uses: every parameter reached is used.
    std::vector<std::string_view> reached;
    for (const auto& [name, each] : parameters_)
        if (each.is_used) reached.push_back(name);
    std::unordered_set<std::string_view> known(reached.begin(), reached.end());
    while (!reached.empty()) {
        const Parameter& each = parameters_.at(reached.back());
        reached.pop_back();
        for (const std::string_view other : each.uses)
            if (known.insert(other).second) reached.push_back(other);
    }
    return known.contains(parameter);
}

// ----- numbers

void FormReader::note(const Measured& value) {
    const Dimension& d = value.dimension;
    comes_to_ += value.value.rational().get_str(36);
    for (const int each : {d.length, d.mass, d.time, d.angle,
                           static_cast<int>(value.is_bare) + 2 * static_cast<int>(value.is_in_radians)})
        comes_to_ += ' ' + std::to_string(each);
    comes_to_ += '\n';
}

std::optional<Measured> FormReader::formula(JsonValue value) {
    auto found = evaluate(value.text(), [this](std::string_view name) { return look_up_parameter(name); });
    if (found) {
        is_approximate_ = is_approximate_ || found->is_approximate;
        note(*found);
        return std::move(*found);
    }
    if (!found.error().empty()) fault(value, std::move(found.error()));
    return std::nullopt;
}

const KnownUnit& FormReader::bare_unit(QuantityKind kind) const {
    const auto set =
        std::find_if(bare_units_.begin(), bare_units_.end(), [&](const KnownUnit* unit) { return unit->kind == kind; });
    return set == bare_units_.end() ? default_unit(kind) : **set;
}

std::optional<WrittenQuantity> FormReader::quantity_as_written(JsonValue value, QuantityKind kind) {
    if (!value) return std::nullopt;
    tl::expected<WrittenQuantity, Words> result = tl::make_unexpected(Words());
    if (value.is_number()) {
        auto number = read_decimal(value.text());
        if (number) {
            result = WrittenQuantity{std::move(*number), &bare_unit(kind)};
        } else {
            result = tl::make_unexpected(std::move(number.error()));
        }
    } else if (value.is_string() && is_formula(value.text())) {
        const auto found = formula(value);
        if (!found) return std::nullopt;
        result = as_quantity(*found, kind, bare_unit(kind));
        if (result && kind == QuantityKind::length) computed_.push_back(result->in_si());
    } else if (value.is_string()) {
        result = read_quantity(value.text(), kind);
        if (result && result->unit->kind != kind) {
            result = tl::make_unexpected(Words(lang::common::is_but_is_wanted, quoted(value.text()),
                                               with_article(result->unit->kind), with_article(kind)));
        }
    } else {
        wrong(value, with_article(kind));
        return std::nullopt;
    }
    if (result && !is_within_range(result->in_si())) {
        result = tl::make_unexpected(Words(lang::common::is_out_of_range, shown(value.text(), 40)));
    }
    if (!result) {
        fault(value, std::move(result.error()));
        return std::nullopt;
    }
    return std::move(*result);
}

std::optional<Exact> FormReader::quantity(JsonValue value, QuantityKind kind) {
    const auto written = quantity_as_written(value, kind);
    if (!written) return std::nullopt;
    return written->in_si();
}

Exact FormReader::quantity_or_zero(JsonValue value, QuantityKind kind) {
    return quantity(value, kind).value_or(Exact());
}

Exact FormReader::positive(JsonValue value, QuantityKind kind, const Words& what) {
    const auto number = quantity(value, kind);
    if (number && number->sign() <= 0) fault(value, {lang::common::must_be_positive, what});
    return number.value_or(Exact(1));
}

std::optional<Exact> FormReader::bare_number(JsonValue value) {
    if (!value || (!is_numeric(value) && !expect(value, Kind::number, {lang::common::a_bare_number})))
        return std::nullopt;
    tl::expected<Exact, Words> number;
    if (value.is_number()) {
        number = read_decimal(value.text());
    } else {
        const auto found = formula(value);
        if (!found) return std::nullopt;
        number = as_number(*found);
    }
    if (number && !is_within_range(*number)) {
        number = tl::make_unexpected(Words(lang::forms::is_outside_1e_60_1e60_where, shown(value.text(), 40)));
    }
    if (!number) {
        fault(value, std::move(number.error()));
        return std::nullopt;
    }
    return std::move(*number);
}

std::optional<Angle> FormReader::angle(JsonValue value) {
    const auto written = quantity_as_written(value, QuantityKind::angle);
    if (!written) return std::nullopt;
    // A turn is 360 degrees exactly.
    if (written->unit->symbol == "rev") return Angle{written->value * 360, true};
    return Angle{written->value, written->unit->symbol == "deg"};
}

std::optional<Vector> FormReader::vector(JsonValue value, QuantityKind kind, const Words& wanted) {
    if (!value) return std::nullopt;
    if (!value.is_array() || value.size() != 2) {
        wrong(value, wanted);
        return std::nullopt;
    }
    const JsonValue first = *value.begin();
    const JsonValue second = *++value.begin();
    const bool bare = kind == QuantityKind::dimensionless;
    auto x = bare ? bare_number(first) : quantity(first, kind);
    auto y = bare ? bare_number(second) : quantity(second, kind);
    if (!x || !y) return std::nullopt;
    return Vector{std::move(*x), std::move(*y)};
}

std::optional<Vector> FormReader::sense(JsonValue value) {
    // Two points are a direction elsewhere: numbers are wanted, but of a vector.
    if (value && value.is_array())
        for (const JsonValue part : value)
            if (part.is_string() && points_by_name_.contains(part.text())) {
                fault(value, {lang::forms::is_wanted_here_not, Words(lang::forms::a_vector_dx_dy), described(part)});
                return std::nullopt;
            }
    auto direction = vector(value, QuantityKind::dimensionless, {lang::forms::a_vector_dx_dy});
    if (direction && direction->is_zero()) {
        fault(value, {lang::forms::n_0_0_has_no_direction});
        return std::nullopt;
    }
    return direction;
}

Bearing::Between FormReader::between(JsonValue value) {
    const JsonValue first = *value.begin();
    const JsonValue second = *++value.begin();
    const Bearing::Between ends{point(first, true), point(second, true)};
    if (ends.from != none && ends.from == ends.to) fault(value, {lang::forms::a_point_and_itself_give_no});
    return ends;
}

std::optional<Bearing> FormReader::bearing(JsonValue value) {
    if (!value) return std::nullopt;
    if (value.is_string() && points_by_name_.contains(value.text()) &&
        !read_quantity(value.text(), QuantityKind::angle)) {
        fault(value, {lang::forms::is_a_point_no_direction_two, quoted(value.text())});
        return std::nullopt;
    }
    if (value.is_number() || value.is_string()) {
        auto turned = angle(value);
        if (!turned) return std::nullopt;
        return Bearing{std::move(*turned)};
    }
    if (value.is_array() && value.size() == 2) {
        const JsonValue first = *value.begin();
        const JsonValue second = *++value.begin();
        const bool numbers = is_numeric(first) && is_numeric(second) && !points_by_name_.contains(first.text());
        if (first.is_string() && second.is_string() && !numbers) return Bearing{between(value)};
        if (is_numeric(first) && is_numeric(second)) {
            auto direction = sense(value);
            if (!direction) return std::nullopt;
            return Bearing{std::move(*direction)};
        }
    }
    fault(value, {lang::forms::a_direction_is_wanted_here, described(value)});
    return std::nullopt;
}

Place FormReader::place(JsonValue value) {
    if (value.is_array())
        return vector(value, QuantityKind::length, {lang::forms::a_point_name_or_its_coordinates}).value_or(Vector{});
    return point(value);
}

}  // namespace kinegraph
