// Forms of a mechanism file as data: which keys an object may have, what stands under each and whether it is needed.
// The readers of the sections read by these rows, the JSON Schema is written from them, and tests hold the tables of
// the documents against them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "engine/file/units.hpp"
#include "lang/words.hpp"

namespace kinegraph {

struct Form;

/// What may stand in a place of the file.
struct FormValue {
    enum class Shape : std::uint8_t {
        json,      ///< as `json` says
        quantity,  ///< a number, or a text with its unit, of `kind`
        unit,      ///< the name of a unit of `kind`
        scale,     ///< of a figure that draws quantities of `kind`
        word,      ///< one of `words`
        texts,     ///< a text, or an object of texts by language
        list,      ///< an array of `of`
        map,       ///< an object: a name → `of`
        form,      ///< an object of `form`
        defined,   ///< `of`, which another section defines
        any        ///< one of `choices`
    };
    Shape shape = Shape::json;
    QuantityKind kind = QuantityKind::dimensionless;
    std::string_view name = {};  ///< in the schema's definitions; empty: it is written out wherever it stands
    std::string_view says = {};  ///< description in the schema
    std::string_view json = {};  ///< members of the schema; of a list or a map in addition
    std::span<const std::string_view> words = {};
    const FormValue* of = nullptr;
    const Form* form = nullptr;
    std::span<const FormValue> choices = {};
    std::size_t least = 0, most = 0;  ///< elements of a list or a map; 0: any number

    constexpr FormValue named(std::string_view definition, std::string_view description) const {
        FormValue copy = *this;
        copy.name = definition;
        copy.says = description;
        return copy;
    }
    /// Further members of the schema.
    constexpr FormValue with(std::string_view members) const {
        FormValue copy = *this;
        copy.json = members;
        return copy;
    }
};

namespace values {

constexpr FormValue json(std::string_view members) { return {.json = members}; }
constexpr FormValue quantity(QuantityKind kind) { return {.shape = FormValue::Shape::quantity, .kind = kind}; }
constexpr FormValue unit(QuantityKind kind) { return {.shape = FormValue::Shape::unit, .kind = kind}; }
constexpr FormValue scale(QuantityKind kind) { return {.shape = FormValue::Shape::scale, .kind = kind}; }
constexpr FormValue word(std::span<const std::string_view> words) {
    return {.shape = FormValue::Shape::word, .words = words};
}
constexpr FormValue list(const FormValue& of, std::size_t least = 0, std::size_t most = 0) {
    return {.shape = FormValue::Shape::list, .of = &of, .least = least, .most = most};
}
constexpr FormValue map(const FormValue& of, std::size_t least = 0, std::size_t most = 0) {
    return {.shape = FormValue::Shape::map, .of = &of, .least = least, .most = most};
}
constexpr FormValue defined(const FormValue& elsewhere) {
    return {.shape = FormValue::Shape::defined, .of = &elsewhere};
}
constexpr FormValue object(const Form& form) { return {.shape = FormValue::Shape::form, .form = &form}; }
constexpr FormValue any(std::span<const FormValue> choices) {
    return {.shape = FormValue::Shape::any, .choices = choices};
}
template <std::size_t count>
constexpr std::array<FormValue, count> objects(const std::array<Form, count>& forms);

}  // namespace values

/// A key of a form.
struct FormRow {
    enum class Need : std::uint8_t {
        optional,
        required,
        one_of,      ///< exactly one of these keys of the form stands in it
        at_most_one  ///< one of these, or none
    };
    enum class Sign : std::uint8_t { any, not_negative, positive };

    std::string_view key;
    std::string_view written;  ///< as the documents write the value: "P"
    FormValue value;
    std::string_view says = {};  ///< description in the schema; empty: that of the value
    Need need = Need::optional;
    Sign sign = Sign::any;
    std::string_view range = {};  ///< of numbers, as the schema writes it
    Key missing = {};             ///< what the key gives, in the message that it is missing
    Key noun = {};                ///< what the value is, in messages that it is wrong; none: the key in quotes

    constexpr FormRow(std::string_view name, std::string_view letter, const FormValue& stands,
                      std::string_view description = {})
        : key(name), written(letter), value(stands), says(description) {}
    constexpr FormRow with_need(Need how) const {
        FormRow copy = *this;
        copy.need = how;
        return copy;
    }
    /// Without a key, its reader says what is missing.
    constexpr FormRow needed(Key meaning = {}) const {
        FormRow copy = with_need(Need::required);
        copy.missing = meaning;
        return copy;
    }
    constexpr FormRow one_of() const { return with_need(Need::one_of); }
    constexpr FormRow at_most_one() const { return with_need(Need::at_most_one); }
    constexpr FormRow called(Key wanted) const {
        FormRow copy = *this;
        copy.noun = wanted;
        return copy;
    }
    constexpr FormRow within(std::string_view limits) const {
        FormRow copy = *this;
        copy.range = limits;
        return copy;
    }
    constexpr FormRow positive(Key wanted = {}) const {
        return of_sign(Sign::positive, wanted).within(R"("exclusiveMinimum": 0)");
    }
    constexpr FormRow not_negative(Key wanted = {}) const {
        return of_sign(Sign::not_negative, wanted).within(R"("minimum": 0)");
    }

private:
    constexpr FormRow of_sign(Sign what, Key wanted) const {
        FormRow copy = called(wanted);
        copy.sign = what;
        return copy;
    }
};

/// The key that tells a form from those of its place: the reader chooses the form by it.
constexpr FormRow leading_key(std::string_view key, std::string_view letter, const FormValue& value,
                              std::string_view says = {}) {
    return FormRow(key, letter, value, says).with_need(FormRow::Need::required);
}

/// An object of the file.
struct Form {
    /// The keys of one of several objects that share a form; all are needed.
    struct Choice {
        std::string_view says;
        std::array<std::string_view, 6> keys;
    };
    Key called;  ///< "a circle", in messages about its keys; {0} is the first of them
    std::span<const FormRow> rows;
    std::string_view says = {};  ///< description in the schema
    /// Keys of other forms of its place: never in this one, but understood where they are misspelt.
    std::span<const std::string_view> others = {};
    std::span<const Choice> choices = {};  ///< none: one object, of all rows
    std::string_view rules = {};           ///< members of the schema that no row states

    constexpr const FormRow* row(std::string_view key) const {
        for (const FormRow& each : rows)
            if (each.key == key) return &each;
        return nullptr;
    }
};

template <std::size_t count>
constexpr std::array<FormValue, count> values::objects(const std::array<Form, count>& forms) {
    std::array<FormValue, count> all{};
    for (std::size_t i = 0; i < count; ++i) all[i] = object(forms[i]);
    return all;
}

}  // namespace kinegraph
