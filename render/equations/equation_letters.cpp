#include "lang/keys/common.hpp"
#include "lang/keys/equations.hpp"
#include "render/equations/equation_chapters.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace kinegraph::render::closure {

void LettersTable::write_letters() {
    list_.heading({lang::equations::closure_equations});
    std::vector<std::vector<Formula>> rows{
        {Formula::upright(pen_.in({lang::common::quantity})), Formula::upright(pen_.in({lang::equations::what})),
         Formula::upright(pen_.in({lang::common::value})), Formula::upright(pen_.in({lang::equations::kind}))}};
    const std::array<Words, 3> kinds{Words(lang::common::given), Words(lang::equations::free_driven),
                                     Words(lang::equations::dependent)};
    for (const auto role : {Letter::Role::given, Letter::Role::free, Letter::Role::dependent})
        for (std::size_t i = 0; i < e_.letters.size(); ++i) {
            const auto index = static_cast<LetterIndex>(i);
            const Letter& own = e_.letters[i];
            if (own.role != role || (role == Letter::Role::given && !is_written(index))) continue;
            rows.push_back({pen_.name(index), what_is(index), pen_.amount_formula(index, own.value, 0),
                            Formula::upright(pen_.in(kinds.at(static_cast<std::size_t>(role))))});
        }
    list_.table(std::move(rows));
}

Formula LettersTable::what_is(LetterIndex index) const {
    const Letter& own = pen_.letter(index);
    if (own.role != Letter::Role::given) return Formula::upright(pen_.described(index));
    if (own.is_radius)
        return Formula::upright(pen_.in(Words(lang::equations::radius_on_body, mechanism_.body(own.body).name)));
    if (own.is_angle) return Formula::upright(pen_.in({lang::equations::fixed_angle}));
    Formula ends = ends_of(index);
    return ends.empty() ? Formula::upright(pen_.in({lang::equations::constant_distance})) : ends;
}

bool LettersTable::is_written(LetterIndex index) const {
    const auto has = [&](const std::vector<Side>& sides) {
        return std::any_of(sides.begin(), sides.end(), [&](const Side& each) {
            const auto& own = each.angle.letters;
            return each.length == index || std::find(own.begin(), own.end(), index) != own.end();
        });
    };
    const auto in_law = [&](const Equations::Law& law) {
        return std::any_of(law.parts.begin(), law.parts.end(), [&](const Equations::Law::Part& part) {
            return part.radius == index || std::any_of(part.sum.begin(), part.sum.end(),
                                                       [&](const auto& each) { return each.second == index; });
        });
    };
    return std::any_of(e_.loops.begin(), e_.loops.end(), [&](const auto& loop) { return has(loop.sides); }) ||
           std::any_of(e_.reaches.begin(), e_.reaches.end(), [&](const auto& reach) { return has(reach.sides); }) ||
           std::any_of(e_.laws.begin(), e_.laws.end(), in_law);
}

Formula LettersTable::ends_of(LetterIndex length) const {
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

Formula LettersTable::point_name(const std::string& name) {
    std::size_t stem = name.size();
    while (stem > 1 && name[stem - 1] >= '0' && name[stem - 1] <= '9') --stem;
    return Formula::letter(name.substr(0, stem), name.substr(stem));
}

std::string LettersTable::point_at(const Vector& place) const {
    for (const PointIndex point : indices_of(mechanism_.points))
        if (solution_.pose.at(point) == place) return mechanism_.point(point).name;
    return {};
}

}  // namespace kinegraph::render::closure
