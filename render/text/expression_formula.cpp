#include "render/text/expression_formula.hpp"

#include <algorithm>
#include <utility>

namespace kinegraph::render {
namespace {

using Kind = Expression::Kind;

class ExpressionSetter {
public:
    ExpressionSetter(const NamedConstants& constants, std::string_view variable, Language language)
        : constants_(constants), variable_(variable), language_(language) {}

    Formula set(const Expression& of) const {
        switch (of.kind) {
            case Kind::number: return number(of.value);
            case Kind::pi: return Formula::upright("π");
            case Kind::constant: return formula_of(constants_[of.constant], language_);
            case Kind::variable: return Formula::letter(variable_);
            case Kind::sum: return sum(of);
            case Kind::product:
            case Kind::power: return product(of);
            case Kind::function: return function(of);
        }
        return {};
    }

private:
    /// An integer, a small fraction, a decimal, or else the exact fraction.
    Formula number(const Exact& value) const {
        const Exact size = abs(value);
        const mpq_class& q = size.rational();
        Formula made;
        if (value.sign() < 0) made += Formula::upright("−");
        constexpr int small = 12;
        if (q.get_den() == 1 || (!(q.get_den() <= small && q.get_num() <= small) && is_short_decimal(size)))
            made += Formula::upright(shortest(size.to_double(), language_));
        else
            made += Formula::fraction(Formula::upright(q.get_num().get_str()), Formula::upright(q.get_den().get_str()));
        return made;
    }
    static bool is_short_decimal(const Exact& value) {
        const Exact scaled = value * 1000000000;
        return scaled.rational().get_den() == 1 && scaled < Exact::power_of_two(52);
    }

    Formula sum(const Expression& of) const {
        Formula made;
        for (const Expression& part : of.parts) {
            const auto [negative, bare] = without_sign(part);
            if (made.empty())
                made += negative ? Formula::upright("−") : Formula();
            else
                made += Formula::sign(negative ? "−" : "+");
            made += bare.kind == Kind::sum ? Formula::fenced(set(bare)) : set(bare);
        }
        return made;
    }
    /// Whether a minus sign leads, and the expression without it.
    static std::pair<bool, Expression> without_sign(const Expression& of) {
        if (of.kind == Kind::number && of.value.sign() < 0) return {true, Expression::number(-of.value)};
        if (of.kind != Kind::product || of.parts[0].kind != Kind::number || of.parts[0].value.sign() >= 0)
            return {false, of};
        Expression bare = of;
        bare.parts[0].value = -bare.parts[0].value;
        if (bare.parts[0].is_number(1)) bare.parts.erase(bare.parts.begin());
        return {true, bare.parts.size() == 1 ? bare.parts[0] : bare};
    }

    /// The factors of numerator and denominator.
    struct Fraction {
        std::vector<Formula> above, below;
        bool negative = false;
    };
    Formula product(const Expression& of) const {
        Fraction fraction;
        gather(of, fraction);
        Formula made;
        if (fraction.negative) made += Formula::upright("−");
        if (fraction.above.empty()) fraction.above.push_back(Formula::upright("1"));
        if (fraction.below.empty()) return made + row(std::move(fraction.above));
        return made + Formula::fraction(alone(std::move(fraction.above)), alone(std::move(fraction.below)));
    }
    static Formula row(std::vector<Formula> factors) {
        Formula made;
        for (Formula& factor : factors) made += std::move(factor);
        return made;
    }
    /// A single term above or below the bar needs no brackets.
    static Formula alone(std::vector<Formula> factors) {
        if (factors.size() == 1 && factors[0].kind == Formula::Kind::fence) return factors[0].parts[0];
        return row(std::move(factors));
    }
    void gather(const Expression& of, Fraction& fraction) const {
        if (of.kind == Kind::product) {
            for (const Expression& part : of.parts) gather(part, fraction);
            return;
        }
        if (of.kind == Kind::number) {
            gather_number(of.value, fraction);
            return;
        }
        if (of.kind != Kind::power) {
            fraction.above.push_back(factor(of));
            return;
        }
        Expression exponent = of.parts[1];
        const auto [negative, positive] = without_sign(exponent);
        std::vector<Formula>& side = negative && exponent.kind == Kind::number ? fraction.below : fraction.above;
        side.push_back(power(of.parts[0], negative && exponent.kind == Kind::number ? positive : exponent));
    }
    void gather_number(const Exact& value, Fraction& fraction) const {
        if (value.sign() < 0) fraction.negative = !fraction.negative;
        const Exact size = abs(value);
        if (size == Exact(1)) return;
        const mpq_class& q = size.rational();
        constexpr int small = 12;
        const bool as_decimal =
            q.get_den() != 1 && !(q.get_den() <= small && q.get_num() <= small) && is_short_decimal(size);
        if (q.get_den() == 1 || as_decimal) {
            fraction.above.push_back(number(size));
            return;
        }
        if (q.get_num() != 1) fraction.above.push_back(Formula::upright(q.get_num().get_str()));
        fraction.below.push_back(Formula::upright(q.get_den().get_str()));
    }
    Formula factor(const Expression& of) const {
        const bool is_quantity = of.kind == Kind::constant && constants_[of.constant].name.empty();
        return of.kind == Kind::sum || is_quantity ? Formula::fenced(set(of)) : set(of);
    }
    Formula power(const Expression& base, const Expression& exponent) const {
        if (exponent.is_number(1)) return factor(base);
        if (exponent.kind == Kind::number && exponent.value == Exact::ratio(1, 2)) return Formula::root(set(base));
        if (base.kind == Kind::function && base.function != Elementary::exp)
            return Formula::power(name_of_function(base.function), set(exponent)) + Formula::fenced(set(base.parts[0]));
        const bool is_piece =
            base.kind == Kind::variable || base.kind == Kind::pi ||
            (base.kind == Kind::constant && !constants_[base.constant].name.empty()) ||
            (base.kind == Kind::number && base.value.sign() >= 0 && base.value.rational().get_den() == 1);
        return Formula::power(is_piece ? set(base) : Formula::fenced(set(base)), set(exponent));
    }
    Formula name_of_function(Elementary function) const {
        std::string name(name_of(function));
        if (function == Elementary::log) name = "ln";
        if (function == Elementary::sin) name = notation(language_).sine;
        if (function == Elementary::asin) name = std::string("a") + notation(language_).sine;
        if (function == Elementary::asin || function == Elementary::acos || function == Elementary::atan)
            name.insert(1, "rc");
        return Formula::upright(name);
    }
    Formula function(const Expression& of) const {
        if (of.function == Elementary::exp) return Formula::power(Formula::letter("e"), set(of.parts[0]));
        if (of.function == Elementary::abs) return Formula::upright("|") + set(of.parts[0]) + Formula::upright("|");
        return name_of_function(of.function) + Formula::fenced(set(of.parts[0]));
    }

    const NamedConstants& constants_;
    std::string_view variable_;
    Language language_;
};

}  // namespace

Formula formula_of(const Expression& of, const NamedConstants& constants, std::string_view variable,
                   Language language) {
    return ExpressionSetter(constants, variable, language).set(of);
}

Formula formula_of(const NamedConstant& constant, Language language) {
    if (constant.name.empty()) {
        std::string text = constant.written;
        std::replace(text.begin(), text.end(), '.', notation(language).decimal_mark);
        return Formula::upright(text);
    }
    const std::size_t digit = constant.name.find_first_of("0123456789_");
    const std::string base = constant.name.substr(0, digit);
    std::string sub = digit == std::string::npos ? "" : constant.name.substr(digit);
    while (sub.starts_with('_')) sub.erase(0, 1);
    return base.empty() ? Formula::letter(constant.name) : Formula::letter(base, sub);
}

}  // namespace kinegraph::render
