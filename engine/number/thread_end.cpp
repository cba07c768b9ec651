#include "engine/number/thread_end.hpp"

#include <mpfr.h>

#include "engine/number/number_memory.hpp"

namespace kinegraph {

void end_thread() {
    mpfr_free_cache();
    give_back_number_memory();
}

}  // namespace kinegraph
