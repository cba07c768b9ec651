// Files that once crashed, hung or gave nonsense: they go through.
#include <gtest/gtest.h>

#include "tests/support/files.hpp"
#include "tests/support/fonts.hpp"
#include "tests/support/through_all.hpp"

namespace kinegraph::tests::fuzz_found_test {
namespace {

std::vector<std::string> found() {
    std::vector<std::string> names;
    for (const auto& file : json_files(std::filesystem::path(KINEGRAPH_TESTS_DIR) / "fuzz" / "found"))
        names.push_back(file.stem().string());
    return names;
}

class Found : public testing::TestWithParam<std::string> {};

TEST_P(Found, GoesThrough) {
    const auto file = std::filesystem::path(KINEGRAPH_TESTS_DIR) / "fuzz" / "found" / (GetParam() + ".json");
    EXPECT_NO_THROW(through_all(contents(file), fonts()));
}

INSTANTIATE_TEST_SUITE_P(ByFuzzing, Found, testing::ValuesIn(found()), [](const auto& each) { return each.param; });

}  // namespace
}  // namespace kinegraph::tests::fuzz_found_test
