#include "engine/results/quantity_name.hpp"

#include <algorithm>

#include "engine/number/assert.hpp"
#include "engine/sentences/result_catalogue.hpp"
#include "engine/solution/result_values.hpp"

namespace kinegraph {
namespace {

class Namer {
public:
    explicit Namer(const Solution& solution) : solution_(solution), mechanism_(solution.mechanism) {}

    std::string name(const Quantity& q) const {
        std::string whole = part_of_name(q) + stem(q);
        switch (q.component) {
            case Quantity::Component::whole: return whole;
            case Quantity::Component::x: return whole + " x";
            case Quantity::Component::y: return whole + " y";
        }
        KG_ASSERT(false, "a component is x or y");
    }
    std::string subject(const Quantity& q) const {
        const ResultKind::Subject kind = result_kind(q).subject;
        return subject(q, kind) + (kind == ResultKind::Subject::joint ? bodies_of_contact(q.joint) : "");
    }

private:
    /// "omega 3", "sliding B velocity", "force A 3 on 2 couple".
    std::string stem(const Quantity& q) const {
        const ResultKind& row = result_kind(q);
        const std::string of = subject(q, row.subject);
        return std::string(row.name) + (of.empty() ? "" : " " + of) + std::string(row.ending);
    }
    std::string subject(const Quantity& q, ResultKind::Subject kind) const {
        using enum ResultKind::Subject;
        const auto name_of_given = [](const auto& given) { return given.name; };
        switch (kind) {
            case nothing: return "";
            case body: return body_name(q.body);
            case two_bodies: return body_name(q.body) + "," + body_name(q.other);
            case point: return carried(q);
            case path: return mechanism_.point(q.point).name + " on " + body_name(q.body);
            case joint: return mechanism_.joint(q.joint).name;
            case action:
            case component:
                return mechanism_.joint(q.joint).name + " " + body_name(q.other) + " on " + body_name(q.body);
            case load: return std::visit(name_of_given, mechanism_.loads[at(q.given)]);
            case mass: return body_name(mechanism_.masses[at(q.given)].body);
            case effort: return std::visit(name_of_given, mechanism_.efforts[at(q.given)]);
            case bar: return bar_name(q.body);
            case coupler:
                for (const auto& [name, each] : named_couplers(mechanism_, 0))
                    if (angle_of(each) == q) return name;
                return mechanism_.joint(q.joint).name;
        }
        KG_ASSERT(false, "a quantity has a subject or none");
    }
    static std::string part_of_name(const Quantity& q) {
        switch (q.part) {
            case Quantity::Part::whole: return "";
            case Quantity::Part::relative: return "relative ";
            case Quantity::Part::normal: return "normal ";
            case Quantity::Part::tangential: return "tangential ";
            case Quantity::Part::sliding: return "sliding ";
            case Quantity::Part::coriolis: return "coriolis ";
            case Quantity::Part::transport: return "transport ";
        }
        KG_ASSERT(false, "a part is one of these");
    }

    std::string bodies_of_contact(JointIndex index) const {
        const Joint& joint = mechanism_.joint(index);
        const auto shares = [&](const Sliding& other) {
            return other.joint != index && mechanism_.joint(other.joint).name == joint.name;
        };
        if (!joint.pair().touches() || std::none_of(solution_.sliding.begin(), solution_.sliding.end(), shares))
            return {};
        return " (" + body_name(joint.bodies[0]) + " on " + body_name(joint.bodies[1]) + ")";
    }
    static std::size_t at(auto index) { return at_index(index); }
    std::string body_name(BodyIndex index) const { return index == none ? "pin" : mechanism_.bodies[at(index)].name; }
    std::string bar_name(BodyIndex index) const {
        if (solution_.truss)
            for (const TrussStructure::Bar& each : solution_.truss->structure.bars)
                if (each.body == index) return each.name;
        return body_name(index);
    }
    std::string carried(const Quantity& q) const {
        // A place that the recipe needs and the file does not name.
        const std::string letter = q.point == none ? "S" : mechanism_.points[at(q.point)].name;
        return is_of_several_bodies(q.point) ? letter + " on " + body_name(q.body) : letter;
    }
    /// Whether several bodies have this point, such as a pin and the point of the slot under it, with different motions
    /// under one letter.
    bool is_of_several_bodies(PointIndex point) const {
        return std::count_if(solution_.points.begin(), solution_.points.end(),
                             [&](const PointMotion& each) { return each.point == point; }) > 1;
    }

    const Solution& solution_;
    const Mechanism& mechanism_;
};

}  // namespace

std::string name_of(const Quantity& quantity, const Solution& solution) { return Namer(solution).name(quantity); }

std::string subject_of(const Quantity& quantity, const Solution& solution) { return Namer(solution).subject(quantity); }

}  // namespace kinegraph
