#include "render/tables/equation_text.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <numbers>

#include "engine/equations_values.hpp"
#include "render/text/formula.hpp"
#include "render/text/utf8.hpp"

namespace kinegraph::render {
namespace {

using Letter = Equations::Letter;
using LetterIndex = Equations::LetterIndex;
using Side = Equations::Side;
using Term = Equations::Term;
using Sum = Equations::Sum;
using Solved = Equations::Solved;
using Kind = EquationItem::Kind;

constexpr int digits = 5;

/// Terms with their signs, on the way to a sum.
struct Signed {
    int sign = 1;
    Formula term;
};
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
Formula equal(Formula left, Formula right) { return std::move(left) + Formula::sign("=") + std::move(right); }
Formula column(std::vector<Formula> entries) { return Formula::matrix(std::move(entries), 1); }
Formula square(Formula of) { return Formula::power(std::move(of), Formula::upright("2")); }

/// What stands between two angles, with its sign: cos and sin of (plus − minus + quarters).
struct Difference {
    std::vector<LetterIndex> plus, minus;
    int quarters = 0;
};

/// Without zeros that only fill: "200.00 mm" is 200 mm.
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

class Text {
public:
    Text(const Solution& solution, Language language)
        : solution_(solution), mechanism_(solution.mechanism), e_(*solution.equations), language_(language) {}

    std::vector<EquationItem> items() {
        write_letters();
        write_positions();
        if (!e_.unknowns.empty() && !e_.free.empty()) {
            write_velocities();
            write_ratios();
            if (e_.by_tangent.empty()) write_accelerations();
        }
        write_reaches();
        if (!e_.free.empty()) write_values();
        write_dead_points();
        return std::move(items_);
    }
    /// Without what leads there.
    std::vector<EquationItem> answers() {
        if (!e_.unknowns.empty() && !e_.free.empty()) {
            write_ratios();
            if (e_.by_tangent.empty() && e_.is_regular()) write_second_ratios();
        }
        write_dead_points();
        return std::move(items_);
    }

private:
    // --- pieces ---------------------------------------------------------------------------------------------------------------

    std::string in(const Words& words) const { return render::in(words, language_); }
    void heading(const Words& words, bool is_apart = false) { items_.push_back({Kind::heading, in(words), {}, {}, is_apart}); }
    void say(const Words& words) { items_.push_back({Kind::words, in(words), {}, {}}); }
    void set(Formula formula) { items_.push_back({Kind::formula, {}, std::move(formula), {}}); }

    const Letter& letter(LetterIndex index) const { return e_.letter(index); }
    Formula name(LetterIndex index, int dots = 0) const { return Formula::letter(letter(index).symbol, letter(index).sub, dots); }
    /// As sentences call it: in braces, which make a letter of it.
    std::string spoken(LetterIndex index) const {
        return "{" + unicode_letter(letter(index).symbol) + (letter(index).sub.empty() ? "" : "_" + letter(index).sub) + "}";
    }
    /// A name of a letter and digits as one letter, "O2" as O₂; others as they are.
    static std::string as_letter(const std::string& name) {
        const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
        const bool is_one = !name.empty() && std::isalpha(static_cast<unsigned char>(name.front())) != 0 &&
                            std::all_of(name.begin() + 1, name.end(), is_digit);
        if (!is_one) return name;
        return "{" + name.substr(0, 1) + (name.size() > 1 ? "_" + name.substr(1) : "") + "}";
    }
    Formula value(double number) const { return Formula::upright(trimmed(render::number(number, digits, language_))); }
    std::string amount_of(LetterIndex index, double si, int derived) const {
        const Units& units = mechanism_.units;
        if (!letter(index).is_angle) {
            constexpr std::array kinds{QuantityKind::length, QuantityKind::velocity, QuantityKind::acceleration};
            return trimmed(amount(si, kinds.at(static_cast<std::size_t>(derived)), units, language_, digits));
        }
        if (derived == 0) return trimmed(amount(half_turns_apart(si), QuantityKind::angle, units, language_, digits));
        if (derived == 1) return trimmed(amount(si, QuantityKind::angular_velocity, units, language_, digits));
        return trimmed(render::number(si, digits, language_)) + " rad/s²";
    }
    /// −180° is 180°.
    static double half_turns_apart(double angle) {
        return std::abs(angle + std::numbers::pi) < 1e-12 ? std::numbers::pi : std::abs(angle) < 1e-15 ? 0 : angle;
    }
    Formula amount_formula(LetterIndex index, double si, int derived) const {
        return Formula::upright(amount_of(index, si, derived));
    }

    Formula sum_of(const std::vector<LetterIndex>& letters, int dots = 0) const {
        std::vector<Signed> terms;
        for (const LetterIndex each : letters) terms.push_back({1, name(each, dots)});
        return joined(terms);
    }
    Formula angle(const Equations::Angle& of) const {
        Formula sum = of.letters.empty() ? Formula() : sum_of(of.letters);
        constexpr std::array<const char*, 4> turned{"0", "90°", "180°", "270°"};
        if (of.quarters == 0) return of.letters.empty() ? Formula::upright("0") : sum;
        Formula quarters = Formula::upright(turned.at(static_cast<std::size_t>(of.quarters)));
        return sum.empty() ? quarters : std::move(sum) + Formula::sign("+") + std::move(quarters);
    }
    static Formula imaginary() { return Formula::letter("i"); }
    /// e^{iθ}; nothing where θ is made of quarters alone.
    Formula turned(const std::vector<LetterIndex>& letters) const {
        if (letters.empty()) return {};
        Formula exponent = imaginary();
        exponent += letters.size() > 1 ? Formula::fenced(sum_of(letters)) : sum_of(letters);
        return Formula::power(Formula::letter("e"), std::move(exponent));
    }
    /// factor · e^{i(angle + more quarters)}: quarters are i, −1, −i.
    Signed exponential(int sign, Formula factor, const Equations::Angle& of, int more = 0) const {
        const int quarters = (of.quarters + more) % 4;
        Formula term;
        if (quarters % 2 == 1) term += imaginary();
        term += std::move(factor);
        if (!of.letters.empty()) term += turned(of.letters);
        return {quarters >= 2 ? -sign : sign, std::move(term)};
    }
    Signed side(const Side& of, int sign = 1) const { return exponential(sign, name(of.length), of.angle); }

    Formula trigonometric(bool sine, Formula of, bool bare) const {
        Formula term = Formula::function(sine ? "sin" : "cos");
        term += bare ? std::move(of) : Formula::fenced(std::move(of));
        return term;
    }
    Signed term(const Term& of, int sign = 1) const {
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
    std::vector<Signed> terms(const Sum& sum, int sign = 1) const {
        std::vector<Signed> all;
        for (const Term& each : sum) all.push_back(term(each, sign));
        return all;
    }
    /// A sum's terms with one rate more.
    static Sum times_rate(Sum sum, LetterIndex rate, int dots) {
        for (Term& each : sum) each.rates.push_back({{rate}, dots, 1});
        return sum;
    }

    // --- what is given, driven, sought ----------------------------------------------------------------------------------------

    std::string described(LetterIndex index) const {
        const Letter& own = letter(index);
        const auto body = [&](BodyIndex which) { return mechanism_.body(which).name; };
        if (own.is_angle && own.joint == none && own.body != none)
            return own.against == none ? in(Words("turn of body {0}", "rotazione del corpo {0}", body(own.body)))
                                       : in(Words("turn of body {0} on body {1}", "rotazione del corpo {0} rispetto al corpo {1}",
                                                  body(own.body), body(own.against)));
        if (own.is_angle)
            return in(Words("equivalent link at {0}", "biella equivalente in {0}",
                            own.joint == none ? std::string() : mechanism_.joint(own.joint).name));
        if (own.joint != none) return in(Words("slide at {0}", "scorrimento in {0}", mechanism_.joint(own.joint).name));
        return in(Words("place: {0}", "posizione: {0}", own.name));
    }
    std::string point_at(const Vector& place) const {
        for (const PointIndex point : indices_of(mechanism_.points))
            if (solution_.pose.at(point) == place) return mechanism_.point(point).name;
        return {};
    }
    /// "O_2", as figures have it.
    static Formula point_name(const std::string& name) {
        std::size_t stem = name.size();
        while (stem > 1 && name[stem - 1] >= '0' && name[stem - 1] <= '9') --stem;
        return Formula::letter(name.substr(0, stem), name.substr(stem));
    }
    /// "OA" where both ends have names.
    Formula ends_of(LetterIndex length) const {
        const auto find = [&](const std::vector<Side>& sides) -> Formula {
            for (const Side& each : sides)
                if (each.length == length) {
                    const std::string from = point_at(each.from), to = point_at(each.to);
                    return from.empty() || to.empty() ? Formula() : point_name(from) + point_name(to);
                }
            return {};
        };
        for (const Equations::Loop& loop : e_.loops)
            if (Formula found = find(loop.sides); !found.empty()) return found;
        for (const Equations::Reach& reach : e_.reaches)
            if (Formula found = find(reach.sides); !found.empty()) return found;
        return {};
    }
    bool is_written(LetterIndex index) const {
        const auto has = [&](const std::vector<Side>& sides) {
            return std::any_of(sides.begin(), sides.end(), [&](const Side& each) {
                const auto& own = each.angle.letters;
                return each.length == index || std::find(own.begin(), own.end(), index) != own.end();
            });
        };
        const auto in_law = [&](const Equations::Law& law) {
            return std::any_of(law.parts.begin(), law.parts.end(), [&](const Equations::Law::Part& part) {
                return part.radius == index ||
                       std::any_of(part.sum.begin(), part.sum.end(), [&](const auto& each) { return each.second == index; });
            });
        };
        return std::any_of(e_.loops.begin(), e_.loops.end(), [&](const auto& loop) { return has(loop.sides); }) ||
               std::any_of(e_.reaches.begin(), e_.reaches.end(), [&](const auto& reach) { return has(reach.sides); }) ||
               std::any_of(e_.laws.begin(), e_.laws.end(), in_law);
    }
    Formula what_is(LetterIndex index) const {
        const Letter& own = letter(index);
        if (own.role != Letter::Role::given) return Formula::upright(described(index));
        if (own.symbol == "R")
            return Formula::upright(in(Words("radius on body {0}", "raggio sul corpo {0}", mechanism_.body(own.body).name)));
        if (own.is_angle) return Formula::upright(in({"fixed angle", "angolo fisso"}));
        Formula ends = ends_of(index);
        return ends.empty() ? Formula::upright(in({"constant distance", "distanza costante"})) : ends;
    }
    void write_letters() {
        heading({"Closure equations", "Equazioni di chiusura"});
        std::vector<std::vector<Formula>> rows{
            {Formula::upright(in({"quantity", "grandezza"})), Formula::upright(in({"what", "che cos’è"})),
             Formula::upright(in({"value", "valore"})), Formula::upright(in({"kind", "tipo"}))}};
        const std::array<Words, 3> kinds{Words("given", "data"), Words("free (driven)", "libera (movente)"),
                                         Words("dependent", "dipendente")};
        for (const auto role : {Letter::Role::given, Letter::Role::free, Letter::Role::dependent})
            for (std::size_t i = 0; i < e_.letters.size(); ++i) {
                const auto index = static_cast<LetterIndex>(i);
                const Letter& own = e_.letters[i];
                if (own.role != role || (role == Letter::Role::given && !is_written(index))) continue;
                rows.push_back({name(index), what_is(index), amount_formula(index, own.value, 0),
                                Formula::upright(in(kinds.at(static_cast<std::size_t>(role))))});
            }
        items_.push_back({Kind::table, {}, {}, std::move(rows)});
    }

    // --- positions ------------------------------------------------------------------------------------------------------------

    void write_positions() {
        for (std::size_t i = 0; i < e_.loops.size(); ++i) {
            const Equations::Loop& loop = e_.loops[i];
            std::string through;
            for (std::size_t k = 0; k < loop.through.size(); ++k)
                if (k == 0 || loop.through[k] != loop.through[k - 1])
                    through += (through.empty() ? "" : "–") + as_letter(loop.through[k]);
            say(Words("Loop {0} ({1}), real and imaginary part:", "Maglia {0} ({1}), parte reale e immaginaria:",
                      std::to_string(i + 1), through));
            set(both_sides(loop, [&](const Side& each) { return side(each); }));
            for (const bool sine : {false, true})
                set(both_sides(loop, [&](const Side& each) { return component(each.length, each.angle, sine, 1); }));
            write_solved(loop, i);
        }
        for (const Equations::Law& law : e_.laws) write_law(law);
        for (const JointIndex joint : e_.by_tangent)
            say(Words(
                "Of the contact {0} only the tangent is known. A slide along it stands for it: right for velocities in this "
                "position, not for accelerations.",
                "Del contatto {0} è nota solo la tangente. Lo sostituisce uno scorrimento lungo di essa: valido per le velocità "
                "in questa posizione, non per le accelerazioni.",
                mechanism_.joint(joint).name));
    }
    /// Left = right; terms that vanish are left out.
    Formula both_sides(const Equations::Loop& loop, const std::function<Signed(const Side&)>& of) const {
        std::array<std::vector<Signed>, 2> terms;
        for (const Side& each : loop.sides)
            if (Signed own = of(each); own.sign != 0) terms.at(each.on_the_right ? 1 : 0).push_back(std::move(own));
        return equal(joined(terms[0]), joined(terms[1]));
    }
    /// length · cos or sin; sign 0 where it vanishes.
    Signed component(LetterIndex length, const Equations::Angle& of, bool sine, int sign) const {
        return projected(name(length), {of.letters, {}, of.quarters}, sine, sign);
    }
    /// factor · cos or sin of a difference.
    Signed projected(Formula factor, Difference of, bool sine, int sign) const {
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
    Formula law_sum(const Equations::Law& law, const std::function<Formula(LetterIndex)>& of) const {
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
    void write_law(const Equations::Law& law) {
        const std::string joint = law.joint == none ? std::string() : mechanism_.joint(law.joint).name;
        if (law.kind == Equations::Law::Kind::rolling)
            say(Words("Rolling at {0}, counted from the drawn position:",
                      "Rotolamento in {0}, contato dalla posizione disegnata:", joint));
        else if (law.kind == Equations::Law::Kind::gear)
            say(Words("Gears at {0}, counted from the drawn position:", "Ingranaggio in {0}, contato dalla posizione disegnata:",
                      joint));
        else
            say({"A driver of what has a coordinate already:", "Un movente di ciò che ha già una coordinata:"});
        set(equal(law_sum(law, [&](LetterIndex each) { return Formula::letter("Delta") + name(each); }), Formula::upright("0")));
    }

    /// The known sides of a loop, as they add up to what the unknown ones are.
    std::vector<Side> known_sides(const Equations::Loop& loop) const {
        std::vector<Side> known;
        for (int i = 0; i < static_cast<int>(loop.sides.size()); ++i)
            if (i != loop.solved.first && i != loop.solved.second) known.push_back(loop.sides[at_index(i)]);
        return known;
    }
    static int sign_of(const Side& known, const Side& lead) { return known.on_the_right == lead.on_the_right ? -1 : 1; }

    void write_solved(const Equations::Loop& loop, std::size_t index) {
        switch (loop.solved.kind) {
            case Solved::Kind::two_turns:
                return write_two_turns(loop, index);
            case Solved::Kind::turn_and_slide:
                return write_turn_and_slide(loop);
            case Solved::Kind::turn_with_slide:
                return write_turn_with_slide(loop, index);
            case Solved::Kind::two_slides:
                return say({"Both unknowns are lengths: the two equations are linear in them.",
                            "Le due incognite sono lunghezze: le due equazioni sono lineari."});
            case Solved::Kind::nothing:
                return say({"All its quantities are known already: it closes by itself.",
                            "Tutte le sue grandezze sono già note: si chiude da sé."});
            case Solved::Kind::iterative:
                return say(
                    {"Its unknowns have no closed form here: they are found by iteration (Newton), together with the other loops’.",
                     "Le sue incognite non hanno qui forma chiusa: si trovano per iterazione (Newton), insieme a quelle delle altre "
                     "maglie."});
        }
    }
    std::string numbered(std::size_t index) const { return e_.loops.size() > 1 ? std::to_string(index + 1) : std::string(); }
    /// p e^{iσ} = …, with its numbers.
    void write_resultant(const Equations::Loop& loop, std::size_t index) {
        const Side& lead = loop.sides[at_index(loop.solved.first)];
        std::vector<Signed> sum;
        for (const Side& each : known_sides(loop)) sum.push_back(side(each, sign_of(each, lead)));
        const Formula p = Formula::letter("p", numbered(index)), sigma = Formula::letter("sigma", numbered(index));
        set(equal(p + Formula::power(Formula::letter("e"), imaginary() + sigma), joined(sum)));
        const auto told = [&](double si, QuantityKind kind) {
            return trimmed(amount(si, kind, mechanism_.units, language_, digits));
        };
        set(equal(p, Formula::upright(told(loop.solved.resultant, QuantityKind::length) + ", ")) +
            equal(sigma, Formula::upright(told(loop.solved.direction, QuantityKind::angle))));
    }
    void write_two_turns(const Equations::Loop& loop, std::size_t index) {
        say({"With what is known as one vector, the law of cosines gives both angles:",
             "Raccolte le grandezze note in un vettore, il teorema del coseno dà i due angoli:"});
        write_resultant(loop, index);
        const Side &first = loop.sides[at_index(loop.solved.first)], &second = loop.sides[at_index(loop.solved.second)];
        const bool same = first.on_the_right == second.on_the_right;
        const Formula p = Formula::letter("p", numbered(index)), b = name(first.length), c = name(second.length);
        const double pv = loop.solved.resultant, bv = letter(first.length).value, cv = letter(second.length).value;
        const auto write = [&](const Side& of, Formula above, const Formula& below, double cosine) {
            set(equal(
                    trigonometric(false, angle(of.angle) + Formula::sign("−") + Formula::letter("sigma", numbered(index)), false),
                    Formula::fraction(std::move(above), Formula::upright("2") + below + p)) +
                Formula::sign("=") + value(cosine));
            set(equal(angle(of.angle), amount_formula(of.angle.letters.empty() ? of.length : of.angle.letters.front(),
                                                      value_of(e_, of.angle), 0)));
        };
        const Formula plus = Formula::sign("+"), minus = Formula::sign("−");
        write(first, square(b) + plus + square(p) + minus + square(c), b, (bv * bv + pv * pv - cv * cv) / (2 * bv * pv));
        if (same)
            write(second, square(p) + plus + square(c) + minus + square(b), c, (pv * pv + cv * cv - bv * bv) / (2 * pv * cv));
        else
            write(second, square(b) + minus + square(p) + minus + square(c), c, (bv * bv - pv * pv - cv * cv) / (2 * pv * cv));
    }
    void write_turn_and_slide(const Equations::Loop& loop) {
        const Side &first = loop.sides[at_index(loop.solved.first)], &second = loop.sides[at_index(loop.solved.second)];
        const auto against = [&](const Side& of) {
            return Difference{of.angle.letters, second.angle.letters, of.angle.quarters - second.angle.quarters};
        };
        const std::vector<Side> known = known_sides(loop);
        say({"Projected square to the slide the loop gives the angle of the side that turns, projected along it the slide itself:",
             "Proiettando la maglia normalmente allo scorrimento si ricava l’angolo del lato che ruota, proiettandola lungo di esso lo "
             "scorrimento:"});
        write_sine(first, known, against);
        const int forth = first.on_the_right == second.on_the_right ? 1 : -1;
        std::vector<Signed> along;
        for (const Side& each : known)
            if (Signed own = projected(name(each.length), against(each), false, forth * sign_of(each, first)); own.sign != 0)
                along.push_back(std::move(own));
        along.push_back(projected(name(first.length), against(first), false, -forth));
        set(equal(name(second.length), joined(along)) + Formula::sign("=") +
            amount_formula(second.length, letter(second.length).value, 0));
    }
    /// sin β = −λ sin α + h/b, λ = a/b, where one crank and offsets are known; else all over b.
    void write_sine(const Side& first, const std::vector<Side>& known, const std::function<Difference(const Side&)>& against) {
        Signed turning = projected({}, against(first), true, 1);
        std::vector<Signed> across;
        const Side* crank = nullptr;
        bool one_crank = true;
        for (const Side& each : known) {
            Signed own = projected(name(each.length), against(each), true, sign_of(each, first));
            if (own.sign == 0) continue;
            const bool turns = own.term.parts.size() > 1;
            if (turns && crank != nullptr) one_crank = false;
            if (turns) crank = &each;
            across.push_back(std::move(own));
        }
        const int side = turning.sign < 0 ? -1 : 1;
        for (Signed& each : across) each.sign *= side;
        if (crank != nullptr && one_crank) {
            set(equal(Formula::letter("lambda"), Formula::fraction(name(crank->length), name(first.length))) +
                Formula::sign("=") + value(letter(crank->length).value / letter(first.length).value));
            std::vector<Signed> shares;
            for (const Side& each : known) {
                Signed own = projected(
                    &each == crank ? Formula::letter("lambda") : Formula::fraction(name(each.length), name(first.length)),
                    against(each), true, side * sign_of(each, first));
                if (own.sign != 0) shares.push_back(std::move(own));
            }
            set(equal(turning.term, joined(shares)));
        } else if (constexpr std::size_t most_above_a_bar = 3; across.size() > most_above_a_bar) {
            // A sum of many terms stands on lines, not above a bar.
            set(equal(name(first.length) + turning.term, joined(across)));
        } else {
            set(equal(turning.term, Formula::fraction(joined(across), name(first.length))));
        }
        set(equal(angle(first.angle), Formula::upright(trimmed(amount(value_of(e_, first.angle), QuantityKind::angle,
                                                                      mechanism_.units, language_, digits)))));
    }
    void write_turn_with_slide(const Equations::Loop& loop, std::size_t index) {
        const Side& first = loop.sides[at_index(loop.solved.first)];
        say({"The sliding side is what is known, as one vector:", "Il lato scorrevole è la somma delle grandezze note:"});
        write_resultant(loop, index);
        set(equal(name(first.length), Formula::letter("p", numbered(index))) + Formula::upright(", ") +
            equal(angle(first.angle), Formula::letter("sigma", numbered(index))));
    }

    // --- velocities and accelerations -----------------------------------------------------------------------------------------

    std::vector<LetterIndex> turning(const Side& of) const {
        std::vector<LetterIndex> letters;
        for (const LetterIndex each : of.angle.letters)
            if (letter(each).role != Letter::Role::given) letters.push_back(each);
        return letters;
    }
    bool slides(const Side& of) const { return letter(of.length).role != Letter::Role::given; }
    Formula rate_of(const std::vector<LetterIndex>& letters, int dots, bool squared = false) const {
        Formula sum = sum_of(letters, dots);
        if (letters.size() > 1) sum = Formula::fenced(std::move(sum));
        return squared ? square(std::move(sum)) : sum;
    }
    void add_velocity(const Side& of, std::vector<Signed>& terms, int sign) const {
        if (slides(of)) terms.push_back(exponential(sign, name(of.length, 1), of.angle));
        if (const auto turns = turning(of); !turns.empty())
            terms.push_back(exponential(sign, name(of.length) + rate_of(turns, 1), of.angle, 1));
    }
    void add_acceleration(const Side& of, std::vector<Signed>& terms, int sign) const {
        const auto turns = turning(of);
        if (slides(of)) terms.push_back(exponential(sign, name(of.length, 2), of.angle));
        if (turns.empty()) return;
        terms.push_back(exponential(sign, name(of.length) + rate_of(turns, 2), of.angle, 1));
        terms.push_back(exponential(-sign, name(of.length) + rate_of(turns, 1, true), of.angle));
        if (slides(of))
            terms.push_back(exponential(sign, Formula::upright("2") + name(of.length, 1) + rate_of(turns, 1), of.angle, 1));
    }
    Formula derived(const Equations::Loop& loop, bool twice) const {
        std::array<std::vector<Signed>, 2> terms;
        for (const Side& each : loop.sides) {
            std::vector<Signed>& own = terms.at(each.on_the_right ? 1 : 0);
            twice ? add_acceleration(each, own, 1) : add_velocity(each, own, 1);
        }
        return equal(joined(terms[0]), joined(terms[1]));
    }

    std::size_t column_of(LetterIndex unknown) const {
        return static_cast<std::size_t>(std::find(e_.unknowns.begin(), e_.unknowns.end(), unknown) - e_.unknowns.begin());
    }
    bool is_in(const Equations::Block& block, LetterIndex unknown) const {
        return std::find(block.unknowns.begin(), block.unknowns.end(), unknown) != block.unknowns.end();
    }
    /// What a row's known terms make, sent to the right.
    Sum known_terms(const Equations::Block& block, std::size_t row, int dots) const {
        Sum sum;
        const auto add = [&](const Sum& entry, LetterIndex of) {
            for (Term& each : times_rate(entry, of, dots)) sum.push_back(std::move(each));
        };
        for (std::size_t k = 0; k < e_.free.size(); ++k) add(e_.f_x[row][k], e_.free[k]);
        for (std::size_t j = 0; j < e_.unknowns.size(); ++j)
            if (!is_in(block, e_.unknowns[j])) add(e_.f_y[row][j], e_.unknowns[j]);
        if (dots == 2) sum.insert(sum.end(), e_.second_order[row].begin(), e_.second_order[row].end());
        return sum;
    }
    double length_unit() const { return mechanism_.units.length.si.to_double(); }
    bool is_of_turns(std::size_t row) const {
        return row >= 2 * e_.loops.size() && e_.laws[row - 2 * e_.loops.size()].kind == Equations::Law::Kind::driver &&
               letter(e_.laws[row - 2 * e_.loops.size()].parts.front().sum.front().second).is_angle;
    }
    double in_units(std::size_t row, LetterIndex unknown, double entry) const {
        return letter(unknown).is_angle && !is_of_turns(row) ? entry / length_unit() : entry;
    }
    Formula unknowns_column(const Equations::Block& block, int dots) const {
        std::vector<Formula> all;
        for (const LetterIndex each : block.unknowns) all.push_back(name(each, dots));
        return column(std::move(all));
    }
    Formula matrix(const Equations::Block& block, bool symbols) const {
        std::vector<Formula> entries;
        for (const int r : block.rows)
            for (const LetterIndex each : block.unknowns) {
                const auto row = at_index(r);
                const std::size_t col = column_of(each);
                entries.push_back(symbols ? joined(terms(e_.f_y[row][col]))
                                          : value(rounded(in_units(row, each, e_.jacobian[row][col]))));
            }
        return Formula::matrix(std::move(entries), block.unknowns.size());
    }
    /// Without the dust that sines of right angles leave.
    double rounded(double entry) const {
        double largest = 0;
        for (const auto& row : e_.jacobian)
            for (const double each : row) largest = std::max(largest, std::abs(each));
        return std::abs(entry) < 1e-12 * std::max(largest / length_unit(), 1e-30) ? 0 : entry;
    }
    Formula right_side(const Equations::Block& block, int dots, bool symbols) const {
        std::vector<Formula> entries;
        for (const int r : block.rows) {
            const Sum known = known_terms(block, at_index(r), dots);
            const double unit = is_of_turns(at_index(r)) ? 1 : length_unit();
            entries.push_back(symbols ? joined(terms(known, -1)) : value(-value_of(e_, known) / unit));
        }
        return column(std::move(entries));
    }
    /// Of a square block, by elimination in doubles.
    std::optional<double> determinant(const Equations::Block& block) const {
        if (block.rows.size() != block.unknowns.size()) return std::nullopt;
        std::vector<std::vector<double>> a;
        for (const int r : block.rows) {
            std::vector<double>& row = a.emplace_back();
            for (const LetterIndex each : block.unknowns)
                row.push_back(in_units(at_index(r), each, e_.jacobian[at_index(r)][column_of(each)]));
        }
        double value = 1;
        for (std::size_t k = 0; k < a.size(); ++k) {
            std::size_t best = k;
            for (std::size_t i = k; i < a.size(); ++i)
                if (std::abs(a[i][k]) > std::abs(a[best][k])) best = i;
            if (a[best][k] == 0) return 0;
            if (best != k) std::swap(a[best], a[k]), value = -value;
            value *= a[k][k];
            for (std::size_t i = k + 1; i < a.size(); ++i) {
                const double share = a[i][k] / a[k][k];
                for (std::size_t j = k; j < a.size(); ++j) a[i][j] -= share * a[k][j];
            }
        }
        return value;
    }
    bool rates_known(const Equations::Block& block, int dots) const {
        const auto known = [&](LetterIndex each) {
            return dots == 1 ? letter(each).rate.has_value() : letter(each).acceleration.has_value();
        };
        return std::all_of(block.unknowns.begin(), block.unknowns.end(), known);
    }

    void write_velocities() {
        heading({"Velocities", "Velocità"}, true);
        const std::string& unit = mechanism_.units.length.symbol;
        say(e_.loops.empty() ? Words("Differentiating the laws once, with entries in {0}, {0}/s and rad:",
                                     "Derivando una volta le leggi, con elementi in {0}, {0}/s e rad:", unit)
                             : Words("Differentiating the loops once, with entries in {0}, {0}/s and rad:",
                                     "Derivando una volta le equazioni di maglia, con elementi in {0}, {0}/s e rad:", unit));
        for (const Equations::Loop& loop : e_.loops) set(derived(loop, false));
        for (const Equations::Law& law : e_.laws)
            set(equal(law_sum(law, [&](LetterIndex each) { return name(each, 1); }), Formula::upright("0")));
        for (const Equations::Block& block : e_.blocks) write_block(block, 1);
    }
    void write_block(const Equations::Block& block, int dots) {
        if (block.unknowns.empty()) return;
        // A system of many unknowns has its matrix apart: J ẏ = …, and long right sides stand one under the other.
        constexpr std::size_t most_in_line = 4, most_letters = 60;
        const bool is_large = block.unknowns.size() > most_in_line;
        if (is_large && dots == 1) write_in_parts(block);
        Formula left = (is_large ? Formula::letter("J") : matrix(block, true)) + unknowns_column(block, dots);
        if (const bool is_long = longest_right_side(block, dots) > most_in_line || widest_right_side(block, dots) > most_letters;
            !is_long)
            set(equal(std::move(left), right_side(block, dots, true)));
        else
            write_long_right_side(block, dots, std::move(left));
        if (rates_known(block, dots)) {
            std::vector<Formula> values;
            for (const LetterIndex each : block.unknowns)
                values.push_back(amount_formula(each, (dots == 1 ? letter(each).rate : letter(each).acceleration).value(), dots));
            if (is_large) {
                if (dots == 1) set(equal(Formula::letter("J"), matrix(block, false)));
            } else {
                set(equal(matrix(block, false) + unknowns_column(block, dots), right_side(block, dots, false)));
            }
            set(equal(unknowns_column(block, dots), column(std::move(values))));
        } else if (dots == 1) {
            set(equal(Formula::letter("J"), matrix(block, false)));
        }
        if (dots == 1) write_determinant(block);
    }
    std::size_t longest_right_side(const Equations::Block& block, int dots) const {
        std::size_t longest = 0;
        for (const int r : block.rows) longest = std::max(longest, known_terms(block, at_index(r), dots).size());
        return longest;
    }
    /// Characters of the longest row.
    std::size_t widest_right_side(const Equations::Block& block, int dots) const {
        std::size_t widest = 0;
        for (const int r : block.rows)
            widest = std::max(widest, character_count(joined(terms(known_terms(block, at_index(r), dots), -1)).plain()));
        return widest;
    }
    void write_long_right_side(const Equations::Block& block, int dots, Formula left) {
        std::vector<Formula> names;
        for (std::size_t i = 0; i < block.rows.size(); ++i) names.push_back(Formula::letter("r", std::to_string(i + 1)));
        set(equal(std::move(left), column(names)));
        for (std::size_t i = 0; i < block.rows.size(); ++i)
            set(equal(names[i], joined(terms(known_terms(block, at_index(block.rows[i]), dots), -1))));
    }
    /// J = [J_1 J_2 …], a few columns each.
    void write_in_parts(const Equations::Block& block) {
        constexpr std::size_t most = 3, most_letters = 56, between = 3;
        std::vector<Formula> names;
        for (std::size_t first = 0; first < block.unknowns.size();) {
            Equations::Block part = block;
            part.unknowns.clear();
            for (std::size_t letters = 0; first < block.unknowns.size() && part.unknowns.size() < most; ++first) {
                Equations::Block one = block;
                one.unknowns = {block.unknowns[first]};
                std::size_t widest = 0;
                for (const Formula& entry : matrix(one, true).parts) widest = std::max(widest, character_count(entry.plain()));
                letters += widest + between;
                if (!part.unknowns.empty() && letters > most_letters) break;
                part.unknowns.push_back(block.unknowns[first]);
            }
            names.push_back(Formula::letter("J", std::to_string(names.size() + 1)));
            set(equal(names.back(), matrix(part, true)));
        }
        const std::size_t count = names.size();
        set(equal(Formula::letter("J"), Formula::matrix(std::move(names), count)));
    }
    void write_determinant(const Equations::Block& block) {
        const auto found = determinant(block);
        if (!found) {
            say(Words("{0} equations for {1} unknowns, of rank {2}.", "{0} equazioni per {1} incognite, di rango {2}.",
                      std::to_string(block.rows.size()), std::to_string(block.unknowns.size()), std::to_string(e_.rank)));
            return;
        }
        Formula left = Formula::upright("det") + Formula::letter("J");
        if (auto closed = closed_determinant(block, *found)) left = equal(std::move(left), *std::move(closed));
        set(equal(std::move(left), value(e_.determinant && *e_.determinant == 0 && e_.blocks.size() == 1 ? 0 : *found)));
    }
    /// b c sin(γ − β), b cos(β − γ), s: of a dyad's two rows, up to the sign, which the number tells.
    std::optional<Formula> closed_determinant(const Equations::Block& block, double found) const {
        if (block.rows.size() != 2 || at_index(block.rows.front()) >= 2 * e_.loops.size()) return std::nullopt;
        const Equations::Loop& loop = e_.loops[at_index(block.rows.front() / 2)];
        const Solved& solved = loop.solved;
        if (solved.first < 0 || solved.second < 0 || loop.unknowns.size() != 2) return std::nullopt;
        const Side &first = loop.sides[at_index(solved.first)], &second = loop.sides[at_index(solved.second)];
        const Difference between{second.angle.letters, first.angle.letters, second.angle.quarters - first.angle.quarters};
        Signed own{0, {}};
        double expected = value_of(e_, second.angle) - value_of(e_, first.angle);
        if (solved.kind == Solved::Kind::two_turns) {
            own = projected(name(first.length) + name(second.length), between, true, 1);
            expected = std::sin(expected);
        } else if (solved.kind == Solved::Kind::turn_and_slide) {
            own = projected(name(first.length),
                            {first.angle.letters, second.angle.letters, first.angle.quarters - second.angle.quarters}, false, 1);
            expected = std::cos(expected);
        } else if (solved.kind == Solved::Kind::turn_with_slide) {
            own = {1, name(first.length)};
            expected = letter(first.length).value;
        }
        if (own.sign == 0) return std::nullopt;
        if (expected * found < 0) own.sign = -own.sign;
        return joined({own});
    }

    /// d of/d by; of several drivers' coordinates ∂ of/∂ by.
    Formula derivative(LetterIndex of, LetterIndex by) const {
        const Formula d = Formula::upright(e_.free.size() > 1 ? "∂" : "d");
        return Formula::fraction(d + name(of), d + name(by));
    }
    Formula second_derivative(LetterIndex of, LetterIndex first, LetterIndex second) const {
        const Formula d = Formula::upright(e_.free.size() > 1 ? "∂" : "d");
        Formula below = first == second ? d + square(name(first)) : d + name(first) + d + name(second);
        return Formula::fraction(square(d) + name(of), std::move(below));
    }
    /// The index of Λ: the coordinate, and of several drivers' which of them.
    std::string index_of(LetterIndex of, std::initializer_list<LetterIndex> by) const {
        std::string index = plain_sub(of);
        if (e_.free.size() > 1)
            for (const LetterIndex each : by) index += "," + plain_sub(each);
        return index;
    }
    /// What rad or m of `of` is for each of the others, in the file's unit of length.
    std::string ratio_unit(LetterIndex of, std::initializer_list<LetterIndex> by) const {
        const std::string& length = mechanism_.units.length.symbol;
        int lengths = letter(of).is_angle ? 0 : 1, turns = letter(of).is_angle ? 1 : 0;
        for (const LetterIndex each : by) --(letter(each).is_angle ? turns : lengths);
        const auto power = [](int of_unit) { return of_unit == 2 ? "²" : ""; };
        // An angle is told where a length stands beside it.
        if (lengths == 0) return "";
        if (lengths > 0) return " " + length + (turns < 0 ? std::string("/rad") + power(-turns) : "");
        return std::string(turns > 0 ? " rad" : " 1") + "/" + length + power(-lengths);
    }
    double ratio_in_units(LetterIndex of, std::initializer_list<LetterIndex> by, double si) const {
        if (!letter(of).is_angle) si /= length_unit();
        for (const LetterIndex each : by)
            if (!letter(each).is_angle) si *= length_unit();
        return si;
    }
    Formula ratio_value(LetterIndex of, std::initializer_list<LetterIndex> by, double si) const {
        return Formula::sign("=") +
               Formula::upright(trimmed(number(ratio_in_units(of, by, si), digits, language_)) + ratio_unit(of, by));
    }
    void write_ratios() {
        bool told = false;
        for (std::size_t j = 0; j < e_.unknowns.size(); ++j)
            for (std::size_t k = 0; k < e_.free.size(); ++k) {
                if (!e_.ratios[j][k]) continue;
                if (!std::exchange(told, true)) heading({"Velocity ratios", "Rapporti di velocità"});
                const LetterIndex of = e_.unknowns[j], by = e_.free[k];
                Formula line = equal(Formula::letter("Lambda", index_of(of, {by})), derivative(of, by));
                if (auto closed = closed_ratio(of, by)) line += Formula::sign("=") + *std::move(closed);
                set(std::move(line) + ratio_value(of, {by}, *e_.ratios[j][k]));
            }
    }
    std::string plain_sub(LetterIndex of) const { return unicode_letter(letter(of).symbol) + letter(of).sub; }
    /// Of the slider-crank a e^{iα} + b e^{iβ} = c: dc/dα = −a (sin α − cos α tan β).
    std::optional<Formula> closed_ratio(LetterIndex of, LetterIndex by) const {
        if (letter(of).is_angle || !letter(by).is_angle) return std::nullopt;
        for (const Equations::Loop& loop : e_.loops) {
            if (loop.solved.kind != Solved::Kind::turn_and_slide) continue;
            const Side &rod = loop.sides[at_index(loop.solved.first)], &slide = loop.sides[at_index(loop.solved.second)];
            const auto is_plain = [](const Side& each, bool right, std::size_t letters) {
                return each.on_the_right == right && each.angle.quarters == 0 && each.angle.letters.size() == letters;
            };
            if (slide.length != of || !is_plain(slide, true, 0) || !is_plain(rod, false, 1)) continue;
            const Side* crank = nullptr;
            for (const Side& each : known_sides(loop)) {
                if (turning(each).empty() && !slides(each)) continue;
                if (crank != nullptr || !is_plain(each, false, 1) || each.angle.letters.front() != by) return std::nullopt;
                crank = &each;
                const Formula alpha = name(by), beta = name(rod.angle.letters.front());
                return Formula::upright("−") + name(crank->length) +
                       Formula::fenced(trigonometric(true, alpha, true) + Formula::sign("−") + trigonometric(false, alpha, true) +
                                       Formula::function("tan") + beta);
            }
        }
        return std::nullopt;
    }

    void write_accelerations() {
        if (!e_.is_regular()) return;
        heading({"Accelerations", "Accelerazioni"}, true);
        say({"Differentiating once more; the matrix is the same:", "Derivando ancora; la matrice resta la stessa:"});
        for (const Equations::Loop& loop : e_.loops) set(derived(loop, true));
        for (const Equations::Block& block : e_.blocks) write_block(block, 2);
        write_second_ratios();
    }
    /// Of two drivers the mixed ones too.
    void write_second_ratios() {
        for (std::size_t j = 0; j < e_.unknowns.size(); ++j)
            for (std::size_t k = 0; k < e_.free.size(); ++k)
                for (std::size_t l = k; l < e_.free.size(); ++l) {
                    const LetterIndex of = e_.unknowns[j], first = e_.free[k], second = e_.free[l];
                    const auto& found = e_.second_ratios[j][k][l];
                    if (!found) continue;
                    set(equal(Formula::primed("Lambda", index_of(of, {first, second}), 1), second_derivative(of, first, second)) +
                        ratio_value(of, {first, second}, *found));
                }
    }

    // --- open chains ----------------------------------------------------------------------------------------------------------

    void write_reaches() {
        for (const Equations::Reach& reach : e_.reaches) {
            const std::string point = mechanism_.point(reach.point).name;
            heading(Words("Open chain to {0}", "Catena aperta fino a {0}", point));
            std::vector<Signed> place, velocity;
            for (const Side& each : reach.sides) {
                const int sign = each.on_the_right ? -1 : 1;
                place.push_back(side(each, sign));
                add_velocity(each, velocity, sign);
            }
            set(equal(Formula::letter("z", point), joined(place)));
            if (!write_groups(reach)) {
                std::vector<Signed> acceleration;
                for (const Side& each : reach.sides) add_acceleration(each, acceleration, each.on_the_right ? -1 : 1);
                set(equal(Formula::letter("z", point, 1), joined(velocity)));
                set(equal(Formula::letter("z", point, 2), joined(acceleration)));
            }
        }
    }
    /// A complex number of metres a second, or a second squared, as the file has them.
    Formula complex(const std::array<double, 2>& of, QuantityKind kind) const {
        const Unit unit = kind == QuantityKind::velocity ? mechanism_.units.velocity : mechanism_.units.acceleration;
        const double si = unit.si.to_double();
        return Formula::fenced(value(of[0] / si) + Formula::sign(of[1] < 0 ? "−" : "+") + imaginary() +
                               value(std::abs(of[1]) / si)) +
               Formula::upright(" " + unit.symbol);
    }
    /// Where the last bodies turn against each other: what an observer on the one before sees, and what he adds.
    bool write_groups(const Equations::Reach& reach) {
        const std::vector<LetterIndex> letters = turning(reach.sides.back());
        if (letters.size() < 2) return false;
        const LetterIndex own = letters.back();
        const std::vector<LetterIndex> others(letters.begin(), letters.end() - 1);
        const std::string point = mechanism_.point(reach.point).name;
        const BodyIndex observer = letter(own).against;
        say(Words("With the terms in {0} apart, as seen by an observer on body {1}: transport and relative motion:",
                  "Separando i termini in {0}, per un osservatore sul corpo {1}: trascinamento e moto relativo:", spoken(own),
                  observer == none ? std::string("?") : mechanism_.body(observer).name));
        Group transport, relative, coriolis;
        std::vector<Signed> v_t, v_r;
        std::array<double, 2> vt{0, 0}, vr{0, 0};
        for (const Side& each : reach.sides) {
            const auto turns = turning(each);
            std::vector<LetterIndex> carried;
            for (const LetterIndex of : turns)
                if (of != own) carried.push_back(of);
            const bool moves = carried.size() != turns.size();
            const std::array<double, 2> z = value_of(e_, each);
            const double w = rate(carried, 1), a = rate(carried, 2), b = letter(own).rate.value_or(0),
                         b2 = letter(own).acceleration.value_or(0);
            v_t.push_back(exponential(1, name(each.length) + rate_of(carried, 1), each.angle, 1));
            add(vt, z, 0, w);
            transport.add(exponential(1, name(each.length) + rate_of(carried, 2), each.angle, 1));
            transport.add(exponential(-1, name(each.length) + rate_of(carried, 1, true), each.angle));
            add(transport.value, z, -w * w, a);
            if (!moves) continue;
            v_r.push_back(exponential(1, name(each.length) + name(own, 1), each.angle, 1));
            add(vr, z, 0, b);
            relative.add(exponential(1, name(each.length) + name(own, 2), each.angle, 1));
            relative.add(exponential(-1, name(each.length) + square(name(own, 1)), each.angle));
            add(relative.value, z, -b * b, b2);
            coriolis.add(
                exponential(-1, Formula::upright("2") + name(each.length) + rate_of(carried, 1) + name(own, 1), each.angle));
            add(coriolis.value, z, -2 * w * b, 0);
        }
        const auto line = [&](const char* symbol, const std::string& kind, const std::vector<Signed>& terms,
                              const std::array<double, 2>& of, QuantityKind quantity) {
            set(equal(Formula::letter(symbol, kind), joined(terms)) + Formula::sign("=") + complex(of, quantity));
        };
        const std::string t = in({"tr", "tr"}), r = in({"rel", "rel"}), c = in({"Cor", "Cor"});
        line("v", t, v_t, vt, QuantityKind::velocity);
        line("v", r, v_r, vr, QuantityKind::velocity);
        line("a", t, transport.terms, transport.value, QuantityKind::acceleration);
        line("a", r, relative.terms, relative.value, QuantityKind::acceleration);
        line("a", c, coriolis.terms, coriolis.value, QuantityKind::acceleration);
        set(equal(Formula::letter("v", point), complex({vt[0] + vr[0], vt[1] + vr[1]}, QuantityKind::velocity)));
        set(equal(Formula::letter("a", point), complex({transport.value[0] + relative.value[0] + coriolis.value[0],
                                                        transport.value[1] + relative.value[1] + coriolis.value[1]},
                                                       QuantityKind::acceleration)));
        return true;
    }
    struct Group {
        std::vector<Signed> terms{};
        std::array<double, 2> value{0, 0};
        void add(Signed term) { terms.push_back(std::move(term)); }
    };
    /// (radial + i across) z.
    static void add(std::array<double, 2>& to, const std::array<double, 2>& z, double radial, double across) {
        to[0] += radial * z[0] - across * z[1];
        to[1] += radial * z[1] + across * z[0];
    }
    double rate(const std::vector<LetterIndex>& letters, int dots) const {
        double sum = 0;
        for (const LetterIndex each : letters) sum += (dots == 1 ? letter(each).rate : letter(each).acceleration).value_or(0);
        return sum;
    }

    // --- values beside the polygons' ------------------------------------------------------------------------------------------

    struct Drawn {
        std::optional<double> rate, acceleration;
    };
    /// What the polygons say of a letter: turns of bodies, and slides along their guides.
    Drawn drawn(LetterIndex index) const {
        const Letter& own = letter(index);
        Drawn found;
        if (own.is_angle && own.joint == none && own.body != none) {
            const auto turn = [&](auto member) -> std::optional<double> {
                const auto& of = solution_.bodies[at_index(own.body)].*member;
                if (!of) return std::nullopt;
                if (own.against == none) return of->to_double();
                const auto& against = solution_.bodies[at_index(own.against)].*member;
                return against ? std::optional(of->to_double() - against->to_double()) : std::nullopt;
            };
            return {turn(&BodyMotion::omega), turn(&BodyMotion::alpha)};
        }
        if (own.is_angle || own.joint == none || !mechanism_.joint(own.joint).pair().has_guide()) return found;
        const auto sliding = std::find_if(solution_.sliding.begin(), solution_.sliding.end(),
                                          [&](const Sliding& each) { return each.joint == own.joint; });
        if (sliding == solution_.sliding.end()) return found;
        const auto direction = direction_of_slide(index);
        if (!direction) return found;
        const auto along = [&](const Vector& v) {
            return v.x.to_double() * std::cos(*direction) + v.y.to_double() * std::sin(*direction);
        };
        if (sliding->velocity) found.rate = along(*sliding->velocity);
        if (sliding->acceleration) found.acceleration = along(*sliding->acceleration);
        return found;
    }
    std::optional<double> direction_of_slide(LetterIndex index) const {
        for (const Equations::Loop& loop : e_.loops)
            for (const Side& each : loop.sides)
                if (each.length == index) return value_of(e_, each.angle);
        for (const Equations::Reach& reach : e_.reaches)
            for (const Side& each : reach.sides)
                if (each.length == index) return value_of(e_, each.angle);
        return std::nullopt;
    }
    void write_values() {
        std::vector<std::vector<Formula>> rows{{Formula::upright(in({"quantity", "grandezza"})),
                                                Formula::upright(in({"equations", "equazioni"})),
                                                Formula::upright(in({"polygon", "poligono"}))}};
        for (const int dots : {1, 2})
            for (const LetterIndex index : e_.unknowns) {
                const Letter& own = letter(index);
                const auto& written = dots == 1 ? own.rate : own.acceleration;
                const Drawn beside = drawn(index);
                const auto& polygon = dots == 1 ? beside.rate : beside.acceleration;
                if (!written && !polygon) continue;
                rows.push_back({name(index, dots), written ? amount_formula(index, *written, dots) : Formula::upright("–"),
                                polygon ? amount_formula(index, *polygon, dots) : Formula::upright("–")});
            }
        if (rows.size() < 2) return;
        heading({"Values", "Valori"});
        items_.push_back({Kind::table, {}, {}, std::move(rows)});
    }

    // --- dead points ----------------------------------------------------------------------------------------------------------

    std::string list_of(const std::vector<double>& values, LetterIndex of) const {
        std::string text;
        for (const double each : values) text += (text.empty() ? "" : "; ") + amount_of(of, each, 0);
        return text;
    }
    void write_dead_points() {
        auto title = [&, told = false]() mutable {
            if (!std::exchange(told, true)) heading({"Dead points", "Punti morti"});
        };
        if (!e_.is_regular() && !e_.free.empty()) {
            for (const LetterIndex each : e_.cannot_be_driven) {
                title();
                say(Words("In the drawn position det {J} = 0: {0} cannot be driven ({1}, {2}); it rests in every motion.",
                          "Nella posizione disegnata det {J} = 0: {0} non può essere movente ({1}, {2}); è fermo in ogni moto.",
                          spoken(each), described(each), amount_of(each, letter(each).value, 0)));
            }
            if (e_.cannot_be_driven.empty()) {
                title();
                say({"The equations leave unknowns open here: their rank is less than their number.",
                     "Qui le equazioni lasciano indeterminate delle incognite: il rango è minore del loro numero."});
            }
        }
        if (e_.free.size() != 1) return;
        for (std::size_t i = 0; i < e_.loops.size(); ++i) {
            if (!e_.loops[i].solved.dead_points) continue;
            title();
            write_dead_points_of(e_.loops[i], i);
        }
    }
    /// Of several loops each speaks for itself alone: another may stop the driver.
    void write_dead_points_of(const Equations::Loop& loop, std::size_t index) {
        const LetterIndex driver = e_.free.front();
        const std::string of = numbered(index);
        const auto told = [&](const Words& words) {
            const std::string loop_named = of.empty() ? std::string() : in(Words("Loop {0}: ", "Maglia {0}: ", of));
            items_.push_back({Kind::words, loop_named + in(words), {}, {}});
        };
        const Solved& solved = loop.solved;
        if (!solved.dead_points->empty())
            told(
                letter(driver).is_angle
                    ? Words("det {J} = 0 at {0} = {1}: there {0} cannot be driven, and its body makes no full turn.",
                            "det {J} = 0 per {0} = {1}: lì {0} non può essere movente, e il suo membro non compie giri completi.",
                            spoken(driver), list_of(*solved.dead_points, driver))
                    : Words("det {J} = 0 at {0} = {1}: there {0} cannot be driven.",
                            "det {J} = 0 per {0} = {1}: lì {0} non può essere movente.", spoken(driver),
                            list_of(*solved.dead_points, driver)));
        else if (!letter(driver).is_angle)
            told(Words("det {J} vanishes for no {0}.", "det {J} non si annulla per alcun {0}.", spoken(driver)));
        else
            told(of.empty()
                     ? Words("det {J} vanishes for no {0}: the driven body makes full turns.",
                             "det {J} non si annulla per alcun {0}: il membro movente compie giri completi.", spoken(driver))
                     : Words("det {J} vanishes for no {0}; as for this loop, the driven body may make full turns.",
                             "det {J} non si annulla per alcun {0}; per questa maglia il membro movente può compiere giri "
                             "completi.",
                             spoken(driver)));
        for (const auto& [at, slide] : solved.standstills)
            told(Words(
                "Crank and rod lie in one line at {0} = {1}, {2} = {3}: there {Λ} = 0, and {2} could not drive.",
                "Manovella e biella sono allineate per {0} = {1}, {2} = {3}: lì {Λ} = 0, e {2} non potrebbe essere movente.",
                spoken(driver), amount_of(driver, at, 0), spoken(loop.sides[at_index(solved.second)].length),
                amount_of(loop.sides[at_index(solved.second)].length, slide, 0)));
    }

    const Solution& solution_;
    const Mechanism& mechanism_;
    const Equations& e_;
    Language language_;
    std::vector<EquationItem> items_;
};

}  // namespace

std::vector<EquationItem> equation_items(const Solution& solution, Language language) {
    if (!solution.equations) return {};
    if (!solution.equations->why_not.empty())
        return {{EquationItem::Kind::heading, in(Words("Closure equations", "Equazioni di chiusura"), language), {}, {}},
                {EquationItem::Kind::words,
                 in(Words("There are none: {0}.", "Non ce ne sono: {0}.", solution.equations->why_not), language),
                 {},
                 {}}};
    return Text(solution, language).items();
}

std::vector<EquationItem> equation_answers(const Solution& solution, Language language) {
    if (!solution.equations || !solution.equations->why_not.empty()) return {};
    return Text(solution, language).answers();
}

namespace {

/// For a terminal: "m/s²".
std::string as_words(const RichText& text) {
    std::string words;
    for (const Piece& piece : text) {
        const bool squared = piece.sup == "2";
        Piece own = piece;
        if (squared) own.sup.clear();
        words += plain({own}) + (squared ? "²" : "");
    }
    return words;
}

}  // namespace

std::string as_text(std::span<const EquationItem> items) {
    std::string text;
    for (const EquationItem& item : items) {
        if (item.kind == Kind::heading) text += (text.empty() ? "" : "\n") + item.words + "\n";
        if (item.kind == Kind::words) text += as_words(formula(item.words)) + "\n";
        if (item.kind == Kind::formula) text += "  " + item.formula.plain() + "\n";
        std::vector<std::size_t> wide;
        for (const auto& row : item.rows)
            for (std::size_t c = 0; c < row.size(); ++c) {
                if (wide.size() <= c) wide.push_back(0);
                wide[c] = std::max(wide[c], character_count(row[c].plain()));
            }
        for (const auto& row : item.rows) {
            std::string line = " ";
            for (std::size_t c = 0; c < row.size(); ++c) {
                const std::string cell = row[c].plain();
                line += " " + cell + (c + 1 < row.size() ? std::string(wide[c] - character_count(cell) + 1, ' ') : "");
            }
            text += line + "\n";
        }
    }
    return text;
}

std::string as_latex(std::span<const EquationItem> items) {
    const auto safe = [](const std::string& words) {
        std::string text;
        for (const char c : words) {
            if (c == '_' || c == '%' || c == '&' || c == '#' || c == '$' || c == '{' || c == '}') text += '\\';
            text += c;
        }
        return text;
    };
    std::string text = "\\documentclass{article}\n\\usepackage{amsmath}\n\\begin{document}\n";
    for (const EquationItem& item : items) {
        if (item.kind == Kind::heading) text += "\\section*{" + safe(item.words) + "}\n";
        if (item.kind == Kind::words) {
            for (const Piece& piece : formula(item.words))
                text += piece.face == Face::italic ? "$" + Formula::letter(letter_spelt(piece.text), piece.sub).latex() + "$"
                                                   : safe(piece.text) + (piece.sup.empty() ? "" : "$^{" + piece.sup + "}$");
            text += "\n\n";
        }
        if (item.kind == Kind::formula) text += "\\[" + item.formula.latex() + "\\]\n";
        if (item.kind != Kind::table) continue;
        std::string array = "\\begin{array}{" + std::string(item.rows.front().size(), 'l') + "}";
        for (std::size_t r = 0; r < item.rows.size(); ++r)
            for (std::size_t c = 0; c < item.rows[r].size(); ++c)
                array += (c > 0 ? " & " : r > 0 ? " \\\\ " : "") + item.rows[r][c].latex();
        text += "\\[" + array + "\\end{array}\\]\n";
    }
    return text + "\\end{document}\n";
}

}  // namespace kinegraph::render
