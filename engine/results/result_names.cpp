#include "engine/results/result_names.hpp"

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "engine/mechanism/exercise.hpp"
#include "engine/number/assert.hpp"
#include "engine/results/operands.hpp"
#include "engine/results/result_expression.hpp"
#include "engine/sentences/centre_symbol.hpp"
#include "engine/sentences/result_catalogue.hpp"
#include "engine/solution/result_values.hpp"
#include "engine/solution/truss.hpp"

namespace kinegraph {
namespace {

using Kind = Quantity::Kind;

std::string name_of_load(const Mechanism& mechanism, int given) {
    return std::visit([](const auto& each) { return each.name; }, mechanism.loads[at_index(given)]);
}
std::string name_of_effort(const Mechanism& mechanism, int given) {
    return std::visit([](const auto& each) { return each.name; }, mechanism.efforts[at_index(given)]);
}
/// Whether anything acts from outside.
bool is_loaded(const Mechanism& mechanism) {
    return !mechanism.loads.empty() || (mechanism.gravity && !mechanism.masses.empty()) || mechanism.inertia_forces;
}
bool is_a_load(const std::string& name, const Mechanism& mechanism) {
    for (std::size_t i = 0; i < mechanism.loads.size(); ++i)
        if (name_of_load(mechanism, static_cast<int>(i)) == name) return true;
    return false;
}

/// "omega 3", "vx A", "F A 3 on 2", "effort M".
std::string name_of_column(const Quantity& q, const Mechanism& mechanism, const std::string& subject) {
    using Subject = ResultKind::Subject;
    const ResultKind& kind = result_kind(q);
    std::string name(*kind.column);
    if (q.component != Quantity::Component::whole) {
        const std::string axis = q.component == Quantity::Component::x ? "x" : "y";
        name = name.size() > 1 ? axis + " " + name : name + axis;
    }
    if (!name.empty()) name += " ";
    const auto body = [&](BodyIndex index) { return index == none ? std::string("pin") : mechanism.body(index).name; };
    switch (kind.subject) {
        case Subject::body: return name + body(q.body);
        case Subject::path: return name + mechanism.point(q.point).name + " on " + body(q.body);
        case Subject::action:
        case Subject::component:
            return name + mechanism.joint(q.joint).name + " " + body(q.other) + " on " + body(q.body);
        case Subject::effort:
            return name + (kind.on_request ? subject_on_request(q, mechanism) : name_of_effort(mechanism, q.given));
        default: return name + (kind.on_request && subject.empty() ? subject_on_request(q, mechanism) : subject);
    }
}

/// All quantities that a solution may contain, with the names of their subjects.
class Possible {
public:
    Possible(const Mechanism& mechanism, int driver) : m_(mechanism), driver_(driver) {}

    std::vector<Column> all() && {
        for (const BodyIndex body : m_.moving_bodies())
            for (const Quantity& turning : {omega_of(body), alpha_of(body)}) add(turning, "");
        for (const PointIndex point : indices<PointIndex>(m_.points.size())) add_point(point);
        for (const Joint& joint : m_.joints) add_joint(joint);
        for (std::size_t e = 0; e < m_.efforts.size(); ++e)
            add({.kind = Kind::effort, .given = static_cast<int>(e)}, "");
        for (const Column& column : columns_) taken_.insert(column.name);
        add_on_request();
        for (Column& modulus : vectors_) add_unless_taken(std::move(modulus));
        return std::move(columns_);
    }

private:
    void add(const Quantity& quantity, const std::string& subject) { add_columns(quantity, m_, subject, columns_); }
    void add_vector(const Quantity& quantity, const std::string& subject, bool names_carrier = false) {
        const std::size_t first = columns_.size();
        add(quantity.along(Quantity::Component::x), subject);
        add(quantity.along(Quantity::Component::y), subject);
        for (std::size_t i = first; i < columns_.size(); ++i) columns_[i].names_carrier = names_carrier;
        vectors_.push_back(modulus_column(quantity, m_, subject));
        vectors_.back().names_carrier = names_carrier;
    }
    void add_point(PointIndex point) {
        std::vector<BodyIndex> carriers;
        for (const BodyIndex body : m_.moving_bodies()) {
            const auto& listed = m_.body(body).points;
            const bool joined = std::any_of(m_.joints.begin(), m_.joints.end(), [&](const Joint& joint) {
                return joint.point == point && joint.connects(body);
            });
            const bool given = m_.motion && m_.motion->body == body;
            if (joined || given || std::find(listed.begin(), listed.end(), point) != listed.end())
                carriers.push_back(body);
        }
        if (carriers.empty()) return;
        for (const BodyIndex body : carriers) carried_.emplace_back(body, point);
        for (const Kind kind : {Kind::velocity, Kind::acceleration}) {
            add_vector({.kind = kind, .body = carriers.front(), .point = point}, m_.point(point).name);
            if (carriers.size() == 1) continue;
            for (const BodyIndex body : carriers)
                add_vector({.kind = kind, .body = body, .point = point},
                           m_.point(point).name + " on " + m_.body(body).name, true);
        }
    }
    void add_joint(const Joint& joint) {
        const JointIndex index = m_.index_of(joint);
        if (joint.pair().slides()) {
            for (const Kind kind : {Kind::sliding_velocity, Kind::sliding_acceleration}) {
                add({.kind = kind, .joint = index}, joint.name);
                if (joint.pair().touches())
                    add({.kind = kind, .joint = index}, joint.name + " (" + m_.body(joint.bodies[0]).name + " on " +
                                                            m_.body(joint.bodies[1]).name + ")");
            }
        }
        for (const BodyIndex on : joint.bodies) {
            for (const BodyIndex from : joint.bodies)
                if (on != from) add_action({.kind = Kind::force, .body = on, .other = from, .joint = index}, joint);
            if (joint.has_own_node()) add_action({.kind = Kind::force, .body = on, .joint = index}, joint);
        }
    }
    void add_action(Quantity quantity, const Joint& joint) {
        add_vector(quantity, "");
        actions_.push_back(quantity);
        quantity.kind = Kind::couple;
        if (joint.pair().transmits_couple()) add(quantity, "");
    }

    void add_on_request() {
        for (const BodyIndex first : indices_of(m_.bodies))
            for (const BodyIndex second : m_.bodies_after(first))
                add_vector_unless_taken({.kind = Kind::centre, .body = first, .other = second});
        const auto add_powers = [&](Kind kind, std::size_t count) {
            for (std::size_t i = 0; i < count; ++i) add_unless_taken({.kind = kind, .given = static_cast<int>(i)});
        };
        add_powers(Kind::power_of_load, m_.loads.size());
        if (m_.gravity) add_powers(Kind::power_of_weight, m_.masses.size());
        if (m_.inertia_forces) add_powers(Kind::power_of_inertia, m_.masses.size());
        add_powers(Kind::power_of_effort, m_.efforts.size());
        for (auto& [column, coupler] : transmission_columns(m_, driver_)) {
            taken_.insert(column.name);
            columns_.push_back(std::move(column));
        }
        if (const auto truss = truss_of(m_))
            for (const TrussStructure::Bar& bar : truss->bars) add_unless_taken({.kind = Kind::bar, .body = bar.body});
        for (const auto& [body, point] : carried_)
            add_unless_taken({.kind = Kind::radius, .body = body, .point = point});
        for (const BodyIndex body : m_.moving_bodies()) {
            add_unless_taken({.kind = Kind::inflection_diameter, .body = body});
            add_vector_unless_taken({.kind = Kind::acceleration_pole, .body = body});
            if (is_loaded(m_)) {
                add_vector_unless_taken({.kind = Kind::resultant, .body = body});
                add_unless_taken({.kind = Kind::resultant_couple, .body = body});
            }
        }
        for (Quantity action : actions_) {
            action.kind = Kind::force_component;
            add_unless_taken(action);
        }
    }
    void add_vector_unless_taken(const Quantity& quantity) {
        add_unless_taken(quantity.along(Quantity::Component::x));
        add_unless_taken(quantity.along(Quantity::Component::y));
        if (result_kind(quantity).shape == ResultKind::Shape::vector)
            vectors_.push_back(modulus_column(quantity, m_, ""));
    }
    void add_unless_taken(const Quantity& quantity) {
        std::vector<Column> added;
        add_columns(quantity, m_, "", added);
        add_unless_taken(std::move(added.front()));
    }
    void add_unless_taken(Column column) {
        if (taken_.insert(column.name).second) columns_.push_back(std::move(column));
    }

    const Mechanism& m_;
    int driver_;
    std::vector<Column> columns_;
    std::unordered_set<std::string> taken_;  ///< names of columns_
    std::vector<Column> vectors_;            // as lengths
    std::vector<std::pair<BodyIndex, PointIndex>> carried_;
    std::vector<Quantity> actions_;
};

}  // namespace

std::string subject_on_request(const Quantity& q, const Mechanism& mechanism) {
    using Subject = ResultKind::Subject;
    switch (result_kind(q).subject) {
        case Subject::two_bodies: return "P" + centre_symbol(mechanism, q.body, q.other, false).about;
        case Subject::load: return name_of_load(mechanism, q.given);
        case Subject::mass: return mechanism.body(mechanism.masses[at_index(q.given)].body).name;
        case Subject::effort: {
            const std::string name = name_of_effort(mechanism, q.given);
            return (is_a_load(name, mechanism) ? "effort " : "") + name;
        }
        case Subject::coupler: return mechanism.joint(q.joint).name;
        case Subject::body: return mechanism.body(q.body).name;
        case Subject::path: return mechanism.point(q.point).name;
        case Subject::component: return symbol_of_action(q, mechanism).about;
        case Subject::bar:
            if (const auto truss = truss_of(mechanism))
                for (const TrussStructure::Bar& bar : truss->bars)
                    if (bar.body == q.body) return bar.name;
            break;
        default: break;
    }
    KG_ASSERT(false, "a result on request has one of these subjects");
}

std::vector<std::pair<Column, Coupler>> transmission_columns(const Mechanism& mechanism, int driver) {
    std::vector<std::pair<Column, Coupler>> columns;
    for (const auto& [name, coupler] : named_couplers(mechanism, driver)) {
        std::vector<Column> column;
        add_columns(angle_of(coupler), mechanism, name, column);
        columns.emplace_back(std::move(column.front()), coupler);
    }
    return columns;
}

void add_columns(const Quantity& q, const Mechanism& mechanism, const std::string& subject,
                 std::vector<Column>& columns) {
    using Subject = ResultKind::Subject;
    const ResultKind& kind = result_kind(q);
    const auto add = [&](Column::Kind what, std::string name, QuantityKind unit) {
        columns.push_back({what, q, std::move(name), unit});
    };
    // A body's angle, a point's place and a slide's displacement come before its velocity.
    if (kind.is_velocity()) {
        if (kind.subject == Subject::body)
            add(Column::Kind::angle, "angle " + mechanism.body(q.body).name, QuantityKind::angle);
        if (kind.subject == Subject::point && q.component == Quantity::Component::x) {
            add(Column::Kind::place_x, "x " + subject, QuantityKind::length);
            add(Column::Kind::place_y, "y " + subject, QuantityKind::length);
        }
        if (kind.subject == Subject::joint && mechanism.joint(q.joint).along)
            add(Column::Kind::slid, "s " + subject, QuantityKind::length);
    }
    add(kind.shape == ResultKind::Shape::along ? Column::Kind::along : Column::Kind::result,
        name_of_column(q, mechanism, subject), unit_kind_of(q, mechanism));
    if (q.component != Quantity::Component::whole)
        columns.back().vector = name_of_column(q.along(Quantity::Component::whole), mechanism, subject);
}

Column modulus_column(const Quantity& vector, const Mechanism& mechanism, const std::string& subject) {
    const Quantity whole = vector.along(Quantity::Component::whole);
    return {Column::Kind::result, whole, name_of_column(whole, mechanism, subject), unit_kind_of(whole, mechanism)};
}

Column modulus_column(const Column& component, const Mechanism& mechanism) {
    const Quantity whole = component.quantity.along(Quantity::Component::whole);
    return {Column::Kind::result, whole, component.vector, unit_kind_of(whole, mechanism)};
}

bool is_modulus(const Column& column) {
    return column.kind == Column::Kind::result && column.quantity.component == Quantity::Component::whole &&
           result_kind(column.quantity).shape == ResultKind::Shape::vector;
}

Symbol symbol_of_action(const Quantity& action, const Mechanism& mechanism) {
    const Joint& joint = mechanism.joint(action.joint);
    const std::string& of =
        action.other == none ? mechanism.point(joint.point).name : mechanism.body(action.other).name;
    const std::string& on = mechanism.body(action.body).name;
    Symbol symbol{result_kind(action).letter, of, ""};
    symbol.about += (of.size() == 1 && on.size() == 1 ? "" : ",") + on;
    const auto is_between = [&](const Joint& other) {
        return !other.has_own_node() && other.connects(action.body) && other.connects(action.other);
    };
    if (action.other != none && std::count_if(mechanism.joints.begin(), mechanism.joints.end(), is_between) > 1)
        symbol.term = joint.name;
    return symbol;
}

std::optional<Quantity> bar_of(const Column& column, const Mechanism& mechanism) {
    const Quantity& q = column.quantity;
    if (!is_modulus(column) || q.kind != Kind::force || q.other != none) return std::nullopt;
    const PointIndex pin = mechanism.joint(q.joint).point;
    for (const Load& load : mechanism.loads)
        if (const auto* force = std::get_if<ForceLoad>(&load);
            force != nullptr && force->body == q.body && force->at == pin)
            return std::nullopt;
    const auto truss = truss_of(mechanism);
    if (!truss) return std::nullopt;
    const auto is_it = [&](const TrussStructure::Bar& bar) { return bar.body == q.body; };
    if (std::none_of(truss->bars.begin(), truss->bars.end(), is_it)) return std::nullopt;
    return Quantity{.kind = Kind::bar, .body = q.body};
}

Column transmission_column() { return {Column::Kind::named, {}, transmission_angle_name, QuantityKind::angle}; }

std::vector<Column> constructed_results(const Mechanism& mechanism, int driver) {
    return Possible(mechanism, driver).all();
}

std::vector<Column> possible_results(const Mechanism& mechanism, int driver) {
    std::vector<Column> columns = constructed_results(mechanism, driver);
    for (const ResultExpression& each : defined_results(mechanism)) columns.push_back(each.column());
    return columns;
}

std::vector<Column> asked_columns(const Mechanism& mechanism) {
    std::vector<Column> columns;
    if (asked_of(mechanism).empty()) return columns;
    const std::vector<Column> possible = possible_results(mechanism);
    for (const AskedResult& each : asked_of(mechanism)) {
        const auto found = std::find_if(possible.begin(), possible.end(),
                                        [&](const Column& other) { return other.name == each.name; });
        if (found != possible.end())
            columns.push_back(*found);
        else
            columns.push_back({Column::Kind::named, {}, each.name, QuantityKind::angle});
        if (const auto expression = expression_called(each.name, mechanism)) columns.back() = expression->column();
        if (const auto bar = bar_of(columns.back(), mechanism)) columns.back().quantity = *bar;
    }
    return columns;
}

std::optional<std::array<PointIndex, 2>> line_of(const Body& body, const Pose& pose) {
    for (const PointIndex point : body.points) {
        const Vector along = pose.at(point) - pose.at(body.points[0]);
        if (along.x.to_double() != 0 || along.y.to_double() != 0) return std::array{body.points[0], point};
    }
    return std::nullopt;
}

}  // namespace kinegraph
