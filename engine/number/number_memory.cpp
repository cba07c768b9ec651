// GMP asks through three functions without a context, so the lists are a thread's and the functions it had before are
// kept here: there is no other place for them.
//
// Every block comes from the functions before ours, with at least the size it is asked for, and goes back to them with
// any size that GMP says. So blocks of a list and others may be mixed, whoever made them and whichever thread ends
// them.
#include "engine/number/number_memory.hpp"

#include <gmp.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstring>

#include "engine/number/watched_memory.hpp"

namespace kinegraph {

#if defined(KINEGRAPH_MEMORY_WATCHED)

void keep_number_memory() {}
void give_back_number_memory() {}

#else

namespace {

/// A block that is not in use begins with the next of its size.
struct Block {
    Block* next;
};
static_assert(sizeof(Block) <= sizeof(mp_limb_t), "a block of one limb holds its link");

constexpr std::size_t limb = sizeof(mp_limb_t);
constexpr std::size_t longest = 64;  ///< limbs of a block that is kept: 4096 bits; longer numbers are few
constexpr std::size_t most_kept = std::size_t{4} << 20U;  ///< bytes a thread keeps

struct Lists {
    std::array<Block*, longest + 1> first;  ///< by limbs
    std::size_t kept;                       ///< bytes
};
// (The model says that the program itself holds them, so that finding them is no call.)
[[gnu::tls_model("initial-exec")]] thread_local constinit Lists lists{};

struct Before {
    void* (*allocate)(std::size_t) = nullptr;
    void* (*reallocate)(void*, std::size_t, std::size_t) = nullptr;
    void (*free)(void*, std::size_t) = nullptr;
};
constinit Before before;

/// Whether blocks of this size are kept: whole limbs, not too many. (Texts of numbers have any size.) Turned right by
/// the bits below a limb, sizes of whole limbs are their number and all others are huge: one comparison for both.
bool is_kept(std::size_t size) {
    static_assert(std::has_single_bit(limb));
    return std::rotr(size, std::countr_zero(limb)) - 1 < longest;
}

void* take(std::size_t size) {
    if (!is_kept(size)) return before.allocate(size);
    Block*& first = lists.first[size / limb];
    if (first == nullptr) return before.allocate(size);
    Block* const block = first;
    first = block->next;
    lists.kept -= size;
    return block;
}

void give(void* memory, std::size_t size) {
    if (!is_kept(size) || lists.kept + size > most_kept) return before.free(memory, size);
    auto* const block = static_cast<Block*>(memory);
    Block*& first = lists.first[size / limb];
    block->next = first;
    first = block;
    lists.kept += size;
}

void* take_again(void* memory, std::size_t old_size, std::size_t size) {
    if (!is_kept(old_size) || !is_kept(size)) return before.reallocate(memory, old_size, size);
    void* const moved = take(size);
    std::memcpy(moved, memory, old_size < size ? old_size : size);
    give(memory, old_size);
    return moved;
}

}  // namespace

void keep_number_memory() {
    if (before.allocate != nullptr) return;
    mp_get_memory_functions(&before.allocate, &before.reallocate, &before.free);
    mp_set_memory_functions(take, take_again, give);
}

void give_back_number_memory() {
    for (std::size_t limbs = 1; limbs <= longest; ++limbs)
        while (Block* const block = lists.first[limbs]) {
            lists.first[limbs] = block->next;
            before.free(block, limbs * limb);
        }
    lists.kept = 0;
}

#endif

}  // namespace kinegraph
