#include "constructions/statics/forces/magnitudes.hpp"

#include <string>

#include "engine/number/assert.hpp"
#include "lang/keys/sentences.hpp"

namespace kinegraph::statics {

bool Magnitudes::magnitudes(const Group& group, const std::vector<Load>& loads, Run& run) {
    const std::vector<int> unknown = known_.unknown_of(group, run);
    if (unknown.empty()) return false;
    const auto [pins, guides, fixed, couples, clamps] = known_.sorted(unknown, run);
    const std::size_t count = 2 * (pins.size() + guides.size()) + fixed.size() + couples.size() + 3 * clamps.size();
    if (count > 3 || couples.size() > 1) return false;
    const Wrench known = model_.known_on(group, loads, run);
    bool done = false;
    if (unknown.size() == 1) {
        done = single(group, unknown[0], known, loads, run);
    } else if (pins.size() == 1 && couples.size() == 1) {
        done = force_and_couple(group, pins[0], couples[0], known, loads, run);
    } else if (pins.size() == 1 && fixed.size() == 1) {
        done = line_and_pin(group, fixed[0], pins[0], known, loads, run);
    } else if (guides.size() == 1 && fixed.size() == 1) {
        done = line_and_guide(group, fixed[0], guides[0], known, loads, run);
    } else if (fixed.size() == 2) {
        done = two_lines(group, fixed[0], fixed[1], couples.empty() ? -1 : couples[0], known, loads, run);
    } else if (fixed.size() == 1 && couples.size() == 1) {
        done = force_and_couple(group, fixed[0], couples[0], known, loads, run);
    } else if (fixed.size() == 3) {
        done = three_lines(group, fixed, known, loads, run);
    }
    if (done) known_.note(group, run);
    if (done && group.size() > 1) run.taken_together.push_back({group, unknown, said_.last()});
    return done;
}

bool Magnitudes::single(const Group& group, int b, const Wrench& known, const std::vector<Load>& loads, Run& run) {
    const Bond::Kind of = known_.shape(b, run);
    const Symbol symbol = of == Bond::Kind::couple ? said_.couple_on(b, group) : said_.symbol_on(b, group);
    said_.say_of(group, known.vanishes() ? lang::sentences::no_force : lang::sentences::single_reaction, {symbol});
    if (of == Bond::Kind::couple) {
        resultants_.note_couple_of_two(group, known, loads, run);
        settled_.settle_couple(b, board_.opposite(model_.moment(known, model_.bonds()[at(b)].place)), group, run);
        return true;
    }
    const bool takes_couple =
        model_.bonds()[at(b)].kind == Bond::Kind::guide || model_.bonds()[at(b)].kind == Bond::Kind::clamp;
    if (of == Bond::Kind::line) {
        const Action line = *run.reactions[at(b)].action;
        if (known.force) {
            settled_.settle(b, balance_.opposite_along(known, line.direction), line.place, group, run);
        } else {
            settled_.found(b, group, run);
        }
    } else if (takes_couple) {
        const ScalarHandle couple = board_.opposite(model_.moment(known, model_.bonds()[at(b)].place));
        if (known.force) {
            say_moment(couple, b, b, group);
            const Force force = of == Bond::Kind::guide
                                    ? balance_.opposite_along(known, model_.bonds()[at(b)].direction)
                                    : balance_.opposite(known);
            settled_.settle_with_couple(b, force, couple, group, run);
        } else {
            settled_.settle_couple(b, couple, group, run);
        }
    } else if (known.force) {
        settled_.settle(b, balance_.opposite(known), model_.bonds()[at(b)].place, group, run);
    } else {
        settled_.found(b, group, run);
    }
    return true;
}

bool Magnitudes::force_and_couple(const Group& group, int force, int couple, const Wrench& known,
                                  const std::vector<Load>& loads, Run& run) {
    const PlaceOnDrawing place = known_.place_of(force, run);
    resultants_.say_resultant(group, known, loads, run);
    said_.say_of(group, known.force ? lang::sentences::force_and_couple : lang::sentences::couple_alone,
                 {said_.symbol_on(force, group), said_.couple_on(couple, group)});
    const ScalarHandle balancing = board_.opposite(model_.moment(known, place));
    if (known.force && !board_.is_zero(balancing)) resultants_.note_lever(group, place, *known.force, known.place, run);
    if (known.force) {
        const auto& line = run.reactions[at(force)].action;
        settled_.settle(force, line ? balance_.opposite_along(known, line->direction) : balance_.opposite(known), place,
                        group, run);
    } else {
        settled_.found(force, group, run);
    }
    settled_.settle_couple(couple, balancing, group, run);
    return true;
}

bool Magnitudes::line_and_pin(const Group& group, int line, int pin, const Wrench& known,
                              const std::vector<Load>& loads, Run& run) {
    const Action given = *run.reactions[at(line)].action;
    const PlaceOnDrawing place = model_.bonds()[at(pin)].place;
    if (board_.on_line(place, given.line)) return false;  // then the moment about the pin does not determine it
    if (known.vanishes()) {
        said_.say_of(group, lang::sentences::zero_forces, {});
        settled_.found(line, group, run);
        settled_.found(pin, group, run);
        return true;
    }
    if (known.force && !board_.parallel(board_.direction(*known.force), given.direction)) {
        const auto met = board_.meet(model_.line_of(known), given.line);
        if (board_.coincide(*met, place)) return false;
        const bool far = funicular_.is_far(group, *met, place, known.place, given.place);
        if (several_by_funicular(group, line, pin, known, far, loads, run)) return true;
        resultants_.say_resultant(group, known, loads, run);
        if (far)
            if (auto found = funicular_.drawn(
                    group, {{resultants_.symbol_of_known(group, loads, run), known.force, known.place, -1}},
                    *known.force, given, place)) {
                said_.say_of(group, lang::sentences::funicular_far,
                             {said_.symbol_on(line, group), said_.symbol_on(pin, group)}, "Culmann");
                const auto [along, at_pin] =
                    funicular_.by_funicular(*std::move(found), line, pin, *known.force, group, run);
                settled_.settle(line, along, given.place, group, run);
                settled_.settle(pin, at_pin, place, group, run);
                return true;
            }
        const std::string letter = said_.meet_name(group, *met);
        said_.say_of(group, lang::sentences::triangle_at,
                     {PointName{letter}, said_.symbol_on(line, group), said_.symbol_on(pin, group)}, "Culmann");
        const DirectionHandle through_meet = board_.direction(board_.vector(place, *met));
        const auto [along, at_pin] = balance_.triangle(known, given.direction, through_meet);
        settled_.settle_line(pin, model_.action(place, through_meet), run);
        settled_.settle(line, along, given.place, group, run);
        settled_.settle(pin, at_pin, place, group, run);
        return true;
    }
    if (known.force)
        if (auto found =
                funicular_.drawn(group, resultants_.actors_on(group, loads, run), *known.force, given, place)) {
            say_funicular(group, lang::sentences::funicular_parallel,
                          {said_.symbol_on(line, group), said_.symbol_on(pin, group)}, *found);
            const auto [first, second] =
                funicular_.by_funicular(*std::move(found), line, pin, *known.force, group, run);
            settled_.settle(line, first, given.place, group, run);
            settled_.settle(pin, second, place, group, run);
            return true;
        }
    const auto along = balance_.by_moments(given, place, known);
    if (!along) return false;
    said_.say_of(group, lang::sentences::parallel_forces, {said_.symbol_on(line, group), said_.symbol_on(pin, group)},
                 "Ritter");
    settled_.settle(line, *along, given.place, group, run);
    settled_.settle(pin, board_.negate(known.force ? board_.add(*known.force, *along) : *along), place, group, run);
    return true;
}

bool Magnitudes::several_by_funicular(const Group& group, int line, int pin, const Wrench& known, bool far,
                                      const std::vector<Load>& loads, Run& run) {
    if (!known_.is_whole(group)) return false;
    const std::vector<Actor> actors = resultants_.actors_on(group, loads, run);
    if (actors.size() < (far ? 2U : 3U)) return false;
    const Action given = *run.reactions[at(line)].action;
    const PlaceOnDrawing place = model_.bonds()[at(pin)].place;
    auto found = funicular_.drawn(group, actors, *known.force, given, place);
    if (!found) return false;
    say_funicular(group, lang::sentences::funicular_several,
                  {said_.symbol_on(line, group), said_.symbol_on(pin, group), found->known}, *found);
    const auto [along, at_pin] = funicular_.by_funicular(*std::move(found), line, pin, *known.force, group, run);
    settled_.settle(line, along, given.place, group, run);
    settled_.settle(pin, at_pin, place, group, run);
    return true;
}

/// The resultant passes through the intersection of the outer strings, which gets a name. One force is no resultant.
void Magnitudes::say_funicular(const Group& group, Key sentence, std::vector<Argument> arguments,
                               const Funicular& found) {
    if (sentence == lang::sentences::funicular_parallel && found.known.size() == 1) {
        sentence = lang::sentences::funicular_parallel_one;
        arguments.emplace_back(found.known.front());
    } else if (found.resultant)
        arguments.emplace_back(PointName{said_.meet_name(group, *found.resultant)});
    said_.say_of(group, sentence, std::move(arguments), "Culmann");
}

void Magnitudes::say_no_force_along(const Group& group, int nothing, int all, bool couple_too) {
    std::vector<Argument> arguments{said_.symbol_on(nothing, group), said_.symbol_on(all, group)};
    if (couple_too) arguments.emplace_back(said_.couple_on(nothing, group));
    said_.say_of(group, lang::sentences::no_force_along, std::move(arguments));
}

bool Magnitudes::line_and_guide(const Group& group, int line, int guide, const Wrench& known,
                                const std::vector<Load>& loads, Run& run) {
    const Action given = *run.reactions[at(line)].action;
    const DirectionHandle normal = model_.bonds()[at(guide)].direction;
    if (board_.parallel(given.direction, normal)) return false;
    bool by_moments = false;
    if (balance_.is_along(known, given)) {
        say_no_force_along(group, guide, line, board_.is_zero(model_.moment(known, given.place)));
    } else if (const auto met = resultants_.meet_of_resultant(group, given, known, loads, run)) {
        const std::string letter = said_.meet_name(group, *met);
        said_.say_of(group, lang::sentences::triangle_at,
                     {PointName{letter}, said_.symbol_on(line, group), said_.symbol_on(guide, group)});
    } else {
        by_moments = true;
        said_.say_of(group, lang::sentences::triangle, {said_.symbol_on(line, group), said_.symbol_on(guide, group)});
    }
    const auto [along, across] = balance_.triangle(known, given.direction, normal);
    settled_.settle(line, along, given.place, group, run);
    Wrench rest = known;
    if (run.reactions[at(line)].force) rest = model_.sum(known, balance_.wrench_at(along, given.place));
    const ScalarHandle couple = board_.opposite(model_.moment(rest, model_.bonds()[at(guide)].place));
    if (by_moments) say_moment(couple, guide, guide, group);
    settled_.settle_with_couple(guide, across, couple, group, run);
    return true;
}

void Magnitudes::say_moment(ScalarHandle couple, int of, int about, const Group& group) {
    if (board_.is_zero(couple)) return;
    said_.add({said_.couple_on(of, group), said_.place_name(about)});
}

bool Magnitudes::two_lines(const Group& group, int one, int two, int couple, const Wrench& known,
                           const std::vector<Load>& loads, Run& run) {
    const Action first = *run.reactions[at(one)].action, second = *run.reactions[at(two)].action;
    if (!board_.parallel(first.direction, second.direction)) {
        const bool by_triangle = !balance_.is_along(known, first) && !balance_.is_along(known, second);
        if (balance_.is_along(known, first))
            say_no_force_along(group, two, one, false);
        else if (balance_.is_along(known, second))
            say_no_force_along(group, one, two, false);
        else
            said_.say_of(group, lang::sentences::triangle, {said_.symbol_on(one, group), said_.symbol_on(two, group)});
        const auto [x, y] = balance_.triangle(known, first.direction, second.direction);
        settled_.settle(one, x, first.place, group, run);
        settled_.settle(two, y, second.place, group, run);
        if (couple >= 0) {
            Wrench rest =
                model_.sum(model_.sum(known, balance_.nonzero(x, first.place)), balance_.nonzero(y, second.place));
            const ScalarHandle balancing = board_.opposite(model_.moment(rest, first.place));
            if (by_triangle) say_moment(balancing, couple, one, group);
            settled_.settle_couple(couple, balancing, group, run);
        }
        return true;
    }
    if (couple >= 0) return false;
    if (balance_.is_along(known, first) && !board_.on_line(second.place, first.line))
        if (auto found =
                funicular_.drawn(group, resultants_.actors_on(group, loads, run), *known.force, first, second.place)) {
            say_funicular(group, lang::sentences::funicular_parallel,
                          {said_.symbol_on(one, group), said_.symbol_on(two, group)}, *found);
            const auto [x, y] = funicular_.by_funicular(*std::move(found), one, two, *known.force, group, run);
            settled_.settle(one, x, first.place, group, run);
            settled_.settle(two, y, second.place, group, run);
            return true;
        }
    const auto x = balance_.by_moments(first, second.place, known);
    if (!x) return false;
    said_.say_of(group, lang::sentences::parallel_forces, {said_.symbol_on(one, group), said_.symbol_on(two, group)},
                 "Ritter");
    settled_.settle(one, *x, first.place, group, run);
    Wrench rest;
    rest.force = known.force ? board_.add(*known.force, *x) : *x;
    settled_.settle(two, balance_.opposite_along(rest, second.direction), second.place, group, run);
    return true;
}

bool Magnitudes::three_lines(const Group& group, const std::vector<int>& fixed, const Wrench& known,
                             const std::vector<Load>& loads, Run& run) {
    for (std::size_t i = 0; i < 3; ++i) {
        const int one = fixed[i], two = fixed[(i + 1) % 3], three = fixed[(i + 2) % 3];
        const Action a = *run.reactions[at(one)].action, b = *run.reactions[at(two)].action,
                     c = *run.reactions[at(three)].action;
        if (board_.parallel(b.direction, c.direction)) continue;
        const PlaceOnDrawing pivot = *board_.meet(b.line, c.line);
        if (board_.on_line(pivot, a.line)) return false;  // concurrent lines balance only a force through that point
        const auto [first, rest] = known_and_one(group, known, one, two, three, pivot, loads, run);
        settled_.settle(one, first, a.place, group, run);
        const auto [x, y] = balance_.triangle(rest, b.direction, c.direction);
        settled_.settle(two, x, b.place, group, run);
        settled_.settle(three, y, c.place, group, run);
        return true;
    }
    return false;
}

std::pair<Force, Wrench> Magnitudes::known_and_one(const Group& group, const Wrench& known, int one, int two, int three,
                                                   PlaceOnDrawing pivot, const std::vector<Load>& loads, Run& run) {
    const Action a = *run.reactions[at(one)].action;
    Wrench rest;
    rest.place = pivot;
    if (known.force && !board_.parallel(board_.direction(*known.force), a.direction)) {
        const PlaceOnDrawing met = *board_.meet(model_.line_of(known), a.line);
        if (!board_.coincide(met, pivot)) {
            resultants_.say_resultant(group, known, loads, run);
            const std::string one_meet = said_.meet_name(group, met), other_meet = said_.meet_name(group, pivot);
            said_.say_of(group, lang::sentences::culmann_line,
                         {PointName{one_meet}, PointName{other_meet}, said_.symbol_on(one, group),
                          said_.symbol_on(two, group), said_.symbol_on(three, group)},
                         "Culmann");
            const auto [first, pair] =
                balance_.triangle(known, a.direction, board_.direction(board_.vector(met, pivot)));
            if (!board_.is_zero(pair)) rest.force = board_.negate(pair);
            if (rest.force) resultants_.note_culmann(group, one, one_meet + other_meet, *rest.force, met, loads, run);
            return {first, rest};
        }
    }
    const auto first = balance_.by_moments(a, pivot, known);
    KG_ASSERT(first, "a line that does not pass the pivot has a lever about it");
    said_.say_of(group, lang::sentences::culmann,
                 {PointName{said_.meet_name(group, pivot)}, said_.symbol_on(one, group), said_.symbol_on(two, group),
                  said_.symbol_on(three, group)},
                 "Ritter");
    rest.force = known.force ? board_.add(*known.force, *first) : *first;
    if (board_.is_zero(*rest.force)) rest.force.reset();
    return {*first, rest};
}

}  // namespace kinegraph::statics
