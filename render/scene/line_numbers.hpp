// Line numbers: the numbers ①, ②, … of the construction lines of a polygon, in drawing order. The figure and the
// sentences share them.
#pragma once

#include <string>
#include <vector>

#include "render/scene/polygon_scene.hpp"

namespace kinegraph::render {

class LineNumbers {
public:
    /// For one polygon. A single line gets no number; nor does a known quantity, which needs no line.
    explicit LineNumbers(const PolygonScene& scene);

    /// "②"; empty if it has no number.
    std::string of(StatementIndex statement, const LineReason& reason) const;
    /// "②" and a no-break space, before the name of a line; empty if it has no number.
    std::string before(StatementIndex statement, const LineReason& reason) const;

private:
    struct Numbered {
        StatementIndex statement = none;
        LineReason reason;
        std::size_t number = 0;  // counted from 0
    };
    std::vector<Numbered> lines_;
};

}  // namespace kinegraph::render
