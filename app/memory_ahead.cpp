// Memory ahead: by glibc and Linux 5.14; elsewhere memory comes as it is touched.
#include "app/memory_ahead.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#if __has_include(<sys/mman.h>)
#include <sys/mman.h>
#endif

// Sanitizers keep what is freed from being used again, so that nothing can be taken ahead.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define KINEGRAPH_MEMORY_WATCHED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
#define KINEGRAPH_MEMORY_WATCHED 1
#endif
#endif

namespace kinegraph::app {

void take_memory_ahead([[maybe_unused]] Ahead ahead) {
#if !defined(KINEGRAPH_MEMORY_WATCHED) && defined(__GLIBC__) && defined(MADV_POPULATE_WRITE) && defined(MADV_HUGEPAGE)
    constexpr std::size_t large_page = std::size_t{2} << 20U, small_page = 4096;
    const std::size_t taken = (ahead == Ahead::of_a_sheet ? 4 : 2) * large_page, of_small_pages = taken * 3 / 8;
    void* const block = std::malloc(taken + large_page);
    if (block == nullptr) return;
    const auto begin = reinterpret_cast<std::uintptr_t>(block);
    const auto up_to = [begin](std::size_t page) { return (begin + page - 1) / page * page; };
    const std::uintptr_t first_large = up_to(large_page);
    std::free(block);
    // What lies before the first large page is left alone to the end, never touched: it would come in small ones. (Volatile: who
    // asks for memory and makes nothing of it is not heard.)
    [[maybe_unused]] void* volatile const before = std::malloc(first_large - begin);
    if (madvise(reinterpret_cast<void*>(first_large), taken, MADV_HUGEPAGE) == 0)
        madvise(reinterpret_cast<void*>(first_large), taken, MADV_POPULATE_WRITE);
    else
        madvise(reinterpret_cast<void*>(up_to(small_page)), of_small_pages, MADV_POPULATE_WRITE);
#endif
}

}  // namespace kinegraph::app
