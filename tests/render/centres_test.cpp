// Instant centres in the figure of the mechanism: those on which a sentence measures are in it, each on its lines.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/sentences/centre_symbol.hpp"
#include "render/figures/figure.hpp"
#include "render/mechanism/paper.hpp"
#include "tests/support/fonts.hpp"
#include "tests/support/solved.hpp"

namespace kinegraph::render::centres_test {
namespace {

using drawing::Bar;
using tests::example;
using tests::example_names;
using tests::fonts;

/// What a group of a centre shows: a dot, or the shaft of an arrow towards it.
struct Shown {
    std::string title;
    std::optional<Spot> dot;
    std::optional<Bar> shaft;
};
struct Drawn {
    std::vector<Shown> centres;
    std::vector<Bar> lines;  // of construction
    std::vector<std::string> labels;
};

std::optional<Bar> straight(const Path& path) {
    if (path.segments.size() != 2) return std::nullopt;
    const auto* from = std::get_if<MoveTo>(path.segments.data());
    const auto* to = std::get_if<LineTo>(&path.segments[1]);
    return from && to ? std::optional(Bar{from->to, to->to}) : std::nullopt;
}

std::optional<Spot> centre_of_round(const Path& path) {
    for (const Segment& segment : path.segments)
        if (const auto* arc = std::get_if<ArcTo>(&segment)) return arc->centre;
    return std::nullopt;
}

Drawn drawn(const Figure& figure) {
    Drawn all;
    std::vector<std::string> groups;
    for (const Mark& mark : figure.marks) {
        if (const auto* group = std::get_if<GroupBegin>(&mark)) {
            groups.push_back(group->cls);
            if (group->cls == "centre") all.centres.push_back({group->title, std::nullopt, std::nullopt});
        } else if (std::holds_alternative<GroupEnd>(mark)) {
            groups.pop_back();
        } else if (const auto* text = std::get_if<TextMark>(&mark)) {
            all.labels.push_back(text->words);
        } else if (const auto* path = std::get_if<Path>(&mark); path && !groups.empty()) {
            const auto bar = straight(*path);
            if (groups.back() == "centre") {
                if (bar) all.centres.back().shaft = bar;
                if (const auto at = centre_of_round(*path)) all.centres.back().dot = at;
            } else if (groups.back() == "construction" && bar) {
                all.lines.push_back(*bar);
            }
        }
    }
    return all;
}

/// The names of the centres on which sentences measure, apart from those that find centres.
std::vector<std::string> measured_on(const Solution& solution) {
    std::vector<std::string> names;
    for (const Statement& statement : solution.protocol.statements) {
        if (statement.section == Topic::centres) continue;
        for (const Argument& argument : statement.message.arguments)
            if (const auto* symbol = std::get_if<Symbol>(&argument); symbol && symbol->letter == Symbol::Letter::centre)
                names.push_back(plain(typeset(*symbol, Language::en)));
    }
    return names;
}

const std::vector<Spot> rooms{{70, 60}, {120, 100}, {250, 180}};

TEST(CentresInTheFigure, on_which_a_sentence_measures_are_shown) {
    const Theme theme;
    std::size_t measured = 0;
    for (const std::string& name : example_names()) {
        const Solution& solution = example(name);
        if (solution.instantaneous_motion || solution.centres.empty()) continue;
        for (const Spot room : rooms) {
            const Drawn all = drawn(mechanism_figure({solution, theme, fonts(), Language::en}, room.x, room.y, true));
            for (const std::string& centre : measured_on(solution)) {
                ++measured;
                EXPECT_TRUE(std::any_of(all.centres.begin(), all.centres.end(),
                                        [&](const Shown& shown) { return shown.title == centre; }))
                    << name << ": " << centre << " in " << room.x << " x " << room.y;
            }
        }
    }
    EXPECT_GT(measured, 0U);
}

/// Whether a line, extended, passes through a place.
bool passes(const Bar& bar, Spot at) {
    constexpr double drawn_exactly = 0.02;  // mm, what numbers of a drawing are rounded to, and more
    return length(bar) > 0 && std::abs(cross(direction(bar), at - bar.from)) < drawn_exactly;
}
bool is_parallel(const Bar& a, const Bar& b) { return std::abs(cross(direction(a), direction(b))) < 1e-4; }

/// Directions of the lines on which a place lies, each once.
std::size_t lines_through(const Drawn& all, Spot at) {
    std::vector<Bar> met;
    for (const Bar& bar : all.lines)
        if (drawing::distance(at, bar) < 0.02 &&
            std::none_of(met.begin(), met.end(), [&](const Bar& other) { return is_parallel(bar, other); }))
            met.push_back(bar);
    return met.size();
}

TEST(CentresInTheFigure, lie_on_two_lines_and_arrows_on_one) {
    const Theme theme;
    std::size_t dots = 0, arrows = 0;
    for (const std::string& name : example_names()) {
        const Solution& solution = example(name);
        if (solution.instantaneous_motion) continue;
        for (const Spot room : rooms) {
            const Drawn all = drawn(mechanism_figure({solution, theme, fonts(), Language::en}, room.x, room.y, true));
            for (const InstantCentre& centre : solution.centres) {
                if (!centre.at || centre.everywhere || centre.how == InstantCentre::How::primary) continue;
                const std::string title = plain(
                    typeset(centre_symbol(solution.mechanism, centre.first, centre.second, centre.at->at_infinity()),
                            Language::en));
                for (const Shown& shown : all.centres) {
                    if (shown.title != title) continue;
                    if (shown.dot) {
                        ++dots;
                        EXPECT_GE(lines_through(all, *shown.dot), 2U) << name << ": " << title << " in " << room.x;
                    } else if (shown.shaft) {
                        ++arrows;
                        EXPECT_TRUE(std::any_of(all.lines.begin(), all.lines.end(),
                                                [&](const Bar& bar) {
                                                    return passes(bar, shown.shaft->from) &&
                                                           is_parallel(bar, *shown.shaft);
                                                }))
                            << name << ": " << title << " in " << room.x;
                    }
                }
            }
        }
    }
    EXPECT_GT(dots, 0U);
    EXPECT_GT(arrows, 0U);
}

TEST(CentresInTheFigure, out_of_reach_have_name_and_distance) {
    const Theme theme;
    std::size_t far = 0;
    for (const std::string& name : example_names()) {
        const Solution& solution = example(name);
        if (solution.instantaneous_motion) continue;
        const Drawn all = drawn(mechanism_figure({solution, theme, fonts(), Language::en}, 250, 180, true));
        for (const Shown& shown : all.centres) {
            if (!shown.shaft || shown.title.find("∞") != std::string::npos) continue;
            ++far;
            EXPECT_TRUE(std::any_of(all.labels.begin(), all.labels.end(),
                                    [&](const std::string& label) {
                                        return label.find(shown.title) != std::string::npos &&
                                               label.find(" = ") != std::string::npos;
                                    }))
                << name << ": " << shown.title;
        }
    }
    EXPECT_GT(far, 0U);
}

/// An arrow that ends at the dot of another centre would have that centre's name.
TEST(CentresInTheFigure, out_of_reach_have_their_arrows_clear_of_other_centres) {
    const Theme theme;
    std::size_t far = 0, met = 0;
    std::string said;
    for (const std::string& name : example_names()) {
        const Solution& solution = example(name);
        if (solution.instantaneous_motion) continue;
        for (const Spot room : rooms) {
            const Drawn all = drawn(mechanism_figure({solution, theme, fonts(), Language::en}, room.x, room.y, true));
            for (const Shown& shown : all.centres) {
                if (!shown.shaft || shown.title.find("∞") != std::string::npos) continue;
                ++far;
                constexpr double clear = 2;  // mm
                if (std::none_of(all.centres.begin(), all.centres.end(), [&](const Shown& other) {
                        return other.dot && drawing::distance(*other.dot, *shown.shaft) < clear;
                    }))
                    continue;
                ++met;
                said += shown.title + " of " + name + " in " + std::to_string(room.x) + "\n";
            }
        }
    }
    ASSERT_GT(far, 60U);
    EXPECT_LE(met, far / 30) << said;
}

}  // namespace
}  // namespace kinegraph::render::centres_test
