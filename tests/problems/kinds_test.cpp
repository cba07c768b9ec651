// The table of the kinds of problems: every row is whole, has a key of its own and is stated by an example, whose
// results stand under that key; two problems in one file are refused, whatever their kinds.
#include "engine/file/units.hpp"  // before signal.h, which makes a macro of si_value

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "engine/results/results.hpp"
#include "engine/solution/problem_kind.hpp"
#include "tests/support/problem_tests.hpp"

namespace kinegraph::kinds_of_problems_test {
namespace {

/// The examples that state a problem in place of joints.
std::map<std::string, const ProblemKind*> examples_of_problems() {
    std::map<std::string, const ProblemKind*> found;
    for (const char* folder : {"contact", "motion", "rotor"})
        for (const std::string& name : tests::example_names(folder)) {
            const std::string example = std::string(folder) + "/" + name;
            if (const auto& problem = tests::example(example).mechanism.problem) found.emplace(example, problem->kind);
        }
    return found;
}

TEST(ProblemKinds, AreWholeRowsWithKeysOfTheirOwn) {
    std::set<std::string_view> keys;
    for (const ProblemKind* each : problem_kinds()) {
        EXPECT_TRUE(keys.insert(each->key).second) << each->key;
        EXPECT_NE(each->read, nullptr) << each->key;
        EXPECT_NE(each->solve, nullptr) << each->key;
        EXPECT_NE(each->results, nullptr) << each->key;
    }
    EXPECT_GE(keys.size(), 5u);
}

TEST(ProblemKinds, AreStatedByExamplesThatHaveResultsUnderTheirKey) {
    std::set<const ProblemKind*> stated;
    for (const auto& [example, kind] : examples_of_problems()) {
        SCOPED_TRACE(example);
        stated.insert(kind);
        const auto results = nlohmann::json::parse(
            results_json(tests::example(example), false, [](const Message&) { return std::string(); }));
        EXPECT_TRUE(results.contains(kind->key));
        EXPECT_EQ(results.at("checks").size(), tests::example(example).problem->values.size());
    }
    EXPECT_EQ(stated.size(), problem_kinds().size());
}

TEST(ProblemKinds, OnePerFile) {
    for (const ProblemKind* first : problem_kinds())
        for (const ProblemKind* second : problem_kinds()) {
            if (first == second) continue;
            const auto section = [](const ProblemKind* kind) {
                return "\"" + std::string(kind->key) +
                       "\": " + (kind->is_stated_by != nullptr ? R"({"point": "P"})" : "{}");
            };
            const std::string file = R"({"kinegraph": 1, )" + section(first) + ", " + section(second) + "}";
            SCOPED_TRACE(file);
            const auto read = read_mechanism(file, "two.json");
            ASSERT_FALSE(read);
            EXPECT_TRUE(std::any_of(read.error().begin(), read.error().end(), [&](const Error& each) {
                return each.message.in(Language::en).find("together") != std::string::npos;
            })) << read.error().front().message.in(Language::en);
        }
}

}  // namespace
}  // namespace kinegraph::kinds_of_problems_test
