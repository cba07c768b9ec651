// The reader of mechanism files: docs/format.md turned into checks, and a Mechanism made of what passes them. Each fault is
// reported once, where it stands; what only the drawing can tell (curves that do not meet, a misfit) is left to the pose.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <variant>
#include <vector>

#include "engine/assert.hpp"
#include "engine/form_reader.hpp"
#include "engine/json_source.hpp"
#include "engine/mechanism.hpp"
#include "engine/point_cycles.hpp"
#include "engine/scale_text.hpp"
#include "engine/spelling.hpp"
#include "engine/units.hpp"

namespace kinegraph {
namespace {

/// Section by section.
class Reader : private FormReader {
public:
    Reader(const JsonSource& source, std::string name) : source_(source) { mechanism_.source = std::move(name); }

    Result<Mechanism> read() {
        for (const JsonValue& twice : source_.duplicates()) {
            fault(twice, quoted(twice.key()) + " stands twice in this object; rename one or take it out");
        }
        if (const JsonValue root = source_.root(); !root.is_object()) {
            fault(root, "a mechanism is a JSON object, not " + described(root));
        } else {
            read_file(root);
        }
        if (faults_.empty()) return std::move(mechanism_);
        std::stable_sort(faults_.begin(), faults_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        Errors errors;
        errors.reserve(faults_.size());
        for (auto& [order, error] : faults_) errors.push_back(std::move(error));
        return tl::make_unexpected(std::move(errors));
    }

private:
    // ----- the file

    void read_file(JsonValue root) {
        const Members file = members(root,
                                     {"$schema", "kinegraph", "title", "units", "frame", "points", "bodies", "joints", "drivers",
                                      "masses", "gravity", "inertia forces", "loads", "effort", "motion", "find", "scales"},
                                     "a mechanism");
        const JsonValue version = required(file, "kinegraph", "write \"kinegraph\": 1, the version of the format");
        if (version) read_version(version);
        if (file["$schema"]) expect(file["$schema"], Kind::string, "a text");
        if (file["title"]) mechanism_.title = words(file["title"]);
        read_units(file["units"]);
        const JsonValue points = required(file, "points", "an object of points by name");
        const JsonValue bodies = required(file, "bodies", "an object of bodies by name");
        if (points && expect(points, Kind::object, "an object of points by name")) {
            points_known_ = true;
            for (const JsonValue member : points) register_point(member);
        }
        const bool bodies_readable = bodies && expect(bodies, Kind::object, "an object of bodies by name");
        bodies_known_ = bodies_readable;
        register_bodies(file["frame"], bodies_readable ? bodies : JsonValue());
        if (points_known_) read_points(points);
        if (bodies_readable) read_bodies(bodies);
        read_joints(file);
        each(file["drivers"], "an array of drivers", [&](JsonValue v) { read_driver(v); });
        read_masses(file["masses"]);
        mechanism_.gravity = vector(file["gravity"], QuantityKind::acceleration, "a vector [gx, gy]");
        if (const JsonValue inertia = file["inertia forces"]; inertia && expect(inertia, Kind::boolean, "true or false")) {
            mechanism_.inertia_forces = is_true(inertia);
        }
        each(file["loads"], "an array of loads", [&](JsonValue v) { read_load(v); });
        if (const JsonValue effort = file["effort"]; effort && effort.is_object()) {
            read_effort(effort);
        } else {
            each(effort, "an array of efforts", [&](JsonValue v) { read_effort(v); });
        }
        if (file["motion"]) read_motion(file["motion"]);
        if (file["find"]) mechanism_.find.stated = true;
        each(file["find"], "an array of what to find", [&](JsonValue v) { read_wish(v); });
        read_scales(file["scales"]);
    }

    template <class Action>
    void each(JsonValue array, std::string_view wanted, Action&& action) {
        if (!array || !expect(array, Kind::array, wanted)) return;
        for (const JsonValue element : array) action(element);
    }

    void read_version(JsonValue version) {
        const auto number = version.is_number() ? read_decimal(version.text()) : tl::expected<Exact, std::string>(Exact());
        if (!number || *number != Exact(1)) {
            fault(version, "the version of the format is 1, not " + described(version) + "; a newer program may read this file");
        }
    }

    // ----- units

    void read_units(JsonValue units) {
        constexpr std::array kinds{
            std::pair{std::string_view("length"), QuantityKind::length},
            std::pair{std::string_view("angle"), QuantityKind::angle},
            std::pair{std::string_view("angular velocity"), QuantityKind::angular_velocity},
            std::pair{std::string_view("velocity"), QuantityKind::velocity},
            std::pair{std::string_view("acceleration"), QuantityKind::acceleration},
            std::pair{std::string_view("mass"), QuantityKind::mass},
            std::pair{std::string_view("force"), QuantityKind::force},
            std::pair{std::string_view("moment"), QuantityKind::moment},
            std::pair{std::string_view("inertia"), QuantityKind::inertia},
        };
        if (units && expect(units, Kind::object, "an object of units by quantity")) {
            const Members set = members(
                units, {"length", "angle", "angular velocity", "velocity", "acceleration", "mass", "force", "moment", "inertia"},
                "\"units\"");
            for (const auto& [key, kind] : kinds) {
                if (set[key]) read_unit(set[key], kind);
            }
        }
        Units& all = mechanism_.units;
        const std::array<Unit*, kinds.size()> targets{&all.length,   &all.angle,        &all.angular_velocity,
                                                      &all.velocity, &all.acceleration, &all.mass,
                                                      &all.force,    &all.moment,       &all.inertia};
        for (std::size_t i = 0; i < kinds.size(); ++i) {
            const KnownUnit& unit = bare_unit(kinds[i].second);
            *targets[i] = {std::string(unit.symbol), unit.si};
        }
    }

    void read_unit(JsonValue value, QuantityKind kind) {
        if (!expect(value, Kind::string, "a unit")) return;
        const KnownUnit* unit = unit_spelt(value.text());
        if (unit == nullptr) {
            fault(value, unknown_unit_message(value.text(), kind));
        } else if (unit->kind != kind) {
            fault(value, quoted(value.text()) + " is a unit of " + std::string(name_of(unit->kind)) + "; the units of " +
                             std::string(name_of(kind)) + " are " + units_of(kind));
        } else {
            bare_units_.push_back(unit);
        }
    }

    // ----- points

    void register_point(JsonValue member) {
        if (!points_by_name_.emplace(member.key(), PointIndex(point_names_.size())).second) return;
        point_names_.push_back(member.key());
        check_name(member, member.key());
    }

    void read_points(JsonValue points) {
        Dependencies graph;
        std::vector<JsonValue> places;
        graph.first.push_back(0);
        collected_ = &graph.targets;
        mechanism_.points.reserve(point_names_.size());
        for (const JsonValue member : points) {
            const bool again = points_by_name_.at(member.key()) != PointIndex(mechanism_.points.size());
            if (again) {
                // A second one of the same name: its own faults are told, but it is not in the drawing.
                const std::size_t kept = graph.targets.size();
                placement(member);
                graph.targets.resize(kept);
                continue;
            }
            mechanism_.points.push_back({std::string(member.key()), placement(member), member.pointer()});
            places.push_back(member);
            graph.first.push_back(graph.targets.size());
        }
        collected_ = nullptr;
        for (const auto& cycle : cycles(graph)) report_cycle(cycle, places);
    }

    void report_cycle(const std::vector<PointIndex>& cycle, const std::vector<JsonValue>& places) {
        constexpr std::size_t most_named = 12;
        const auto name = [&](PointIndex i) { return quoted(point_names_[at_index(i)]); };
        std::string chain = name(cycle.front());
        for (std::size_t i = 1; i < std::min(cycle.size(), most_named); ++i) chain += " → " + name(cycle[i]);
        if (cycle.size() > most_named) chain += " → … (" + std::to_string(cycle.size()) + " points)";
        chain += " → " + name(cycle.front());
        fault(places[at_index(cycle.front())],
              cycle.size() == 1
                  ? "the point " + name(cycle.front()) + " is placed by itself; place it by others or by coordinates"
                  : "these points are placed by each other in a cycle: " + chain +
                        "; place one of them by others or by coordinates");
    }

    Placement placement(JsonValue value) {
        if (value.is_array())
            return Coordinates{vector(value, QuantityKind::length, "a pair of coordinates [x, y]").value_or(Vector{})};
        if (!value.is_object()) {
            fault(value, "a point is [x, y] or an object that says how to place it, not " + described(value));
            return Coordinates{};
        }
        if (value["meet"] || value["near"] || value["side"]) return meet(value);
        if (value["to"] || value["ratio"]) return point_on_line(value);
        if (value["circle"] || value["line"]) {
            fault(value, "a curve alone is no point; write {\"meet\": [curve, curve]}");
            return Coordinates{};
        }
        const Members form = members(value, {"from", "distance", "angle", "relative to", "to", "ratio", "meet"}, "a point");
        if (form.has_or_misspells("meet") || form.has_or_misspells("to") || form.has_or_misspells("ratio")) return Coordinates{};
        Polar polar;
        polar.from = point(required(form, "from", "the point from which the distance is taken"));
        polar.distance = quantity_or_zero(required(form, "distance", "how far from there the point lies"), QuantityKind::length);
        polar.angle = angle(required(form, "angle", "in which direction (or give \"to\")")).value_or(Angle{});
        if (const JsonValue base = form["relative to"]) {
            if (base.is_array() && base.size() == 2) {
                polar.relative_to = between(base);
            } else {
                fault(base, "the names of two points [\"P\", \"Q\"] are wanted here, not " + described(base));
            }
        }
        return polar;
    }

    Placement point_on_line(JsonValue value) {
        const Members form = members(value, {"from", "to", "distance", "ratio"}, "a point on a line");
        Along along;
        along.from = point(required(form, "from", "the point from which the distance is taken"));
        along.to = point(required(form, "to", "the point towards which it is taken"));
        if (along.from != none && along.from == along.to) fault(form["to"], "a point and itself give no line; name another");
        if (const JsonValue amount = one_of(form, {"distance", "ratio"})) {
            along.is_ratio = amount.key() == "ratio";
            along.amount =
                along.is_ratio ? bare_number(amount).value_or(Exact()) : quantity_or_zero(amount, QuantityKind::length);
        }
        return along;
    }

    Placement meet(JsonValue value) {
        const Members form = members(value, {"meet", "near", "side"}, "a meet");
        Meet meet;
        if (const JsonValue curves = required(form, "meet", "two curves"); curves) {
            if (curves.is_array() && curves.size() == 2) {
                meet.first = curve(*curves.begin());
                meet.second = curve(*++curves.begin());
            } else {
                fault(curves, "two curves are wanted here, not " + described(curves));
            }
        }
        one_of(form, {"near", "side"}, false);
        meet.near = vector(form["near"], QuantityKind::length, "a place [x, y]");
        if (const JsonValue side = form["side"]) {
            if (side.is_string() && side.text() == "left") {
                meet.side = Meet::Side::left;
            } else if (side.is_string() && side.text() == "right") {
                meet.side = Meet::Side::right;
            } else {
                fault(side, "\"left\" or \"right\" is wanted here, not " + described(side));
            }
        }
        return meet;
    }

    Curve curve(JsonValue value) {
        if (!expect(value, Kind::object, "a curve, {\"circle\": …} or {\"line\": …},")) return CircleCurve{};
        if (value["circle"] || value["radius"]) {
            const Members form = members(value, {"circle", "radius"}, "a circle");
            CircleCurve circle;
            if (const JsonValue centre = required(form, "circle", "the circle's centre")) circle.centre = place(centre);
            circle.radius = positive(required(form, "radius", "the circle's radius"), QuantityKind::length, "a radius");
            return circle;
        }
        const Members form = members(value, {"line", "angle", "to", "parallel", "perpendicular", "circle"}, "a line");
        LineCurve line;
        if (form.has_or_misspells("circle")) return line;
        if (const JsonValue through = required(form, "line", "a point on the line")) line.through = place(through);
        const JsonValue how = one_of(form, {"angle", "to", "parallel", "perpendicular"});
        if (!how) return line;
        if (how.key() == "angle") {
            line.angle = angle(how).value_or(Angle{});
        } else if (how.key() == "to") {
            line.by = LineCurve::By::to;
            line.to = point(how);
            const auto* through = std::get_if<PointIndex>(&line.through);
            if (through != nullptr && *through != none && *through == line.to)
                fault(how, "a point and itself give no line; name another");
        } else {
            line.by = how.key() == "parallel" ? LineCurve::By::parallel : LineCurve::By::perpendicular;
            line.bearing = bearing_or_default(how);
        }
        return line;
    }

    // ----- bodies

    void register_bodies(JsonValue frame, JsonValue bodies) {
        std::string_view frame_name = "0";
        if (frame) {
            if (frame.is_string() || is_whole_number(frame)) {
                frame_name = frame.text();
                check_name(frame, frame_name);
            } else {
                fault(frame, "a body's name is wanted here, not " + described(frame));
                bodies_known_ = false;
            }
        }
        const auto add = [&](std::string_view name, std::string where) {
            if (!bodies_by_name_.emplace(name, BodyIndex(body_names_.size())).second) return false;
            body_names_.push_back(name);
            Body added;
            added.name = name;
            added.where = std::move(where);
            mechanism_.bodies.push_back(std::move(added));
            return true;
        };
        add(frame_name, frame ? frame.pointer() : "");
        if (!bodies) return;
        for (const JsonValue member : bodies) {
            if (add(member.key(), member.pointer())) {
                check_name(member, member.key());
            } else if (member.key() == frame_name) {
                mechanism_.bodies.front().where = member.pointer();
            }
        }
    }

    Body& body_at(BodyIndex index) { return mechanism_.bodies[at_index(index)]; }

    void carry(BodyIndex on, PointIndex carried) {
        if (on == none || carried == none) return;
        const std::uint64_t pair =
            (static_cast<std::uint64_t>(on.number()) << 32U) | static_cast<std::uint64_t>(carried.number());
        if (carried_.insert(pair).second) body_at(on).points.push_back(carried);
    }

    void read_bodies(JsonValue bodies) {
        for (const JsonValue member : bodies) {
            const BodyIndex index = bodies_by_name_.at(member.key());
            JsonValue points = member;
            if (member.is_object()) {
                const Members form = members(member, {"points", "label", "circle"}, "a body");
                points = form["points"];
                if (form["label"]) body_at(index).label = words(form["label"]);
                if (form["circle"]) read_body_circle(form["circle"], index);
                if (!points) continue;
                if (!expect(points, Kind::array, "an array of points")) continue;
            } else if (!expect(points, Kind::array, "an array of points, or {\"points\": […], …},")) {
                continue;
            }
            for (const JsonValue name : points) carry(index, point(name, true));
        }
    }

    void read_body_circle(JsonValue value, BodyIndex index) {
        if (!expect(value, Kind::object, "{\"centre\": …, \"radius\": …}")) return;
        const Members form = members(value, {"centre", "radius"}, "a body's circle");
        Circle circle;
        circle.centre = point(required(form, "centre", "the circle's centre"));
        circle.radius = positive(required(form, "radius", "the circle's radius"), QuantityKind::length, "a radius");
        body_at(index).circle = std::move(circle);
    }

    // ----- joints

    void read_joints(const Members& file) {
        const JsonValue joints = file["joints"];
        if (file["motion"]) {
            for (const std::string_view key : {"joints", "drivers"}) {
                if (file[key])
                    fault(file[key], '"' + std::string(key) + "\" and \"motion\" do not go together; take one of them out");
            }
        } else if (!file.has_or_misspells("motion")) {
            required(file, "joints", "an array of joints (or \"motion\", one body's act of motion)");
        }
        joints_known_ = joints && joints.is_array();
        each(joints, "an array of joints", [&](JsonValue v) { read_joint(v); });
    }

    void read_joint(JsonValue value) {
        if (!expect(value, Kind::object, "a joint")) {
            joints_known_ = false;
            return;
        }
        const PlanePair* pair = nullptr;
        for (const PlanePair& candidate : plane_pairs) {
            if (!value[candidate.key]) continue;
            if (pair != nullptr) {
                fault(value[candidate.key], "a joint is of one kind; this one is " + quoted(pair->key) + " already");
                joints_known_ = false;
                return;
            }
            pair = &candidate;
        }
        if (pair == nullptr) return miss_kind(value);
        Joint joint;
        joint.kind = pair->kind;
        joint.where = value.pointer();
        const Members form = members(value, keys_of(*pair), pair->called);
        const JsonValue at = form[pair->key];
        joint.point = point(at);
        joint.name = at.is_string() ? at.text() : std::string_view();
        if (form["name"]) {
            joint.named = true;
            joint.name = new_name(form["name"], "a name");
        }
        if (!at.is_string() && !joint.named) joints_known_ = false;
        read_joint_bodies(form, joint);
        if (pair->is_sleeve()) joint.along = bearing(required(form, "along", "the direction of the guide"));
        if (pair->is_slot()) read_slot(form, joint);
        if (pair->touches()) read_profiles(form, joint);
        joint.pushes = sense(form["pushes"]);
        if (const JsonValue pressure = form["pressure angle"]) {
            joint.pressure_angle = angle(pressure);
            if (joint.pressure_angle) check_pressure_angle(pressure, *joint.pressure_angle);
        }
        if (const JsonValue arm = form["arm"]) {
            joint.arm = body(arm);
            if (joint.connects(joint.arm) && joint.arm != none) {
                fault(arm, "the carrier of the two gears is a third body");
            }
        }
        if (pair->has_common_point()) {
            for (const BodyIndex on : joint.bodies) carry(on, joint.point);
        }
        if (pair->has_guide() && !joint.name.empty()) {
            const auto [found, first] = sliding_keys_.emplace(joint.name, joint.where);
            if (!first) {
                fault(value, "two sliding joints are called " + quoted(joint.name) + " (the other is " + found->second +
                                 "); give one of them a \"name\"");
            } else {
                sliding_by_name_.emplace(joint.name, JointIndex(mechanism_.joints.size()));
                sliding_names_.push_back(joint.named ? form["name"].text() : at.text());
            }
        }
        if (!pair->has_guide() && !joint.name.empty()) other_joints_.emplace(joint.name, pair->key);
        mechanism_.joints.push_back(std::move(joint));
    }

    /// The key that is meant to be the kind is misspelt, or there is none.
    void miss_kind(JsonValue value) {
        joints_known_ = false;
        std::vector<std::string_view> kinds;
        for (const PlanePair& pair : plane_pairs) kinds.push_back(pair.key);
        std::vector<std::string_view> keys = kinds;
        for (const PlanePair& pair : plane_pairs)
            for (const std::string_view key : keys_of(pair))
                if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
        if (!members(value, keys, "a joint").has_misspelt())
            fault(value, "the kind of joint is missing: one of " + listed(kinds));
    }

    /// What a joint of this kind may say: of its kind, of its bodies, of what is its own.
    static std::vector<std::string_view> keys_of(const PlanePair& pair) {
        std::vector<std::string_view> keys{pair.key, "bodies"};
        std::copy_if(pair.members.begin(), pair.members.end(), std::back_inserter(keys), [](auto key) { return !key.empty(); });
        keys.emplace_back("name");
        return keys;
    }

    void read_joint_bodies(const Members& form, Joint& joint) {
        const JsonValue bodies = required(form, "bodies", "the bodies that the joint connects");
        if (!bodies || !expect(bodies, Kind::array, "an array of bodies")) return;
        const bool any_number = joint.pair().joins_many;
        if (bodies.size() < 2 || (bodies.size() > 2 && !any_number)) {
            fault(bodies,
                  std::string(any_number ? "two bodies or more" : "two bodies") + " are wanted here, not " + described(bodies));
        }
        std::set<BodyIndex> seen;
        for (const JsonValue name : bodies) {
            const BodyIndex connected = body(name);
            if (connected != none && !seen.insert(connected).second) {
                fault(name, "the body " + quoted(name.text()) + " stands twice in one joint");
            }
            joint.bodies.push_back(connected);
        }
    }

    void read_slot(const Members& form, Joint& joint) {
        const JsonValue shape = one_of(form, {"along", "arc"});
        if (!shape) return;
        if (shape.key() == "along") {
            joint.along = bearing(shape);
        } else {
            joint.arc = point(shape);
            if (joint.arc != none && joint.arc == joint.point)
                fault(shape, "a slot about its own pin has no radius; name the arc's centre");
        }
    }

    void check_pressure_angle(JsonValue value, const Angle& angle) {
        const Exact right_angle = angle.in_degrees ? Exact(90) : pi() / 2;
        if (angle.value.sign() < 0 || angle.value >= right_angle) fault(value, "a pressure angle lies between 0° and 90°");
    }

    void read_profiles(const Members& form, Joint& joint) {
        const JsonValue shape = one_of(form, {"profiles", "tangent"}, false);
        if (form["profiles"] && form["tangent"]) return;
        if (shape && shape.key() == "tangent") {
            joint.tangent = bearing(shape);
            return;
        }
        if (form.has_or_misspells("tangent") || (!shape && form.has_or_misspells("profiles"))) return;
        bool complete = joint.bodies.size() == 2 && joint.bodies[0] != none && joint.bodies[1] != none;
        if (shape) {
            if (!expect(shape, Kind::object, "an object of profiles by body")) return;
            for (const JsonValue member : shape) complete = read_profile(member, joint) && complete;
        }
        if (!complete) return;
        const JsonValue place = shape ? shape : form.object();
        for (const BodyIndex on : joint.bodies) {
            if (joint.profiles.contains(on)) continue;
            const Body& owner = body_at(on);
            if (owner.circle) {
                if (owner.circle->centre == joint.point && joint.point != none) {
                    fault(place, "the circle of body " + quoted(owner.name) + " has its centre at the contact itself");
                }
                joint.profiles.emplace(on, CircleProfile{owner.circle->centre});
            } else {
                fault(place, "the profile of body " + quoted(owner.name) +
                                 " is missing: give it under \"profiles\", or the body a \"circle\", or the joint a \"tangent\"");
                complete = false;
            }
        }
        if (!complete || joint.bodies[0] == joint.bodies[1]) return;
        const Profile& first = joint.profiles.at(joint.bodies[0]);
        const Profile& second = joint.profiles.at(joint.bodies[1]);
        if (std::holds_alternative<LineProfile>(first) && std::holds_alternative<LineProfile>(second)) {
            fault(place, "two lines are no contact: they touch everywhere or nowhere; one of the bodies has another profile");
        }
        if (std::holds_alternative<TipProfile>(first) && std::holds_alternative<TipProfile>(second)) {
            fault(place, "two tips are no contact: they have no common tangent; one of the bodies has another profile");
        }
    }

    bool read_profile(JsonValue member, Joint& joint) {
        const BodyIndex on = look_up_body(member, member.key());
        if (on != none && !joint.connects(on)) {
            if (!joint.connects(none)) {
                fault(member, "the body " + quoted(member.key()) + " is not in this joint");
            }
            return false;
        }
        if (!expect(member, Kind::object, "a profile, {\"line\": …}, {\"circle\": …} or {\"tip\": true},")) return false;
        const Members form = members(member, {"line", "circle", "tip"}, "a profile");
        const JsonValue shape = one_of(form, {"line", "circle", "tip"});
        if (!shape) return false;
        if (shape.key() == "line") {
            const auto along = bearing(shape);
            if (!along) return false;
            joint.profiles.emplace(on, LineProfile{*along});
        } else if (shape.key() == "circle") {
            const PointIndex centre = point(shape);
            if (centre != none && centre == joint.point)
                fault(shape, "a circle about the contact itself has no radius; name its centre");
            joint.profiles.emplace(on, CircleProfile{centre});
        } else {
            if (!is_true(shape)) {
                fault(shape, "a tip is {\"tip\": true}");
                return false;
            }
            joint.profiles.emplace(on, TipProfile{});
        }
        return on != none;
    }

    /// A sliding joint by its name, or none with a fault; `remedy` is for those who name a joint of another kind.
    JointIndex sliding_joint(JsonValue value, std::string_view remedy) {
        if (!value || !expect(value, Kind::string, "a joint's name")) return none;
        const std::string name(value.text());
        if (const auto found = sliding_by_name_.find(name); found != sliding_by_name_.end()) return found->second;
        if (const auto other = other_joints_.find(name); other != other_joints_.end()) {
            fault(value,
                  "the joint " + quoted(name) + " is of kind \"" + std::string(other->second) + "\"; " + std::string(remedy));
        } else if (joints_known_) {
            fault(value, "no sliding joint is named " + quoted(name) + did_you_mean(speller_.nearest(name, sliding_names_)));
        }
        return none;
    }

    // ----- drivers

    void read_driver(JsonValue value) {
        if (!expect(value, Kind::object, "a driver")) return;
        if (value["joint"]) {
            const Members form = members(value, {"joint", "speed", "acceleration"}, "a driver of a joint");
            SlideDriver driver;
            driver.where = value.pointer();
            driver.joint =
                sliding_joint(form["joint"], "a driver moves a prismatic joint or a straight pin-slot; drive a \"body\" here");
            if (driver.joint != none && mechanism_.joint(driver.joint).arc != none) {
                fault(form["joint"], "the slot of " + quoted(form["joint"].text()) + " is curved; drive a \"body\" instead");
            }
            driver.speed = quantity_or_zero(form["speed"], QuantityKind::velocity);
            driver.acceleration = quantity_or_zero(form["acceleration"], QuantityKind::acceleration);
            mechanism_.drivers.emplace_back(std::move(driver));
            return;
        }
        constexpr std::string_view frame_rests = "the frame does not move; drive another body";
        if (value["at"] || value["along"] || value["speed"] || value["acceleration"]) {
            const Members form = members(value, {"body", "at", "along", "speed", "acceleration", "joint"}, "a driver of a point");
            PointDriver driver;
            driver.where = value.pointer();
            if (form.has_or_misspells("joint")) return;
            if (!form.has_or_misspells("body") && !form.has_or_misspells("at") && !form.has_or_misspells("along")) {
                fault(value, "what is driven is missing: \"joint\", or \"body\", \"at\" and \"along\"");
                return;
            }
            driver.body = moving_body(required(form, "body", "the body that is driven"), frame_rests);
            driver.at = point(required(form, "at", "the point that is driven"));
            driver.along = bearing_or_default(required(form, "along", "the direction in which it is driven"));
            driver.speed = quantity_or_zero(form["speed"], QuantityKind::velocity);
            driver.acceleration = quantity_or_zero(form["acceleration"], QuantityKind::acceleration);
            mechanism_.drivers.emplace_back(std::move(driver));
            return;
        }
        const Members form = members(
            value, {"body", "relative to", "omega", "alpha", "joint", "at", "along", "speed", "acceleration"}, "a driver");
        for (const std::string_view key : {"joint", "at", "along", "speed", "acceleration"}) {
            if (form.has_or_misspells(key)) return;
        }
        SpinDriver driver;
        driver.where = value.pointer();
        driver.body = moving_body(required(form, "body", "the body that is driven (or give \"joint\")"), frame_rests);
        if (const JsonValue base = form["relative to"]) {
            driver.relative_to = body(base);
            if (driver.relative_to > frame && driver.relative_to == driver.body)
                fault(base, "a body does not turn against itself; name another");
        }
        driver.omega = quantity_or_zero(form["omega"], QuantityKind::angular_velocity);
        driver.alpha = quantity_or_zero(form["alpha"], QuantityKind::angular_acceleration);
        mechanism_.drivers.emplace_back(std::move(driver));
    }

    // ----- forces

    void read_masses(JsonValue masses) {
        if (!masses || !expect(masses, Kind::object, "an object of masses by body")) return;
        for (const JsonValue member : masses) {
            Mass mass;
            mass.where = member.pointer();
            mass.body = look_up_body(member, member.key());
            if (!expect(member, Kind::object, "{\"mass\": …, \"centre\": …, \"inertia\": …}")) continue;
            const Members form = members(member, {"mass", "centre", "inertia"}, "a body's mass");
            mass.mass = not_negative(required(form, "mass", "how much it is"), QuantityKind::mass, "a mass");
            mass.centre = point(required(form, "centre", "the centre of mass"));
            mass.inertia = not_negative(form["inertia"], QuantityKind::inertia, "a moment of inertia");
            mechanism_.masses.push_back(std::move(mass));
        }
    }

    void read_load(JsonValue value) {
        if (!expect(value, Kind::object, "a load")) return;
        if (value["couple"]) {
            const Members form = members(value, {"couple", "body", "value", "force"}, "a couple");
            one_of(form, {"couple", "force"});
            CoupleLoad couple;
            couple.where = value.pointer();
            couple.name = new_name(form["couple"], "the couple's name");
            couple.body = body(required(form, "body", "the body on which it acts"));
            couple.value = quantity_or_zero(required(form, "value", "the couple's size"), QuantityKind::moment);
            mechanism_.loads.emplace_back(std::move(couple));
        } else if (value["bodies"] || value["between"]) {
            read_spring(value);
        } else {
            read_force(value);
        }
    }

    void read_spring(JsonValue value) {
        const Members form = members(value, {"force", "bodies", "between", "magnitude"}, "a force between two bodies");
        SpringLoad spring;
        spring.where = value.pointer();
        if (const JsonValue name = required(form, "force", "the force's name")) spring.name = new_name(name, "the force's name");
        if (const JsonValue bodies = required(form, "bodies", "the two bodies that are pulled together")) {
            if (bodies.is_array() && bodies.size() == 2) {
                const JsonValue second = *++bodies.begin();
                spring.bodies = {body(*bodies.begin()), body(second)};
                if (spring.bodies[0] != none && spring.bodies[0] == spring.bodies[1]) {
                    fault(second, "the body " + quoted(second.text()) + " stands twice; a spring is between two bodies");
                }
            } else {
                fault(bodies, "two bodies are wanted here, not " + described(bodies));
            }
        }
        if (const JsonValue ends = required(form, "between", "the two points at which they are pulled")) {
            if (ends.is_array() && ends.size() == 2) {
                const Bearing::Between points = between(ends);
                spring.between = {points.from, points.to};
            } else {
                fault(ends, "two points are wanted here, not " + described(ends));
            }
        }
        spring.magnitude = quantity_or_zero(required(form, "magnitude", "how hard they are pulled"), QuantityKind::force);
        mechanism_.loads.emplace_back(std::move(spring));
    }

    void read_force(JsonValue value) {
        const Members form =
            members(value, {"force", "body", "at", "value", "magnitude", "along", "couple", "bodies", "between"}, "a force");
        if (form.has_or_misspells("couple") || form.has_or_misspells("bodies") || form.has_or_misspells("between")) return;
        if (!form.has_or_misspells("force")) {
            fault(value, "the load's name is missing: \"force\" or \"couple\"");
            return;
        }
        ForceLoad force;
        force.where = value.pointer();
        if (const JsonValue name = required(form, "force", "the force's name (or \"couple\")"))
            force.name = new_name(name, "the force's name");
        force.body = body(required(form, "body", "the body on which it acts"));
        force.at = point(required(form, "at", "the point at which it acts"));
        const JsonValue how = one_of(form, {"value", "magnitude"});
        if (how && how.key() == "value") {
            one_of(form, {"value", "along"});
            force.value = vector(how, QuantityKind::force, "a force [Fx, Fy]");
        } else if (how) {
            const auto magnitude = quantity(how, QuantityKind::force);
            const auto along = bearing(required(form, "along", "the direction of the force"));
            if (magnitude && along) force.magnitude = {*magnitude, *along};
        }
        mechanism_.loads.emplace_back(std::move(force));
    }

    void read_effort(JsonValue value) {
        if (!expect(value, Kind::object, "an effort")) return;
        constexpr std::string_view frame_rests = "an effort on the frame balances nothing; name a body that moves";
        std::string name;
        JsonValue name_value;
        const auto take_name = [&](JsonValue given, std::string_view wanted) {
            name_value = given;
            if (given) name = new_name(given, wanted);
        };
        if (value["couple"]) {
            const Members form = members(value, {"couple", "body", "from", "force"}, "a couple that balances");
            one_of(form, {"couple", "force"});
            take_name(form["couple"], "the couple's name");
            CoupleEffort couple;
            couple.where = value.pointer();
            couple.body = body(required(form, "body", "the body on which it acts"));
            if (const JsonValue from = form["from"]) couple.from = body(from);
            if (couple.body != none && couple.body == couple.from) {
                fault(form["from"] ? form["from"] : form["body"],
                      form["from"] ? "a couple from a body on itself balances nothing; name another" : std::string(frame_rests));
            }
            couple.name = name;
            mechanism_.efforts.emplace_back(std::move(couple));
        } else if (value["joint"]) {
            const Members form = members(value, {"force", "joint"}, "an actuator");
            take_name(required(form, "force", "the force's name"), "the force's name");
            ActuatorEffort actuator;
            actuator.where = value.pointer();
            constexpr std::string_view remedy = "an actuator works in a prismatic joint";
            actuator.joint = sliding_joint(form["joint"], remedy);
            if (actuator.joint != none) {
                const PlanePair& pair = mechanism_.joint(actuator.joint).pair();
                if (!pair.is_sleeve())
                    fault(form["joint"], "the joint " + quoted(form["joint"].text()) + " is of kind \"" + std::string(pair.key) +
                                             "\"; " + std::string(remedy));
            }
            actuator.name = name;
            mechanism_.efforts.emplace_back(std::move(actuator));
        } else {
            const Members form = members(value, {"force", "body", "at", "along", "couple", "joint"}, "a force that balances");
            if (form.has_or_misspells("couple") || form.has_or_misspells("joint")) return;
            if (!form.has_or_misspells("force")) {
                fault(value, "the effort's name is missing: \"force\" or \"couple\"");
                return;
            }
            take_name(form["force"], "the force's name");
            ForceEffort force;
            force.where = value.pointer();
            force.body = moving_body(required(form, "body", "the body on which it acts (or give \"joint\")"), frame_rests);
            force.at = point(required(form, "at", "the point at which it acts"));
            force.along = bearing_or_default(required(form, "along", "the direction of the force"));
            force.name = name;
            mechanism_.efforts.emplace_back(std::move(force));
        }
        if (!name.empty() && !effort_names_.insert(name).second) {
            fault(name_value, "two efforts are named " + quoted(name) + "; results go by the name, so rename one");
        }
    }

    // ----- motion, wishes, scales

    void read_motion(JsonValue value) {
        if (!expect(value, Kind::object, "an act of motion, {\"body\": …, \"velocities\": {…}},")) return;
        const Members form = members(value, {"body", "velocities", "accelerations"}, "an act of motion");
        ActOfMotion motion;
        motion.where = value.pointer();
        motion.body = moving_body(required(form, "body", "the body that moves"), "the frame does not move; name another body");
        if (const JsonValue velocities = required(form, "velocities", "what is known of the velocities of its points")) {
            motion.velocities = given_motions(motion.body, velocities, QuantityKind::velocity);
        }
        if (const JsonValue accelerations = form["accelerations"]) {
            motion.accelerations = given_motions(motion.body, accelerations, QuantityKind::acceleration);
        }
        mechanism_.motion = std::move(motion);
    }

    /// The points named move with the body, listed there or not.
    std::vector<GivenMotion> given_motions(BodyIndex on, JsonValue value, QuantityKind kind) {
        std::vector<GivenMotion> motions;
        if (!expect(value, Kind::object, "an object of vectors by point")) return motions;
        for (const JsonValue member : value) {
            GivenMotion given;
            given.point = look_up_point(member, member.key());
            carry(on, given.point);
            if (member.is_object()) {
                const Members form = members(member, {"along"}, "what is known of a vector");
                given.value = bearing_or_default(required(form, "along", "the direction of the vector"));
            } else {
                given.value = vector(member, kind, "a vector [x, y] or {\"along\": X}").value_or(Vector{});
            }
            motions.push_back(std::move(given));
        }
        return motions;
    }

    void read_wish(JsonValue value) {
        constexpr std::array<std::string_view, 4> wishes{"instant centres", "velocity", "acceleration", "forces"};
        Find& find = mechanism_.find;
        const std::array<bool*, wishes.size()> flags{&find.instant_centres, &find.velocity, &find.acceleration, &find.forces};
        if (value.is_string()) {
            const auto* const known = std::find(wishes.begin(), wishes.end(), value.text());
            if (known != wishes.end()) {
                *flags[static_cast<std::size_t>(known - wishes.begin())] = true;
                return;
            }
            const auto meant = speller_.nearest(value.text(), wishes);
            fault(value, quoted(value.text()) + " is nothing to find" +
                             (meant ? did_you_mean(meant)
                                    : "; what can be found is " + listed(wishes) + " and {\"relative motion\": …}"));
            return;
        }
        if (!expect(value, Kind::object, "a wish, as \"velocity\" or {\"relative motion\": …, \"observer\": …},")) return;
        const Members form = members(value, {"relative motion", "observer"}, "a wish");
        RelativeMotionQuery query;
        query.where = value.pointer();
        query.point = point(required(form, "relative motion", "the point whose motion is observed"));
        const JsonValue observer = required(form, "observer", "the body that carries the observer, or {\"translating with\": Q}");
        if (observer && observer.is_object()) {
            const Members frame = members(observer, {"translating with"}, "an observer");
            query.translating_with = point(required(frame, "translating with", "the point that carries the observer"));
        } else {
            query.observer = body(observer);
        }
        find.relative_motion.push_back(std::move(query));
    }

    void read_scales(JsonValue value) {
        if (!value || !expect(value, Kind::object, "an object of scales by figure")) return;
        constexpr std::array figures{
            std::pair{std::string_view("mechanism"), QuantityKind::length},
            std::pair{std::string_view("centres"), QuantityKind::length},
            std::pair{std::string_view("velocity"), QuantityKind::velocity},
            std::pair{std::string_view("acceleration"), QuantityKind::acceleration},
            std::pair{std::string_view("body"), QuantityKind::force},
            std::pair{std::string_view("forces"), QuantityKind::force},
            std::pair{std::string_view("closure"), QuantityKind::force},
        };
        const Members form =
            members(value, {"mechanism", "centres", "velocity", "acceleration", "body", "forces", "closure"}, "\"scales\"");
        for (const auto& [figure, kind] : figures) {
            const JsonValue scale = form[figure];
            if (!scale) continue;
            auto per_millimetre = scale.is_string()
                                      ? read_scale(scale.text(), kind)
                                      : tl::expected<Exact, std::string>(tl::make_unexpected(
                                            "a scale" + scale_example(kind) + " is wanted here, not " + described(scale)));
            if (per_millimetre) {
                mechanism_.scales.push_back({std::string(figure), std::move(*per_millimetre), scale.pointer()});
            } else {
                fault(scale, std::move(per_millimetre.error()));
            }
        }
        // In the file's order, whatever the order of the table.
        std::unordered_map<std::string_view, std::uint32_t> order;
        for (const JsonValue member : value) order.emplace(member.key(), member.order());
        std::sort(mechanism_.scales.begin(), mechanism_.scales.end(),
                  [&](const AskedScale& a, const AskedScale& b) { return order.at(a.figure) < order.at(b.figure); });
    }

    const JsonSource& source_;
    Mechanism mechanism_;
    bool joints_known_ = false;  ///< as FormReader's
    std::unordered_map<std::string, JointIndex> sliding_by_name_;
    std::unordered_map<std::string, std::string>
        sliding_keys_;  ///< where each name stands; contacts have results under theirs too
    std::vector<std::string_view> sliding_names_;
    std::unordered_map<std::string, std::string_view> other_joints_;  ///< name → kind of those that do not slide
    std::unordered_set<std::string> effort_names_;
    std::unordered_set<std::uint64_t> carried_;  ///< (body, point)
};

template <class Item>
std::optional<ListIndex<Item>> named_in(const std::vector<Item>& items, std::string_view name) {
    const auto found = std::find_if(items.begin(), items.end(), [&](const Item& item) { return item.name == name; });
    if (found == items.end()) return std::nullopt;
    return ListIndex<Item>(found - items.begin());
}

}  // namespace

std::optional<PointIndex> Mechanism::point_named(std::string_view name) const { return named_in(points, name); }
std::optional<BodyIndex> Mechanism::body_named(std::string_view name) const { return named_in(bodies, name); }

Result<Mechanism> read_mechanism(std::string_view text, std::string source) {
    const Result<JsonSource> json = JsonSource::read(text);
    if (!json) return tl::make_unexpected(json.error());
    return Reader(*json, std::move(source)).read();
}

}  // namespace kinegraph
