#include "render/equations/equation_chapters.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/equations/equations_values.hpp"
#include "engine/number/functions.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/equations.hpp"

namespace kinegraph::render::closure {

void DrawnRates::write_values() {
    std::vector<std::vector<Formula>> rows{{Formula::upright(pen_.in({lang::common::quantity})),
                                            Formula::upright(pen_.in({lang::equations::equations})),
                                            Formula::upright(pen_.in({lang::equations::polygon}))}};
    for (const int dots : {1, 2})
        for (const LetterIndex index : e_.unknowns) {
            const Letter& own = pen_.letter(index);
            const auto& written = dots == 1 ? own.rate : own.acceleration;
            const Drawn beside = drawn(index);
            const auto& polygon = dots == 1 ? beside.rate : beside.acceleration;
            if (!written && !polygon) continue;
            rows.push_back({pen_.name(index, dots),
                            written ? pen_.amount_formula(index, *written, dots) : Formula::upright("–"),
                            polygon ? pen_.amount_formula(index, *polygon, dots) : Formula::upright("–")});
        }
    if (rows.size() < 2) return;
    list_.heading({lang::equations::values});
    list_.table(std::move(rows));
}

DrawnRates::Drawn DrawnRates::drawn(LetterIndex index) const {
    const Letter& own = pen_.letter(index);
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
        return v.x.to_double() * nearest::cos(*direction) + v.y.to_double() * nearest::sin(*direction);
    };
    if (sliding->velocity) found.rate = along(*sliding->velocity);
    if (sliding->acceleration) found.acceleration = along(*sliding->acceleration);
    return found;
}

std::optional<double> DrawnRates::direction_of_slide(LetterIndex index) const {
    for (const Equations::Loop& loop : e_.loops)
        for (const Side& each : loop.sides)
            if (each.length == index) return value_of(e_, each.angle);
    for (const Equations::Reach& reach : e_.reaches)
        for (const Side& each : reach.sides)
            if (each.length == index) return value_of(e_, each.angle);
    return std::nullopt;
}

}  // namespace kinegraph::render::closure
