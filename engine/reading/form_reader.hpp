// Forms of a mechanism file: objects with the keys they may have, names of points and bodies, quantities with their
// units, directions. Notes every fault where it stands; knows no section of the file.
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

namespace kinegraph {

/// The members of an object that its form knows.
class Members {
public:
    JsonValue operator[](std::string_view key) const {
        const auto found =
            std::find_if(known_.begin(), known_.end(), [&](const JsonValue& v) { return v.key() == key; });
        return found == known_.end() ? JsonValue() : *found;
    }
    /// There, or there in a spelling that has been reported.
    bool has_or_misspells(std::string_view key) const {
        return (*this)[key] || std::find(misspelt_.begin(), misspelt_.end(), key) != misspelt_.end();
    }

    /// The object itself.
    JsonValue object() const { return object_; }
    bool has_misspelt() const { return !misspelt_.empty(); }

private:
    friend class FormReader;
    JsonValue object_;
    std::vector<JsonValue> known_;
    std::vector<std::string> misspelt_;
};

/// What the reader of a file and of each section is built on. What cannot be read is a fault, and a value that does no
/// harm stands for it.
class FormReader {
public:
    using Kind = JsonValue::Kind;

    // ----- faults and forms
    void fault(JsonValue at, Words message);
    /// "{wanted} is wanted here, not an array of 3".
    void wrong(JsonValue value, const Words& wanted);
    bool expect(JsonValue value, Kind kind, const Words& wanted);
    /// Sorts an object's members; reports those that `form` ("a driver") does not know.
    Members members(JsonValue object, std::span<const std::string_view> known, const Words& form);
    Members members(JsonValue object, std::initializer_list<std::string_view> known, const Words& form) {
        return members(object, std::span(known.begin(), known.size()), form);
    }
    /// The member, or a fault that says what it is needed for.
    JsonValue required(const Members& of, std::string_view key, const Words& meaning);
    /// The fault of a member beside another one of that key.
    void not_together(JsonValue at, std::string_view other);
    /// The one of several members that must not stand together; a fault where there are none (if `needed`) or more.
    JsonValue one_of(const Members& of, std::initializer_list<std::string_view> keys, bool needed = true);
    template <class Action>
    void each(JsonValue array, const Words& wanted, Action&& action) {
        if (!array || !expect(array, Kind::array, wanted)) return;
        for (const JsonValue element : array) action(element);
    }
    std::size_t fault_count() const { return faults_.size(); }
    Speller& speller() { return speller_; }

    // ----- names
    /// A new one of the file's points; false: it is there already.
    bool add_point(std::string_view name);
    bool add_body(std::string_view name);
    PointIndex index_of_point(std::string_view name) const { return points_by_name_.at(name); }
    BodyIndex index_of_body(std::string_view name) const { return bodies_by_name_.at(name); }
    /// Whether the list could be read, so that a name that is not in it is a fault.
    void know_points(bool known) { points_known_ = known; }
    void know_bodies(bool known) { bodies_known_ = known; }
    /// Where the points are noted that placements name from now on; null: no more.
    void collect_points(std::vector<PointIndex>* where) { collected_ = where; }
    /// Whether the text may be a name; a fault at `at` if not.
    void check_name(JsonValue at, std::string_view name);
    /// A new name as a member's value.
    std::string new_name(JsonValue value, const Words& wanted);
    PointIndex look_up_point(JsonValue at, std::string_view name);
    /// A point's name; in an array an integer will do.
    PointIndex point(JsonValue value, bool in_array = false);
    BodyIndex look_up_body(JsonValue at, std::string_view name);
    BodyIndex body(JsonValue value);
    /// A body that moves: the frame is refused with `why`.
    BodyIndex moving_body(JsonValue value, const Words& why);
    Words words(JsonValue value);
    void one_of_both(const Members& by_language);

    // ----- parameters
    /// Every parameter is read here, so that its faults are told whether or not it is used. `set` overrides what the
    /// file says.
    void read_parameters(JsonValue parameters, std::span<const Setting> set);
    bool has_parameter(std::string_view name) const { return parameters_.contains(name); }
    const std::vector<std::string_view>& parameter_names() const { return parameter_names_; }
    /// Whether something of the file beside the parameters hangs on it, directly or by way of another.
    bool is_used(std::string_view parameter) const;
    /// The value of a formula or a parameter's name; an error without words has been told before.
    tl::expected<Measured, Words> look_up_parameter(std::string_view name);

    // ----- numbers
    /// The value of "= …"; whatever its dimension.
    std::optional<Measured> formula(JsonValue value);
    /// Keeps the value of a formula: where the values of all are the same the file comes to the same.
    void note(const Measured& value);
    /// A number, or a formula.
    static bool is_numeric(JsonValue value) {
        return value.is_number() || (value.is_string() && is_formula(value.text()));
    }
    const KnownUnit& bare_unit(QuantityKind kind) const;
    void measure_bare_numbers_in(const KnownUnit& unit) { bare_units_.push_back(&unit); }
    /// A number or a string with a unit, as written; range checked in SI.
    std::optional<WrittenQuantity> quantity_as_written(JsonValue value, QuantityKind kind);
    /// In SI.
    std::optional<Exact> quantity(JsonValue value, QuantityKind kind);
    Exact quantity_or_zero(JsonValue value, QuantityKind kind);
    Exact positive(JsonValue value, QuantityKind kind, const Words& what);
    Exact not_negative(JsonValue value, QuantityKind kind, const Words& what);
    std::optional<Exact> bare_number(JsonValue value);
    std::optional<Angle> angle(JsonValue value);
    /// [x, y], each a quantity (or a bare number where dimensionless).
    std::optional<Vector> vector(JsonValue value, QuantityKind kind, const Words& wanted);
    std::optional<Vector> sense(JsonValue value);
    /// Two points whose join has a direction.
    Bearing::Between between(JsonValue value);
    /// FORMAT "X, a direction".
    std::optional<Bearing> bearing(JsonValue value);
    Bearing bearing_or_default(JsonValue value);
    /// A point's name or bare coordinates.
    Place place(JsonValue value);

protected:
    std::vector<std::pair<std::uint32_t, Error>> faults_;
    Speller speller_;
    std::vector<const KnownUnit*> bare_units_;  ///< those that the file sets
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
        std::string_view set;                     ///< instead of what the file says; empty: not set
        std::vector<std::string_view> uses = {};  ///< parameters that its formula names
        bool is_used = false;                     ///< by a formula that stands elsewhere than among the parameters
        State state = State::unread;
        Measured value = {};
    };
    void read_parameter(std::string_view name, Parameter& parameter);
    std::unordered_map<std::string_view, Parameter> parameters_;
    std::vector<std::string_view> parameter_names_;
    int parameters_being_read_ = 0;
    Parameter* being_read_ = nullptr;               ///< the innermost of them
    std::string comes_to_;                          ///< the values of all formulas but the parameters' own
    std::vector<PointIndex>* collected_ = nullptr;  ///< where the points that a placement uses are noted
};

}  // namespace kinegraph
