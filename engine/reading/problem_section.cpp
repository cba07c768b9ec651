#include "engine/reading/problem_sections.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/problems.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace kinegraph {
namespace {

/// `motion` is one where it is a point's.
constexpr std::array<std::string_view, 5> keys{"hertz", "reye", "impact", "positions", "motion"};

}  // namespace

bool ProblemSection::is_in(const Members& file) {
    return std::any_of(keys.begin(), keys.end(), [&](std::string_view key) {
        return key == "motion" ? PointMotionSection::is_stated_by(file[key]) : file.has_or_misspells(key);
    });
}

std::shared_ptr<const Problem> ProblemSection::read(const Members& file) {
    JsonValue section;
    for (const std::string_view key : keys) {
        if (!file[key] || (key == "motion" && !PointMotionSection::is_stated_by(file[key]))) continue;
        if (section)
            file_.not_together(file[key], section.key());
        else
            section = file[key];
    }
    if (!section) return nullptr;
    for (const std::string_view key :
         {"joints", "drivers", "motion", "masses", "gravity", "inertia forces", "loads", "effort", "find", "scales"}) {
        if (file[key] && !(key == "motion" && PointMotionSection::is_stated_by(file[key])))
            file_.not_together(file[key], section.key());
    }
    if (section.key() == "positions") {
        if (!file_.expect(section, Kind::array, {lang::problems::an_array_of_positions})) return nullptr;
    } else if (!file_.expect(section, Kind::object, {lang::common::an_object})) {
        return nullptr;
    }
    const auto shared = [](auto problem) -> std::shared_ptr<const Problem> {
        if (!problem) return nullptr;
        return std::make_shared<const Problem>(Problem{*std::move(problem)});
    };
    if (section.key() == "hertz") return shared(HertzSection(file_, mechanism_).read(section));
    if (section.key() == "reye") return shared(ReyeSection(file_).read(section));
    if (section.key() == "impact") return shared(ImpactSection(file_, mechanism_).read(section));
    if (section.key() == "positions") return shared(PositionsSection(file_).read(section));
    return shared(PointMotionSection(file_).read(section));
}

}  // namespace kinegraph
