#include "problems/rotor/rotor.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "engine/reading/form_reader.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/rotor.hpp"

namespace kinegraph {
namespace {

constexpr FormValue plane_name = values::json(R"("type": ["string", "integer"], "minLength": 1)")
                                     .named("planeName", "The name of a plane of the rotor; an integer will do.");
constexpr std::array way_choices{values::angle, values::sense};
constexpr FormValue way_in_the_plane = values::any(way_choices);

constexpr std::array rotor_mass_rows{
    FormRow("mass", "m", values::mass).needed(lang::common::a_mass).positive(lang::common::a_mass),
    FormRow("radius", "r", values::length, "How far from the axis of rotation.")
        .needed(lang::rotor::how_far_from_the_axis)
        .positive(lang::common::a_radius),
    FormRow("angle", "θ", way_in_the_plane,
            "From the axis x, counter-clockwise in the end view; or a vector [dx, dy] of which only the direction "
            "counts.")
        .needed(lang::rotor::the_angle_of_its_radius),
    FormRow("plane", "A", plane_name, "Needed where the rotor has planes.")};
constexpr Form rotor_mass_form{lang::rotor::a_mass_of_the_rotor, rotor_mass_rows};
constexpr FormValue rotor_mass =
    values::object(rotor_mass_form).named("rotorMass", "A mass that turns with the rotor.");
constexpr std::array correction_rows{
    FormRow("plane", "A", plane_name, "Needed where the rotor has planes."),
    FormRow("radius", "r", values::length, "The mass is found.").at_most_one().positive(lang::common::a_radius),
    FormRow("mass", "m", values::mass, "The radius is found.").at_most_one().positive(lang::common::a_mass)};
constexpr Form correction_form{lang::rotor::a_correction, correction_rows};
constexpr FormValue rotor_correction =
    values::object(correction_form)
        .named("rotorCorrection",
               "A mass to be added, at a given radius, or a given mass; with neither the "
               "product of both is found.");
constexpr std::array rotor_rows{
    FormRow("planes", "{…}", values::map(values::length, 1), "Name → its place z along the shaft.")
        .called(lang::rotor::an_object_of_planes_by_name),
    FormRow("masses", "{…}", values::map(rotor_mass, 1), "Name → mass.")
        .needed(lang::rotor::an_object_of_masses_by_name)
        .called(lang::rotor::an_object_of_masses_by_name),
    FormRow("correction", "[…]", values::list(rotor_correction, 1, 2), "One: static balance; two: dynamic balance.")
        .needed(lang::rotor::an_array_of_one_or_two)
        .called(lang::rotor::an_array_of_one_or_two),
    FormRow("bearings", "[C, D]", values::list(plane_name, 2, 2), "The planes of the two bearings.")
        .called(lang::rotor::an_array_of_two_planes),
    FormRow("omega", "ω", values::angular_velocity, "With bearings: the speed at which they are loaded.")};
constexpr Form rotor_form{lang::rotor::rotor, rotor_rows};

/// "rotor": masses that turn with a shaft, and where others may be added.
class RotorSection {
public:
    explicit RotorSection(FormReader& file) : file_(file) {}

    std::optional<RotorProblem> read(JsonValue section);

private:
    using Kind = FormReader::Kind;

    void read_masses(const Members& form);
    RotorMass read_mass(JsonValue member);
    Bearing read_angle(const Members& form);
    void read_corrections(const Members& form);
    void read_bearings(const Members& form);
    /// The plane that a member names; `needed`: a fault where it is missing.
    std::optional<std::size_t> plane_of(const Members& form, bool needed);
    std::optional<std::size_t> look_up_plane(JsonValue value);
    /// Two planes that must not coincide, since masses or bearings in them make no couple.
    void keep_apart(JsonValue at, const std::array<std::optional<std::size_t>, 2>& planes, Key why);

    FormReader& file_;
    RotorProblem problem_;
};

std::optional<RotorProblem> RotorSection::read(JsonValue section) {
    const std::size_t before = file_.fault_count();
    const Members form = file_.members(section, rotor_form);
    problem_.where = section.pointer();
    form.each("planes", [&](JsonValue member) {
        file_.check_name(member, member.key());
        problem_.planes.push_back({std::string(member.key()), file_.quantity_or_zero(member, QuantityKind::length)});
    });
    read_corrections(form);
    read_masses(form);
    read_bearings(form);
    if (file_.fault_count() > before) return std::nullopt;
    return std::move(problem_);
}

void RotorSection::read_masses(const Members& form) {
    const JsonValue masses = form.expected("masses");
    if (!masses) return;
    for (const JsonValue member : masses) problem_.masses.push_back(read_mass(member));
    if (problem_.masses.empty()) file_.fault(masses, {lang::rotor::without_masses_nothing_is});
}

RotorMass RotorSection::read_mass(JsonValue member) {
    RotorMass mass;
    mass.name = member.key();
    file_.check_name(member, member.key());
    // The symbols of a correction have the name of its plane.
    if (std::any_of(problem_.corrections.begin(), problem_.corrections.end(),
                    [&](const RotorCorrection& each) { return problem_.name_of(each) == mass.name; }))
        file_.fault(member, {lang::rotor::a_mass_has_the_name_of, quoted(mass.name)});
    if (!file_.expect(member, Kind::object, {lang::common::an_object})) return mass;
    const Members form = file_.members(member, rotor_mass_form);
    mass.mass = form.quantity_or_default("mass");
    mass.radius = form.quantity_or_default("radius");
    mass.angle = read_angle(form);
    mass.plane = plane_of(form, problem_.has_planes());
    return mass;
}

Bearing RotorSection::read_angle(const Members& form) {
    const JsonValue value = form.value("angle");
    if (value && value.is_array()) return {file_.sense(value).value_or(Vector{1, 0})};
    return {file_.angle(value).value_or(Angle{})};
}

void RotorSection::read_corrections(const Members& form) {
    const JsonValue corrections = form.expected("correction");
    if (!corrections) return;
    if (corrections.size() != 1 && corrections.size() != 2) {
        file_.fault(corrections, {lang::rotor::one_plane_balances, std::to_string(corrections.size())});
        return;
    }
    const bool dynamic = corrections.size() == 2;
    for (const JsonValue member : corrections) {
        if (!file_.expect(member, Kind::object, {lang::common::an_object})) return;
        const Members of = file_.members(member, correction_form);
        RotorCorrection added;
        added.plane = plane_of(of, dynamic || problem_.has_planes());
        if (const JsonValue given = of.one_of(); given && given.key() == "radius")
            added.radius = of.quantity_or_default("radius");
        else if (given)
            added.mass = of.quantity_or_default("mass");
        problem_.corrections.push_back(added);
    }
    if (dynamic)
        keep_apart(corrections, {problem_.corrections[0].plane, problem_.corrections[1].plane},
                   lang::rotor::both_corrections_lie);
}

void RotorSection::read_bearings(const Members& form) {
    const JsonValue bearings = form.expected("bearings");
    if (!bearings) {
        if (const JsonValue omega = form["omega"]; omega && !form["bearings"])
            file_.fault(omega, {lang::rotor::a_speed_loads_bearings});
        return;
    }
    file_.required(form, "omega", {lang::rotor::the_speed_at_which_they});
    problem_.omega = form.quantity_or_default("omega");
    if (form["omega"] && problem_.omega.is_zero()) file_.fault(form["omega"], {lang::rotor::at_rest_nothing_pulls});
    if (bearings.size() != 2) {
        file_.fault(bearings, {lang::rotor::a_shaft_has_two_bearings, std::to_string(bearings.size())});
        return;
    }
    std::array<std::optional<std::size_t>, 2> planes;
    std::size_t i = 0;
    for (const JsonValue each : bearings) planes.at(i++) = look_up_plane(each);
    keep_apart(bearings, planes, lang::rotor::both_bearings_lie);
    if (planes[0] && planes[1]) problem_.bearings = {*planes[0], *planes[1]};
}

std::optional<std::size_t> RotorSection::plane_of(const Members& form, bool needed) {
    const JsonValue value =
        needed ? file_.required(form, "plane", {lang::rotor::the_plane_in_which_it_lies}) : form["plane"];
    return value ? look_up_plane(value) : std::nullopt;
}

std::optional<std::size_t> RotorSection::look_up_plane(JsonValue value) {
    if (!value.is_string() && !value.is_number()) {
        file_.wrong(value, {lang::rotor::the_name_of_a_plane});
        return std::nullopt;
    }
    const auto found = std::find_if(problem_.planes.begin(), problem_.planes.end(),
                                    [&](const RotorPlane& each) { return each.name == value.text(); });
    if (found != problem_.planes.end()) return static_cast<std::size_t>(found - problem_.planes.begin());
    std::vector<std::string_view> names;
    for (const RotorPlane& each : problem_.planes) names.push_back(each.name);
    file_.fault(value, {lang::rotor::no_plane_is_named, quoted(value.text()),
                        did_you_mean(file_.speller().nearest(value.text(), names))});
    return std::nullopt;
}

void RotorSection::keep_apart(JsonValue at, const std::array<std::optional<std::size_t>, 2>& planes, Key why) {
    if (planes[0] && planes[1] && problem_.z_of(planes[0]) == problem_.z_of(planes[1])) file_.fault(at, {why});
}

}  // namespace

constinit const FormValue rotor_section =
    values::object(rotor_form).named({}, "Masses on a shaft, to be balanced in one plane or two, in place of joints.");

std::any read_rotor(FormReader& file, Mechanism&, JsonValue section) {
    if (!file.expect(section, JsonValue::Kind::object, {lang::common::an_object})) return {};
    auto problem = RotorSection(file).read(section);
    return problem ? std::any(*std::move(problem)) : std::any();
}

}  // namespace kinegraph
