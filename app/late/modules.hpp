// The interface between the program and its modules: each module exports, under its own name, one table of the
// library's functions that it contains.
#pragma once

#include "engine/file/expression.hpp"
#include "render/backends/archive.hpp"
#include "render/backends/backends.hpp"
#include "render/text/subset.hpp"
#include "render/text/typeface.hpp"

namespace kinegraph::app {

struct CairoModule {
    decltype(&render::to_png) to_png;
    decltype(&render::to_pdf) to_pdf;
    decltype(&render::to_live_pdf) to_live_pdf;
};
struct TypeModule {
    decltype(&render::open_typefaces) open_typefaces;
    decltype(&render::font_subset) font_subset;
};
struct GinacModule {
    decltype(&derivative) derivative_of;
};
struct ZipModule {
    decltype(&render::packed) packed_files;
};

}  // namespace kinegraph::app
