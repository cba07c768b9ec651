#include "engine/reading/form_reader.hpp"

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace kinegraph {

// ----- faults and forms

void FormReader::fault(JsonValue at, Words message) {
    faults_.emplace_back(at.order(), Error{ErrorCode::bad_input, at.pointer(), std::move(message)});
}

void FormReader::wrong(JsonValue value, const Words& wanted) {
    fault(value, {"{0} is wanted here, not {1}", "qui serve {0}, non {1}", wanted, described(value)});
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
        Words message("unknown key {0}", "chiave sconosciuta {0}", quoted(member.key()));
        if (meant) {
            message += did_you_mean(meant);
            result.misspelt_.push_back(*meant);
        } else {
            message += Words("; the keys of {0} are {1}", "; le chiavi di {0} sono {1}", form, listed(known));
        }
        fault(member, std::move(message));
    }
    return result;
}

JsonValue FormReader::required(const Members& of, std::string_view key, const Words& meaning) {
    if (of[key]) return of[key];
    if (!of.has_or_misspells(key)) fault(of.object_, {"\"{0}\" is missing: {1}", "manca \"{0}\": {1}", key, meaning});
    return {};
}

void FormReader::not_together(JsonValue at, std::string_view other) {
    fault(at, {"{0} and {1} do not go together; take one of them out", "{0} e {1} non stanno insieme; toglierne una",
               quoted(at.key()), quoted(other)});
}

JsonValue FormReader::one_of(const Members& of, std::initializer_list<std::string_view> keys, bool needed) {
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
        fault(of.object_, {"one of {0} is missing", "manca una fra {0}", listed({keys.begin(), keys.size()})});
    }
    return only;
}

// ----- names

void FormReader::check_name(JsonValue at, std::string_view name) {
    if (name.empty()) {
        fault(at, {"a name must not be empty", "un nome non può essere vuoto"});
    } else if (name.find(',') != std::string_view::npos) {
        fault(at,
              {"the name {0} has a comma; names in results are separated by commas, so choose another",
               "il nome {0} ha una virgola; nei risultati i nomi sono separati da virgole, quindi sceglierne un altro",
               quoted(name)});
    } else if (name.find(" on ") != std::string_view::npos) {
        fault(at, {"the name {0} has \" on \" in it; results say \"3 on 2\", so choose another",
                   "il nome {0} contiene \" on \"; i risultati dicono \"3 on 2\", quindi sceglierne un altro",
                   quoted(name)});
    } else if (has_control_character(name, true)) {
        fault(at, {"the name {0} has a control character; take it out",
                   "il nome {0} ha un carattere di controllo; toglierlo", quoted(name)});
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
        fault(at, {"no point is named {0}{1}", "nessun punto si chiama {0}{1}", quoted(name),
                   did_you_mean(speller_.nearest(name, point_names_))});
    return none;
}

PointIndex FormReader::point(JsonValue value, bool in_array) {
    if (!value) return none;
    if (value.is_string() || (in_array && is_whole_number(value))) return look_up_point(value, value.text());
    wrong(value, {"a point's name", "il nome di un punto"});
    return none;
}

BodyIndex FormReader::look_up_body(JsonValue at, std::string_view name) {
    const auto found = bodies_by_name_.find(name);
    if (found != bodies_by_name_.end()) return found->second;
    if (bodies_known_)
        fault(at, {"no body is named {0}{1}", "nessun corpo si chiama {0}{1}", quoted(name),
                   did_you_mean(speller_.nearest(name, body_names_))});
    return none;
}

BodyIndex FormReader::body(JsonValue value) {
    if (!value) return none;
    if (value.is_string() || is_whole_number(value)) return look_up_body(value, value.text());
    wrong(value, {"a body's name", "il nome di un corpo"});
    return none;
}

BodyIndex FormReader::moving_body(JsonValue value, const Words& why) {
    const BodyIndex found = body(value);
    if (found == frame) fault(value, why);
    return found;
}

Words FormReader::words(JsonValue value) {
    const auto line = [&](JsonValue text) -> std::string {
        if (!expect(text, Kind::string, {"a text", "un testo"})) return {};
        if (has_control_character(text.text(), false))
            fault(text, {"a control character cannot be drawn; take it out of {0}",
                         "un carattere di controllo non si può disegnare; toglierlo da {0}", quoted(text.text())});
        std::string clean(text.text());
        std::replace_if(
            clean.begin(), clean.end(), [](char c) { return c == '\t' || c == '\n' || c == '\r'; }, ' ');
        return clean;
    };
    Words result;
    if (value.is_string()) {
        result.en = result.it = line(value);
    } else if (value.is_object()) {
        const Members by_language =
            members(value, {"en", "it"}, {"a text in several languages", "un testo in più lingue"});
        one_of_both(by_language);
        if (by_language["en"]) result.en = line(by_language["en"]);
        result.it = by_language["it"] ? line(by_language["it"]) : result.en;
        if (!by_language["en"]) result.en = result.it;
    } else {
        wrong(value, {"a text or {\"en\": …, \"it\": …}", "un testo o {\"en\": …, \"it\": …}"});
    }
    return result;
}

void FormReader::one_of_both(const Members& by_language) {
    if (!by_language.has_or_misspells("en") && !by_language.has_or_misspells("it")) {
        fault(by_language.object_, {"neither \"en\" nor \"it\" is given", "non è dato né \"en\" né \"it\""});
    }
}

// ----- parameters

void FormReader::read_parameters(JsonValue parameters, std::span<const Setting> set) {
    if (parameters &&
        !expect(parameters, Kind::object, {"an object of parameters by name", "un oggetto con i parametri per nome"}))
        return;
    if (parameters) {
        for (const JsonValue member : parameters) {
            if (!is_parameter_name(member.key()))
                fault(member,
                      {"{0} can be no parameter’s name: a letter, then letters, digits and _; no function of formulas",
                       "{0} non può essere il nome di un parametro: una lettera, poi lettere, cifre e _; nessuna "
                       "funzione delle formule",
                       quoted(member.key())});
            if (parameters_.try_emplace(member.key(), Parameter{.at = member, .set = {}}).second)
                parameter_names_.push_back(member.key());
        }
    }
    for (const Setting& setting : set) {
        const auto found = parameters_.find(setting.name);
        if (found == parameters_.end()) {
            faults_.emplace_back(0, Error{ErrorCode::bad_input,
                                          {},
                                          {"--set {0}: the file has no parameter named {0}{1}",
                                           "--set {0}: il file non ha un parametro {0}{1}", quoted(setting.name),
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
        wrong(parameter.at, {"a number, a quantity or a formula", "un numero, una grandezza o una formula"});
    } else {
        value = read_measured(of_the_file ? parameter.at.text() : parameter.set,
                              [this](std::string_view other) { return look_up_parameter(other); });
    }
    // "40" is a number in quotes: it lacks its unit, as everywhere in a file.
    if (value && of_the_file && parameter.at.is_string() && !is_formula(parameter.at.text()) && value->is_bare)
        value = tl::make_unexpected(Words("{0} has no unit; add one, or write the number without quotes",
                                          "{0} non ha unità; aggiungerla, o scrivere il numero senza virgolette",
                                          quoted(parameter.at.text())));
    --parameters_being_read_;
    being_read_ = outer;
    parameter.state = value ? Parameter::State::read : Parameter::State::faulty;
    if (value) parameter.value = std::move(*value);
    if (value || value.error().empty()) return;
    fault(parameter.at, of_the_file ? value.error() : Words("--set {0}: {1}", "--set {0}: {1}", name, value.error()));
}

tl::expected<Measured, Words> FormReader::look_up_parameter(std::string_view name) {
    constexpr int most_within_each_other = 100;
    const auto found = parameters_.find(name);
    if (found == parameters_.end()) {
        std::vector<std::string_view> known = parameter_names_;
        for (const std::string_view word : formula_words()) known.push_back(word);
        return tl::make_unexpected(Words("no parameter is named {0}{1}", "nessun parametro si chiama {0}{1}",
                                         quoted(name), did_you_mean(speller_.nearest(name, known))));
    }
    Parameter& parameter = found->second;
    if (being_read_ != nullptr)
        being_read_->uses.push_back(found->first);
    else
        parameter.is_used = true;
    if (parameter.state == Parameter::State::being_read)
        return tl::make_unexpected(
            Words("the parameter {0} is given by itself; give one of the cycle a value",
                  "il parametro {0} è dato per mezzo di se stesso; dare un valore a uno del cerchio", quoted(name)));
    if (parameter.state == Parameter::State::unread && parameters_being_read_ > most_within_each_other)
        return tl::make_unexpected(Words("more than {0} parameters are given one by the other",
                                         "più di {0} parametri sono dati l’uno per mezzo dell’altro",
                                         std::to_string(most_within_each_other)));
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
            result =
                tl::make_unexpected(Words("{0} is {1}; {2} is wanted here", "{0} è {1}; qui serve {2}",
                                          quoted(value.text()), with_article(result->unit->kind), with_article(kind)));
        }
    } else {
        wrong(value, with_article(kind));
        return std::nullopt;
    }
    if (result && !is_within_range(result->in_si())) {
        result = tl::make_unexpected(
            Words("{0} is outside 1e-60 … 1e60 (in SI units), where a number other than zero must lie",
                  "{0} è fuori da 1e-60 … 1e60 (in unità SI), dove deve stare un numero diverso da zero",
                  shown(value.text(), 40)));
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
    if (number && number->sign() <= 0)
        fault(value, {"{0} must be greater than zero", "{0} deve essere maggiore di zero", what});
    return number.value_or(Exact(1));
}

Exact FormReader::not_negative(JsonValue value, QuantityKind kind, const Words& what) {
    const auto number = quantity(value, kind);
    if (number && number->sign() < 0)
        fault(value, {"{0} must not be negative", "{0} non può avere valore negativo", what});
    return number.value_or(Exact());
}

std::optional<Exact> FormReader::bare_number(JsonValue value) {
    if (!value || (!is_numeric(value) && !expect(value, Kind::number, {"a bare number", "un numero puro"})))
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
        number = tl::make_unexpected(Words("{0} is outside 1e-60 … 1e60, where a number other than zero must lie",
                                           "{0} è fuori da 1e-60 … 1e60, dove deve stare un numero diverso da zero",
                                           shown(value.text(), 40)));
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
    auto direction = vector(value, QuantityKind::dimensionless, {"a vector [dx, dy]", "un vettore [dx, dy]"});
    if (direction && direction->is_zero()) {
        fault(value, {"[0, 0] has no direction", "[0, 0] non ha direzione"});
        return std::nullopt;
    }
    return direction;
}

Bearing::Between FormReader::between(JsonValue value) {
    const JsonValue first = *value.begin();
    const JsonValue second = *++value.begin();
    const Bearing::Between ends{point(first, true), point(second, true)};
    if (ends.from != none && ends.from == ends.to)
        fault(value, {"a point and itself give no direction; name two points",
                      "un punto e se stesso non danno una direzione; indicare due punti"});
    return ends;
}

std::optional<Bearing> FormReader::bearing(JsonValue value) {
    if (!value) return std::nullopt;
    if (value.is_string() && points_by_name_.contains(value.text()) &&
        !read_quantity(value.text(), QuantityKind::angle)) {
        fault(value,
              {"{0} is a point, no direction; two points in an array give one: [{0}, …]",
               "{0} è un punto, non una direzione; la danno due punti in un array: [{0}, …]", quoted(value.text())});
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
    fault(value, {"a direction is wanted here: an angle, two points [\"A\", \"B\"] or a vector [dx, dy], not {0}",
                  "qui serve una direzione: un angolo, due punti [\"A\", \"B\"] o un vettore [dx, dy], non {0}",
                  described(value)});
    return std::nullopt;
}

Bearing FormReader::bearing_or_default(JsonValue value) { return bearing(value).value_or(Bearing{}); }

Place FormReader::place(JsonValue value) {
    if (value.is_array())
        return vector(value, QuantityKind::length,
                      {"a point's name or its coordinates [x, y]", "il nome di un punto o le sue coordinate [x, y]"})
            .value_or(Vector{});
    return point(value);
}

}  // namespace kinegraph
