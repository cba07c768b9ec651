// The form of the whole file: the sections of mechanisms, of the kinds of problems and of exercises.
#include <algorithm>
#include <mutex>
#include <string>
#include <vector>

#include "engine/file/json_text.hpp"
#include "engine/number/assert.hpp"
#include "engine/reading/forms.hpp"
#include "engine/solution/problem_kind.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/exercises.hpp"
#include "lang/keys/joints.hpp"
#include "lang/keys/loads.hpp"
#include "lang/keys/mechanism.hpp"
#include "lang/keys/units.hpp"

namespace kinegraph {
namespace {

/// Elements that files name, so their names follow the rule of names.
constexpr std::string_view named_elements = R"("propertyNames": {"$ref": "#/definitions/name"})";

constexpr std::array rows_of_mechanism{
    FormRow("$schema", "\"…\"", values::text, "For editors; ignored.").called(lang::common::a_text),
    FormRow("kinegraph", "1", values::json(R"("type": "number", "minimum": 1, "maximum": 1)"),
            "The version of the format.")
        .needed(lang::common::write_the_version),
    FormRow("title", "\"…\"", values::texts, "What the sheet is called."),
    FormRow("units", "{…}", values::object(forms::units),
            "The units of bare numbers and of what is printed. Results in JSON are SI always.")
        .called(lang::units::an_object_of_units_by_quantity),
    FormRow("parameters", "{…}", values::map(values::parameter).with(R"("propertyNames": {"pattern": "^[^ ,]+$"})"),
            "Name → value: a number, a quantity with its unit, or a formula of other parameters."),
    FormRow(
        "precision", "…", values::length,
        "How far coordinates and lengths may be off: what lies within it is meant. 0: decimals are exact as written.")
        .not_negative(),
    FormRow("frame", "…", values::body_name, "The name of the frame, \"0\" if left out; it needs no entry in bodies."),
    FormRow("points", "{…}", values::map(forms::point).with(named_elements), "Name → how the point is placed."),
    FormRow("bodies", "{…}", values::map(forms::body).with(named_elements),
            "Name → the points that move with the body."),
    FormRow("joints", "[…]", values::list(forms::joint), "The joints.").called(lang::joints::an_array_of_joints),
    FormRow("drivers", "[…]", values::list(forms::driver), "What drives the mechanism.")
        .called(lang::mechanism::an_array_of_drivers),
    FormRow("masses", "{…}", values::map(forms::mass).with(values::by_body), "Body → its mass.")
        .called(lang::loads::an_object_of_masses_by_body),
    FormRow("gravity", "[gx, gy]", values::accelerations, "[gx, gy]; none if left out.")
        .called(lang::mechanism::a_vector_gx_gy),
    FormRow("inertia forces", "true", values::flag, "Whether −m·a_G and −J_G·α act."),
    FormRow("loads", "[…]", values::list(forms::load), "Given forces and couples.")
        .called(lang::mechanism::an_array_of_loads),
    FormRow("effort", "[…]", values::defined(forms::effort), "What balances, one for each degree of freedom."),
    FormRow("motion", "{…}", values::object(forms::motion_of_body)),
    FormRow("find", "[…]", values::list(forms::wish), "What to find; without it, all that the data allow.")
        .called(lang::mechanism::an_array_of_what_to_find),
    FormRow("scales", "{…}", values::object(forms::scales), "Figure → scale; else chosen.")
        .called(lang::units::an_object_of_scales_by_figure),
};

constexpr std::array rows_of_exercise{
    FormRow("ask", "[…]", values::list(values::text, 1).with(R"("uniqueItems": true)"),
            "The results that are asked for, by the names of the columns of a sweep: \"v B\", \"omega 3\", \"effort "
            "M\".")
        .called(lang::exercises::an_array_of_names_of_results),
    FormRow("vary", "{…}", values::map(forms::variation, 1),
            "Parameter → the values that it takes from copy to copy of an exercise (kinegraph variants).")
        .called(lang::exercises::an_object_of_parameters),
    FormRow("require", "[…]", values::list(values::some_text),
            "Conditions that every copy meets: \"omega 3 > 0.2\", \"vx B between 0.1 m/s and 1 m/s\", \"crank turns "
            "fully\", \"velocity polygon readable\".")
        .called(lang::exercises::an_array_of_conditions_such),
    FormRow("position of cam", "\"…\"", values::text,
            "The cam file of which this is one position: the circle of curvature stands in place of the profile, and "
            "the mechanism is not moved.")
        .called(lang::mechanism::the_name_of_a_cam_file),
};

/// The form with what it refers to; it does not move.
struct FileForm {
    std::vector<FormRow> rows{rows_of_mechanism.begin(), rows_of_mechanism.end()};
    std::vector<FormValue> shared;  ///< what may stand at a key that a problem shares
    std::string rules = R"("anyOf": [{"required": ["points", "bodies", "joints"]}, )"
                        R"({"required": ["points", "bodies", "motion"]})";
    Form form;
};

/// A problem has a key of its own, or shares that of a motion, from which its own keys tell it.
void add_problem(FileForm& file, const ProblemKind& kind) {
    const auto same =
        std::find_if(file.rows.begin(), file.rows.end(), [&](const FormRow& row) { return row.key == kind.key; });
    const std::string key = json_text(kind.key);
    file.rules += R"(, {"required": [)" + key + "]";
    if (same == file.rows.end()) {
        file.rows.emplace_back(kind.key, "…", values::defined(*kind.section));
    } else {
        KG_ASSERT(file.shared.empty(), "only one problem shares its key");
        file.shared = {same->value, values::defined(*kind.section)};
        same->value = values::any(file.shared);
        std::string own;
        for (const FormRow& row : kind.section->form->rows)
            if (row.need == FormRow::Need::one_of)
                own += (own.empty() ? "" : ", ") + (R"({"required": [)" + json_text(row.key)) + "]}";
        file.rules += R"(, "properties": {)" + key + R"(: {"anyOf": [)" + own + "]}}";
    }
    file.rules += "}";
}

}  // namespace

const Form& forms::mechanism() {
    static FileForm file;
    static std::once_flag made;
    std::call_once(made, [] {
        for (const ProblemKind* kind : problem_kinds()) add_problem(file, *kind);
        file.rows.insert(file.rows.end(), rows_of_exercise.begin(), rows_of_exercise.end());
        file.rules += R"(], "dependencies": {"motion": {"not": {"anyOf": [{"required": ["joints"]}, )"
                      R"({"required": ["drivers"]}]}}})";
        file.form = {
            .called = lang::mechanism::a_mechanism,
            .rows = file.rows,
            .says = "A planar mechanism with what drives and loads it, version 1. docs/file.md says it in words.",
            .rules = file.rules};
    });
    return file.form;
}

}  // namespace kinegraph
