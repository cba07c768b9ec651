// Kept scales: the scales of one sheet, for another that is to be read beside it: the same problem in another language,
// in brief, or with other numbers.
#pragma once

#include <map>
#include <optional>
#include <string>

namespace kinegraph::render {

struct KeptScales {
    enum class Hold {
        exactly,      ///< the same scales
        not_coarser,  ///< the same scales or finer ones
    };
    /// By name in the command line, units per mm. A figure that has no name here is free. Those of vectors on a drawing
    /// of places have the name of its figure with an ending.
    std::map<std::string, double> of_figures;
    static std::string vectors_of(const std::string& figure) { return figure + " vectors"; }
    std::optional<double> of_forces;  ///< common scale of the force polygons
    Hold hold = Hold::exactly;
};

}  // namespace kinegraph::render
