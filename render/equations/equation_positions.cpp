#include "render/equations/equation_chapters.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "engine/equations/equations_values.hpp"
#include "lang/keys/equations.hpp"

namespace kinegraph::render::closure {

void PositionText::write_positions() {
    for (std::size_t i = 0; i < e_.loops.size(); ++i) {
        const Equations::Loop& loop = e_.loops[i];
        std::string through;
        for (std::size_t k = 0; k < loop.through.size(); ++k)
            if (k == 0 || loop.through[k] != loop.through[k - 1])
                through += (through.empty() ? "" : "–") + pen_.as_letter(loop.through[k]);
        list_.announce(Words(lang::equations::loop_real_and_imaginary_part, std::to_string(i + 1), through));
        list_.set(both_sides(loop, [&](const Side& each) { return pen_.side(each); }));
        for (const bool sine : {false, true})
            list_.set(
                both_sides(loop, [&](const Side& each) { return pen_.component(each.length, each.angle, sine, 1); }));
        write_solved(loop, i);
    }
    for (const Equations::Law& law : e_.laws) write_law(law);
    for (const JointIndex joint : e_.by_tangent)
        list_.say(Words(lang::equations::of_the_contact_only_the_tangent, mechanism_.joint(joint).name));
}

Formula PositionText::both_sides(const Equations::Loop& loop, const std::function<Signed(const Side&)>& of) const {
    std::array<std::vector<Signed>, 2> terms;
    for (const Side& each : loop.sides)
        if (Signed own = of(each); own.sign != 0) terms.at(each.on_the_right ? 1 : 0).push_back(std::move(own));
    return equal(joined(terms[0]), joined(terms[1]));
}

void PositionText::write_law(const Equations::Law& law) {
    const std::string joint = law.joint == none ? std::string() : mechanism_.joint(law.joint).name;
    if (law.kind == Equations::Law::Kind::rolling)
        list_.announce(Words(lang::equations::rolling_at_counted_from_the_drawn, joint));
    else if (law.kind == Equations::Law::Kind::gear)
        list_.announce(Words(lang::equations::gears_at_counted_from_the_drawn, joint));
    else
        list_.announce({lang::equations::a_driver_of_what});
    list_.set(equal(pen_.law_sum(law, [&](LetterIndex each) { return Formula::letter("Delta") + pen_.name(each); }),
                    Formula::upright("0")));
}

void PositionText::write_solved(const Equations::Loop& loop, std::size_t index) {
    switch (loop.solved.kind) {
        case Solved::Kind::two_turns: return write_two_turns(loop, index);
        case Solved::Kind::turn_and_slide: return write_turn_and_slide(loop);
        case Solved::Kind::turn_with_slide: return write_turn_with_slide(loop, index);
        case Solved::Kind::turn_with_offset_slide: return write_turn_with_offset_slide(loop, index);
        case Solved::Kind::two_slides: return list_.say({lang::equations::both_unknowns_are_lengths_the_two});
        case Solved::Kind::nothing: return list_.say({lang::equations::all_its_quantities_are_known_already});
        case Solved::Kind::iterative:
            if (stands_alone(index)) return list_.say({lang::equations::its_unknowns_have_no_closed_form});
            return list_.say({lang::equations::its_unknowns_have_no_closed_form_here});
    }
}

bool PositionText::stands_alone(std::size_t index) const {
    const int row = static_cast<int>(2 * index);
    return std::any_of(e_.blocks.begin(), e_.blocks.end(), [&](const Equations::Block& block) {
        return block.rows.size() == 2 && std::find(block.rows.begin(), block.rows.end(), row) != block.rows.end();
    });
}

void PositionText::write_resultant(const Equations::Loop& loop, std::size_t index) {
    const Side& lead = loop.sides[at_index(loop.solved.first)];
    std::vector<Signed> sum;
    for (const Side& each : pen_.known_sides(loop)) sum.push_back(pen_.side(each, pen_.sign_of(each, lead)));
    const Formula p = Formula::letter("p", pen_.numbered(index)),
                  sigma = Formula::letter("sigma", pen_.numbered(index));
    list_.set(equal(p + Formula::power(Formula::letter("e"), pen_.imaginary() + sigma), joined(sum)));
    list_.set(equal(p, Formula::upright(pen_.amount_text(loop.solved.resultant, QuantityKind::length) + ", ")) +
              equal(sigma, Formula::upright(pen_.amount_text(loop.solved.direction, QuantityKind::angle))));
}

void PositionText::write_two_turns(const Equations::Loop& loop, std::size_t index) {
    list_.announce({lang::equations::with_what_is_known});
    write_resultant(loop, index);
    const Side &first = loop.sides[at_index(loop.solved.first)], &second = loop.sides[at_index(loop.solved.second)];
    const bool same = first.on_the_right == second.on_the_right;
    const Formula p = Formula::letter("p", pen_.numbered(index)), b = pen_.name(first.length),
                  c = pen_.name(second.length);
    const double pv = loop.solved.resultant, bv = pen_.letter(first.length).value,
                 cv = pen_.letter(second.length).value;
    const auto write = [&](const Side& of, Formula above, const Formula& below, double cosine) {
        list_.set(
            equal(pen_.trigonometric(
                      false, pen_.angle(of.angle) + Formula::sign("−") + Formula::letter("sigma", pen_.numbered(index)),
                      false),
                  Formula::fraction(std::move(above), Formula::upright("2") + below + p)) +
            Formula::sign("=") + pen_.value(cosine));
        list_.set(equal(pen_.angle(of.angle),
                        pen_.amount_formula(of.angle.letters.empty() ? of.length : of.angle.letters.front(),
                                            value_of(e_, of.angle), 0)));
    };
    const Formula plus = Formula::sign("+"), minus = Formula::sign("−");
    write(first, square(b) + plus + square(p) + minus + square(c), b, (bv * bv + pv * pv - cv * cv) / (2 * bv * pv));
    if (same)
        write(second, square(p) + plus + square(c) + minus + square(b), c,
              (pv * pv + cv * cv - bv * bv) / (2 * pv * cv));
    else
        write(second, square(b) + minus + square(p) + minus + square(c), c,
              (bv * bv - pv * pv - cv * cv) / (2 * pv * cv));
}

void PositionText::write_turn_and_slide(const Equations::Loop& loop) {
    const Side &first = loop.sides[at_index(loop.solved.first)], &second = loop.sides[at_index(loop.solved.second)];
    const auto against = [&](const Side& of) {
        return Difference{of.angle.letters, second.angle.letters, of.angle.quarters - second.angle.quarters};
    };
    const std::vector<Side> known = pen_.known_sides(loop);
    list_.announce({lang::equations::projected_square_to_the_slide});
    write_sine(first, known, against);
    const int forth = first.on_the_right == second.on_the_right ? 1 : -1;
    std::vector<Signed> along;
    for (const Side& each : known)
        if (Signed own =
                pen_.projected(pen_.name(each.length), against(each), false, forth * pen_.sign_of(each, first));
            own.sign != 0)
            along.push_back(std::move(own));
    along.push_back(pen_.projected(pen_.name(first.length), against(first), false, -forth));
    list_.set(equal(pen_.name(second.length), joined(along)) + Formula::sign("=") +
              pen_.amount_formula(second.length, pen_.letter(second.length).value, 0));
}

void PositionText::write_sine(const Side& first, const std::vector<Side>& known,
                              const std::function<Difference(const Side&)>& against) {
    Signed turning = pen_.projected({}, against(first), true, 1);
    std::vector<Signed> across;
    const Side* crank = nullptr;
    bool one_crank = true;
    for (const Side& each : known) {
        Signed own = pen_.projected(pen_.name(each.length), against(each), true, pen_.sign_of(each, first));
        if (own.sign == 0) continue;
        const bool turns = own.term.parts.size() > 1;
        if (turns && crank != nullptr) one_crank = false;
        if (turns) crank = &each;
        across.push_back(std::move(own));
    }
    const int side = turning.sign < 0 ? -1 : 1;
    for (Signed& each : across) each.sign *= side;
    if (crank != nullptr && one_crank) {
        list_.set(
            equal(Formula::letter("lambda"), Formula::fraction(pen_.name(crank->length), pen_.name(first.length))) +
            Formula::sign("=") + pen_.value(pen_.letter(crank->length).value / pen_.letter(first.length).value));
        std::vector<Signed> shares;
        for (const Side& each : known) {
            Signed own =
                pen_.projected(&each == crank ? Formula::letter("lambda")
                                              : Formula::fraction(pen_.name(each.length), pen_.name(first.length)),
                               against(each), true, side * pen_.sign_of(each, first));
            if (own.sign != 0) shares.push_back(std::move(own));
        }
        list_.set(equal(turning.term, joined(shares)));
    } else if (constexpr std::size_t most_above_a_bar = 3; across.size() > most_above_a_bar) {
        // A long sum stands on lines of its own, not above a fraction bar.
        list_.set(equal(pen_.name(first.length) + turning.term, joined(across)));
    } else {
        list_.set(equal(turning.term, Formula::fraction(joined(across), pen_.name(first.length))));
    }
    list_.set(equal(pen_.angle(first.angle),
                    Formula::upright(pen_.amount_text(value_of(e_, first.angle), QuantityKind::angle))));
}

void PositionText::write_turn_with_slide(const Equations::Loop& loop, std::size_t index) {
    const Side& first = loop.sides[at_index(loop.solved.first)];
    list_.announce({lang::equations::the_sliding_side_is_what});
    write_resultant(loop, index);
    list_.set(equal(pen_.name(first.length), Formula::letter("p", pen_.numbered(index))) + Formula::upright(", ") +
              equal(pen_.angle(first.angle), Formula::letter("sigma", pen_.numbered(index))));
}

void PositionText::write_turn_with_offset_slide(const Equations::Loop& loop, std::size_t index) {
    const Side &slide = loop.sides[at_index(loop.solved.first)], &arm = loop.sides[at_index(loop.solved.second)];
    list_.announce(Words(lang::equations::with_what_is_known_as_one_vector, pen_.spoken(arm.length)));
    write_resultant(loop, index);
    const Formula p = Formula::letter("p", pen_.numbered(index)),
                  sigma = Formula::letter("sigma", pen_.numbered(index));
    const Formula b = pen_.name(slide.length), c = pen_.name(arm.length), minus = Formula::sign("−");
    const double slid = pen_.letter(slide.length).value, pv = loop.solved.resultant, cv = pen_.letter(arm.length).value;
    list_.set(equal(b, joined({{slid < 0 ? -1 : 1, Formula::root(square(p) + minus + square(c))}})) +
              Formula::sign("=") + pen_.amount_formula(slide.length, slid, 0));
    // (b ± i c) e^{iβ} = p e^{iσ}: sin(β − σ) = ∓ c/p.
    const int quarters = ((arm.angle.quarters - slide.angle.quarters) % 4 + 4) % 4;
    const int side = (quarters == 1 ? 1 : -1) * pen_.sign_of(arm, slide);
    list_.set(equal(pen_.trigonometric(true, pen_.angle(slide.angle) + minus + sigma, false),
                    joined({{side, Formula::fraction(c, p)}})) +
              Formula::sign("=") + pen_.value(side * cv / pv));
    list_.set(equal(pen_.angle(slide.angle),
                    Formula::upright(pen_.amount_text(value_of(e_, slide.angle), QuantityKind::angle))));
}

}  // namespace kinegraph::render::closure
