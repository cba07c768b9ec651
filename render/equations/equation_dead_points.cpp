#include "render/equations/equation_chapters.hpp"

#include <utility>

namespace kinegraph::render::closure {

void DeadPointText::write_dead_points() {
    auto title = [&, told = false]() mutable {
        if (!std::exchange(told, true)) list_.heading({"Dead points", "Punti morti"});
    };
    if (!e_.is_regular() && !e_.free.empty()) {
        for (const LetterIndex each : e_.cannot_be_driven) {
            title();
            list_.say(Words(
                "In the drawn position det {J} = 0: {0} cannot be driven ({1}, {2}); it rests in every motion.",
                "Nella posizione disegnata det {J} = 0: {0} non può essere movente ({1}, {2}); è fermo in ogni moto.",
                pen_.spoken(each), pen_.described(each), pen_.amount_of(each, pen_.letter(each).value, 0)));
        }
        if (e_.cannot_be_driven.empty()) {
            title();
            list_.say({"The equations leave unknowns open here: their rank is less than their number.",
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

void DeadPointText::write_dead_points_of(const Equations::Loop& loop, std::size_t index) {
    const LetterIndex driver = e_.free.front();
    const std::string of = pen_.numbered(index);
    const auto told = [&](const Words& words) {
        const std::string loop_named = of.empty() ? std::string() : pen_.in(Words("Loop {0}: ", "Maglia {0}: ", of));
        list_.say_text(loop_named + pen_.in(words));
    };
    const Solved& solved = loop.solved;
    if (!solved.dead_points->empty())
        told(pen_.letter(driver).is_angle
                 ? Words("det {J} = 0 at {0} = {1}: there {0} cannot be driven, and its body makes no full turn.",
                         "det {J} = 0 per {0} = {1}: lì {0} non può essere movente, e il suo membro non compie giri "
                         "completi.",
                         pen_.spoken(driver), list_of(*solved.dead_points, driver))
                 : Words("det {J} = 0 at {0} = {1}: there {0} cannot be driven.",
                         "det {J} = 0 per {0} = {1}: lì {0} non può essere movente.", pen_.spoken(driver),
                         list_of(*solved.dead_points, driver)));
    if (!solved.change_points.empty()) told(change_points_of(solved, of.empty()));
    if (solved.dead_points->empty() && solved.change_points.empty()) told(no_dead_point(of.empty()));
    for (const auto& [at, slide] : solved.standstills)
        told(Words("Crank and rod lie in one line at {0} = {1}, {2} = {3}: there {Λ} = 0, and {2} could not drive.",
                   "Manovella e biella sono allineate per {0} = {1}, {2} = {3}: lì {Λ} = 0, e {2} non potrebbe essere "
                   "movente.",
                   pen_.spoken(driver), pen_.amount_of(driver, at, 0),
                   pen_.spoken(loop.sides[at_index(solved.second)].length),
                   pen_.amount_of(loop.sides[at_index(solved.second)].length, slide, 0)));
}

Words DeadPointText::no_dead_point(bool is_only_loop) const {
    const LetterIndex driver = e_.free.front();
    if (!pen_.letter(driver).is_angle)
        return {"det {J} vanishes for no {0}.", "det {J} non si annulla per alcun {0}.", pen_.spoken(driver)};
    if (is_only_loop)
        return {"det {J} vanishes for no {0}: the driven body makes full turns.",
                "det {J} non si annulla per alcun {0}: il membro movente compie giri completi.", pen_.spoken(driver)};
    return {"det {J} vanishes for no {0}; as for this loop, the driven body may make full turns.",
            "det {J} non si annulla per alcun {0}; per questa maglia il membro movente può compiere giri completi.",
            pen_.spoken(driver)};
}

Words DeadPointText::change_points_of(const Equations::Solved& solved, bool is_only_loop) const {
    const LetterIndex driver = e_.free.front();
    const Words what = solved.change_points.size() == 1 ? Words("a change point", "un punto di biforcazione")
                                                        : Words("change points", "punti di biforcazione");
    const bool turns_fully = pen_.letter(driver).is_angle && solved.dead_points->empty();
    const Words so =
        !turns_fully ? Words("the driven body goes on beyond", "il membro movente prosegue oltre")
        : is_only_loop
            ? Words("the driven body passes and makes full turns", "il membro movente vi passa e compie giri completi")
            : Words("the driven body passes and, as for this loop, may make full turns",
                    "il membro movente vi passa e, per questa maglia, può compiere giri completi");
    return {"det {J} = 0 at {0} = {1}: {2}, where the branch is a choice; {3}.",
            "det {J} = 0 per {0} = {1}: {2}, dove il ramo è una scelta; {3}.",
            pen_.spoken(driver),
            list_of(solved.change_points, driver),
            what,
            so};
}

std::string DeadPointText::list_of(const std::vector<double>& values, LetterIndex of) const {
    std::string text;
    for (const double each : values) text += (text.empty() ? "" : "; ") + pen_.amount_of(of, each, 0);
    return text;
}

}  // namespace kinegraph::render::closure
