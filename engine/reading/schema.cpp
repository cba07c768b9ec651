
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "engine/file/json_source.hpp"
#include "engine/file/json_writer.hpp"
#include "engine/file/scale_text.hpp"
#include "engine/number/assert.hpp"
#include "engine/reading/file_text.hpp"
#include "engine/reading/forms.hpp"
#include "lang/keys/notation.hpp"

namespace kinegraph {
namespace {

using Shape = FormValue::Shape;
using Need = FormRow::Need;

/// A member that is said, if there is something to say.
void say(std::string_view key, std::string_view text, JsonWriter& json) {
    if (!text.empty()) json.member(key, text);
}
/// Members that are JSON already.
void add(std::string_view members, JsonWriter& json) {
    if (!members.empty()) json.json(members);
}

// ----- quantities

std::string in_braces(const std::string& text) { return "(" + text + ")"; }

std::string number_pattern(std::string_view signs) {
    return "[" + std::string(signs) + R"(]?[0-9]+(\.[0-9]+)?([eE][+-]?[0-9]+)?)";
}

/// Every spelling of the unit, as unit_spelt() reads it.
std::string unit_pattern(std::string_view symbol) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 6> spellings{{{"deg", "(deg|°)"},
                                                                                      {"²", R"((²|\^2))"},
                                                                                      {"³", R"((³|\^3))"},
                                                                                      {" ", "( *[·⋅*] *| +)"},
                                                                                      {"(", R"(\()"},
                                                                                      {")", R"(\))"}}};
    std::string pattern;
    while (!symbol.empty()) {
        const auto* const spelt = std::find_if(spellings.begin(), spellings.end(),
                                               [&](const auto& each) { return symbol.starts_with(each.first); });
        const bool is_plain = spelt == spellings.end();
        pattern += is_plain ? symbol.substr(0, 1) : spelt->second;
        symbol.remove_prefix(is_plain ? 1 : spelt->first.size());
    }
    return pattern;
}

std::string units_pattern(QuantityKind kind) {
    std::string pattern;
    for (const KnownUnit& each : known_units())
        if (each.kind == kind) pattern += (pattern.empty() ? "" : "|") + unit_pattern(each.symbol);
    return in_braces(pattern);
}

/// Of the kinds of quantities, in their order: what the definitions are called.
constexpr std::array definitions{"bareNumber",
                                 "length",
                                 "angle",
                                 "angularVelocity",
                                 "angularAcceleration",
                                 "velocity",
                                 "acceleration",
                                 "mass",
                                 "force",
                                 "moment",
                                 "momentOfInertia",
                                 "pressure",
                                 "time",
                                 "area",
                                 "forcePerLength",
                                 "torsionalStiffness",
                                 "power",
                                 "coefficientOfWear"};
static_assert(definitions.size() == count_of_quantity_kinds);
std::string definition_of(QuantityKind kind) { return definitions.at(static_cast<std::size_t>(kind)); }

void write_quantity(QuantityKind kind, JsonWriter& json) {
    using enum QuantityKind;
    const bool turns = kind == angle || kind == angular_velocity || kind == angular_acceleration || kind == moment;
    const bool can_be_set = std::any_of(forms::units.rows.begin(), forms::units.rows.end(),
                                        [&](const FormRow& row) { return row.value.kind == kind; });
    std::string article = in_english(with_article(kind));
    article.front() = static_cast<char>(article.front() - 'a' + 'A');
    const std::string bare = can_be_set ? "the unit that \"units\" sets" : std::string(default_unit(kind).symbol);
    json.open('{');
    json.member("description", article + (turns ? ", counter-clockwise positive" : "") + ". A bare number is in " +
                                   bare + "; a string states its own unit (" + units_of(kind) +
                                   "), or is a formula \"= …\".");
    json.key("type").open('[').values("number", "string").close();
    // Editors propose them; ours also proposes the units alone.
    json.key("examples").open('[');
    for (const KnownUnit& each : known_units())
        if (each.kind == kind) json.value("1 " + std::string(each.symbol));
    json.close();
    json.member("pattern", "^ *=|^" + number_pattern("+-") + " *" + units_pattern(kind) + " *$").close();
}

void write_unit(QuantityKind kind, JsonWriter& json) {
    json.member("type", "string").key("examples").open('[');
    for (const KnownUnit& each : known_units()) {
        if (each.kind == kind) json.value(each.symbol);
        if (each.kind == kind && each.symbol == "deg") json.value("°");
    }
    json.close();
}

void write_scale(QuantityKind kind, JsonWriter& json) {
    const std::string number = number_pattern("+");
    const std::string ratio = in_braces("^ *" + number + " *: *" + number + " *$");
    const std::string side = "^ *" + number + " *" + units_pattern(QuantityKind::length);
    const std::string equation = in_braces(side + " *(=|≙) *" + number + " *" + units_pattern(kind) + " *$");
    json.member("type", "string");
    json.member("pattern", kind == QuantityKind::length ? ratio + "|" + equation : equation);
}

/// What the row says or, if it says nothing, what the message calls it where it is missing; a quantity has a
/// description of its own.
std::string said_by(const FormRow& row) {
    if (!row.says.empty() || row.missing == Key{} || row.value.shape == Shape::quantity) return std::string(row.says);
    std::string text = row.missing.in(Language::en) + ".";
    if (text.front() >= 'a' && text.front() <= 'z') text.front() = static_cast<char>(text.front() - 'a' + 'A');
    return text;
}

/// With what follows from the kind of the quantity.
std::string description_of(const FormRow& row) {
    const QuantityKind kind = row.value.kind;
    std::string says = said_by(row);
    if (row.value.shape == Shape::scale) return "A scale" + in_english(scale_example(kind)) + ".";
    if (row.value.shape == Shape::quantity && !says.empty()) return says + " " + units_of(kind) + ".";
    if (row.value.shape != Shape::unit) return says;
    return "One of " + units_of(kind) +
           " (`·`, space and * are alike, ² is ^2, ° is deg). Default: " + std::string(default_unit(kind).symbol) +
           "." + (says.empty() ? "" : " ") + says;
}

void write_texts(JsonWriter& json) {
    json.key("anyOf").open('[').open('{').member("type", "string").close();
    json.open('{').member("type", "object").key("properties").open('{');
    for (const Language language : languages)
        json.key(code_of(language))
            .open('{')
            .member("description", lang::notation::name.in(language) + ".")
            .member("type", "string")
            .close();
    json.close().member("additionalProperties", false).member("minProperties", 1).close().close();
}

// ----- forms

class SchemaOfForms {
public:
    std::string whole(const Form& file) {
        JsonWriter json;
        json.open('{').member("$schema", "http://json-schema.org/draft-07/schema#");
        json.member("title", "Kinegraph mechanism");
        say("description", file.says, json);
        definitions_.open('{');
        write_form(file, json);
        return json.member("definitions", definitions_.close()).close().take();
    }

private:
    /// A value in its place: a reference where it has a definition.
    void write(const FormValue& stated, JsonWriter& json) { write(stated, {}, {}, json); }

    void write(const FormValue& stated, std::string_view says, std::string_view range, JsonWriter& json) {
        const FormValue& of = stated.shape == Shape::defined ? *stated.of : stated;
        const std::string definition = define(of);
        json.open('{');
        if (definition.empty()) {
            say("description", says.empty() ? description(of) : says, json);
            write_members(of, json);
            add(range, json);
            json.close();
            return;
        }
        const bool is_alone = says.empty() && range.empty();
        say("description", says, json);
        if (!is_alone) json.key("allOf").open('[').open('{');
        json.member("$ref", "#/definitions/" + definition);
        if (!is_alone) json.close();
        if (!range.empty()) json.open('{').json(range).close();
        if (!is_alone) json.close();
        json.close();
    }

    static std::string_view description(const FormValue& of) {
        return of.shape == Shape::form && of.says.empty() ? of.form->says : of.says;
    }

    /// The name of its definition, which is added at its first use; empty: it has none.
    std::string define(const FormValue& of) {
        const bool is_quantity = of.shape == Shape::quantity;
        std::string name = is_quantity ? definition_of(of.kind) : std::string(of.name);
        if (name.empty() || std::find(defined_.begin(), defined_.end(), name) != defined_.end()) return name;
        defined_.push_back(name);
        JsonWriter own;
        if (is_quantity) {
            write_quantity(of.kind, own);
        } else {
            own.open('{');
            say("description", description(of), own);
            write_members(of, own);
            own.close();
        }
        definitions_.member(name, own);
        return name;
    }

    void write_members(const FormValue& of, JsonWriter& json) {
        switch (of.shape) {
            case Shape::json: return add(of.json, json);
            case Shape::unit: return write_unit(of.kind, json);
            case Shape::scale: return write_scale(of.kind, json);
            case Shape::texts: return write_texts(json);
            case Shape::form: return of.form->choices.empty() ? write_form(*of.form, json) : write_any({of}, json);
            case Shape::any: return write_any({of.choices.begin(), of.choices.end()}, json);
            case Shape::word: json.member("enum", of.words); return;
            case Shape::list:
            case Shape::map: return write_several(of, json);
            case Shape::quantity:
            case Shape::defined: break;
        }
        KG_ASSERT(false, "a quantity has a definition of its own");
    }

    void write_several(const FormValue& of, JsonWriter& json) {
        const bool is_list = of.shape == Shape::list;
        const std::string what = is_list ? "Items" : "Properties";
        json.member("type", is_list ? "array" : "object");
        add(of.json, json);
        if (of.least > 0) json.member("min" + what, of.least);
        if (of.most > 0) json.member("max" + what, of.most);
        write(*of.of, json.key(is_list ? "items" : "additionalProperties"));
    }

    void write_any(const std::vector<FormValue>& choices, JsonWriter& json) {
        json.key("anyOf").open('[');
        for (const FormValue& each : choices) {
            if (each.shape != Shape::form || each.form->choices.empty())
                write(each, json);
            else
                for (const Form::Choice& choice : each.form->choices) write_choice(*each.form, choice, json);
        }
        json.close();
    }

    void write_choice(const Form& form, const Form::Choice& choice, JsonWriter& json) {
        json.open('{');
        say("description", choice.says, json);
        std::vector<std::string_view> keys;
        json.member("type", "object").key("properties").open('{');
        for (const std::string_view key : choice.keys) {
            if (key.empty()) continue;
            const FormRow* const row = form.row(key);
            KG_ASSERT(row != nullptr, "a choice names keys of its form");
            keys.push_back(key);
            write_row(*row, json);
        }
        json.close();
        if (!keys.empty()) json.member("required", keys);
        json.member("additionalProperties", false).close();
    }

    void write_form(const Form& form, JsonWriter& json) {
        std::vector<std::string_view> required, one_of, at_most_one;
        json.member("type", "object").key("properties").open('{');
        for (const FormRow& row : form.rows) {
            write_row(row, json);
            if (row.need == Need::required) required.push_back(row.key);
            if (row.need == Need::one_of) one_of.push_back(row.key);
            if (row.need == Need::at_most_one) at_most_one.push_back(row.key);
        }
        json.close();
        if (!required.empty()) json.member("required", required);
        json.member("additionalProperties", false);
        if (!one_of.empty())
            json.list("oneOf", one_of,
                      [&](std::string_view key) { json.open('{').member("required", std::array{key}).close(); });
        KG_ASSERT(at_most_one.empty() || at_most_one.size() == 2, "not both of two keys");
        if (!at_most_one.empty()) json.key("not").open('{').member("required", at_most_one).close();
        add(form.rules, json);
    }

    void write_row(const FormRow& row, JsonWriter& json) {
        write(row.value, description_of(row), row.range, json.key(row.key));
    }

    JsonWriter definitions_;
    std::vector<std::string> defined_;
};

}  // namespace

std::string json_schema_of(const Form& file) {
    const Result<JsonSource> schema = JsonSource::read(SchemaOfForms().whole(file));
    KG_ASSERT(schema.has_value(), "the forms make JSON");
    return file_with(*schema, {}, {});
}

}  // namespace kinegraph
