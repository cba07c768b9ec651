// solve -o OUT.ggb on the command line. What the file says is tested by tests/geogebra.
#include <gtest/gtest.h>

#include <string>

#include "tests/support/command_line.hpp"

namespace kinegraph::tests::geogebra_command_test {
namespace {

using GeoGebraCommand = CommandLine;

std::string example(const std::string& name) { return std::string(KINEGRAPH_EXAMPLES_DIR) + "/" + name; }

TEST_F(GeoGebraCommand, WritesTheSameBytesAgain) {
    EXPECT_EQ(run("solve four_bar.json -o one.ggb").status, 0);
    EXPECT_EQ(run("solve four_bar.json -o two.ggb -o results.json").status, 0);
    const std::string bytes = contents(folder_ / "one.ggb");
    EXPECT_EQ(bytes.substr(0, 4), "PK\x03\x04");
    EXPECT_EQ(bytes, contents(folder_ / "two.ggb"));
    EXPECT_EQ(run("solve four_bar.json --format ggb").out, bytes);
}

TEST_F(GeoGebraCommand, SpeaksTheLanguage) {
    EXPECT_EQ(run("solve four_bar.json -o one.ggb --lang de").status, 0);
    EXPECT_NE(contents(folder_ / "one.ggb").find("Gelenk"), std::string::npos);
}

TEST_F(GeoGebraCommand, SaysThatForcesAreLeftOut) {
    const Outcome outcome = run("solve " + example("four_bar_weights.json") + " -o forces.ggb");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_NE(
        outcome.err.find("remark: the construction for GeoGebra has position, motion and centres; forces are left"),
        std::string::npos)
        << outcome.err;
    EXPECT_EQ(run("solve four_bar.json -o motion.ggb").err, "");
}

TEST_F(GeoGebraCommand, RefusesWhatHasNoConstructionInOneLine) {
    const Snapshot before = snapshot();
    const Outcome elsewhere = run("solve four_bar.json --at 30 -o one.ggb");
    EXPECT_EQ(elsewhere.status, 2);
    EXPECT_TRUE(lines_are(elsewhere.err, "four_bar.json: a construction for GeoGebra begins at .+; leave --at out"))
        << elsewhere.err;
    const Outcome problem = run("solve " + example("contact/ball_on_plane.json") + " -o one.ggb -o results.json");
    EXPECT_EQ(problem.status, 2);
    EXPECT_TRUE(lines_are(problem.err, ".*GeoGebra takes the position and the motion of a mechanism; .+"))
        << problem.err;
    EXPECT_EQ(changed_since(before), "");
}

}  // namespace
}  // namespace kinegraph::tests::geogebra_command_test
