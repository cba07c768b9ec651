// Crew: all of the work is done, each part once; a sheet is the same whoever draws its figures.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "render/backends/backends.hpp"
#include "render/layout/crew.hpp"
#include "render/sheet/sheet.hpp"
#include "tests/support/four_bars_in_a_row.hpp"
#include "tests/support/pages.hpp"

namespace {

using namespace kinegraph;
using namespace kinegraph::render;
using namespace kinegraph::pages;

TEST(Crew, DoesEachPartOnce) {
    for (const int helpers : {0, 1, 3}) {
        Crew crew(helpers);
        for (const std::size_t count : {0U, 1U, 2U, 7U, 1000U}) {
            std::vector<std::atomic<int>> done(count);
            crew.share(count, [&](std::size_t i) { ++done[i]; });
            for (const auto& each : done) EXPECT_EQ(each, 1) << count << " by " << helpers;
        }
    }
}

TEST(Crew, WorksSideBySide) {
    Crew crew(1);
    std::atomic<int> here = 0, met = 0;
    // Each waits for the other: one after the other they would wait in vain.
    const auto late = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    crew.share(2, [&](std::size_t) {
        ++here;
        while (here < 2 && std::chrono::steady_clock::now() < late) std::this_thread::yield();
        if (std::chrono::steady_clock::now() < late) ++met;
    });
    EXPECT_EQ(met, 2);
}

TEST(Crew, BringsOutTheFirstFaultByNumberWhenAllIsDone) {
    Crew crew(2);
    for (int times = 0; times < 50; ++times) {
        std::atomic<int> done = 0;
        try {
            crew.share(20, [&](std::size_t i) {
                ++done;
                if (i % 6 == 5) throw std::runtime_error(std::to_string(i));
            });
            ADD_FAILURE() << "nothing was thrown";
        } catch (const std::runtime_error& fault) {
            EXPECT_STREQ(fault.what(), "5");
        }
        EXPECT_EQ(done, 20);
    }
}

TEST(Crew, LetsEachHelperBeginAndEnd) {
    std::atomic<int> begun = 0, ended = 0;
    {
        const Crew crew(
            3, [&] { ++begun; }, [&] { ++ended; });
    }
    EXPECT_EQ(begun, 3);
    EXPECT_EQ(ended, 3);
}

std::vector<std::string> drawn(const Solution& solution, Crew* crew) {
    const Fonts own = std::move(*Fonts::open());  // no word is set yet
    SheetOptions options;
    options.crew = crew;
    std::vector<std::string> texts;
    for (const Page& page : lay_out(solution, options, own)) texts.push_back(to_svg(page, own));
    for (const std::string& missing : own.missing()) texts.push_back(missing);
    return texts;
}

TEST(Crew, DrawsTheSameSheets) {
    Crew crew(3);
    // Motion and forces, a scale that the file asks for, details, and figures with more names than have room.
    for (const char* name : {"exam_2001", "sluice_gate", "four_bar", "truss_roof_wind"}) {
        const Solution solution = example(name);
        const std::vector<std::string> alone = drawn(solution, nullptr);
        for (int times = 0; times < 3; ++times) EXPECT_EQ(drawn(solution, &crew), alone) << name;
    }
    const Solution crowded = tests::solved(tests::four_bars_in_a_row(5));
    EXPECT_EQ(drawn(crowded, &crew), drawn(crowded, nullptr));
}

TEST(Crew, FindsTheSameMissingCharacters) {
    std::string text = tests::four_bars_in_a_row(1);
    for (const auto& [name, other] : {std::pair{"\"C0\"", "\"中\""}, {"\"B1\"", "\"語\""}, {"\"O1\"", "\"文😀\""}})
        for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1))
            text.replace(at, 4, other);
    const Solution solution = tests::solved(text);
    const std::vector<std::string> alone = drawn(solution, nullptr);
    EXPECT_EQ(std::vector(alone.end() - 4, alone.end()),
              (std::vector<std::string>{"U+4E2D", "U+6587", "U+8A9E", "U+1F600"}));
    Crew crew(3);
    for (int times = 0; times < 5; ++times) EXPECT_EQ(drawn(solution, &crew), alone);
}

}  // namespace
