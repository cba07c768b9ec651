// Derivatives by GiNaC: expressions become its, and what it finds becomes expressions again, sorted by an order of ours, since
// its own hangs on addresses. Its counts of references are not for several threads: one at a time is let in.
#include <ginac/ginac.h>

#include <algorithm>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "engine/algebra.hpp"

namespace kinegraph {
namespace {

using Kind = Expression::Kind;

/// What no expression can say.
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
            case Kind::number:
                return GiNaC::numeric(of.value.to_fraction().c_str());
            case Kind::pi:
                return GiNaC::Pi;
            case Kind::constant:
                return symbols_.at(of.constant);
            case Kind::variable:
                return variable_;
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
            case Kind::power:
                return GiNaC::pow(there(of.parts[0]), there(of.parts[1]));
            case Kind::function:
                return function(of.function, there(of.parts[0]));
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
        if (GiNaC::is_a<GiNaC::power>(of)) return Expression::of(Kind::power, {back(of.op(0)), back(of.op(1))});
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
            case Elementary::sin:
                return GiNaC::sin(u);
            case Elementary::cos:
                return GiNaC::cos(u);
            case Elementary::tan:
                return GiNaC::tan(u);
            case Elementary::asin:
                return GiNaC::asin(u);
            case Elementary::acos:
                return GiNaC::acos(u);
            case Elementary::atan:
                return GiNaC::atan(u);
            case Elementary::sinh:
                return GiNaC::sinh(u);
            case Elementary::cosh:
                return GiNaC::cosh(u);
            case Elementary::tanh:
                return GiNaC::tanh(u);
            case Elementary::exp:
                return GiNaC::exp(u);
            case Elementary::log:
                return GiNaC::log(u);
            case Elementary::abs:
                return GiNaC::abs(u);
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
    /// Factors: numbers, π, letters, powers of these, functions; terms by the power of the variable; the same by their text.
    Expression sorted(Kind kind, const GiNaC::ex& of) {
        std::vector<std::pair<std::pair<int, std::string>, Expression>> parts;
        for (const GiNaC::ex& each : of) {
            Expression part = back(each);
            const int rank = kind == Kind::product ? rank_of_factor(part) : rank_of_term(part);
            parts.push_back({{rank, written(part, constants_, "t")}, std::move(part)});
        }
        std::stable_sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        // What begins a sum has no minus, if anything has none.
        if (kind == Kind::sum) {
            const auto positive =
                std::find_if(parts.begin(), parts.end(), [](const auto& each) { return !each.first.second.starts_with('-'); });
            if (positive != parts.end()) std::rotate(parts.begin(), positive, positive + 1);
        }
        Expression made = Expression::of(kind);
        for (auto& [key, part] : parts) made.parts.push_back(std::move(part));
        return made;
    }
    static int rank_of_factor(const Expression& of) {
        const Expression& base = of.kind == Kind::power ? of.parts[0] : of;
        switch (base.kind) {
            case Kind::number:
                return of.kind == Kind::power ? 1 : 0;
            case Kind::pi:
                return 2;
            case Kind::constant:
                return 3;
            case Kind::variable:
                return 4;
            case Kind::sum:
            case Kind::product:
            case Kind::power:
                return 5;
            case Kind::function:
                return base.function == Elementary::exp ? 6 : 7;
        }
        return 8;
    }
    static int rank_of_term(const Expression& of) {
        int rank = 0;
        for_each_factor(of, [&](const Expression& factor) {
            if (factor.kind == Kind::variable) rank += 1;
            if (factor.kind == Kind::power && factor.parts[0].kind == Kind::variable && factor.parts[1].kind == Kind::number)
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

tl::expected<Expression, Words> derivative(const Expression& of, const NamedConstants& constants) {
    static std::mutex one_at_a_time;
    const std::lock_guard<std::mutex> lock(one_at_a_time);
    try {
        Translator translation(constants);
        return translation.back(translation.there(of).diff(translation.variable()));
    } catch (const Unwritable& why) {
        if (std::string_view(why.what()) == "too long")
            return tl::make_unexpected(Words("its derivatives would fill pages; write it shorter, with constants",
                                             "le sue derivate riempirebbero pagine; scriverla più corta, con costanti"));
        return tl::make_unexpected(Words("its derivative is not real; it has the root or the logarithm of what is negative",
                                         "la sua derivata non è reale; contiene la radice o il logaritmo di ciò che è negativo"));
    } catch (const std::exception&) {  // GiNaC's: pole_error and its like
        return tl::make_unexpected(Words("it divides by zero, or is infinite, whatever its variable is",
                                         "divide per zero, o è infinita, qualunque sia la variabile"));
    }
}

}  // namespace

const Algebra ginac_algebra{derivative};

}  // namespace kinegraph
