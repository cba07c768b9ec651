// Block memory: where the blocks come from that C++ asks for with new. A sheet makes and drops some fifteen thousand,
// most of them short strings and lists of a few marks, far more at once than glibc keeps at hand for a thread (seven of
// a size), and its search for all others takes a seventh of a sheet's time. So each thread keeps what it drops in lists
// by size and takes it from there again, as numbers do (engine/number/number_memory.hpp).
//
// Every block comes from malloc with the size of its class, which is that of malloc's own chunks, and may go back to
// free() at any time: blocks of a list and others may be mixed, whoever made them (a module has a new and a delete of
// its own) and whichever thread ends them. Sanitizers must see every block end, and other libraries of C have other
// chunks: there nothing is replaced.
#include "app/commands/block_memory.hpp"

#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>

#include "engine/number/watched_memory.hpp"

#if defined(KINEGRAPH_MEMORY_WATCHED) || !defined(__GLIBC__) || __SIZEOF_POINTER__ != 8

namespace kinegraph::app {
void give_back_block_memory() {}
}  // namespace kinegraph::app

#else

namespace kinegraph::app {
namespace {

// A chunk of malloc's is a multiple of 16 bytes, of which 8 are its own; the least has 32.
constexpr std::size_t grain = 16, own = 8;
constexpr std::size_t classes = 128;  ///< blocks up to 2 KiB; longer ones are few
/// Bytes of one class that a thread keeps. A thread that ends what another makes (lines of batch) gets ever more of a
/// class or two: that must not take the place of all others.
constexpr std::size_t most_of_a_class = std::size_t{1} << 20U;

/// Blocks of one class that are not in use. Their places stand here and not in themselves: a block that was dropped
/// long ago is far away, and to read the next one's place from it would wait for it.
struct List {
    void** blocks;
    std::uint32_t count, room;
};
struct Lists {
    std::array<List, classes + 1> of;  ///< by class
    bool are_closed;                   ///< nothing more is kept
};
// (The model says that the program itself holds them, so that finding them is no call.)
[[gnu::tls_model("initial-exec")]] thread_local constinit Lists lists{};

constexpr std::size_t class_of(std::size_t size) {
    const std::size_t chunks = (size + own + grain - 1) / grain;
    return chunks < 2 ? 2 : chunks;
}
constexpr std::size_t room_of(std::size_t of_class) { return of_class * grain - own; }

[[gnu::noinline]] void* ask(std::size_t size) {
    for (;;) {
        if (void* const block = std::malloc(size)) return block;
        const std::new_handler handler = std::get_new_handler();
        if (handler == nullptr) throw std::bad_alloc();
        handler();
    }
}

inline void* take(std::size_t size) {
    constexpr std::size_t longest = room_of(classes);
    if (size > longest) [[unlikely]]
        return ask(size);
    const std::size_t of_class = class_of(size);
    List& list = lists.of[of_class];
    if (list.count == 0) [[unlikely]]
        return ask(room_of(of_class));
    return list.blocks[--list.count];
}

/// A block for which its list has no room: that grows, or the block goes back.
[[gnu::noinline]] void give_to_full_list(void* memory, std::size_t of_class) {
    constexpr std::uint32_t least = 64;
    List& list = lists.of[of_class];
    const std::uint32_t room = list.room == 0 ? least : 2 * list.room;
    if (lists.are_closed || room * of_class * grain > most_of_a_class) return std::free(memory);
    void* const larger = std::realloc(list.blocks, room * sizeof(void*));
    if (larger == nullptr) return std::free(memory);
    list.blocks = static_cast<void**>(larger);
    list.room = room;
    list.blocks[list.count++] = memory;
}

/// `room`: what it was asked for with, or what it has.
inline void give(void* memory, std::size_t room) {
    const std::size_t of_class = class_of(room);
    if (of_class > classes) [[unlikely]]
        return std::free(memory);
    List& list = lists.of[of_class];
    if (list.count == list.room) [[unlikely]]
        return give_to_full_list(memory, of_class);
    list.blocks[list.count++] = memory;
}

}  // namespace

void give_back_block_memory() {
    for (List& list : lists.of) {
        for (std::size_t i = 0; i < list.count; ++i) std::free(list.blocks[i]);
        std::free(list.blocks);
        list = {};
    }
    lists.are_closed = true;  // what ends after this goes back at once
}

}  // namespace kinegraph::app

void* operator new(std::size_t size) { return kinegraph::app::take(size); }
void operator delete(void* memory) noexcept {
    if (memory != nullptr) kinegraph::app::give(memory, ::malloc_usable_size(memory));
}
void operator delete(void* memory, std::size_t size) noexcept {
    if (memory != nullptr) kinegraph::app::give(memory, size);
}

#endif
