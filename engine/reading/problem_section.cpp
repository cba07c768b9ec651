#include "engine/reading/problem_section.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "engine/solution/problem_kind.hpp"

namespace kinegraph {
namespace {

bool states(const ProblemKind& kind, JsonValue section) {
    return kind.is_stated_by == nullptr ? bool(section) : kind.is_stated_by(section);
}
/// A member of the file states a problem, or belongs to mechanisms.
bool states_a_problem(JsonValue member) {
    const auto kinds = problem_kinds();
    return std::any_of(kinds.begin(), kinds.end(),
                       [&](const ProblemKind* each) { return each->key == member.key() && states(*each, member); });
}

}  // namespace

bool ProblemSection::is_in(const Members& file) {
    const auto kinds = problem_kinds();
    return std::any_of(kinds.begin(), kinds.end(), [&](const ProblemKind* each) {
        return each->is_stated_by == nullptr ? file.has_or_misspells(each->key) : each->is_stated_by(file[each->key]);
    });
}

std::shared_ptr<const Problem> ProblemSection::read(const Members& file) {
    JsonValue section;
    const ProblemKind* kind = nullptr;
    for (const ProblemKind* each : problem_kinds()) {
        if (!states(*each, file[each->key])) continue;
        if (section) {
            file_.not_together(file[each->key], section.key());
        } else {
            section = file[each->key];
            kind = each;
        }
    }
    if (!section) return nullptr;
    for (const std::string_view key :
         {"joints", "drivers", "motion", "masses", "gravity", "inertia forces", "loads", "effort", "find", "scales"})
        if (file[key] && !states_a_problem(file[key])) file_.not_together(file[key], section.key());
    std::any of = kind->read(file_, mechanism_, section);
    if (!of.has_value()) return nullptr;
    return std::make_shared<const Problem>(Problem{kind, std::move(of)});
}

}  // namespace kinegraph
