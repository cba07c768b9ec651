#include "render/equations/chapters.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/solution/solution.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/equations.hpp"
#include "lang/keys/notation.hpp"
#include "render/equations/equation_chapters.hpp"
#include "render/text/formula.hpp"

namespace kinegraph::render {
namespace {

using Apart = RelativeMotion::Apart;

class ApartText : closure::EquationList {
public:
    ApartText(const Solution& solution, const RelativeMotion& motion, Language language)
        : EquationList(language),
          mechanism_(solution.mechanism),
          pose_(solution.pose),
          motion_(motion),
          apart_(*motion.apart),
          language_(language) {}

    std::vector<EquationItem> items() {
        write_axes();
        write_transport();
        write_seen();
        write_coriolis();
        return taken();
    }

private:
    std::string in(const Words& words) const { return kinegraph::in(words, language_); }
    const std::string& body() const { return mechanism_.body(motion_.query.observer).name; }
    const std::string& point() const { return mechanism_.point(motion_.query.point).name; }
    const std::string& origin() const { return mechanism_.point(apart_.origin).name; }
    std::string wedge() const { return std::string(" ") + notation(language_).cross_product + " "; }
    /// "AB", "O_2 A": the vector from the first point to the second.
    Formula reach() const { return Formula::fenced(named(point()) + Formula::sign("−") + named(origin())); }
    static Formula named(const std::string& name) {
        std::size_t stem = name.size();
        while (stem > 1 && name[stem - 1] >= '0' && name[stem - 1] <= '9') --stem;
        return Formula::letter(name.substr(0, stem), name.substr(stem));
    }
    Formula omega() const { return Formula::letter("omega", body()); }
    Formula alpha() const {
        return Formula::letter(letter_spelt(notation(language_).alpha), body(), notation(language_).alpha_dots);
    }
    static Formula upright(const std::string& text) { return Formula::upright(text); }
    std::string amount_of(double si, QuantityKind kind) const { return amount(si, kind, mechanism_.units, language_); }
    static Formula equal(Formula left, Formula right) {
        return std::move(left) + Formula::sign("=") + std::move(right);
    }

    void write_axes() {
        heading(Words(lang::equations::seen_from_body, body()));
        if (apart_.towards == none)
            say(Words(lang::equations::moving_axes_on_body_origin_x, body(), origin()));
        else
            say(Words(lang::equations::moving_axes_on_body_origin_x_towards, body(), origin(),
                      mechanism_.point(apart_.towards).name));
        set(equal(omega(), upright(amount_of(apart_.omega->to_double(), QuantityKind::angular_velocity))) +
            upright(",  ") + equal(alpha(), upright(number(apart_.alpha->to_double(), 4, language_) + " rad/s²")));
        announce({lang::equations::their_unit_vectors_change_by_poisson});
        const auto rate = [](const char* of) {
            return Formula::fraction(upright("d") + Formula::letter(of) + upright("′"),
                                     upright("d") + Formula::letter("t"));
        };
        const auto turned = [&](const char* of) {
            return omega() + upright(wedge()) + Formula::letter(of) + upright("′");
        };
        set(equal(equal(rate("i"), turned("i")), omega() + Formula::letter("j") + upright("′")) + upright(",   ") +
            equal(equal(rate("j"), turned("j")), upright("−") + omega() + Formula::letter("i") + upright("′")));
    }

    struct Term {
        Formula name, rule;
        Vector value;
    };
    void add_rows(std::vector<std::vector<Formula>>& rows, std::vector<Term> terms, QuantityKind kind) const {
        double largest = 0;
        for (const Term& each : terms) largest = std::max(largest, length(each.value));
        const auto clean = [&](double value) { return std::abs(value) <= 1e-14 * largest ? 0 : value; };
        const Unit unit = suitable_unit(largest, kind, mechanism_.units);
        const double si = unit.si.to_double();
        const auto written = [&](double value) { return number(clean(value) / si, 4, language_); };
        for (Term& each : terms)
            rows.push_back(
                {std::move(each.name), std::move(each.rule),
                 upright(pair_of(written(each.value.x.to_double()), written(each.value.y.to_double()), language_)),
                 upright(written(length(each.value)) + " " + unit.symbol)});
    }
    void write_transport() {
        announce(Words(lang::equations::the_transport_of_the_motion, point(), body(), origin()));
        std::vector<std::vector<Formula>> rows{{upright(in({lang::equations::term})), upright(""),
                                                upright("(x" + in({lang::notation::semicolon}) + "y)"),
                                                upright(in({lang::common::magnitude}))}};
        const auto v = [&](const std::string& sub) { return Formula::letter("v", sub); };
        const auto a = [&](const std::string& sub) { return Formula::letter("a", sub); };
        const Formula square = Formula::power(Formula::letter("omega", body()), upright("2"));
        const Notation& own = notation(language_);
        const std::string &tr = own.transport, &rel = own.relative, &cor = own.coriolis;
        add_rows(rows,
                 {{v(origin()), upright(in({lang::equations::of_the_origin})), *apart_.origin_velocity},
                  {Formula::letter("v", "r"), omega() + upright(wedge()) + reach(), *apart_.turning_velocity},
                  {v(tr), v(origin()) + Formula::sign("+") + v("r"), *motion_.transport_velocity},
                  {v(rel), upright(in({lang::equations::seen_by_the_observer})), *motion_.relative_velocity},
                  {v(point()), v(tr) + Formula::sign("+") + v(rel), *motion_.velocity}},
                 QuantityKind::velocity);
        add_rows(
            rows,
            {{a(origin()), upright(in({lang::equations::of_the_origin})), *apart_.origin_acceleration},
             {a("t"), alpha() + upright(wedge()) + reach(), *apart_.tangential},
             {a("n"), upright("−") + square + reach(), *apart_.normal},
             {a(tr), a(origin()) + Formula::sign("+") + a("t") + Formula::sign("+") + a("n"),
              *motion_.transport_acceleration},
             {a(cor), upright("2 ") + omega() + upright(wedge()) + v(rel), *motion_.coriolis},
             {a(rel), upright(in({lang::equations::seen_by_the_observer})), *motion_.relative_acceleration},
             {a(point()), a(tr) + Formula::sign("+") + a(cor) + Formula::sign("+") + a(rel), *motion_.acceleration}},
            QuantityKind::acceleration);
        table(std::move(rows));
    }

    Vector axis() const {
        return apart_.towards == none ? Vector{1, 0} : pose_.at(apart_.towards) - pose_.at(apart_.origin);
    }
    /// "ẋ′ = 0.64 m/s".
    Formula component(const char* letter, int dots, double size, const Exact& sense, QuantityKind kind) const {
        return equal(Formula::letter(letter, "", dots) + upright("′"),
                     upright(amount_of(std::copysign(size, sense.to_double()), kind)));
    }
    void write_seen() {
        announce({lang::equations::in_the_moving_axes_whose_unit});
        const Vector x = axis();
        const auto line = [&](int dots, const Recorded<Vector>& along, const Recorded<Vector>& across,
                              QuantityKind kind) {
            set(component("x", dots, length(*along), dot(*along, x), kind) + upright(",   ") +
                component("y", dots, length(*across), cross(x, *across), kind));
        };
        line(1, apart_.velocity_along, apart_.velocity_across, QuantityKind::velocity);
        line(2, apart_.acceleration_along, apart_.acceleration_across, QuantityKind::acceleration);
    }
    void write_coriolis() {
        switch (apart_.no_coriolis) {
            case Apart::NoCoriolis::there_is:
                return say(apart_.omega->sign() > 0
                               ? Words(lang::equations::coriolis_acceleration_is_v_rel_turned, body())
                               : Words(lang::equations::coriolis_acceleration_is_v_rel_turned_by, body()));
            case Apart::NoCoriolis::observer_does_not_turn:
                return say(apart_.alpha->is_zero()
                               ? Words(lang::equations::coriolis_acceleration_vanishes_because_body, body())
                               : Words(lang::equations::coriolis_acceleration_vanishes_because_0, body()));
            case Apart::NoCoriolis::rests_for_observer:
                return say(Words(lang::equations::coriolis_acceleration_vanishes_because_rests, point()));
        }
    }

    const Mechanism& mechanism_;
    const Pose& pose_;
    const RelativeMotion& motion_;
    const Apart& apart_;
    Language language_;
};

}  // namespace

std::vector<EquationItem> apart_items(const Solution& solution, std::size_t index, Language language) {
    return ApartText(solution, solution.relative_motion[index], language).items();
}

}  // namespace kinegraph::render
