// The results file (docs/results.md): a Solution as JSON, SI units, keys in the file's order, numbers as the shortest
// decimals that round-trip to the same double. Computes nothing and rounds only to doubles.
#include "engine/results/results.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/equations/equations.hpp"
#include "engine/number/functions.hpp"
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

constexpr auto on_lines = JsonWriter::Entries::on_lines;

VectorOf<double> unit(const Vector& direction) {
    const double dx = direction.x.to_double();
    const double dy = direction.y.to_double();
    const double length = nearest::hypot(dx, dy);
    return {dx / length, dy / length};
}
/// The same direction in the smallest integers; its length is arbitrary.
Vector whole(const Vector& direction) {
    if (direction.x.is_zero()) return {0, 1};
    const Exact slope = direction.y / direction.x;
    const Exact run(mpq_class(slope.rational().get_den()));
    return {run, run * slope};
}

/// A bound, rounded outwards, so that it stays a bound.
double bound(const Exact& leftover) {
    const double value = leftover.to_double();
    return Exact::from_double(value) < leftover ? std::nextafter(value, HUGE_VAL) : value;
}

/// One entry of the file: its values, and the exact ones if requested.
class Entry {
public:
    Entry(const Pose& pose, bool exact) : pose_(pose), exact_(exact) {
        members_.open('{');
        fractions_.open('{');
    }

    template <class... Value>
    void add(std::string_view key, const Value&... value) {
        members_.member(key, value...);
    }
    void add(std::string_view key, const Exact& value) {
        members_.member(key, value);
        if (exact_ && pose_.is_certain(value)) fractions_.key(key).fraction(value);
    }
    void add(std::string_view key, const Vector& value) {
        members_.member(key, value);
        if (exact_ && is_certain(value)) fractions_.key(key).fraction(value);
    }
    template <class Value>
    void add(std::string_view key, const Recorded<Value>& value) {
        if (value) add(key, *value);
    }
    /// A named point's own place, exact or with the error bound of the compass.
    void add_place(PointIndex point) {
        const Vector& at = pose_.at(point);
        const Exact& leftover = pose_.leftover[at_index(point)];
        if (leftover.is_zero()) return add("at", at);
        members_.member("at", at);
        if (exact_) leftover_ = bound(leftover);
    }
    void add_towards(const Vector& sensed) {
        const Vector direction = without_sense(sensed, pose_.exact);
        members_.member("towards", unit(direction));
        if (exact_ && is_certain(direction)) fractions_.key("towards").fraction(whole(direction));
    }
    bool is_empty() const { return members_.is_empty(); }
    /// All of it; nothing is added afterwards.
    const JsonWriter& closed() {
        if (!fractions_.is_empty()) members_.member("exact", fractions_.close());
        if (leftover_) members_.member("leftover", JsonWriter().value(*leftover_).take());
        return members_.close();
    }

private:
    bool is_certain(const Vector& v) const { return pose_.is_certain(v.x) && pose_.is_certain(v.y); }

    const Pose& pose_;
    bool exact_;
    JsonWriter members_, fractions_;
    std::optional<double> leftover_;  ///< a bound
};

/// A row of `checks`.
void write_check(std::string_view name, double graphical, double numeric, double difference, JsonWriter& json) {
    json.open('{').member("quantity", name).member("graphical", graphical).member("numeric", numeric);
    json.member("difference", difference).close();
}
/// For a value that has one.
void write_check(std::string_view name, const ProblemValue& value, JsonWriter& json) {
    const double numeric = value.numeric.value_or(value.value);
    write_check(name, value.value, numeric, value.value - numeric, json);
}

bool forces_asked(const Solution& solution) {
    const Mechanism& mechanism = solution.mechanism;
    if (mechanism.find.stated) return mechanism.find.forces;
    return !mechanism.loads.empty() || !mechanism.efforts.empty() || !solution.resultants.empty();
}

/// The base of the sections of the results.
class ResultsSection {
public:
    ResultsSection(const Solution& solution, bool exact, const Teller& tell, JsonWriter& json)
        : solution_(solution), mechanism_(solution.mechanism), exact_(exact), tell_(tell), json_(json) {}

protected:
    const std::string& name_of_body(BodyIndex body) const { return mechanism_.body(body).name; }
    const std::string& name_of_point(PointIndex point) const { return mechanism_.point(point).name; }
    Entry entry() const { return {solution_.pose, exact_}; }
    /// A result under the name that its row of the catalogue has.
    template <class Value>
    void add(const Quantity& quantity, const Recorded<Value>& value, Entry& entry) const {
        entry.add(result_kind(quantity).in_file, value);
    }

    const Solution& solution_;
    const Mechanism& mechanism_;
    bool exact_;
    const Teller& tell_;
    JsonWriter& json_;
};

/// The sections whose values are all results of the catalogue: where a value lies is in the row of its kind.
class CatalogueSections : ResultsSection {
public:
    CatalogueSections(const Solution& solution, bool exact, const Teller& tell, JsonWriter& json)
        : ResultsSection(solution, exact, tell, json) {
        for_each_result(solution, [&](const Quantity& quantity, const auto& found) { take(quantity, *found); });
    }

    /// Writes the section, also one without values.
    void write(std::string_view name) {
        const auto section = find(name);
        if (section == sections_.end()) {
            json_.key(name).open('{').close();
            return;
        }
        write(*section);
    }
    void write_if_any(std::string_view name) {
        if (const auto section = find(name); section != sections_.end()) write(*section);
    }
    /// Those that have not been written, in the order of their first values.
    void write_the_others() {
        for (Section& each : sections_)
            if (!each.is_written) write(each);
    }

private:
    struct Section {
        std::string_view name;
        JsonWriter json{JsonWriter::Style::document, 1};
        std::string key{};  ///< of the entry
        std::optional<Entry> entry{};
        bool is_written = false;
    };

    std::vector<Section>::iterator find(std::string_view name) {
        return std::find_if(sections_.begin(), sections_.end(), [&](const Section& each) { return each.name == name; });
    }
    /// "section/*", "section/*/member" or, with the numbers of one kind together, "section/member/*".
    template <class Value>
    void take(const Quantity& quantity, const Value& found) {
        const std::string_view place = result_kind(quantity).in_file;
        const std::size_t first = place.find('/'), second = place.rfind('/');
        const std::string_view name = place.substr(0, first);
        if (first == std::string_view::npos) return;  // in a section with more than results
        if (result_kind(quantity).is_of_forces() && !forces_asked(solution_)) return;
        if (find(name) == sections_.end()) {
            sections_.push_back({name});
            sections_.back().json.open('{', on_lines);
        }
        Section& section = *find(name);
        const std::string subject = subject_of(quantity, solution_);
        if (first == second) {
            section.json.member(subject, found);
            return;
        }
        const bool of_subject = place[first + 1] == '*';
        const std::string key = of_subject ? subject : std::string(place.substr(first + 1, second - first - 1));
        if (!section.entry || section.key != key) {
            end_entry(section);
            section.key = key;
            section.entry.emplace(entry());
        }
        if (of_subject)
            section.entry->add(place.substr(second + 1), found);
        else
            section.entry->add(subject, JsonWriter().value(found));
    }
    /// What may lie at infinity is in a section of its own.
    void take(const Quantity& /*quantity*/, const ProjectivePoint& /*found*/) {}
    void take(const Quantity& /*quantity*/, const Distance& /*found*/) {}
    void write(Section& section) {
        end_entry(section);
        json_.member(section.name, section.json.close());
        section.is_written = true;
    }
    static void end_entry(Section& section) {
        if (section.entry) section.json.member(section.key, section.entry->closed());
        section.entry.reset();
    }

    std::vector<Section> sections_;
};

/// Sections of motion: points, centres, relative motion and curvature.
class MotionResults : ResultsSection {
public:
    using ResultsSection::ResultsSection;

    void points() const {
        json_.key("points").open('{', on_lines);
        for (const PointIndex point : indices_of(mechanism_.points)) {
            std::vector<const PointMotion*> nodes;
            for (const PointMotion& motion : solution_.points)
                if (motion.point == point) nodes.push_back(&motion);
            Entry here = entry();
            here.add_place(point);
            if (nodes.size() == 1) add_motion(*nodes[0], here);
            if (nodes.size() > 1) {
                JsonWriter on;
                on.open('{');
                for (const BodyIndex body : indices_of(mechanism_.bodies))
                    for (const PointMotion* node : nodes) {
                        if (std::find(node->bodies.begin(), node->bodies.end(), body) == node->bodies.end()) continue;
                        Entry there = entry();
                        add_motion(*node, there);
                        if (!there.is_empty()) on.member(name_of_body(body), there.closed());
                    }
                if (!on.is_empty()) here.add("on", on.close());
            }
            json_.member(name_of_point(point), here.closed());
        }
        json_.close();
    }

    void centres() const {
        json_.key("instant centres").open('{', on_lines);
        for (const InstantCentre& centre : solution_.centres) {
            Entry where = entry();
            if (centre.everywhere) where.add("everywhere", true);
            if (centre.at && !centre.at->at_infinity())
                where.add("at", centre.at->place());
            else if (centre.at)
                where.add_towards(centre.at->place());
            if (where.is_empty()) continue;
            if (centre.depends_on_drivers) where.add("depends on drivers", true);
            json_.member(subject_of(quantity_of(centre), solution_), where.closed());
        }
        json_.close();
    }

    /// The point of a body whose acceleration vanishes.
    void acceleration_centres() const {
        Entry where = entry();
        where.add("at", solution_.instantaneous_motion->acceleration_centre);
        json_.key("acceleration centres").open('{', on_lines);
        json_.member(name_of_body(solution_.instantaneous_motion->body), where.closed()).close();
    }

    void curvature() const {
        json_.key("curvature").open('{', on_lines);
        for (const Curvature& found : solution_.curvature)
            json_.member(name_of_body(found.body), curvature_of(found).closed());
        json_.close();
    }

    void relative_motion() const {
        json_.key("relative motion").open('[', on_lines);
        for (const RelativeMotion& motion : solution_.relative_motion) {
            Entry seen = entry();
            seen.add("point", name_of_point(motion.query.point));
            if (motion.query.translating_with != none)
                seen.add("observer", JsonWriter()
                                         .open('{')
                                         .member("translating with", name_of_point(motion.query.translating_with))
                                         .close());
            else
                seen.add("observer", name_of_body(motion.query.observer));
            seen.add("velocity", motion.velocity);
            seen.add("transport velocity", motion.transport_velocity);
            seen.add("relative velocity", motion.relative_velocity);
            seen.add("acceleration", motion.acceleration);
            seen.add("transport acceleration", motion.transport_acceleration);
            seen.add("relative acceleration", motion.relative_acceleration);
            seen.add("coriolis", motion.coriolis);
            if (motion.apart) seen.add("apart", apart(*motion.apart).closed());
            json_.value(seen.closed());
        }
        json_.close();
    }

private:
    void add_motion(const PointMotion& motion, Entry& entry) const {
        add(velocity_of(motion), motion.velocity, entry);
        add(acceleration_of(motion), motion.acceleration, entry);
    }

    Entry curvature_of(const Curvature& found) const {
        Entry body = entry();
        const auto reason = [&](const Key& why) { body.add("reason", tell_({why, {}})); };
        if (found.kind == Curvature::Kind::translation) {
            body.add("translation", true);
            reason(lang::phrases::body_translates);
        }
        if (found.kind == Curvature::Kind::turning) reason(lang::phrases::pole_at_rest);
        if (found.kind == Curvature::Kind::rest) reason(lang::phrases::body_at_rest);
        if (found.pole && !found.pole->at_infinity()) body.add("pole", found.pole->place());
        if (found.tangent) body.add("pole tangent", unit(without_sense(*found.tangent, solution_.pose.exact)));
        if (found.inflection_centre) {
            Entry circle = entry();
            circle.add("centre", found.inflection_centre);
            circle.add("diameter", diameter_of(found)->to_double());
            body.add("inflection circle", circle.closed());
        }
        if (found.tangential_pole) body.add("tangential circle", tangential_circle(found));
        body.add("acceleration pole", found.acceleration_pole);
        body.add("points", path_centres(found));
        if (!found.envelopes.empty()) body.add("envelopes", envelopes(found));
        return body;
    }

    /// Bresse's second circle: the points without tangential acceleration.
    static JsonWriter tangential_circle(const Curvature& found) {
        const Vector pole = found.pole->place(), half = Exact(1) / Exact(2) * (*found.tangential_pole - pole);
        return JsonWriter().open('{').member("centre", pole + half).member("diameter", 2 * length(half)).close();
    }

    JsonWriter path_centres(const Curvature& found) const {
        JsonWriter points;
        points.open('{');
        for (const PathCentre& path : found.points) {
            Entry each = entry();
            if (const auto radius = radius_of(path, solution_.pose)) {
                each.add("centre", radius->to);
                each.add("radius", radius->to_double());
            } else {
                each.add("radius", std::nullopt);
                each.add("reason",
                         tell_({path.centre ? lang::phrases::path_straight : lang::phrases::point_at_rest, {}}));
            }
            points.member(name_of_point(path.point), each.closed());
        }
        return points.close();
    }

    JsonWriter envelopes(const Curvature& found) const {
        JsonWriter all;
        all.open('{');
        for (const EnvelopeCentre& envelope : found.envelopes) {
            all.key(mechanism_.joint(envelope.joint).name).open('{');
            all.member("touches", *envelope.touches).member("centre", *envelope.centre);
            all.member("radius", length(*envelope.centre - *envelope.touches)).close();
        }
        return all.close();
    }

    /// Components along the moving axes are signed.
    Entry apart(const RelativeMotion::Apart& found) const {
        const Vector axis =
            found.towards == none ? Vector{1, 0} : solution_.pose.at(found.towards) - solution_.pose.at(found.origin);
        const auto components = [&](const Recorded<Vector>& along, const Recorded<Vector>& across) {
            return VectorOf<double>{std::copysign(length(*along), dot(*along, axis).to_double()),
                                    std::copysign(length(*across), cross(axis, *across).to_double())};
        };
        Entry entry = this->entry();
        entry.add("origin", name_of_point(found.origin));
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
        return entry;
    }
};

/// Sections of forces: at joints and on bodies, and by cuts through a truss.
class StaticsResults : ResultsSection {
public:
    using ResultsSection::ResultsSection;

    /// One member per joint name, in the file's order, with the actions between its bodies.
    void forces() const {
        std::vector<std::pair<std::string, JsonWriter>> by_joint;
        for (const JointForce& action : solution_.forces) {
            if (!action.force && !action.component && !action.couple) continue;
            const Joint& joint = mechanism_.joint(action.joint);
            if (by_joint.empty() || by_joint.back().first != joint.name) {
                const auto same = std::find_if(by_joint.begin(), by_joint.end(),
                                               [&](const auto& entry) { return entry.first == joint.name; });
                if (same != by_joint.end())
                    std::rotate(same, same + 1, by_joint.end());
                else
                    by_joint.emplace_back(joint.name, JsonWriter().open('{'));
            }
            Quantity quantity = quantity_of(action);
            Entry here = entry();
            add(quantity, action.force, here);
            if (action.component)
                here.add("component", JsonWriter()
                                          .open('{')
                                          .member("along", unit_of_component(action))
                                          .member("value", component_of(action))
                                          .close());
            here.add_place(joint.point);
            quantity.kind = Quantity::Kind::couple;
            add(quantity, action.couple, here);
            if (action.force && action.couple) add_through(action, solution_.pose.at(joint.point), here);
            const std::string from = action.from == none ? "pin" : name_of_body(action.from);
            by_joint.back().second.member(from + " on " + name_of_body(action.on), here.closed());
        }
        json_.key("forces").open('{', on_lines);
        for (auto& [name, actions] : by_joint) json_.member(name, actions.close());
        json_.close();
    }

    /// For each bar found by a cut: the moment of the actions on one side, and its arm; for parallel bars the component
    /// across them.
    void cuts() const {
        json_.key("cuts").open('[', on_lines);
        for (const Truss::Cut& cut : solution_.truss->cuts) {
            const Truss& truss = *solution_.truss;
            std::vector<std::string> names;
            for (const int bar : cut.bars) names.push_back(truss.structure.bars[at_index(bar)].name);
            json_.open('{').member("cut", names).member("bar", truss.structure.bars[at_index(cut.found)].name);
            const Truss::CutNumbers numbers = truss.numbers_of(cut, solution_.pose.points);
            if (cut.pivot)
                json_.member("about", *cut.pivot).member("moment", numbers.known).member("arm", numbers.arm);
            else
                json_.member("across", numbers.known).member("sine", numbers.arm);
            json_.close();
        }
        json_.close();
    }

    /// By connected bodies: "2", "2,3".
    void resultants() const {
        json_.key("resultant").open('{', on_lines);
        for (const Resultant& found : solution_.resultants) {
            std::string name;
            for (const BodyIndex body : found.bodies) name += (name.empty() ? "" : ",") + name_of_body(body);
            Entry here = entry();
            here.add("force", found.force);
            here.add("couple", found.couple);
            if (found.through)
                here.add("through", found.through);
            else
                here.add("through", std::nullopt);
            json_.member(name, here.closed());
        }
        json_.close();
    }

private:
    /// The foot of the perpendicular from the joint's point on the line of the resultant: arm M/F.
    static void add_through(const JointForce& action, const Vector& at, Entry& here) {
        const Vector& force = *action.force;
        if (force.is_zero())
            here.add("through", std::nullopt);
        else
            here.add("through", at - (*action.couple / squared_length(force)) * quarter_turn(force));
    }
};

/// The whole file, section by section.
class Results : ResultsSection {
public:
    using ResultsSection::ResultsSection;

    void write() const {
        const MotionResults motion(solution_, exact_, tell_, json_);
        const StaticsResults forces(solution_, exact_, tell_, json_);
        CatalogueSections sections(solution_, exact_, tell_, json_);
        json_.open('{', on_lines);
        mobility();
        if (solution_.instant_motion && !solution_.instant_motion->branches.empty()) branches();
        motion.points();
        sections.write("bodies");
        sections.write("sliding");
        motion.centres();
        if (solution_.instantaneous_motion && solution_.instantaneous_motion->acceleration_centre)
            motion.acceleration_centres();
        if (!solution_.relative_motion.empty()) motion.relative_motion();
        if (!solution_.curvature.empty()) motion.curvature();
        sections.write_if_any("transmission angles");
        if (forces_asked(solution_)) {
            forces.forces();
            sections.write("effort");
            if (solution_.truss) sections.write("bars");
            if (solution_.truss && !solution_.truss->cuts.empty()) forces.cuts();
        }
        sections.write_the_others();
        if (!solution_.resultants.empty()) forces.resultants();
        if (solution_.contacts) contacts();
        if (solution_.equations && solution_.equations->why_not.empty()) {
            json_.key("equations");
            write_equations(*solution_.equations, json_);
        }
        if (solution_.displacements && solution_.displacements->why_not.empty()) {
            json_.key("virtual work");
            write_displacements(mechanism_, *solution_.displacements, json_);
        }
        checks();
        unsolved();
        if (!solution_.remarks.empty() || (solution_.contacts && !solution_.contacts->remarks.empty())) remarks();
        json_.close();
    }

private:
    void mobility() const {
        const Mobility& found = solution_.mobility;
        json_.key("mobility").open('{').member("gruebler", found.gruebler).member("effective", found.effective);
        json_.member("verdict", kinegraph::name_of(found.verdict()));
        if (!found.redundant.empty()) {
            json_.key("redundant").open('{');
            for (const Mobility::Redundant& each : found.redundant)
                json_.member(mechanism_.joint(each.joint).name, each.rows);
            json_.close();
        }
        json_.close();
    }

    /// Ratios of angular velocities, by body.
    void branches() const {
        json_.key("branches").open('[', on_lines);
        for (const Branch& branch : solution_.instant_motion->branches) {
            json_.open('{').key("reference");
            if (branch.reference == none)
                json_.value(std::nullopt);
            else
                json_.value(name_of_body(branch.reference));
            json_.key("ratios").open('{');
            for (std::size_t body = 1; body < branch.ratios.size(); ++body)
                json_.member(mechanism_.bodies[body].name, branch.ratios[body]);
            json_.close();
            if (exact_ && branch.exact.size() > 1) {
                json_.key("exact").open('{');
                for (std::size_t body = 1; body < branch.exact.size(); ++body)
                    json_.key(mechanism_.bodies[body].name).fraction(branch.exact[body]);
                json_.close();
            }
            json_.close();
        }
        json_.close();
    }

    void checks() const {
        json_.key("checks").open('[', on_lines);
        for (const CheckRow& row : solution_.checks)
            write_check(name_of(row.quantity, solution_), row.graphical, row.numeric, row.difference, json_);
        if (solution_.contacts) add_checks_of_contacts();
        json_.close();
    }

    /// By the key of the problem, the joint and the name of the value.
    void add_checks_of_contacts() const {
        const std::string kind(solution_.contacts->kind->key);
        for (const SolvedContact& contact : solution_.contacts->at_joints)
            for (const ProblemValue& each : contact.found->values)
                write_check(kind + " " + mechanism_.joint(contact.joint).name + " " + each.key, each, json_);
    }

    void unsolved() const {
        json_.key("unsolved").open('[', on_lines);
        for (const Unsolved& what : solution_.unsolved)
            json_.open('{').member("what", tell_(what.what)).member("why", tell_(what.why)).close();
        json_.close();
    }

    /// By the joint's name: the load, and the values that follow from it.
    void contacts() const {
        json_.key(solution_.contacts->kind->key).open('{', on_lines);
        for (const SolvedContact& contact : solution_.contacts->at_joints) {
            json_.key(mechanism_.joint(contact.joint).name).open('{').member("force", contact.load);
            write_values(*contact.found, json_);
            json_.close();
        }
        json_.close();
    }

    void remarks() const {
        json_.key("remarks").open('[', on_lines);
        for (const Message& remark : solution_.remarks) json_.value(tell_(remark));
        if (solution_.contacts)
            for (const Words& remark : solution_.contacts->remarks) json_.value(in_english(remark));
        json_.close();
    }
};

/// Results of a problem in place of joints: its own section, and the checks of its values.
void write_problem(const Solution& solution, bool exact, JsonWriter& json) {
    const ProblemKind& kind = *solution.mechanism.problem->kind;
    const ProblemSolution& found = *solution.problem;
    json.open('{', on_lines).key(kind.key);
    kind.results(solution, exact, json);
    json.key("checks").open('[', on_lines);
    for (const ProblemValue& each : found.values)
        if (each.numeric) write_check(each.key, each, json);
    json.close().key("unsolved").open('[').close();
    if (!found.remarks.empty()) {
        json.key("remarks").open('[', on_lines);
        for (const Words& each : found.remarks) json.value(in_english(each));
        json.close();
    }
    json.close();
}

}  // namespace

void write_values(const ProblemSolution& found, JsonWriter& json) {
    for (const ProblemValue& each : found.values)
        if (each.in_file) json.member(each.key, each.value);
}

std::string results_json(const Solution& solution, bool exact, const Teller& tell) {
    JsonWriter json;
    if (stands_for_joints(solution.mechanism))
        write_problem(solution, exact, json);
    else
        Results(solution, exact, tell, json).write();
    return json.take() + '\n';
}

}  // namespace kinegraph
