// kinegraph_ginac.so: symbolic derivatives.
#include "app/late/modules.hpp"

using namespace kinegraph;

extern "C" [[gnu::visibility("default")]] const app::GinacModule kinegraph_ginac{derivative};
