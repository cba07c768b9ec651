#include "engine/reading/sections.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "engine/file/units.hpp"
#include "lang/keys/joints.hpp"

namespace kinegraph {

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
    file_.each(joints, {lang::joints::an_array_of_joints}, [&](JsonValue v) { read_joint(v); });
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
    const Members form = file_.members(value, keys_of(*pair), {pair->called, pair->key});
    const JsonValue at = form[pair->key];
    joint.point = file_.point(at);
    joint.name = at.is_string() ? at.text() : std::string_view();
    if (form["name"]) {
        joint.named = true;
        joint.name = file_.new_name(form["name"], {lang::joints::a_name});
    }
    if (!at.is_string() && !joint.named) joints_known_ = false;
    read_joint_bodies(form, joint);
    if (pair->is_sleeve())
        joint.along = file_.bearing(file_.required(form, "along", {lang::joints::the_direction_of_the_guide}));
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
        for (const std::string_view key : keys_of(pair))
            if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
    if (!file_.members(value, keys, {lang::joints::a_joint}).has_misspelt())
        file_.fault(value, {lang::joints::the_kind_of_joint_is_missing, listed(kinds)});
}

std::vector<std::string_view> JointsSection::keys_of(const PlanePair& pair) {
    std::vector<std::string_view> keys{pair.key, "bodies"};
    std::copy_if(pair.members.begin(), pair.members.end(), std::back_inserter(keys),
                 [](auto key) { return !key.empty(); });
    if (pair.touches()) keys.insert(keys.end(), ContactsOfJoints::keys.begin(), ContactsOfJoints::keys.end());
    keys.emplace_back("name");
    return keys;
}

void JointsSection::read_joint_bodies(const Members& form, Joint& joint) {
    const JsonValue bodies = file_.required(form, "bodies", {lang::joints::the_bodies_that_the_joint_connects});
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
    const JsonValue shape = file_.one_of(form, {"along", "arc"});
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
