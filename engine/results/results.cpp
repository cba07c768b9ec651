// The results file (docs/results.md): a Solution as JSON, SI units, keys in the file's order, numbers as the shortest
// decimals that round-trip to the same double. Computes nothing and rounds only to doubles.
#include "engine/results/results.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/equations/equations.hpp"
#include "engine/file/json_text.hpp"
#include "engine/number/assert.hpp"
#include "engine/number/functions.hpp"
#include "engine/results/json_parts.hpp"
#include "engine/results/quantity_name.hpp"
#include "engine/results/result_names.hpp"
#include "engine/sentences/result_catalogue.hpp"
#include "engine/solution/displacements.hpp"
#include "engine/solution/problem_kind.hpp"
#include "engine/solution/result_values.hpp"
#include "engine/solution/solution.hpp"
#include "lang/keys/phrases.hpp"

namespace kinegraph {
namespace {

using json::append_member;
using json::append_number;
using json::fraction;
using json::fractions;
using json::lines;
using json::Members;
using json::number;
using json::object;
using json::object_of_lines;
using json::pair;
using json::quoted;
using json::values_of;

/// The direction to a point at infinity has no sense: normalised to dx > 0, or (0, 1). The larger component is 1 or −1.
Vector without_sense(Vector direction, bool pose_is_exact) {
    const Exact x = abs(direction.x);
    const Exact y = abs(direction.y);
    const Exact& largest = x > y ? x : y;
    KG_ASSERT(!largest.is_zero(), "a point at infinity has a direction");
    direction = {direction.x / largest, direction.y / largest};
    if (!pose_is_exact) {
        // On a pose with a leftover a vertical direction is accurate to about 2^-100; its sense must not depend on
        // that.
        const Exact noise = Exact::power_of_two(-80);
        if (abs(direction.x) < noise) direction.x = 0;
        if (abs(direction.y) < noise) direction.y = 0;
    }
    if (direction.x.sign() < 0 || (direction.x.is_zero() && direction.y.sign() < 0)) direction = -direction;
    return direction;
}
std::string unit(const Vector& direction) {
    const double dx = direction.x.to_double();
    const double dy = direction.y.to_double();
    const double length = nearest::hypot(dx, dy);
    return pair(number(dx / length), number(dy / length));
}
/// The same direction in the smallest integers; its length is arbitrary.
std::string whole(const Vector& direction) {
    if (direction.x.is_zero()) return fractions({0, 1});
    const Exact slope = direction.y / direction.x;
    const Exact run(mpq_class(slope.rational().get_den()));
    return fractions({run, run * slope});
}

/// A bound, rounded outwards, so that it stays a bound.
std::string bound(const Exact& leftover) {
    double value = leftover.to_double();
    if (Exact::from_double(value) < leftover) value = std::nextafter(value, HUGE_VAL);
    return quoted(number(value));
}

/// One entry of the file: its values, and the exact ones if requested.
class Entry {
public:
    Entry(const Pose& pose, bool exact) : pose_(pose), exact_(exact) {}

    void add(const std::string& key, std::string json) { members_.emplace_back(key, std::move(json)); }
    void add(const std::string& key, const Recorded<Exact>& value) {
        if (!value) return;
        add(key, number(*value));
        if (exact_ && certain(*value)) fractions_.emplace_back(key, fraction(*value));
    }
    void add(const std::string& key, const Recorded<Vector>& value) {
        if (!value) return;
        add(key, pair(*value));
        if (exact_ && certain(value->x) && certain(value->y)) fractions_.emplace_back(key, fractions(*value));
    }
    /// A named point's own place, exact or with the error bound of the compass.
    void add_place(PointIndex point) {
        const Vector& at = pose_.at(point);
        add("at", pair(at));
        const Exact& leftover = pose_.leftover[at_index(point)];
        if (!leftover.is_zero()) {
            if (exact_) leftover_ = bound(leftover);
        } else if (exact_ && certain(at.x) && certain(at.y)) {
            fractions_.emplace_back("at", fractions(at));
        }
    }
    void add_towards(const Vector& sensed) {
        const Vector direction = without_sense(sensed, pose_.exact);
        add("towards", unit(direction));
        if (exact_ && certain(direction.x) && certain(direction.y))
            fractions_.emplace_back("towards", whole(direction));
    }
    bool empty() const { return members_.empty(); }
    std::string json() && {
        if (!fractions_.empty()) add("exact", object(fractions_));
        if (!leftover_.empty()) add("leftover", leftover_);
        return object(members_);
    }

private:
    /// On a pose with a leftover, a value that depends on it is a fraction as long as the compass's rounding, and not
    /// exact. A short one cannot depend on it.
    bool certain(const Exact& value) const {
        return pose_.exact || value.bits() < static_cast<std::size_t>(pose_.bits > 0 ? pose_.bits : 1);
    }

    const Pose& pose_;
    bool exact_;
    Members members_, fractions_;
    std::string leftover_;
};

/// A row of `checks`.
std::string check_row(std::string_view name, double graphical, double numeric, double difference) {
    constexpr std::size_t usual = 160;
    std::string json = R"({"quantity": )";
    json.reserve(usual);
    append_json_text(json, name);
    for (const auto& [key, value] : {std::pair(R"(, "graphical": )", graphical), std::pair(R"(, "numeric": )", numeric),
                                     std::pair(R"(, "difference": )", difference)}) {
        json += key;
        append_number(json, value);
    }
    return json += '}';
}
/// For a value that has one.
std::string check_row(std::string_view name, const ProblemValue& value) {
    const double numeric = value.numeric.value_or(value.value);
    return check_row(name, value.value, numeric, value.value - numeric);
}

bool forces_asked(const Solution& solution) {
    const Mechanism& mechanism = solution.mechanism;
    if (mechanism.find.stated) return mechanism.find.forces;
    return !mechanism.loads.empty() || !mechanism.efforts.empty() || !solution.resultants.empty();
}

/// The base of the sections of the results.
class ResultsSection {
public:
    ResultsSection(const Solution& solution, bool exact, const Teller& tell)
        : solution_(solution), mechanism_(solution.mechanism), exact_(exact), tell_(tell) {}

protected:
    const std::string& name_of_body(BodyIndex body) const { return mechanism_.body(body).name; }
    const std::string& name_of_point(PointIndex point) const { return mechanism_.point(point).name; }
    Entry entry() const { return {solution_.pose, exact_}; }
    std::string reason(const Message& why) const { return quoted(tell_(why)); }

    const Solution& solution_;
    const Mechanism& mechanism_;
    bool exact_;
    const Teller& tell_;
};

/// Sections of motion: points, bodies, sliding, centres, relative motion and curvature.
class MotionResults : ResultsSection {
public:
    using ResultsSection::ResultsSection;

    std::string points() const {
        Members all;
        for (const PointIndex point : indices_of(mechanism_.points)) {
            std::vector<const PointMotion*> nodes;
            for (const PointMotion& motion : solution_.points)
                if (motion.point == point) nodes.push_back(&motion);
            Entry here = entry();
            here.add_place(point);
            if (nodes.size() == 1) {
                here.add("velocity", nodes[0]->velocity);
                here.add("acceleration", nodes[0]->acceleration);
            } else if (nodes.size() > 1) {
                Members on;
                for (const BodyIndex body : indices_of(mechanism_.bodies)) {
                    for (const PointMotion* node : nodes) {
                        bool carries = false;
                        for (const BodyIndex carrier : node->bodies) carries = carries || carrier == body;
                        Entry there = entry();
                        there.add("velocity", node->velocity);
                        there.add("acceleration", node->acceleration);
                        if (carries && !there.empty()) on.emplace_back(name_of_body(body), std::move(there).json());
                    }
                }
                if (!on.empty()) here.add("on", object(on));
            }
            all.emplace_back(name_of_point(point), std::move(here).json());
        }
        return object_of_lines(all);
    }

    std::string bodies() const {
        Members all;
        for (std::size_t body = 1; body < solution_.bodies.size(); ++body) {
            Entry motion = entry();
            motion.add("omega", solution_.bodies[body].omega);
            motion.add("alpha", solution_.bodies[body].alpha);
            if (!motion.empty()) all.emplace_back(mechanism_.bodies[body].name, std::move(motion).json());
        }
        return object_of_lines(all);
    }

    std::string sliding() const {
        Members all;
        for (const Sliding& slide : solution_.sliding) {
            Entry motion = entry();
            motion.add("velocity", slide.velocity);
            motion.add("acceleration", slide.acceleration);
            motion.add("coriolis", slide.coriolis);
            if (!motion.empty()) all.emplace_back(sliding_key(slide), std::move(motion).json());
        }
        return object_of_lines(all);
    }

    std::string centres() const {
        Members all;
        for (const InstantCentre& centre : solution_.centres) {
            Entry where = entry();
            if (centre.everywhere) where.add("everywhere", std::string("true"));
            if (centre.at && !centre.at->at_infinity())
                where.add("at", centre.at->place());
            else if (centre.at)
                where.add_towards(centre.at->place());
            if (where.empty()) continue;
            if (centre.depends_on_drivers) where.add("depends on drivers", std::string("true"));
            all.emplace_back(name_of_body(centre.first) + "," + name_of_body(centre.second), std::move(where).json());
        }
        return object_of_lines(all);
    }

    /// The point of a body whose acceleration vanishes.
    std::string acceleration_centres() const {
        Entry where = entry();
        where.add("at", solution_.instantaneous_motion->acceleration_centre);
        return object_of_lines({{name_of_body(solution_.instantaneous_motion->body), std::move(where).json()}});
    }

    std::string curvature() const {
        Members all;
        for (const Curvature& found : solution_.curvature)
            all.emplace_back(name_of_body(found.body), curvature_of(found));
        return object_of_lines(all);
    }

    std::string relative_motion() const {
        std::vector<std::string> all;
        for (const RelativeMotion& motion : solution_.relative_motion) {
            Entry seen = entry();
            seen.add("point", quoted(name_of_point(motion.query.point)));
            if (motion.query.translating_with != none)
                seen.add("observer",
                         object({{"translating with", quoted(name_of_point(motion.query.translating_with))}}));
            else
                seen.add("observer", quoted(name_of_body(motion.query.observer)));
            seen.add("velocity", motion.velocity);
            seen.add("transport velocity", motion.transport_velocity);
            seen.add("relative velocity", motion.relative_velocity);
            seen.add("acceleration", motion.acceleration);
            seen.add("transport acceleration", motion.transport_acceleration);
            seen.add("relative acceleration", motion.relative_acceleration);
            seen.add("coriolis", motion.coriolis);
            if (motion.apart) seen.add("apart", apart(*motion.apart));
            all.push_back(std::move(seen).json());
        }
        return lines('[', all, ']');
    }

    /// rad, by the joint at which a coupler drives a link.
    Members transmission_angles() const {
        Members all;
        constexpr std::string_view name = "transmission angle ";
        for (const auto& [column, coupler] : transmission_columns(mechanism_, 0))
            all.emplace_back(column.name.substr(name.size()), number(transmission_angle(coupler, solution_.pose)));
        return all;
    }

private:
    /// The joint's name; a contact that shares its point with another sliding joint also names the two bodies.
    std::string sliding_key(const Sliding& slide) const {
        const Joint& joint = mechanism_.joint(slide.joint);
        const auto shares = [&](const Sliding& other) {
            return other.joint != slide.joint && mechanism_.joint(other.joint).name == joint.name;
        };
        if (!joint.pair().touches() || std::none_of(solution_.sliding.begin(), solution_.sliding.end(), shares))
            return joint.name;
        return joint.name + " (" + name_of_body(joint.bodies[0]) + " on " + name_of_body(joint.bodies[1]) + ")";
    }

    std::string curvature_of(const Curvature& found) const {
        Entry body = entry();
        if (found.kind == Curvature::Kind::translation) {
            body.add("translation", std::string("true"));
            body.add("reason", reason({lang::phrases::body_translates, {}}));
        }
        if (found.kind == Curvature::Kind::turning) body.add("reason", reason({lang::phrases::pole_at_rest, {}}));
        if (found.kind == Curvature::Kind::rest) body.add("reason", reason({lang::phrases::body_at_rest, {}}));
        if (found.pole && !found.pole->at_infinity()) body.add("pole", Recorded<Vector>(found.pole->place()));
        if (found.tangent) body.add("pole tangent", unit(without_sense(*found.tangent, solution_.pose.exact)));
        if (found.inflection_centre) {
            const double diameter = found.inflection_pole ? length(*found.inflection_pole - found.pole->place()) : 0;
            Entry circle = entry();
            circle.add("centre", found.inflection_centre);
            circle.add("diameter", number(diameter));
            body.add("inflection circle", std::move(circle).json());
        }
        if (found.tangential_pole) body.add("tangential circle", tangential_circle(found));
        body.add("acceleration pole", found.acceleration_pole);
        body.add("points", path_centres(found));
        if (!found.envelopes.empty()) body.add("envelopes", envelopes(found));
        return std::move(body).json();
    }

    /// Bresse's second circle: the points without tangential acceleration.
    std::string tangential_circle(const Curvature& found) const {
        const Vector pole = found.pole->place(), half = Exact(1) / Exact(2) * (*found.tangential_pole - pole);
        return object({{"centre", pair(pole + half)}, {"diameter", number(2 * length(half))}});
    }

    std::string path_centres(const Curvature& found) const {
        Members points;
        for (const PathCentre& path : found.points) {
            Entry each = entry();
            if (path.centre && !path.centre->at_infinity()) {
                const Vector centre = path.centre->place();
                each.add("centre", Recorded<Vector>(centre));
                each.add("radius", number(length(centre - solution_.pose.at(path.point))));
            } else {
                each.add("radius", std::string("null"));
                each.add("reason",
                         reason({path.centre ? lang::phrases::path_straight : lang::phrases::point_at_rest, {}}));
            }
            points.emplace_back(name_of_point(path.point), std::move(each).json());
        }
        return object(points);
    }

    std::string envelopes(const Curvature& found) const {
        Members all;
        for (const EnvelopeCentre& envelope : found.envelopes)
            all.emplace_back(mechanism_.joint(envelope.joint).name,
                             object({{"touches", pair(*envelope.touches)},
                                     {"centre", pair(*envelope.centre)},
                                     {"radius", number(length(*envelope.centre - *envelope.touches))}}));
        return object(all);
    }

    /// Components along the moving axes are signed.
    std::string apart(const RelativeMotion::Apart& found) const {
        const Vector axis =
            found.towards == none ? Vector{1, 0} : solution_.pose.at(found.towards) - solution_.pose.at(found.origin);
        const auto components = [&](const Recorded<Vector>& along, const Recorded<Vector>& across) {
            return pair(number(std::copysign(length(*along), dot(*along, axis).to_double())),
                        number(std::copysign(length(*across), cross(axis, *across).to_double())));
        };
        Entry entry = this->entry();
        entry.add("origin", quoted(name_of_point(found.origin)));
        entry.add("x axis", unit(axis));
        entry.add("omega", found.omega);
        entry.add("alpha", found.alpha);
        entry.add("velocity of the origin", found.origin_velocity);
        entry.add("velocity of turning", found.turning_velocity);
        entry.add("acceleration of the origin", found.origin_acceleration);
        entry.add("tangential acceleration", found.tangential);
        entry.add("normal acceleration", found.normal);
        entry.add("relative velocity in the axes", components(found.velocity_along, found.velocity_across));
        entry.add("relative acceleration in the axes", components(found.acceleration_along, found.acceleration_across));
        return std::move(entry).json();
    }
};

/// Sections of forces: at joints and on bodies, in the bars of a truss and by cuts through it.
class StaticsResults : ResultsSection {
public:
    using ResultsSection::ResultsSection;

    /// One member per joint name, in the file's order, with the actions between its bodies.
    std::string forces() const {
        std::vector<std::pair<std::string, Members>> by_joint;
        for (const JointForce& action : solution_.forces) {
            if (!action.force && !action.component && !action.couple) continue;
            const Joint& joint = mechanism_.joint(action.joint);
            if (by_joint.empty() || by_joint.back().first != joint.name) {
                const auto same = std::find_if(by_joint.begin(), by_joint.end(),
                                               [&](const auto& entry) { return entry.first == joint.name; });
                if (same != by_joint.end()) {
                    std::rotate(same, same + 1, by_joint.end());
                } else {
                    by_joint.emplace_back(joint.name, Members{});
                }
            }
            Entry here = entry();
            here.add("force", action.force);
            if (action.component)
                here.add("component",
                         object({{"along", pair(unit_of_component(action))}, {"value", number(component_of(action))}}));
            here.add_place(joint.point);
            here.add("couple", action.couple);
            if (action.force && action.couple) add_through(action, solution_.pose.at(joint.point), here);
            const std::string from = action.from == none ? "pin" : name_of_body(action.from);
            by_joint.back().second.emplace_back(from + " on " + name_of_body(action.on), std::move(here).json());
        }
        Members all;
        for (const auto& [name, actions] : by_joint) all.emplace_back(name, object(actions));
        return object_of_lines(all);
    }

    std::string effort() const {
        Members all;
        for (const EffortValue& found : solution_.efforts) {
            if (found.value) all.emplace_back(found.name, number(*found.value));
        }
        return object_of_lines(all);
    }

    /// W, by the sections of the file.
    Members powers() const {
        Members all;
        const auto add = [&](const Quantity& quantity, const auto& power) {
            const std::string_view key = section_of_power(quantity.kind);
            if (all.empty() || all.back().first != key) all.emplace_back(key, "");
            std::string& json = all.back().second;
            json += json.empty() ? "{" : ", ";
            append_member(json, name_of_acting(quantity), number(*power));
        };
        if (forces_asked(solution_)) for_each_power(solution_, add);
        for (auto& each : all) each.second += '}';
        return all;
    }

    /// N, tension positive.
    std::string bars() const {
        const Truss& truss = *solution_.truss;
        Members all;
        for (std::size_t bar = 0; bar < truss.bars.size(); ++bar)
            if (truss.bars[bar].force)
                all.emplace_back(truss.structure.bars[bar].name, number(truss.tension(bar, solution_.pose.points)));
        return object_of_lines(all);
    }

    /// For each bar found by a cut: the moment of the actions on one side, and its arm; for parallel bars the component
    /// across them.
    std::string cuts() const {
        std::vector<std::string> all;
        for (const Truss::Cut& cut : solution_.truss->cuts) {
            const Truss& truss = *solution_.truss;
            std::string names;
            for (const int bar : cut.bars)
                names += (names.empty() ? "" : ", ") + quoted(truss.structure.bars[at_index(bar)].name);
            Members members{{"cut", "[" + names + "]"},
                            {"bar", quoted(truss.structure.bars[at_index(cut.found)].name)}};
            const Truss::CutNumbers numbers = truss.numbers_of(cut, solution_.pose.points);
            if (cut.pivot) {
                members.emplace_back("about", pair(*cut.pivot));
                members.emplace_back("moment", number(numbers.known));
                members.emplace_back("arm", number(numbers.arm));
            } else {
                members.emplace_back("across", number(numbers.known));
                members.emplace_back("sine", number(numbers.arm));
            }
            all.push_back(object(members));
        }
        return lines('[', all, ']');
    }

    /// By connected bodies: "2", "2,3".
    std::string resultants() const {
        Members all;
        for (const Resultant& found : solution_.resultants) {
            std::string name;
            for (const BodyIndex body : found.bodies) name += (name.empty() ? "" : ",") + name_of_body(body);
            Entry here = entry();
            here.add("force", found.force);
            here.add("couple", found.couple);
            if (found.through)
                here.add("through", found.through);
            else
                here.add("through", std::string("null"));
            all.emplace_back(name, std::move(here).json());
        }
        return object_of_lines(all);
    }

private:
    static std::string_view section_of_power(Quantity::Kind kind) {
        switch (kind) {
            case Quantity::Kind::power_of_load: return "loads";
            case Quantity::Kind::power_of_weight: return "weights";
            case Quantity::Kind::power_of_inertia: return "inertia forces";
            default: return "effort";
        }
    }
    std::string name_of_acting(const Quantity& power) const {
        const auto name = [](const auto& given) { return given.name; };
        const std::size_t i = at_index(power.given);
        switch (result_kind(power).subject) {
            case ResultKind::Subject::load: return std::visit(name, mechanism_.loads[i]);
            case ResultKind::Subject::mass: return name_of_body(mechanism_.masses[i].body);
            default: return std::visit(name, mechanism_.efforts[i]);
        }
    }

    /// The foot of the perpendicular from the joint's point on the line of the resultant: arm M/F.
    static void add_through(const JointForce& action, const Vector& at, Entry& here) {
        const Vector& force = *action.force;
        if (force.is_zero())
            here.add("through", std::string("null"));
        else
            here.add("through", Recorded<Vector>(at - (*action.couple / squared_length(force)) * quarter_turn(force)));
    }
};

/// The whole file, section by section.
class Results : ResultsSection {
public:
    using ResultsSection::ResultsSection;

    std::string json() const {
        const MotionResults motion(solution_, exact_, tell_);
        const StaticsResults forces(solution_, exact_, tell_);
        Members file;
        file.emplace_back("mobility", mobility());
        if (solution_.instant_motion && !solution_.instant_motion->branches.empty())
            file.emplace_back("branches", branches());
        file.emplace_back("points", motion.points());
        file.emplace_back("bodies", motion.bodies());
        file.emplace_back("sliding", motion.sliding());
        file.emplace_back("instant centres", motion.centres());
        if (solution_.instantaneous_motion && solution_.instantaneous_motion->acceleration_centre)
            file.emplace_back("acceleration centres", motion.acceleration_centres());
        if (!solution_.relative_motion.empty()) file.emplace_back("relative motion", motion.relative_motion());
        if (!solution_.curvature.empty()) file.emplace_back("curvature", motion.curvature());
        if (auto angles = motion.transmission_angles(); !angles.empty())
            file.emplace_back("transmission angles", object_of_lines(angles));
        if (forces_asked(solution_)) {
            file.emplace_back("forces", forces.forces());
            file.emplace_back("effort", forces.effort());
            if (solution_.truss) file.emplace_back("bars", forces.bars());
            if (solution_.truss && !solution_.truss->cuts.empty()) file.emplace_back("cuts", forces.cuts());
        }
        if (auto powers = forces.powers(); !powers.empty()) file.emplace_back("power", object_of_lines(powers));
        if (!solution_.resultants.empty()) file.emplace_back("resultant", forces.resultants());
        if (solution_.contacts) file.emplace_back(solution_.contacts->kind->key, contacts());
        if (solution_.equations && solution_.equations->why_not.empty())
            file.emplace_back("equations", equations_json(*solution_.equations));
        if (solution_.displacements && solution_.displacements->why_not.empty())
            file.emplace_back("virtual work", displacements_json(mechanism_, *solution_.displacements));
        file.emplace_back("checks", checks());
        file.emplace_back("unsolved", unsolved());
        if (!solution_.remarks.empty() || (solution_.contacts && !solution_.contacts->remarks.empty()))
            file.emplace_back("remarks", remarks());
        std::string text = "{";
        for (const auto& [key, value] : file) {
            text += text.size() == 1 ? "\n  " : ",\n  ";
            append_member(text, key, value);
        }
        return text += "\n}\n";
    }

private:
    std::string mobility() const {
        const Mobility& found = solution_.mobility;
        Members members{{"gruebler", std::to_string(found.gruebler)},
                        {"effective", std::to_string(found.effective)},
                        {"verdict", quoted(kinegraph::name_of(found.verdict()))}};
        Members redundant;
        for (const Mobility::Redundant& each : found.redundant)
            redundant.emplace_back(mechanism_.joint(each.joint).name, std::to_string(each.rows));
        if (!redundant.empty()) members.emplace_back("redundant", object(redundant));
        return object(members);
    }

    /// Ratios of angular velocities, by body.
    std::string branches() const {
        std::vector<std::string> all;
        for (const Branch& branch : solution_.instant_motion->branches) {
            Members ratios, fractions;
            for (std::size_t body = 1; body < branch.ratios.size(); ++body)
                ratios.emplace_back(mechanism_.bodies[body].name, number(branch.ratios[body]));
            for (std::size_t body = 1; body < branch.exact.size(); ++body)
                fractions.emplace_back(mechanism_.bodies[body].name, quoted(branch.exact[body].to_fraction()));
            Members members{{"reference", branch.reference == none ? "null" : quoted(name_of_body(branch.reference))},
                            {"ratios", object(ratios)}};
            if (exact_ && !fractions.empty()) members.emplace_back("exact", object(fractions));
            all.push_back(object(members));
        }
        return lines('[', all, ']');
    }

    std::string checks() const {
        std::vector<std::string> all;
        all.reserve(solution_.checks.size());
        for (const CheckRow& row : solution_.checks)
            all.push_back(check_row(name_of(row.quantity, solution_), row.graphical, row.numeric, row.difference));
        if (solution_.contacts) add_checks_of_contacts(all);
        return lines('[', all, ']');
    }

    /// By the key of the problem, the joint and the name of the value.
    void add_checks_of_contacts(std::vector<std::string>& all) const {
        const std::string kind(solution_.contacts->kind->key);
        for (const SolvedContact& contact : solution_.contacts->at_joints)
            for (const ProblemValue& each : contact.found->values)
                all.push_back(
                    check_row(kind + " " + mechanism_.joint(contact.joint).name + " " + in_english(each.name), each));
    }

    std::string unsolved() const {
        std::vector<std::string> all;
        for (const Unsolved& what : solution_.unsolved)
            all.push_back(object({{"what", quoted(tell_(what.what))}, {"why", quoted(tell_(what.why))}}));
        return lines('[', all, ']');
    }

    /// By the joint's name: the load, and the values that follow from it.
    std::string contacts() const {
        Members joints;
        for (const SolvedContact& contact : solution_.contacts->at_joints) {
            Members members{{"force", number(contact.load)}};
            for (auto& each : values_of(*contact.found)) members.push_back(std::move(each));
            joints.emplace_back(mechanism_.joint(contact.joint).name, object(members));
        }
        return object_of_lines(joints);
    }

    std::string remarks() const {
        std::vector<std::string> all;
        for (const Message& remark : solution_.remarks) all.push_back(quoted(tell_(remark)));
        if (solution_.contacts)
            for (const Words& remark : solution_.contacts->remarks) all.push_back(quoted(in_english(remark)));
        return lines('[', all, ']');
    }
};

/// Results of a problem in place of joints: its own section, and the checks of its values.
class ProblemResults {
public:
    ProblemResults(const Solution& solution, bool exact)
        : solution_(solution), found_(*solution.problem), exact_(exact) {}

    std::string json() const {
        const ProblemKind& kind = *solution_.mechanism.problem->kind;
        Members file{{std::string(kind.key), kind.results(solution_, exact_)}};
        file.emplace_back("checks", checks());
        file.emplace_back("unsolved", "[]");
        if (!found_.remarks.empty()) {
            std::vector<std::string> all;
            for (const Words& each : found_.remarks) all.push_back(quoted(in_english(each)));
            file.emplace_back("remarks", lines('[', all, ']'));
        }
        std::string text = "{";
        for (std::size_t i = 0; i < file.size(); ++i)
            text += (i == 0 ? "\n  " : ",\n  ") + quoted(file[i].first) + ": " + file[i].second;
        return text + "\n}\n";
    }

private:
    std::string checks() const {
        std::vector<std::string> all;
        for (const ProblemValue& each : found_.values)
            if (each.numeric) all.push_back(check_row(in_english(each.name), each));
        return lines('[', all, ']');
    }

    const Solution& solution_;
    const ProblemSolution& found_;
    bool exact_;
};

std::string number(const std::optional<double>& value) { return value ? number(*value) : "null"; }

std::string list(const std::vector<std::string>& entries) {
    std::string json = "[";
    for (const std::string& entry : entries) json += (json.size() > 1 ? ", " : "") + entry;
    return json + "]";
}

/// The equations by name: variables are named by body or joint, equations are written in letters.
class EquationResults {
public:
    explicit EquationResults(const Equations& equations) : e_(equations) {}

    std::string json() const {
        std::vector<std::string> loops, laws;
        for (const Equations::Loop& loop : e_.loops) loops.push_back(quoted(spelt(e_, loop)));
        for (const Equations::Law& law : e_.laws) laws.push_back(quoted(spelt(e_, law)));
        Members members{
            {"unknowns", names(e_.unknowns)},
            {"free", names(e_.free)},
            {"jacobian", matrix(e_.jacobian)},
            {"drive", matrix(e_.drive)},
            {"rank", std::to_string(e_.rank)},
            {"determinant", number(e_.determinant)},
            {"velocity ratios", ratios([&](std::size_t j, std::size_t k) { return number(e_.ratios[j][k]); })}};
        if (!e_.second_ratios.empty()) members.emplace_back("second ratios", second_ratios());
        if (!e_.cannot_be_driven.empty()) members.emplace_back("cannot be driven", names(e_.cannot_be_driven));
        members.emplace_back("loops", list(loops));
        if (!laws.empty()) members.emplace_back("laws", list(laws));
        members.emplace_back("letters", letters());
        return object_of_lines(members);
    }

private:
    std::string names(const std::vector<Equations::LetterIndex>& which) const {
        std::vector<std::string> all;
        for (const auto index : which) all.push_back(quoted(e_.letter(index).name));
        return list(all);
    }
    static std::string matrix(const std::vector<std::vector<double>>& rows) {
        std::vector<std::string> all;
        for (const auto& row : rows) {
            std::vector<std::string> entries;
            for (const double entry : row) entries.push_back(number(entry));
            all.push_back(list(entries));
        }
        return list(all);
    }
    template <class Value>
    std::string ratios(Value value) const {
        Members all;
        for (std::size_t j = 0; j < e_.unknowns.size(); ++j) {
            Members own;
            for (std::size_t k = 0; k < e_.free.size(); ++k) own.emplace_back(e_.letter(e_.free[k]).name, value(j, k));
            all.emplace_back(e_.letter(e_.unknowns[j]).name, object(own));
        }
        return object(all);
    }
    /// By the drivers' names; for two drivers, joined with a comma.
    std::string second_ratios() const {
        Members all;
        for (std::size_t j = 0; j < e_.unknowns.size(); ++j) {
            Members own;
            for (std::size_t k = 0; k < e_.free.size(); ++k)
                for (std::size_t l = k; l < e_.free.size(); ++l) {
                    const std::string& first = e_.letter(e_.free[k]).name;
                    own.emplace_back(l == k ? first : first + ", " + e_.letter(e_.free[l]).name,
                                     number(e_.second_ratios[j][k][l]));
                }
            all.emplace_back(e_.letter(e_.unknowns[j]).name, object(own));
        }
        return object(all);
    }
    std::string letters() const {
        Members all;
        for (const Equations::Letter& letter : e_.letters) {
            Members own{{"value", number(letter.value)}};
            if (!letter.name.empty()) own.insert(own.begin(), {"of", quoted(letter.name)});
            if (letter.role != Equations::Letter::Role::given) {
                own.emplace_back("rate", number(letter.rate));
                own.emplace_back("second rate", number(letter.acceleration));
            }
            all.emplace_back(spelt(letter), object(own));
        }
        return object(all);
    }

    const Equations& e_;
};

/// Virtual work: the displacements, the work per unit of them, and the efforts.
class DisplacementResults {
public:
    DisplacementResults(const Mechanism& mechanism, const Displacements& found)
        : mechanism_(mechanism), found_(found) {}

    std::string json() const {
        std::vector<std::string> freedoms;
        for (const Displacements::Freedom& freedom : found_.freedoms) freedoms.push_back(of(freedom));
        return object_of_lines(
            {{"freedoms", list(freedoms)},
             {"effort",
              efforts([](const auto& effort) { return effort.value ? number(*effort.value) : std::string("null"); })},
             {"effort by velocity ratios", efforts([](const auto& effort) { return number(effort.ratio); })},
             {"balanced", found_.balanced ? "true" : "false"}});
    }

private:
    template <class Value>
    std::string efforts(Value value) const {
        Members members;
        for (const Displacements::Effort& effort : found_.efforts)
            members.emplace_back(name(effort.given), value(effort));
        return object(members);
    }
    std::string name(int effort) const {
        return std::visit([](const auto& given) { return given.name; }, mechanism_.efforts[at_index(effort)]);
    }
    std::string of(const Displacements::Freedom& freedom) const {
        const VirtualWork& work = *freedom.moved->virtual_work;
        Members points, turns, shares;
        for (const PointMotion& point : freedom.moved->points)
            if (point.bodies.front() != frame && point.velocity)
                points.emplace_back(point.label, pair(*point.velocity));
        for (const BodyIndex body : mechanism_.moving_bodies())
            if (const auto& turn = freedom.moved->bodies[at_index(body)].omega)
                turns.emplace_back(mechanism_.body(body).name, number(*turn));
        std::vector<std::string> works;
        for (const VirtualWork::Entry& entry : work.entries)
            works.push_back(object({{"of", quoted(name_of(entry.symbol))},
                                    {"on", quoted(mechanism_.body(entry.body).name)},
                                    {"work", number(entry.power)},
                                    {"by velocity ratios", number(work_by_ratios(*freedom.equations, entry))}}));
        for (const VirtualWork::Share& share : work.shares)
            shares.emplace_back(name(share.effort), number(*share.power));
        return object({{"displaced", quoted(coordinate_name(mechanism_, freedom.driver))},
                       {"chosen", freedom.chosen ? "true" : "false"},
                       {"points", object(points)},
                       {"turns", object(turns)},
                       {"works", list(works)},
                       {"given", number(work.total)},
                       {"unit efforts", object(shares)}});
    }

    const Mechanism& mechanism_;
    const Displacements& found_;
};

}  // namespace

std::string displacements_json(const Mechanism& mechanism, const Displacements& displacements) {
    return DisplacementResults(mechanism, displacements).json();
}

std::string equations_json(const Equations& equations) { return EquationResults(equations).json(); }

std::string results_json(const Solution& solution, bool exact, const Teller& tell) {
    if (stands_for_joints(solution.mechanism)) return ProblemResults(solution, exact).json();
    return Results(solution, exact, tell).json();
}

}  // namespace kinegraph
