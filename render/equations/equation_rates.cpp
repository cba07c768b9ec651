#include "render/equations/equation_chapters.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "engine/equations/equations_values.hpp"
#include "engine/number/functions.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/equations.hpp"
#include "render/text/utf8.hpp"

namespace kinegraph::render::closure {

void RateText::write_velocities() {
    list_.heading({lang::common::velocities}, true);
    const std::string& unit = mechanism_.units.length.symbol;
    list_.announce(e_.loops.empty() ? Words(lang::equations::differentiating_the_laws_once_with_entries, unit)
                                    : Words(lang::equations::differentiating_the_loops_once_with_entries, unit));
    for (const Equations::Loop& loop : e_.loops) list_.set(derived(loop, false));
    for (const Equations::Law& law : e_.laws)
        list_.set(
            equal(pen_.law_sum(law, [&](LetterIndex each) { return pen_.name(each, 1); }), Formula::upright("0")));
    for (const Equations::Block& block : e_.blocks) write_block(block, 1);
}

void RateText::write_accelerations() {
    list_.heading({lang::common::accelerations}, true);
    list_.announce({lang::equations::differentiating_once_more_the_matrix});
    for (const Equations::Loop& loop : e_.loops) list_.set(derived(loop, true));
    for (const Equations::Block& block : e_.blocks) write_block(block, 2);
}

Formula RateText::derived(const Equations::Loop& loop, bool twice) const {
    std::array<std::vector<Signed>, 2> terms;
    for (const Side& each : loop.sides) {
        std::vector<Signed>& own = terms.at(each.on_the_right ? 1 : 0);
        twice ? pen_.add_acceleration(each, own, 1) : pen_.add_velocity(each, own, 1);
    }
    return equal(joined(terms[0]), joined(terms[1]));
}

Sum RateText::times_rate(Sum sum, LetterIndex rate, int dots) {
    for (Term& each : sum) each.rates.push_back({{rate}, dots, 1});
    return sum;
}

std::size_t RateText::column_of(LetterIndex unknown) const {
    return static_cast<std::size_t>(std::find(e_.unknowns.begin(), e_.unknowns.end(), unknown) - e_.unknowns.begin());
}

bool RateText::is_in(const Equations::Block& block, LetterIndex unknown) const {
    return std::find(block.unknowns.begin(), block.unknowns.end(), unknown) != block.unknowns.end();
}

Sum RateText::known_terms(const Equations::Block& block, std::size_t row, int dots) const {
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

bool RateText::is_of_turns(std::size_t row) const {
    return row >= 2 * e_.loops.size() && e_.laws[row - 2 * e_.loops.size()].kind == Equations::Law::Kind::driver &&
           pen_.letter(e_.laws[row - 2 * e_.loops.size()].parts.front().sum.front().second).is_angle;
}

double RateText::in_units(std::size_t row, LetterIndex unknown, double entry) const {
    return pen_.letter(unknown).is_angle && !is_of_turns(row) ? entry / length_unit() : entry;
}

Formula RateText::unknowns_column(const Equations::Block& block, int dots) const {
    std::vector<Formula> all;
    for (const LetterIndex each : block.unknowns) all.push_back(pen_.name(each, dots));
    return column(std::move(all));
}

Formula RateText::matrix(const Equations::Block& block, bool symbols) const {
    std::vector<Formula> entries;
    for (const int r : block.rows)
        for (const LetterIndex each : block.unknowns) {
            const auto row = at_index(r);
            const std::size_t col = column_of(each);
            entries.push_back(symbols ? joined(pen_.terms(e_.f_y[row][col]))
                                      : pen_.value(rounded(in_units(row, each, e_.jacobian[row][col]))));
        }
    return Formula::matrix(std::move(entries), block.unknowns.size(), between_entries());
}

/// In plain text: a semicolon where the comma is the decimal mark.
const char* RateText::between_entries() const { return notation(pen_.language()).decimal_mark == ',' ? "; " : ", "; }

double RateText::rounded(double entry) const {
    double largest = 0;
    for (const auto& row : e_.jacobian)
        for (const double each : row) largest = std::max(largest, std::abs(each));
    return std::abs(entry) < 1e-12 * std::max(largest / length_unit(), 1e-30) ? 0 : entry;
}

Formula RateText::right_side(const Equations::Block& block, int dots, bool symbols) const {
    std::vector<Formula> entries;
    for (const int r : block.rows) {
        const Sum known = known_terms(block, at_index(r), dots);
        const double unit = is_of_turns(at_index(r)) ? 1 : length_unit();
        entries.push_back(symbols ? joined(pen_.terms(known, -1)) : pen_.value(-value_of(e_, known) / unit));
    }
    return column(std::move(entries));
}

std::optional<double> RateText::determinant(const Equations::Block& block) const {
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

bool RateText::rates_known(const Equations::Block& block, int dots) const {
    const auto known = [&](LetterIndex each) {
        return dots == 1 ? pen_.letter(each).rate.has_value() : pen_.letter(each).acceleration.has_value();
    };
    return std::all_of(block.unknowns.begin(), block.unknowns.end(), known);
}

void RateText::write_block(const Equations::Block& block, int dots) {
    if (block.unknowns.empty()) return;
    // A large system shows its matrix separately, J ẏ = …, and long right sides stand below one another.
    constexpr std::size_t most_in_line = 4, most_letters = 60;
    const bool is_large = block.unknowns.size() > most_in_line;
    if (is_large && dots == 1) write_in_parts(block);
    Formula left = (is_large ? Formula::letter("J") : matrix(block, true)) + unknowns_column(block, dots);
    if (const bool is_long =
            longest_right_side(block, dots) > most_in_line || widest_right_side(block, dots) > most_letters;
        !is_long)
        list_.set(equal(std::move(left), right_side(block, dots, true)));
    else
        write_long_right_side(block, dots, std::move(left));
    if (rates_known(block, dots)) {
        std::vector<Formula> values;
        for (const LetterIndex each : block.unknowns)
            values.push_back(pen_.amount_formula(
                each, (dots == 1 ? pen_.letter(each).rate : pen_.letter(each).acceleration).value(), dots));
        if (is_large) {
            if (dots == 1) list_.set(equal(Formula::letter("J"), matrix(block, false)));
        } else {
            list_.set(equal(matrix(block, false) + unknowns_column(block, dots), right_side(block, dots, false)));
        }
        list_.set(equal(unknowns_column(block, dots), column(std::move(values))));
    } else if (dots == 1) {
        list_.set(equal(Formula::letter("J"), matrix(block, false)));
    }
    if (dots == 1) write_determinant(block);
}

std::size_t RateText::longest_right_side(const Equations::Block& block, int dots) const {
    std::size_t longest = 0;
    for (const int r : block.rows) longest = std::max(longest, known_terms(block, at_index(r), dots).size());
    return longest;
}

std::size_t RateText::widest_right_side(const Equations::Block& block, int dots) const {
    std::size_t widest = 0;
    for (const int r : block.rows)
        widest =
            std::max(widest, character_count(joined(pen_.terms(known_terms(block, at_index(r), dots), -1)).plain()));
    return widest;
}

void RateText::write_long_right_side(const Equations::Block& block, int dots, Formula left) {
    std::vector<Formula> names;
    for (std::size_t i = 0; i < block.rows.size(); ++i) names.push_back(Formula::letter("r", std::to_string(i + 1)));
    list_.set(equal(std::move(left), column(names)));
    for (std::size_t i = 0; i < block.rows.size(); ++i)
        list_.set(equal(names[i], joined(pen_.terms(known_terms(block, at_index(block.rows[i]), dots), -1))));
}

void RateText::write_in_parts(const Equations::Block& block) {
    constexpr std::size_t most = 3, most_letters = 56, between = 3;
    std::vector<Formula> names;
    for (std::size_t first = 0; first < block.unknowns.size();) {
        Equations::Block part = block;
        part.unknowns.clear();
        for (std::size_t letters = 0; first < block.unknowns.size() && part.unknowns.size() < most; ++first) {
            Equations::Block one = block;
            one.unknowns = {block.unknowns[first]};
            std::size_t widest = 0;
            for (const Formula& entry : matrix(one, true).parts)
                widest = std::max(widest, character_count(entry.plain()));
            letters += widest + between;
            if (!part.unknowns.empty() && letters > most_letters) break;
            part.unknowns.push_back(block.unknowns[first]);
        }
        names.push_back(Formula::letter("J", std::to_string(names.size() + 1)));
        list_.set(equal(names.back(), matrix(part, true)));
    }
    const std::size_t count = names.size();
    list_.set(equal(Formula::letter("J"), Formula::matrix(std::move(names), count, between_entries())));
}

void RateText::write_determinant(const Equations::Block& block) {
    const auto found = determinant(block);
    if (!found) {
        list_.say(Words(lang::equations::equations_for_unknowns_of_rank, std::to_string(block.rows.size()),
                        std::to_string(block.unknowns.size()), std::to_string(e_.rank)));
        return;
    }
    Formula left = Formula::upright("det") + Formula::letter("J");
    if (auto closed = closed_determinant(block, *found)) left = equal(std::move(left), *std::move(closed));
    list_.set(equal(std::move(left),
                    pen_.value(e_.determinant && *e_.determinant == 0 && e_.blocks.size() == 1 ? 0 : *found)));
}

std::optional<Formula> RateText::closed_determinant(const Equations::Block& block, double found) const {
    if (block.rows.size() != 2 || at_index(block.rows.front()) >= 2 * e_.loops.size()) return std::nullopt;
    const Equations::Loop& loop = e_.loops[at_index(block.rows.front() / 2)];
    const Solved& solved = loop.solved;
    if (solved.first < 0 || solved.second < 0 || loop.unknowns.size() != 2) return std::nullopt;
    const Side &first = loop.sides[at_index(solved.first)], &second = loop.sides[at_index(solved.second)];
    const Difference between{second.angle.letters, first.angle.letters, second.angle.quarters - first.angle.quarters};
    Signed own{0, {}};
    double expected = value_of(e_, second.angle) - value_of(e_, first.angle);
    if (solved.kind == Solved::Kind::two_turns) {
        own = pen_.projected(pen_.name(first.length) + pen_.name(second.length), between, true, 1);
        expected = nearest::sin(expected);
    } else if (solved.kind == Solved::Kind::turn_and_slide) {
        own = pen_.projected(pen_.name(first.length),
                             {first.angle.letters, second.angle.letters, first.angle.quarters - second.angle.quarters},
                             false, 1);
        expected = nearest::cos(expected);
    } else if (solved.kind == Solved::Kind::turn_with_slide || solved.kind == Solved::Kind::turn_with_offset_slide) {
        own = {1, pen_.name(first.length)};
        expected = pen_.letter(first.length).value;
    }
    if (own.sign == 0) return std::nullopt;
    if (expected * found < 0) own.sign = -own.sign;
    return joined({own});
}

}  // namespace kinegraph::render::closure
