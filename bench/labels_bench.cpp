// The time to place labels: each figure of the richest example once, and a drawing with far more names than space.
#include <benchmark/benchmark.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "constructions/solving/solve.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "render/figures/figure.hpp"

namespace {

using namespace kinegraph::render;

const Fonts& fonts() {
    static const Fonts opened = std::move(*Fonts::open());
    return opened;
}

kinegraph::Solution solved(const char* name) {
    std::ifstream file(std::string(KINEGRAPH_EXAMPLES_DIR) + "/" + name);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    auto mechanism = kinegraph::read_mechanism(text, name);
    if (!mechanism) throw std::runtime_error("no such example");
    return kinegraph::solve(std::move(*mechanism)).value();
}

/// A finished figure without its labels; each becomes a request for a label of the same size at the middle of its old
/// place.
Figure unlettered(Figure figure) {
    std::vector<Mark> marks;
    for (Mark& mark : figure.marks) {
        const auto* text = std::get_if<TextMark>(&mark);
        if (!text || text->cls != "label" || text->glyphs.empty()) {
            marks.push_back(std::move(mark));
            continue;
        }
        LabelRequest request;
        Piece words;
        words.text = text->words;
        words.face = Face::italic;
        request.text = {words};
        request.anchor = text->pivot;
        if (text->angle != 0) {
            request.toward =
                Spot{text->pivot.x + 10 * std::cos(text->angle), text->pivot.y + 10 * std::sin(text->angle)};
            request.along = true;
        }
        figure.labels.push_back(std::move(request));
    }
    figure.marks = std::move(marks);
    return figure;
}

/// The figures of the richest example, in the size of its sheet.
std::vector<Figure> richest_figures() {
    const kinegraph::Solution solution = solved("cutting_force.json");
    const Theme theme;
    const DrawingContext context{solution, theme, fonts()};
    std::vector<Figure> figures{mechanism_figure(context, 124, 173, true), mechanism_with_forces(context, 124, 173),
                                force_polygons_figure(context, 124, 80), velocities_on_mechanism(context, 168, 80),
                                circle_diagram(context, 80, 78)};
    for (std::size_t p = 0; p < solution.protocol.polygons.size(); ++p)
        if (solution.protocol.polygons[p].plane != kinegraph::Plane::force)
            figures.push_back(polygon_figure(context, static_cast<int>(p), 124, 80));
    for (const int p : closed_polygons(solution)) figures.push_back(closed_polygon_figure(context, p, 124, 80));
    for (std::size_t i = 0; i < solution.free_bodies.size(); ++i)
        figures.push_back(free_body_figure(context, i, 80, 85));
    for (Figure& figure : figures) figure = unlettered(std::move(figure));
    return figures;
}

void letter_the_richest_sheet(benchmark::State& state) {
    const std::vector<Figure> figures = richest_figures();
    std::size_t labels = 0;
    for (const Figure& figure : figures) labels += figure.labels.size();
    for (auto _ : state)
        for (Figure figure : figures) {
            place_labels(figure, fonts(), Spot{figure.box.width() + 30, figure.box.height() + 30});
            benchmark::DoNotOptimize(figure.marks.data());
        }
    state.counters["figures"] = static_cast<double>(figures.size());
    state.counters["labels"] = static_cast<double>(labels);
}
BENCHMARK(letter_the_richest_sheet)->Unit(benchmark::kMillisecond);

/// `count` names on a page too small for them.
void letter_a_crowd(benchmark::State& state) {
    Figure crowd;
    const int count = static_cast<int>(state.range(0));
    for (int i = 0; i < count; ++i) {
        const Spot at{static_cast<double>(i * 37 % 100), static_cast<double>(i * 53 % 70)};
        Path path;
        path.segments = {MoveTo{at}, LineTo{{at.x + 20, at.y + i % 30 - 15}}};
        path.stroked = true;
        crowd.marks.emplace_back(std::move(path));
        LabelRequest request;
        Piece words;
        words.text = "a";
        words.sub = std::to_string(i);
        request.text = {words};
        request.anchor = at;
        crowd.labels.push_back(std::move(request));
    }
    crowd.box = {{0, 0}, {120, 80}};
    for (auto _ : state) {
        Figure figure = crowd;
        place_labels(figure, fonts(), Spot{130, 90});
        benchmark::DoNotOptimize(figure.marks.data());
    }
}
BENCHMARK(letter_a_crowd)->Arg(50)->Arg(100)->Arg(200)->Unit(benchmark::kMillisecond);

}  // namespace
