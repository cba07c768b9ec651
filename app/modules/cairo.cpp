// kinegraph_cairo.so: PNG and PDF.
#include "app/late/modules.hpp"

using namespace kinegraph;

extern "C" [[gnu::visibility("default")]] const app::CairoModule kinegraph_cairo{render::to_png, render::to_pdf,
                                                                                 render::to_live_pdf};
