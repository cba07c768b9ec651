#include "render/equations/equation_chapters.hpp"

#include <utility>

#include "lang/keys/equations.hpp"
#include "render/text/formula.hpp"

namespace kinegraph::render::closure {

void RatioText::write_ratios() {
    bool told = false;
    for (std::size_t j = 0; j < e_.unknowns.size(); ++j)
        for (std::size_t k = 0; k < e_.free.size(); ++k) {
            if (!e_.ratios[j][k]) continue;
            if (!std::exchange(told, true)) list_.heading({lang::equations::velocity_ratios});
            const LetterIndex of = e_.unknowns[j], by = e_.free[k];
            Formula line = equal(Formula::letter("Lambda", index_of(of, {by})), derivative(of, by));
            if (auto closed = closed_ratio(of, by)) line += Formula::sign("=") + *std::move(closed);
            list_.set(std::move(line) + ratio_value(of, {by}, *e_.ratios[j][k]));
        }
}

void RatioText::write_second_ratios() {
    for (std::size_t j = 0; j < e_.unknowns.size(); ++j)
        for (std::size_t k = 0; k < e_.free.size(); ++k)
            for (std::size_t l = k; l < e_.free.size(); ++l) {
                const LetterIndex of = e_.unknowns[j], first = e_.free[k], second = e_.free[l];
                const auto& found = e_.second_ratios[j][k][l];
                if (!found) continue;
                list_.set(equal(Formula::primed("Lambda", index_of(of, {first, second}), 1),
                                second_derivative(of, first, second)) +
                          ratio_value(of, {first, second}, *found));
            }
}

Formula RatioText::derivative(LetterIndex of, LetterIndex by) const {
    const Formula d = Formula::upright(e_.free.size() > 1 ? "∂" : "d");
    return Formula::fraction(d + pen_.name(of), d + pen_.name(by));
}

Formula RatioText::second_derivative(LetterIndex of, LetterIndex first, LetterIndex second) const {
    const Formula d = Formula::upright(e_.free.size() > 1 ? "∂" : "d");
    Formula below = first == second ? d + square(pen_.name(first)) : d + pen_.name(first) + d + pen_.name(second);
    return Formula::fraction(square(d) + pen_.name(of), std::move(below));
}

std::string RatioText::index_of(LetterIndex of, std::initializer_list<LetterIndex> by) const {
    std::string index = plain_sub(of);
    if (e_.free.size() > 1)
        for (const LetterIndex each : by) index += "," + plain_sub(each);
    return index;
}

std::string RatioText::ratio_unit(LetterIndex of, std::initializer_list<LetterIndex> by) const {
    const std::string& length = mechanism_.units.length.symbol;
    int lengths = pen_.letter(of).is_angle ? 0 : 1, turns = pen_.letter(of).is_angle ? 1 : 0;
    for (const LetterIndex each : by) --(pen_.letter(each).is_angle ? turns : lengths);
    const auto power = [](int of_unit) { return of_unit == 2 ? "²" : ""; };
    // The unit of an angle is shown only beside a length.
    if (lengths == 0) return "";
    if (lengths > 0) return " " + length + (turns < 0 ? std::string("/rad") + power(-turns) : "");
    return std::string(turns > 0 ? " rad" : " 1") + "/" + length + power(-lengths);
}

double RatioText::ratio_in_units(LetterIndex of, std::initializer_list<LetterIndex> by, double si) const {
    if (!pen_.letter(of).is_angle) si /= mechanism_.units.length.si.to_double();
    for (const LetterIndex each : by)
        if (!pen_.letter(each).is_angle) si *= mechanism_.units.length.si.to_double();
    return si;
}

Formula RatioText::ratio_value(LetterIndex of, std::initializer_list<LetterIndex> by, double si) const {
    return Formula::sign("=") + Formula::upright(pen_.number_text(ratio_in_units(of, by, si)) + ratio_unit(of, by));
}

std::optional<Formula> RatioText::closed_ratio(LetterIndex of, LetterIndex by) const {
    if (pen_.letter(of).is_angle || !pen_.letter(by).is_angle) return std::nullopt;
    for (const Equations::Loop& loop : e_.loops) {
        if (loop.solved.kind != Solved::Kind::turn_and_slide) continue;
        const Side &rod = loop.sides[at_index(loop.solved.first)], &slide = loop.sides[at_index(loop.solved.second)];
        const auto is_plain = [](const Side& each, bool right, std::size_t letters) {
            return each.on_the_right == right && each.angle.quarters == 0 && each.angle.letters.size() == letters;
        };
        if (slide.length != of || !is_plain(slide, true, 0) || !is_plain(rod, false, 1)) continue;
        const Side* crank = nullptr;
        for (const Side& each : pen_.known_sides(loop)) {
            if (pen_.turning(each).empty() && !pen_.slides(each)) continue;
            if (crank != nullptr || !is_plain(each, false, 1) || each.angle.letters.front() != by) return std::nullopt;
            crank = &each;
            const Formula alpha = pen_.name(by), beta = pen_.name(rod.angle.letters.front());
            return Formula::upright("−") + pen_.name(crank->length) +
                   Formula::fenced(pen_.trigonometric(true, alpha, true) + Formula::sign("−") +
                                   pen_.trigonometric(false, alpha, true) + Formula::function("tan") + beta);
        }
    }
    return std::nullopt;
}

}  // namespace kinegraph::render::closure
