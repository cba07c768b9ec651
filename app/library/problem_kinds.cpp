// The kinds of problems that a file may state in place of joints, one row for each. Their order is that of messages.
#include "app/library/problem_kinds.hpp"

#include <algorithm>
#include <array>

#include "engine/number/assert.hpp"
#include "problems/hertz/hertz.hpp"
#include "problems/impact/impact.hpp"
#include "problems/point/point.hpp"
#include "problems/positions/positions.hpp"
#include "problems/reye/reye.hpp"
#include "problems/rotor/rotor.hpp"
#include "render/problems/problem_sections.hpp"
#include "render/scene/drawing_context.hpp"

namespace kinegraph {
namespace {

struct ProblemRow {
    const ProblemKind* kind;
    std::vector<render::ProblemSection> (*sections)(const render::DrawingContext& context);
    app::EquationsOfProblem equations = nullptr;
};
constexpr std::array problem_rows{
    ProblemRow{&hertz_problem, render::hertz_sections},
    ProblemRow{&reye_problem, render::reye_sections},
    ProblemRow{&impact_problem, render::impact_sections},
    ProblemRow{&rotor_problem, render::rotor_sections},
    ProblemRow{&positions_problem, render::positions_sections},
    ProblemRow{&point_problem, render::point_sections, render::point_items},
};

const ProblemRow& row_of(const Mechanism& mechanism) {
    const auto* row = std::find_if(problem_rows.begin(), problem_rows.end(),
                                   [&](const ProblemRow& each) { return each.kind == mechanism.problem->kind; });
    KG_ASSERT(row != problem_rows.end(), "a problem is of a kind in this table");
    return *row;
}

}  // namespace

std::span<const ProblemKind* const> problem_kinds() {
    static constexpr auto kinds = [] {
        std::array<const ProblemKind*, problem_rows.size()> all{};
        std::transform(problem_rows.begin(), problem_rows.end(), all.begin(),
                       [](const ProblemRow& each) { return each.kind; });
        return all;
    }();
    return kinds;
}

std::vector<render::ProblemSection> render::sections_of_problem(const DrawingContext& context) {
    return row_of(context.solution.mechanism).sections(context);
}

app::EquationsOfProblem app::equations_of_problem(const Mechanism& mechanism) {
    return mechanism.problem ? row_of(mechanism).equations : nullptr;
}

}  // namespace kinegraph
