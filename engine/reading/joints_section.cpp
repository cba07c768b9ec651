#include "engine/reading/sections.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "engine/file/units.hpp"
#include "engine/number/assert.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/joints.hpp"

namespace kinegraph {
namespace {

constexpr FormRow joint_at(std::string_view kind) { return leading_key(kind, "P", values::point_name); }
constexpr FormRow joint_bodies = FormRow("bodies", "[i, j]", values::two_bodies, "The two bodies i, j.")
                                     .needed(lang::joints::the_bodies_that_the_joint_connects);
constexpr FormRow hinge_bodies =
    FormRow("bodies", "[i, j, …]", values::list(values::body_name, 2), "Two bodies or more.")
        .needed(lang::joints::the_bodies_that_the_joint_connects);
constexpr FormRow guide("along", "X", values::direction);
constexpr FormRow profiles_row = FormRow("profiles", "{…}", values::defined(forms::profiles)).at_most_one();
constexpr FormRow tangent_row = FormRow("tangent", "X", values::direction,
                                        "The common tangent, instead of profiles; serves velocities and forces only.")
                                    .at_most_one();
constexpr FormRow joint_materials("materials", "…", values::defined(forms::contact_materials));
constexpr FormRow contact_length = FormRow("length", "l", values::length).positive(lang::common::the_length);
constexpr FormRow joint_name = FormRow("name", "\"…\"", values::name,
                                       "What results and references call the joint; else it goes by its point's name.")
                                   .called(lang::joints::a_name);

constexpr std::array revolute_rows{joint_at("revolute"), hinge_bodies, joint_name};
constexpr std::array prismatic_rows{joint_at("prismatic"), joint_bodies,
                                    guide.needed(lang::joints::the_direction_of_the_guide), joint_name};
constexpr std::array slot_rows{joint_at("pin-slot"), joint_bodies, guide.one_of(),
                               FormRow("arc", "C", values::point_name, "The centre of a curved slot.").one_of(),
                               joint_name};
constexpr std::array rolling_rows{joint_at("rolling"), joint_bodies,   profiles_row, tangent_row,
                                  joint_materials,     contact_length, joint_name};
constexpr std::array contact_rows{
    joint_at("contact"),
    joint_bodies,
    profiles_row,
    tangent_row,
    FormRow("pushes", "[dx, dy]", values::sense, "One-sided: the sense of the force on i."),
    joint_materials,
    contact_length,
    joint_name};
constexpr std::array gear_rows{joint_at("gear"),
                               joint_bodies,
                               profiles_row,
                               tangent_row,
                               FormRow("pressure angle", "a", values::angle),
                               FormRow("arm", "k", values::body_name, "The carrier, when it is not the frame."),
                               joint_materials,
                               contact_length,
                               joint_name};
constexpr std::array weld_rows{joint_at("weld"), joint_bodies, joint_name};

/// In the order of JointKind.
constexpr std::array joint_forms{
    Form{lang::joints::a_revolute, revolute_rows, "A hinge."},
    Form{lang::joints::a_prismatic_joint, prismatic_rows,
         "A slider or sleeve: j carries the guide, which passes through the point along X."},
    Form{lang::joints::a_pin_slot, slot_rows, "A pin of i in a slot of j, straight (\"along\") or curved (\"arc\")."},
    Form{lang::joints::a_rolling_joint, rolling_rows, "Rolling without slip."},
    Form{lang::joints::a_contact, contact_rows, "A sliding contact."},
    Form{lang::joints::a_gear, gear_rows, "Pitch curves that touch at the pitch point."},
    Form{lang::joints::a_weld, weld_rows, "Clamped."}};
constexpr std::array joint_choices = values::objects(joint_forms);

const Form& form_of(const PlanePair& pair) {
    const Form& form = joint_forms.at(static_cast<std::size_t>(pair.kind));
    KG_ASSERT(form.rows.front().key == pair.key, "the forms of joints stand in the order of the kinds");
    return form;
}

}  // namespace

constinit const FormValue forms::joint = values::any(joint_choices).named("joint", "A joint between bodies.");

void JointsSection::read_joints(const Members& file) {
    const JsonValue joints = file["joints"];
    if (file["motion"]) {
        for (const std::string_view key : {"joints", "drivers"}) {
            if (file[key]) file_.not_together(file[key], "motion");
        }
    } else if (!file.has_or_misspells("motion")) {
        file_.required(file, "joints", {lang::joints::an_array_of_joints_or_motion});
    }
    joints_known_ = joints && joints.is_array();
    file.each("joints", [&](JsonValue v) { read_joint(v); });
}

JointIndex JointsSection::sliding_joint(JsonValue value, const Words& remedy) {
    if (!value || !file_.expect(value, Kind::string, {lang::joints::a_joint_name})) return none;
    const std::string name(value.text());
    if (const auto found = sliding_by_name_.find(name); found != sliding_by_name_.end()) return found->second;
    if (const auto other = other_joints_.find(name); other != other_joints_.end()) {
        wrong_kind(value, other->second, remedy);
    } else if (joints_known_) {
        file_.fault(value, {lang::joints::no_sliding_joint_is_named, quoted(name),
                            did_you_mean(file_.speller().nearest(name, sliding_names_))});
    }
    return none;
}

JointIndex JointsSection::hinge(JsonValue value) {
    if (!file_.expect(value, Kind::string, {lang::joints::a_hinge_by_its_name}) || !joints_known_) return none;
    const std::string_view name = value.text();
    std::vector<JointIndex> named, there;
    for (const JointIndex index : indices_of(mechanism_.joints)) {
        const Joint& joint = mechanism_.joint(index);
        if (!joint.pair().is_hinge()) continue;
        if (joint.name == name) named.push_back(index);
        if (joint.point != none && mechanism_.point(joint.point).name == name) there.push_back(index);
    }
    if (named.empty()) named = there;
    if (named.size() == 1) return named.front();
    file_.fault(value, named.empty() ? Words(lang::joints::there_is_no_hinge, quoted(name))
                                     : Words(lang::joints::there_are_hinges_at_make_them, quoted(name),
                                             std::to_string(named.size())));
    return none;
}

void JointsSection::wrong_kind(JsonValue joint, std::string_view kind, const Words& remedy) {
    file_.fault(joint, {lang::joints::the_joint_is_of_kind, quoted(joint.text()), kind, remedy});
}

void JointsSection::read_joint(JsonValue value) {
    if (!file_.expect(value, Kind::object, {lang::joints::a_joint})) {
        joints_known_ = false;
        return;
    }
    const PlanePair* const pair = pair_of(value);
    if (pair == nullptr) return;
    Joint joint;
    joint.kind = pair->kind;
    joint.where = value.pointer();
    const Members form = file_.members(value, form_of(*pair));
    const JsonValue at = form[pair->key];
    joint.point = file_.point(at);
    joint.name = at.is_string() ? at.text() : std::string_view();
    if (form["name"]) {
        joint.named = true;
        joint.name = form.name("name");
    }
    if (!at.is_string() && !joint.named) joints_known_ = false;
    read_joint_bodies(form, joint);
    if (pair->is_sleeve()) joint.along = form.bearing("along");
    if (pair->is_slot()) read_slot(form, joint);
    if (pair->touches()) profiles_.read_profiles(form, joint);
    joint.pushes = file_.sense(form["pushes"]);
    if (const JsonValue pressure = form["pressure angle"]) {
        joint.pressure_angle = file_.angle(pressure);
        if (joint.pressure_angle) check_pressure_angle(pressure, *joint.pressure_angle);
    }
    if (const JsonValue arm = form["arm"]) {
        joint.arm = file_.body(arm);
        if (joint.connects(joint.arm) && joint.arm != none) {
            file_.fault(arm, {lang::joints::the_carrier_of_the_two_gears});
        }
    }
    if (pair->has_common_point()) {
        for (const BodyIndex on : joint.bodies) bodies_.carry(on, joint.point);
    }
    if (pair->has_guide() && !joint.name.empty())
        add_sliding_name(value, joint, joint.named ? form["name"].text() : at.text());
    if (!pair->has_guide() && !joint.name.empty()) other_joints_.emplace(joint.name, pair->key);
    if (pair->touches()) contacts_.read(form, joint, JointIndex(mechanism_.joints.size()));
    mechanism_.joints.push_back(std::move(joint));
}

const PlanePair* JointsSection::pair_of(JsonValue value) {
    const PlanePair* pair = nullptr;
    for (const PlanePair& candidate : plane_pairs) {
        if (!value[candidate.key]) continue;
        if (pair != nullptr) {
            file_.fault(value[candidate.key], {lang::joints::a_joint_is_of_one_kind, quoted(pair->key)});
            joints_known_ = false;
            return nullptr;
        }
        pair = &candidate;
    }
    if (pair == nullptr) miss_kind(value);
    return pair;
}

void JointsSection::add_sliding_name(JsonValue value, const Joint& joint, std::string_view written) {
    const auto [found, first] = sliding_keys_.emplace(joint.name, joint.where);
    if (!first) {
        file_.fault(value, {lang::joints::two_sliding_joints_are_called, quoted(joint.name), found->second});
        return;
    }
    sliding_by_name_.emplace(joint.name, JointIndex(mechanism_.joints.size()));
    sliding_names_.push_back(written);
}

void JointsSection::miss_kind(JsonValue value) {
    joints_known_ = false;
    std::vector<std::string_view> kinds;
    for (const PlanePair& pair : plane_pairs) kinds.push_back(pair.key);
    std::vector<std::string_view> keys = kinds;
    for (const PlanePair& pair : plane_pairs)
        for (const FormRow& row : form_of(pair).rows)
            if (std::find(keys.begin(), keys.end(), row.key) == keys.end()) keys.push_back(row.key);
    if (!file_.members(value, keys, {lang::joints::a_joint}).has_misspelt())
        file_.fault(value, {lang::joints::the_kind_of_joint_is_missing, listed(kinds)});
}

void JointsSection::read_joint_bodies(const Members& form, Joint& joint) {
    const JsonValue bodies = form.value("bodies");
    if (!bodies || !file_.expect(bodies, Kind::array, {lang::joints::an_array_of_bodies})) return;
    const bool any_number = joint.pair().joins_many;
    if (bodies.size() < 2 || (bodies.size() > 2 && !any_number)) {
        file_.fault(bodies, {lang::joints::are_wanted_here_not,
                             any_number ? Words(lang::joints::two_bodies_or_more) : Words(lang::joints::two_bodies),
                             described(bodies)});
    }
    std::set<BodyIndex> seen;
    for (const JsonValue name : bodies) {
        const BodyIndex connected = file_.body(name);
        if (connected != none && !seen.insert(connected).second) {
            file_.fault(name, {lang::joints::the_body_stands_twice, quoted(name.text())});
        }
        joint.bodies.push_back(connected);
    }
}

void JointsSection::read_slot(const Members& form, Joint& joint) {
    const JsonValue shape = form.one_of();
    if (!shape) return;
    if (shape.key() == "along") {
        joint.along = file_.bearing(shape);
    } else {
        joint.arc = file_.point(shape);
        if (joint.arc != none && joint.arc == joint.point) file_.fault(shape, {lang::joints::a_slot_about_its_own_pin});
    }
}

void JointsSection::check_pressure_angle(JsonValue value, const Angle& angle) {
    const Exact right_angle = angle.in_degrees ? Exact(90) : pi() / 2;
    if (angle.value.sign() < 0 || angle.value >= right_angle)
        file_.fault(value, {lang::joints::a_pressure_angle_lies_between_0});
}

}  // namespace kinegraph
