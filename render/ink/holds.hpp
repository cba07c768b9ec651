// Holds: what a mark hangs on, for whoever moves the figure. Names are those of engine/solution/held.hpp; a drawing
// that stands still needs none of it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace kinegraph::render {

struct Holds {
    /// A place is one name. A direction is one name, of a vector; or two, of the places that it leads from and to.
    enum class Form : std::uint8_t {
        nothing,
        at,      ///< goes with a place
        with,    ///< goes with a place and turns with a direction
        arrow,   ///< the same, as long as the vector is large
        couple,  ///< goes with a place; its sense is that of a scalar
        line,  ///< on the lines of forces, each as far as to the places on it: names of the forces, an empty one, those
               ///< of the places
        segment,  ///< from place to place
        through,  ///< all that is seen of the line through two places
        normal,   ///< of the line through the first, normal to that
        circle,   ///< on two places as ends of a diameter
        arc,      ///< about the first through the second
        body      ///< goes and turns with a body: its index
    } form = Form::nothing;
    std::vector<std::string> on{};
    double beyond = 0;  ///< by how much lines and segments go on past their ends, mm
    double unit = 0;    ///< of a label that says a number: its unit in SI; 0: it says none
};

std::string_view name_of(Holds::Form form);

}  // namespace kinegraph::render
