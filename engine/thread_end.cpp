#include "engine/thread_end.hpp"

#include <mpfr.h>

namespace kinegraph {

void end_thread() { mpfr_free_cache(); }

}  // namespace kinegraph
