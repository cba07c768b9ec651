// Five hundred random mechanisms on paper: nothing covers anything, counted from the display list and in pixels. From one to the
// next language, theme, paper and orientation change, so that all combinations are met.
//
// Each is named by its seed. KINEGRAPH_SEED=n lays that one out alone, prints its file and writes its pages as PNG into
// KINEGRAPH_PAGES_DIR where that is set; KINEGRAPH_RANDOM_MECHANISMS=n takes so many; KINEGRAPH_ALL_PAPERS=1 lays each out in
// all combinations (some forty minutes for the five hundred).
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <string>

#include "constructions/solve.hpp"
#include "render/backends.hpp"
#include "render/sheet.hpp"
#include "tests/chains.hpp"
#include "tests/page_checker.hpp"
#include "tests/random_loads.hpp"
#include "tests/random_mechanism.hpp"

namespace kinegraph::render {
namespace {

const Fonts& fonts() {
    static const Fonts opened = std::move(*Fonts::open());
    return opened;
}

/// Forces at bodies and pins by a file's text.
std::string loaded(const std::string& text, std::uint64_t seed, int efforts) {
    const auto bare = read_mechanism(text, "bare");
    if (!bare) throw std::runtime_error(bare.error().front().message);
    const auto pose = draw_pose(*bare);
    if (!pose) throw std::runtime_error(pose.error().front().message);
    return under_random_loads(text, *bare, *pose, seed, efforts);
}

struct RandomFile {
    std::string text, recipe;
};

/// Of ten, three are chains of dyads, one of them under loads; three are four-bars and six-bars under loads (sliders, slots,
/// rolling), two of them; four are eight-bars, one of them under loads.
RandomFile random_file(std::uint64_t seed) {
    const std::uint64_t nth = seed / 10;
    const auto chain = [&](std::uint64_t first, std::uint64_t count, bool forces) -> RandomFile {
        // Of all inversions the four-bars come first, then the six-bars, then the eight-bars; further rounds are drawn otherwise.
        const std::uint64_t of_chain = first + (7 * nth + seed % 10) % count + all_inversions().size() * nth;
        const ChainMechanism mechanism = random_chain_mechanism(of_chain);
        return {forces ? loaded(mechanism.text, seed, 0) : mechanism.text, mechanism.recipe + (forces ? ", loaded" : "")};
    };
    const auto dyads = [&](bool forces) -> RandomFile {
        const RandomMechanism mechanism = random_mechanism(seed);
        return {forces ? loaded(mechanism.text, seed, mechanism.freedoms) : mechanism.text,
                mechanism.recipe + (forces ? ", loaded" : "")};
    };
    switch (seed % 10) {
        case 0:
        case 1:
            return dyads(false);
        case 2:
            return dyads(true);
        case 3:
            return chain(0, 12, true);
        case 4:
            return chain(12, 60, false);
        case 5:
            return chain(12, 60, true);
        case 6:
            return chain(72, 896, true);
        default:
            return chain(72, 896, false);
    }
}

/// One of all combinations of what a sheet may look like.
constexpr int combinations = 2 * 3 * 3 * 2;
SheetOptions combination(int n) {
    SheetOptions options;
    options.language = n % 2 == 0 ? Language::en : Language::it;
    options.paper = static_cast<Paper>(n / 2 % 3);
    options.orientation = static_cast<Orientation>(n / 6 % 2);
    options.theme = *built_in_theme(theme_names()[static_cast<std::size_t>(n / 12 % 3)]);
    options.joukowsky = n % 5 == 0;
    return options;
}
std::string said(int n) {
    const SheetOptions options = combination(n);
    return std::string(options.language == Language::en ? "en, " : "it, ") +
           std::array{"A4", "A3", "letter"}[static_cast<std::size_t>(options.paper)] +
           (options.orientation == Orientation::landscape ? ", landscape, " : ", portrait, ") +
           std::string(theme_names()[static_cast<std::size_t>(n / 12 % 3)]);
}

struct Count {
    std::map<Fault::Kind, int> faults;
    std::size_t pixels = 0;
    std::string first;  ///< in words
    int sheets = 0, pages = 0, clean = 0;
};

constexpr double dpi = 100;

/// Counts the faults of one sheet.
void look_at(const Solution& solution, int n, const std::string& name, Count& count) {
    const SheetOptions options = combination(n);
    ++count.sheets;
    bool clean = true;
    int number = 0;
    for (const Page& page : lay_out(solution, options, fonts())) {
        ++count.pages;
        ++number;
        if (const char* directory = std::getenv("KINEGRAPH_PAGES_DIR")) {
            std::ofstream(std::string(directory) + "/" + name + "-" + std::to_string(number) + ".png")
                << to_png(page, fonts(), 150);
        }
        const std::string where = name + " (" + said(n) + "), page " + std::to_string(number) + ", ";
        for (const Fault& fault : faults_of(page, fonts())) {
            clean = false;
            ++count.faults[fault.kind];
            if (count.first.size() < 4'000'000)
                count.first += where + std::to_string(static_cast<int>(fault.kind)) + " " + render::said(fault) + "\n";
        }
        if (const std::size_t pixels = pixels_in_common(page, fonts(), dpi); pixels > 0) {
            clean = false;
            count.pixels += pixels;
            count.first += where + "P " + std::to_string(pixels) + " pixels in common\n";
        }
    }
    count.clean += clean ? 1 : 0;
}

void lay_out_one(std::uint64_t seed, Count& count) {
    const RandomFile file = random_file(seed);
    const std::string name = "seed " + std::to_string(seed);
    SCOPED_TRACE(name + ": " + file.recipe);
    auto mechanism = read_mechanism(file.text, name);
    ASSERT_TRUE(mechanism) << mechanism.error().front().message;
    const auto solution = solve(*std::move(mechanism));
    ASSERT_TRUE(solution) << solution.error().front().message;
    if (std::getenv("KINEGRAPH_ALL_PAPERS") != nullptr) {
        for (int n = 0; n < combinations; ++n) look_at(*solution, n, name, count);
    } else {
        // Seeds of one kind are ten apart and share no factor with the combinations after this.
        look_at(*solution, static_cast<int>((seed / 10 * 7 + seed) % combinations), name, count);
    }
    if (std::getenv("KINEGRAPH_SEED") != nullptr) std::cerr << file.text;
}

void look_at_quarter(int quarter) {
    Count count;
    if (const char* one = std::getenv("KINEGRAPH_SEED")) {
        if (quarter == 0) lay_out_one(std::strtoull(one, nullptr, 10), count);
    } else {
        const char* asked = std::getenv("KINEGRAPH_RANDOM_MECHANISMS");
        const int mechanisms = asked != nullptr ? std::atoi(asked) : 500;
        for (int seed = quarter; seed < mechanisms; seed += 4) lay_out_one(static_cast<std::uint64_t>(seed), count);
    }
    EXPECT_EQ(count.faults, (std::map<Fault::Kind, int>{})) << count.first;
    EXPECT_EQ(count.pixels, 0U) << count.first;
    std::cout << count.sheets << " sheets, " << count.pages << " pages, " << count.clean << " sheets clean\n";
}

TEST(RandomPages1, CoverNothing) { look_at_quarter(0); }
TEST(RandomPages2, CoverNothing) { look_at_quarter(1); }
TEST(RandomPages3, CoverNothing) { look_at_quarter(2); }
TEST(RandomPages4, CoverNothing) { look_at_quarter(3); }

}  // namespace
}  // namespace kinegraph::render
