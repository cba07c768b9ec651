// The time to solve, from the text of a file to the Solution, and of each part: kinematics, centres, the check,
// reading. Measured within the process; docs/performance.md measures whole commands.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <variant>

#include "constructions/positions/cycle.hpp"
#include "constructions/solving/solve.hpp"
#include "engine/board/replay.hpp"
#include "engine/check/check.hpp"
#include "engine/drawing/pose.hpp"
#include "engine/motion/mobility.hpp"
#include "tests/support/four_bars_in_a_row.hpp"

namespace {

using namespace kinegraph;
using kinegraph::tests::at;
using kinegraph::tests::four_bars_in_a_row;
using kinegraph::tests::jitter;

std::string example(const std::string& name) {
    std::ifstream file(std::string(KINEGRAPH_EXAMPLES_DIR) + "/" + name + ".json");
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

std::string number(int value) { return std::to_string(value); }
/// A file of about so many megabytes, of points carried by one crank: the size limit of an input file.
std::string large_file(std::size_t megabytes) {
    std::string points = "\"O\": [0, 0]", carried = "\"O\"";
    for (int i = 1; points.size() + carried.size() < megabytes * 1'000'000 - 1000; ++i) {
        points += ",\n\"P" + number(i) + "\": " + at(jitter(i, 5000), jitter(3 * i, 5000));
        carried += ", \"P" + number(i) + "\"";
    }
    return "{\"kinegraph\": 1, \"frame\": 1, \"points\": {" + points + "},\n\"bodies\": {\"2\": [" + carried +
           "]},\n\"joints\": [{\"revolute\": \"O\", \"bodies\": [1, 2]}], \"drivers\": [{\"body\": 2, \"omega\": 1}]}";
}

Mechanism read(const std::string& text) {
    auto mechanism = read_mechanism(text, "benchmark");
    if (!mechanism)
        throw std::runtime_error(mechanism.error().front().where + ": " +
                                 mechanism.error().front().message.in(Language::en));
    return *std::move(mechanism);
}

std::size_t most_bits(const Solution& solution) {
    std::size_t bits = 0;
    for (const Value& value : solution.protocol.values) {
        if (const auto* point = std::get_if<ProjectivePoint>(&value))
            bits = std::max({bits, point->x.bits(), point->y.bits()});
    }
    return bits;
}

void solve_text(benchmark::State& state, const std::string& text) {
    const Mechanism mechanism = read(text);
    for (auto _ : state) {
        auto solution = solve(mechanism);
        if (!solution || !solution->unsolved.empty()) return state.SkipWithError("not solved");
        benchmark::DoNotOptimize(solution);
    }
    const auto solution = solve(mechanism);
    state.counters["bodies"] = static_cast<double>(mechanism.bodies.size());
    state.counters["centres"] = static_cast<double>(solution->centres.size());
    state.counters["strokes"] = static_cast<double>(solution->protocol.program.strokes.size());
    state.counters["bits"] = static_cast<double>(most_bits(*solution));
}

/// Replays the program of a mechanism, reduced to some of its results, in doubles, with its givens and guards.
void replay(benchmark::State& state, const std::string& text, bool with_forces) {
    Solution solution = *solve(read(text));
    std::vector<ElementIndex> wanted;
    const auto want = [&](const auto& found) {
        if (found.element() != none) wanted.push_back(found.element());
    };
    for (const PointMotion& point : solution.points) {
        want(point.velocity);
        want(point.acceleration);
    }
    for (const BodyMotion& body : solution.bodies) {
        want(body.omega);
        want(body.alpha);
    }
    if (with_forces) {
        for (const JointForce& force : solution.forces) {
            want(force.force);
            want(force.couple);
        }
        for (const EffortValue& effort : solution.efforts) want(effort.value);
    }
    const Cut record =
        cut(solution.protocol.program, wanted, with_forces ? solution.settled.forces : solution.settled.accelerations);
    Replay replay(record.program, givens_of(record.program, solution.mechanism, solution.pose),
                  solution.pose.size.to_double());
    for (auto _ : state) {
        if (replay.run()) return state.SkipWithError("a guard flipped");
        benchmark::ClobberMemory();
    }
    state.counters["strokes"] = static_cast<double>(replay.strokes());
    state.counters["guards"] = static_cast<double>(record.program.guards.size());
}
void BM_ReplayFourBar(benchmark::State& state) { replay(state, example("four_bar"), false); }
BENCHMARK(BM_ReplayFourBar);
void BM_ReplayWattSixBar(benchmark::State& state) { replay(state, example("watt_six_bar"), false); }
BENCHMARK(BM_ReplayWattSixBar);
void BM_ReplayExamWithForces(benchmark::State& state) { replay(state, example("exam_2001"), true); }
BENCHMARK(BM_ReplayExamWithForces);

/// A row of a cycle: closes the joints by Newton's method and replays the program, without the check. `with_values`
/// false: Newton's method only.
void cycle(benchmark::State& state, const std::string& text, bool with_values) {
    const Mechanism mechanism = read(text);
    const Pose pose = *draw_pose(mechanism);
    auto cycle = *Cycle::of(mechanism, pose, 0);
    const Travel travel = *travel_of(cycle.positions(), true, {}, {});
    cycle.begin(travel, false);
    Positions positions = cycle.positions();
    int i = 0;
    double longest = 0;
    for (auto _ : state) {
        const double coordinate = travel.from + (travel.to - travel.from) * (i++ % 360) / 360;
        if (with_values) {
            const auto row = cycle.row(coordinate);
            if (row) longest = std::max(longest, row->back());
        } else if (!positions.move_to(coordinate)) {
            return state.SkipWithError("out of reach");
        }
        benchmark::DoNotOptimize(longest);
    }
    state.counters["plans"] = cycle.plans();
}
void BM_PositionFourBar(benchmark::State& state) { cycle(state, example("four_bar"), false); }
BENCHMARK(BM_PositionFourBar);
void BM_CycleFourBar(benchmark::State& state) { cycle(state, example("four_bar"), true); }
BENCHMARK(BM_CycleFourBar);
void BM_PositionJansen(benchmark::State& state) { cycle(state, example("jansen_leg"), false); }
BENCHMARK(BM_PositionJansen);
void BM_CycleJansen(benchmark::State& state) { cycle(state, example("jansen_leg"), true); }
BENCHMARK(BM_CycleJansen);

/// Pose, mobility, all centres, both polygons, the numeric solution and the check.
void BM_FourBar(benchmark::State& state) { solve_text(state, example("four_bar")); }
BENCHMARK(BM_FourBar)->Unit(benchmark::kMicrosecond);
void BM_FourBarByDecimals(benchmark::State& state) { solve_text(state, four_bars_in_a_row(1)); }
BENCHMARK(BM_FourBarByDecimals)->Unit(benchmark::kMicrosecond);
void BM_WattSixBar(benchmark::State& state) { solve_text(state, example("watt_six_bar")); }
BENCHMARK(BM_WattSixBar)->Unit(benchmark::kMicrosecond);
void BM_QuickReturn(benchmark::State& state) { solve_text(state, example("quick_return")); }
BENCHMARK(BM_QuickReturn)->Unit(benchmark::kMicrosecond);

/// Velocities and accelerations of 2 + 2·dyads bodies, with the check; 49 dyads give 100 bodies.
void BM_ChainMotion(benchmark::State& state) {
    solve_text(state, four_bars_in_a_row(static_cast<int>(state.range(0)), R"(["velocity", "acceleration"])"));
}
BENCHMARK(BM_ChainMotion)->Arg(10)->Arg(25)->Arg(49)->Arg(50)->Unit(benchmark::kMillisecond);

void BM_ChainMotionByCompass(benchmark::State& state) {
    solve_text(state, four_bars_in_a_row(static_cast<int>(state.range(0)), R"(["velocity", "acceleration"])", true));
}
BENCHMARK(BM_ChainMotionByCompass)->Arg(10)->Arg(49)->Unit(benchmark::kMillisecond);

/// Twelve bodies: pose, mobility and all 66 centres by the Aronhold–Kennedy theorem.
void BM_TwelveBodiesCentres(benchmark::State& state) {
    solve_text(state, four_bars_in_a_row(5, R"(["instant centres"])"));
}
BENCHMARK(BM_TwelveBodiesCentres)->Unit(benchmark::kMicrosecond);
void BM_TwelveBodiesCentresByCompass(benchmark::State& state) {
    solve_text(state, four_bars_in_a_row(5, R"(["instant centres"])", true));
}
BENCHMARK(BM_TwelveBodiesCentresByCompass)->Unit(benchmark::kMicrosecond);
void BM_TwelveBodiesAll(benchmark::State& state) { solve_text(state, four_bars_in_a_row(5)); }
BENCHMARK(BM_TwelveBodiesAll)->Unit(benchmark::kMicrosecond);

// --- the parts ---
void BM_FourBarPose(benchmark::State& state) {
    const Mechanism mechanism = read(example("four_bar"));
    for (auto _ : state) benchmark::DoNotOptimize(draw_pose(mechanism));
}
BENCHMARK(BM_FourBarPose)->Unit(benchmark::kMicrosecond);

void BM_ChainMobility(benchmark::State& state) {
    const Mechanism mechanism = read(four_bars_in_a_row(static_cast<int>(state.range(0))));
    const auto pose = draw_pose(mechanism);
    for (auto _ : state) benchmark::DoNotOptimize(mobility_of(mechanism, *pose));
}
BENCHMARK(BM_ChainMobility)->Arg(1)->Arg(5)->Arg(49)->Unit(benchmark::kMicrosecond);

void BM_ChainCheck(benchmark::State& state) {
    const Mechanism mechanism = read(four_bars_in_a_row(static_cast<int>(state.range(0))));
    const auto pose = draw_pose(mechanism);
    for (auto _ : state) benchmark::DoNotOptimize(check_motion(mechanism, *pose));
}
BENCHMARK(BM_ChainCheck)->Arg(1)->Arg(5)->Arg(49)->Unit(benchmark::kMicrosecond);

// --- reading ---
void read_text(benchmark::State& state, const std::string& text) {
    for (auto _ : state) {
        auto mechanism = read_mechanism(text, "benchmark");
        if (!mechanism) return state.SkipWithError("not read");
        benchmark::DoNotOptimize(mechanism);
    }
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(text.size()));
}

void BM_ReadFourBar(benchmark::State& state) { read_text(state, example("four_bar")); }
BENCHMARK(BM_ReadFourBar)->Unit(benchmark::kMicrosecond);
void BM_ReadHundredBodies(benchmark::State& state) { read_text(state, four_bars_in_a_row(49)); }
BENCHMARK(BM_ReadHundredBodies)->Unit(benchmark::kMillisecond);
void BM_ReadTenMegabytes(benchmark::State& state) { read_text(state, large_file(10)); }
BENCHMARK(BM_ReadTenMegabytes)->Unit(benchmark::kMillisecond);

}  // namespace
