// Whether vectors to be found are long enough to be read.
#include "render/sheet/sheet.hpp"

#include <algorithm>

#include "render/layout/drawn_sheet.hpp"
#include "render/tables/answers.hpp"

namespace kinegraph::render {
namespace {

bool belongs(Topic section, Condition::Polygon polygon) {
    switch (polygon) {
        case Condition::Polygon::velocity: return section == Topic::velocity;
        case Condition::Polygon::acceleration: return section == Topic::acceleration;
        case Condition::Polygon::force: return section == Topic::forces;
    }
    return false;
}

}  // namespace

bool is_readable(const Solution& solution, Condition::Polygon polygon, const SheetOptions& options,
                 const Fonts& fonts) {
    const DrawnSheet drawn = draw_solution(solution, options, fonts);
    const DrawingContext context{solution, options.theme, fonts, options.language, options.dimensions};
    const std::vector<Answer> answers = answers_of(context, drawn.figures, false);
    return std::all_of(answers.begin(), answers.end(), [&](const Answer& each) {
        // A zero vector has neither direction nor length.
        const auto letter = each.symbol.letter;
        const bool turns =
            letter == Symbol::Letter::omega || letter == Symbol::Letter::alpha || letter == Symbol::Letter::M;
        const bool is_vector = !turns && (each.direction || each.value == 0);
        if (!is_vector || !belongs(each.section, polygon)) return true;
        return each.tolerance && reading_by_hand * each.value / *each.tolerance >= readable_length;
    });
}

}  // namespace kinegraph::render
