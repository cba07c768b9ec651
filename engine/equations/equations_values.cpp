// Symbolic derivatives of closure equations, and Gaussian elimination on their values in Exact. A side l e^{iθ} has the
// derivatives
//   l̇ e^{iθ} + l θ̇ i e^{iθ}   and   (l̈ − l θ̇²) e^{iθ} + (2 l̇ θ̇ + l θ̈) i e^{iθ},
// θ being a sum of letters, some of which are constant.
#include "engine/equations/equations_values.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/motion/closure.hpp"
#include "engine/number/functions.hpp"

namespace kinegraph {
namespace {

using Letter = Equations::Letter;
using LetterIndex = Equations::LetterIndex;
using Angle = Equations::Angle;
using Side = Equations::Side;
using Term = Equations::Term;
using Sum = Equations::Sum;
using Solved = Equations::Solved;

Vector unit_of(const Equations& equations, const Angle& angle) {
    Vector unit{1, 0};
    for (const LetterIndex letter : angle.letters) unit = faced(unit, equations.letter(letter).unit);
    for (int k = 0; k < angle.quarters; ++k) unit = quarter_turn(unit);
    return unit;
}

/// coefficient · … · cos(angle + quarters), with the quarter turns absorbed into sign and function; adds nothing where
/// it vanishes.
void add_turned(Sum& sum, Term term, const Angle& angle, bool sine) {
    // cos(x + q 90°), and sin x = cos(x − 90°).
    const int quarters = (angle.quarters + (sine ? 3 : 0)) % 4;
    const bool is_sine = quarters % 2 == 1;
    if (quarters == 1 || quarters == 2) term.coefficient = -term.coefficient;
    if (angle.letters.empty()) {
        if (is_sine) return;
    } else {
        term.turn = is_sine ? Term::Turn::sin : Term::Turn::cos;
        term.angle = angle.letters;
    }
    sum.push_back(std::move(term));
}

/// The variable letters of a side.
struct Varying {
    bool length = false;
    std::vector<LetterIndex> turns;
};
Varying varying(const Equations& equations, const Side& side) {
    Varying found;
    found.length = equations.letter(side.length).role != Letter::Role::given;
    for (const LetterIndex letter : side.angle.letters)
        if (equations.letter(letter).role != Letter::Role::given) found.turns.push_back(letter);
    return found;
}

/// Rows and matrices in symbols.
class Rows {
public:
    explicit Rows(Equations& equations) : e_(equations) {}

    void write() {
        for (std::size_t i = 0; i < e_.letters.size(); ++i) {
            if (e_.letters[i].role == Letter::Role::dependent) e_.unknowns.push_back(static_cast<LetterIndex>(i));
            if (e_.letters[i].role == Letter::Role::free) e_.free.push_back(static_cast<LetterIndex>(i));
        }
        for (const Equations::Loop& loop : e_.loops)
            for (const bool imaginary : {false, true}) {
                e_.f_y.push_back(row(loop, e_.unknowns, imaginary));
                e_.f_x.push_back(row(loop, e_.free, imaginary));
                e_.second_order.push_back(second_order(loop, imaginary));
            }
        for (const Equations::Law& law : e_.laws) {
            e_.f_y.push_back(row(law, e_.unknowns));
            e_.f_x.push_back(row(law, e_.free));
            e_.second_order.emplace_back();
        }
    }

private:
    std::vector<Sum> row(const Equations::Loop& loop, const std::vector<LetterIndex>& columns, bool imaginary) const {
        std::vector<Sum> entries;
        for (const LetterIndex column : columns) {
            Sum& entry = entries.emplace_back();
            for (const Side& side : loop.sides) {
                Term term;
                term.coefficient = side.on_the_right ? -1 : 1;
                if (side.length == column) add_turned(entry, term, side.angle, imaginary);
                if (std::find(side.angle.letters.begin(), side.angle.letters.end(), column) == side.angle.letters.end())
                    continue;
                term.lengths = {side.length};
                Angle ahead = side.angle;
                ahead.quarters = (ahead.quarters + 1) % 4;
                add_turned(entry, term, ahead, imaginary);
            }
        }
        return entries;
    }
    static std::vector<Sum> row(const Equations::Law& law, const std::vector<LetterIndex>& columns) {
        std::vector<Sum> entries;
        for (const LetterIndex column : columns) {
            Sum& entry = entries.emplace_back();
            for (const Equations::Law::Part& part : law.parts)
                for (const auto& [sign, letter] : part.sum) {
                    if (letter != column) continue;
                    Term term;
                    term.coefficient = part.sign * sign;
                    if (part.radius >= 0) term.lengths = {part.radius};
                    // Terms that differ in sign only cancel; terms with different radii do not.
                    const auto same = std::find_if(entry.begin(), entry.end(),
                                                   [&](const Term& each) { return each.lengths == term.lengths; });
                    if (same == entry.end())
                        entry.push_back(std::move(term));
                    else if ((same->coefficient += term.coefficient) == 0)
                        entry.erase(same);
                }
        }
        return entries;
    }
    Sum second_order(const Equations::Loop& loop, bool imaginary) const {
        Sum sum;
        for (const Side& side : loop.sides) {
            const Varying own = varying(e_, side);
            if (own.turns.empty()) continue;
            const int sign = side.on_the_right ? -1 : 1;
            Term centripetal;
            centripetal.coefficient = -sign;
            centripetal.lengths = {side.length};
            centripetal.rates = {{own.turns, 1, 2}};
            add_turned(sum, centripetal, side.angle, imaginary);
            if (!own.length) continue;
            Term coriolis;
            coriolis.coefficient = 2 * sign;
            coriolis.rates = {{{side.length}, 1, 1}, {own.turns, 1, 1}};
            Angle ahead = side.angle;
            ahead.quarters = (ahead.quarters + 1) % 4;
            add_turned(sum, coriolis, ahead, imaginary);
        }
        return sum;
    }

    Equations& e_;
};

Exact power(const Exact& base, int exponent) {
    Exact value = 1;
    for (int k = 0; k < exponent; ++k) value *= base;
    return value;
}
/// `rate` by letter and order of derivative.
template <class Rate>
Exact evaluate(const Equations& equations, const Term& term, Rate rate) {
    Exact value = term.coefficient;
    for (const LetterIndex length : term.lengths) value *= equations.letter(length).exact;
    for (const Term::Rate& each : term.rates) {
        Exact sum;
        for (const LetterIndex letter : each.sum) sum += rate(letter, each.dots);
        value *= power(sum, each.power);
    }
    if (term.turn == Term::Turn::plain) return value;
    const Vector unit = unit_of(equations, {term.angle, 0});
    return value * (term.turn == Term::Turn::cos ? unit.x : unit.y);
}
template <class Rate>
Exact evaluate(const Equations& equations, const Sum& sum, Rate rate) {
    Exact value;
    for (const Term& term : sum) value += evaluate(equations, term, rate);
    return value;
}

/// Gaussian elimination with complete pivoting on rows and columns of similar size.
class Gauss {
public:
    using Matrix = std::vector<std::vector<Exact>>;
    Gauss(Matrix matrix, std::size_t columns, double vanishing)
        : a_(std::move(matrix)), columns_(columns), vanishing_(vanishing) {
        for (std::size_t i = 0; i < a_.size(); ++i) row_.push_back(i);
        for (std::size_t j = 0; j < columns; ++j) column_.push_back(j);
    }
    /// The right sides are further columns of the matrix.
    void run() {
        double first = 0;
        for (; rank_ < std::min(a_.size(), columns_); ++rank_) {
            double largest = 0;
            std::size_t best_row = rank_, best_column = rank_;
            for (std::size_t i = rank_; i < a_.size(); ++i)
                for (std::size_t j = rank_; j < columns_; ++j)
                    if (const double size = std::abs(at(i, column_[j]).to_double()); size > largest)
                        largest = size, best_row = i, best_column = j;
            if (rank_ == 0) first = largest;
            if (!(largest > vanishing_ * first)) break;
            if (best_row != rank_) sign_ = -sign_, std::swap(row_[rank_], row_[best_row]);
            if (best_column != rank_) sign_ = -sign_, std::swap(column_[rank_], column_[best_column]);
            const std::size_t pivot_column = column_[rank_];
            determinant_ *= at(rank_, pivot_column);
            for (std::size_t i = 0; i < a_.size(); ++i) {
                if (i == rank_ || at(i, pivot_column).is_zero()) continue;
                const Exact share = at(i, pivot_column) / at(rank_, pivot_column);
                for (std::size_t j = 0; j < a_[i].size(); ++j)
                    if (!at(rank_, j).is_zero()) at(i, j) -= share * at(rank_, j);
                at(i, pivot_column) = 0;
            }
        }
    }
    int rank() const { return static_cast<int>(rank_); }
    Exact determinant() const {
        return rank_ == columns_ && a_.size() == columns_ ? (sign_ < 0 ? -determinant_ : determinant_) : Exact(0);
    }
    /// An unknown for one of the right sides; none where it is free, or the equations are inconsistent.
    std::optional<Exact> solution(std::size_t unknown, std::size_t right) const {
        double size = 0, left = 0;
        for (std::size_t i = 0; i < a_.size(); ++i) {
            const double own = std::abs(a_[row_[i]][columns_ + right].to_double());
            size = std::max(size, own);
            if (i >= rank_) left = std::max(left, own);
        }
        if (left > contradiction * size) return std::nullopt;
        for (std::size_t k = 0; k < rank_; ++k) {
            if (column_[k] != unknown) continue;
            const std::vector<Exact>& own = a_[row_[k]];
            for (std::size_t j = rank_; j < columns_; ++j)
                if (std::abs(own[column_[j]].to_double()) > contradiction * std::abs(own[unknown].to_double()))
                    return std::nullopt;
            return own[columns_ + right] / own[unknown];
        }
        return std::nullopt;
    }

private:
    static constexpr double contradiction = 1e-9;
    Exact& at(std::size_t i, std::size_t j) { return a_[row_[i]][j]; }

    Matrix a_;
    std::size_t columns_, rank_ = 0;
    double vanishing_;
    std::vector<std::size_t> row_, column_;
    Exact determinant_ = 1;
    int sign_ = 1;
};

class Values {
public:
    Values(Equations& equations, const Pose& pose, const std::vector<std::pair<Exact, Exact>>& rates)
        : e_(equations),
          size_(pose.size),
          vanishing_(std::max(std::ldexp(1.0, -60), 16 * pose.rounding())),
          given_(rates) {
        given_.resize(e_.letters.size());
    }

    void find() {
        const auto resting = [](LetterIndex, int) { return Exact(0); };
        for (std::size_t i = 0; i < e_.f_y.size(); ++i) {
            y_.emplace_back();
            x_.emplace_back();
            e_.jacobian.emplace_back();
            e_.drive.emplace_back();
            for (const Sum& entry : e_.f_y[i]) {
                y_.back().push_back(evaluate(e_, entry, resting));
                e_.jacobian.back().push_back(y_.back().back().to_double());
            }
            for (const Sum& entry : e_.f_x[i]) {
                x_.back().push_back(evaluate(e_, entry, resting));
                e_.drive.back().push_back(x_.back().back().to_double());
            }
        }
        find_ratios();
        find_rates();
        find_dead_point();
    }

private:
    std::size_t unknowns() const { return e_.unknowns.size(); }
    bool is_law_of_turns(std::size_t row) const {
        if (row < 2 * e_.loops.size()) return false;
        const Equations::Law& law = e_.laws[row - 2 * e_.loops.size()];
        return law.kind == Equations::Law::Kind::driver && e_.letter(law.parts.front().sum.front().second).is_angle;
    }
    Exact row_scale(std::size_t row) const { return is_law_of_turns(row) ? Exact(1) : Exact(1) / size_; }
    Exact column_scale(LetterIndex letter) const { return e_.letter(letter).is_angle ? Exact(1) : size_; }

    /// f_y, scaled, with right sides, by row and column.
    Gauss eliminated(const std::vector<std::vector<Exact>>& right) const {
        Gauss::Matrix matrix(y_.size());
        for (std::size_t i = 0; i < y_.size(); ++i) {
            const Exact scale = row_scale(i);
            for (std::size_t j = 0; j < unknowns(); ++j)
                matrix[i].push_back(scale * y_[i][j] * column_scale(e_.unknowns[j]));
            for (const Exact& each : right[i]) matrix[i].push_back(scale * each);
        }
        Gauss gauss(std::move(matrix), unknowns(), vanishing_);
        gauss.run();
        return gauss;
    }
    std::optional<Exact> solution(const Gauss& gauss, std::size_t unknown, std::size_t right) const {
        auto value = gauss.solution(unknown, right);
        if (value) *value *= column_scale(e_.unknowns[unknown]);
        return value;
    }

    void find_ratios() {
        std::vector<std::vector<Exact>> right(y_.size());
        for (std::size_t i = 0; i < y_.size(); ++i)
            for (const Exact& each : x_[i]) right[i].push_back(-each);
        const Gauss gauss = eliminated(right);
        e_.rank = gauss.rank();
        if (y_.size() == unknowns()) {
            Exact scale = 1;
            for (std::size_t i = 0; i < y_.size(); ++i) scale *= row_scale(i) * column_scale(e_.unknowns[i]);
            e_.determinant = (gauss.determinant() / scale).to_double();
        }
        ratios_.assign(unknowns(), std::vector<std::optional<Exact>>(e_.free.size()));
        e_.ratios.assign(unknowns(), std::vector<std::optional<double>>(e_.free.size()));
        for (std::size_t j = 0; j < unknowns(); ++j)
            for (std::size_t k = 0; k < e_.free.size(); ++k) {
                ratios_[j][k] = solution(gauss, j, k);
                if (ratios_[j][k]) e_.ratios[j][k] = ratios_[j][k]->to_double();
            }
        if (e_.is_regular() && e_.by_tangent.empty()) find_second_ratios();
    }

    /// The right sides −(second order) for velocities by letter.
    std::vector<Exact> bent(const std::vector<Exact>& rate) const {
        std::vector<Exact> right;
        for (const Sum& sum : e_.second_order)
            right.push_back(-evaluate(e_, sum, [&](LetterIndex letter, int) { return rate[at_index(letter)]; }));
        return right;
    }
    std::vector<Exact> along(std::size_t free) const {
        std::vector<Exact> rate(e_.letters.size());
        rate[at_index(e_.free[free])] = 1;
        for (std::size_t j = 0; j < unknowns(); ++j)
            rate[at_index(e_.unknowns[j])] = ratios_[j][free].value_or(Exact(0));
        return rate;
    }
    /// The second order is quadratic in the rates: the value for two drivers together minus the values for each alone
    /// is twice the mixed term.
    void find_second_ratios() {
        const std::size_t n = e_.free.size();
        std::vector<std::vector<Exact>> right(y_.size());
        const auto add = [&](const std::vector<Exact>& rate) {
            const std::vector<Exact> own = bent(rate);
            for (std::size_t i = 0; i < own.size(); ++i) right[i].push_back(own[i]);
        };
        for (std::size_t k = 0; k < n; ++k)
            for (std::size_t l = k; l < n; ++l) {
                std::vector<Exact> rate = along(k);
                const std::vector<Exact> other = along(l);
                if (l > k)
                    for (std::size_t i = 0; i < rate.size(); ++i) rate[i] += other[i];
                add(rate);
            }
        const Gauss gauss = eliminated(right);
        e_.second_ratios.assign(
            unknowns(), std::vector<std::vector<std::optional<double>>>(n, std::vector<std::optional<double>>(n)));
        for (std::size_t j = 0; j < unknowns(); ++j) {
            std::vector<std::vector<Exact>> whole(n, std::vector<Exact>(n));
            std::size_t column = 0;
            for (std::size_t k = 0; k < n; ++k)
                for (std::size_t l = k; l < n; ++l) whole[k][l] = solution(gauss, j, column++).value_or(Exact(0));
            for (std::size_t k = 0; k < n; ++k)
                for (std::size_t l = 0; l < n; ++l) {
                    const std::size_t a = std::min(k, l), b = std::max(k, l);
                    const Exact value = a == b ? whole[a][a] : (whole[a][b] - whole[a][a] - whole[b][b]) / 2;
                    e_.second_ratios[j][k][l] = value.to_double();
                }
        }
    }

    void find_rates() {
        std::vector<Exact> rate(e_.letters.size()), second(e_.letters.size());
        for (Letter& letter : e_.letters)
            if (letter.role == Letter::Role::given) letter.rate = letter.acceleration = 0.0;
        for (const LetterIndex free : e_.free) {
            rate[at_index(free)] = given_[at_index(free)].first;
            second[at_index(free)] = given_[at_index(free)].second;
            e_.letters[at_index(free)].rate = rate[at_index(free)].to_double();
            e_.letters[at_index(free)].acceleration = second[at_index(free)].to_double();
        }
        bool all = true;
        for (std::size_t j = 0; j < unknowns(); ++j) {
            Exact sum;
            bool known = !e_.free.empty();
            for (std::size_t k = 0; k < e_.free.size(); ++k) {
                known = known && ratios_[j][k].has_value();
                if (known) sum += *ratios_[j][k] * rate[at_index(e_.free[k])];
            }
            all = all && known;
            if (!known) continue;
            rate[at_index(e_.unknowns[j])] = sum;
            e_.letters[at_index(e_.unknowns[j])].rate = sum.to_double();
        }
        if (all && e_.by_tangent.empty()) find_accelerations(rate, second);
    }
    void find_accelerations(const std::vector<Exact>& rate, const std::vector<Exact>& second) {
        const std::vector<Exact> own = bent(rate);
        std::vector<std::vector<Exact>> right(y_.size());
        for (std::size_t i = 0; i < y_.size(); ++i) {
            Exact sum = own[i];
            for (std::size_t k = 0; k < e_.free.size(); ++k) sum -= x_[i][k] * second[at_index(e_.free[k])];
            right[i].push_back(std::move(sum));
        }
        const Gauss gauss = eliminated(right);
        for (std::size_t j = 0; j < unknowns(); ++j)
            if (const auto value = solution(gauss, j, 0))
                e_.letters[at_index(e_.unknowns[j])].acceleration = value->to_double();
    }

    /// A free letter is at rest in every motion if the row "it is at rest" depends on the equations.
    void find_dead_point() {
        if (e_.is_regular()) return;
        Gauss::Matrix whole(y_.size());
        for (std::size_t i = 0; i < y_.size(); ++i) {
            for (std::size_t j = 0; j < unknowns(); ++j)
                whole[i].push_back(row_scale(i) * y_[i][j] * column_scale(e_.unknowns[j]));
            for (std::size_t k = 0; k < e_.free.size(); ++k)
                whole[i].push_back(row_scale(i) * x_[i][k] * column_scale(e_.free[k]));
        }
        const auto rank_of = [&](Gauss::Matrix matrix) {
            Gauss gauss(std::move(matrix), unknowns() + e_.free.size(), vanishing_);
            gauss.run();
            return gauss.rank();
        };
        const int rank = rank_of(whole);
        for (std::size_t k = 0; k < e_.free.size(); ++k) {
            Gauss::Matrix more = whole;
            more.emplace_back(unknowns() + e_.free.size());
            more.back()[unknowns() + k] = 1;
            if (rank_of(std::move(more)) == rank) e_.cannot_be_driven.push_back(e_.free[k]);
        }
    }

    Equations& e_;
    Exact size_;
    double vanishing_;
    std::vector<std::pair<Exact, Exact>> given_;
    std::vector<std::vector<Exact>> y_, x_;  // f_y and f_x
    std::vector<std::vector<std::optional<Exact>>> ratios_;
};

/// Which unknowns each loop introduces, how they are computed, and which rows are solved together.
class Order {
public:
    explicit Order(Equations& equations) : e_(equations) {}

    void find() {
        known_.assign(e_.letters.size(), true);
        for (const LetterIndex unknown : e_.unknowns) known_[at_index(unknown)] = false;
        law_taken_.assign(e_.laws.size(), false);
        take_laws();
        close_block();
        for (std::size_t i = 0; i < e_.loops.size(); ++i) {
            Equations::Loop& loop = e_.loops[i];
            for (const Side& side : loop.sides) {
                offer(loop.unknowns, side.length);
                for (const LetterIndex letter : side.angle.letters) offer(loop.unknowns, letter);
            }
            solve(loop);
            block_.rows.push_back(static_cast<int>(2 * i));
            block_.rows.push_back(static_cast<int>(2 * i + 1));
            for (const LetterIndex unknown : loop.unknowns) learn(unknown);
            take_laws();
            close_block();
        }
        for (std::size_t i = 0; i < e_.laws.size(); ++i)
            if (!law_taken_[i]) take_law(i);
        if (!block_.rows.empty() || !block_.unknowns.empty()) e_.blocks.push_back(std::move(block_));
    }

private:
    void offer(std::vector<LetterIndex>& list, LetterIndex letter) const {
        if (!known_[at_index(letter)] && std::find(list.begin(), list.end(), letter) == list.end())
            list.push_back(letter);
    }
    void learn(LetterIndex letter) {
        if (known_[at_index(letter)]) return;
        known_[at_index(letter)] = true;
        block_.unknowns.push_back(letter);
    }
    std::vector<LetterIndex> open_in(const Equations::Law& law) const {
        std::vector<LetterIndex> open;
        for (const Equations::Law::Part& part : law.parts)
            for (const auto& each : part.sum) offer(open, each.second);
        return open;
    }
    void take_law(std::size_t i) {
        law_taken_[i] = true;
        for (const LetterIndex letter : open_in(e_.laws[i])) learn(letter);
        block_.rows.push_back(static_cast<int>(2 * e_.loops.size() + i));
    }
    /// Laws that determine one more letter, or that relate letters of this block.
    void take_laws() {
        for (bool more = true; more;) {
            more = false;
            for (std::size_t i = 0; i < e_.laws.size(); ++i) {
                if (law_taken_[i] || open_in(e_.laws[i]).size() > 1) continue;
                take_law(i);
                close_block();
                more = true;
            }
        }
    }
    void close_block() {
        if (block_.rows.empty() || block_.rows.size() != block_.unknowns.size()) return;
        e_.blocks.push_back(std::exchange(block_, {}));
    }

    // --- closed forms
    // -----------------------------------------------------------------------------------------------------------

    bool turns_with(const Side& side, LetterIndex letter) const {
        return std::find(side.angle.letters.begin(), side.angle.letters.end(), letter) != side.angle.letters.end();
    }
    /// The only side that contains a letter; −1: none, or several.
    int only_side(const Equations::Loop& loop, LetterIndex letter) const {
        int found = -1;
        for (std::size_t i = 0; i < loop.sides.size(); ++i) {
            if (loop.sides[i].length != letter && !turns_with(loop.sides[i], letter)) continue;
            if (found >= 0) return -1;
            found = static_cast<int>(i);
        }
        return found;
    }
    /// The only other side that rotates with a sliding side, perpendicular to it; −1: none, or several, or the slide
    /// does not rotate.
    int arm_of(const Equations::Loop& loop, LetterIndex turn, int sliding) const {
        if (sliding < 0 || !e_.letter(turn).is_angle || !turns_with(loop.sides[at_index(sliding)], turn)) return -1;
        const Equations::Angle& own = loop.sides[at_index(sliding)].angle;
        int arm = -1;
        for (int i = 0; i < static_cast<int>(loop.sides.size()); ++i) {
            const Side& side = loop.sides[at_index(i)];
            if (i == sliding || !turns_with(side, turn)) continue;
            const bool is_square = side.angle.letters == own.letters && (side.angle.quarters - own.quarters) % 2 != 0;
            if (arm >= 0 || !is_square) return -1;
            arm = i;
        }
        return arm;
    }
    void solve(Equations::Loop& loop) {
        Solved& solved = loop.solved;
        if (loop.unknowns.empty()) solved.kind = Solved::Kind::nothing;
        if (loop.unknowns.size() != 2) return;
        LetterIndex first = loop.unknowns[0], second = loop.unknowns[1];
        if (!e_.letter(first).is_angle) std::swap(first, second);
        solved.first = only_side(loop, first);
        solved.second = only_side(loop, second);
        const int arm = e_.letter(second).is_angle ? -1 : arm_of(loop, first, solved.second);
        if (arm >= 0) solved.first = std::exchange(solved.second, arm);
        if (solved.first < 0 || solved.second < 0) return;
        const bool first_turns = e_.letter(first).is_angle, second_turns = e_.letter(second).is_angle;
        if (arm >= 0)
            solved.kind = Solved::Kind::turn_with_offset_slide;
        else if (solved.first == solved.second)
            solved.kind = Solved::Kind::turn_with_slide;
        else if (first_turns && second_turns)
            solved.kind = Solved::Kind::two_turns;
        else if (first_turns)
            solved.kind = Solved::Kind::turn_and_slide;
        else
            solved.kind = Solved::Kind::two_slides;
        const std::array<double, 2> k = resultant(loop, -1);
        solved.resultant = nearest::hypot(k[0], k[1]);
        solved.direction = nearest::atan2(k[1], k[0]);
        if (e_.by_tangent.empty()) find_dead_points(loop);
    }
    /// The sum of the unknown sides, the first of them counted forwards, without an excluded side.
    std::array<double, 2> resultant(const Equations::Loop& loop, int without) const {
        const double lead = loop.sides[at_index(loop.solved.first)].on_the_right ? -1 : 1;
        std::array<double, 2> sum{0, 0};
        for (int i = 0; i < static_cast<int>(loop.sides.size()); ++i) {
            if (i == loop.solved.first || i == loop.solved.second || i == without) continue;
            const Side& side = loop.sides[at_index(i)];
            const std::array<double, 2> own = value_of(e_, side);
            const double sign = (side.on_the_right ? 1 : -1) * lead;
            sum[0] += sign * own[0];
            sum[1] += sign * own[1];
        }
        return sum;
    }

    /// The only variable side among the known ones, and its only variable letter; (−1, −1) where there is none, or
    /// several.
    std::pair<int, LetterIndex> driving_side(const Equations::Loop& loop) const {
        std::pair<int, LetterIndex> driving{-1, -1};
        for (int i = 0; i < static_cast<int>(loop.sides.size()); ++i) {
            if (i == loop.solved.first || i == loop.solved.second) continue;
            const Varying own = varying(e_, loop.sides[at_index(i)]);
            if (!own.length && own.turns.empty()) continue;
            if (driving.first >= 0 || (own.length && !own.turns.empty()) || own.turns.size() > 1) return {-1, -1};
            driving = {i, own.length ? loop.sides[at_index(i)].length : own.turns.front()};
        }
        return driving;
    }
    static constexpr double touching = 1e-12;  ///< relative rounding difference of equal sums of lengths
    static constexpr double same_turn = 1e-9;

    /// The only variable side among the known ones, and the sum of the others.
    struct DrivenSide {
        LetterIndex driver = -1;
        bool turning = false;
        std::array<double, 2> rest{0, 0};
        double own = 0;  ///< direction of its contribution to the resultant
        double length = 0;
    };
    /// Values of the driver.
    struct Limits {
        std::vector<double> dead_points, change_points;
    };
    std::optional<DrivenSide> driven_side(const Equations::Loop& loop) const {
        const auto [index, driver] = driving_side(loop);
        if (index < 0 || e_.letter(driver).role != Letter::Role::free || loop.solved.kind == Solved::Kind::two_slides)
            return std::nullopt;
        const Side& side = loop.sides[at_index(index)];
        const bool same = side.on_the_right != loop.sides[at_index(loop.solved.first)].on_the_right;
        return DrivenSide{driver, e_.letter(driver).is_angle, resultant(loop, index),
                          value_of(e_, side.angle) + (same ? 0 : std::numbers::pi), e_.letter(side.length).value};
    }

    /// For a single driven letter in a single known side: the positions where the dyad is stretched or folded (two
    /// rotating sides), its rotating side is perpendicular to the slide, or the slide's length vanishes. Where two of
    /// them coincide, the dyad only touches its limit.
    void find_dead_points(Equations::Loop& loop) const {
        Solved& solved = loop.solved;
        const std::optional<DrivenSide> driven = driven_side(loop);
        if (!driven) return;
        const bool slides = solved.kind == Solved::Kind::turn_and_slide;
        Limits limits = slides ? limits_of_slide(loop, *driven) : limits_of_reach(loop, *driven);
        if (slides && driven->turning) find_standstills(loop, *driven);
        for (std::vector<double>* each : {&limits.dead_points, &limits.change_points}) {
            std::sort(each->begin(), each->end());
            const double near = driven->turning ? same_turn : 1e-9 * (driven->length + 1e-30);
            each->erase(
                std::unique(each->begin(), each->end(), [&](double a, double b) { return std::abs(a - b) < near; }),
                each->end());
        }
        solved.dead_points = std::move(limits.dead_points);
        solved.change_points = std::move(limits.change_points);
    }

    /// The angles of the driver for which its side makes the angle of this cosine with the direction `from`: two, one
    /// (the dyad only touches its limit), or none.
    void add_turns(Limits& limits, const DrivenSide& driven, double cosine, double from) const {
        if (std::abs(cosine) > 1 + touching) return;
        const auto turn = [&](double direction) {
            const double turned =
                std::remainder(direction - driven.own + e_.letter(driven.driver).value, 2 * std::numbers::pi);
            return turned < same_turn - std::numbers::pi ? turned + 2 * std::numbers::pi : turned;
        };
        if (std::abs(cosine) > 1 - touching) {
            limits.change_points.push_back(turn(cosine > 0 ? from : from + std::numbers::pi));
            return;
        }
        const double half = nearest::acos(cosine);
        for (const double each : {from + half, from - half}) limits.dead_points.push_back(turn(each));
    }

    /// n · (rest + own) = ± b, n perpendicular to the slide.
    Limits limits_of_slide(const Equations::Loop& loop, const DrivenSide& driven) const {
        const Solved& solved = loop.solved;
        Limits limits;
        const double b = e_.letter(loop.sides[at_index(solved.first)].length).value;
        const double along = value_of(e_, loop.sides[at_index(solved.second)].angle) + std::numbers::pi / 2;
        const double across = driven.rest[0] * nearest::cos(along) + driven.rest[1] * nearest::sin(along),
                     tilt = nearest::cos(driven.own - along);
        for (const double reach : {b, -b}) {
            if (driven.turning)
                add_turns(limits, driven, (reach - across) / driven.length, along);
            else if (std::abs(tilt) > 1e-12)
                limits.dead_points.push_back((reach - across) / tilt);
        }
        return limits;
    }

    /// The lengths of the resultant at the limits of the dyad.
    std::vector<double> limiting_reaches(const Equations::Loop& loop) const {
        const Solved& solved = loop.solved;
        const double first = e_.letter(loop.sides[at_index(solved.first)].length).value;
        if (solved.kind == Solved::Kind::two_turns) {
            const double second = e_.letter(loop.sides[at_index(solved.second)].length).value;
            return {first + second, std::abs(first - second)};
        }
        if (solved.kind == Solved::Kind::turn_with_offset_slide)
            return {e_.letter(loop.sides[at_index(solved.second)].length).value};
        return {0};
    }
    /// |rest + own| = reach.
    Limits limits_of_reach(const Equations::Loop& loop, const DrivenSide& driven) const {
        Limits limits;
        const double w = nearest::hypot(driven.rest[0], driven.rest[1]),
                     to = nearest::atan2(driven.rest[1], driven.rest[0]);
        const double length = driven.length;
        for (const double reach : limiting_reaches(loop)) {
            if (driven.turning) {
                if (w > 1e-12 * length)
                    add_turns(limits, driven, (reach * reach - w * w - length * length) / (2 * w * length), to);
                continue;
            }
            const double middle = -w * nearest::cos(driven.own - to), inside = reach * reach - w * w + middle * middle;
            const double grain = touching * (reach * reach + w * w);
            if (inside < -grain) continue;
            if (inside <= grain) {
                limits.change_points.push_back(middle);
                continue;
            }
            limits.dead_points.push_back(middle + std::sqrt(inside));
            limits.dead_points.push_back(middle - std::sqrt(inside));
        }
        return limits;
    }

    /// A crank of length r and direction `own`, a connecting rod b: e^{iα} r − b e^{iβ} = ± s u − rest has length r ± b
    /// where they are in line.
    void find_standstills(Equations::Loop& loop, const DrivenSide& driven) const {
        Solved& solved = loop.solved;
        const Side &rod = loop.sides[at_index(solved.first)], &slide = loop.sides[at_index(solved.second)];
        const double b = e_.letter(rod.length).value, along = value_of(e_, slide.angle);
        const double sign = rod.on_the_right == slide.on_the_right ? 1 : -1;
        const double ux = nearest::cos(along), uy = nearest::sin(along);
        const double r = driven.length;
        // lead: b e^{iβ} + sign s u = rest + r e^{iα}.
        const double ahead = sign * (driven.rest[0] * ux + driven.rest[1] * uy),
                     across = driven.rest[1] * ux - driven.rest[0] * uy;
        const double side = e_.letter(slide.length).value - ahead < 0 ? -1 : 1;
        for (const double reach : {r + b, std::abs(r - b)}) {
            if (reach * reach < across * across || reach < 1e-12 * (r + b)) continue;
            const double s = ahead + side * std::sqrt(reach * reach - across * across);
            const double x = sign * s * ux - driven.rest[0], y = sign * s * uy - driven.rest[1];
            const bool against = reach < r + b && r < b;  // the crank points away from the rod's end
            const double direction = nearest::atan2(y, x) + (against ? std::numbers::pi : 0);
            solved.standstills.emplace_back(
                std::remainder(direction - driven.own + e_.letter(driven.driver).value, 2 * std::numbers::pi), s);
        }
    }

    Equations& e_;
    std::vector<bool> known_, law_taken_;
    Equations::Block block_;
};

}  // namespace

void complete(Equations& equations, const Mechanism&, const Pose& pose,
              const std::vector<std::pair<Exact, Exact>>& rates) {
    Rows(equations).write();
    Order(equations).find();
    Values(equations, pose, rates).find();
}

double value_of(const Equations& equations, const Equations::Angle& angle) {
    const Vector unit = unit_of(equations, angle);
    return nearest::atan2(unit.y.to_double(), unit.x.to_double());
}
std::array<double, 2> value_of(const Equations& equations, const Side& side) {
    const Vector unit = unit_of(equations, side.angle);
    const Exact& length = equations.letter(side.length).exact;
    return {(length * unit.x).to_double(), (length * unit.y).to_double()};
}
double value_of(const Equations& equations, const Sum& sum) {
    const auto rate = [&](LetterIndex index, int dots) {
        const Letter& letter = equations.letter(index);
        return Exact::from_double((dots == 1 ? letter.rate : letter.acceleration).value_or(0));
    };
    Exact value, size;
    for (const Equations::Term& term : sum) {
        const Exact own = evaluate(equations, term, rate);
        value += own;
        size += abs(own);
    }
    // The rates are doubles: below this many bits, the sum of cancelling terms is zero.
    constexpr int kept_bits = 46;
    return abs(value) <= Exact::power_of_two(-kept_bits) * size ? 0 : value.to_double();
}

std::pair<std::optional<std::array<double, 2>>, std::optional<std::array<double, 2>>> change_of(
    const Equations& equations, const Side& side) {
    const Letter& length = equations.letter(side.length);
    std::optional<double> turn = 0.0, second = 0.0;
    for (const LetterIndex index : side.angle.letters) {
        const Letter& letter = equations.letter(index);
        turn = turn && letter.rate ? std::optional(*turn + *letter.rate) : std::nullopt;
        second = second && letter.acceleration ? std::optional(*second + *letter.acceleration) : std::nullopt;
    }
    if (!turn || !length.rate) return {};
    const Vector unit = unit_of(equations, side.angle);
    const double x = unit.x.to_double(), y = unit.y.to_double(), l = length.value;
    const auto at = [&](double radial, double across) {
        return std::array<double, 2>{radial * x - across * y, radial * y + across * x};
    };
    std::pair<std::optional<std::array<double, 2>>, std::optional<std::array<double, 2>>> change;
    change.first = at(*length.rate, l * *turn);
    if (second && length.acceleration)
        change.second = at(*length.acceleration - l * *turn * *turn, 2 * *length.rate * *turn + l * *second);
    return change;
}

}  // namespace kinegraph
