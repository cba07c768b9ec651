// Line numbers: the numbers ①, ②, … that the lines of a polygon's construction carry, in the order drawn, on the figure
// and where a sentence names them. Owns which line has which; draws and says nothing.
#pragma once

#include <string>
#include <vector>

#include "render/scene/polygon_scene.hpp"

namespace kinegraph::render {

class LineNumbers {
public:
    /// Of one polygon. A line that stands alone has no number; nor has what is known, and so draws no line of its own.
    explicit LineNumbers(const PolygonScene& scene);

    /// "②" and a blank that does not break, before the name of a line; empty: it has none.
    std::string before(StatementIndex statement, const LineReason& reason) const;

private:
    struct Numbered {
        StatementIndex statement = none;
        LineReason reason;
        std::size_t number = 0;  // from 0
    };
    std::vector<Numbered> lines_;
};

}  // namespace kinegraph::render
