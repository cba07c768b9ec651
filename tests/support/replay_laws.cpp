#include "tests/support/replay_laws.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "constructions/solving/solve.hpp"
#include "engine/board/replay.hpp"
#include "engine/solution/found_elements.hpp"

namespace kinegraph::tests {
namespace {

std::size_t at(auto index) { return at_index(index); }

std::vector<ElementIndex> results_of(Solution solution) {
    std::vector<ElementIndex> elements;
    for_each_found(solution, [&](ElementIndex& element, auto&) { elements.push_back(element); });
    return elements;
}

/// A value as numbers: three for a point, two for a vector, one for a scalar. A point at infinity has a direction
/// without a length.
std::vector<double> numbers(const ValueOf<double>& value) {
    if (const auto* p = std::get_if<PointOf<double>>(&value)) {
        const double length = p->at_infinity() ? std::hypot(p->x, p->y) : 1;
        return {p->x / length, p->y / length, p->w};
    }
    if (const auto* v = std::get_if<VectorOf<double>>(&value)) return {v->x, v->y};
    if (const auto* s = std::get_if<double>(&value)) return {*s};
    const auto& l = std::get<LineOf<double>>(value);
    return {l.a, l.b, l.c};
}
std::vector<double> replayed(const Replay& replay, ElementIndex element, const Value& like) {
    if (std::holds_alternative<ProjectivePoint>(like)) return numbers(replay.point(element));
    if (std::holds_alternative<Vector>(like)) return numbers(replay.vector(element));
    return numbers(replay.scalar(element));
}

/// The largest number among all elements of a plane, separately for scalars.
class LargestOfKind {
public:
    explicit LargestOfKind(const Protocol& protocol) : protocol_(protocol) {
        for (std::size_t i = 0; i < protocol.values.size(); ++i) {
            if (std::holds_alternative<ProjectiveLine>(protocol.values[i])) continue;
            double& largest = largest_[kind_of(i)];
            for (const double number : numbers(to_double(protocol.values[i])))
                largest = std::max(largest, std::abs(number));
        }
    }
    double of(ElementIndex element) const { return largest_.at(kind_of(at(element))); }

private:
    std::pair<Plane, bool> kind_of(std::size_t i) const {
        return {protocol_.program.strokes[i].plane, std::holds_alternative<Exact>(protocol_.values[i])};
    }
    const Protocol& protocol_;
    std::map<std::pair<Plane, bool>, double> largest_;
};

std::string told(const Guard& guard) {
    static constexpr std::array names{"coincide", "parallel", "zero vector", "zero scalar", "on line",
                                      "sign",     "turn",     "along",       "longer"};
    return std::string(names[static_cast<std::size_t>(guard.question)]) + " " +
           std::to_string(guard.inputs[0].number()) + " " + std::to_string(guard.inputs[1].number()) + ": " +
           std::to_string(guard.verdict);
}

/// Sorts bodies by the order of the file and forces by name. The order of the solution and its points of concurrency
/// depend on the planner; whether a resultant needs a funicular polygon depends on where lines intersect on the sheet.
void put_in_order(Solution& solution) {
    const auto by_name = [](const auto& a, const auto& b) { return name_of(a.symbol) < name_of(b.symbol); };
    const auto put_bodies_in_order = [&](std::vector<FreeBody>& bodies) {
        for (FreeBody& body : bodies) {
            std::sort(body.forces.begin(), body.forces.end(), by_name);
            body.meets.clear();
            body.sums.clear();
            body.funicular.reset();
        }
        std::sort(bodies.begin(), bodies.end(), [](const FreeBody& a, const FreeBody& b) {
            return std::pair(a.body, a.pin) < std::pair(b.body, b.pin);
        });
    };
    put_bodies_in_order(solution.free_bodies);
    if (solution.superposition)
        for (Superposition::Part& part : solution.superposition->parts)
            put_bodies_in_order(part.bodies), part.together.clear();
    solution.taken_together.clear();
    if (!solution.virtual_work) return;
    auto& entries = solution.virtual_work->entries;
    std::sort(entries.begin(), entries.end(), by_name);
    std::stable_sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.body < b.body; });
}

}  // namespace

int idle_strokes(const Solution& solution) {
    const Program& program = solution.protocol.program;
    std::vector<bool> needed(program.strokes.size(), false);
    Protocol drawn = solution.protocol;
    for_each_drawn(drawn, [&](ElementIndex& element) { needed[at(element)] = true; });
    for (const ElementIndex element : results_of(solution)) needed[at(element)] = true;
    for (const Guard& guard : program.guards)
        for (const ElementIndex input : guard.inputs)
            if (input != none) needed[at(input)] = true;
    for (std::size_t i = needed.size(); i-- > 0;)
        for (const ElementIndex input : program.strokes[i].inputs)
            if (input != none && needed[i]) needed[at(input)] = true;
    return static_cast<int>(std::count(needed.begin(), needed.end(), false));
}

void expect_identical_replay(const Solution& solution) {
    const Protocol& protocol = solution.protocol;
    const Program& program = protocol.program;
    EXPECT_EQ(idle_strokes(solution), 0);
    const Evaluation again = evaluate(program, givens_of(program, solution.mechanism, solution.pose), solution.pose);
    ASSERT_FALSE(again.flipped) << told(program.guards[at(*again.flipped)]);
    ASSERT_EQ(again.values.size(), protocol.values.size());
    for (std::size_t i = 0; i < again.values.size(); ++i)
        ASSERT_TRUE(identical(again.values[i], protocol.values[i])) << "element " << i;
}

double difference_in_doubles(const Solution& solution) {
    const Protocol& protocol = solution.protocol;
    Replay replay(protocol.program, givens_of(protocol.program, solution.mechanism, solution.pose),
                  solution.pose.size.to_double());
    if (replay.run()) return std::numeric_limits<double>::infinity();
    const LargestOfKind largest(protocol);
    double worst = 0;
    for (const ElementIndex element : results_of(solution)) {
        const std::vector<double> exact = numbers(to_double(protocol.values[at(element)]));
        const std::vector<double> found = replayed(replay, element, protocol.values[at(element)]);
        for (std::size_t c = 0; c < exact.size(); ++c)
            if (found[c] != exact[c]) worst = std::max(worst, std::abs(found[c] - exact[c]) / largest.of(element));
    }
    return worst;
}

Mechanism with_other_givens(Mechanism mechanism) {
    int n = 0;
    // Different factors, none of which makes two values cancel.
    const auto changed = [&](const Exact& value) { return value * Exact::ratio(7 + 4 * (++n), 5); };
    for (Driver& driver : mechanism.drivers) {
        std::visit(
            [&](auto& given) {
                if constexpr (requires { given.omega; }) {
                    given.omega = changed(given.omega);
                    given.alpha = changed(given.alpha);
                } else {
                    given.speed = changed(given.speed);
                    given.acceleration = changed(given.acceleration);
                }
            },
            driver);
    }
    for (Load& load : mechanism.loads) {
        if (auto* force = std::get_if<ForceLoad>(&load)) {
            if (force->value) force->value = changed(1) * *force->value;
            if (force->magnitude) force->magnitude->first = changed(force->magnitude->first);
        } else if (auto* couple = std::get_if<CoupleLoad>(&load)) {
            couple->value = changed(couple->value);
        } else if (auto* distributed = std::get_if<DistributedLoad>(&load)) {
            const Exact times = changed(1);
            for (Exact& intensity : distributed->intensity) intensity *= times;
        } else if (auto* torsion = std::get_if<TorsionLoad>(&load)) {
            torsion->stiffness = changed(torsion->stiffness);
        } else {
            auto& spring = std::get<SpringLoad>(load);
            spring.magnitude = changed(spring.magnitude);
            if (spring.elastic) spring.elastic->stiffness = changed(spring.elastic->stiffness);
        }
    }
    for (Mass& mass : mechanism.masses) {
        mass.mass = changed(mass.mass);
        mass.inertia = changed(mass.inertia);
    }
    return mechanism;
}

bool expect_fresh_solution(const Solution& solution) {
    const Mechanism other = with_other_givens(solution.mechanism);
    const Program& program = solution.protocol.program;
    const Evaluation replayed = evaluate(program, givens_of(program, other, solution.pose), solution.pose);
    if (replayed.flipped) {
        EXPECT_LT(at(*replayed.flipped), program.guards.size());
        return false;
    }
    const auto fresh = solve(other);
    EXPECT_TRUE(fresh);
    if (!fresh) return true;
    Solution as_replayed = solution, as_solved = *fresh;
    read_values(as_replayed, replayed.values);
    put_in_order(as_replayed);
    put_in_order(as_solved);

    std::vector<Value> exact_one, exact_two;
    for_each_found(as_replayed, [&](ElementIndex&, auto& value) { exact_one.emplace_back(value); });
    for_each_found(as_solved, [&](ElementIndex&, auto& value) { exact_two.emplace_back(value); });
    EXPECT_EQ(exact_one.size(), exact_two.size());
    if (exact_one.size() != exact_two.size()) return true;
    for (std::size_t i = 0; i < exact_one.size(); ++i) {
        if (solution.pose.exact) {
            EXPECT_TRUE(identical(exact_one[i], exact_two[i])) << "result " << i;
            continue;
        }
        // Two orders of the same operations propagate the compass' inexactness differently, far below the precision of
        // a double.
        const auto near = numbers(to_double(exact_one[i])), far = numbers(to_double(exact_two[i]));
        for (std::size_t c = 0; c < near.size(); ++c)
            EXPECT_NEAR(near[c], far[c], 1e-12 * (1 + std::abs(far[c]))) << "result " << i;
    }
    return true;
}

}  // namespace kinegraph::tests
