// kinegraph_type.so: HarfBuzz, for typefaces and subsets of fonts.
#include "app/late/modules.hpp"

using namespace kinegraph;

extern "C"
    [[gnu::visibility("default")]] const app::TypeModule kinegraph_type{render::open_typefaces, render::font_subset};
