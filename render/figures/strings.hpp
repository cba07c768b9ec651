// The strings of a funicular polygon, drawn over the mechanism, truss or body whose forces it composes.
#pragma once

#include "render/mechanism/sketch.hpp"

namespace kinegraph::render::drawing {

/// Strings have the numbers of their rays. The closing line has the last number; the outer strings extend to their
/// intersection if that is near. A string of zero length (the force passes through its starting point) is omitted.
/// `load`: of loads that act alone; empty: all loads.
void draw_strings(Sketch& sketch, const FreeBody::Funicular& funicular, const std::string& load = "");
/// Extends `box` by the ends of the strings within `near`: m, y downwards.
void include_strings(Box& box, const FreeBody::Funicular& funicular, const Box& near);

}  // namespace kinegraph::render::drawing
