// What figures of contacts show: arms as dimensions, pivots on the frame, velocities that can be seen.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "problems/impact/impact.hpp"
#include "problems/reye/reye.hpp"
#include "render/page/shapes.hpp"
#include "tests/support/pages.hpp"

namespace contact_figures_test {
namespace {

using namespace kinegraph;
using namespace kinegraph::render;
using namespace kinegraph::pages;

struct Stroke {
    Spot from, to;
};
/// The straight strokes of a figure with a pen of this width and colour.
std::vector<Stroke> strokes(const Figure& figure, double width, Colour colour) {
    std::vector<Stroke> found;
    for (const Mark& mark : figure.marks) {
        const auto* path = std::get_if<Path>(&mark);
        if (path == nullptr || !path->stroked || path->pen.width != width || path->pen.colour != colour) continue;
        if (path->segments.size() != 2) continue;
        const auto* from = std::get_if<MoveTo>(&path->segments[0]);
        if (const auto* to = std::get_if<LineTo>(&path->segments[1]); from != nullptr && to != nullptr)
            found.push_back({from->to, to->to});
    }
    return found;
}
double distance(Spot at, const Stroke& bar) {
    const Spot along = unit(bar.to - bar.from);
    const double way = std::clamp(dot(at - bar.from, along), 0.0, length(bar.to - bar.from));
    return length(at - (bar.from + way * along));
}

/// A line that ends on the tip of a force hides where it acts and how long its arm is.
TEST(ContactFigures, NoLineOfAShoeEndsOnItsForce) {
    const Theme theme;
    for (const char* const name : {"contact/drum_shoe", "contact/outer_shoe"}) {
        SCOPED_TRACE(name);
        const DrawingContext context{example(name), theme, fonts()};
        const Figure figure = reye_contact_figure(context, 80, 90);
        std::vector<Stroke> forces = strokes(figure, theme.vector, theme.text);
        std::erase_if(forces, [](const Stroke& each) { return each.from.y == each.to.y; });  // the wall below the pivot
        ASSERT_EQ(forces.size(), 1U);
        constexpr double tip = 4;  // mm, the head and what lies before it
        const Stroke force{forces[0].from, forces[0].to + tip * unit(forces[0].to - forces[0].from)};
        std::size_t thin = 0;
        for (const Colour ink : {theme.text, theme.secondary})
            for (const Stroke& each : strokes(figure, theme.thin, ink)) {
                ++thin;
                EXPECT_GT(std::min(distance(each.from, force), distance(each.to, force)), 0.8);
            }
        EXPECT_GE(thin, 10U);  // two dimensions of four strokes each, and the hatching
    }
}

/// The pivot of a shoe stands on a hatched wall, as a hinge of the frame does.
TEST(ContactFigures, TheShoesPivotIsOnTheFrame) {
    const Theme theme;
    for (const char* const name : {"contact/drum_shoe", "contact/outer_shoe"}) {
        const DrawingContext context{example(name), theme, fonts()};
        const Figure figure = reye_contact_figure(context, 80, 90);
        std::size_t walls = 0;
        for (const Stroke& wall : strokes(figure, theme.outline, theme.text)) {
            std::size_t hatches = 0;
            for (const Stroke& each : strokes(figure, theme.thin, theme.text))
                hatches += distance(each.from, wall) < 0.01 && length(each.to - each.from) < 4 ? 1 : 0;
            walls += hatches >= 4 ? 1 : 0;
        }
        EXPECT_EQ(walls, 1U) << name;
    }
}

/// Velocities have a scale in each figure: those afterwards are seen, also where they are a tenth of those before.
TEST(ContactFigures, VelocitiesAfterAnImpactAreSeen) {
    const Theme theme;
    for (const char* const name :
         {"contact/rod_hit_off_centre", "contact/billiard_shot", "contact/ball_against_wall"}) {
        const DrawingContext context{example(name), theme, fonts()};
        for (const auto& draw : {impact_bodies_figure, impact_after_figure}) {
            double longest = 0;
            for (const Mark& mark : draw(context, 80, 70).marks)
                if (const auto* axis = std::get_if<Axis>(&mark))
                    longest = std::max(longest, length(axis->tip - axis->tail));
            EXPECT_GE(longest, 8) << name;  // mm: the series of scales has steps of 2.5 at most, below 20 mm
        }
    }
}

}  // namespace
}  // namespace contact_figures_test
