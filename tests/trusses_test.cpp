// Trusses: recognised by their structure, resolved pin by pin and by cuts; every bar force against a linear solve of this file's
// own, exactly. Published and closed-form numbers of the examples.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "engine/truss.hpp"
#include "tests/random_mechanism.hpp"
#include "tests/solved.hpp"

namespace kinegraph {
namespace {

using tests::example;
using tests::solved;

std::size_t at(auto index) { return at_index(index); }

double force_in(const Solution& solution, const std::string& bar) {
    const int index = solution.truss->structure.bar_named(solution.mechanism, bar);
    return solution.truss->tension(at(index), solution.pose.points);
}

/// Solves A x = b exactly, by columns with a pivot that is not zero; empty where there is none.
std::vector<Exact> linear_solve(std::vector<std::vector<Exact>> a, std::vector<Exact> b) {
    const std::size_t n = b.size();
    for (std::size_t c = 0; c < n; ++c) {
        std::size_t pivot = c;
        while (pivot < n && a[pivot][c].is_zero()) ++pivot;
        if (pivot == n) return {};
        std::swap(a[c], a[pivot]);
        std::swap(b[c], b[pivot]);
        for (std::size_t r = 0; r < n; ++r) {
            if (r == c || a[r][c].is_zero()) continue;
            const Exact share = a[r][c] / a[c][c];
            for (std::size_t k = c; k < n; ++k) a[r][k] = a[r][k] - share * a[c][k];
            b[r] = b[r] - share * b[c];
        }
    }
    std::vector<Exact> x;
    for (std::size_t c = 0; c < n; ++c) x.push_back(b[c] / a[c][c]);
    return x;
}

/// Forces over lengths, by equilibrium of all pins in one system; empty where it is singular.
std::vector<Exact> densities(const Solution& solution, const TrussStructure& truss) {
    const Mechanism& mechanism = solution.mechanism;
    const std::size_t unknowns = 2 * truss.pins.size();
    std::vector<std::vector<Exact>> a(unknowns, std::vector<Exact>(unknowns));
    std::vector<Exact> b(unknowns);
    std::size_t column = 0;
    const auto enter = [&](std::size_t pin, const Vector& unit) {
        a[2 * pin][column] = unit.x;
        a[2 * pin + 1][column] = unit.y;
    };
    for (const TrussStructure::Bar& bar : truss.bars) {
        const Vector along = solution.pose.at(truss.pins[at(bar.pins[1])].point) - solution.pose.at(truss.pins[at(bar.pins[0])].point);
        enter(at(bar.pins[0]), along);
        enter(at(bar.pins[1]), Vector{} - along);
        ++column;
    }
    for (std::size_t pin = 0; pin < truss.pins.size(); ++pin) {
        for (const JointIndex support : truss.pins[pin].supports) {
            enter(pin, solution.pose.normals[at(support)]);
            ++column;
        }
        if (truss.pins[pin].hinges.empty()) continue;
        for (const Vector& unit : {Vector{1, 0}, Vector{0, 1}}) {
            enter(pin, unit);
            ++column;
        }
    }
    for (const Load& load : mechanism.loads) {
        const auto& force = std::get<ForceLoad>(load);
        for (std::size_t pin = 0; pin < truss.pins.size(); ++pin)
            if (truss.pins[pin].point == force.at) {
                b[2 * pin] = b[2 * pin] - force.value->x;
                b[2 * pin + 1] = b[2 * pin + 1] - force.value->y;
            }
    }
    return linear_solve(std::move(a), std::move(b));
}

void expect_as_linear_solve(const Solution& solution, const std::string& text) {
    ASSERT_TRUE(solution.truss) << text;
    const Truss& truss = *solution.truss;
    const std::vector<Exact> expected = densities(solution, truss.structure);
    ASSERT_FALSE(expected.empty()) << text;
    for (std::size_t bar = 0; bar < truss.bars.size(); ++bar) {
        const auto& ends = truss.structure.bars[bar].pins;
        const Vector along = solution.pose.at(truss.structure.pins[at(ends[1])].point) - solution.pose.at(truss.structure.pins[at(ends[0])].point);
        ASSERT_TRUE(truss.bars[bar].force) << text;
        EXPECT_EQ(*truss.bars[bar].force, expected[bar] * along) << truss.structure.bars[bar].name << "\n" << text;
    }
}

/// A simple truss: every further pin on two bars. Loaded at pins, and on pins of bars.
class RandomTruss {
public:
    explicit RandomTruss(std::uint64_t seed, int pins) : random_(seed) {
        place(0, 0);
        place(random_.whole(3, 6), random_.whole(0, 2));
        bar(0, 1);
        while (static_cast<int>(places_.size()) < pins) grow();
        support();
        load();
    }
    std::string text() const {
        std::string points, bodies, joints, loads;
        const auto add = [](std::string& list, const std::string& member) { list += (list.empty() ? "" : ", ") + member; };
        for (std::size_t p = 0; p < places_.size(); ++p)
            add(points, quoted(name(p)) + ": [" + std::to_string(places_[p].first) + ", " + std::to_string(places_[p].second) + "]");
        std::vector<std::string> at_pin(places_.size());
        for (std::size_t b = 0; b < bars_.size(); ++b) {
            const std::string body = std::to_string(b + 2);
            add(bodies, quoted(body) + ": [" + quoted(name(bars_[b].first)) + ", " + quoted(name(bars_[b].second)) + "]");
            for (const std::size_t end : {bars_[b].first, bars_[b].second}) add(at_pin[end], body);
        }
        at_pin[0] = "1, " + at_pin[0];
        for (std::size_t p = 0; p < places_.size(); ++p)
            add(joints, "{\"revolute\": " + quoted(name(p)) + ", \"bodies\": [" + at_pin[p] + "]}");
        add(joints, roller_);
        for (const std::string& each : loads_) add(loads, each);
        return "{\"kinegraph\": 1, \"frame\": 1, \"points\": {" + points + "}, \"bodies\": {" + bodies + "}, \"joints\": [" + joints +
               "], \"loads\": [" + loads + "]}";
    }

private:
    static std::string quoted(const std::string& text) { return "\"" + text + "\""; }
    static std::string name(std::size_t pin) { return "P" + std::to_string(pin); }
    void place(int x, int y) { places_.emplace_back(x, y); }
    void bar(std::size_t from, std::size_t to) { bars_.emplace_back(from, to); }
    bool in_line(std::pair<int, int> a, std::pair<int, int> b, std::pair<int, int> c) const {
        return (b.first - a.first) * (c.second - a.second) == (b.second - a.second) * (c.first - a.first);
    }
    void grow() {
        const auto first = static_cast<std::size_t>(random_.whole(0, static_cast<int>(bars_.size()) - 1));
        const auto [a, b] = bars_[first];
        const std::pair<int, int> spot{random_.whole(-12, 12), random_.whole(-12, 12)};
        if (in_line(places_[a], places_[b], spot) || std::find(places_.begin(), places_.end(), spot) != places_.end()) return;
        places_.push_back(spot);
        bar(a, places_.size() - 1);
        bar(b, places_.size() - 1);
    }
    /// A roller: the normal of its slot has a lever about the hinge at the origin.
    void support() {
        for (;;) {
            const auto pin = static_cast<std::size_t>(random_.whole(1, static_cast<int>(places_.size()) - 1));
            const int x = random_.whole(-3, 3), y = random_.whole(-3, 3);
            if ((x == 0 && y == 0) || places_[pin].first * x + places_[pin].second * y == 0) continue;
            const auto held = std::find_if(bars_.begin(), bars_.end(), [&](const auto& each) { return each.first == pin || each.second == pin; });
            roller_ = "{\"pin-slot\": " + quoted(name(pin)) + ", \"bodies\": [" + std::to_string(held - bars_.begin() + 2) +
                      ", 1], \"along\": [" + std::to_string(x) + ", " + std::to_string(y) + "]}";
            return;
        }
    }
    void load() {
        for (std::size_t pin = 1; pin < places_.size(); ++pin) {
            if (!loads_.empty() && random_.chance(50)) continue;
            const std::string value = "[" + std::to_string(random_.whole(-9, 9)) + ", " + std::to_string(random_.whole(-9, 9) * 2 + 1) + "]";
            const auto held = std::find_if(bars_.begin(), bars_.end(), [&](const auto& each) { return each.first == pin || each.second == pin; });
            const std::string on = random_.chance(30) ? "\"body\": " + std::to_string(held - bars_.begin() + 2) + ", \"at\": " + quoted(name(pin))
                                                      : "\"pin\": " + quoted(name(pin));
            loads_.push_back("{\"force\": \"F" + std::to_string(pin) + "\", " + on + ", \"value\": " + value + "}");
        }
    }

    Random random_;
    std::vector<std::pair<int, int>> places_;
    std::vector<std::pair<std::size_t, std::size_t>> bars_;
    std::string roller_;
    std::vector<std::string> loads_;
};

TEST(RandomTrusses, AreTheLinearSolveExactly) {
    const int count = unless_sanitized(60, 8);
    int plans = 0;
    for (int i = 0; i < count; ++i) {
        const std::string text = RandomTruss(static_cast<std::uint64_t>(i) + 1, 3 + i % 14).text();
        const Solution solution = solved(text);
        if (solution.mobility.effective != 0) continue;
        expect_as_linear_solve(solution, text);
        EXPECT_TRUE(solution.unsolved.empty()) << text;
        plans += solution.truss->polygon >= 0;
        // The check has every bar.
        const auto rows = std::count_if(solution.checks.begin(), solution.checks.end(),
                                        [](const CheckRow& row) { return row.quantity.kind == Quantity::Kind::bar; });
        EXPECT_EQ(static_cast<std::size_t>(rows), solution.truss->bars.size());
    }
    EXPECT_GT(plans, count / 6);
}

}  // namespace
}  // namespace kinegraph
