#include "tests/random_mechanism.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace kinegraph {

int Random::whole(int least, int most) {
    const auto range = static_cast<std::uint64_t>(most - least) + 1;
    // The bias of a remainder of 64 bits is far below anything a test could see.
    return least + static_cast<int>(engine_() % range);
}

double Random::real(double least, double most) { return least + (most - least) * static_cast<double>(engine_() >> 11) * 0x1p-53; }

namespace {

constexpr double pi = 3.14159265358979323846;
const double least_sine = std::sin(6 * pi / 180);  // a little more than the promised 5°: compass places are rounded
constexpr double least_distance = 8;               // mm
constexpr double reach = 150;                      // mm: half the width of the drawing
constexpr int most_bodies = 12;

struct Spot {
    double x = 0, y = 0;
};
Spot operator-(Spot a, Spot b) { return {a.x - b.x, a.y - b.y}; }
Spot operator+(Spot a, Spot b) { return {a.x + b.x, a.y + b.y}; }
Spot operator*(double s, Spot a) { return {s * a.x, s * a.y}; }
double cross(Spot a, Spot b) { return a.x * b.y - a.y * b.x; }
double dot(Spot a, Spot b) { return a.x * b.x + a.y * b.y; }
double length(Spot a) { return std::hypot(a.x, a.y); }
/// Sine of the angle between two lines: 0 where they are parallel.
double sine(Spot a, Spot b) { return std::abs(cross(a, b)) / (length(a) * length(b)); }
Spot turned(Spot a, double angle) {
    return {a.x * std::cos(angle) - a.y * std::sin(angle), a.x * std::sin(angle) + a.y * std::cos(angle)};
}

/// value / 10^digits as a decimal.
std::string decimal(long value, int digits) {
    std::string text = std::to_string(std::labs(value));
    if (digits > 0) {
        const auto places = static_cast<std::size_t>(digits);
        if (text.size() <= places) text.insert(0, places + 1 - text.size(), '0');
        text.insert(text.size() - places, ".");
    }
    return (value < 0 ? "-" : "") + text;
}
std::string tenths(double value) { return decimal(std::lround(value * 10), 1); }
double to_tenths(double value) { return static_cast<double>(std::lround(value * 10)) / 10; }
std::string quoted(const std::string& text) { return "\"" + text + "\""; }
std::string pair(const std::string& a, const std::string& b) { return "[" + a + ", " + b + "]"; }

struct Guide {
    std::string text;
    Spot along;
};

/// The file being written. All lengths in mm.
class Drawing {
public:
    explicit Drawing(Random& random, bool by_compass) : random_(random), by_compass_(by_compass) { bodies_.push_back({"1", {}}); }

    // --- places ------------------------------------------------------------------------------------------------------------
    const Spot& at(int point) const { return points_[static_cast<std::size_t>(point)].spot; }
    const std::string& name(int point) const { return points_[static_cast<std::size_t>(point)].name; }
    bool is_free(Spot spot) const {
        for (const Point& point : points_) {
            if (length(point.spot - spot) < least_distance) return false;
        }
        return true;
    }
    Spot anywhere() { return {to_tenths(random_.real(-reach, reach)), to_tenths(random_.real(-reach, reach))}; }
    std::string unused_name() {
        const std::size_t count = points_.size();
        const std::string letter(1, static_cast<char>('A' + count % 26));
        return count < 26 ? letter : letter + std::to_string(count / 26);
    }
    int add(Spot spot, std::string placement) {
        points_.push_back({unused_name(), spot, std::move(placement)});
        return static_cast<int>(points_.size()) - 1;
    }
    int given(Spot spot) { return add(spot, pair(tenths(spot.x), tenths(spot.y))); }
    /// A further place somewhere: by coordinates, or from points already there.
    std::optional<int> place() {
        for (int attempt = 0; attempt < 40; ++attempt) {
            const Spot spot = anywhere();
            if (!by_compass_ || points_.empty() || random_.chance(40)) {
                if (is_free(spot)) return given(spot);
                continue;
            }
            const int from = any_point();
            const Spot away = spot - at(from);
            if (random_.chance(60)) {
                const double distance = to_tenths(length(away));
                const long degrees = std::lround(std::atan2(away.y, away.x) * 180 / pi * 10);
                const Spot there = at(from) + distance * turned({1, 0}, static_cast<double>(degrees) / 10 * pi / 180);
                if (!is_free(there)) continue;
                return add(there, "{\"from\": " + quoted(name(from)) + ", \"distance\": " + tenths(distance) +
                                      ", \"angle\": " + decimal(degrees, 1) + "}");
            }
            const int to = any_point();
            if (to == from) continue;
            const double ratio = to_tenths(random_.real(-0.6, 1.6));
            const Spot there = at(from) + ratio * (at(to) - at(from));
            if (!is_free(there) || std::abs(there.x) > 2 * reach || std::abs(there.y) > 2 * reach) continue;
            return add(there, "{\"from\": " + quoted(name(from)) + ", \"to\": " + quoted(name(to)) +
                                  ", \"ratio\": " + tenths(ratio) + "}");
        }
        return std::nullopt;
    }
    /// The pin between two arms from `a` and `c`: the angle between the arms away from 0° and 180°.
    std::optional<int> pin_between(int a, int c) {
        for (int attempt = 0; attempt < 60; ++attempt) {
            Spot spot = anywhere();
            if (length(spot - at(a)) < least_distance || length(spot - at(c)) < least_distance) continue;
            if (by_compass_ && random_.chance(70)) {
                const double r = to_tenths(length(spot - at(a))), s = to_tenths(length(spot - at(c)));
                const Spot between = at(c) - at(a);
                const double d = length(between);
                const double along = (d * d + r * r - s * s) / (2 * d);
                const double square = r * r - along * along;
                if (square < 1) continue;
                const bool left = cross(between, spot - at(a)) > 0;
                const Spot unit = 1 / d * between;
                spot = at(a) + along * unit + (left ? 1 : -1) * std::sqrt(square) * Spot{-unit.y, unit.x};
                if (!is_free(spot) || sine(spot - at(a), spot - at(c)) < least_sine) continue;
                return add(spot, "{\"meet\": [{\"circle\": " + quoted(name(a)) + ", \"radius\": " + tenths(r) +
                                     "}, {\"circle\": " + quoted(name(c)) + ", \"radius\": " + tenths(s) + "}], \"side\": \"" +
                                     (left ? "left" : "right") + "\"}");
            }
            if (is_free(spot) && sine(spot - at(a), spot - at(c)) >= least_sine) return given(spot);
        }
        return std::nullopt;
    }
    int any_point() { return random_.whole(0, static_cast<int>(points_.size()) - 1); }

    // --- bodies ------------------------------------------------------------------------------------------------------------
    int body_count() const { return static_cast<int>(bodies_.size()); }
    int add_body(std::vector<int> points) {
        bodies_.push_back({std::to_string(bodies_.size() + 1), std::move(points)});
        return static_cast<int>(bodies_.size()) - 1;
    }
    std::vector<int>& points_of(int body) { return bodies_[static_cast<std::size_t>(body)].points; }
    /// One of a body's points, now and then a new one.
    std::optional<int> point_on(int body) {
        std::vector<int>& points = points_of(body);
        if (!points.empty() && !random_.chance(body == 0 ? 70 : 25))
            return points[static_cast<std::size_t>(random_.whole(0, static_cast<int>(points.size()) - 1))];
        const auto fresh = place();
        if (fresh) points_of(body).push_back(*fresh);
        return fresh;
    }
    void further_point(int body) {
        if (!random_.chance(45)) return;
        if (const auto fresh = place()) points_of(body).push_back(*fresh);
    }
    std::string body_name(int body) const { return bodies_[static_cast<std::size_t>(body)].name; }
    std::string body_pair(int i, int j) const { return pair(quoted(body_name(i)), quoted(body_name(j))); }

    // --- joints ------------------------------------------------------------------------------------------------------------
    /// j hinged to i; now and then on the pin that holds i there already, as one hinge of several bodies.
    void revolute(int point, int i, int j) {
        for (Hinge& hinge : hinges_) {
            const bool holds =
                hinge.point == point && std::find(hinge.bodies.begin(), hinge.bodies.end(), i) != hinge.bodies.end();
            if (holds && random_.chance(50)) return hinge.bodies.push_back(j);
        }
        hinges_.push_back({point, {i, j}, joints_.size()});
        joints_.emplace_back();
    }
    void weld(int point, int i, int j) {
        joints_.push_back("{\"weld\": " + quoted(name(point)) + ", \"bodies\": " + body_pair(i, j) + "}");
    }
    /// i slides on j; returns the joint's name.
    std::string slide(const char* kind, int point, int i, int j, const std::string& along) {
        std::string title = "s" + std::to_string(++slides_);
        joints_.push_back("{\"" + std::string(kind) + "\": " + quoted(name(point)) + ", \"bodies\": " + body_pair(i, j) + ", " +
                          along + ", \"name\": " + quoted(title) + "}");
        return title;
    }
    std::string prismatic(int point, int i, int j, const Guide& guide) {
        return slide("prismatic", point, i, j, "\"along\": " + guide.text);
    }
    std::string pin_slot(int point, int i, int j, const Guide& guide) {
        return slide("pin-slot", point, i, j, "\"along\": " + guide.text);
    }
    std::string pin_in_arc(int point, int i, int j, int centre) {
        return slide("pin-slot", point, i, j, "\"arc\": " + quoted(name(centre)));
    }
    Guide any_guide() {
        if (by_compass_ && random_.chance(50)) {
            const long degrees = random_.whole(-1799, 1800);
            return {decimal(degrees, 1), turned({1, 0}, static_cast<double>(degrees) / 10 * pi / 180)};
        }
        if (points_.size() > 1 && random_.chance(30)) {
            const int from = any_point(), to = any_point();
            if (from != to) return {pair(quoted(name(from)), quoted(name(to))), at(to) - at(from)};
        }
        int dx = 0, dy = 0;
        while (dx == 0 && dy == 0) dx = random_.whole(-9, 9), dy = random_.whole(-9, 9);
        return {pair(std::to_string(dx), std::to_string(dy)), {static_cast<double>(dx), static_cast<double>(dy)}};
    }

    // --- drivers -----------------------------------------------------------------------------------------------------------
    /// A decimal of few digits, not zero.
    std::string speed(double most) {
        long value = 0;
        while (value == 0) value = std::lround(random_.real(-most, most) * 100);
        return decimal(value, 2);
    }
    void spin(int body, int relative_to) {
        std::string text = "{\"body\": " + quoted(body_name(body));
        if (relative_to != 0) text += ", \"relative to\": " + quoted(body_name(relative_to));
        const std::string omega = random_.chance(8) ? quoted(std::to_string(random_.whole(10, 300)) + " rpm") : speed(12);
        drivers_.push_back(text + ", \"omega\": " + omega + ", \"alpha\": " + speed(20) + "}");
    }
    void drive_slide(const std::string& joint) {
        drivers_.push_back("{\"joint\": " + quoted(joint) + ", \"speed\": " + speed(2) + ", \"acceleration\": " + speed(5) + "}");
    }
    void drive_point(int body, int point, const Guide& along) {
        drivers_.push_back("{\"body\": " + quoted(body_name(body)) + ", \"at\": " + quoted(name(point)) +
                           ", \"along\": " + along.text + ", \"speed\": " + speed(2) + ", \"acceleration\": " + speed(5) + "}");
    }
    int driver_count() const { return static_cast<int>(drivers_.size()); }

    std::string text() const {
        std::string out = "{\n  \"kinegraph\": 1,\n  \"units\": {\"length\": \"mm\"},\n  \"frame\": 1,\n  \"points\": {\n";
        for (std::size_t i = 0; i < points_.size(); ++i)
            out += "    " + quoted(points_[i].name) + ": " + points_[i].placement + (i + 1 < points_.size() ? ",\n" : "\n");
        out += "  },\n  \"bodies\": {\n";
        for (std::size_t i = 1; i < bodies_.size(); ++i) {
            out += "    " + quoted(bodies_[i].name) + ": [";
            for (std::size_t k = 0; k < bodies_[i].points.size(); ++k)
                out += (k > 0 ? ", " : "") + quoted(name(bodies_[i].points[k]));
            out += i + 1 < bodies_.size() ? "],\n" : "]\n";
        }
        out += "  },\n  \"joints\": [\n";
        for (std::size_t i = 0; i < joints_.size(); ++i) out += "    " + joint_text(i) + (i + 1 < joints_.size() ? ",\n" : "\n");
        out += "  ],\n  \"drivers\": [";
        for (std::size_t i = 0; i < drivers_.size(); ++i) out += (i > 0 ? ", " : "") + drivers_[i];
        return out + "]\n}\n";
    }

private:
    std::string joint_text(std::size_t index) const {
        for (const Hinge& hinge : hinges_) {
            if (hinge.joint != index) continue;
            std::string names;
            for (const int body : hinge.bodies) names += (names.empty() ? "" : ", ") + quoted(body_name(body));
            return "{\"revolute\": " + quoted(name(hinge.point)) + ", \"bodies\": [" + names + "]}";
        }
        return joints_[index];
    }

    struct Hinge {
        int point = -1;
        std::vector<int> bodies;
        std::size_t joint = 0;  ///< its place among the joints
    };
    struct Point {
        std::string name;
        Spot spot;
        std::string placement;
    };
    struct Body {
        std::string name;
        std::vector<int> points;
    };
    Random& random_;
    bool by_compass_;
    std::vector<Point> points_;
    std::vector<Body> bodies_;
    std::vector<std::string> joints_, drivers_;
    std::vector<Hinge> hinges_;
    int slides_ = 0;
};

/// Adds driven bodies and dyads to a drawing. Each method gives false where its draw was degenerate; the drawing is then
/// thrown away by the caller, which costs nothing and keeps the methods straight.
class Builder {
public:
    explicit Builder(std::uint64_t seed) : random_(seed) {}

    RandomMechanism run() {
        for (int attempt = 0; attempt < 1000; ++attempt) {
            const bool by_compass = random_.chance(35);
            Drawing drawing(random_, by_compass);
            drawing_ = &drawing;
            recipe_.clear();
            if (!driven_body()) continue;
            if (random_.chance(25) && !second_driven_body()) continue;
            const int dyads = random_.whole(0, 5);
            bool sound = true;
            for (int i = 0; i < dyads && sound && drawing.body_count() + 2 <= most_bodies; ++i) sound = dyad();
            if (!sound) continue;
            if (random_.chance(10) && drawing.body_count() < most_bodies && !welded()) continue;
            return {drawing.text(), drawing.body_count(), drawing.driver_count(), by_compass, recipe_};
        }
        throw std::runtime_error("a thousand draws, and all degenerate");
    }

private:
    Drawing& draw() { return *drawing_; }
    void note(const std::string& what) { recipe_ += (recipe_.empty() ? "" : " ") + what; }
    int any_body(int least = 0) { return random_.whole(least, draw().body_count() - 1); }
    /// i on j, or j on i: either may carry the guide.
    std::string sleeve(int point, int i, int j, const Guide& guide) {
        return random_.chance(50) ? draw().prismatic(point, i, j, guide) : draw().prismatic(point, j, i, guide);
    }

    bool driven_body() {
        const auto ground = draw().place();
        if (!ground) return false;
        draw().points_of(0).push_back(*ground);
        if (random_.chance(15)) {
            const int slider = draw().add_body({*ground});
            if (const auto more = draw().place()) draw().points_of(slider).push_back(*more);
            draw().drive_slide(sleeve(*ground, slider, 0, draw().any_guide()));
            note("driven-slider");
            return true;
        }
        return crank(0, *ground);
    }

    bool crank(int on, int pivot) {
        const auto tip = draw().place();
        if (!tip) return false;
        const int body = draw().add_body({pivot, *tip});
        draw().revolute(pivot, on, body);
        draw().further_point(body);
        if (on == 0 && random_.chance(10)) {
            const Guide along = draw().any_guide();
            const Spot arm = draw().at(*tip) - draw().at(pivot);
            // The point moves ⟂ to its arm: the component given must not be that along the arm.
            if (sine(arm, along.along) < least_sine) return false;
            draw().drive_point(body, *tip, along);
            note("crank-by-point");
        } else {
            draw().spin(body, on);
            note(on == 0 ? "crank" : "crank-on-" + draw().body_name(on));
        }
        return true;
    }

    bool second_driven_body() {
        const int on = random_.chance(60) ? any_body(1) : 0;
        const auto point = draw().point_on(on);
        if (!point) return false;
        if (random_.chance(30)) {
            const int slider = draw().add_body({*point});
            draw().further_point(slider);
            draw().drive_slide(sleeve(*point, slider, on, draw().any_guide()));
            note("driven-slider-on-" + draw().body_name(on));
            return true;
        }
        return crank(on, *point);
    }

    bool dyad() {
        const int x = any_body(1);
        int y = any_body();
        // A dyad on two points of one body is at rest on it: rare, and allowed.
        if (y == x && !random_.chance(15)) y = 0;
        switch (random_.whole(0, 7)) {
            case 0:
            case 1:
                return rrr(x, y);
            case 2:
                return random_.chance(50) ? rrp(x, y) : rrp(y, x);
            case 3:
                return random_.chance(50) ? rpr(x, y) : rpr(y, x);
            case 4:
                return random_.chance(50) ? pin_in_slot(x, y) : pin_in_slot(y, x);
            case 5:
                return random_.chance(50) ? arm_in_slot(x, y) : arm_in_slot(y, x);
            case 6:
                return prp(x, y);
            default:
                return random_.chance(50) ? rpp(x, y) : rpp(y, x);
        }
    }

    /// The points that a dyad hangs on: of different bodies, at different places.
    std::optional<std::pair<int, int>> ends(int x, int y) {
        const auto a = draw().point_on(x), c = draw().point_on(y);
        if (!a || !c || length(draw().at(*a) - draw().at(*c)) < least_distance) return std::nullopt;
        return std::pair(*a, *c);
    }

    bool rrr(int x, int y) {
        const auto hung = ends(x, y);
        if (!hung) return false;
        const auto [a, c] = *hung;
        const auto b = draw().pin_between(a, c);
        if (!b) return false;
        const int p = draw().add_body({a, *b}), q = draw().add_body({*b, c});
        draw().further_point(p);
        draw().further_point(q);
        draw().revolute(a, x, p);
        draw().revolute(*b, p, q);
        draw().revolute(c, q, y);
        note("RRR");
        return true;
    }

    bool rrp(int x, int y) {
        const auto a = draw().point_on(x), b = draw().place();
        if (!a || !b) return false;
        const Guide guide = draw().any_guide();
        // v_B ⟂ AB as seen from A, ∥ guide as seen from y: the two must not be parallel.
        const Spot arm = draw().at(*b) - draw().at(*a);
        if (std::abs(dot(arm, guide.along)) < least_sine * length(arm) * length(guide.along)) return false;
        const int p = draw().add_body({*a, *b}), q = draw().add_body({*b});
        int g = *b;
        if (random_.chance(40)) {
            const auto other = draw().place();
            if (!other) return false;
            g = *other;
            draw().points_of(q).push_back(g);
        }
        draw().further_point(p);
        draw().revolute(*a, x, p);
        draw().revolute(*b, p, q);
        sleeve(g, q, y, guide);
        note("RRP");
        return true;
    }

    /// ω common to both links, the slide unknown: the guide must not be ⟂ to the join of the pins.
    bool guides_well(const Guide& guide, int a, int c) {
        const Spot join = draw().at(c) - draw().at(a);
        return std::abs(dot(join, guide.along)) >= least_sine * length(join) * length(guide.along);
    }

    bool rpr(int x, int y) {
        const auto hung = ends(x, y);
        if (!hung) return false;
        const auto [a, c] = *hung;
        const Guide guide = draw().any_guide();
        if (!guides_well(guide, a, c)) return false;
        const auto g = random_.chance(50) ? std::optional(a) : draw().place();
        if (!g) return false;
        const int p = draw().add_body({a}), q = draw().add_body({c});
        if (*g != a) draw().points_of(p).push_back(*g);
        draw().further_point(q);
        draw().revolute(a, x, p);
        draw().revolute(c, q, y);
        sleeve(*g, p, q, guide);
        note("RPR");
        return true;
    }

    /// The pin of x in a slot of a link that turns about c of y.
    bool pin_in_slot(int x, int y) {
        const auto hung = ends(x, y);
        if (!hung) return false;
        const auto [a, c] = *hung;
        const int q = draw().add_body({c});
        draw().further_point(q);
        draw().revolute(c, q, y);
        if (random_.chance(30)) {
            // Curved about k: the pin turns about k as seen from the link, so a, k, c are a dyad's pins.
            const auto k = draw().pin_between(a, c);
            if (!k) return false;
            draw().points_of(q).push_back(*k);
            draw().pin_in_arc(a, x, q, *k);
            note("pin-in-arc");
            return true;
        }
        const Guide guide = draw().any_guide();
        if (!guides_well(guide, a, c)) return false;
        draw().pin_slot(a, x, q, guide);
        note("pin-in-slot");
        return true;
    }

    /// A link pinned to x whose pin b runs in a slot of y.
    bool arm_in_slot(int x, int y) {
        const auto a = draw().point_on(x), b = draw().place();
        if (!a || !b) return false;
        const Spot arm = draw().at(*b) - draw().at(*a);
        const int p = draw().add_body({*a, *b});
        draw().further_point(p);
        draw().revolute(*a, x, p);
        if (random_.chance(30)) {
            const auto k = draw().place();
            if (!k || sine(draw().at(*b) - draw().at(*k), arm) < least_sine) return false;
            draw().points_of(y).push_back(*k);
            draw().pin_in_arc(*b, p, y, *k);
            note("arm-in-arc");
            return true;
        }
        const Guide guide = draw().any_guide();
        if (std::abs(dot(arm, guide.along)) < least_sine * length(arm) * length(guide.along)) return false;
        draw().pin_slot(*b, p, y, guide);
        note("arm-in-slot");
        return true;
    }

    bool prp(int x, int y) {
        const auto b = draw().place();
        if (!b) return false;
        const Guide first = draw().any_guide(), second = draw().any_guide();
        if (sine(first.along, second.along) < least_sine) return false;
        const int p = draw().add_body({*b}), q = draw().add_body({*b});
        const auto g = random_.chance(50) ? b : draw().place();
        if (!g) return false;
        if (*g != *b) draw().points_of(p).push_back(*g);
        draw().further_point(q);
        sleeve(*g, p, x, first);
        draw().revolute(*b, p, q);
        sleeve(*b, q, y, second);
        note("PRP");
        return true;
    }

    bool rpp(int x, int y) {
        const auto a = draw().point_on(x), g = draw().place();
        if (!a || !g) return false;
        const Guide first = draw().any_guide(), second = draw().any_guide();
        if (sine(first.along, second.along) < least_sine) return false;
        const int p = draw().add_body({*a}), q = draw().add_body({*g});
        draw().further_point(q);
        draw().revolute(*a, x, p);
        sleeve(random_.chance(50) ? *a : *g, p, q, first);
        sleeve(*g, q, y, second);
        note("RPP");
        return true;
    }

    bool welded() {
        const int on = any_body(1);
        const auto point = draw().point_on(on);
        if (!point) return false;
        const int body = draw().add_body({*point});
        draw().further_point(body);
        draw().weld(*point, on, body);
        note("weld");
        return true;
    }

    Random random_;
    Drawing* drawing_ = nullptr;
    std::string recipe_;
};

}  // namespace

RandomMechanism random_mechanism(std::uint64_t seed) { return Builder(seed).run(); }

RandomMechanism chain_of_dyads(int dyads, std::uint64_t seed) {
    Random random(seed);
    Drawing drawing(random, false);
    // Crank, then link and rocker again and again: the rocker's far pin carries the next link. Every number has few digits.
    const int pivot = drawing.given({0, 0});
    int carried = drawing.given({30, 40});
    int carrier = drawing.add_body({pivot, carried});
    drawing.points_of(0).push_back(pivot);
    drawing.revolute(pivot, 0, carrier);
    drawing.spin(carrier, 0);
    for (int i = 0; i < dyads; ++i) {
        const double x = 120 * (i + 1);
        const auto jitter = [&] { return static_cast<double>(random.whole(-10, 10)); };
        const int ground = drawing.given({x, jitter()});
        const int pin = drawing.given({x + 10 + jitter(), 80 + jitter()});
        const int next = drawing.given({x + 40 + jitter(), 50 + jitter()});
        const int link = drawing.add_body({carried, pin}), rocker = drawing.add_body({ground, pin, next});
        drawing.points_of(0).push_back(ground);
        drawing.revolute(carried, carrier, link);
        drawing.revolute(pin, link, rocker);
        drawing.revolute(ground, 0, rocker);
        carrier = rocker;
        carried = next;
    }
    return {drawing.text(), drawing.body_count(), 1, false, "chain"};
}

}  // namespace kinegraph
