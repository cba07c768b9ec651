// The strings of a funicular polygon, over the mechanism, the truss or the body on which it balances forces.
#pragma once

#include "render/mechanism/sketch.hpp"

namespace kinegraph::render::drawing {

/// The strings numbered as the rays are, the closing line broken, the outer ones as far as they meet if that is near.
/// One without length (the force passes where it begins) is left out. `load`: of what acts alone; empty: all loads.
void draw_strings(Sketch& sketch, const FreeBody::Funicular& funicular, const std::string& load = "");
/// Where the strings end, as far as they are near enough to make room for: m, y downwards, into `box`.
void include_strings(Box& box, const FreeBody::Funicular& funicular, const Box& near);

}  // namespace kinegraph::render::drawing
