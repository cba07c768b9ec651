#include "engine/reading/sections.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "engine/file/units.hpp"

namespace kinegraph {

void JointsSection::read_joints(const Members& file) {
    const JsonValue joints = file["joints"];
    if (file["motion"]) {
        for (const std::string_view key : {"joints", "drivers"}) {
            if (file[key]) file_.not_together(file[key], "motion");
        }
    } else if (!file.has_or_misspells("motion")) {
        file_.required(file, "joints",
                       {"an array of joints (or \"motion\", one body's act of motion)",
                        "un array di coppie (o \"motion\", l’atto di moto di un corpo)"});
    }
    joints_known_ = joints && joints.is_array();
    file_.each(joints, {"an array of joints", "un array di coppie"}, [&](JsonValue v) { read_joint(v); });
}

JointIndex JointsSection::sliding_joint(JsonValue value, const Words& remedy) {
    if (!value || !file_.expect(value, Kind::string, {"a joint's name", "il nome di una coppia"})) return none;
    const std::string name(value.text());
    if (const auto found = sliding_by_name_.find(name); found != sliding_by_name_.end()) return found->second;
    if (const auto other = other_joints_.find(name); other != other_joints_.end()) {
        wrong_kind(value, other->second, remedy);
    } else if (joints_known_) {
        file_.fault(value, {"no sliding joint is named {0}{1}", "nessuna coppia con scorrimento si chiama {0}{1}",
                            quoted(name), did_you_mean(file_.speller().nearest(name, sliding_names_))});
    }
    return none;
}

JointIndex JointsSection::hinge(JsonValue value) {
    if (!file_.expect(value, Kind::string,
                      {"a hinge, by its name or its point,", "una cerniera, per nome o per punto"}) ||
        !joints_known_)
        return none;
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
    file_.fault(
        value,
        named.empty()
            ? Words("there is no hinge at {0}; a load on a point of a body has \"body\" and \"at\"",
                    "in {0} non c’è cerniera; un carico in un punto di un corpo ha \"body\" e \"at\"", quoted(name))
            : Words(
                  "there are {1} hinges at {0}; make them one with all their bodies, or give the one meant a \"name\"",
                  "in {0} ci sono {1} cerniere; farne una sola con tutti i corpi, o dare un \"name\" a quella voluta",
                  quoted(name), std::to_string(named.size())));
    return none;
}

void JointsSection::wrong_kind(JsonValue joint, std::string_view kind, const Words& remedy) {
    file_.fault(joint, {"the joint {0} is of kind \"{1}\"; {2}", "la coppia {0} è di tipo \"{1}\"; {2}",
                        quoted(joint.text()), kind, remedy});
}

void JointsSection::read_joint(JsonValue value) {
    if (!file_.expect(value, Kind::object, {"a joint", "una coppia"})) {
        joints_known_ = false;
        return;
    }
    const PlanePair* const pair = pair_of(value);
    if (pair == nullptr) return;
    Joint joint;
    joint.kind = pair->kind;
    joint.where = value.pointer();
    const Members form = file_.members(value, keys_of(*pair), {pair->called, "una coppia \"{0}\"", pair->key});
    const JsonValue at = form[pair->key];
    joint.point = file_.point(at);
    joint.name = at.is_string() ? at.text() : std::string_view();
    if (form["name"]) {
        joint.named = true;
        joint.name = file_.new_name(form["name"], {"a name", "un nome"});
    }
    if (!at.is_string() && !joint.named) joints_known_ = false;
    read_joint_bodies(form, joint);
    if (pair->is_sleeve())
        joint.along =
            file_.bearing(file_.required(form, "along", {"the direction of the guide", "la direzione della guida"}));
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
            file_.fault(arm, {"the carrier of the two gears is a third body",
                              "il portatreno delle due ruote è un terzo corpo"});
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
            file_.fault(value[candidate.key], {"a joint is of one kind; this one is {0} already",
                                               "una coppia è di un solo tipo; questa è già {0}", quoted(pair->key)});
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
        file_.fault(value, {"two sliding joints are called {0} (the other is {1}); give one of them a \"name\"",
                            "due coppie con scorrimento si chiamano {0} (l’altra è {1}); dare a una un \"name\"",
                            quoted(joint.name), found->second});
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
    if (!file_.members(value, keys, {"a joint", "una coppia"}).has_misspelt())
        file_.fault(
            value, {"the kind of joint is missing: one of {0}", "manca il tipo di coppia: uno fra {0}", listed(kinds)});
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
    const JsonValue bodies =
        file_.required(form, "bodies", {"the bodies that the joint connects", "i corpi che la coppia collega"});
    if (!bodies || !file_.expect(bodies, Kind::array, {"an array of bodies", "un array di corpi"})) return;
    const bool any_number = joint.pair().joins_many;
    if (bodies.size() < 2 || (bodies.size() > 2 && !any_number)) {
        file_.fault(bodies,
                    {"{0} are wanted here, not {1}", "qui servono {0}, non {1}",
                     any_number ? Words("two bodies or more", "due o più corpi") : Words("two bodies", "due corpi"),
                     described(bodies)});
    }
    std::set<BodyIndex> seen;
    for (const JsonValue name : bodies) {
        const BodyIndex connected = file_.body(name);
        if (connected != none && !seen.insert(connected).second) {
            file_.fault(name, {"the body {0} stands twice in one joint",
                               "il corpo {0} compare due volte nella stessa coppia", quoted(name.text())});
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
        if (joint.arc != none && joint.arc == joint.point)
            file_.fault(shape, {"a slot about its own pin has no radius; name the arc's centre",
                                "un glifo attorno al proprio perno non ha raggio; indicare il centro dell’arco"});
    }
}

void JointsSection::check_pressure_angle(JsonValue value, const Angle& angle) {
    const Exact right_angle = angle.in_degrees ? Exact(90) : pi() / 2;
    if (angle.value.sign() < 0 || angle.value >= right_angle)
        file_.fault(value, {"a pressure angle lies between 0° and 90°", "un angolo di pressione sta fra 0° e 90°"});
}

}  // namespace kinegraph
