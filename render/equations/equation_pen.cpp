#include "render/equations/equation_pen.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <functional>
#include <numbers>

#include "lang/keys/equations.hpp"
#include "lang/keys/notation.hpp"
#include "render/text/formula.hpp"

namespace kinegraph::render::closure {
namespace {

constexpr int digits_of_terms = 5;

/// Without trailing zeros: "200.00 mm" is 200 mm.
std::string trimmed(const std::string& text) {
    const std::size_t mark = text.find_first_of(".,");
    if (mark == std::string::npos) return text;
    std::size_t end = mark + 1;
    while (end < text.size() && text[end] >= '0' && text[end] <= '9') ++end;
    std::size_t keep = end;
    while (text[keep - 1] == '0') --keep;
    if (keep == mark + 1) keep = mark;
    return text.substr(0, keep) + text.substr(end);
}

}  // namespace

Formula joined(const std::vector<Signed>& terms) {
    if (terms.empty()) return Formula::upright("0");
    Formula sum;
    for (std::size_t i = 0; i < terms.size(); ++i) {
        if (i > 0)
            sum += Formula::sign(terms[i].sign < 0 ? "−" : "+");
        else if (terms[i].sign < 0)
            sum += Formula::upright("−");
        sum += terms[i].term;
    }
    return sum;
}

std::string EquationPen::number_text(double number) const {
    return trimmed(render::number(number, digits_of_terms, language_));
}
std::string EquationPen::amount_text(double si, QuantityKind kind) const {
    return trimmed(amount(si, kind, mechanism_.units, language_, digits_of_terms));
}

std::string EquationPen::spoken(LetterIndex index) const {
    return "{" + unicode_letter(letter(index).symbol) + (letter(index).sub.empty() ? "" : "_" + letter(index).sub) +
           "}";
}

std::string EquationPen::as_letter(const std::string& name) {
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    const bool is_one = !name.empty() && std::isalpha(static_cast<unsigned char>(name.front())) != 0 &&
                        std::all_of(name.begin() + 1, name.end(), is_digit);
    if (!is_one) return name;
    return "{" + name.substr(0, 1) + (name.size() > 1 ? "_" + name.substr(1) : "") + "}";
}

std::string EquationPen::amount_of(LetterIndex index, double si, int derived) const {
    if (!letter(index).is_angle) {
        constexpr std::array kinds{QuantityKind::length, QuantityKind::velocity, QuantityKind::acceleration};
        return amount_text(si, kinds.at(static_cast<std::size_t>(derived)));
    }
    if (derived == 0) return amount_text(half_turns_apart(si), QuantityKind::angle);
    if (derived == 1) return amount_text(si, QuantityKind::angular_velocity);
    return number_text(si) + " rad/s²";
}

Formula EquationPen::amount_formula(LetterIndex index, double si, int derived) const {
    return Formula::upright(amount_of(index, si, derived));
}

std::string EquationPen::described(LetterIndex index) const {
    const Letter& own = letter(index);
    const auto body = [&](BodyIndex which) { return mechanism_.body(which).name; };
    if (own.is_angle && own.joint == none && own.body != none)
        return own.against == none
                   ? in(Words(lang::equations::turn_of_body, body(own.body)))
                   : in(Words(lang::equations::turn_of_body_on_body, body(own.body), body(own.against)));
    if (own.is_angle)
        return in(Words(lang::equations::equivalent_link,
                        own.joint == none ? std::string() : mechanism_.joint(own.joint).name));
    if (own.joint != none) return in(Words(lang::equations::slide_at, mechanism_.joint(own.joint).name));
    return in(Words(lang::equations::place, own.name));
}

Formula EquationPen::sum_of(const std::vector<LetterIndex>& letters, int dots) const {
    std::vector<Signed> terms;
    for (const LetterIndex each : letters) terms.push_back({1, name(each, dots)});
    return joined(terms);
}

Formula EquationPen::angle(const Equations::Angle& of) const {
    Formula sum = of.letters.empty() ? Formula() : sum_of(of.letters);
    constexpr std::array<const char*, 4> turned{"0", "90°", "180°", "270°"};
    if (of.quarters == 0) return of.letters.empty() ? Formula::upright("0") : sum;
    Formula quarters = Formula::upright(turned.at(static_cast<std::size_t>(of.quarters)));
    return sum.empty() ? quarters : std::move(sum) + Formula::sign("+") + std::move(quarters);
}

Formula EquationPen::trigonometric(bool sine, Formula of, bool bare) const {
    Formula term = Formula::function(sine ? word(lang::notation::sine_in_equations, language_) : "cos");
    term += bare ? std::move(of) : Formula::fenced(std::move(of));
    return term;
}

std::vector<Signed> EquationPen::terms(const Sum& sum, int sign) const {
    std::vector<Signed> all;
    for (const Term& each : sum) all.push_back(term(each, sign));
    return all;
}

Signed EquationPen::component(LetterIndex length, const Equations::Angle& of, bool sine, int sign) const {
    return projected(name(length), {of.letters, {}, of.quarters}, sine, sign);
}

Signed EquationPen::projected(Formula factor, Difference of, bool sine, int sign) const {
    for (auto own = of.minus.begin(); own != of.minus.end();) {
        const auto same = std::find(of.plus.begin(), of.plus.end(), *own);
        if (same == of.plus.end()) {
            ++own;
            continue;
        }
        of.plus.erase(same);
        own = of.minus.erase(own);
    }
    const int quarters = ((of.quarters + (sine ? 3 : 0)) % 4 + 4) % 4;
    const bool is_sine = quarters % 2 == 1;
    if (quarters == 1 || quarters == 2) sign = -sign;
    if (of.plus.empty() && of.minus.empty()) return is_sine ? Signed{0, {}} : Signed{sign, std::move(factor)};
    std::vector<Signed> sum;
    for (const LetterIndex each : of.plus) sum.push_back({1, name(each)});
    for (const LetterIndex each : of.minus) sum.push_back({-1, name(each)});
    const bool bare = sum.size() == 1 && sum.front().sign > 0;
    return {sign, std::move(factor) + trigonometric(is_sine, joined(sum), bare)};
}

std::vector<Side> EquationPen::known_sides(const Equations::Loop& loop) const {
    std::vector<Side> known;
    for (int i = 0; i < static_cast<int>(loop.sides.size()); ++i)
        if (i != loop.solved.first && i != loop.solved.second) known.push_back(loop.sides[at_index(i)]);
    return known;
}

std::vector<LetterIndex> EquationPen::turning(const Side& of) const {
    std::vector<LetterIndex> letters;
    for (const LetterIndex each : of.angle.letters)
        if (letter(each).role != Letter::Role::given) letters.push_back(each);
    return letters;
}

Formula EquationPen::rate_of(const std::vector<LetterIndex>& letters, int dots, bool squared) const {
    Formula sum = sum_of(letters, dots);
    if (letters.size() > 1) sum = Formula::fenced(std::move(sum));
    return squared ? square(std::move(sum)) : sum;
}

Signed EquationPen::exponential(int sign, Formula factor, const Equations::Angle& of, int more) const {
    const int quarters = (of.quarters + more) % 4;
    Formula term;
    if (quarters % 2 == 1) term += imaginary();
    term += std::move(factor);
    if (!of.letters.empty()) term += turned(of.letters);
    return {quarters >= 2 ? -sign : sign, std::move(term)};
}

void EquationPen::add_velocity(const Side& of, std::vector<Signed>& terms, int sign) const {
    if (slides(of)) terms.push_back(exponential(sign, name(of.length, 1), of.angle));
    if (const auto turns = turning(of); !turns.empty())
        terms.push_back(exponential(sign, name(of.length) + rate_of(turns, 1), of.angle, 1));
}

void EquationPen::add_acceleration(const Side& of, std::vector<Signed>& terms, int sign) const {
    const auto turns = turning(of);
    if (slides(of)) terms.push_back(exponential(sign, name(of.length, 2), of.angle));
    if (turns.empty()) return;
    terms.push_back(exponential(sign, name(of.length) + rate_of(turns, 2), of.angle, 1));
    terms.push_back(exponential(-sign, name(of.length) + rate_of(turns, 1, true), of.angle));
    if (slides(of))
        terms.push_back(exponential(sign, Formula::upright("2") + name(of.length, 1) + rate_of(turns, 1), of.angle, 1));
}

Formula EquationPen::law_sum(const Equations::Law& law, const std::function<Formula(LetterIndex)>& of) const {
    std::vector<Signed> terms;
    for (const Equations::Law::Part& part : law.parts) {
        std::vector<Signed> sum;
        for (const auto& [sign, each] : part.sum) sum.push_back({sign, of(each)});
        Formula inner = joined(sum);
        if (part.radius >= 0)
            inner = name(part.radius) + (sum.size() > 1 ? Formula::fenced(std::move(inner)) : std::move(inner));
        terms.push_back({part.sign, std::move(inner)});
    }
    return joined(terms);
}

double EquationPen::half_turns_apart(double angle) {
    return std::abs(angle + std::numbers::pi) < 1e-12 ? std::numbers::pi : std::abs(angle) < 1e-15 ? 0 : angle;
}

Formula EquationPen::turned(const std::vector<LetterIndex>& letters) const {
    if (letters.empty()) return {};
    Formula exponent = imaginary();
    exponent += letters.size() > 1 ? Formula::fenced(sum_of(letters)) : sum_of(letters);
    return Formula::power(Formula::letter("e"), std::move(exponent));
}

Signed EquationPen::term(const Term& of, int sign) const {
    Formula made;
    const int size = std::abs(of.coefficient);
    if (size != 1) made += Formula::upright(std::to_string(size));
    for (const LetterIndex each : of.lengths) made += name(each);
    for (const Term::Rate& rate : of.rates) {
        Formula sum = sum_of(rate.sum, rate.dots);
        if (rate.sum.size() > 1) sum = Formula::fenced(std::move(sum));
        made += rate.power == 2 ? square(std::move(sum)) : std::move(sum);
    }
    if (of.turn != Term::Turn::plain)
        made += trigonometric(of.turn == Term::Turn::sin, sum_of(of.angle), of.angle.size() == 1);
    if (made.empty()) made = Formula::upright("1");
    return {of.coefficient < 0 ? -sign : sign, std::move(made)};
}

}  // namespace kinegraph::render::closure
