// Formulas of the closure equations: letters, angles, sides of loops, their derivatives and terms, and the description
// and value of a letter. Independent of how they are combined into a text.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "engine/equations/equations.hpp"
#include "engine/file/units.hpp"
#include "render/text/math.hpp"
#include "render/text/words.hpp"

namespace kinegraph::render::closure {

using Letter = Equations::Letter;
using LetterIndex = Equations::LetterIndex;
using Side = Equations::Side;
using Term = Equations::Term;
using Sum = Equations::Sum;
using Solved = Equations::Solved;

/// Signed terms of a sum.
struct Signed {
    int sign = 1;
    Formula term;
};
Formula joined(const std::vector<Signed>& terms);
inline Formula equal(Formula left, Formula right) { return std::move(left) + Formula::sign("=") + std::move(right); }
inline Formula column(std::vector<Formula> entries) { return Formula::matrix(std::move(entries), 1); }
inline Formula square(Formula of) { return Formula::power(std::move(of), Formula::upright("2")); }

/// The argument of a signed sine or cosine: plus − minus + quarters · 90°.
struct Difference {
    std::vector<LetterIndex> plus, minus;
    int quarters = 0;
};

class EquationPen {
public:
    EquationPen(const Equations& equations, const Mechanism& mechanism, Language language)
        : e_(equations), mechanism_(mechanism), language_(language) {}

    /// Without trailing zeros.
    std::string number_text(double number) const;
    std::string amount_text(double si, QuantityKind kind) const;

    Language language() const { return language_; }
    std::string in(const Words& words) const { return kinegraph::in(words, language_); }
    const Letter& letter(LetterIndex index) const { return e_.letter(index); }
    Formula name(LetterIndex index, int dots = 0) const {
        return Formula::letter(letter(index).symbol, letter(index).sub, dots);
    }
    /// In braces, which make it a letter in a sentence's template.
    std::string spoken(LetterIndex index) const;
    /// A name of one letter and digits as one symbol, "O2" as O₂; other names unchanged.
    static std::string as_letter(const std::string& name);
    Formula value(double number) const { return Formula::upright(number_text(number)); }
    std::string amount_of(LetterIndex index, double si, int derived) const;
    Formula amount_formula(LetterIndex index, double si, int derived) const;
    std::string described(LetterIndex index) const;
    Formula sum_of(const std::vector<LetterIndex>& letters, int dots = 0) const;
    Formula angle(const Equations::Angle& of) const;
    static Formula imaginary() { return Formula::letter("i"); }
    Signed side(const Side& of, int sign = 1) const { return exponential(sign, name(of.length), of.angle); }
    Formula trigonometric(bool sine, Formula of, bool bare) const;
    std::vector<Signed> terms(const Sum& sum, int sign = 1) const;
    /// length · cos or length · sin; sign 0 if it vanishes.
    Signed component(LetterIndex length, const Equations::Angle& of, bool sine, int sign) const;
    /// factor · cos or factor · sin of a difference.
    Signed projected(Formula factor, Difference of, bool sine, int sign) const;
    /// The known sides of a loop, with the signs of the sum that equals the unknown sides.
    std::vector<Side> known_sides(const Equations::Loop& loop) const;
    static int sign_of(const Side& known, const Side& lead) { return known.on_the_right == lead.on_the_right ? -1 : 1; }
    std::string numbered(std::size_t index) const {
        return e_.loops.size() > 1 ? std::to_string(index + 1) : std::string();
    }
    std::vector<LetterIndex> turning(const Side& of) const;
    bool slides(const Side& of) const { return letter(of.length).role != Letter::Role::given; }
    Formula rate_of(const std::vector<LetterIndex>& letters, int dots, bool squared = false) const;
    /// factor · e^{i(angle + more quarters)}; quarter turns become factors i, −1, −i.
    Signed exponential(int sign, Formula factor, const Equations::Angle& of, int more = 0) const;
    void add_velocity(const Side& of, std::vector<Signed>& terms, int sign) const;
    void add_acceleration(const Side& of, std::vector<Signed>& terms, int sign) const;
    Formula law_sum(const Equations::Law& law, const std::function<Formula(LetterIndex)>& of) const;

private:
    /// −180° becomes 180°.
    static double half_turns_apart(double angle);
    /// e^{iθ}; empty if θ consists of quarter turns only.
    Formula turned(const std::vector<LetterIndex>& letters) const;
    Signed term(const Term& of, int sign = 1) const;

    const Equations& e_;
    const Mechanism& mechanism_;
    Language language_;
};

}  // namespace kinegraph::render::closure
