// Variants of an exercise: tries combinations of its parameter values, solves each, and keeps it if its conditions
// hold. Conditions on the drawing are evaluated by a function of the caller.
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
#include "engine/solution/solution.hpp"

namespace kinegraph {

/// One variant of an exercise.
struct Variant {
    std::vector<Setting> values;  ///< of the parameters that vary, in the file's order
    Solution solution;
    std::vector<NamedResult>
        results;  ///< requested; by default input forces and couples, else angular velocities, else all
};

/// Whether every vector sought in a polygon is long enough on paper to be read.
using IsReadable = std::function<bool(const Solution&, Condition::Polygon)>;

/// The variants of a file, in an order that depends on the seed only. The n-th variant is the n-th combination of the
/// shuffled lattice that fulfils the conditions and differs from all earlier mechanisms. Each combination is tried
/// once.
class Variants {
public:
    /// `source` is the name of `text` in messages; `set` overrides parameters of the file. Errors: the file's faults;
    /// no parameter varies.
    static Result<Variants> of(std::string text, std::string source, std::vector<Setting> set, std::uint64_t seed);

    /// The next variant; none if all combinations have been tried, `most_in_a_row` were rejected one after the other,
    /// or `stops`, called before each, returns true. Errors: the file asks for or compares a result that does not
    /// exist.
    Result<std::optional<Variant>> next(const IsReadable& is_readable, const std::function<bool()>& stops = {});

    std::uint64_t combinations() const { return size_; }
    std::uint64_t looked_at() const { return looked_at_; }
    bool is_exhausted() const { return looked_at_ == size_; }
    const Mechanism& original() const { return original_; }

    /// Why combinations were rejected, in order of first occurrence.
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
    /// Tries one combination; none if it is rejected.
    Result<std::optional<Variant>> drawn(std::uint64_t number, const IsReadable& is_readable);
    void reject(Words why);

    std::string text_, source_;
    std::vector<Setting> set_;
    Mechanism original_;
    std::uint64_t size_, looked_at_ = 0;
    Shuffle order_;
    std::unordered_set<std::string> drawn_;  ///< the canonical text of each variant's file
    std::vector<Rejection> rejections_;
};

}  // namespace kinegraph
