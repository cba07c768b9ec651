#include "render/figures/strings.hpp"

#include <utility>

#include "render/page/shapes.hpp"

namespace kinegraph::render::drawing {

void draw_strings(Sketch& sketch, const FreeBody::Funicular& funicular) {
    constexpr double least = 0.5;  // mm
    const Theme& theme = sketch.theme;
    const auto& vertices = funicular.vertices;
    const auto string = [&](const Vector& from, const Vector& to, std::size_t number, std::vector<double> dashed) {
        const Spot a = sketch.spot(from), b = sketch.spot(to);
        if (length(b - a) < least) return;
        sketch.over_bodies.emplace_back(line(a, b, {theme.thin, theme.text, std::move(dashed), false}));
        belong(sketch.over_bodies, sketch.over_bodies.size() - 1, funicular.statement);
        sketch.add_label(one_piece(std::to_string(number)), theme.secondary, 0.5 * (a + b), 1.0, funicular.statement).size =
            theme.small;
    };
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i) string(*vertices[i], *vertices[i + 1], i + 1, {});
    string(*vertices.back(), *vertices.front(), vertices.size(), dashes());
    if (!funicular.resultant) return;
    // The outer strings as far as they meet, on the line of the resultant.
    const Spot meet = sketch.spot(*funicular.resultant);
    if (!contains(grown(sketch.mechanism_box(), 0.6 * sketch.size()), meet)) return;
    for (const Spot end : {sketch.spot(*vertices[1]), sketch.spot(*vertices[vertices.size() - 2])}) {
        if (length(meet - end) < 1) continue;
        sketch.construction.emplace_back(line(end, meet, {theme.thin, theme.secondary, dashes(), false}));
        belong(sketch.construction, sketch.construction.size() - 1, funicular.statement);
    }
}

void include_strings(Box& box, const FreeBody::Funicular& funicular, const Box& near) {
    for (const Recorded<Vector>& vertex : funicular.vertices)
        if (const Spot at = paper_spot(*vertex); contains(near, at)) box.include(at);
}

}  // namespace kinegraph::render::drawing
