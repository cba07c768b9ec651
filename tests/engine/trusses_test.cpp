// Trusses: recognised by their structure, resolved pin by pin and by cuts; every bar force against a linear solve of
// this file's own, exactly. Published and closed-form numbers of the examples.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/solution/solution.hpp"
#include "lang/keys/sentences.hpp"
#include "tests/support/files.hpp"
#include "tests/support/random_mechanism.hpp"
#include "tests/support/solved.hpp"

namespace kinegraph::trusses_test {
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
        const Vector along =
            solution.pose.at(truss.pins[at(bar.pins[1])].point) - solution.pose.at(truss.pins[at(bar.pins[0])].point);
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
        const Vector along = solution.pose.at(truss.structure.pins[at(ends[1])].point) -
                             solution.pose.at(truss.structure.pins[at(ends[0])].point);
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
        const auto add = [](std::string& list, const std::string& member) {
            list += (list.empty() ? "" : ", ") + member;
        };
        for (std::size_t p = 0; p < places_.size(); ++p)
            add(points, quoted(name(p)) + ": [" + std::to_string(places_[p].first) + ", " +
                            std::to_string(places_[p].second) + "]");
        std::vector<std::string> at_pin(places_.size());
        for (std::size_t b = 0; b < bars_.size(); ++b) {
            const std::string body = std::to_string(b + 2);
            add(bodies,
                quoted(body) + ": [" + quoted(name(bars_[b].first)) + ", " + quoted(name(bars_[b].second)) + "]");
            for (const std::size_t end : {bars_[b].first, bars_[b].second}) add(at_pin[end], body);
        }
        at_pin[0] = "1, " + at_pin[0];
        for (std::size_t p = 0; p < places_.size(); ++p)
            add(joints, "{\"revolute\": " + quoted(name(p)) + ", \"bodies\": [" + at_pin[p] + "]}");
        add(joints, roller_);
        for (const std::string& each : loads_) add(loads, each);
        return "{\"kinegraph\": 1, \"frame\": 1, \"points\": {" + points + "}, \"bodies\": {" + bodies +
               "}, \"joints\": [" + joints + "], \"loads\": [" + loads + "]}";
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
        if (in_line(places_[a], places_[b], spot) || std::find(places_.begin(), places_.end(), spot) != places_.end())
            return;
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
            const auto held = std::find_if(bars_.begin(), bars_.end(),
                                           [&](const auto& each) { return each.first == pin || each.second == pin; });
            roller_ = "{\"pin-slot\": " + quoted(name(pin)) + ", \"bodies\": [" +
                      std::to_string(held - bars_.begin() + 2) + ", 1], \"along\": [" + std::to_string(x) + ", " +
                      std::to_string(y) + "]}";
            return;
        }
    }
    void load() {
        for (std::size_t pin = 1; pin < places_.size(); ++pin) {
            if (!loads_.empty() && random_.chance(50)) continue;
            const std::string value =
                "[" + std::to_string(random_.whole(-9, 9)) + ", " + std::to_string(random_.whole(-9, 9) * 2 + 1) + "]";
            const auto held = std::find_if(bars_.begin(), bars_.end(),
                                           [&](const auto& each) { return each.first == pin || each.second == pin; });
            const std::string on = random_.chance(30) ? "\"body\": " + std::to_string(held - bars_.begin() + 2) +
                                                            ", \"at\": " + quoted(name(pin))
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

TEST(Trusses, TheSimpleOneHasItsForces) {
    // 12 kN and 6 kN at the thirds of 12 m: A = 10 kN, D = 8 kN; panels 4 m wide and 3 m high. Moments about C: EF =
    // −32/3 kN.
    const Solution& solution = example("truss_simple");
    ASSERT_TRUE(solution.truss);
    const std::map<std::string, double> expected{{"AB", 40000.0 / 3}, {"AE", -50000.0 / 3}, {"BE", 12000},
                                                 {"BC", 40000.0 / 3}, {"CE", -10000.0 / 3}, {"EF", -32000.0 / 3},
                                                 {"CF", 8000},        {"CD", 32000.0 / 3},  {"DF", -40000.0 / 3}};
    for (const auto& [bar, force] : expected) EXPECT_NEAR(force_in(solution, bar), force, 1e-6) << bar;
}

TEST(Trusses, ARoofUnderWindOnAnInclinedRollerHasItsForces) {
    // W = 10 kN normal to the slope through B; the roller's line (3, 4)/5: 12.8 R = 50.
    const Solution& solution = example("truss_roof_wind");
    ASSERT_TRUE(solution.truss);
    const std::map<std::string, double> expected{{"AB", -115.0 / 24}, {"BC", -10.0 / 3},   {"CD", -125.0 / 24},
                                                 {"DE", -125.0 / 24}, {"AG", 1025.0 / 96}, {"EG", 625.0 / 96},
                                                 {"BG", -125.0 / 24}, {"CG", 3.125},       {"DG", 0}};
    for (const auto& [bar, force] : expected) EXPECT_NEAR(force_in(solution, bar), 1000 * force, 1e-6) << bar;
    for (const Truss::External& external : solution.truss->externals)
        if (external.joint != none && solution.mechanism.joint(external.joint).name == "E") {
            EXPECT_EQ(*external.force, (Vector{Exact::ratio(9375, 4), Exact(3125)}));
        }
    EXPECT_TRUE(solution.truss->bars[at(solution.truss->structure.bar_named(solution.mechanism, "GD"))].idle_by_rule);
    EXPECT_TRUE(solution.free_bodies.empty()) << "its bars are not cut free one by one";
}

/// The simple truss with a body of its own at D, in a guide along the ground through `at`.
Solution simple_on_roller_body(const std::string& at) {
    std::string text = tests::contents(tests::example_file("truss_simple"));
    const auto replace = [&](const std::string& from, const std::string& to) {
        const std::size_t place = text.find(from);
        ASSERT_NE(place, std::string::npos) << from;
        text.replace(place, from.size(), to);
    };
    replace(R"("10": ["C", "F"])", R"("10": ["C", "F"], "11": {"points": ["D"]})");
    replace(R"("bodies": [4, 7]})", R"("bodies": [4, 7, 11]})");
    replace(R"({"contact": "D", "bodies": [4, 1], "tangent": 0, "pushes": [0, 1]})",
            R"({"prismatic": ")" + at + R"(", "bodies": [11, 1], "along": 0, "name": "roller"})");
    replace(R"(, {"cut": ["BC", "CE", "EF"]})", "");
    return solved(text);
}

TEST(Trusses, TheRollerMayBeABodyInAGuide) {
    const Solution contact = example("truss_simple"), roller = simple_on_roller_body("D");
    ASSERT_TRUE(roller.truss);
    EXPECT_TRUE(roller.unsolved.empty());
    EXPECT_TRUE(roller.free_bodies.empty());
    ASSERT_EQ(roller.truss->bars.size(), contact.truss->bars.size());
    for (std::size_t bar = 0; bar < contact.truss->bars.size(); ++bar)
        EXPECT_EQ(*roller.truss->bars[bar].force, *contact.truss->bars[bar].force)
            << contact.truss->structure.bars[bar].name;
    // Where the guide is not at the hinge, it could bear a couple.
    EXPECT_FALSE(simple_on_roller_body("C").truss);
}

bool says(const Solution& solution, Key sentence) {
    return std::any_of(solution.protocol.statements.begin(), solution.protocol.statements.end(),
                       [&](const Statement& statement) { return statement.message.sentence == sentence; });
}

TEST(Trusses, ThePlanHasEveryBarOnceAndItsCornersClose) {
    for (const char* const name : {"truss_simple", "truss_roof_wind"}) {
        const Solution& solution = example(name);
        const Truss& truss = *solution.truss;
        ASSERT_GE(truss.polygon, 0);
        ASSERT_FALSE(truss.bars.empty());
        ASSERT_FALSE(truss.externals.empty());
        std::map<BodyIndex, int> sides;
        for (const int v : solution.protocol.polygons[at(truss.polygon)].vectors) {
            const DrawnVector& side = solution.protocol.vectors[at(v)];
            if (side.quantity.kind == Quantity::Kind::bar) ++sides[side.quantity.body];
        }
        // Every pin closes in the corners of the spaces round it: its bars' sides and outer forces are differences of
        // corners.
        for (std::size_t bar = 0; bar < truss.bars.size(); ++bar) {
            EXPECT_EQ(sides[truss.structure.bars[bar].body], truss.bars[bar].force->is_zero() ? 0 : 1);
            EXPECT_NE(truss.bars[bar].left, truss.bars[bar].right);
        }
        for (std::size_t e = 0; e < truss.externals.size(); ++e)
            EXPECT_EQ(truss.externals[e].after, truss.externals[(e + 1) % truss.externals.size()].before);
    }
}

TEST(Trusses, ACutGivesItsBarsByMoments) {
    const Solution& solution = example("truss_simple");
    ASSERT_EQ(solution.truss->cuts.size(), 3u);
    for (const Truss::Cut& cut : solution.truss->cuts) {
        const Truss::CutNumbers numbers = solution.truss->numbers_of(cut, solution.pose.points);
        EXPECT_NEAR(std::abs(numbers.known),
                    numbers.arm * std::abs(solution.truss->tension(at(cut.found), solution.pose.points)), 1e-6);
        EXPECT_EQ(cut.pivot.has_value(), solution.truss->structure.bars[at(cut.found)].name != "CE")
            << "BC and EF are parallel";
    }
}

/// A Polonceau truss: two fans that share the apex, and a tie.
std::string fan_text() {
    const std::string left =
        R"("A": [0, 0], "R1": [2, 1.5], "R2": [4, 3], "R3": [6, 4.5], "C": [8, 6], "J": [2.5, 0], "D": [5, 0],
        "K": [6.5, 3])";
    const std::string right =
        R"("B": [16, 0], "S1": [14, 1.5], "S2": [12, 3], "S3": [10, 4.5], "L": [13.5, 0], "E": [11, 0], "M": [9.5, 3])";
    const char* const bars[][2] = {{"A", "R1"}, {"R1", "R2"}, {"R2", "R3"}, {"R3", "C"},  {"A", "J"},  {"J", "D"},
                                   {"D", "K"},  {"K", "C"},   {"R1", "J"},  {"J", "R2"},  {"R2", "D"}, {"R2", "K"},
                                   {"R3", "K"}, {"B", "S1"},  {"S1", "S2"}, {"S2", "S3"}, {"S3", "C"}, {"B", "L"},
                                   {"L", "E"},  {"E", "M"},   {"M", "C"},   {"S1", "L"},  {"L", "S2"}, {"S2", "E"},
                                   {"S2", "M"}, {"S3", "M"},  {"D", "E"}};
    std::string bodies, joints;
    std::map<std::string, std::string> at_pin{{"A", "1"}};
    int body = 2;
    for (const auto& [from, to] : bars) {
        bodies += (body == 2 ? "\"" : ", \"") + std::to_string(body) + "\": [\"" + from + "\", \"" + to + "\"]";
        for (const char* const end : {from, to})
            at_pin[end] += (at_pin[end].empty() ? "" : ", ") + std::to_string(body);
        ++body;
    }
    for (const auto& [pin, all] : at_pin) joints += "{\"revolute\": \"" + pin + "\", \"bodies\": [" + all + "]}, ";
    joints += R"({"contact": "B", "bodies": [15, 1], "tangent": 0, "pushes": [0, 1]})";
    return R"({"kinegraph": 1, "frame": 1, "points": {)" + left + ", " + right + R"(}, "bodies": {)" + bodies +
           R"(}, "joints": [)" + joints +
           R"(], "loads": [{"force": "F1", "pin": "R1", "value": [0, -1000]}, {"force": "F2", "pin": "R2",
           "value": [0, -3000]},
               {"force": "F3", "pin": "R3", "value": [0, -1000]}, {"force": "F4", "pin": "S1", "value": [0, -2000]},
               {"force": "F5", "pin": "S2", "value": [0, -1000]}, {"force": "F6", "pin": "S3", "value": [500,
               -2000]}]})";
}

TEST(Trusses, WherePinsLeadNowhereACutLeadsOn) {
    const std::string text = fan_text();
    const Solution solution = solved(text);
    expect_as_linear_solve(solution, text);
    EXPECT_TRUE(says(solution, lang::sentences::truss_stuck));
    EXPECT_FALSE(solution.truss->cuts.empty());
    EXPECT_TRUE(solution.remarks.empty());
}

TEST(Trusses, WhereNoCutLeadsOnTheReasonIsSaidAndTheForcesAreFound) {
    // A hexagon with its long diagonals: three bars at each pin.
    const std::string text = R"({"kinegraph": 1, "frame": 1,
      "points": {"A": [0, 0], "B": [4, -1], "C": [7, 2], "D": [5, 6], "E": [1, 5], "F": [-2, 3]},
      "bodies": {"2": ["A", "B"], "3": ["B", "C"], "4": ["C", "D"], "5": ["D", "E"], "6": ["E", "F"], "7": ["F", "A"],
                 "8": ["A", "D"], "9": ["B", "E"], "10": ["C", "F"]},
      "joints": [{"revolute": "A", "bodies": [1, 2, 7, 8]}, {"revolute": "B", "bodies": [2, 3, 9]},
                 {"revolute": "C", "bodies": [3, 4, 10]}, {"revolute": "D", "bodies": [4, 5, 8]},
                 {"revolute": "E", "bodies": [5, 6, 9]}, {"revolute": "F", "bodies": [6, 7, 10]},
                 {"pin-slot": "C", "bodies": [3, 1], "along": 0}],
      "loads": [{"force": "P", "pin": "D", "value": [300, -700]}]})";
    const Solution solution = solved(text);
    expect_as_linear_solve(solution, text);
    ASSERT_FALSE(solution.remarks.empty());
    EXPECT_EQ(solution.remarks.front().sentence, lang::sentences::truss_without_order);
}

// A bar whose pins lie at one place pulls along no line: what it is part of is found as bodies, or not at all.
TEST(Trusses, WithABarWithoutLengthAreNoTrusses) {
    for (const char* const example : {"truss_simple", "truss_roof_wind"}) {
        const nlohmann::json whole = nlohmann::json::parse(tests::contents(tests::example_file(example)));
        for (const auto& [body, pins] : whole["bodies"].items()) {
            nlohmann::json file = whole;
            const auto ends = pins.is_array() ? pins : pins["points"];
            if (ends.size() != 2) continue;
            file["points"][ends[0].get<std::string>()] = file["points"][ends[1].get<std::string>()];
            auto mechanism = read_mechanism(file.dump(), "truss.json");
            if (!mechanism) continue;
            const auto solution = solve(*std::move(mechanism));
            ASSERT_TRUE(solution) << example << " " << body;
            EXPECT_FALSE(solution->truss) << example << " " << body;
        }
    }
}

TEST(Trusses, ACantileverOnTwoHingesIsResolvedFromItsTip) {
    const std::string text =
        R"({"kinegraph": 1, "frame": 1, "points": {"A": [0, 0], "B": [0, 3], "C": [4, 0], "D": [4, 3], "E": [8, 0]},
      "bodies": {"2": ["A", "C"], "3": ["B", "C"], "4": ["B", "D"], "5": ["C", "D"], "6": ["C", "E"], "7": ["D", "E"]},
      "joints": [{"revolute": "A", "bodies": [1, 2]}, {"revolute": "B", "bodies": [1, 3, 4]}, {"revolute": "C",
      "bodies": [2, 3, 5, 6]},
                 {"revolute": "D", "bodies": [4, 5, 7]}, {"revolute": "E", "bodies": [6, 7]}],
      "loads": [{"force": "P", "body": 7, "at": "E", "value": [0, -900]}], "find": [{"cut": ["BD", "CB", "AC"]}]})";
    const Solution solution = solved(text);
    expect_as_linear_solve(solution, text);
    EXPECT_TRUE(solution.unsolved.empty());
    EXPECT_EQ(solution.truss->cuts.size(), 3u);
    EXPECT_NEAR(force_in(solution, "BD"), 900 * 8.0 / 3 - 900 * 4.0 / 3, 1e-9) << "moments about C: 900 · 4/3";
}

std::string fault_of(const std::string& cut) {
    std::string text = tests::contents(tests::example_file("truss_simple"));
    const std::string old = R"(["BC", "CE", "EF"])";
    text.replace(text.find(old), old.size(), cut);
    const auto read = read_mechanism(text, "test.json");
    return read ? "" : read.error().front().where + " " + read.error().front().message.in(Language::en);
}

TEST(Cuts, ThatCannotBeMadeAreRefusedWithAPlaceAndARemedy) {
    EXPECT_EQ(fault_of(R"(["CB", "EC", "FE"])"), "") << "a bar has one name both ways";
    EXPECT_TRUE(fault_of(R"(["BC", "CX", "EF"])")
                    .starts_with("/find/1/cut/1 there is no bar \"CX\"; the bars are \"AB\", \"BC\""));
    EXPECT_TRUE(fault_of(R"(["AB", "BC", "BE"])").starts_with("/find/1/cut the bars meet in pin B"));
    EXPECT_TRUE(fault_of(R"(["AB", "CE", "EF"])").starts_with("/find/1/cut these bars do not part the truss"));
    EXPECT_TRUE(fault_of(R"(["AB", "EF"])").starts_with("/find/1/cut a cut crosses three bars"));
    EXPECT_TRUE(fault_of(R"(["AB", "AB", "EF"])").starts_with("/find/1/cut/1 bar \"AB\" is cut twice"));
}

TEST(TheWholeFirst, AFrameOnPinAndRollerIsCutFreeAsOneBeforeItsBodies) {
    // A step ladder: legs hinged at the top, a tie between them, a load on one leg.
    const Solution solution = solved(R"({"kinegraph": 1, "frame": 1,
      "points": {"A": [0, 0], "B": [4, 0], "C": [2, 4], "D": [1, 2], "E": [3, 2], "P": [0.5, 1]},
      "bodies": {"2": ["A", "C", "D", "P"], "3": ["B", "C", "E"], "4": ["D", "E"]},
      "joints": [{"revolute": "A", "bodies": [1, 2]}, {"contact": "B", "bodies": [3, 1], "tangent": 0},
                 {"revolute": "C", "bodies": [2, 3]}, {"revolute": "D", "bodies": [2, 4]}, {"revolute": "E",
                 "bodies": [3, 4]}],
      "loads": [{"force": "W", "body": 2, "at": "P", "value": [0, -800]}]})");
    EXPECT_FALSE(solution.truss);
    EXPECT_TRUE(says(solution, lang::sentences::structure_whole));
    EXPECT_FALSE(says(solution, lang::sentences::moments_give));
    // B = 800 · 0.5/4 = 100 N; the tie holds 100 · 2/2.
    for (const JointForce& action : solution.forces) {
        ASSERT_TRUE(action.force);
        const std::string& joint = solution.mechanism.joint(action.joint).name;
        if (joint == "B" && action.from == frame) {
            EXPECT_EQ(*action.force, (Vector{0, 100}));
        }
        if (joint == "D" && action.on == BodyIndex(3)) {
            EXPECT_EQ(action.force->x, Exact(-100));
        }
    }
    EXPECT_TRUE(solution.unsolved.empty());
}

TEST(TheWholeFirst, AnExcavatorsCylindersHoldItsBodiesByMoments) {
    const Solution& solution = example("excavator_arm");
    EXPECT_TRUE(solution.unsolved.empty());
    const auto place = [&](const char* name) { return solution.pose.at(*solution.mechanism.point_named(name)); };
    const Vector load{8000, 6000};
    // Everything beyond a hinge turns about it under the load and its cylinder alone.
    const auto cylinder = [&](const char* hinge, const char* from, const char* to) {
        const Vector along = place(to) - place(from);
        return -cross(place("T") - place(hinge), load).to_double() * length(along) /
               cross(place(to) - place(hinge), along).to_double();
    };
    const double expected[] = {cylinder("A", "C", "E"), cylinder("B", "F", "G"), cylinder("D", "H", "K")};
    for (std::size_t e = 0; e < 3; ++e)
        EXPECT_NEAR(solution.efforts[e].value->to_double(), expected[e], 1e-9 * std::abs(expected[e]));
}

/// Each string of the whole is parallel to its ray, and the closing line to the dividing one.
void expect_strings(const Solution& solution, const std::string& text) {
    for (const TakenTogether& together : solution.taken_together) {
        ASSERT_TRUE(together.funicular) << text;
        const FreeBody::Funicular& found = *together.funicular;
        for (std::size_t i = 0; i < found.corners.size(); ++i)
            EXPECT_TRUE(cross(*found.vertices[i + 1] - *found.vertices[i], *found.corners[i] - *found.pole).is_zero())
                << text;
        EXPECT_TRUE(cross(*found.vertices.front() - *found.vertices.back(), *found.dividing - *found.pole).is_zero())
            << text;
    }
}

/// KINEGRAPH_RANDOM_MECHANISMS=n takes so many.
TEST(RandomTrusses, AreTheLinearSolveExactly) {
    const char* const asked = std::getenv("KINEGRAPH_RANDOM_MECHANISMS");
    const int count = asked != nullptr ? std::stoi(asked) : unless_sanitized(40, 6);
    int plans = 0, strings = 0;
    for (int i = 0; i < count; ++i) {
        const std::string text = RandomTruss(static_cast<std::uint64_t>(i) + 1, 3 + i % 14).text();
        const Solution solution = solved(text);
        if (solution.mobility.effective != 0) continue;
        expect_as_linear_solve(solution, text);
        expect_strings(solution, text);
        strings += solution.taken_together.empty() ? 0 : 1;
        EXPECT_TRUE(solution.unsolved.empty()) << text;
        plans += solution.truss->polygon >= 0;
        // The check has every bar.
        const auto rows = std::count_if(solution.checks.begin(), solution.checks.end(),
                                        [](const CheckRow& row) { return row.quantity.kind == Quantity::Kind::bar; });
        EXPECT_EQ(static_cast<std::size_t>(rows), solution.truss->bars.size());
    }
    EXPECT_GT(plans, count / 20);
    EXPECT_GT(strings, count / 4);
}

}  // namespace
}  // namespace kinegraph::trusses_test
