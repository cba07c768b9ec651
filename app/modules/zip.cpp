// kinegraph_zip.so: archives.
#include "app/late/modules.hpp"

using namespace kinegraph;

extern "C" [[gnu::visibility("default")]] const app::ZipModule kinegraph_zip{render::packed};
