// kinegraph_subset.so: the library's subsets of fonts, for the program to load when it writes live text.
#include "app/modules/subset.hpp"

extern "C" [[gnu::visibility("default")]] const kinegraph::app::SubsetFunctions kinegraph_subset{
    kinegraph::render::font_subset};
