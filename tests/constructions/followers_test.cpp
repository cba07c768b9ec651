// What the list of bodies calls the follower of a four-bar linkage: by Grashof's rule.
#include "render/sheet/sheet.hpp"
#include "tests/support/pages.hpp"

namespace followers_test {
namespace {

using namespace kinegraph::pages;

/// A four-bar linkage with the crank O2A upright: lengths of frame and crank, and where B lies.
std::vector<Page> sheet_of(const std::string& frame, const std::string& crank, const std::string& b) {
    return lay_out(kinegraph::tests::solved(
                       R"({"kinegraph": 1, "units": {"length": "mm"}, "frame": 1, "points": {"O2": [0, 0], "A": [0, )" +
                       crank + R"(], "O4": [)" + frame + R"(, 0], "B": )" + b + R"(},
"bodies": {"2": {"points": ["O2", "A"]}, "3": {"points": ["A", "B"]}, "4": {"points": ["B", "O4"]}},
"joints": [{"revolute": "O2", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
  {"revolute": "B", "bodies": [3, 4]}, {"revolute": "O4", "bodies": [1, 4]}],
"drivers": [{"body": 2, "omega": 10}]})"),
                   {}, fonts());
}

TEST(Followers, OneThatGoesRoundIsACrank) {
    // A drag link: the frame, 30, is the shortest; 30 + 72.1 < 70 + 70.7.
    EXPECT_TRUE(says(sheet_of("30", "70", "[70, 60]"), "crank BO_4"));
    // The antiparallelogram, whose frame is as short as its coupler.
    EXPECT_TRUE(says(laid_out("antiparallelogram"), "crank BO_4"));
}

TEST(Followers, OneThatSwingsIsARocker) {
    // The crank is the shortest.
    EXPECT_TRUE(says(laid_out("four_bar"), "rocker BO_4"));
    // No link goes round: 20 + 100 > 41.2 + 60.8.
    EXPECT_TRUE(says(sheet_of("100", "20", "[60, 10]"), "rocker BO_4"));
}

}  // namespace
}  // namespace followers_test
