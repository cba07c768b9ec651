#include "engine/reading/schema.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "engine/file/json_source.hpp"
#include "engine/file/json_text.hpp"
#include "engine/file/scale_text.hpp"
#include "engine/number/assert.hpp"
#include "engine/reading/file_text.hpp"
#include "engine/reading/forms.hpp"

namespace kinegraph {
namespace {

using Shape = FormValue::Shape;
using Need = FormRow::Need;

/// Members of an object or elements of an array, one after the other.
class JsonParts {
public:
    void add(std::string_view part) {
        if (!part.empty()) text_ += (text_.empty() ? "" : ", ") + std::string(part);
    }
    void add(std::string_view key, std::string_view value) { add(json_text(key) + ": " + std::string(value)); }
    void add_text(std::string_view key, std::string_view text) {
        if (!text.empty()) add(key, json_text(text));
    }
    std::string object() const { return "{" + text_ + "}"; }
    std::string array() const { return "[" + text_ + "]"; }
    const std::string& text() const { return text_; }

private:
    std::string text_;
};

std::string required_keys(const std::vector<std::string_view>& keys) {
    JsonParts all;
    for (const std::string_view key : keys) all.add(json_text(key));
    return "\"required\": " + all.array();
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

/// "angularVelocity".
std::string definition_of(QuantityKind kind) {
    std::string name;
    bool begins_word = false;
    for (const char c : in_english(name_of(kind))) {
        if (c != ' ') name += begins_word && c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
        begins_word = c == ' ';
    }
    return name;
}

std::string schema_of_quantity(QuantityKind kind) {
    using enum QuantityKind;
    const bool turns = kind == angle || kind == angular_velocity || kind == angular_acceleration || kind == moment;
    const bool can_be_set = std::any_of(forms::units.rows.begin(), forms::units.rows.end(),
                                        [&](const FormRow& row) { return row.value.kind == kind; });
    std::string article = in_english(with_article(kind));
    article.front() = static_cast<char>(article.front() - 'a' + 'A');
    const std::string bare = can_be_set ? "the unit that \"units\" sets" : std::string(default_unit(kind).symbol);
    JsonParts parts;
    parts.add_text("description", article + (turns ? ", counter-clockwise positive" : "") + ". A bare number is in " +
                                      bare + "; a string states its own unit (" + units_of(kind) +
                                      "), or is a formula \"= …\".");
    parts.add("type", R"(["number", "string"])");
    parts.add_text("pattern", "^ *=|^" + number_pattern("+-") + " *" + units_pattern(kind) + " *$");
    return parts.object();
}

std::string members_of_unit(QuantityKind kind) {
    JsonParts examples;
    for (const KnownUnit& each : known_units()) {
        if (each.kind == kind) examples.add(json_text(each.symbol));
        if (each.kind == kind && each.symbol == "deg") examples.add(json_text("°"));
    }
    JsonParts parts;
    parts.add_text("type", "string");
    parts.add("examples", examples.array());
    return parts.text();
}

std::string members_of_scale(QuantityKind kind) {
    const std::string number = number_pattern("+");
    const std::string ratio = in_braces("^ *" + number + " *: *" + number + " *$");
    const std::string side = "^ *" + number + " *" + units_pattern(QuantityKind::length);
    const std::string equation = in_braces(side + " *(=|≙) *" + number + " *" + units_pattern(kind) + " *$");
    JsonParts parts;
    parts.add_text("type", "string");
    parts.add_text("pattern", kind == QuantityKind::length ? ratio + "|" + equation : equation);
    return parts.text();
}

/// With what follows from the kind of the quantity.
std::string description_of(const FormRow& row) {
    const QuantityKind kind = row.value.kind;
    if (row.value.shape == Shape::scale) return "A scale" + in_english(scale_example(kind)) + ".";
    if (row.value.shape == Shape::quantity && !row.says.empty())
        return std::string(row.says) + " " + units_of(kind) + ".";
    if (row.value.shape != Shape::unit) return std::string(row.says);
    return "One of " + units_of(kind) +
           " (`·`, space and * are alike, ² is ^2, ° is deg). Default: " + std::string(default_unit(kind).symbol) +
           "." + (row.says.empty() ? "" : " ") + std::string(row.says);
}

std::string members_of_texts() {
    JsonParts by_language;
    for (const Language language : languages) by_language.add(code_of(language), R"({"type": "string"})");
    return R"("anyOf": [{"type": "string"}, {"type": "object", "properties": )" + by_language.object() +
           R"(, "additionalProperties": false, "minProperties": 1}])";
}

// ----- forms

class SchemaOfForms {
public:
    std::string whole(const Form& file) {
        JsonParts parts;
        parts.add_text("$schema", "http://json-schema.org/draft-07/schema#");
        parts.add_text("title", "Kinegraph mechanism");
        parts.add_text("description", file.says);
        parts.add(members_of_object(file));
        parts.add("definitions", definitions_.object());
        return parts.object();
    }

private:
    /// A value in its place: a reference where it has a definition.
    std::string value(const FormValue& stated) { return value_with(stated, {}, {}); }

    std::string value_with(const FormValue& stated, std::string_view says, std::string_view range) {
        const FormValue& of = stated.shape == Shape::defined ? *stated.of : stated;
        const std::string definition = define(of);
        JsonParts parts;
        if (definition.empty()) {
            parts.add_text("description", says.empty() ? description(of) : says);
            parts.add(members(of));
            parts.add(range);
            return parts.object();
        }
        std::string reference = R"({"$ref": "#/definitions/)" + definition + "\"}";
        if (says.empty() && range.empty()) return reference;
        JsonParts all;
        all.add(reference);
        if (!range.empty()) all.add("{" + std::string(range) + "}");
        parts.add_text("description", says);
        parts.add("allOf", all.array());
        return parts.object();
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
        JsonParts parts;
        parts.add_text("description", description(of));
        if (!is_quantity) parts.add(members(of));
        definitions_.add(name, is_quantity ? schema_of_quantity(of.kind) : parts.object());
        return name;
    }

    std::string members(const FormValue& of) {
        JsonParts parts;
        switch (of.shape) {
            case Shape::json: return std::string(of.json);
            case Shape::unit: return members_of_unit(of.kind);
            case Shape::scale: return members_of_scale(of.kind);
            case Shape::texts: return members_of_texts();
            case Shape::form: return of.form->choices.empty() ? members_of_object(*of.form) : any_of({of});
            case Shape::any: return any_of({of.choices.begin(), of.choices.end()});
            case Shape::word:
                for (const std::string_view word : of.words) parts.add(json_text(word));
                return "\"enum\": " + parts.array();
            case Shape::list:
            case Shape::map: return members_of_several(of);
            case Shape::quantity:
            case Shape::defined: break;
        }
        KG_ASSERT(false, "a quantity has a definition of its own");
        return {};
    }

    std::string members_of_several(const FormValue& of) {
        const bool is_list = of.shape == Shape::list;
        const std::string what = is_list ? "Items" : "Properties";
        JsonParts parts;
        parts.add_text("type", is_list ? "array" : "object");
        parts.add(of.json);
        if (of.least > 0) parts.add("min" + what, std::to_string(of.least));
        if (of.most > 0) parts.add("max" + what, std::to_string(of.most));
        parts.add(is_list ? "items" : "additionalProperties", value(*of.of));
        return parts.text();
    }

    std::string any_of(const std::vector<FormValue>& choices) {
        JsonParts all;
        for (const FormValue& each : choices) {
            if (each.shape != Shape::form || each.form->choices.empty())
                all.add(value(each));
            else
                for (const Form::Choice& choice : each.form->choices) all.add(object_of(*each.form, choice));
        }
        return "\"anyOf\": " + all.array();
    }

    std::string object_of(const Form& form, const Form::Choice& choice) {
        std::vector<std::string_view> keys;
        JsonParts properties;
        for (const std::string_view key : choice.keys) {
            if (key.empty()) continue;
            const FormRow* const row = form.row(key);
            KG_ASSERT(row != nullptr, "a choice names keys of its form");
            keys.push_back(key);
            properties.add(key, property(*row));
        }
        JsonParts parts;
        parts.add_text("description", choice.says);
        parts.add(object(properties, keys));
        return parts.object();
    }

    std::string members_of_object(const Form& form) {
        JsonParts properties, alternatives;
        std::vector<std::string_view> required, at_most_one;
        for (const FormRow& row : form.rows) {
            properties.add(row.key, property(row));
            if (row.need == Need::required) required.push_back(row.key);
            if (row.need == Need::one_of) alternatives.add("{" + required_keys({row.key}) + "}");
            if (row.need == Need::at_most_one) at_most_one.push_back(row.key);
        }
        JsonParts parts;
        parts.add(object(properties, required));
        if (!alternatives.text().empty()) parts.add("oneOf", alternatives.array());
        KG_ASSERT(at_most_one.empty() || at_most_one.size() == 2, "not both of two keys");
        if (!at_most_one.empty()) parts.add("not", "{" + required_keys(at_most_one) + "}");
        parts.add(form.rules);
        return parts.text();
    }

    static std::string object(const JsonParts& properties, const std::vector<std::string_view>& required) {
        JsonParts parts;
        parts.add_text("type", "object");
        parts.add("properties", properties.object());
        if (!required.empty()) parts.add(required_keys(required));
        parts.add("additionalProperties", "false");
        return parts.text();
    }

    std::string property(const FormRow& row) { return value_with(row.value, description_of(row), row.range); }

    JsonParts definitions_;
    std::vector<std::string> defined_;
};

}  // namespace

std::string json_schema_of(const Form& file) {
    const Result<JsonSource> schema = JsonSource::read(SchemaOfForms().whole(file));
    KG_ASSERT(schema.has_value(), "the forms make JSON");
    return file_with(*schema, {}, {});
}

}  // namespace kinegraph
