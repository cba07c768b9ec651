// Memory ahead: by glibc and Linux 5.14; elsewhere memory comes as it is touched.
#include "app/commands/memory_ahead.hpp"

#include <cstddef>
#include <cstdlib>
#include <memory>

#include "engine/number/watched_memory.hpp"
#if __has_include(<sys/mman.h>)
#include <sys/mman.h>
#endif

namespace kinegraph::app {

void take_memory_ahead([[maybe_unused]] Ahead ahead) {
#if !defined(KINEGRAPH_MEMORY_WATCHED) && defined(__GLIBC__) && defined(MADV_POPULATE_WRITE) && defined(MADV_HUGEPAGE)
    constexpr std::size_t large_page = std::size_t{2} << 20U, small_page = 4096;
    const std::size_t taken = (ahead == Ahead::of_a_sheet ? 4 : 2) * large_page, of_small_pages = taken * 3 / 8;
    const std::size_t asked = taken + large_page;
    void* const block = std::malloc(asked);
    if (block == nullptr) return;
    const auto first_after = [&](std::size_t page) {
        void* first = block;
        std::size_t space = asked;
        return std::align(page, 1, first, space);
    };
    void *const large = first_after(large_page), *const small = first_after(small_page);
    const auto before_large = static_cast<std::size_t>(static_cast<char*>(large) - static_cast<char*>(block));
    std::free(block);
    // What lies before the first large page is left alone to the end, never touched: it would come in small ones.
    // (Volatile: who asks for memory and makes nothing of it is not heard.)
    [[maybe_unused]] void* volatile const left_alone = std::malloc(before_large);
    if (madvise(large, taken, MADV_HUGEPAGE) == 0)
        madvise(large, taken, MADV_POPULATE_WRITE);
    else
        madvise(small, of_small_pages, MADV_POPULATE_WRITE);
#endif
}

}  // namespace kinegraph::app
