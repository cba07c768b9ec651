// The record of a solution in another position: either one of its verdicts changes, or its speeds are those of a
// solution drawn there. So no step may rest on a coincidence that the record does not have.
#include <gtest/gtest.h>

#include "app/library/driver_choice.hpp"
#include "engine/board/program.hpp"
#include "tests/support/chains.hpp"
#include "tests/support/files.hpp"
#include "tests/support/random_mechanism.hpp"
#include "tests/support/solved.hpp"

namespace kinegraph::record_elsewhere_test {
namespace {

/// Compares the angular velocities of all bodies; false where a verdict changes.
bool holds_elsewhere(const Solution& drawn, const Solution& moved) {
    const Program& program = drawn.protocol.program;
    const Evaluation found = evaluate(program, givens_of(program, moved.mechanism, moved.pose), moved.pose);
    if (found.flipped) return false;
    for (std::size_t body = 0; body < drawn.bodies.size(); ++body) {
        const auto &record = drawn.bodies[body].omega, &fresh = moved.bodies[body].omega;
        if (!record || !fresh || record.element() == none) continue;
        EXPECT_EQ(std::get<Exact>(found.values[at_index(record.element())]), *fresh)
            << drawn.mechanism.bodies[body].name;
    }
    return true;
}

TEST(RecordElsewhere, HasTheSpeedsOfASolutionDrawnThereOrChangesAVerdict) {
    int compared = 0, changed = 0;
    for (const std::string& name : tests::example_names()) {
        SCOPED_TRACE(name);
        const Solution& drawn = tests::example(name);
        for (const char* at : {"2°", "-3°", "1 mm"}) {
            const auto moved = app::solved_positions(drawn.mechanism, {.at = {at}}, Arithmetic::left_out);
            if (moved) ++(holds_elsewhere(drawn, moved->front()) ? compared : changed);
        }
    }
    EXPECT_GT(compared, 30);
    EXPECT_GT(changed, 5);
}

TEST(RecordElsewhere, OfRandomChainsLikewise) {
    int compared = 0, changed = 0;
    for (int seed = 0; seed < unless_sanitized(300, 60); ++seed) {
        const ChainMechanism chain = random_chain_mechanism(static_cast<std::uint64_t>(seed));
        SCOPED_TRACE(chain.recipe);
        const Solution drawn = tests::solved(chain.text);
        const auto moved = app::solved_positions(drawn.mechanism, {.at = {"1°"}}, Arithmetic::left_out);
        if (moved) ++(holds_elsewhere(drawn, moved->front()) ? compared : changed);
    }
    EXPECT_GT(compared, unless_sanitized(30, 5));
}

}  // namespace
}  // namespace kinegraph::record_elsewhere_test
