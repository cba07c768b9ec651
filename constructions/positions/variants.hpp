// Variants of an exercise: one draw after another from the values of its parameters, solved, and kept where its
// conditions hold. Writes nothing and draws nothing: what only a drawing tells is asked of the caller.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "constructions/positions/conditions.hpp"
#include "engine/mechanism/variation.hpp"

namespace kinegraph {

/// One exercise of many.
struct Variant {
    std::vector<Setting> values;  ///< of the parameters that vary, in the file's order
    Solution solution;
    std::vector<NamedResult>
        results;  ///< that it asks for; where it asks for none, efforts, else angular velocities, else all
};

/// Whether every vector that is sought in a polygon is long enough on paper to be read.
using IsReadable = std::function<bool(const Solution&, Condition::Polygon)>;

/// The variants of a file, in the order that a seed gives them: the n-th is the n-th combination of the shuffled
/// lattice whose conditions hold, whatever number is wanted, but for those that come to the mechanism of one before; so
/// all differ, and each combination is looked at once.
class Variants {
public:
    /// `text` names `source` in messages; `set`: parameters in place of the file's. Errors: the file's faults; that it
    /// varies nothing.
    static Result<Variants> of(std::string text, std::string source, std::vector<Setting> set, std::uint64_t seed);

    /// The next one; nothing where there is none: all combinations have been looked at, `most_in_a_row` failed one
    /// after the other, or `stops` says so, which is asked before each. Errors: of the file, which asks for or compares
    /// what is not there.
    Result<std::optional<Variant>> next(const IsReadable& is_readable, const std::function<bool()>& stops = {});

    std::uint64_t combinations() const { return size_; }
    std::uint64_t looked_at() const { return looked_at_; }
    bool is_exhausted() const { return looked_at_ == size_; }
    const Mechanism& original() const { return original_; }

    /// Why combinations were rejected, in the order in which each reason first came up.
    struct Rejection {
        Words why;
        std::uint64_t count = 0;
    };
    const std::vector<Rejection>& rejections() const { return rejections_; }

    static constexpr std::uint64_t most_in_a_row = 20'000;

private:
    Variants(std::string text, std::string source, std::vector<Setting> set, Mechanism original, std::uint64_t seed,
             std::uint64_t size)
        : text_(std::move(text)),
          source_(std::move(source)),
          set_(std::move(set)),
          original_(std::move(original)),
          size_(size),
          order_(seed, size) {}
    /// One combination: a variant, or nothing where it is rejected.
    Result<std::optional<Variant>> drawn(std::uint64_t number, const IsReadable& is_readable);
    void reject(Words why);

    std::string text_, source_;
    std::vector<Setting> set_;
    Mechanism original_;
    std::uint64_t size_, looked_at_ = 0;
    Shuffle order_;
    std::unordered_set<std::string> drawn_;  ///< what the variants' files come to
    std::vector<Rejection> rejections_;
};

}  // namespace kinegraph
