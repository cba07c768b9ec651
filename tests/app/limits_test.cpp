// The limits that docs/file_faults.md lists: one line with the limit and a remedy, status 2, and nothing written. One
// body less is solved.
#include <nlohmann/json.hpp>

#include <fstream>

#include "app/library/limits.hpp"
#include "render/sheet/sheet_limits.hpp"
#include "tests/support/command_line.hpp"

namespace kinegraph::tests::limits_test {
namespace {

using Json = nlohmann::ordered_json;

class Limits : public CommandLine {
protected:
    /// A chain of that many bodies, the frame included, each link driven.
    void write_chain(std::size_t bodies, const Json& find = nullptr) const {
        Json file{{"kinegraph", 1}, {"frame", "0"}, {"points", {{"P0", {0, 0}}}}};
        for (std::size_t i = 1; i < bodies; ++i) {
            const std::string link = std::to_string(i), from = "P" + std::to_string(i - 1), to = "P" + link;
            file["points"][to] = {i, i % 3};
            file["bodies"][link] = {from, to};
            file["joints"].push_back({{"revolute", from}, {"bodies", {std::to_string(i - 1), link}}});
            file["drivers"].push_back({{"body", link}, {"omega", 1}});
        }
        if (!find.is_null()) file["find"] = find;
        std::ofstream(folder_ / "chain.json") << file;
    }
    void expect_refused(const std::string& command, const std::string& place) const {
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.status, 2) << outcome.err;
        EXPECT_TRUE(lines_are(outcome.err, "(chain\\.json|kinegraph): " + place + ".*")) << outcome.err;
        EXPECT_FALSE(std::filesystem::exists(folder_ / "out.csv")) << "half written";
        EXPECT_FALSE(std::filesystem::exists(folder_ / "out.svg")) << "half written";
    }
};

TEST_F(Limits, OfBodiesAndOfInstantCentres) {
    write_chain(app::most_bodies + 1, {"velocity"});
    expect_refused("solve chain.json -o out.svg", "/bodies: 301 bodies; at most 300 are solved in one file");
    write_chain(app::most_bodies, {"velocity"});
    EXPECT_EQ(run("solve chain.json -o out.json").status, 0);
    write_chain(app::most_bodies_with_centres + 1);
    expect_refused("solve chain.json -o out.svg", "/find: 251 bodies have 31375 instant centres");
    expect_refused("solve chain.json --at 10° -o out.svg", "/find: 251 bodies have 31375 instant centres");
}

TEST_F(Limits, OfASweep) {
    write_chain(app::most_swept_bodies + 1);
    expect_refused("sweep chain.json -o out.csv", "a sweep moves at most 40 bodies, and this file has 41");
    write_chain(app::most_swept_bodies, {"velocity"});
    EXPECT_EQ(run("sweep chain.json --steps 2 -o out.csv").status, 0);
}

TEST_F(Limits, OfTheWayOfADriverWithALaw) {
    const auto swung = [&](const std::string& turn) {
        std::string text = contents(example_file("slider_crank_law"));
        for (std::size_t at; (at = text.find("90°")) != std::string::npos;) text.replace(at, 4, turn);
        std::ofstream(folder_ / "chain.json") << text;
    };
    swung("9e7°");
    expect_refused("sweep chain.json -o out.csv", ".*° is too far to move driver 2 step by step; at most 1000 turns");
    EXPECT_EQ(run("solve chain.json -o out.html").status, 0) << "one position is drawn";
}

// Work is counted in bits of the numbers, so a refusal is the same on every machine.
TEST_F(Limits, OfPositionsThatNeedExactNumbers) {
    const auto turned = [&](const std::string& omega) {
        Json file = Json::parse(contents(example_file("four_bar_inertia")));
        file["drivers"][0]["omega"] = "=" + omega;
        std::ofstream(folder_ / "chain.json") << file;
    };
    turned("1e-60");
    const std::string between = "quantities differ so much in size that what is between the rows needs more than 500 ";
    expect_refused("sweep chain.json -o out.csv", between);
    expect_refused("sweep chain.json -o out.svg --steps 4", between);
    // A far origin is no such difference.
    Json far = Json::parse(contents(example_file("slider_crank_long_crank")));
    far["points"]["O"] = {1e61, 0};
    std::ofstream(folder_ / "chain.json") << far;
    EXPECT_EQ(run("sweep chain.json -o out.csv --steps 6").status, 0);
    std::filesystem::remove(folder_ / "out.csv");
    // Fewer rows are named as the remedy where they are one.
    turned("5e-6");
    expect_refused("sweep chain.json -o out.csv", "quantities differ so much in size .* take fewer --steps");
    EXPECT_EQ(run("sweep chain.json --steps 24 -o out.csv").status, 0);
    turned("1e-3");
    EXPECT_EQ(run("sweep chain.json -o out.csv").status, 0);
}

TEST_F(Limits, OfASweepOverAParameter) {
    std::ofstream(folder_ / "chain.json") << contents(example_file("variants/four_bar"));
    const std::string over = "sweep chain.json --over r --from \"35 mm\" --to \"60 mm\" -o out.csv ";
    expect_refused(over + "--steps 20000",
                   "--over: 20001 values take more work .* some [12][0-9]{3} values of this file");
    expect_refused(over + "--step \"0.001 mm\"", "--over: 25001 values .* fewer --steps");
    EXPECT_EQ(run(over).status, 0);
    // A speed of a thousand digits, in every value.
    Json file = Json::parse(contents(example_file("variants/four_bar")));
    file["parameters"]["n"] = "1." + std::string(990, '3') + " rpm";
    std::ofstream(folder_ / "chain.json") << file;
    std::filesystem::remove(folder_ / "out.csv");
    expect_refused(over + "--steps 3700", "--over: 3701 values take more work .* some 1?[0-9]{3} values");
    // The work follows what is solved: instant centres grow with the square of the bodies.
    for (const auto& [bodies, steps] : {std::pair(41, 360), {100, 60}, {160, 20}}) {
        write_chain(static_cast<std::size_t>(bodies));
        std::ifstream in(folder_ / "chain.json");
        Json chain = Json::parse(in);
        chain["parameters"]["r"] = 1;
        chain["points"]["P1"][0] = "= r";
        std::ofstream(folder_ / "chain.json") << chain;
        const std::string ends = "sweep chain.json --over r --from 1 --to 3 -o out.csv --steps ";
        expect_refused(ends + std::to_string(steps), "--over: .* values take more work than one sweep does");
        EXPECT_EQ(run(ends + "2").status, 0) << bodies;
        std::filesystem::remove(folder_ / "out.csv");
    }
}

TEST_F(Limits, OfSheetsAndSteps) {
    write_chain(render::most_drawn_bodies + 1, {"velocity"});
    expect_refused("solve chain.json -o out.svg", "/find: a drawing has at most 250 bodies");
    // 24 bodies have 276 instant centres, with a sentence each.
    write_chain(24);
    expect_refused("solve chain.json --steps -o out.svg", "/find: the steps of this solution would take");
    EXPECT_EQ(run("solve chain.json --sheet question -o out.svg").status, 0);
}

}  // namespace
}  // namespace kinegraph::tests::limits_test
