#include "render/figures/strings.hpp"

#include <optional>
#include <utility>
#include <vector>

#include "engine/solution/bindings.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render::drawing {

namespace {

/// A funicular polygon on a sketch. String i runs from vertex i to the next one; the last one is the closing line.
class Strings {
public:
    Strings(Sketch& sketch, const FreeBody::Funicular& funicular, const std::string& load)
        : sketch_(sketch), funicular_(funicular), load_(load) {
        if (!funicular.resultant) return;
        const Spot meet = sketch.spot(*funicular.resultant);
        if (contains(grown(sketch.mechanism_box(), 0.6 * sketch.size()), meet)) meet_ = meet;
    }

    void draw() {
        const std::size_t last = funicular_.vertices.size() - 1;
        for (std::size_t i = 0; i <= last; ++i) draw(i, i < last ? i + 1 : 0);
        if (!meet_) return;
        extend(1);
        extend(last - 1);
    }

private:
    Spot vertex(std::size_t index) const { return sketch_.spot(*funicular_.vertices[index]); }
    Holds held(std::size_t from, std::size_t to) const {
        return {Holds::Form::segment, {string_binding(load_, funicular_, from), string_binding(load_, funicular_, to)}};
    }
    bool is_outer(std::size_t string) const { return string == 0 || string + 2 == funicular_.vertices.size(); }

    void draw(std::size_t from, std::size_t to) {
        constexpr double least = 0.5;  // mm
        const Spot a = vertex(from), b = vertex(to);
        std::vector<std::pair<std::size_t, Spot>> ends{from == 0 ? std::pair{to, b} : std::pair{from, a}};
        if (length(b - a) >= least) {
            sketch_.over_bodies.emplace_back(line(a, b, {sketch_.theme.thin, sketch_.theme.text, {}, false}));
            belong(sketch_.over_bodies, sketch_.over_bodies.size() - 1, funicular_.statement);
            hang(sketch_.over_bodies, sketch_.over_bodies.size() - 1, held(from, to));
            ends.push_back(from == 0 ? std::pair{from, a} : std::pair{to, b});
        }
        // Of an outer string between two forces of one point there is the extension only.
        if (meet_ && is_outer(from)) ends.emplace_back(funicular_.vertices.size(), *meet_);
        if (ends.size() == 3 && length(ends[2].second - ends[1].second) < length(ends[0].second - ends[1].second))
            ends.pop_back();  // the intersection is on the string
        if (ends.size() < 2 || length(ends.back().second - ends[ends.size() - 2].second) < least) return;
        name(from + 1, ends[ends.size() - 2].second, ends.back().second,
             held(ends[ends.size() - 2].first, ends.back().first));
    }
    /// The number stands nearer to its string than to another.
    void name(std::size_t number, Spot a, Spot b, Holds holds) {
        LabelRequest& label = sketch_.add_label(one_piece(std::to_string(number)), sketch_.theme.secondary,
                                                0.5 * (a + b), 1.0, funicular_.statement);
        label.size = sketch_.theme.small;
        label.toward = b;
        label.is_of_vector = true;
        label.holds = std::move(holds);
    }
    /// An outer string to its intersection with the other one, on the line of the resultant.
    void extend(std::size_t from) {
        const Spot end = vertex(from);
        if (length(*meet_ - end) < 1) return;
        sketch_.construction.emplace_back(line(end, *meet_, {sketch_.theme.thin, sketch_.theme.secondary, {}, false}));
        belong(sketch_.construction, sketch_.construction.size() - 1, funicular_.statement);
        hang(sketch_.construction, sketch_.construction.size() - 1, held(from, funicular_.vertices.size()));
    }

    Sketch& sketch_;
    const FreeBody::Funicular& funicular_;
    const std::string& load_;
    std::optional<Spot> meet_;  // where it is near enough
};

}  // namespace

void draw_strings(Sketch& sketch, const FreeBody::Funicular& funicular, const std::string& load) {
    Strings(sketch, funicular, load).draw();
}

void include_strings(Box& box, const FreeBody::Funicular& funicular, const Box& near) {
    for (const Recorded<Vector>& vertex : funicular.vertices)
        if (const Spot at = paper_spot(*vertex); contains(near, at)) box.include(at);
}

}  // namespace kinegraph::render::drawing
