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
#include "engine/drivers.hpp"
#include "engine/exercise_reader.hpp"
#include "engine/json_source.hpp"
#include "engine/law_reader.hpp"
#include "engine/mechanism.hpp"
#include "engine/point_cycles.hpp"
#include "engine/rounding.hpp"
#include "engine/scale_text.hpp"
#include "engine/spelling.hpp"
#include "engine/truss.hpp"
#include "engine/units.hpp"

namespace kinegraph {
namespace {

/// Section by section.
class Reader : private ExerciseReader {
public:
    Reader(const JsonSource& source, std::string name, std::span<const Setting> set) : source_(source), set_(set) {
        mechanism_.source = std::move(name);
    }

    Result<Mechanism> read() {
        for (const JsonValue& twice : source_.duplicates()) {
            fault(twice, {"{0} stands twice in this object; rename one or take it out",
                          "{0} compare due volte in questo oggetto; rinominare o togliere uno dei due", quoted(twice.key())});
        }
        if (const JsonValue root = source_.root(); !root.is_object()) {
            fault(root, {"a mechanism is a JSON object, not {0}", "un meccanismo è un oggetto JSON, non {0}", described(root)});
        } else {
            read_file(root);
        }
        if (faults_.empty()) return finished();
        std::stable_sort(faults_.begin(), faults_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        Errors errors;
        errors.reserve(faults_.size());
        for (auto& [order, error] : faults_) errors.push_back(std::move(error));
        return tl::make_unexpected(std::move(errors));
    }

private:
    /// Roots and sines are as exact as a compass that the file itself holds: what they leave open, the precision decides.
    Mechanism finished() {
        mechanism_.computed = std::move(computed_);
        std::sort(mechanism_.computed.begin(), mechanism_.computed.end());
        if (is_approximate_ && !mechanism_.precision && !looks_rounded(mechanism_)) mechanism_.precision = precision_of_roots();
        return std::move(mechanism_);
    }

    // ----- the file

    void read_file(JsonValue root) {
        const Members file = members(
            root, {"$schema", "kinegraph", "title",  "units",   "parameters",     "precision", "frame",  "points", "bodies",
                   "joints",  "drivers",   "masses", "gravity", "inertia forces", "loads",     "effort", "motion", "find",
                   "scales",  "hertz",     "reye",   "impact",  "positions",      "ask",       "vary",   "require"},
            {"a mechanism", "un meccanismo"});
        const JsonValue version =
            required(file, "kinegraph",
                     {"write \"kinegraph\": 1, the version of the format", "scrivere \"kinegraph\": 1, la versione del formato"});
        if (version) read_version(version);
        if (file["$schema"]) expect(file["$schema"], Kind::string, {"a text", "un testo"});
        if (file["title"]) mechanism_.title = words(file["title"]);
        read_units(file["units"]);
        read_parameters(file["parameters"], set_);
        if (file["precision"])
            mechanism_.precision = not_negative(file["precision"], QuantityKind::length, std::string("\"precision\""));
        // A problem names its bodies itself, and needs no points.
        const bool is_problem = states_problem(file);
        const auto wanted = [&](std::string_view key, const Words& what) {
            return is_problem ? file[key] : required(file, key, what);
        };
        const JsonValue points = wanted("points", {"an object of points by name", "un oggetto con i punti per nome"});
        const JsonValue bodies = wanted("bodies", {"an object of bodies by name", "un oggetto con i corpi per nome"});
        if (points && expect(points, Kind::object, {"an object of points by name", "un oggetto con i punti per nome"})) {
            points_known_ = true;
            for (const JsonValue member : points) register_point(member);
        }
        if (is_problem && !points) points_known_ = true;  // there are none
        const bool bodies_readable =
            bodies && expect(bodies, Kind::object, {"an object of bodies by name", "un oggetto con i corpi per nome"});
        bodies_known_ = bodies_readable;
        register_bodies(file["frame"], bodies_readable ? bodies : JsonValue());
        if (points && points_known_) read_points(points);
        if (bodies_readable) read_bodies(bodies);
        if (is_problem) {
            mechanism_.problem = read_problem(file, mechanism_);
            read_exercise(file, mechanism_);
            return;
        }
        read_joints(file);
        each(file["drivers"], {"an array of drivers", "un array di moventi"}, [&](JsonValue v) { read_driver(v); });
        read_masses(file["masses"]);
        mechanism_.gravity = vector(file["gravity"], QuantityKind::acceleration, {"a vector [gx, gy]", "un vettore [gx, gy]"});
        if (const JsonValue inertia = file["inertia forces"];
            inertia && expect(inertia, Kind::boolean, {"true or false", "true o false"})) {
            mechanism_.inertia_forces = is_true(inertia);
        }
        each(file["loads"], {"an array of loads", "un array di carichi"}, [&](JsonValue v) { read_load(v); });
        if (const JsonValue effort = file["effort"]; effort && effort.is_object()) {
            read_effort(effort);
        } else {
            each(effort, {"an array of efforts", "un array di azioni equilibranti"}, [&](JsonValue v) { read_effort(v); });
        }
        if (file["motion"]) read_motion(file["motion"]);
        if (file["find"]) mechanism_.find.stated = true;
        each(file["find"], {"an array of what to find", "un array di ciò che si cerca"}, [&](JsonValue v) { read_wish(v); });
        read_scales(file["scales"]);
        read_exercise(file, mechanism_);
        if (!cuts_.empty() && faults_.empty()) read_cuts();
    }

    template <class Action>
    void each(JsonValue array, const Words& wanted, Action&& action) {
        if (!array || !expect(array, Kind::array, wanted)) return;
        for (const JsonValue element : array) action(element);
    }

    void read_version(JsonValue version) {
        const auto number = version.is_number() ? read_decimal(version.text()) : tl::expected<Exact, Words>(Exact());
        if (!number || *number != Exact(1)) {
            fault(version, {"the version of the format is 1, not {0}; a newer program may read this file",
                            "la versione del formato è 1, non {0}; un programma più recente può forse leggere questo file",
                            described(version)});
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
            std::pair{std::string_view("pressure"), QuantityKind::pressure},
        };
        if (units && expect(units, Kind::object, {"an object of units by quantity", "un oggetto con le unità per grandezza"})) {
            const Members set = members(units,
                                        {"length", "angle", "angular velocity", "velocity", "acceleration", "mass", "force",
                                         "moment", "inertia", "pressure"},
                                        {"\"units\"", "\"units\""});
            for (const auto& [key, kind] : kinds) {
                if (set[key]) read_unit(set[key], kind);
            }
        }
        Units& all = mechanism_.units;
        const std::array<Unit*, kinds.size()> targets{
            &all.length, &all.angle, &all.angular_velocity, &all.velocity, &all.acceleration,
            &all.mass,   &all.force, &all.moment,           &all.inertia,  &all.pressure};
        for (std::size_t i = 0; i < kinds.size(); ++i) {
            const KnownUnit& unit = bare_unit(kinds[i].second);
            *targets[i] = {std::string(unit.symbol), unit.si};
        }
    }

    void read_unit(JsonValue value, QuantityKind kind) {
        if (!expect(value, Kind::string, {"a unit", "un’unità"})) return;
        const KnownUnit* unit = unit_spelt(value.text());
        if (unit == nullptr) {
            fault(value, unknown_unit_message(value.text(), kind));
        } else if (unit->kind != kind) {
            fault(value, {"{0} is a unit of {1}; the units of {2} are {3}", "{0} è un’unità di {1}; le unità di {2} sono {3}",
                          quoted(value.text()), name_of(unit->kind), name_of(kind), units_of(kind)});
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
        Words chain = name(cycle.front());
        for (std::size_t i = 1; i < std::min(cycle.size(), most_named); ++i) chain += " → " + name(cycle[i]);
        if (cycle.size() > most_named) chain += Words(" → … ({0} points)", " → … ({0} punti)", std::to_string(cycle.size()));
        chain += " → " + name(cycle.front());
        fault(places[at_index(cycle.front())],
              cycle.size() == 1
                  ? Words("the point {0} is placed by itself; place it by others or by coordinates",
                          "il punto {0} è definito per mezzo di se stesso; definirlo con altri o con coordinate",
                          name(cycle.front()))
                  : Words("these points are placed by each other in a cycle: {0}; place one of them by others or by coordinates",
                          "questi punti si definiscono l’un l’altro in cerchio: {0}; definirne uno con altri o con coordinate",
                          chain));
    }

    Placement placement(JsonValue value) {
        if (value.is_array())
            return Coordinates{
                vector(value, QuantityKind::length, {"a pair of coordinates [x, y]", "una coppia di coordinate [x, y]"})
                    .value_or(Vector{})};
        if (!value.is_object()) {
            fault(value, {"a point is [x, y] or an object that says how to place it, not {0}",
                          "un punto è [x, y] o un oggetto che dice come si trova, non {0}", described(value)});
            return Coordinates{};
        }
        if (value["meet"] || value["near"] || value["side"]) return meet(value);
        if (value["to"] || value["ratio"]) return point_on_line(value);
        if (value["circle"] || value["line"]) {
            fault(value, {"a curve alone is no point; write {\"meet\": [curve, curve]}",
                          "una curva sola non è un punto; scrivere {\"meet\": [curva, curva]}"});
            return Coordinates{};
        }
        const Members form =
            members(value, {"from", "distance", "angle", "relative to", "to", "ratio", "meet"}, {"a point", "un punto"});
        if (form.has_or_misspells("meet") || form.has_or_misspells("to") || form.has_or_misspells("ratio")) return Coordinates{};
        Polar polar;
        polar.from = point(
            required(form, "from", {"the point from which the distance is taken", "il punto da cui si misura la distanza"}));
        polar.distance =
            quantity_or_zero(required(form, "distance", {"how far from there the point lies", "quanto dista di lì il punto"}),
                             QuantityKind::length);
        polar.angle =
            angle(required(form, "angle", {"in which direction (or give \"to\")", "in quale direzione (o assegnare \"to\")"}))
                .value_or(Angle{});
        if (const JsonValue base = form["relative to"]) {
            if (base.is_array() && base.size() == 2) {
                polar.relative_to = between(base);
            } else {
                fault(base, {"the names of two points [\"P\", \"Q\"] are wanted here, not {0}",
                             "qui servono i nomi di due punti [\"P\", \"Q\"], non {0}", described(base)});
            }
        }
        return polar;
    }

    Placement point_on_line(JsonValue value) {
        const Members form = members(value, {"from", "to", "distance", "ratio"}, {"a point on a line", "un punto su una retta"});
        Along along;
        along.from = point(
            required(form, "from", {"the point from which the distance is taken", "il punto da cui si misura la distanza"}));
        along.to = point(required(form, "to", {"the point towards which it is taken", "il punto verso cui si misura"}));
        if (along.from != none && along.from == along.to)
            fault(form["to"], {"a point and itself give no line; name another",
                               "un punto e se stesso non danno una retta; indicarne un altro"});
        if (const JsonValue amount = one_of(form, {"distance", "ratio"})) {
            along.is_ratio = amount.key() == "ratio";
            along.amount =
                along.is_ratio ? bare_number(amount).value_or(Exact()) : quantity_or_zero(amount, QuantityKind::length);
        }
        return along;
    }

    Placement meet(JsonValue value) {
        const Members form = members(value, {"meet", "near", "side"}, {"a meet", "un’intersezione"});
        Meet meet;
        if (const JsonValue curves = required(form, "meet", {"two curves", "due curve"}); curves) {
            if (curves.is_array() && curves.size() == 2) {
                meet.first = curve(*curves.begin());
                meet.second = curve(*++curves.begin());
            } else {
                fault(curves, {"two curves are wanted here, not {0}", "qui servono due curve, non {0}", described(curves)});
            }
        }
        one_of(form, {"near", "side"}, false);
        meet.near = vector(form["near"], QuantityKind::length, {"a place [x, y]", "un luogo [x, y]"});
        if (const JsonValue side = form["side"]) meet.side = side_of(side, meet);
        return meet;
    }

    /// Of two circles left or right; where a line meets a circle also which comes first on the line.
    Meet::Side side_of(JsonValue value, const Meet& meet) {
        using Side = Meet::Side;
        const bool first = std::holds_alternative<LineCurve>(meet.first), second = std::holds_alternative<LineCurve>(meet.second);
        const bool on_line = first != second;
        constexpr std::array sides{std::pair{"left", Side::left}, std::pair{"right", Side::right},
                                   std::pair{"behind", Side::behind}, std::pair{"ahead", Side::ahead}};
        for (const auto& [word, side] : sides) {
            if (!value.is_string() || value.text() != word) continue;
            if (side == Side::left || side == Side::right || first || second) return side;
            fault(value, {"{0} is a side on a line; of two circles take \"left\" or \"right\"",
                          "{0} è un lato su una retta; per due circonferenze scegliere \"left\" o \"right\"", quoted(word)});
            return Side::either;
        }
        wrong(value, on_line ? Words("\"behind\" or \"ahead\"", "\"behind\" o \"ahead\"")
                             : Words("\"left\" or \"right\"", "\"left\" o \"right\""));
        return Side::either;
    }

    Curve curve(JsonValue value) {
        if (!expect(value, Kind::object,
                    {"a curve, {\"circle\": …} or {\"line\": …},", "una curva, {\"circle\": …} o {\"line\": …},"}))
            return CircleCurve{};
        if (value["circle"] || value["radius"]) {
            const Members form = members(value, {"circle", "radius"}, {"a circle", "una circonferenza"});
            CircleCurve circle;
            if (const JsonValue centre = required(form, "circle", {"the circle's centre", "il centro della circonferenza"}))
                circle.centre = place(centre);
            circle.radius = positive(required(form, "radius", {"the circle's radius", "il raggio della circonferenza"}),
                                     QuantityKind::length, {"a radius", "un raggio"});
            return circle;
        }
        const Members form =
            members(value, {"line", "angle", "to", "parallel", "perpendicular", "circle"}, {"a line", "una retta"});
        LineCurve line;
        if (form.has_or_misspells("circle")) return line;
        if (const JsonValue through = required(form, "line", {"a point on the line", "un punto della retta"}))
            line.through = place(through);
        const JsonValue how = one_of(form, {"angle", "to", "parallel", "perpendicular"});
        if (!how) return line;
        if (how.key() == "angle") {
            line.angle = angle(how).value_or(Angle{});
        } else if (how.key() == "to") {
            line.by = LineCurve::By::to;
            line.to = point(how);
            const auto* through = std::get_if<PointIndex>(&line.through);
            if (through != nullptr && *through != none && *through == line.to)
                fault(how, {"a point and itself give no line; name another",
                            "un punto e se stesso non danno una retta; indicarne un altro"});
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
                wrong(frame, {"a body's name", "il nome di un corpo"});
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
                const Members form = members(member, {"points", "label", "circle"}, {"a body", "un corpo"});
                points = form["points"];
                if (form["label"]) body_at(index).label = words(form["label"]);
                if (form["circle"]) read_body_circle(form["circle"], index);
                if (!points) continue;
                if (!expect(points, Kind::array, {"an array of points", "un array di punti"})) continue;
            } else if (!expect(points, Kind::array,
                               {"an array of points, or {\"points\": […], …},", "un array di punti, o {\"points\": […], …},"})) {
                continue;
            }
            for (const JsonValue name : points) carry(index, point(name, true));
        }
    }

    void read_body_circle(JsonValue value, BodyIndex index) {
        if (!expect(value, Kind::object, {"{\"centre\": …, \"radius\": …}", "{\"centre\": …, \"radius\": …}"})) return;
        const Members form = members(value, {"centre", "radius"}, {"a body's circle", "la circonferenza di un corpo"});
        Circle circle;
        circle.centre = point(required(form, "centre", {"the circle's centre", "il centro della circonferenza"}));
        circle.radius = positive(required(form, "radius", {"the circle's radius", "il raggio della circonferenza"}),
                                 QuantityKind::length, {"a radius", "un raggio"});
        body_at(index).circle = std::move(circle);
    }

    // ----- joints

    void read_joints(const Members& file) {
        const JsonValue joints = file["joints"];
        if (file["motion"]) {
            for (const std::string_view key : {"joints", "drivers"}) {
                if (file[key])
                    fault(file[key], {"\"{0}\" and \"motion\" do not go together; take one of them out",
                                      "\"{0}\" e \"motion\" non stanno insieme; toglierne una", key});
            }
        } else if (!file.has_or_misspells("motion")) {
            required(file, "joints",
                     {"an array of joints (or \"motion\", one body's act of motion)",
                      "un array di coppie (o \"motion\", l’atto di moto di un corpo)"});
        }
        joints_known_ = joints && joints.is_array();
        each(joints, {"an array of joints", "un array di coppie"}, [&](JsonValue v) { read_joint(v); });
        if (!contacts_.empty()) mechanism_.problem = std::make_shared<const Problem>(Problem{std::move(contacts_)});
    }

    void read_joint(JsonValue value) {
        if (!expect(value, Kind::object, {"a joint", "una coppia"})) {
            joints_known_ = false;
            return;
        }
        const PlanePair* const pair = pair_of(value);
        if (pair == nullptr) return;
        Joint joint;
        joint.kind = pair->kind;
        joint.where = value.pointer();
        const Members form = members(value, keys_of(*pair), {pair->called, "una coppia \"{0}\"", pair->key});
        const JsonValue at = form[pair->key];
        joint.point = point(at);
        joint.name = at.is_string() ? at.text() : std::string_view();
        if (form["name"]) {
            joint.named = true;
            joint.name = new_name(form["name"], {"a name", "un nome"});
        }
        if (!at.is_string() && !joint.named) joints_known_ = false;
        read_joint_bodies(form, joint);
        if (pair->is_sleeve())
            joint.along = bearing(required(form, "along", {"the direction of the guide", "la direzione della guida"}));
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
                fault(arm, {"the carrier of the two gears is a third body", "il portatreno delle due ruote è un terzo corpo"});
            }
        }
        if (pair->has_common_point()) {
            for (const BodyIndex on : joint.bodies) carry(on, joint.point);
        }
        if (pair->has_guide() && !joint.name.empty())
            add_sliding_name(value, joint, joint.named ? form["name"].text() : at.text());
        if (!pair->has_guide() && !joint.name.empty()) other_joints_.emplace(joint.name, pair->key);
        if (pair->touches()) read_contact(form, joint, JointIndex(mechanism_.joints.size()));
        mechanism_.joints.push_back(std::move(joint));
    }

    /// Null where there is none, or two, which has been said.
    const PlanePair* pair_of(JsonValue value) {
        const PlanePair* pair = nullptr;
        for (const PlanePair& candidate : plane_pairs) {
            if (!value[candidate.key]) continue;
            if (pair != nullptr) {
                fault(value[candidate.key], {"a joint is of one kind; this one is {0} already",
                                             "una coppia è di un solo tipo; questa è già {0}", quoted(pair->key)});
                joints_known_ = false;
                return nullptr;
            }
            pair = &candidate;
        }
        if (pair == nullptr) miss_kind(value);
        return pair;
    }
    /// Of the joint that is read next; results go by it, so it is given once.
    void add_sliding_name(JsonValue value, const Joint& joint, std::string_view written) {
        const auto [found, first] = sliding_keys_.emplace(joint.name, joint.where);
        if (!first) {
            fault(value, {"two sliding joints are called {0} (the other is {1}); give one of them a \"name\"",
                          "due coppie con scorrimento si chiamano {0} (l’altra è {1}); dare a una un \"name\"",
                          quoted(joint.name), found->second});
            return;
        }
        sliding_by_name_.emplace(joint.name, JointIndex(mechanism_.joints.size()));
        sliding_names_.push_back(written);
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
        if (!members(value, keys, {"a joint", "una coppia"}).has_misspelt())
            fault(value, {"the kind of joint is missing: one of {0}", "manca il tipo di coppia: uno fra {0}", listed(kinds)});
    }

    /// What a joint of this kind may say: of its kind, of its bodies, of what is its own.
    static std::vector<std::string_view> keys_of(const PlanePair& pair) {
        std::vector<std::string_view> keys{pair.key, "bodies"};
        std::copy_if(pair.members.begin(), pair.members.end(), std::back_inserter(keys), [](auto key) { return !key.empty(); });
        if (pair.touches()) keys.insert(keys.end(), contact_keys.begin(), contact_keys.end());
        keys.emplace_back("name");
        return keys;
    }

    void read_joint_bodies(const Members& form, Joint& joint) {
        const JsonValue bodies =
            required(form, "bodies", {"the bodies that the joint connects", "i corpi che la coppia collega"});
        if (!bodies || !expect(bodies, Kind::array, {"an array of bodies", "un array di corpi"})) return;
        const bool any_number = joint.pair().joins_many;
        if (bodies.size() < 2 || (bodies.size() > 2 && !any_number)) {
            fault(bodies, {"{0} are wanted here, not {1}", "qui servono {0}, non {1}",
                           any_number ? Words("two bodies or more", "due o più corpi") : Words("two bodies", "due corpi"),
                           described(bodies)});
        }
        std::set<BodyIndex> seen;
        for (const JsonValue name : bodies) {
            const BodyIndex connected = body(name);
            if (connected != none && !seen.insert(connected).second) {
                fault(name, {"the body {0} stands twice in one joint", "il corpo {0} compare due volte nella stessa coppia",
                             quoted(name.text())});
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
                fault(shape, {"a slot about its own pin has no radius; name the arc's centre",
                              "un glifo attorno al proprio perno non ha raggio; indicare il centro dell’arco"});
        }
    }

    void check_pressure_angle(JsonValue value, const Angle& angle) {
        const Exact right_angle = angle.in_degrees ? Exact(90) : pi() / 2;
        if (angle.value.sign() < 0 || angle.value >= right_angle)
            fault(value, {"a pressure angle lies between 0° and 90°", "un angolo di pressione sta fra 0° e 90°"});
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
            if (!expect(shape, Kind::object, {"an object of profiles by body", "un oggetto con i profili per corpo"})) return;
            for (const JsonValue member : shape) complete = read_profile(member, joint) && complete;
        }
        if (!complete) return;
        const JsonValue place = shape ? shape : form.object();
        for (const BodyIndex on : joint.bodies) {
            if (joint.profiles.contains(on)) continue;
            const Body& owner = body_at(on);
            if (owner.circle) {
                if (owner.circle->centre == joint.point && joint.point != none) {
                    fault(place, {"the circle of body {0} has its centre at the contact itself",
                                  "la circonferenza del corpo {0} ha il centro nel contatto stesso", quoted(owner.name)});
                }
                joint.profiles.emplace(on, CircleProfile{owner.circle->centre});
            } else {
                fault(
                    place,
                    {"the profile of body {0} is missing: give it under \"profiles\", or the body a \"circle\", or the joint a \"tangent\"",
                     "manca il profilo del corpo {0}: assegnarlo in \"profiles\", o dare al corpo un \"circle\", o alla coppia una \"tangent\"",
                     quoted(owner.name)});
                complete = false;
            }
        }
        if (!complete || joint.bodies[0] == joint.bodies[1]) return;
        const Profile& first = joint.profiles.at(joint.bodies[0]);
        const Profile& second = joint.profiles.at(joint.bodies[1]);
        if (std::holds_alternative<LineProfile>(first) && std::holds_alternative<LineProfile>(second)) {
            fault(place,
                  {"two lines are no contact: they touch everywhere or nowhere; one of the bodies has another profile",
                   "due rette non fanno un contatto: si toccano ovunque o in nessun punto; uno dei corpi ha un altro profilo"});
        }
        if (std::holds_alternative<TipProfile>(first) && std::holds_alternative<TipProfile>(second)) {
            fault(place, {"two tips are no contact: they have no common tangent; one of the bodies has another profile",
                          "due punte non fanno un contatto: non hanno tangente comune; uno dei corpi ha un altro profilo"});
        }
    }

    bool read_profile(JsonValue member, Joint& joint) {
        const BodyIndex on = look_up_body(member, member.key());
        if (on != none && !joint.connects(on)) {
            if (!joint.connects(none)) {
                fault(member, {"the body {0} is not in this joint", "il corpo {0} non è in questa coppia", quoted(member.key())});
            }
            return false;
        }
        if (!expect(member, Kind::object,
                    {"a profile, {\"line\": …}, {\"circle\": …} or {\"tip\": true},",
                     "un profilo, {\"line\": …}, {\"circle\": …} o {\"tip\": true},"}))
            return false;
        const Members form = members(member, {"line", "circle", "tip"}, {"a profile", "un profilo"});
        const JsonValue shape = one_of(form, {"line", "circle", "tip"});
        if (!shape) return false;
        if (shape.key() == "line") {
            const auto along = bearing(shape);
            if (!along) return false;
            joint.profiles.emplace(on, LineProfile{*along});
        } else if (shape.key() == "circle") {
            const PointIndex centre = point(shape);
            if (centre != none && centre == joint.point)
                fault(shape, {"a circle about the contact itself has no radius; name its centre",
                              "una circonferenza attorno al contatto stesso non ha raggio; indicarne il centro"});
            joint.profiles.emplace(on, CircleProfile{centre});
        } else {
            if (!is_true(shape)) {
                fault(shape, {"a tip is {\"tip\": true}", "una punta è {\"tip\": true}"});
                return false;
            }
            joint.profiles.emplace(on, TipProfile{});
        }
        return on != none;
    }

    /// A sliding joint by its name, or none with a fault; `remedy` is for those who name a joint of another kind.
    JointIndex sliding_joint(JsonValue value, const Words& remedy) {
        if (!value || !expect(value, Kind::string, {"a joint's name", "il nome di una coppia"})) return none;
        const std::string name(value.text());
        if (const auto found = sliding_by_name_.find(name); found != sliding_by_name_.end()) return found->second;
        if (const auto other = other_joints_.find(name); other != other_joints_.end()) {
            wrong_kind(value, other->second, remedy);
        } else if (joints_known_) {
            fault(value, {"no sliding joint is named {0}{1}", "nessuna coppia con scorrimento si chiama {0}{1}", quoted(name),
                          did_you_mean(speller_.nearest(name, sliding_names_))});
        }
        return none;
    }

    void wrong_kind(JsonValue joint, std::string_view kind, const Words& remedy) {
        fault(joint, {"the joint {0} is of kind \"{1}\"; {2}", "la coppia {0} è di tipo \"{1}\"; {2}", quoted(joint.text()), kind,
                      remedy});
    }

    // ----- drivers

    void read_driver(JsonValue value) {
        if (!expect(value, Kind::object, {"a driver", "un movente"})) return;
        if (value["joint"]) return read_slide_driver(value);
        if (value["at"] || value["along"] || value["speed"] || value["acceleration"]) return read_point_driver(value);
        read_spin_driver(value);
    }
    static Words nothing_drives_the_frame() {
        return {"the frame does not move; drive another body", "il telaio non si muove; comandare un altro corpo"};
    }
    void read_slide_driver(JsonValue value) {
        const Members form = members(value, {"joint", "speed", "acceleration", "law", "drawn at"},
                                     {"a driver of a joint", "un movente di una coppia"});
        SlideDriver driver;
        driver.where = value.pointer();
        driver.joint = sliding_joint(
            form["joint"], {"a driver moves a prismatic joint or a straight pin-slot; drive a \"body\" here",
                            "un movente muove una coppia prismatica o un glifo rettilineo; qui comandare un corpo con \"body\""});
        if (driver.joint != none && mechanism_.joint(driver.joint).arc != none) {
            fault(form["joint"],
                  {"the slot of {0} is curved; drive a \"body\" instead",
                   "il glifo di {0} è curvo; comandare invece un corpo con \"body\"", quoted(form["joint"].text())});
        }
        driver.speed = quantity_or_zero(form["speed"], QuantityKind::velocity);
        driver.acceleration = quantity_or_zero(form["acceleration"], QuantityKind::acceleration);
        driver.law = law(form, {"speed", "acceleration"});
        add(std::move(driver));
    }
    void read_point_driver(JsonValue value) {
        const Members form = members(value, {"body", "at", "along", "speed", "acceleration", "law", "drawn at", "joint"},
                                     {"a driver of a point", "un movente di un punto"});
        PointDriver driver;
        driver.where = value.pointer();
        if (form.has_or_misspells("joint")) return;
        if (!form.has_or_misspells("body") && !form.has_or_misspells("at") && !form.has_or_misspells("along")) {
            fault(value, {"what is driven is missing: \"joint\", or \"body\", \"at\" and \"along\"",
                          "manca ciò che è comandato: \"joint\", oppure \"body\", \"at\" e \"along\""});
            return;
        }
        if (form["body"] && !form.has_or_misspells("at") && !form.has_or_misspells("along")) return turn_instead(form);
        driver.body =
            moving_body(required(form, "body", {"the body that is driven", "il corpo comandato"}), nothing_drives_the_frame());
        driver.at = point(required(form, "at", {"the point that is driven", "il punto comandato"}));
        driver.along = bearing_or_default(
            required(form, "along", {"the direction in which it is driven", "la direzione in cui è comandato"}));
        driver.speed = quantity_or_zero(form["speed"], QuantityKind::velocity);
        driver.acceleration = quantity_or_zero(form["acceleration"], QuantityKind::acceleration);
        driver.law = law(form, {"speed", "acceleration"});
        add(std::move(driver));
    }
    void read_spin_driver(JsonValue value) {
        const Members form = members(
            value, {"body", "relative to", "omega", "alpha", "law", "drawn at", "joint", "at", "along", "speed", "acceleration"},
            {"a driver", "un movente"});
        for (const std::string_view key : {"joint", "at", "along", "speed", "acceleration"}) {
            if (form.has_or_misspells(key)) return;
        }
        SpinDriver driver;
        driver.where = value.pointer();
        driver.body = moving_body(
            required(form, "body", {"the body that is driven (or give \"joint\")", "il corpo comandato (o assegnare \"joint\")"}),
            nothing_drives_the_frame());
        if (const JsonValue base = form["relative to"]) {
            driver.relative_to = body(base);
            if (driver.relative_to > frame && driver.relative_to == driver.body)
                fault(base, {"a body does not turn against itself; name another",
                             "un corpo non ruota rispetto a se stesso; indicarne un altro"});
        }
        driver.omega = quantity_or_zero(form["omega"], QuantityKind::angular_velocity);
        driver.alpha = quantity_or_zero(form["alpha"], QuantityKind::angular_acceleration);
        driver.law = law(form, {"omega", "alpha"});
        add(std::move(driver));
    }

    /// A driver, with the rates of its law.
    void add(Driver driver) {
        if (const Law* law = law_of(driver)) {
            const auto rates = rates_at(*law, 0);
            KG_ASSERT(rates.has_value(), "a law passes through where it is drawn");
            driver = with_rates(std::move(driver), *rates);
        }
        mechanism_.drivers.push_back(std::move(driver));
    }

    /// FORMAT "Laws of motion": of a driver; `rates` are the keys that it stands for.
    std::optional<Law> law(const Members& form, std::initializer_list<std::string_view> rates) {
        const JsonValue value = form["law"], drawn = form["drawn at"];
        if (!value) {
            if (drawn)
                fault(drawn, {"\"drawn at\" is a time of the \"law\", and there is none",
                              "\"drawn at\" è un istante di \"law\", che manca"});
            return std::nullopt;
        }
        for (const std::string_view key : rates) {
            if (form[key])
                fault(form[key], {"\"law\" gives the rates at every time; leave out {0}",
                                  "\"law\" dà velocità e accelerazione a ogni istante; togliere {0}", quoted(key)});
        }
        const bool turning = *rates.begin() == "omega";
        const std::size_t faults = faults_.size();
        Law law = law_of_value(value, turning ? LawTerms{"turn", QuantityKind::angle, "time", QuantityKind::time}
                                              : LawTerms{"slide", QuantityKind::length, "time", QuantityKind::time});
        if (faults_.size() > faults) return std::nullopt;
        law.drawn = quantity_or_zero(drawn, QuantityKind::time);
        if (law.drawn.sign() < 0 || law.drawn.to_double() > law.length() * (1 + 1e-12)) {
            fault(drawn, {"it is no time of the law: before its beginning, or after its end",
                          "non è un istante della legge: precede il suo inizio, o segue la sua fine"});
            return std::nullopt;
        }
        return law;
    }

    /// {"body": 2, "speed": 150}: a body turns.
    void turn_instead(const Members& form) {
        for (const auto& [key, turning] : {std::pair{"speed", "omega"}, std::pair{"acceleration", "alpha"}})
            if (form[key])
                fault(
                    form[key],
                    {"a body turns: give \"{1}\"; \"{0}\" is of a \"joint\" that slides, or of a point of the body, \"at\" P "
                     "\"along\" X",
                     "un corpo ruota: assegnare \"{1}\"; \"{0}\" è di una coppia che scorre (\"joint\") o di un punto del corpo, "
                     "\"at\" P \"along\" X",
                     std::string_view(key), std::string_view(turning)});
    }

    // ----- forces

    void read_masses(JsonValue masses) {
        if (!masses || !expect(masses, Kind::object, {"an object of masses by body", "un oggetto con le masse per corpo"}))
            return;
        for (const JsonValue member : masses) {
            Mass mass;
            mass.where = member.pointer();
            mass.body = look_up_body(member, member.key());
            if (!expect(member, Kind::object,
                        {"{\"mass\": …, \"centre\": …, \"inertia\": …}", "{\"mass\": …, \"centre\": …, \"inertia\": …}"}))
                continue;
            const Members form = members(member, {"mass", "centre", "inertia"}, {"a body's mass", "la massa di un corpo"});
            mass.mass = not_negative(required(form, "mass", {"how much it is", "quanto vale"}), QuantityKind::mass,
                                     {"a mass", "una massa"});
            mass.centre = point(required(form, "centre", {"the centre of mass", "il baricentro"}));
            mass.inertia = not_negative(form["inertia"], QuantityKind::inertia, {"a moment of inertia", "un momento d’inerzia"});
            mechanism_.masses.push_back(std::move(mass));
        }
    }

    void read_load(JsonValue value) {
        if (!expect(value, Kind::object, {"a load", "un carico"})) return;
        if (value["couple"]) {
            const Members form = members(value, {"couple", "body", "value", "force"}, {"a couple", "una coppia di forze"});
            one_of(form, {"couple", "force"});
            CoupleLoad couple;
            couple.where = value.pointer();
            couple.name = name_of_load(form["couple"], {"the couple's name", "il nome della coppia di forze"});
            couple.body = body(required(form, "body", {"the body on which it acts", "il corpo su cui agisce"}));
            couple.value = quantity_or_zero(required(form, "value", {"the couple's size", "il valore della coppia di forze"}),
                                            QuantityKind::moment);
            mechanism_.loads.emplace_back(std::move(couple));
        } else if (value["spring"]) {
            read_elastic(value);
        } else if (value["distributed"]) {
            read_distributed(value);
        } else if (value["bodies"] || value["between"]) {
            read_spring(value);
        } else if (value["pin"]) {
            read_pin_load(value);
        } else {
            read_force(value);
        }
    }

    /// Results and figures go by it.
    std::string name_of_load(JsonValue value, const Words& wanted) {
        std::string name = new_name(value, wanted);
        if (!name.empty() && !load_names_.insert(name).second)
            fault(value, {"two loads are named {0}; figures go by the name, so rename one",
                          "due carichi si chiamano {0}; le figure vanno per nome, quindi rinominarne uno", quoted(name)});
        return name;
    }

    void read_spring(JsonValue value) {
        const Members form = members(value, {"force", "bodies", "between", "magnitude"},
                                     {"a force between two bodies", "una forza fra due corpi"});
        SpringLoad spring;
        spring.where = value.pointer();
        if (const JsonValue name = required(form, "force", {"the force's name", "il nome della forza"}))
            spring.name = name_of_load(name, {"the force's name", "il nome della forza"});
        read_ends(form, spring);
        spring.magnitude = quantity_or_zero(required(form, "magnitude", {"how hard they are pulled", "quanto sono tirati"}),
                                            QuantityKind::force);
        mechanism_.loads.emplace_back(std::move(spring));
    }

    void read_ends(const Members& form, SpringLoad& spring) {
        if (const JsonValue bodies =
                required(form, "bodies", {"the two bodies that are pulled together", "i due corpi che si attraggono"}))
            spring.bodies = two_bodies(bodies);
        if (const JsonValue ends =
                required(form, "between", {"the two points at which they are pulled", "i due punti in cui sono tirati"})) {
            if (ends.is_array() && ends.size() == 2) {
                const Bearing::Between points = between(ends);
                spring.between = {points.from, points.to};
            } else {
                fault(ends, {"two points are wanted here, not {0}", "qui servono due punti, non {0}", described(ends)});
            }
        }
    }
    /// Of a spring.
    std::array<BodyIndex, 2> two_bodies(JsonValue bodies) {
        if (!bodies.is_array() || bodies.size() != 2) {
            fault(bodies, {"two bodies are wanted here, not {0}", "qui servono due corpi, non {0}", described(bodies)});
            return {none, none};
        }
        const JsonValue second = *++bodies.begin();
        const std::array<BodyIndex, 2> both{body(*bodies.begin()), body(second)};
        if (both[0] != none && both[0] == both[1])
            fault(second, {"the body {0} stands twice; a spring is between two bodies",
                           "il corpo {0} compare due volte; una molla sta fra due corpi", quoted(second.text())});
        return both;
    }

    /// FORMAT "Forces": an elastic spring, straight or of torsion.
    void read_elastic(JsonValue value) {
        const bool of_torsion = value["turned"] || value["at"];
        const Members form =
            of_torsion
                ? members(value, {"spring", "bodies", "at", "stiffness", "turned"}, {"a torsion spring", "una molla di torsione"})
                : members(value, {"spring", "bodies", "between", "stiffness", "free length"}, {"a spring", "una molla"});
        const std::string name = name_of_load(form["spring"], {"the spring's name", "il nome della molla"});
        const JsonValue stiffness = required(form, "stiffness", {"how stiff the spring is", "la rigidezza della molla"});
        const Words called("a stiffness", "una rigidezza");
        if (!of_torsion) {
            SpringLoad spring;
            spring.where = value.pointer();
            spring.name = name;
            read_ends(form, spring);
            spring.elastic = SpringLoad::Elastic{
                not_negative(stiffness, QuantityKind::force_per_length, called),
                not_negative(required(form, "free length", {"how long it is without force", "la lunghezza a riposo"}),
                             QuantityKind::length, {"a free length", "una lunghezza a riposo"})};
            mechanism_.loads.emplace_back(std::move(spring));
            return;
        }
        TorsionLoad torsion;
        torsion.where = value.pointer();
        torsion.name = name;
        if (const JsonValue bodies = required(form, "bodies", {"the two bodies that it turns", "i due corpi che fa ruotare"}))
            torsion.bodies = two_bodies(bodies);
        torsion.at = point(required(form, "at", {"the point about which it is wound", "il punto attorno a cui è avvolta"}));
        torsion.stiffness = not_negative(stiffness, QuantityKind::torsional_stiffness, called);
        torsion.turned = quantity_or_zero(
            required(form, "turned",
                     {"by how much the first body is turned from where the spring is slack, seen from the second",
                      "di quanto il primo corpo, visto dal secondo, è ruotato dalla posizione in cui la molla è scarica"}),
            QuantityKind::angle);
        mechanism_.loads.emplace_back(std::move(torsion));
    }

    void read_distributed(JsonValue value) {
        const Members form = members(value, {"distributed", "body", "from", "to", "intensity", "along"},
                                     {"a distributed load", "un carico distribuito"});
        DistributedLoad load;
        load.where = value.pointer();
        load.name = name_of_load(form["distributed"], {"the load's name", "il nome del carico"});
        load.body = body(required(form, "body", {"the body on which it acts", "il corpo su cui agisce"}));
        load.from = point(required(form, "from", {"the point where it begins", "il punto in cui comincia"}));
        load.to = point(required(form, "to", {"the point where it ends", "il punto in cui finisce"}));
        if (load.from != none && load.from == load.to)
            fault(form["to"], {"a load from a point to itself has no length; name another",
                               "un carico da un punto a se stesso non ha lunghezza; indicarne un altro"});
        const JsonValue intensity =
            required(form, "intensity", {"the intensities at both ends, [q0, q1]", "le intensità ai due estremi, [q0, q1]"});
        if (intensity && (!intensity.is_array() || intensity.size() != 2)) {
            fault(intensity, {"the intensities at both ends [q0, q1] are wanted here, not {0}",
                              "qui servono le intensità ai due estremi [q0, q1], non {0}", described(intensity)});
        } else if (intensity) {
            load.intensity = {quantity_or_zero(*intensity.begin(), QuantityKind::force_per_length),
                              quantity_or_zero(*++intensity.begin(), QuantityKind::force_per_length)};
        }
        load.along = bearing_or_default(required(form, "along", {"the direction of the load", "la direzione del carico"}));
        mechanism_.loads.emplace_back(std::move(load));
    }

    /// On the pin of a hinge, which is then a node of its own.
    void read_pin_load(JsonValue value) {
        const Members form =
            members(value, {"force", "pin", "value", "magnitude", "along", "pressure", "area"}, {"a force", "una forza"});
        ForceLoad force;
        force.where = value.pointer();
        if (const JsonValue name = required(form, "force", {"the force's name", "il nome della forza"}))
            force.name = name_of_load(name, {"the force's name", "il nome della forza"});
        force.pin = hinge(form["pin"]);
        if (force.pin != none) {
            Joint& joint = mechanism_.joints[at_index(force.pin)];
            joint.loaded_pin = true;
            force.at = joint.point;
        }
        read_size(form, force);
        mechanism_.loads.emplace_back(std::move(force));
    }
    /// By its name, or else by its point.
    JointIndex hinge(JsonValue value) {
        if (!expect(value, Kind::string, {"a hinge, by its name or its point,", "una cerniera, per nome o per punto"}) ||
            !joints_known_)
            return none;
        const std::string_view name = value.text();
        std::vector<JointIndex> named, there;
        for (const JointIndex index : indices_of(mechanism_.joints)) {
            const Joint& joint = mechanism_.joint(index);
            if (!joint.pair().is_hinge()) continue;
            if (joint.name == name) named.push_back(index);
            if (joint.point != none && point_names_[at_index(joint.point)] == name) there.push_back(index);
        }
        if (named.empty()) named = there;
        if (named.size() == 1) return named.front();
        fault(value,
              named.empty()
                  ? Words("there is no hinge at {0}; a load on a point of a body has \"body\" and \"at\"",
                          "in {0} non c’è cerniera; un carico in un punto di un corpo ha \"body\" e \"at\"", quoted(name))
                  : Words("there are {1} hinges at {0}; make them one with all their bodies, or give the one meant a \"name\"",
                          "in {0} ci sono {1} cerniere; farne una sola con tutti i corpi, o dare un \"name\" a quella voluta",
                          quoted(name), std::to_string(named.size())));
        return none;
    }

    void read_force(JsonValue value) {
        const Members form = members(
            value,
            {"force", "body", "at", "value", "magnitude", "along", "pressure", "area", "couple", "bodies", "between", "pin"},
            {"a force", "una forza"});
        for (const std::string_view key : {"couple", "bodies", "between", "pin"})
            if (form.has_or_misspells(key)) return;
        if (!form.has_or_misspells("force")) {
            fault(value,
                  {"the load's name is missing: \"force\" or \"couple\"", "manca il nome del carico: \"force\" o \"couple\""});
            return;
        }
        ForceLoad force;
        force.where = value.pointer();
        if (const JsonValue name =
                required(form, "force", {"the force's name (or \"couple\")", "il nome della forza (o \"couple\")"}))
            force.name = name_of_load(name, {"the force's name", "il nome della forza"});
        force.body = body(required(form, "body", {"the body on which it acts", "il corpo su cui agisce"}));
        force.at = point(required(form, "at", {"the point at which it acts", "il punto in cui agisce"}));
        read_size(form, force);
        mechanism_.loads.emplace_back(std::move(force));
    }

    /// Components, or magnitude and direction, or a pressure on an area and a direction.
    void read_size(const Members& form, ForceLoad& force) {
        const JsonValue how =
            form["pressure"] ? one_of(form, {"value", "magnitude", "pressure"}) : one_of(form, {"value", "magnitude"});
        if (how && how.key() == "value") {
            one_of(form, {"value", "along"});
            force.value = vector(how, QuantityKind::force, {"a force [Fx, Fy]", "una forza [Fx, Fy]"});
        } else if (how) {
            const auto magnitude = how.key() == "pressure" ? pressure_on_area(form) : quantity(how, QuantityKind::force);
            const auto along = bearing(required(form, "along", {"the direction of the force", "la direzione della forza"}));
            if (magnitude && along) force.magnitude = {*magnitude, *along};
        }
        if (form["area"] && !form["pressure"])
            fault(form["area"], {"\"area\" goes with a \"pressure\"; give one", "\"area\" va con una \"pressure\"; assegnarla"});
    }
    std::optional<Exact> pressure_on_area(const Members& form) {
        const auto pressure = quantity(form["pressure"], QuantityKind::pressure);
        const JsonValue on = required(form, "area", {"the area on which it presses", "l’area su cui preme"});
        if (!on || !pressure) return std::nullopt;
        return *pressure * not_negative(on, QuantityKind::area, {"an area", "un’area"});
    }

    /// A name and where it stands.
    struct Named {
        std::string text{};
        JsonValue at{};
    };
    Named effort_name(JsonValue given, const Words& wanted) {
        return {given ? std::string(new_name(given, wanted)) : std::string(), given};
    }
    static Words nothing_moves_the_frame() {
        return {"an effort on the frame balances nothing; name a body that moves",
                "un’azione sul telaio non equilibra nulla; indicare un corpo che si muove"};
    }
    void read_effort(JsonValue value) {
        if (!expect(value, Kind::object, {"an effort", "un’azione equilibrante"})) return;
        const Named name = value["couple"]  ? read_couple_effort(value)
                           : value["joint"] ? read_actuator(value)
                                            : read_force_effort(value);
        if (!name.text.empty() && !effort_names_.insert(name.text).second) {
            fault(name.at, {"two efforts are named {0}; results go by the name, so rename one",
                            "due azioni equilibranti si chiamano {0}; i risultati vanno per nome, quindi rinominarne una",
                            quoted(name.text)});
        }
    }
    Named read_couple_effort(JsonValue value) {
        const Members form =
            members(value, {"couple", "body", "from", "force"}, {"a couple that balances", "una coppia di forze equilibrante"});
        one_of(form, {"couple", "force"});
        Named name = effort_name(form["couple"], {"the couple's name", "il nome della coppia di forze"});
        CoupleEffort couple;
        couple.where = value.pointer();
        couple.body = body(required(form, "body", {"the body on which it acts", "il corpo su cui agisce"}));
        if (const JsonValue from = form["from"]) couple.from = body(from);
        if (couple.body != none && couple.body == couple.from) {
            fault(form["from"] ? form["from"] : form["body"],
                  form["from"] ? Words("a couple from a body on itself balances nothing; name another",
                                       "una coppia di forze da un corpo su se stesso non equilibra nulla; indicarne un altro")
                               : nothing_moves_the_frame());
        }
        couple.name = name.text;
        mechanism_.efforts.emplace_back(std::move(couple));
        return name;
    }
    Named read_actuator(JsonValue value) {
        const Members form = members(value, {"force", "joint"}, {"an actuator", "un attuatore"});
        Named name = effort_name(required(form, "force", {"the force's name", "il nome della forza"}),
                                 {"the force's name", "il nome della forza"});
        ActuatorEffort actuator;
        actuator.where = value.pointer();
        const Words remedy("an actuator works in a prismatic joint", "un attuatore agisce in una coppia prismatica");
        actuator.joint = sliding_joint(form["joint"], remedy);
        if (actuator.joint != none) {
            const PlanePair& pair = mechanism_.joint(actuator.joint).pair();
            if (!pair.is_sleeve()) wrong_kind(form["joint"], pair.key, remedy);
        }
        actuator.name = name.text;
        mechanism_.efforts.emplace_back(std::move(actuator));
        return name;
    }
    Named read_force_effort(JsonValue value) {
        const Members form = members(value, {"force", "body", "at", "along", "couple", "joint"},
                                     {"a force that balances", "una forza equilibrante"});
        if (form.has_or_misspells("couple") || form.has_or_misspells("joint")) return {};
        if (!form.has_or_misspells("force")) {
            fault(value, {"the effort's name is missing: \"force\" or \"couple\"",
                          "manca il nome dell’azione equilibrante: \"force\" o \"couple\""});
            return {};
        }
        Named name = effort_name(form["force"], {"the force's name", "il nome della forza"});
        ForceEffort force;
        force.where = value.pointer();
        force.body = moving_body(
            required(form, "body",
                     {"the body on which it acts (or give \"joint\")", "il corpo su cui agisce (o assegnare \"joint\")"}),
            nothing_moves_the_frame());
        force.at = point(required(form, "at", {"the point at which it acts", "il punto in cui agisce"}));
        force.along = bearing_or_default(required(form, "along", {"the direction of the force", "la direzione della forza"}));
        force.name = name.text;
        mechanism_.efforts.emplace_back(std::move(force));
        return name;
    }

    // ----- motion, wishes, scales

    void read_motion(JsonValue value) {
        if (!expect(value, Kind::object,
                    {"an act of motion, {\"body\": …, \"velocities\": {…}},",
                     "un atto di moto, {\"body\": …, \"velocities\": {…}},"}))
            return;
        const Members form = members(value, {"body", "velocities", "accelerations"}, {"an act of motion", "un atto di moto"});
        ActOfMotion motion;
        motion.where = value.pointer();
        motion.body =
            moving_body(required(form, "body", {"the body that moves", "il corpo che si muove"}),
                        {"the frame does not move; name another body", "il telaio non si muove; indicare un altro corpo"});
        if (const JsonValue velocities =
                required(form, "velocities",
                         {"what is known of the velocities of its points", "ciò che si sa delle velocità dei suoi punti"})) {
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
        if (!expect(value, Kind::object, {"an object of vectors by point", "un oggetto con i vettori per punto"})) return motions;
        for (const JsonValue member : value) {
            GivenMotion given;
            given.point = look_up_point(member, member.key());
            carry(on, given.point);
            if (member.is_object()) {
                const Members form = members(member, {"along"}, {"what is known of a vector", "ciò che si sa di un vettore"});
                given.value =
                    bearing_or_default(required(form, "along", {"the direction of the vector", "la direzione del vettore"}));
            } else {
                given.value = vector(member, kind, {"a vector [x, y] or {\"along\": X}", "un vettore [x, y] o {\"along\": X}"})
                                  .value_or(Vector{});
            }
            motions.push_back(std::move(given));
        }
        return motions;
    }

    /// Whether the motion is to be found through the observer; one that translates gives no direction of a relative velocity.
    void read_solve(JsonValue value, RelativeMotionQuery& query) {
        if (!value || !expect(value, Kind::boolean, {"true or false", "true o false"})) return;
        query.solves = is_true(value);
        if (query.solves && query.translating_with != none)
            fault(value, {"the motion is solved through an observer on a body: name one as \"observer\", or leave \"solve\" out",
                          "il moto si risolve con un osservatore solidale a un corpo: indicarlo in \"observer\", o togliere "
                          "\"solve\""});
    }

    void read_wish(JsonValue value) {
        constexpr std::array<std::string_view, 7> wishes{"instant centres", "velocity",  "acceleration", "forces",
                                                         "curvature",       "equations", "virtual work"};
        Find& find = mechanism_.find;
        const std::array<bool*, wishes.size()> flags{&find.instant_centres, &find.velocity,  &find.acceleration, &find.forces,
                                                     &find.curvature,       &find.equations, &find.virtual_work};
        if (value.is_string()) {
            const auto* const known = std::find(wishes.begin(), wishes.end(), value.text());
            if (known != wishes.end()) {
                *flags[static_cast<std::size_t>(known - wishes.begin())] = true;
                return;
            }
            const auto meant = speller_.nearest(value.text(), wishes);
            fault(value, {"{0} is nothing to find{1}", "{0} non è cosa da trovare{1}", quoted(value.text()),
                          meant ? did_you_mean(meant)
                                : Words("; what can be found is {0} and {\"relative motion\": …}",
                                        "; si può trovare {0} e {\"relative motion\": …}", listed(wishes))});
            return;
        }
        if (!expect(value, Kind::object,
                    {"a wish, as \"velocity\" or {\"relative motion\": …, \"observer\": …},",
                     "una richiesta, come \"velocity\" o {\"relative motion\": …, \"observer\": …},"}))
            return;
        if (is_cut(value)) {
            members(value, {"cut"}, {"a cut", "una sezione"});
            for (const JsonValue member : value)
                if (member.key() == "cut" && expect(member, Kind::array, {"an array of three bars", "un array di tre aste"}))
                    cuts_.push_back(member);
            find.forces = true;
            return;
        }
        const Members form = members(value, {"relative motion", "observer", "solve"}, {"a wish", "una richiesta"});
        RelativeMotionQuery query;
        query.where = value.pointer();
        query.point = point(
            required(form, "relative motion", {"the point whose motion is observed", "il punto di cui si osserva il moto"}));
        const JsonValue observer = required(form, "observer",
                                            {"the body that carries the observer, or {\"translating with\": Q}",
                                             "il corpo solidale all’osservatore, o {\"translating with\": Q}"});
        if (observer && observer.is_object()) {
            const Members frame = members(observer, {"translating with"}, {"an observer", "un osservatore"});
            query.translating_with = point(required(
                frame, "translating with", {"the point that carries the observer", "il punto con cui trasla l’osservatore"}));
        } else {
            query.observer = body(observer);
        }
        read_solve(form["solve"], query);
        find.relative_motion.push_back(std::move(query));
    }

    static bool is_cut(JsonValue value) {
        bool found = false;
        for (const JsonValue member : value) found = found || member.key() == "cut";
        return found;
    }

    /// Cuts name bars of a truss, which the whole file makes.
    void read_cuts() {
        const std::optional<TrussStructure> truss = truss_of(mechanism_);
        for (const JsonValue cut : cuts_) {
            if (truss)
                read_cut(cut, *truss);
            else
                fault(cut, {"only a truss can be cut: three bars or more, hinged at both ends and loaded at their pins, without "
                            "efforts and drivers, on supports that hold it with as many reactions as it needs",
                            "si può sezionare solo una travatura reticolare: almeno tre aste, incernierate ai due estremi e "
                            "caricate nei nodi, senza azioni equilibranti né moventi, con tante reazioni quante ne occorrono"});
        }
    }
    void read_cut(JsonValue value, const TrussStructure& truss) {
        std::vector<std::string_view> known;
        for (const TrussStructure::Bar& bar : truss.bars) known.emplace_back(bar.name);
        std::vector<int> bars;
        CutQuery query;
        query.where = value.pointer();
        for (const JsonValue member : value) {
            if (!expect(member, Kind::string, {"the name of a bar", "il nome di un’asta"})) return;
            const int bar = truss.bar_named(mechanism_, member.text());
            if (bar < 0)
                return fault(member, {"there is no bar {0}; the bars are {1}", "non c’è un’asta {0}; le aste sono {1}",
                                      quoted(member.text()), listed(known)});
            if (std::find(bars.begin(), bars.end(), bar) != bars.end())
                return fault(member, {"bar {0} is cut twice; name three different bars",
                                      "l’asta {0} è nominata due volte; indicare tre aste diverse", quoted(member.text())});
            bars.push_back(bar);
            query.bars.push_back(truss.bars[static_cast<std::size_t>(bar)].body);
        }
        constexpr std::size_t needed = 3;
        if (bars.size() != needed)
            return fault(value, {"a cut crosses three bars, for a body has three equations; name three",
                                 "una sezione incontra tre aste, tante quante le equazioni di un corpo; indicarne tre"});
        for (std::size_t pin = 0; pin < truss.pins.size(); ++pin) {
            const auto& meeting = truss.pins[pin].bars;
            if (std::all_of(bars.begin(), bars.end(),
                            [&](int bar) { return std::find(meeting.begin(), meeting.end(), bar) != meeting.end(); }))
                return fault(value, {"the bars meet in pin {0}, so that no moment gives one of them alone; cut bars that do not "
                                     "all meet",
                                     "le aste concorrono nel nodo {0}: nessun momento ne dà una sola; sezionare aste che non "
                                     "concorrono tutte",
                                     truss.name_of(mechanism_, static_cast<int>(pin))});
        }
        if (sides_of_cut(truss, bars).empty())
            return fault(value, {"these bars do not part the truss in two; name all bars that the section crosses",
                                 "queste aste non dividono in due la travatura; indicare tutte le aste che la sezione incontra"});
        mechanism_.find.cuts.push_back(std::move(query));
    }

    void read_scales(JsonValue value) {
        if (!value || !expect(value, Kind::object, {"an object of scales by figure", "un oggetto con le scale per figura"}))
            return;
        constexpr std::array figures{
            std::pair{std::string_view("mechanism"), QuantityKind::length},
            std::pair{std::string_view("centres"), QuantityKind::length},
            std::pair{std::string_view("velocity"), QuantityKind::velocity},
            std::pair{std::string_view("acceleration"), QuantityKind::acceleration},
            std::pair{std::string_view("body"), QuantityKind::force},
            std::pair{std::string_view("forces"), QuantityKind::force},
            std::pair{std::string_view("closure"), QuantityKind::force},
        };
        const Members form = members(value, {"mechanism", "centres", "velocity", "acceleration", "body", "forces", "closure"},
                                     {"\"scales\"", "\"scales\""});
        for (const auto& [figure, kind] : figures) {
            const JsonValue scale = form[figure];
            if (!scale) continue;
            auto per_millimetre = scale.is_string() ? read_scale(scale.text(), kind)
                                                    : tl::expected<Exact, Words>(tl::make_unexpected(Words(
                                                          "a scale{0} is wanted here, not {1}", "qui serve una scala{0}, non {1}",
                                                          scale_example(kind), described(scale))));
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
    std::span<const Setting> set_;
    Mechanism mechanism_;
    bool joints_known_ = false;  ///< as FormReader's
    std::unordered_map<std::string, JointIndex> sliding_by_name_;
    std::unordered_map<std::string, std::string>
        sliding_keys_;  ///< where each name stands; contacts have results under theirs too
    std::vector<std::string_view> sliding_names_;
    std::unordered_map<std::string, std::string_view> other_joints_;  ///< name → kind of those that do not slide
    std::unordered_set<std::string> load_names_, effort_names_;
    std::unordered_set<std::uint64_t> carried_;  ///< (body, point)
    std::vector<JsonValue> cuts_;                ///< of "find", read when the file makes a truss
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

Result<Mechanism> read_mechanism(std::string_view text, std::string source, std::span<const Setting> set) {
    const Result<JsonSource> json = JsonSource::read(text);
    if (!json) return tl::make_unexpected(json.error());
    return Reader(*json, std::move(source), set).read();
}

}  // namespace kinegraph
