// kinegraph_type.so: the library's typefaces, for the program to load when it draws.
#include "app/modules/type.hpp"

extern "C" [[gnu::visibility("default")]] const kinegraph::app::TypeFunctions kinegraph_type{
    kinegraph::render::open_typefaces};
