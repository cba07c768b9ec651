// kinegraph_ginac.so: derivatives in symbols.
#include "app/late/modules.hpp"

using namespace kinegraph;

extern "C" [[gnu::visibility("default")]] const app::GinacModule kinegraph_ginac{derivative};
