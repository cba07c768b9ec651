// The target of libFuzzer: a file goes through everything; mutations work on its tree. At the end it says how far files
// came.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

#include "tests/fuzz/mutate.hpp"
#include "tests/support/fonts.hpp"
#include "tests/support/through_all.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t longest);

namespace {

struct Counts {
    unsigned long runs = 0, read = 0, solved = 0, drawn = 0;
    ~Counts() {
        const auto share = [&](unsigned long of) {
            return 100.0 * static_cast<double>(of) / static_cast<double>(runs + (runs == 0));
        };
        std::fprintf(stderr, "%lu runs: %.1f %% read, %.1f %% solved, %.1f %% drawn\n", runs, share(read),
                     share(solved), share(drawn));
    }
};
Counts counts;

std::string_view text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

std::size_t given_back(const std::string& text, std::uint8_t* data, std::size_t longest) {
    if (text.empty() || text.size() > longest) return 0;
    std::memcpy(data, text.data(), text.size());
    return text.size();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto far = kinegraph::tests::through_all(text_of(data, size), kinegraph::tests::fonts());
    ++counts.runs;
    counts.read += far.read;
    counts.solved += far.solved;
    counts.drawn += far.drawn;
    return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t longest,
                                               unsigned seed) {
    constexpr unsigned one_in = 50;  // of the bytes themselves: what is no JSON is refused too
    const std::string text = seed % one_in == 0 ? "" : kinegraph::fuzz::mutated(text_of(data, size), {}, seed);
    if (const std::size_t changed = given_back(text, data, longest)) return changed;
    return LLVMFuzzerMutate(data, size, longest);
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* one, std::size_t size_of_one,
                                                 const std::uint8_t* other, std::size_t size_of_other,
                                                 std::uint8_t* out, std::size_t longest, unsigned seed) {
    return given_back(kinegraph::fuzz::mutated(text_of(one, size_of_one), text_of(other, size_of_other), seed), out,
                      longest);
}
