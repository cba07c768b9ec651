// Binding of a mark: what it moves with when the figure is animated. Names are those of engine/solution/bindings.hpp.
// Static drawings do not need it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace kinegraph::render {

struct Holds {
    /// A place is one name. A direction is one name (of a vector) or two (the places from which and to which it leads).
    enum class Form : std::uint8_t {
        nothing,
        at,      ///< moves with a place
        with,    ///< moves with a place and turns with a direction
        arrow,   ///< as `with`, if the vector is long enough
        couple,  ///< moves with a place; its sense follows the sign of a scalar
        line,    ///< on the lines of action of forces, each extended to the places on it: names of the forces, an empty
                 ///< name, names of the places
        segment,  ///< from place to place
        through,  ///< the visible part of the line through two places
        normal,   ///< the line through the first place, perpendicular to the direction
        circle,   ///< with two places as ends of a diameter
        arc,      ///< about the first place through the second
        body      ///< moves and turns with a body, given by its index
    } form = Form::nothing;
    std::vector<std::string> on{};
    double beyond = 0;  ///< extension of lines and segments past their ends, mm
    double unit = 0;    ///< for a label with a number: its unit in SI; 0: no number
};

std::string_view name_of(Holds::Form form);

}  // namespace kinegraph::render
