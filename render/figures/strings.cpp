#include "render/figures/strings.hpp"

#include "engine/solution/bindings.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render::drawing {

void draw_strings(Sketch& sketch, const FreeBody::Funicular& funicular, const std::string& load) {
    constexpr double least = 0.5;  // mm
    const Theme& theme = sketch.theme;
    const auto& vertices = funicular.vertices;
    const auto held = [&](std::size_t from, std::size_t to) {
        return Holds{Holds::Form::segment,
                     {string_binding(load, funicular, from), string_binding(load, funicular, to)}};
    };
    const auto string = [&](std::size_t from, std::size_t to, std::size_t number) {
        const Spot a = sketch.spot(*vertices[from]), b = sketch.spot(*vertices[to]);
        if (length(b - a) < least) return;
        sketch.over_bodies.emplace_back(line(a, b, {theme.thin, theme.text, {}, false}));
        belong(sketch.over_bodies, sketch.over_bodies.size() - 1, funicular.statement);
        hang(sketch.over_bodies, sketch.over_bodies.size() - 1, held(from, to));
        LabelRequest& label = sketch.add_label(one_piece(std::to_string(number)), theme.secondary, 0.5 * (a + b), 1.0,
                                               funicular.statement);
        label.size = theme.small;
        label.holds = held(from, to);
    };
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i) string(i, i + 1, i + 1);
    string(vertices.size() - 1, 0, vertices.size());
    if (!funicular.resultant) return;
    // The outer strings to their intersection, on the line of the resultant.
    const Spot meet = sketch.spot(*funicular.resultant);
    if (!contains(grown(sketch.mechanism_box(), 0.6 * sketch.size()), meet)) return;
    for (const std::size_t i : {std::size_t{1}, vertices.size() - 2}) {
        const Spot end = sketch.spot(*vertices[i]);
        if (length(meet - end) < 1) continue;
        sketch.construction.emplace_back(line(end, meet, {theme.thin, theme.secondary, {}, false}));
        belong(sketch.construction, sketch.construction.size() - 1, funicular.statement);
        hang(sketch.construction, sketch.construction.size() - 1, held(i, vertices.size()));
    }
}

void include_strings(Box& box, const FreeBody::Funicular& funicular, const Box& near) {
    for (const Recorded<Vector>& vertex : funicular.vertices)
        if (const Spot at = paper_spot(*vertex); contains(near, at)) box.include(at);
}

}  // namespace kinegraph::render::drawing
