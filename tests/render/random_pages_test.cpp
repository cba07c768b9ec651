// Random mechanisms on paper: nothing covers anything, counted from the display list and in pixels. From
// one to the next language, theme, paper and orientation change, so that all combinations are met.
//
// Each is named by its seed. KINEGRAPH_SEED=n lays that one out alone, prints its file, and writes its pages as PNG
// into the directory KINEGRAPH_PAGES where that is set; KINEGRAPH_RANDOM_MECHANISMS=n takes so many;
// KINEGRAPH_ALL_PAPERS=n lays each out in all languages, papers and orientations, the themes in turn: 1, 2 and 3
// together are all combinations (some twenty minutes of one core each, for five hundred).
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>

#include "constructions/solving/solve.hpp"
#include "render/backends/backends.hpp"
#include "render/sheet/sheet.hpp"
#include "tests/support/chains.hpp"
#include "tests/support/fonts.hpp"
#include "tests/support/page_checker.hpp"
#include "tests/support/random_loads.hpp"
#include "tests/support/random_mechanism.hpp"
#include "tests/support/solved.hpp"

namespace kinegraph::render::random_pages_test {
namespace {

using tests::fonts;

/// A mechanism file under random loads.
std::string loaded(const std::string& text, std::uint64_t seed, int efforts) {
    const auto bare = read_mechanism(text, "bare");
    if (!bare) throw std::runtime_error(bare.error().front().message.in(Language::en));
    const auto pose = draw_pose(*bare);
    if (!pose) throw std::runtime_error(pose.error().front().message.in(Language::en));
    return under_random_loads(text, *bare, *pose, seed, efforts);
}

struct RandomFile {
    std::string text, recipe;
};

/// A chain of dyads with no more bodies than that.
RandomMechanism dyads_of(std::uint64_t seed, int most_bodies) {
    for (std::uint64_t other = 0;; ++other) {
        RandomMechanism mechanism = random_mechanism(seed + 100'000 * other);
        if (mechanism.bodies <= most_bodies) return mechanism;
    }
}

/// Of ten, two are chains of dyads, one of them loaded; two loaded four-bars; three six-bars, one of them loaded; three
/// eight-bars. Now and then one is larger or loaded too: few, because they take long.
RandomFile random_file(std::uint64_t seed) {
    const std::uint64_t nth = seed / 10;
    const bool seldom = nth % 5 == 0;
    const auto dyads = [&](bool forces, int most_bodies) -> RandomFile {
        const RandomMechanism mechanism = dyads_of(seed, most_bodies);
        return {forces ? loaded(mechanism.text, seed, mechanism.freedoms) : mechanism.text, mechanism.recipe};
    };
    // Of all inversions the four-bars come first, then the six-bars, then the eight-bars; further rounds are drawn
    // otherwise.
    const auto chain = [&](std::uint64_t first, std::uint64_t count, bool forces) -> RandomFile {
        const ChainMechanism mechanism =
            random_chain_mechanism(first + (7 * nth + seed) % count + all_inversions().size() * nth);
        return {forces ? loaded(mechanism.text, seed, 0) : mechanism.text, mechanism.recipe};
    };
    switch (seed % 10) {
        case 0: return dyads(false, seldom ? 12 : 8);
        case 1: return dyads(true, 8);
        case 2:
        case 3: return chain(0, 12, true);
        case 4:
        case 5:
        case 6: return chain(12, 60, seed % 10 == 6);
        default: return chain(72, 896, seldom && seed % 10 == 9);
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
/// "it, A3, portrait, dark"
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

/// Counts the faults of one sheet.
void look_at(const Solution& solution, int n, const std::string& name, Count& count) {
    constexpr double dpi = 100;
    const char* const directory = std::getenv("KINEGRAPH_PAGES");
    const std::size_t said_before = count.first.size();
    int number = 0;
    for (const Page& page : lay_out(solution, combination(n), fonts())) {
        ++count.pages;
        ++number;
        if (directory != nullptr)
            std::ofstream(std::string(directory) + "/" + name + "-" + std::to_string(number) + ".png", std::ios::binary)
                << to_png(page, fonts(), 150);
        const std::string where = name + " (" + said(n) + "), page " + std::to_string(number) + ", ";
        for (const Fault& fault : faults_of(page, fonts())) {
            ++count.faults[fault.kind];
            count.first += where + said(fault) + "\n";
        }
        if (const std::size_t pixels = pixels_in_common(page, fonts(), dpi); pixels > 0) {
            count.pixels += pixels;
            count.first += where + std::to_string(pixels) + " pixels in common\n";
        }
    }
    ++count.sheets;
    count.clean += count.first.size() == said_before ? 1 : 0;
}

void lay_out_one(std::uint64_t seed, Count& count) {
    const RandomFile file = random_file(seed);
    const std::string name = "seed-" + std::to_string(seed);
    SCOPED_TRACE(name + ": " + file.recipe);
    if (std::getenv("KINEGRAPH_SEED") != nullptr) std::cerr << file.text;
    const Solution solution = tests::solved(file.text, name);
    if (const char* turn = std::getenv("KINEGRAPH_ALL_PAPERS")) {
        constexpr int of_a_theme = combinations / 3;
        for (int n = 0; n < of_a_theme; ++n)
            look_at(solution, n + of_a_theme * ((n + static_cast<int>(seed) + std::atoi(turn)) % 3), name, count);
    } else {
        // Seeds of one kind are ten apart: they come round to every combination.
        look_at(solution, static_cast<int>((seed / 10 * 7 + seed) % combinations), name, count);
    }
}

void look_at_quarter(int quarter) {
    Count count;
    const auto lay_out = [&](std::uint64_t seed) { return lay_out_one(seed, count), true; };
    hold_quarter(quarter, unless_sanitized(240, 40), lay_out, [] { return false; });
    EXPECT_EQ(count.faults, (std::map<Fault::Kind, int>{})) << count.first;
    EXPECT_EQ(count.pixels, 0U) << count.first;
    std::cout << count.sheets << " sheets, " << count.pages << " pages, " << count.clean << " sheets clean\n"
              << count.first;
}

TEST(RandomPages1, CoverNothing) { look_at_quarter(0); }
TEST(RandomPages2, CoverNothing) { look_at_quarter(1); }
TEST(RandomPages3, CoverNothing) { look_at_quarter(2); }
TEST(RandomPages4, CoverNothing) { look_at_quarter(3); }

}  // namespace
}  // namespace kinegraph::render::random_pages_test
