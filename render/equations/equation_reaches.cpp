#include "render/equations/equation_chapters.hpp"

#include <cmath>
#include <string>

#include "engine/equations/equations_values.hpp"
#include "lang/keys/equations.hpp"
#include "lang/keys/notation.hpp"

namespace kinegraph::render::closure {

void ReachText::write_reaches() {
    for (const Equations::Reach& reach : e_.reaches) {
        const std::string point = mechanism_.point(reach.point).name;
        list_.heading(Words(lang::equations::open_chain, point));
        std::vector<Signed> place, velocity;
        for (const Side& each : reach.sides) {
            const int sign = each.on_the_right ? -1 : 1;
            place.push_back(pen_.side(each, sign));
            pen_.add_velocity(each, velocity, sign);
        }
        list_.set(equal(Formula::letter("z", point), joined(place)));
        if (!write_groups(reach)) {
            std::vector<Signed> acceleration;
            for (const Side& each : reach.sides) pen_.add_acceleration(each, acceleration, each.on_the_right ? -1 : 1);
            list_.set(equal(Formula::letter("z", point, 1), joined(velocity)));
            list_.set(equal(Formula::letter("z", point, 2), joined(acceleration)));
        }
    }
}

Formula ReachText::complex(const std::array<double, 2>& of, QuantityKind kind) const {
    const Unit unit = kind == QuantityKind::velocity ? mechanism_.units.velocity : mechanism_.units.acceleration;
    const double si = unit.si.to_double();
    return Formula::fenced(pen_.value(of[0] / si) + Formula::sign(of[1] < 0 ? "−" : "+") + pen_.imaginary() +
                           pen_.value(std::abs(of[1]) / si)) +
           Formula::upright(" " + unit.symbol);
}

bool ReachText::write_groups(const Equations::Reach& reach) {
    const std::vector<LetterIndex> letters = pen_.turning(reach.sides.back());
    if (letters.size() < 2) return false;
    const LetterIndex own = letters.back();
    const std::vector<LetterIndex> others(letters.begin(), letters.end() - 1);
    const std::string point = mechanism_.point(reach.point).name;
    const BodyIndex observer = pen_.letter(own).against;
    list_.announce(Words(lang::equations::with_the_terms_in_apart, pen_.spoken(own),
                         observer == none ? std::string("?") : mechanism_.body(observer).name));
    Group transport, relative, coriolis;
    std::vector<Signed> v_t, v_r;
    std::array<double, 2> vt{0, 0}, vr{0, 0};
    for (const Side& each : reach.sides) {
        const auto turns = pen_.turning(each);
        std::vector<LetterIndex> carried;
        for (const LetterIndex of : turns)
            if (of != own) carried.push_back(of);
        const bool moves = carried.size() != turns.size();
        const std::array<double, 2> z = value_of(e_, each);
        const double w = rate(carried, 1), a = rate(carried, 2), b = pen_.letter(own).rate.value_or(0),
                     b2 = pen_.letter(own).acceleration.value_or(0);
        v_t.push_back(pen_.exponential(1, pen_.name(each.length) + pen_.rate_of(carried, 1), each.angle, 1));
        add(vt, z, 0, w);
        transport.add(pen_.exponential(1, pen_.name(each.length) + pen_.rate_of(carried, 2), each.angle, 1));
        transport.add(pen_.exponential(-1, pen_.name(each.length) + pen_.rate_of(carried, 1, true), each.angle));
        add(transport.value, z, -w * w, a);
        if (!moves) continue;
        v_r.push_back(pen_.exponential(1, pen_.name(each.length) + pen_.name(own, 1), each.angle, 1));
        add(vr, z, 0, b);
        relative.add(pen_.exponential(1, pen_.name(each.length) + pen_.name(own, 2), each.angle, 1));
        relative.add(pen_.exponential(-1, pen_.name(each.length) + square(pen_.name(own, 1)), each.angle));
        add(relative.value, z, -b * b, b2);
        coriolis.add(pen_.exponential(
            -1, Formula::upright("2") + pen_.name(each.length) + pen_.rate_of(carried, 1) + pen_.name(own, 1),
            each.angle));
        add(coriolis.value, z, -2 * w * b, 0);
    }
    const auto line = [&](const char* symbol, const std::string& kind, const std::vector<Signed>& terms,
                          const std::array<double, 2>& of, QuantityKind quantity) {
        list_.set(equal(Formula::letter(symbol, kind), joined(terms)) + Formula::sign("=") + complex(of, quantity));
    };
    const std::string t = pen_.in({lang::notation::transport}), r = pen_.in({lang::notation::relative}),
                      c = pen_.in({lang::notation::coriolis});
    line("v", t, v_t, vt, QuantityKind::velocity);
    line("v", r, v_r, vr, QuantityKind::velocity);
    line("a", t, transport.terms, transport.value, QuantityKind::acceleration);
    line("a", r, relative.terms, relative.value, QuantityKind::acceleration);
    line("a", c, coriolis.terms, coriolis.value, QuantityKind::acceleration);
    list_.set(equal(Formula::letter("v", point), complex({vt[0] + vr[0], vt[1] + vr[1]}, QuantityKind::velocity)));
    list_.set(equal(Formula::letter("a", point), complex({transport.value[0] + relative.value[0] + coriolis.value[0],
                                                          transport.value[1] + relative.value[1] + coriolis.value[1]},
                                                         QuantityKind::acceleration)));
    return true;
}

void ReachText::add(std::array<double, 2>& to, const std::array<double, 2>& z, double radial, double across) {
    to[0] += radial * z[0] - across * z[1];
    to[1] += radial * z[1] + across * z[0];
}

double ReachText::rate(const std::vector<LetterIndex>& letters, int dots) const {
    double sum = 0;
    for (const LetterIndex each : letters)
        sum += (dots == 1 ? pen_.letter(each).rate : pen_.letter(each).acceleration).value_or(0);
    return sum;
}

}  // namespace kinegraph::render::closure
