#include "tests/support/random_mechanism.hpp"

#include <cmath>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "tests/support/random_drawing.hpp"

namespace kinegraph {

int Random::whole(int least, int most) {
    const auto range = static_cast<std::uint64_t>(most - least) + 1;
    // The bias of the remainder of 64 bits is negligible.
    return least + static_cast<int>(engine_() % range);
}

double Random::real(double least, double most) {
    return least + (most - least) * static_cast<double>(engine_() >> 11) * 0x1p-53;
}

namespace {

constexpr int most_bodies = 12;

/// Adds driven bodies and dyads to a drawing. A method returns false if its random values are degenerate; the caller
/// then discards the whole drawing, which costs little and keeps the methods simple.
class Builder {
public:
    explicit Builder(std::uint64_t seed) : random_(seed) {}

    RandomMechanism run() {
        for (int attempt = 0; attempt < 1000; ++attempt) {
            const bool by_compass = random_.chance(35);
            RandomDrawing drawing(random_, by_compass);
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
    RandomDrawing& draw() { return *drawing_; }
    void note(const std::string& what) { recipe_ += (recipe_.empty() ? "" : " ") + what; }
    int any_body(int least = 0) { return random_.whole(least, draw().body_count() - 1); }
    /// i on j, or j on i: either body may have the guide.
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
            // The point moves ⟂ to its arm, so the given component must not be along the arm.
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
        // A dyad on two points of one body is at rest relative to it: allowed, but rare.
        if (y == x && !random_.chance(15)) y = 0;
        switch (random_.whole(0, 7)) {
            case 0:
            case 1: return rrr(x, y);
            case 2: return random_.chance(50) ? rrp(x, y) : rrp(y, x);
            case 3: return random_.chance(50) ? rpr(x, y) : rpr(y, x);
            case 4: return random_.chance(50) ? pin_in_slot(x, y) : pin_in_slot(y, x);
            case 5: return random_.chance(50) ? arm_in_slot(x, y) : arm_in_slot(y, x);
            case 6: return prp(x, y);
            default: return random_.chance(50) ? rpp(x, y) : rpp(y, x);
        }
    }

    /// The end points of a dyad: on different bodies, at different places.
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
        // v_B ⟂ AB as seen from A, ∥ guide as seen from y: these must not be parallel.
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

    /// Both links have the same ω and the sliding is unknown: the guide must not be ⟂ to the line of the pins.
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

    /// A pin of x in a slot of a link hinged to y at c.
    bool pin_in_slot(int x, int y) {
        const auto hung = ends(x, y);
        if (!hung) return false;
        const auto [a, c] = *hung;
        const int q = draw().add_body({c});
        draw().further_point(q);
        draw().revolute(c, q, y);
        if (random_.chance(30)) {
            // A curved slot with centre k: seen from the link the pin turns about k, so a, k, c are the pins of a dyad.
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

    /// A link hinged to x whose pin b moves in a slot of y.
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
    RandomDrawing* drawing_ = nullptr;
    std::string recipe_;
};

}  // namespace

RandomMechanism random_mechanism(std::uint64_t seed) { return Builder(seed).run(); }

RandomMechanism chain_of_dyads(int dyads, std::uint64_t seed) {
    Random random(seed);
    RandomDrawing drawing(random, false);
    // Crank, then link and rocker repeatedly; the rocker's far pin carries the next link. Every number has few digits.
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

bool hold_quarter(int quarter, int count, const std::function<bool(std::uint64_t)>& hold,
                  const std::function<bool()>& failed) {
    if (const char* one = std::getenv("KINEGRAPH_SEED")) {
        if (quarter == 0) hold(std::strtoull(one, nullptr, 10));
        return true;
    }
    if (const char* asked = std::getenv("KINEGRAPH_RANDOM_MECHANISMS")) count = std::atoi(asked);
    int held = 0;
    for (int seed = quarter; held < count / 4 && !failed(); seed += 4) {
        // Most draws are valid; four times as many attempts are enough.
        if (seed >= 4 * count + 400) return false;
        held += hold(static_cast<std::uint64_t>(seed)) ? 1 : 0;
    }
    return true;
}

}  // namespace kinegraph
