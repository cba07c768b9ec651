// Symbols: each kind of joint and profile has its symbol, in its place: wheels touch, teeth mesh, links that cross are
// parted once, every stroke says its role.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "constructions/solving/solve.hpp"
#include "render/figures/figure.hpp"
#include "render/mechanism/sketch.hpp"
#include "render/page/shapes.hpp"
#include "tests/support/fonts.hpp"
#include "tests/support/solved.hpp"

namespace kinegraph::render::symbols_test {
namespace {

using tests::fonts;

/// A mechanism's figure without centres, and where its points are on it.
struct Drawn {
    Figure figure;
    std::vector<Spot> points;

    explicit Drawn(const std::string& points_bodies_joints, double room = 150,
                   Dimensions dimensions = Dimensions::automatic) {
        auto mechanism =
            read_mechanism(R"({"kinegraph": 1, "frame": 1, "find": [], )" + points_bodies_joints + "}", "test");
        EXPECT_TRUE(mechanism.has_value());
        auto solution = solve(*mechanism);
        EXPECT_TRUE(solution.has_value());
        const Theme theme;
        figure = mechanism_figure({*solution, theme, fonts(), Language::en, dimensions}, room, room, false);
        // The first pin or dot of a joint's group stands at the joint's point: the whole figure is set off by the same.
        Spot offset;
        for (const Joint& joint : solution->mechanism.joints) {
            const auto marks = group("joint-" + legal_id(joint.name));
            if (marks.empty()) continue;
            const auto& at = solution->pose.at(joint.point);
            const Spot centre = std::get<ArcTo>(std::get<Path>(marks[0]).segments[1]).centre;
            offset = centre - Spot{at.x.to_double() / figure.scale, -at.y.to_double() / figure.scale};
            break;
        }
        for (const Vector& at : solution->pose.points)
            points.push_back(offset + Spot{at.x.to_double() / figure.scale, -at.y.to_double() / figure.scale});
    }

    /// The marks within a group, by its id.
    std::vector<Mark> group(const std::string& id) const {
        std::vector<Mark> marks;
        int depth = 0;
        for (const Mark& mark : figure.marks) {
            const auto* begin = std::get_if<GroupBegin>(&mark);
            if (depth == 0 && begin && begin->id.text() == id) {
                depth = 1;
                continue;
            }
            if (depth == 0) continue;
            if (begin) ++depth;
            if (std::holds_alternative<GroupEnd>(mark) && --depth == 0) break;
            marks.push_back(mark);
        }
        return marks;
    }
    /// The marks of a role, all groups of that class together.
    std::vector<Path> role(const std::string& cls) const {
        std::vector<Path> paths;
        std::vector<std::string> open;
        for (const Mark& mark : figure.marks) {
            if (const auto* begin = std::get_if<GroupBegin>(&mark)) open.push_back(begin->cls);
            if (std::holds_alternative<GroupEnd>(mark)) open.pop_back();
            if (const auto* path = std::get_if<Path>(&mark);
                path && std::find(open.begin(), open.end(), cls) != open.end())
                paths.push_back(*path);
        }
        return paths;
    }
};

/// The corners of a path, arcs cut into short chords.
std::vector<Spot> outline(const Path& path) {
    std::vector<Spot> spots;
    for (const Segment& segment : path.segments) {
        if (const auto* m = std::get_if<MoveTo>(&segment)) spots.push_back(m->to);
        if (const auto* l = std::get_if<LineTo>(&segment)) spots.push_back(l->to);
        if (const auto* a = std::get_if<ArcTo>(&segment))
            for (int i = 0; i <= 200; ++i) {
                const double angle = a->from + (a->to - a->from) * i / 200;
                spots.push_back(a->centre + a->radius * Spot{std::cos(angle), std::sin(angle)});
            }
    }
    return spots;
}

bool inside(const std::vector<Spot>& polygon, Spot spot) {
    bool in = false;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        const Spot a = polygon[i], b = polygon[j];
        if ((a.y > spot.y) != (b.y > spot.y) && spot.x < a.x + (b.x - a.x) * (spot.y - a.y) / (b.y - a.y)) in = !in;
    }
    return in;
}

double distance_to(const std::vector<Spot>& polygon, Spot spot) {
    double least = 1e300;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        const Spot d = polygon[j] - polygon[i];
        const double t = dot(d, d) > 0 ? std::clamp(dot(spot - polygon[i], d) / dot(d, d), 0.0, 1.0) : 0;
        least = std::min(least, length(spot - polygon[i] - t * d));
    }
    return least;
}

double depth_inside(const std::vector<Spot>& polygon, Spot spot) {
    return inside(polygon, spot) ? distance_to(polygon, spot) : 0;
}

/// The toothed contour of a link: its path of most segments.
Path contour(const std::vector<Mark>& marks) {
    Path most;
    for (const Mark& mark : marks)
        if (const auto* path = std::get_if<Path>(&mark); path && path->segments.size() > most.segments.size())
            most = *path;
    return most;
}

/// The largest circle of a group.
ArcTo largest_circle(const std::vector<Mark>& marks) {
    ArcTo largest;
    for (const Mark& mark : marks)
        if (const auto* path = std::get_if<Path>(&mark); path && path->segments.size() == 3)
            if (const auto* arc = std::get_if<ArcTo>(&path->segments[1]); arc && arc->radius > largest.radius)
                largest = *arc;
    return largest;
}

const std::string disc_on_line =
    R"("points": {"C": [0, 0.2], "P": [0, 0]}, "bodies": {"2": {"circle": {"centre": "C", "radius": 0.2}}},
       "joints": [{"rolling": "P", "bodies": [2, 1], "profiles": {"1": {"line": 0}}}])";
const std::string planetary =
    R"("points": {"O": [0, 0], "C": [0.3, 0], "P": [0.2, 0], "Q": [0.4, 0]},
       "bodies": {"2": {"circle": {"centre": "O", "radius": 0.2}}, "3": {"circle": {"centre": "C", "radius": 0.1}},
       "4": ["O", "C"],
                  "5": {"circle": {"centre": "O", "radius": 0.4}}},
       "joints": [{"revolute": "O", "bodies": [1, 2], "name": "sun"}, {"revolute": "O", "bodies": [1, 4],
       "name": "arm"},
                  {"revolute": "O", "bodies": [1, 5], "name": "ring"}, {"revolute": "C", "bodies": [4, 3]},
                  {"gear": "P", "bodies": [2, 3], "arm": 4}, {"gear": "Q", "bodies": [3, 5], "arm": 4}])";
const std::string rack_and_pinion =
    R"("points": {"O": [0, 0], "P": [0, -0.1], "D": [0.05, -0.2]}, "bodies": {"2": {"circle": {"centre": "O",
    "radius": 0.1}}, "3": ["D"]},
       "joints": [{"revolute": "O", "bodies": [1, 2]}, {"gear": "P", "bodies": [2, 3], "profiles": {"3": {"line": 0}}},
                  {"prismatic": "D", "bodies": [3, 1], "along": 0}])";
const std::string crossing_links =
    R"("points": {"O2": [0, 0], "O4": [0.2, 0], "A": [0.18, 0.15], "B": [0.02, 0.2]},
       "bodies": {"2": ["O2", "A"], "3": ["A", "B"], "4": ["O4", "B"]},
       "joints": [{"revolute": "O2", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]}, {"revolute": "B",
       "bodies": [3, 4]},
                  {"revolute": "O4", "bodies": [1, 4]}])";
const std::string knife_edge =
    R"("points": {"O": [0, 0], "C": [0.03, 0.01], "P": [0.03, 0.07], "D": [0.03, 0.2]},
       "bodies": {"2": {"points": ["O"], "circle": {"centre": "C", "radius": 0.06}}, "3": ["P", "D"]},
       "joints": [{"revolute": "O", "bodies": [1, 2]}, {"contact": "P", "bodies": [3, 2],
       "profiles": {"3": {"tip": true}}},
                  {"prismatic": "D", "bodies": [3, 1], "along": 90}])";
const std::string flat_follower =
    R"("points": {"O": [0, 0], "C": [0.03, 0.02], "P": [0.03, 0.08], "D": [0, 0.14]},
       "bodies": {"2": {"points": ["O"], "circle": {"centre": "C", "radius": 0.06}}, "3": ["D"]},
       "joints": [{"revolute": "O", "bodies": [1, 2]}, {"contact": "P", "bodies": [3, 2],
       "profiles": {"3": {"line": 0}}},
                  {"prismatic": "D", "bodies": [3, 1], "along": 90}])";
const std::string hydraulic =
    R"("points": {"O": [0, 0], "B": [0.4, 0.1], "A": [0.25, 0.35]}, "bodies": {"2": ["O", "A"], "3": ["B"], "4": ["A"]},
       "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "B", "bodies": [1, 3]}, {"revolute": "A",
       "bodies": [2, 4]},
                  {"prismatic": "B", "bodies": [4, 3], "along": ["B", "A"], "name": "ram"}],
       "drivers": [{"joint": "ram", "speed": 0.1}])";
const std::string sprung =
    R"("points": {"O": [0, 0], "A": [0.3, 0.2], "B": [0.4, 0]}, "bodies": {"2": ["O", "A"]},
       "joints": [{"revolute": "O", "bodies": [1, 2]}],
       "loads": [{"spring": "S", "bodies": [2, 1], "between": ["A", "B"], "stiffness": 100, "free length": 0.1}])";

const std::string pulled =
    R"("points": {"O": [0, 0], "A": [0.3, 0.2], "B": [0.4, 0]}, "bodies": {"2": ["O", "A"]},
       "joints": [{"revolute": "O", "bodies": [1, 2]}],
       "loads": [{"force": "S", "bodies": [2, 1], "between": ["A", "B"], "magnitude": 10}])";

TEST(Symbols, a_wheel_stands_on_the_ground_it_rolls_on) {
    const Drawn drawn(disc_on_line);
    const ArcTo rim = largest_circle(drawn.group("link-2"));
    EXPECT_NEAR(rim.radius, 0.2 / drawn.figure.scale, 1e-6);
    const Spot contact = drawn.points[1];
    EXPECT_NEAR(length(rim.centre + Spot{0, rim.radius} - contact), 0, 1e-6);
    bool on_ground = false;
    for (const Path& path : drawn.role("ground"))
        if (const std::vector<Spot> ends = outline(path); ends.size() == 2)
            on_ground =
                on_ground || (std::abs(ends[0].y - contact.y) < 1e-6 && std::abs(ends[1].y - contact.y) < 1e-6 &&
                              (ends[0].x - contact.x) * (ends[1].x - contact.x) < 0);
    EXPECT_TRUE(on_ground);
    // The spoke runs from the hub to the rim.
    bool spoke = false;
    for (const Mark& mark : drawn.group("link-2"))
        if (const auto* path = std::get_if<Path>(&mark); path && path->segments.size() == 2) {
            const std::vector<Spot> ends = outline(*path);
            spoke = spoke || (std::abs(cross(ends[0] - rim.centre, ends[1] - rim.centre)) < 1e-6 &&
                              length(ends[1] - rim.centre) > rim.radius - 1);
        }
    EXPECT_TRUE(spoke);
}

/// No tooth stands in a tooth of the other, and at the pitch point one reaches across the pitch curve.
void expect_mesh(const std::vector<Spot>& teeth, const std::vector<Spot>& others, Spot pitch_point) {
    double nearest = 1e300;
    for (const Spot spot : teeth)
        if (length(spot - pitch_point) < 12) {
            EXPECT_LT(depth_inside(others, spot), 0.25);
            nearest = std::min(nearest, length(spot - pitch_point));
        }
    EXPECT_GT(nearest, 0.5) << "a pitch point lies within a tooth, or in the middle of a space";
}

TEST(Symbols, teeth_of_a_pair_stand_in_each_others_spaces) {
    const Drawn train(planetary);
    const std::vector<Spot> sun = outline(contour(train.group("link-2"))),
                            planet = outline(contour(train.group("link-3")));
    ASSERT_GT(sun.size(), 50U);
    expect_mesh(sun, planet, train.points[2]);
    expect_mesh(planet, sun, train.points[2]);
    const Drawn rack(rack_and_pinion);
    const std::vector<Spot> pinion = outline(contour(rack.group("link-2"))),
                            bar = outline(contour(rack.group("link-3")));
    ASSERT_GT(bar.size(), 20U);
    expect_mesh(pinion, bar, rack.points[1]);
    expect_mesh(bar, pinion, rack.points[1]);
}

TEST(Symbols, an_internal_gear_lies_about_its_planet) {
    const Drawn train(planetary);
    const std::vector<Spot> planet = outline(contour(train.group("link-3"))),
                            ring = outline(contour(train.group("link-5")));
    ASSERT_GT(ring.size(), 50U);
    for (const Spot spot : planet) {
        // Within the ring's hollow, or in one of its spaces: not deeper in its teeth than a line is wide. Away from the
        // mesh straight flanks are not involutes.
        if (length(spot - train.points[3]) > 6 || inside(ring, spot)) continue;
        EXPECT_LT(distance_to(ring, spot), 0.35);
    }
}

TEST(Symbols, pitch_circles_touch_and_are_dash_dotted) {
    const Drawn train(planetary);
    std::vector<double> radii;
    for (const Path& path : train.role("construction"))
        if (path.segments.size() == 3 && path.pen.dashes == dash_dot())
            radii.push_back(std::get<ArcTo>(path.segments[1]).radius * train.figure.scale);
    std::sort(radii.begin(), radii.end());
    ASSERT_EQ(radii.size(), 3U);
    EXPECT_NEAR(radii[0], 0.1, 1e-9);
    EXPECT_NEAR(radii[1], 0.2, 1e-9);
    EXPECT_NEAR(radii[2], 0.4, 1e-9);
}

TEST(Symbols, links_that_cross_are_parted_exactly_once) {
    const Drawn drawn(crossing_links);
    int crossings = 0;
    for (const Mark& mark : drawn.figure.marks)
        if (const auto* group = std::get_if<GroupBegin>(&mark)) crossings += group->cls == "crossing";
    EXPECT_EQ(crossings, 1);
    const std::vector<Mark> gap = drawn.group("crossing-2.4");
    ASSERT_EQ(gap.size(), 1U);
    const std::vector<Spot> ends = outline(std::get<Path>(gap[0]));
    const Spot middle = 0.5 * (ends[0] + ends[1]);
    const auto distance = [&](Spot a, Spot b) { return std::abs(cross(unit(b - a), middle - a)); };
    EXPECT_LT(distance(drawn.points[0], drawn.points[2]), 1e-6);
    EXPECT_LT(distance(drawn.points[1], drawn.points[3]), 1e-6);
}

TEST(Symbols, links_that_only_share_a_pin_are_not_parted) {
    const Drawn drawn(R"("points": {"O2": [0, 0], "O4": [0.3, 0], "A": [0, 0.2], "B": [0.3, 0.2]},
        "bodies": {"2": ["O2", "A"], "3": ["A", "B"], "4": ["O4", "B"]},
        "joints": [{"revolute": "O2", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]}, {"revolute": "B",
        "bodies": [3, 4]},
                   {"revolute": "O4", "bodies": [1, 4]}])");
    EXPECT_TRUE(drawn.role("crossing").empty());
}

TEST(Symbols, a_knife_edge_is_pointed_at_the_contact) {
    const Drawn drawn(knife_edge);
    const Spot contact = drawn.points[2];
    double nearest = 1e300;
    for (const Mark& mark : drawn.group("link-3"))
        if (const auto* path = std::get_if<Path>(&mark); path && path->filled && !path->stroked)
            for (const Spot spot : outline(*path)) nearest = std::min(nearest, length(spot - contact));
    EXPECT_LT(nearest, 1e-6);
}

TEST(Symbols, a_flat_follower_touches_with_its_edge) {
    const Drawn drawn(flat_follower);
    const Spot contact = drawn.points[2];
    bool touches = false;
    for (const Mark& mark : drawn.group("link-3"))
        if (const auto* path = std::get_if<Path>(&mark); path && path->segments.size() == 2) {
            const std::vector<Spot> ends = outline(*path);
            touches = touches || (std::abs(ends[0].y - ends[1].y) < 1e-9 &&
                                  std::abs(ends[0].y + path->pen.width / 2 - contact.y) < 1e-6);
        }
    EXPECT_TRUE(touches);
}

/// Where a rope leaves a pulley is a point of the disc, which needs no bar to carry it.
TEST(Symbols, points_on_a_disc_add_nothing_to_its_body) {
    const auto pulley = [](const std::string& points) {
        return Drawn(R"("points": {"B": [0, 0], "D": [6, 0], "T": [8, 0], "U": [6, 2], "G": [5, 1]},
            "bodies": {"2": ["B", "D"], "3": {"points": [)" +
                     points + R"(], "circle": {"centre": "D", "radius": 2}}},
            "joints": [{"revolute": "B", "bodies": [1, 2]}, {"revolute": "D", "bodies": [2, 3]}])");
    };
    const std::size_t alone = pulley(R"("D")").role("link").size();
    EXPECT_GE(alone, 2U);
    EXPECT_EQ(pulley(R"("D", "T", "U", "G")").role("link").size(), alone);
    EXPECT_EQ(pulley(R"("D", "T")").role("link").size(), alone);
}

TEST(Symbols, a_driven_slide_between_pins_is_a_cylinder) {
    const Drawn drawn(hydraulic);
    const Spot foot = drawn.points[1], head = drawn.points[2];
    const Spot along = unit(head - foot);
    // The barrel lies between the pins, about their line; the piston in it.
    std::vector<Spot> barrel, piston;
    for (const Mark& mark : drawn.group("link-3"))
        if (const auto* path = std::get_if<Path>(&mark); path && path->filled && path->stroked) barrel = outline(*path);
    for (const Mark& mark : drawn.group("link-4"))
        if (const auto* path = std::get_if<Path>(&mark); path && path->filled && !path->stroked)
            piston = outline(*path);
    ASSERT_EQ(barrel.size(), 4U);
    ASSERT_EQ(piston.size(), 4U);
    double sum = 0;
    for (const Spot spot : barrel) {
        sum += cross(along, spot - foot);
        EXPECT_GT(dot(along, spot - foot), 1);
        EXPECT_LT(dot(along, spot - foot), length(head - foot) - 1);
    }
    EXPECT_NEAR(sum, 0, 1e-6);
    for (const Spot spot : piston) EXPECT_TRUE(inside(barrel, spot));
}

/// In any size of the drawing, as the list of bodies names them.
TEST(Symbols, a_small_cylinder_is_one_too) {
    for (const double room : {150.0, 60.0, 45.0}) {
        const Drawn drawn(hydraulic, room);
        const auto filled_of = [&](const std::string& link, bool stroked) {
            std::size_t count = 0;
            for (const Mark& mark : drawn.group(link))
                if (const auto* path = std::get_if<Path>(&mark))
                    count += path->filled && path->stroked == stroked ? 1 : 0;
            return count;
        };
        EXPECT_EQ(filled_of("link-3", true), 1U) << room << ": a barrel";
        EXPECT_EQ(filled_of("link-4", false), 1U) << room << ": a piston";
    }
}

/// A guide with a point on each side of its slider: a barrel would leave out the one that the rod points to.
TEST(Symbols, a_guide_that_goes_on_past_its_driven_slider_reaches_its_points) {
    const Drawn drawn(R"("points": {"A": [0, 0], "P": [90, 0], "B": [150, 0]},
        "bodies": {"2": ["A", "B"], "3": ["P"]},
        "joints": [{"revolute": "A", "bodies": [1, 2]},
                   {"prismatic": "P", "bodies": [3, 2], "along": ["A", "B"]}],
        "drivers": [{"body": 2, "omega": 3}, {"joint": "P", "speed": 0.2}])");
    for (const std::size_t end : {0U, 2U}) {
        double nearest = 1e300;
        for (const Mark& mark : drawn.group("link-2"))
            if (const auto* path = std::get_if<Path>(&mark))
                for (const Spot spot : outline(*path)) nearest = std::min(nearest, length(spot - drawn.points[end]));
        EXPECT_LT(nearest, 2) << end;
    }
}

TEST(Symbols, a_spring_ends_at_its_two_points) {
    const Drawn drawn(sprung);
    const std::vector<Mark> spring = drawn.group("spring-S");
    ASSERT_EQ(spring.size(), 1U);
    const std::vector<Spot> coil = outline(std::get<Path>(spring[0]));
    EXPECT_LT(length(coil.front() - drawn.points[1]), 1e-6);
    EXPECT_LT(length(coil.back() - drawn.points[2]), 1e-6);
    EXPECT_GT(coil.size(), 6U);
}

TEST(Symbols, a_pull_of_given_magnitude_is_the_line_of_its_points) {
    const Drawn drawn(pulled);
    const std::vector<Mark> pull = drawn.group("spring-S");
    ASSERT_EQ(pull.size(), 1U);
    const std::vector<Spot> rope = outline(std::get<Path>(pull[0]));
    ASSERT_EQ(rope.size(), 2U);
    EXPECT_LT(length(rope.front() - drawn.points[1]), 1e-6);
    EXPECT_LT(length(rope.back() - drawn.points[2]), 1e-6);
}

TEST(Symbols, a_pin_under_a_block_that_it_does_not_hold_is_drawn_hidden) {
    const Drawn drawn(R"("points": {"O2": [0, 0], "O4": [0.15, 0]}, "bodies": {"2": ["O2"], "3": [], "4": ["O4"]},
        "joints": [{"revolute": "O2", "bodies": [1, 2]}, {"revolute": "O4", "bodies": [1, 4]},
                   {"prismatic": "O2", "bodies": [3, 2], "along": 30, "name": "p"}, {"prismatic": "O4",
                   "bodies": [3, 4], "along": 120, "name": "q"}])");
    const std::vector<Mark> joint = drawn.group("joint-O2");
    const auto& pin = std::get<Path>(joint.at(0));
    EXPECT_FALSE(pin.filled);
    EXPECT_FALSE(pin.pen.dashes.empty());
}

const std::string given_four_bar =
    R"("units": {"length": "mm"}, "points": {"O2": [0, 0], "A": {"from": "O2", "distance": 40, "angle": 60},
    "O4": [150, 0],
       "B": {"meet": [{"circle": "A", "radius": 130}, {"circle": "O4", "radius": 80}], "side": "left"}},
       "bodies": {"2": ["O2", "A"], "3": ["A", "B"], "4": ["O4", "B"]},
       "joints": [{"revolute": "O2", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]}, {"revolute": "B",
       "bodies": [3, 4]},
                  {"revolute": "O4", "bodies": [1, 4]}])";

TEST(Dimensions, say_what_the_file_gives_where_it_is_measured) {
    const Drawn drawn(given_four_bar, 150, Dimensions::on);
    const std::vector<std::pair<std::string, std::pair<int, int>>> lengths{
        {"dimension-O2.A", {0, 1}}, {"dimension-A.B", {1, 3}}, {"dimension-O4.B", {2, 3}}, {"dimension-O2.O4", {0, 2}}};
    const std::vector<std::string> values{"40 mm", "130 mm", "80 mm", "150 mm"};
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        const auto& [id, ends] = lengths[i];
        SCOPED_TRACE(id);
        const std::vector<Mark> marks = drawn.group(id);
        ASSERT_FALSE(marks.empty());
        // The arrowheads' tips are as far apart as the points.
        std::vector<Spot> tips;
        std::string words;
        for (const Mark& mark : marks) {
            if (const auto* path = std::get_if<Path>(&mark); path && path->filled)
                tips.push_back(std::get<MoveTo>(path->segments[0]).to);
            if (const auto* text = std::get_if<TextMark>(&mark)) words += text->words;
        }
        ASSERT_EQ(tips.size(), 2U);
        const Spot a = drawn.points[static_cast<std::size_t>(ends.first)],
                   b = drawn.points[static_cast<std::size_t>(ends.second)];
        EXPECT_NEAR(length(tips[1] - tips[0]), length(b - a), 1e-6);
        EXPECT_NEAR(cross(tips[1] - tips[0], b - a), 0, 1e-4);
        EXPECT_EQ(words, values[i]);
    }
    EXPECT_FALSE(drawn.group("dimension-angle.O2.A").empty());
}

TEST(Dimensions, are_left_out_on_request_and_never_cost_a_step_of_the_scale) {
    for (const double room : {60.0, 80.0, 100.0, 120.0, 150.0}) {
        const Drawn none(given_four_bar, room, Dimensions::off), some(given_four_bar, room);
        EXPECT_TRUE(none.role("dimensions").empty());
        EXPECT_EQ(none.figure.scale, some.figure.scale);
    }
    EXPECT_FALSE(Drawn(given_four_bar).role("dimensions").empty());
}

TEST(Dimensions, none_lies_on_what_a_name_got_later) {
    const Theme theme;
    std::size_t drawn = 0;
    for (const char* name : {"cam_roller_follower", "stephenson_1_driver_3", "stephenson_3_driver_2", "jansen_leg"}) {
        const Solution& solution = tests::example(name);
        for (const double room : {70.0, 85.0, 100.0, 115.0, 130.0}) {
            const Figure figure = mechanism_figure({solution, theme, fonts(), Language::en}, room, room, true);
            EXPECT_TRUE(drawing::covered_dimensions(figure, fonts()).empty()) << name << " in " << room;
            for (const Mark& mark : figure.marks)
                if (const auto* group = std::get_if<GroupBegin>(&mark)) drawn += group->cls == "dimension";
        }
    }
    EXPECT_GT(drawn, 0U);
}

TEST(Symbols, every_mark_has_a_role_and_stays_in_the_room) {
    const std::set<std::string> roles{"tint",   "construction", "ground",  "links",
                                      "joints", "arrows",       "centres", "dimensions"};
    for (const std::string& text :
         {disc_on_line, planetary, rack_and_pinion, crossing_links, knife_edge, flat_follower, hydraulic, sprung}) {
        SCOPED_TRACE(text);
        const Drawn drawn(text, 90);
        EXPECT_LE(drawn.figure.box.width(), 90);
        EXPECT_LE(drawn.figure.box.height(), 90);
        const Box ink = box_of(drawn.figure.marks);
        EXPECT_TRUE(std::isfinite(ink.min.x) && std::isfinite(ink.max.y));
        // Within the figure's group: paths lie in a role's group; labels, their leaders and the scale bar stand by
        // themselves.
        std::vector<std::string> open;
        int in_roles = 0;
        bool labels_began = false;
        for (const Mark& mark : drawn.figure.marks) {
            if (const auto* group = std::get_if<GroupBegin>(&mark)) open.push_back(group->cls);
            if (std::holds_alternative<GroupEnd>(mark)) open.pop_back();
            if (open.size() >= 2 && roles.count(open[1]) != 0) {
                EXPECT_FALSE(labels_began) << "strokes after labels";
                ++in_roles;
            } else if (open.size() == 1 && !std::holds_alternative<GroupEnd>(mark) &&
                       !std::holds_alternative<GroupBegin>(mark)) {
                labels_began = true;
            }
        }
        EXPECT_GT(in_roles, 10);
    }
}

}  // namespace
}  // namespace kinegraph::render::symbols_test
