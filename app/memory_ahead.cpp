// Memory ahead: by glibc and Linux 5.14; elsewhere memory comes as it is touched.
#include "app/memory_ahead.hpp"

#include <cstddef>
#include <cstdlib>
#include <memory>
#if __has_include(<malloc.h>) && __has_include(<sys/mman.h>)
#include <malloc.h>
#include <sys/mman.h>
#endif

namespace kinegraph::app {

void take_memory_ahead() {
#if defined(M_MMAP_THRESHOLD) && defined(MADV_POPULATE_WRITE)
    constexpr int taken = 3 << 20, kept = 64 << 20;
    constexpr std::size_t page = 4096;
    // What is given back now must stay the process's.
    mallopt(M_MMAP_THRESHOLD, kept);
    mallopt(M_TRIM_THRESHOLD, kept);
    void* block = std::malloc(taken);
    if (block == nullptr) return;
    void* first = block;
    std::size_t space = taken;
    if (std::align(page, taken - page, first, space) != nullptr) madvise(first, taken - page, MADV_POPULATE_WRITE);
    std::free(block);
#endif
}

}  // namespace kinegraph::app
