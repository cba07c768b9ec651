// Derivatives by GiNaC: expressions are converted to GiNaC and back. The result is sorted in our own order, since
// GiNaC's depends on addresses. GiNaC's reference counts are not thread-safe: a mutex admits one thread at a time.
#include <ginac/ginac.h>

#include <algorithm>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "engine/file/expression.hpp"
#include "lang/keys/expressions.hpp"

namespace kinegraph {
namespace {

using Kind = Expression::Kind;

/// An expression that our type cannot represent.
struct Unwritable : std::runtime_error {
    using std::runtime_error::runtime_error;
};

class Translator {
public:
    explicit Translator(const NamedConstants& constants) : constants_(constants), variable_("t") {
        for (std::size_t i = 0; i < constants.size(); ++i) symbols_.emplace_back("c" + std::to_string(i));
    }
    const GiNaC::realsymbol& variable() const { return variable_; }

    GiNaC::ex there(const Expression& of) const {
        switch (of.kind) {
            case Kind::number: return GiNaC::numeric(of.value.to_fraction().c_str());
            case Kind::pi: return GiNaC::Pi;
            case Kind::constant: return symbols_.at(of.constant);
            case Kind::variable: return variable_;
            case Kind::sum: {
                GiNaC::exvector terms;
                for (const Expression& part : of.parts) terms.push_back(there(part));
                return GiNaC::add(terms);
            }
            case Kind::product: {
                GiNaC::exvector factors;
                for (const Expression& part : of.parts) factors.push_back(there(part));
                return GiNaC::mul(factors);
            }
            case Kind::power: return GiNaC::pow(there(of.parts[0]), there(of.parts[1]));
            case Kind::function: return function(of.function, there(of.parts[0]));
        }
        return 0;
    }

    Expression back(const GiNaC::ex& of) {
        constexpr int most = 20000;
        if (++count_ > most) throw Unwritable("too long");
        if (GiNaC::is_a<GiNaC::numeric>(of)) return number(GiNaC::ex_to<GiNaC::numeric>(of));
        if (of.is_equal(GiNaC::Pi)) return Expression::of(Kind::pi);
        if (of.is_equal(variable_)) return Expression::of(Kind::variable);
        if (GiNaC::is_a<GiNaC::symbol>(of)) {
            for (std::size_t i = 0; i < symbols_.size(); ++i)
                if (of.is_equal(symbols_[i])) return Expression::named(i);
        }
        if (GiNaC::is_a<GiNaC::add>(of)) return sorted(Kind::sum, of);
        if (GiNaC::is_a<GiNaC::mul>(of)) return sorted(Kind::product, of);
        if (GiNaC::is_a<GiNaC::power>(of)) return power_back(back(of.op(0)), back(of.op(1)));
        if (GiNaC::is_a<GiNaC::function>(of)) return function_back(of);
        throw Unwritable("no expression");
    }

private:
    static Expression number(const GiNaC::numeric& value) {
        if (!value.is_rational()) throw Unwritable("not real");
        std::string top, below;
        const auto text = [](const GiNaC::numeric& whole) {
            std::ostringstream stream;
            stream.imbue(std::locale::classic());
            stream << whole;
            return stream.str();
        };
        return Expression::number(Exact(mpq_class(mpz_class(text(value.numer())), mpz_class(text(value.denom())))));
    }
    static GiNaC::ex function(Elementary function, const GiNaC::ex& u) {
        switch (function) {
            case Elementary::sin: return GiNaC::sin(u);
            case Elementary::cos: return GiNaC::cos(u);
            case Elementary::tan: return GiNaC::tan(u);
            case Elementary::asin: return GiNaC::asin(u);
            case Elementary::acos: return GiNaC::acos(u);
            case Elementary::atan: return GiNaC::atan(u);
            case Elementary::sinh: return GiNaC::sinh(u);
            case Elementary::cosh: return GiNaC::cosh(u);
            case Elementary::tanh: return GiNaC::tanh(u);
            case Elementary::exp: return GiNaC::exp(u);
            case Elementary::log: return GiNaC::log(u);
            case Elementary::abs: return GiNaC::abs(u);
        }
        return 0;
    }
    Expression function_back(const GiNaC::ex& of) {
        const std::string name = GiNaC::ex_to<GiNaC::function>(of).get_name();
        if (name == "abs") return Expression::of(Elementary::abs, back(of.op(0)));
        const auto known = elementary_called(name);
        if (!known || of.nops() != 1) throw Unwritable("no expression");
        return Expression::of(*known, back(of.op(0)));
    }
    /// GiNaC gives a sum that is a factor, or raised to an integer power, the sign that its own order of terms
    /// suggests. This restores the sign of our order.
    Expression power_back(Expression base, Expression exponent) const {
        const bool is_whole = exponent.kind == Kind::number && exponent.value.rational().get_den() == 1;
        if (base.kind != Kind::sum || !is_whole || !first_is_negative(base))
            return Expression::of(Kind::power, {std::move(base), std::move(exponent)});
        turn_over(base);
        const bool is_odd = mpz_odd_p(exponent.value.rational().get_num_mpz_t()) != 0;
        Expression power = Expression::of(Kind::power, {std::move(base), std::move(exponent)});
        if (!is_odd) return power;
        return Expression::of(Kind::product, {Expression::number(-1), std::move(power)});
    }
    void turn_over(Expression& sum) const {
        for (Expression& term : sum.parts) term = opposite(std::move(term));
        std::stable_sort(sum.parts.begin(), sum.parts.end(), [&](const Expression& a, const Expression& b) {
            return place_of(Kind::sum, a) < place_of(Kind::sum, b);
        });
        put_positive_first(sum);
    }
    static bool is_negative(const Expression& of) {
        const Expression& leading = of.kind == Kind::product ? of.parts[0] : of;
        return leading.kind == Kind::number && leading.value.sign() < 0;
    }
    static Expression opposite(Expression of) {
        if (of.kind == Kind::number) return Expression::number(-of.value);
        if (of.kind != Kind::product) return Expression::of(Kind::product, {Expression::number(-1), std::move(of)});
        if (of.parts[0].kind != Kind::number) {
            of.parts.insert(of.parts.begin(), Expression::number(-1));
            return of;
        }
        of.parts[0].value = -of.parts[0].value;
        if (!of.parts[0].is_number(1)) return of;
        of.parts.erase(of.parts.begin());
        return of.parts.size() == 1 ? Expression(of.parts[0]) : of;
    }
    /// Order of factors: numbers, π, letters, the variable, sums, functions. Order of terms: by the power of the
    /// variable. Ties are ordered by their text without sign.
    using Place = std::pair<int, std::string>;
    Place place_of(Kind kind, const Expression& part) const {
        if (kind == Kind::product) return {rank_of_factor(part), written(part, constants_, "t")};
        return {rank_of_term(part), written(is_negative(part) ? opposite(part) : part, constants_, "t")};
    }
    bool first_is_negative(const Expression& sum) const {
        return is_negative(*std::min_element(
            sum.parts.begin(), sum.parts.end(),
            [&](const Expression& a, const Expression& b) { return place_of(Kind::sum, a) < place_of(Kind::sum, b); }));
    }
    /// Puts a term without a minus first, if there is one.
    static void put_positive_first(Expression& sum) {
        const auto positive =
            std::find_if(sum.parts.begin(), sum.parts.end(), [](const Expression& part) { return !is_negative(part); });
        if (positive != sum.parts.end()) std::rotate(sum.parts.begin(), positive, positive + 1);
    }
    Expression sorted(Kind kind, const GiNaC::ex& of) {
        std::vector<std::pair<Place, Expression>> parts;
        Exact coefficient = 1;
        const auto take = [&](Expression part) {
            if (kind == Kind::product && part.kind == Kind::number) {
                coefficient *= part.value;
                return;
            }
            if (kind == Kind::product && part.kind == Kind::sum && first_is_negative(part)) {
                turn_over(part);
                coefficient = -coefficient;
            }
            Place place = place_of(kind, part);
            parts.emplace_back(std::move(place), std::move(part));
        };
        for (const GiNaC::ex& each : of) {
            Expression part = back(each);
            if (kind == Kind::product && part.kind == Kind::product)
                for (Expression& factor : part.parts) take(std::move(factor));
            else
                take(std::move(part));
        }
        std::stable_sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        Expression made = Expression::of(kind);
        if (coefficient != Exact(1)) made.parts.push_back(Expression::number(coefficient));
        for (auto& [place, part] : parts) made.parts.push_back(std::move(part));
        if (kind == Kind::sum) put_positive_first(made);
        return made.parts.size() == 1 ? Expression(made.parts[0]) : made;
    }
    static int rank_of_factor(const Expression& of) {
        const Expression& base = of.kind == Kind::power ? of.parts[0] : of;
        switch (base.kind) {
            case Kind::number: return of.kind == Kind::power ? 1 : 0;
            case Kind::pi: return 2;
            case Kind::constant: return 3;
            case Kind::variable: return 4;
            case Kind::sum:
            case Kind::product:
            case Kind::power: return 5;
            case Kind::function: return base.function == Elementary::exp ? 6 : 7;
        }
        return 8;
    }
    static int rank_of_term(const Expression& of) {
        int rank = 0;
        for_each_factor(of, [&](const Expression& factor) {
            if (factor.kind == Kind::variable) rank += 1;
            if (factor.kind == Kind::power && factor.parts[0].kind == Kind::variable &&
                factor.parts[1].kind == Kind::number)
                rank += static_cast<int>(factor.parts[1].value.to_double());
        });
        return rank;
    }
    template <class See>
    static void for_each_factor(const Expression& of, See see) {
        if (of.kind != Kind::product) {
            see(of);
            return;
        }
        for (const Expression& part : of.parts) see(part);
    }

    const NamedConstants& constants_;
    GiNaC::realsymbol variable_;
    std::vector<GiNaC::realsymbol> symbols_;
    int count_ = 0;
};

tl::unexpected<Error> underivable(Words why) { return tl::unexpected(Error{ErrorCode::bad_input, "", std::move(why)}); }

}  // namespace

tl::expected<Expression, Error> derivative(const Expression& of, const NamedConstants& constants) {
    static std::mutex one_at_a_time;
    const std::lock_guard<std::mutex> lock(one_at_a_time);
    try {
        Translator translation(constants);
        return translation.back(translation.there(of).diff(translation.variable()));
    } catch (const Unwritable& why) {
        if (std::string_view(why.what()) == "too long")
            return underivable({lang::expressions::its_derivatives_would_fill_pages_write});
        return underivable({lang::expressions::its_derivative_is_not_real});
    } catch (const std::exception&) {  // GiNaC's exceptions: pole_error and others
        return underivable({lang::expressions::it_divides_by_zero});
    }
}

}  // namespace kinegraph
