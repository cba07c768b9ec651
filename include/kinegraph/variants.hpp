/// \file
/// Variants of an exercise: the same problem with different numbers, for example one for each student.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <kinegraph/error.hpp>
#include <kinegraph/mechanism.hpp>
#include <kinegraph/sheet.hpp>

namespace kinegraph {

/// One variant of an exercise.
struct ExerciseVariant {
    std::vector<ParameterValue> values;  ///< parameters that vary, in the file's order
    Solved solved;                   ///< its solution; draw() makes both the question and the solution sheet from it
    std::vector<ResultValue> asked;  ///< the results in "ask"; if the file has none, a default choice
    std::string file;                ///< the mechanism file of this variant alone
};

/// The variants of a file with "vary", in an order that depends on the seed only. The n-th variant does not depend on
/// how many are requested. No two variants are the same mechanism, and each fulfils the file's conditions ("require").
/// An object may be used by one thread at a time. Several objects with the same file and seed give the same variants.
class ExerciseVariants {
public:
    /// Reads the file. `options` give the paper on which a condition on readable polygons must hold. Fails with the
    /// faults of the file, and if no parameter varies.
    static Expected<ExerciseVariants> parse(std::string_view text, std::string name, std::uint64_t seed,
                                            const std::vector<ParameterValue>& set = {},
                                            const DrawingOptions& options = {});
    /// Moves; a moved-from object may only be destroyed or assigned to.
    ExerciseVariants(ExerciseVariants&&) noexcept;
    /// Moves, as the constructor does.
    ExerciseVariants& operator=(ExerciseVariants&&) noexcept;
    ~ExerciseVariants();

    /// The next variant; none if all combinations have been tried, or 20,000 in a row were rejected. Fails if the file
    /// asks for or compares a result that does not exist.
    Expected<std::optional<ExerciseVariant>> next();
    /// Number of combinations in the file.
    std::uint64_t combinations() const;
    /// Number of combinations tried so far.
    std::uint64_t looked_at() const;

private:
    struct State;
    explicit ExerciseVariants(State* state) : state_(state) {}
    State* state_;  ///< owned; null after a move
};

}  // namespace kinegraph
