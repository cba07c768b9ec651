#include "lang/keys/equations.hpp"
#include "lang/keys/notation.hpp"
#include "render/equations/equation_chapters.hpp"

#include <utility>

namespace kinegraph::render::closure {

void DeadPointText::write_dead_points() {
    auto title = [&, told = false]() mutable {
        if (!std::exchange(told, true)) list_.heading({lang::equations::dead_points});
    };
    if (!e_.is_regular() && !e_.free.empty()) {
        for (const LetterIndex each : e_.cannot_be_driven) {
            title();
            list_.say(Words(lang::equations::in_the_drawn_position_det_j, pen_.spoken(each), pen_.described(each),
                            pen_.amount_of(each, pen_.letter(each).value, 0)));
        }
        if (e_.cannot_be_driven.empty()) {
            title();
            list_.say({lang::equations::the_equations_leave_unknowns_open_here});
        }
    }
    if (e_.free.size() != 1) return;
    for (std::size_t i = 0; i < e_.loops.size(); ++i) {
        if (!e_.loops[i].solved.dead_points) continue;
        title();
        write_dead_points_of(e_.loops[i], i);
    }
}

void DeadPointText::write_dead_points_of(const Equations::Loop& loop, std::size_t index) {
    const LetterIndex driver = e_.free.front();
    const std::string of = pen_.numbered(index);
    const auto told = [&](const Words& words) {
        const std::string loop_named = of.empty() ? std::string() : pen_.in(Words(lang::equations::loop, of));
        list_.say_text(loop_named + pen_.in(words));
    };
    const Solved& solved = loop.solved;
    if (!solved.dead_points->empty())
        told(pen_.letter(driver).is_angle ? Words(lang::equations::det_j_0_at_there_cannot, pen_.spoken(driver),
                                                  list_of(*solved.dead_points, driver))
                                          : Words(lang::equations::det_j_0_at_there_cannot_be, pen_.spoken(driver),
                                                  list_of(*solved.dead_points, driver)));
    if (!solved.change_points.empty()) told(change_points_of(solved, of.empty()));
    if (solved.dead_points->empty() && solved.change_points.empty()) told(no_dead_point(of.empty()));
    for (const auto& [at, slide] : solved.standstills)
        told(Words(lang::equations::crank_and_rod_lie, pen_.spoken(driver), pen_.amount_of(driver, at, 0),
                   pen_.spoken(loop.sides[at_index(solved.second)].length),
                   pen_.amount_of(loop.sides[at_index(solved.second)].length, slide, 0)));
}

Words DeadPointText::no_dead_point(bool is_only_loop) const {
    const LetterIndex driver = e_.free.front();
    if (!pen_.letter(driver).is_angle) return {lang::equations::det_j_vanishes_for_no, pen_.spoken(driver)};
    if (is_only_loop) return {lang::equations::det_j_vanishes_for_no_the, pen_.spoken(driver)};
    return {lang::equations::det_j_vanishes_for_no_as, pen_.spoken(driver)};
}

Words DeadPointText::change_points_of(const Equations::Solved& solved, bool is_only_loop) const {
    const LetterIndex driver = e_.free.front();
    const Words what = solved.change_points.size() == 1 ? Words(lang::equations::a_change_point)
                                                        : Words(lang::equations::change_points);
    const bool turns_fully = pen_.letter(driver).is_angle && solved.dead_points->empty();
    const Words so = !turns_fully   ? Words(lang::equations::the_driven_body_goes_on_beyond)
                     : is_only_loop ? Words(lang::equations::the_driven_body_passes_and_makes)
                                    : Words(lang::equations::the_driven_body_passes);
    return {lang::equations::det_j_0, pen_.spoken(driver), list_of(solved.change_points, driver), what, so};
}

std::string DeadPointText::list_of(const std::vector<double>& values, LetterIndex of) const {
    std::string text;
    for (const double each : values)
        text += (text.empty() ? "" : pen_.in({lang::notation::semicolon})) + pen_.amount_of(of, each, 0);
    return text;
}

}  // namespace kinegraph::render::closure
