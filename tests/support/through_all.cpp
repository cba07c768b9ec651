#include "tests/support/through_all.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "constructions/positions/conditions.hpp"
#include "constructions/solving/solve.hpp"
#include "constructions/verdicts/verdicts.hpp"
#include "engine/mechanism/variation.hpp"
#include "engine/results/results.hpp"
#include "render/backends/backends.hpp"
#include "render/sheet/sheet.hpp"
#include "render/sheet/sheet_limits.hpp"
#include "render/text/words.hpp"

namespace kinegraph::tests {
namespace {

using namespace render;

void expect(bool holds, const char* what) {
    if (!holds) throw std::runtime_error(what);
}
void expect_finite(std::initializer_list<double> numbers) {
    for (const double number : numbers) expect(std::isfinite(number), "a mark stands nowhere");
}
void expect_finite(Spot spot) { expect_finite({spot.x, spot.y}); }

struct IsFinite {
    void operator()(const MoveTo& move) const { expect_finite(move.to); }
    void operator()(const LineTo& line) const { expect_finite(line.to); }
    void operator()(const CurveTo& curve) const {
        for (const Spot spot : {curve.control_1, curve.control_2, curve.to}) expect_finite(spot);
    }
    void operator()(const ArcTo& arc) const {
        expect_finite({arc.centre.x, arc.centre.y, arc.radius, arc.from, arc.to});
    }
    void operator()(const Close&) const {}
    void operator()(const Path& path) const {
        for (const render::Segment& segment : path.segments) std::visit(*this, segment);
        expect_finite({path.pen.width});
    }
    void operator()(const Axis& axis) const {
        expect_finite(axis.tail);
        expect_finite(axis.tip);
    }
    void operator()(const TextMark& text) const {
        expect_finite({text.angle, text.pivot.x, text.pivot.y});
        for (const Glyph& glyph : text.glyphs) expect_finite({glyph.origin.x, glyph.origin.y, glyph.size});
    }
    void operator()(const GroupBegin&) const {}
    void operator()(const GroupEnd&) const {}
};

void expect_said(const Words& message) {
    for (const Language language : languages)
        expect(!message.in(language).empty(), "a fault has words in every language");
}

/// Each result that an exercise asks for or requires is found, or reported as missing.
void through_exercise(const Solution& solution) {
    if (!solution.mechanism.exercise) return;
    const Exercise& exercise = *solution.mechanism.exercise;
    if (const auto size = Lattice::size(exercise.vary)) Lattice::at(exercise.vary, *size - 1);
    const auto results = results_for(exercise, solution);
    const auto expect_words = [](const Errors& errors) {
        for (const Error& error : errors) expect_said(error.message);
    };
    if (const auto asked = asked_of_results(solution, results); !asked) expect_words(asked.error());
    for (const Condition& each : exercise.require) {
        if (each.holds || each.kind == Condition::Kind::crank_turns_fully ||
            each.kind == Condition::Kind::polygon_readable)
            continue;
        if (const auto fits = holds(each, solution, results); !fits) expect_words(fits.error());
    }
}

}  // namespace

HowFar through_all(std::string_view text, const Fonts& fonts) {
    HowFar far;
    auto mechanism = read_mechanism(text, "fuzz.json");
    if (!mechanism) {
        for (const Error& error : mechanism.error()) expect_said(error.message);
        return far;
    }
    far.read = true;
    const auto solution = solve(*std::move(mechanism));
    if (!solution) return far;
    far.solved = true;
    through_exercise(*solution);
    likely_mistakes(solution->mechanism, solution->pose, solution->mobility);
    // JSON has no NaN and no infinity.
    const std::string results =
        results_json(*solution, false, [](const Message& said) { return tell(said, Language::en); });
    expect(nlohmann::json::accept(results), "the results are no JSON");
    results_table(*solution, Language::it);
    for (const auto& refused : {beyond_doubles(*solution), beyond_sheet(*solution)})
        if (refused) return expect_said(*refused), far;
    const std::vector<Page> pages = lay_out(*solution, {}, fonts);
    for (const Page& page : pages) {
        for (const Mark& mark : page.marks) std::visit(IsFinite(), mark);
        if (const auto refused = beyond_paper(page)) return expect_said(*refused), far;
    }
    to_svg(pages, fonts);
    to_live_svg(pages, fonts);
    to_tex(pages, fonts);
    far.drawn = true;
    return far;
}

}  // namespace kinegraph::tests
