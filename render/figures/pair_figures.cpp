#include "render/figures/pair_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "engine/number/functions.hpp"
#include "render/figures/pair_pen.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render {
namespace {

using std::numbers::pi;

/// A pair in the plane. P is the origin of each half.
class PlanePairFigure {
public:
    PlanePairFigure(const DrawingContext& context, JointKind kind)
        : pen_(context, "pair-" + std::string(plane_pair(kind).key), larger), pair_(plane_pair(kind)) {}

    Figure draw() {
        pen_.at({-13, 0});
        draw_other();
        draw_own();
        draw_joint();
        draw_motions();
        pen_.at({pair_.meshes() ? 17.0 : 14.0, 0});
        draw_own();
        if (pair_.has_pin() && !pair_.is_clamp()) pen_.pin({0, 0}, first);
        draw_reactions();
        return pen_.figure({60, 42});
    }

private:
    static constexpr int first = 1, second = 3;  // colours of the bodies i and j
    static constexpr double larger = 1.15;

    void draw_own() {
        if (pair_.rolls() || (pair_.touches() && !pair_.meshes())) {
            pen_.wheel({0, -6.5}, 6.5, first);
        } else if (pair_.meshes()) {
            pen_.gear({-5.2, 0}, 5.2, 12, 0, first);
        } else if (pair_.is_sleeve()) {
            pen_.bar({0, -2}, {-5, -10}, first);
            pen_.block({0, 0}, {5, 0}, {0, 3}, first);
        } else {
            pen_.bar({0, 0}, pair_.is_clamp() ? Spot{-10, 0} : Spot{-8, -8}, first);
        }
    }
    void draw_other() {
        if (pair_.rolls()) {
            pen_.bar({-11, 0.9}, {11, 0.9}, second);
        } else if (pair_.meshes()) {
            pen_.gear({6.5, 0}, 6.5, 15, 0, second);  // an odd number, so that there is a gap at the pitch point
        } else if (pair_.touches()) {
            pen_.cap({0, 15}, 15, second);
        } else if (pair_.is_sleeve()) {
            pen_.bar({-12, 0}, {12, 0}, second);
        } else if (pair_.is_slot()) {
            pen_.block({0, 0}, {11, 0}, {0, 2.6}, second);
        } else {
            pen_.bar({0, 0}, pair_.is_clamp() ? Spot{8, 7} : Spot{10, 6}, second);
        }
    }
    void draw_joint() {
        if (pair_.is_clamp())
            pen_.clamp({0, 0});
        else if (pair_.has_pin())
            pen_.pin({0, 0}, first);
        else
            pen_.dot({0, 0});
        pen_.name("{P}", {0, 0});
    }
    void draw_motions() {
        if (pair_.turns()) {
            const double from = pair_.touches() && !pair_.meshes() ? -2.75 : pair_.is_slot() ? -1.9 : -0.9;
            pen_.turn({0, 0}, pair_.meshes() ? 9.5 : 6.2, pair_.meshes() ? -2.1 : from,
                      pair_.meshes() ? -1.0 : from + 2.2, "r");
        }
        if (!pair_.slides() && !pair_.meshes()) return;
        // Gears slide along the normal of their pitch curves; all others along the guide or the common tangent.
        if (pair_.meshes())
            pen_.both_ways({0, 10}, {7, 0}, "{t_n}");
        else
            pen_.both_ways({0, pair_.touches() ? 4.2 : 6.4}, {9, 0}, pair_.touches() ? "{t_t}" : "{t_x}");
    }
    void draw_reactions() {
        if (pair_.meshes()) {
            const double angle = 20 * pi / 180;
            const Spot along{-nearest::sin(angle), nearest::cos(angle)};
            pen_.axis(-11 * along, 11 * along);
            pen_.force(9 * along, {0, 0}, "{F}");
            return;
        }
        if (pair_.holds_normal)
            pen_.force({0, 11}, {0, pair_.is_sleeve() ? 3.0 : 0.0}, pair_.touches() ? "{F_n}" : "{F_y}");
        if (pair_.holds_tangent)
            pen_.force(pair_.is_clamp() ? Spot{11, 0} : Spot{-11, 0}, {0, 0}, pair_.touches() ? "{F_t}" : "{F_x}");
        if (!pair_.transmits_couple()) return;
        if (pair_.is_clamp())
            pen_.couple({0, 0}, 6.5, -2.3, -0.6, "{M}");
        else
            pen_.couple({0, 0}, 7.2, -0.8, 1.0, "{M}");
    }

    PairPen pen_;
    const PlanePair& pair_;
};

/// A position or a direction in space.
struct Space {
    double x = 0, y = 0, z = 0;
};

/// A lower pair in space, seen from above and from the side; axis z.
class SpacePairFigure {
public:
    SpacePairFigure(const DrawingContext& context, const SpacePair& pair)
        : pen_(context, "space-" + std::string(pair.key), larger), key_(pair.key), pair_(pair) {}

    Figure draw() {
        pen_.at({-18, 0});
        draw_bodies();
        draw_motions();
        pen_.at({19, 4});
        draw_reactions();
        return pen_.figure({80, 56});
    }

private:
    static constexpr int first = 1, second = 3;
    static constexpr double larger = 1.2;
    static constexpr double azimuth = 0.62, elevation = 0.44;

    static Spot seen(const Space& p) {
        const double across = -nearest::sin(azimuth) * p.x + nearest::cos(azimuth) * p.y;
        const double near = nearest::cos(azimuth) * p.x + nearest::sin(azimuth) * p.y;
        return {across, nearest::sin(elevation) * near - nearest::cos(elevation) * p.z};
    }
    static Space axis(char letter, double size) {
        return letter == 'x' ? Space{size, 0, 0} : letter == 'y' ? Space{0, size, 0} : Space{0, 0, size};
    }

    /// Points of a circle about the axis. `angle` on paper: 0 right, π/2 in front.
    static Spot round(double radius, double z, double angle) {
        return Spot{radius * nearest::cos(angle), radius * nearest::sin(elevation) * nearest::sin(angle)} +
               seen({0, 0, z});
    }
    static std::vector<Spot> arc(double radius, double z, double from, double to) {
        constexpr int pieces = 48;
        std::vector<Spot> spots;
        for (int i = 0; i <= pieces; ++i) spots.push_back(round(radius, z, from + (to - from) * i / pieces));
        return spots;
    }
    void cylinder(double low, double high, double radius, int body) {
        std::vector<Spot> outline = arc(radius, low, pi, 0);
        const std::vector<Spot> back = arc(radius, high, 0, -pi);
        outline.insert(outline.end(), back.begin(), back.end());
        pen_.panel(outline, body);
        pen_.panel(arc(radius, high, 0, 2 * pi), body);
    }
    /// The three visible faces.
    void box(const Space& least, const Space& most, int body) {
        const auto corner = [&](bool x, bool y, bool z) {
            return seen({x ? most.x : least.x, y ? most.y : least.y, z ? most.z : least.z});
        };
        pen_.panel({corner(true, false, false), corner(true, true, false), corner(true, true, true),
                    corner(true, false, true)},
                   body);
        pen_.panel({corner(false, true, false), corner(true, true, false), corner(true, true, true),
                    corner(false, true, true)},
                   body);
        pen_.panel({corner(false, false, true), corner(true, false, true), corner(true, true, true),
                    corner(false, true, true)},
                   body);
    }

    void draw_bodies() {
        if (key_ == "prismatic") {
            box({-2.6, -2.6, -13}, {2.6, 2.6, -4.5}, first);
            box({-6, -6, -4.5}, {6, 6, 4.5}, second);
            box({-2.6, -2.6, 4.5}, {2.6, 2.6, 12}, first);
        } else if (key_ == "planar") {
            box({-10, -10, -4}, {10, 10, -1.5}, second);
            box({-4.5, -4.5, -1.5}, {4.5, 4.5, 3.5}, first);
        } else if (key_ == "spherical") {
            draw_ball();
        } else {
            const bool collars = key_ == "revolute";
            cylinder(-13, -5, 3, first);
            if (key_ == "helical") thread(-13, -5);
            if (collars) cylinder(-7.2, -5, 5, first);
            cylinder(-5, 5, 6.8, second);
            if (collars) cylinder(5, 7.2, 5, first);
            cylinder(collars ? 7.2 : 5, 12, 3, first);
            if (key_ == "helical") thread(5, 12);
        }
    }
    /// The visible parts of a helix on the shaft.
    void thread(double low, double high) {
        constexpr double pitch = 1.75, radius = 3;
        for (double z = low; z + pitch <= high + 1e-9; z += pitch) {
            std::vector<Spot> turn;
            constexpr int pieces = 16;
            for (int i = 0; i <= pieces; ++i) {
                const double share = static_cast<double>(i) / pieces;
                turn.push_back(round(radius, z + pitch * (0.25 + 0.5 * share), pi * (1 - share)));
            }
            pen_.edge(turn, first);
        }
    }
    void draw_ball() {
        constexpr double outer = 8, ball = 6.6;
        std::vector<Spot> cup;  // its outline below the rim, then the rear part of the rim
        constexpr int pieces = 48;
        for (int i = 0; i <= pieces; ++i) cup.push_back(outer * polar_spot(pi * i / pieces));
        pen_.panel(cup, second);
        pen_.panel(arc(outer, 0, 0, 2 * pi), second);
        pen_.paper(arc(ball, 0, 0, 2 * pi), second);
        pen_.bar({0, -5}, {0, -15}, first);
        pen_.wheel_without_hub({0, 0}, ball, first);
        // The cup in front of the ball.
        std::vector<Spot> front = arc(outer, 0, pi, 0);
        std::vector<Spot> inner = arc(ball, 0, pi, 0);
        for (int i = 0; i <= pieces; ++i) front.push_back(outer * polar_spot(pi * i / pieces));
        pen_.panel(front, second);
        std::vector<Spot> rim = arc(outer, 0, pi, 0);
        std::reverse(inner.begin(), inner.end());
        rim.insert(rim.end(), inner.begin(), inner.end());
        pen_.panel(rim, second);
    }

    void draw_motions() {
        if (key_ == "spherical") {
            turn_about('z', {0, 0, 14.5}, 4.5, "{r_z}");
            turn_about('x', {14, 0, 0}, 4, "{r_x}");
            turn_about('y', {0, 13, 0}, 4, "{r_y}");
            return;
        }
        if (key_ == "planar") {
            shift('x', {6.5, -6, -1.5}, "{t_x}");
            shift('y', {-6, 6.5, -1.5}, "{t_y}");
            turn_about('z', {0, 0, 5.5}, 5, "{r_z}");
            return;
        }
        const bool turns = key_ != "prismatic", shifts = key_ != "revolute";
        if (turns) turn_about('z', {0, 0, 13.5}, 5.2, "{r_z}");
        if (shifts) {
            const Spot foot = seen({0, 0, 0}) + Spot{10.5, 0}, up = 7.5 * unit(seen({0, 0, 1}));
            pen_.both_ways(foot, up, key_ == "helical" ? "{t_z} = {p}{r_z}" : "{t_z}");
        }
    }
    void shift(char letter, const Space& from, const char* name) {
        const Spot middle = seen(from), reach = 6.0 * unit(seen(axis(letter, 1)));
        pen_.both_ways(middle, reach, name);
    }
    /// Most of a circle about an axis through a point, with an arrowhead; counter-clockwise as seen from the tip of the
    /// axis.
    void turn_about(char letter, const Space& at, double radius, const char* name) {
        std::vector<Spot> spots;
        constexpr int pieces = 40;
        for (int i = 0; i <= pieces; ++i) {
            const double angle = -0.2 + 4.9 * i / pieces, c = radius * nearest::cos(angle),
                         s = radius * nearest::sin(angle);
            const Space p = letter == 'z'   ? Space{at.x + c, at.y + s, at.z}
                            : letter == 'x' ? Space{at.x, at.y + c, at.z + s}
                                            : Space{at.x + s, at.y, at.z + c};
            spots.push_back(seen(p));
        }
        pen_.axis(seen(at) - 2.5 * unit(seen(axis(letter, 1))), seen(at) + 4 * unit(seen(axis(letter, 1))));
        pen_.curved(spots, name);
    }

    /// The reactions on each axis: a force at the origin, a couple farther out.
    void draw_reactions() {
        const auto& free = pair_.reactions.free;
        const auto carries = [&](const std::string& name) {
            return std::find(free.begin(), free.end(), name) != free.end();
        };
        for (const char letter : {'x', 'y', 'z'}) {
            const Spot along = unit(seen(axis(letter, 1)));
            pen_.axis({0, 0}, 17 * along);
            pen_.name(std::string("{") + letter + "}", 17 * along);
            // In a screw F_z and M_z depend on each other by its lead.
            const bool tied = letter == 'z' && !pair_.reactions.tied.empty();
            const std::string of = std::string("_") + letter;
            if (carries("F" + of) || tied) pen_.force({0, 0}, 8 * along, "{F" + of + "}", tied);
            if (carries("M" + of) || tied) pen_.couple_along(8.6 * along, 14.5 * along, "{M" + of + "}", tied);
        }
        pen_.dot({0, 0});
    }

    PairPen pen_;
    std::string_view key_;
    const SpacePair& pair_;
};

/// The ends of a link with `pairs` pairs.
std::vector<Spot> ends_of_link(int pairs) {
    if (pairs == 2) return {{-9, 5}, {9, -5}};
    if (pairs == 3) return {{-9, 7}, {10, 5}, {-2, -8}};
    return {{-9, 7}, {9, 8}, {10, -6}, {-7, -8}};
}

/// Position on paper for each of up to four bodies of a scheme.
Spot corner_of_scheme(std::size_t body) {
    constexpr std::array<std::array<double, 2>, 4> corners{{{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}};
    return {corners.at(body)[0], corners.at(body)[1]};
}

}  // namespace

Figure plane_pair_figure(const DrawingContext& context, JointKind kind) {
    return PlanePairFigure(context, kind).draw();
}
Figure space_pair_figure(const DrawingContext& context, const SpacePair& pair) {
    return SpacePairFigure(context, pair).draw();
}

Figure closure_figure(const DrawingContext& context, Closure closure) {
    PairPen pen(context, closure == Closure::form ? "closure-form" : "closure-force");
    if (closure == Closure::form) {
        pen.block({0, 0}, {15, 0}, {0, 6.2}, 3);
        pen.paper({{-13, -3.6}, {13, -3.6}, {13, 3.6}, {-13, 3.6}}, 3);
        pen.bar({0, 0}, {-6, -13}, 1);
        pen.wheel({0, 0}, 3.4, 1);
        return pen.figure({54, 38});
    }
    pen.bar({-14, 4.4}, {14, 4.4}, 3);
    pen.bar({0, 0}, {0, -9}, 1);
    pen.wheel({0, 0}, 3.4, 1);
    pen.spring({0, -9}, {0, -19});
    pen.ground({-5, -19}, {5, -19}, {0, -1});
    return pen.figure({54, 38});
}

Figure link_figure(const DrawingContext& context, int pairs) {
    PairPen pen(context, "link-" + std::to_string(pairs));
    const std::vector<Spot> ends = ends_of_link(pairs);
    if (pairs == 2)
        pen.bar(ends[0], ends[1], 1);
    else
        pen.plate(ends, 1);
    for (const Spot& end : ends) pen.pin(end, 1);
    return pen.figure({34, 28});
}

Figure chain_figure(const DrawingContext& context, ChainDrawn chain) {
    PairPen pen(context, chain == ChainDrawn::open     ? "chain-open"
                         : chain == ChainDrawn::closed ? "chain-closed"
                                                       : "chain-mixed");
    const Spot a{-14, 9}, b{-11, -6}, c{9, -9}, d{14, 9}, e{20, -17};
    pen.pivot(a);
    pen.bar(a, b, 1);
    pen.bar(b, c, 2);
    if (chain == ChainDrawn::open) {
        pen.bar(c, e, 3);
    } else {
        pen.pivot(d);
        pen.bar(d, c, 3);
        if (chain == ChainDrawn::mixed) {
            const Spot f = 0.5 * (b + c);
            pen.bar(f, f + Spot{9, -11}, 4);
            pen.pin(f, 4);
        }
        pen.pin(d, 3);
    }
    pen.pin(a, 1);
    pen.pin(b, 2);
    pen.pin(c, 3);
    return pen.figure({50, 38});
}

Figure triple_hinge_figure(const DrawingContext& context, const BinaryScheme* scheme) {
    const std::array<Spot, 3> ways{polar_spot(pi * 0.75), polar_spot(-pi / 2), polar_spot(pi * 0.25)};
    constexpr std::array colours{1, 2, 3};
    constexpr double reach = 13, aside = 5;
    std::string id = "triple-hinge";
    if (scheme)
        for (const auto& hinge : scheme->hinges)
            id += "-" + std::to_string(hinge[0] + 1) + std::to_string(hinge[1] + 1);
    PairPen pen(context, id);
    // A body with both binary pins has one on each side of the original hinge.
    std::array<int, 3> hinges{};
    if (scheme)
        for (const auto& hinge : scheme->hinges)
            for (const int body : hinge) ++hinges.at(static_cast<std::size_t>(body));
    const auto carrier = static_cast<std::size_t>(std::max_element(hinges.begin(), hinges.end()) - hinges.begin());
    const auto place = [&](std::size_t body) {
        if (!scheme || body == carrier) return Spot{};
        return aside * ways.at(body);
    };
    for (std::size_t i = 0; i < 3; ++i) {
        if (scheme && i == carrier) continue;
        pen.bar(place(i), place(i) + reach * ways.at(i), colours.at(i));
    }
    if (scheme) {
        std::vector<Spot> ends{reach * ways.at(carrier)};
        for (std::size_t i = 0; i < 3; ++i)
            if (i != carrier) ends.push_back(place(i));
        pen.plate(ends, colours.at(carrier));
        for (std::size_t i = 0; i < 3; ++i)
            if (i != carrier) pen.pin(place(i), colours.at(i));
    } else {
        pen.bar({0, 0}, reach * ways[0], colours[0]);
        pen.pin({0, 0}, colours[1]);
    }
    for (std::size_t i = 0; i < 3; ++i)
        pen.body_name(std::to_string(i + 1), place(i) + 0.8 * reach * ways.at(i), colours.at(i));
    return pen.figure({38, 38});
}

Figure scheme_figure(const DrawingContext& context, const BinaryScheme& scheme) {
    std::string id = "scheme";
    for (const auto& hinge : scheme.hinges) id += "-" + std::to_string(hinge[0] + 1) + std::to_string(hinge[1] + 1);
    PairPen pen(context, id);
    for (const auto& hinge : scheme.hinges)
        pen.stroke(corner_of_scheme(static_cast<std::size_t>(hinge[0])),
                   corner_of_scheme(static_cast<std::size_t>(hinge[1])));
    for (std::size_t body = 0; body <= scheme.hinges.size(); ++body) {
        pen.body_dot(corner_of_scheme(body), static_cast<int>(body) + 1);
        pen.body_name(std::to_string(body + 1), corner_of_scheme(body), static_cast<int>(body) + 1);
    }
    return pen.figure({24, 24});
}

}  // namespace kinegraph::render
