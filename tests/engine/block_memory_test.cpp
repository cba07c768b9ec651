// Block memory: blocks of all sizes, each one's own, whichever thread made them; the same again and again; all of them
// given back. What is tested is what the program is linked with, so it stands here as a whole, and serves all tests.
#include "app/commands/block_memory.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "app/commands/block_memory.cpp"  // NOLINT(bugprone-suspicious-include): the library has no part of it

namespace kinegraph::app {
namespace {

constexpr std::size_t largest = 5000;  // bytes, beyond what is kept

unsigned char mark_of(std::size_t size) { return static_cast<unsigned char>(size % 251); }

std::vector<void*> blocks_of_all_sizes() {
    std::vector<void*> blocks;
    for (std::size_t size = 0; size < largest; ++size) {
        blocks.push_back(::operator new(size));
        std::memset(blocks.back(), mark_of(size), size);
    }
    return blocks;
}
bool are_whole(const std::vector<void*>& blocks) {
    for (std::size_t size = 0; size < blocks.size(); ++size) {
        const auto* bytes = static_cast<const unsigned char*>(blocks[size]);
        for (std::size_t i = 0; i < size; ++i)
            if (bytes[i] != mark_of(size)) return false;
    }
    return true;
}
/// By turns with their size told and not.
void drop(const std::vector<void*>& blocks) {
    for (std::size_t size = 0; size < blocks.size(); ++size)
        if (size % 2 == 0)
            ::operator delete(blocks[size], size);
        else
            ::operator delete(blocks[size]);
}

TEST(BlockMemory, BlocksDoNotMeet) {
    for (int round = 0; round < 3; ++round) {
        const std::vector<void*> blocks = blocks_of_all_sizes();
        EXPECT_TRUE(are_whole(blocks));
        drop(blocks);
    }
    ::operator delete(nullptr);
    ::operator delete (nullptr, std::size_t{8});
}

TEST(BlockMemory, ABlockMayEndInAnotherThread) {
    std::vector<void*> blocks;
    std::thread([&] {
        blocks = blocks_of_all_sizes();
        give_back_block_memory();
    }).join();
    EXPECT_TRUE(are_whole(blocks));
    std::thread([&] {
        drop(blocks);
        give_back_block_memory();
        drop(blocks_of_all_sizes());  // of which nothing is kept any more
    }).join();
    const std::vector<void*> others = blocks_of_all_sizes();
    EXPECT_TRUE(are_whole(others));
    drop(others);
}

TEST(BlockMemory, BlocksOfAnotherThreadAreKeptUpToAMeasure) {
    constexpr std::size_t size = 100, count = 100'000;  // far more than are kept of a class
    std::vector<void*> blocks;
    std::thread([&] {
        for (std::size_t i = 0; i < count; ++i) blocks.push_back(::operator new(size));
        give_back_block_memory();
    }).join();
    for (void* const block : blocks) ::operator delete(block, size);
    const std::vector<void*> others = blocks_of_all_sizes();
    EXPECT_TRUE(are_whole(others));
    drop(others);
}

// A module has a new and a delete of its own, which are those of C.
#if defined(__GLIBC__) && !defined(KINEGRAPH_MEMORY_WATCHED)
TEST(BlockMemory, TakesAndGivesBlocksOfC) {
    void* (*volatile of_c)(std::size_t) = std::malloc;  // the compiler warns of what is tested here
    for (std::size_t size = 1; size < largest; ++size) ::operator delete(of_c(size), size);
    const std::vector<void*> blocks = blocks_of_all_sizes();
    EXPECT_TRUE(are_whole(blocks));
    for (void* const block : blocks) std::free(block);
}

TEST(BlockMemory, WhatIsDroppedIsTakenAgain) {
    void* const first = ::operator new(100);
    ::operator delete(first, 100);
    void* const second = ::operator new(101);  // of the same class
    EXPECT_EQ(first, second);
    ::operator delete(second);
}
#endif

}  // namespace
}  // namespace kinegraph::app
