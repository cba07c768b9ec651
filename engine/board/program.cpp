#include "engine/board/program.hpp"

#include <utility>

#include "engine/drawing/pose.hpp"
#include "engine/drawing/spring_force.hpp"
#include "engine/mechanism/drivers.hpp"
#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {
namespace {

Vector act_vector(const GivenMotion& given, const Pose& pose) {
    if (const auto* bearing = std::get_if<Bearing>(&given.value)) return direction_of(*bearing, pose);
    return std::get<Vector>(given.value);
}

Exact load_magnitude(const Load& load, const Pose& pose) {
    if (const auto* force = std::get_if<ForceLoad>(&load)) return force->magnitude->first;
    if (const auto* couple = std::get_if<CoupleLoad>(&load)) return couple->value;
    if (const auto* torsion = std::get_if<TorsionLoad>(&load)) return couple_of(*torsion);
    if (const auto* distributed = std::get_if<DistributedLoad>(&load)) return force_of(*distributed, pose);
    return pull_of(std::get<SpringLoad>(load), pose);
}
Vector load_unit(const Load& load, const Pose& pose) {
    if (const auto* force = std::get_if<ForceLoad>(&load))
        return unit_along(direction_of(force->magnitude->second, pose), pose.bits);
    if (const auto* distributed = std::get_if<DistributedLoad>(&load))
        return unit_along(direction_of(distributed->along, pose), pose.bits);
    const auto& [from, to] = std::get<SpringLoad>(load).between;
    return unit_along(pose.at(to) - pose.at(from), pose.bits);
}
Vector load_unit_back(const Load& load, const Pose& pose) {
    const auto& [from, to] = std::get<SpringLoad>(load).between;
    return unit_along(pose.at(from) - pose.at(to), pose.bits);
}

Vector other_normal(const Vector& normal, const Vector& tangent) {
    return (2 * dot(normal, tangent) / squared_length(tangent)) * tangent - normal;
}

std::string where_of(const Load& load) {
    return std::visit([](const auto& given) { return given.where; }, load);
}

}  // namespace

Magnitude<Exact> Magnitude<Exact>::of(const Exact& value) {
    if (value.is_zero()) return {};
    return {static_cast<long>(mpz_sizeinbase(value.rational().get_num_mpz_t(), 2)) -
            static_cast<long>(mpz_sizeinbase(value.rational().get_den_mpz_t(), 2))};
}

Value given_value(const Given& given, const Mechanism& mechanism, const Pose& pose) {
    using Kind = Given::Kind;
    const std::size_t i = given.index < 0 ? 0 : at_index(given.index);
    switch (given.kind) {
        case Kind::place: return point_at(pose.points[i]);
        case Kind::guide: return pose.guides[i];
        case Kind::guide_unit: return pose.guide_units[i];
        case Kind::normal: return pose.normals[i];
        case Kind::other_normal: return other_normal(pose.normals[i], pose.tangents[i]);
        case Kind::tangent: return pose.tangents[i];
        case Kind::push: return *mechanism.joints[i].pushes;
        case Kind::driver_direction: return pose.driver_directions[i];
        case Kind::driver_unit: return pose.driver_units[i];
        case Kind::driver_velocity: return rates_of(mechanism.drivers[i]).first;
        case Kind::driver_acceleration: return rates_of(mechanism.drivers[i]).second;
        case Kind::act_velocity: return act_vector(mechanism.motion->velocities[i], pose);
        case Kind::act_acceleration: return act_vector(mechanism.motion->accelerations[i], pose);
        case Kind::load_force: return *std::get<ForceLoad>(mechanism.loads[i]).value;
        case Kind::load_magnitude: return load_magnitude(mechanism.loads[i], pose);
        case Kind::load_unit: return load_unit(mechanism.loads[i], pose);
        case Kind::load_unit_back: return load_unit_back(mechanism.loads[i], pose);
        case Kind::effort_unit:
            return unit_along(direction_of(std::get<ForceEffort>(mechanism.efforts[i]).along, pose), pose.bits);
        case Kind::gravity: return *mechanism.gravity;
        case Kind::mass: return mechanism.masses[i].mass;
        case Kind::inertia: return mechanism.masses[i].inertia;
        case Kind::number: return given.constant.x;
        case Kind::direction: return given.constant;
    }
    KG_ASSERT(false, "every given has a value");
}

std::string name_of_given(Given::Kind kind, int index, const Mechanism& mechanism) {
    using Kind = Given::Kind;
    const std::size_t i = index < 0 ? 0 : at_index(index);
    const auto driver = [&](const char* of_spin, const char* of_slide) {
        const bool spins = turns(mechanism.drivers[i]);
        return where_of(mechanism.drivers[i]) + (spins ? of_spin : of_slide);
    };
    switch (kind) {
        case Kind::place: return mechanism.points[i].where;
        case Kind::guide:
        case Kind::guide_unit: return mechanism.joints[i].where + "/along";
        case Kind::normal:
        case Kind::other_normal:
        case Kind::tangent: return mechanism.joints[i].where;
        case Kind::push: return mechanism.joints[i].where + "/pushes";
        case Kind::driver_direction:
        case Kind::driver_unit: return where_of(mechanism.drivers[i]) + "/along";
        case Kind::driver_velocity: return driver("/omega", "/speed");
        case Kind::driver_acceleration: return driver("/alpha", "/acceleration");
        case Kind::act_velocity: return mechanism.motion->where + "/velocities/" + std::to_string(index);
        case Kind::act_acceleration: return mechanism.motion->where + "/accelerations/" + std::to_string(index);
        case Kind::load_force:
        case Kind::load_magnitude:
        case Kind::load_unit:
        case Kind::load_unit_back: return where_of(mechanism.loads[i]);
        case Kind::effort_unit: return std::get<ForceEffort>(mechanism.efforts[i]).where + "/along";
        case Kind::gravity: return "/gravity";
        case Kind::mass: return mechanism.masses[i].where + "/mass";
        case Kind::inertia: return mechanism.masses[i].where + "/inertia";
        case Kind::number:
        case Kind::direction: return {};
    }
    KG_ASSERT(false, "every given has a name");
}

std::vector<Value> givens_of(const Program& program, const Mechanism& mechanism, const Pose& pose) {
    std::vector<Value> values;
    values.reserve(program.givens.size());
    for (const Given& given : program.givens) values.push_back(given_value(given, mechanism, pose));
    return values;
}

ValueOf<double> to_double(const Value& value) {
    const auto near = [](const Exact& number) { return number.to_double(); };
    if (const auto* p = std::get_if<ProjectivePoint>(&value))
        return PointOf<double>{near(p->x), near(p->y), near(p->w)};
    if (const auto* l = std::get_if<ProjectiveLine>(&value)) return LineOf<double>{near(l->a), near(l->b), near(l->c)};
    if (const auto* v = std::get_if<Vector>(&value)) return VectorOf<double>{near(v->x), near(v->y)};
    return near(std::get<Exact>(value));
}

bool is_at_infinity(const Program& program, ElementIndex element) {
    const Stroke& stroke = program.strokes[at_index(element)];
    switch (stroke.verb) {
        case Verb::point_at_infinity:
        case Verb::meet_at_infinity: return true;
        case Verb::through: return is_at_infinity(program, stroke.inputs[0]);
        case Verb::join: return is_at_infinity(program, stroke.inputs[0]) && is_at_infinity(program, stroke.inputs[1]);
        default: return false;
    }
}

ElementIndex before_turning(const Program& program, ElementIndex element) {
    const Stroke& stroke = program.strokes[at_index(element)];
    const bool turns = stroke.verb == Verb::perpendicular || stroke.verb == Verb::turn || stroke.verb == Verb::negate;
    return turns ? before_turning(program, stroke.inputs[0]) : element;
}

bool identical(const Value& a, const Value& b) {
    if (a.index() != b.index()) return false;
    if (const auto* p = std::get_if<ProjectivePoint>(&a)) {
        const auto& q = std::get<ProjectivePoint>(b);
        return p->x == q.x && p->y == q.y && p->w == q.w;
    }
    if (const auto* l = std::get_if<ProjectiveLine>(&a)) {
        const auto& m = std::get<ProjectiveLine>(b);
        return l->a == m.a && l->b == m.b && l->c == m.c;
    }
    if (const auto* v = std::get_if<Vector>(&a)) return *v == std::get<Vector>(b);
    return std::get<Exact>(a) == std::get<Exact>(b);
}

namespace {

/// Marks the inputs of the marked strokes, from the last to the first.
void mark_inputs(const Program& program, std::vector<bool>& marked) {
    for (std::size_t i = marked.size(); i-- > 0;) {
        if (!marked[i]) continue;
        for (const ElementIndex input : program.strokes[i].inputs)
            if (input != none) marked[at_index(input)] = true;
    }
}

}  // namespace

std::vector<int> hangs_on(const Program& program, ElementIndex element) {
    std::vector<bool> needed(program.strokes.size(), false);
    needed[at_index(element)] = true;
    mark_inputs(program, needed);
    std::vector<int> givens;
    for (std::size_t i = 0; i < needed.size(); ++i)
        if (needed[i] && program.strokes[i].given >= 0) givens.push_back(program.strokes[i].given);
    std::sort(givens.begin(), givens.end());
    return givens;
}

Cut cut(const Program& program, const std::vector<ElementIndex>& wanted, int settled) {
    std::vector<bool> needed(program.strokes.size(), false);
    for (const ElementIndex element : wanted) needed[at_index(element)] = true;
    const auto decides = [&](const Guard& guard) {
        return guard.before <= settled && guard.how != Guard::How::by_choice;
    };
    for (const Guard& guard : program.guards)
        for (const ElementIndex input : guard.inputs)
            if (input != none && decides(guard)) needed[at_index(input)] = true;
    mark_inputs(program, needed);

    Cut result;
    result.program.doubtful_bits = program.doubtful_bits;
    result.element.assign(program.strokes.size(), none);
    std::vector<int> made(program.strokes.size() + 1, 0);  // by stroke: number of strokes kept before it
    for (std::size_t i = 0; i < program.strokes.size(); ++i) {
        made[i + 1] = made[i] + (needed[i] ? 1 : 0);
        if (!needed[i]) continue;
        Stroke stroke = program.strokes[i];
        for (ElementIndex& input : stroke.inputs)
            if (input != none) input = result.element[at_index(input)];
        if (stroke.given >= 0) {
            result.program.givens.push_back(program.givens[at_index(stroke.given)]);
            stroke.given = static_cast<int>(result.program.givens.size()) - 1;
        }
        result.element[i] = ElementIndex(result.program.strokes.size());
        result.program.strokes.push_back(stroke);
    }
    for (Guard guard : program.guards) {
        if (!decides(guard)) continue;
        for (ElementIndex& input : guard.inputs)
            if (input != none) input = result.element[at_index(input)];
        guard.before = made[at_index(guard.before)];
        result.program.guards.push_back(guard);
    }
    return result;
}

namespace {

struct ExactMemory {
    using Number = Exact;
    std::vector<Value>& values;

    const ProjectivePoint& point(ElementIndex i) const { return std::get<ProjectivePoint>(values[at_index(i)]); }
    const ProjectiveLine& line(ElementIndex i) const { return std::get<ProjectiveLine>(values[at_index(i)]); }
    const Vector& vector(ElementIndex i) const { return std::get<Vector>(values[at_index(i)]); }
    const Exact& scalar(ElementIndex i) const { return std::get<Exact>(values[at_index(i)]); }
    bool is_line(ElementIndex i) const { return std::holds_alternative<ProjectiveLine>(values[at_index(i)]); }
    void put(ElementIndex, Value value) { values.push_back(std::move(value)); }
};

}  // namespace

Evaluation evaluate(const Program& program, const std::vector<Value>& givens, const Pose& pose) {
    Evaluation result;
    result.values.reserve(program.strokes.size());
    ExactMemory memory{result.values};
    Largest<Exact> largest;
    largest.vector[static_cast<std::size_t>(Plane::drawing)] = magnitude_of(pose.size);
    const auto holds = [&](const Guard& guard) {
        const auto now = answer(guard, program.strokes, memory, largest);
        if (guard.how == Guard::How::by_precision && now.is_small(program.doubtful_bits)) return true;
        // On a pose with leftovers, a value as small as these was decided before; that verdict stays.
        if (!pose.exact && !now.is_exact && now.is_small(pose.bits / 2)) return guard.how == Guard::How::by_finer_pose;
        return now.verdict == guard.verdict;
    };
    std::size_t next = 0;
    for (std::size_t i = 0; i <= program.strokes.size(); ++i) {
        for (; next < program.guards.size() && at_index(program.guards[next].before) <= i; ++next) {
            if (holds(program.guards[next])) continue;
            result.flipped = static_cast<int>(next);
            return result;
        }
        if (i == program.strokes.size()) break;
        const Stroke& stroke = program.strokes[i];
        if (stroke.given >= 0) {
            result.values.push_back(givens[at_index(stroke.given)]);
        } else {
            carry_out(stroke, ElementIndex(i), memory);
        }
        std::visit([&](const auto& made) { largest.note(stroke.plane, made); }, result.values.back());
    }
    return result;
}

Value trimmed(const Value& value, int digits) {
    const auto number = [&](const Exact& full) {
        return full.is_zero() ? full : rounded(full, static_cast<int>(digits - magnitude_of(full).order));
    };
    if (const auto* p = std::get_if<ProjectivePoint>(&value))
        return ProjectivePoint{number(p->x), number(p->y), number(p->w)};
    if (const auto* l = std::get_if<ProjectiveLine>(&value))
        return ProjectiveLine{number(l->a), number(l->b), number(l->c)};
    if (const auto* v = std::get_if<Vector>(&value)) return Vector{number(v->x), number(v->y)};
    return number(std::get<Exact>(value));
}

std::vector<Value> trimmed_values(const Program& program, const std::vector<Value>& givens, int digits) {
    std::vector<Value> values;
    values.reserve(program.strokes.size());
    ExactMemory memory{values};
    for (const Stroke& stroke : program.strokes) {
        if (stroke.given >= 0) {
            values.push_back(givens[at_index(stroke.given)]);
        } else {
            carry_out(stroke, ElementIndex(values.size()), memory);
        }
        values.back() = trimmed(values.back(), digits);
    }
    return values;
}

}  // namespace kinegraph
