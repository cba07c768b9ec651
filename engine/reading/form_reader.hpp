// Forms of a mechanism file: objects with permitted keys, names of points and bodies, quantities with units,
// directions. Reports every fault at its place; independent of particular sections.
#pragma once

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "engine/file/error.hpp"
#include "engine/file/formula.hpp"
#include "engine/file/json_source.hpp"
#include "engine/file/spelling.hpp"
#include "engine/file/units.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "engine/reading/forms.hpp"

namespace kinegraph {

class Members;

/// The base of the readers of files and sections. An unreadable value is reported and replaced by a harmless one.
class FormReader {
public:
    using Kind = JsonValue::Kind;

    // ----- faults and forms
    void fault(JsonValue at, Words message);
    /// "{wanted} is wanted here, not an array of 3".
    void wrong(JsonValue value, const Words& wanted);
    bool expect(JsonValue value, Kind kind, const Words& wanted);
    /// Sorts an object's members; reports those that are not in `form` ("a driver").
    Members members(JsonValue object, std::span<const std::string_view> known, const Words& form);
    Members members(JsonValue object, const Form& form);
    /// The member; if missing, a fault that states what it is needed for.
    JsonValue required(const Members& of, std::string_view key, const Words& meaning);
    /// Reports a member that must not stand beside another one of that key.
    void not_together(JsonValue at, std::string_view other);
    /// The present one of several mutually exclusive members; a fault where there are none (if `needed`) or several.
    JsonValue one_of(const Members& of, std::span<const std::string_view> keys, bool needed);
    JsonValue one_of(const Members& of, std::initializer_list<std::string_view> keys, bool needed = true) {
        return one_of(of, std::span(keys.begin(), keys.size()), needed);
    }
    template <class Action>
    void each(JsonValue array, const Words& wanted, Action&& action) {
        if (!array || !expect(array, Kind::array, wanted)) return;
        for (const JsonValue element : array) action(element);
    }
    std::size_t fault_count() const { return faults_.size(); }
    Speller& speller() { return speller_; }

    // ----- names
    /// Adds a point of the file; false: it exists already.
    bool add_point(std::string_view name);
    bool add_body(std::string_view name);
    PointIndex index_of_point(std::string_view name) const { return points_by_name_.at(name); }
    BodyIndex index_of_body(std::string_view name) const { return bodies_by_name_.at(name); }
    /// Whether the list was readable, so that an unlisted name is a fault.
    void know_points(bool known) { points_known_ = known; }
    void know_bodies(bool known) { bodies_known_ = known; }
    /// From now on, collects the points that placements name; null: stops.
    void collect_points(std::vector<PointIndex>* where) { collected_ = where; }
    /// Reports, at `at`, a text that is not a valid name.
    void check_name(JsonValue at, std::string_view name);
    /// A new name as a member's value.
    std::string new_name(JsonValue value, const Words& wanted);
    PointIndex look_up_point(JsonValue at, std::string_view name);
    /// A point's name; in an array an integer is accepted.
    PointIndex point(JsonValue value, bool in_array = false);
    BodyIndex look_up_body(JsonValue at, std::string_view name);
    BodyIndex body(JsonValue value);
    /// A moving body: the frame is rejected with the message `why`.
    BodyIndex moving_body(JsonValue value, const Words& why);
    Words words(JsonValue value);
    /// Reports a fault if a text is given in no language.
    void require_a_language(const Members& by_language);

    // ----- parameters
    /// Reads every parameter here, so that its faults are reported even if it is unused. `set` overrides the file's
    /// values.
    void read_parameters(JsonValue parameters, std::span<const Setting> set);
    bool has_parameter(std::string_view name) const { return parameters_.contains(name); }
    const std::vector<std::string_view>& parameter_names() const { return parameter_names_; }
    /// Whether something outside the parameters depends on it, directly or through another parameter.
    bool is_used(std::string_view parameter) const;
    /// The value of a formula or a parameter's name; an error without words has already been reported.
    tl::expected<Measured, Words> look_up_parameter(std::string_view name);

    // ----- numbers
    /// The value of "= …", of any dimension.
    std::optional<Measured> formula(JsonValue value);
    /// Records the value of a formula: two files are the same if all of these values are equal.
    void note(const Measured& value);
    /// A number, or a formula.
    static bool is_numeric(JsonValue value) {
        return value.is_number() || (value.is_string() && is_formula(value.text()));
    }
    const KnownUnit& bare_unit(QuantityKind kind) const;
    void measure_bare_numbers_in(const KnownUnit& unit) { bare_units_.push_back(&unit); }
    /// A number or a string with a unit, as written; the range is checked in SI.
    std::optional<WrittenQuantity> quantity_as_written(JsonValue value, QuantityKind kind);
    /// In SI.
    std::optional<Exact> quantity(JsonValue value, QuantityKind kind);
    Exact quantity_or_zero(JsonValue value, QuantityKind kind);
    Exact positive(JsonValue value, QuantityKind kind, const Words& what);
    std::optional<Exact> bare_number(JsonValue value);
    std::optional<Angle> angle(JsonValue value);
    /// [x, y], each a quantity (or a bare number where dimensionless).
    std::optional<Vector> vector(JsonValue value, QuantityKind kind, const Words& wanted);
    std::optional<Vector> sense(JsonValue value);
    /// Two points; the same point twice is a fault.
    Bearing::Between between(JsonValue value);
    /// FORMAT "X, a direction".
    std::optional<Bearing> bearing(JsonValue value);
    /// A point's name or bare coordinates.
    Place place(JsonValue value);

protected:
    std::vector<std::pair<std::uint32_t, Error>> faults_;
    Speller speller_;
    std::vector<const KnownUnit*> bare_units_;  ///< units set by the file
    std::vector<Exact> computed_;               ///< lengths that formulas gave, m
    bool is_approximate_ = false;               ///< one of them is a root or a sine
    // Views into the source.
    std::unordered_map<std::string_view, PointIndex> points_by_name_;
    std::unordered_map<std::string_view, BodyIndex> bodies_by_name_;
    std::vector<std::string_view> point_names_, body_names_;
    bool points_known_ = false, bodies_known_ = false;
    struct Parameter {
        enum class State : std::uint8_t { unread, being_read, read, faulty };
        JsonValue at;
        std::string_view set;                     ///< replaces the file's value; empty: not set
        std::vector<std::string_view> uses = {};  ///< parameters that its formula names
        bool is_used = false;                     ///< by a formula outside the parameters
        State state = State::unread;
        Measured value = {};
    };
    void read_parameter(std::string_view name, Parameter& parameter);
    std::unordered_map<std::string_view, Parameter> parameters_;
    std::vector<std::string_view> parameter_names_;
    int parameters_being_read_ = 0;
    Parameter* being_read_ = nullptr;               ///< the innermost one being evaluated
    std::string comes_to_;                          ///< the values of all formulas except those of parameters
    std::vector<PointIndex>* collected_ = nullptr;  ///< collects the points that a placement uses
};

/// The permitted members of an object. The values of those that the form's rows describe are read as the rows say: one
/// that is needed and missing is reported, and so is one of a wrong kind or sign.
class Members {
public:
    Members() = default;
    /// Whether there is an object.
    explicit operator bool() const { return bool(object_); }
    JsonValue operator[](std::string_view key) const {
        const auto found =
            std::find_if(known_.begin(), known_.end(), [&](const JsonValue& v) { return v.key() == key; });
        return found == known_.end() ? JsonValue() : *found;
    }
    /// Whether it is present, possibly misspelt (then already reported).
    bool has_or_misspells(std::string_view key) const {
        return (*this)[key] || std::find(misspelt_.begin(), misspelt_.end(), key) != misspelt_.end();
    }
    /// Whether it has a key, possibly misspelt, of another form of its place.
    bool is_of_another_form() const {
        const auto keys = form_->others;
        return std::any_of(keys.begin(), keys.end(), [this](std::string_view key) { return has_or_misspells(key); });
    }

    /// The object itself.
    JsonValue object() const { return object_; }
    bool has_misspelt() const { return !misspelt_.empty(); }

    // ----- values
    /// The member; a fault where it is missing and needed.
    JsonValue value(std::string_view key) const {
        const FormRow& of = row(key);
        return of.need == FormRow::Need::required ? file_->required(*this, key, of.missing) : (*this)[key];
    }
    /// The same, of the JSON kind that its row asks for.
    JsonValue expected(std::string_view key) const;
    /// The elements of an array, the members of an object by name.
    template <class Action>
    void each(std::string_view key, Action&& action) const {
        if (const JsonValue all = expected(key))
            for (const JsonValue element : all) action(element);
    }
    /// The members of an object that has a form of its own; false where it is missing or unreadable.
    Members form(std::string_view key) const {
        const JsonValue there = expected(key);
        return there ? file_->members(there, *row(key).value.form) : Members();
    }
    /// The present one of the keys that exclude each other; a fault where there are several, or none and one is needed.
    JsonValue one_of() const;
    PointIndex point(std::string_view key) const { return file_->point(value(key)); }
    BodyIndex body(std::string_view key) const { return file_->body(value(key)); }
    /// A new name.
    std::string name(std::string_view key) const;
    /// "true"; false otherwise.
    bool flag(std::string_view key) const;
    /// In SI.
    std::optional<Exact> quantity(std::string_view key) const {
        return file_->quantity(value(key), row(key).value.kind);
    }
    /// If it is unreadable, 1 of what must be positive, otherwise 0.
    Exact quantity_or_default(std::string_view key) const;
    std::optional<Exact> number(std::string_view key) const { return file_->bare_number(value(key)); }
    Angle angle(std::string_view key) const { return file_->angle(value(key)).value_or(Angle{}); }
    std::optional<Vector> vector(std::string_view key) const;
    std::optional<Bearing> bearing(std::string_view key) const { return file_->bearing(value(key)); }
    Bearing bearing_or_default(std::string_view key) const { return bearing(key).value_or(Bearing{}); }
    Place place(std::string_view key) const;

private:
    friend class FormReader;
    const FormRow& row(std::string_view key) const;

    FormReader* file_ = nullptr;
    const Form* form_ = nullptr;
    JsonValue object_;
    std::vector<JsonValue> known_;
    std::vector<std::string> misspelt_;
};

}  // namespace kinegraph
