// Number memory: the same numbers, the same blocks again and again, and all of them given back.
#include "engine/number/number_memory.hpp"

#include <gmp.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "engine/number/exact.hpp"
#include "engine/number/watched_memory.hpp"

namespace kinegraph {
namespace {

// What GMP asks for without ours, counted.
std::atomic<long> asked_for = 0, held = 0;
void* allocate(std::size_t size) {
    ++asked_for;
    ++held;
    return std::malloc(size);  // NOLINT(cppcoreguidelines-no-malloc): as GMP itself
}
void* reallocate(void* block, std::size_t, std::size_t size) {
    return std::realloc(block, size);  // NOLINT(cppcoreguidelines-no-malloc)
}
void release(void* block, std::size_t) {
    --held;
    std::free(block);  // NOLINT(cppcoreguidelines-no-malloc)
}

/// Fractions from one limb to far more than are kept, and their texts.
std::vector<Exact> harmonic_numbers() {
    std::vector<Exact> sums{1};
    for (int i = 2; i < 40; ++i) sums.push_back(sums.back() + Exact::ratio(1, i));
    for (int i = 0; i < 7; ++i) sums.push_back(sums.back() * sums.back());
    return sums;
}
std::string texts_of(const std::vector<Exact>& numbers) {
    std::string texts;
    for (const Exact& each : numbers) texts += each.to_fraction() + ' ';
    return texts;
}

/// GMP's functions as they were, whatever a test has made of them.
class Restored {
public:
    Restored() { mp_get_memory_functions(&allocate_, &reallocate_, &free_); }
    Restored(const Restored&) = delete;
    Restored& operator=(const Restored&) = delete;
    ~Restored() { mp_set_memory_functions(allocate_, reallocate_, free_); }

private:
    void* (*allocate_)(std::size_t) = nullptr;
    void* (*reallocate_)(void*, std::size_t, std::size_t) = nullptr;
    void (*free_)(void*, std::size_t) = nullptr;
};

// One test, for the functions are set once in a process.
TEST(NumberMemory, ServesAllThreadsAndGivesEverythingBack) {
    const std::string expected = texts_of(harmonic_numbers());
    const Restored restored;
    mp_set_memory_functions(allocate, reallocate, release);
    const long before = held;
    keep_number_memory();

    [[maybe_unused]] long taken[] = {0, 0};
    for (long& each : taken) {
        const long start = asked_for;
        harmonic_numbers();
        each = asked_for - start;
    }
#if !defined(KINEGRAPH_MEMORY_WATCHED)
    // The second time only the longest numbers want other blocks.
    EXPECT_LT(taken[1], taken[0] / 2);
#endif
    EXPECT_EQ(texts_of(harmonic_numbers()), expected);

    // Made here and ended there, made there and ended here.
    std::vector<Exact> here = harmonic_numbers(), there;
    std::thread([&here, &there, &expected] {
        EXPECT_EQ(texts_of(std::exchange(here, {})), expected);
        there = harmonic_numbers();
        give_back_number_memory();
    }).join();
    EXPECT_EQ(texts_of(there), expected);

    here.clear();
    there.clear();
    give_back_number_memory();
    EXPECT_EQ(held, before);
}

}  // namespace
}  // namespace kinegraph
