/// \file
/// Variants of an exercise: the same problem with other numbers, for each student one.
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

/// One exercise of many.
struct ExerciseVariant {
    std::vector<ParameterValue> values;  ///< of the parameters that vary, in the file's order
    Solved solved;                       ///< its solution; draw() makes question and solution of it
    std::vector<ResultValue> asked;      ///< what it asks for; where it asks for nothing, what a reader would ask for
    std::string file;                    ///< the mechanism file of this variant alone
};

/// The variants of a file with "vary", in the order that a seed gives them. The n-th variant is the same whatever
/// number is wanted, no two are the same mechanism, and each fulfils the file's conditions ("require"). One thread at a
/// time may use an object; several objects of one file and seed give the same variants.
class ExerciseVariants {
public:
    /// Reads the file. `options` say on which paper a condition on readable polygons must hold. Fails with the faults
    /// of the file, and where it varies nothing.
    static Expected<ExerciseVariants> parse(std::string_view text, std::string name, std::uint64_t seed,
                                            const std::vector<ParameterValue>& set = {},
                                            const DrawingOptions& options = {});
    /// Moves; what was moved from may only be destroyed or assigned to.
    ExerciseVariants(ExerciseVariants&&) noexcept;
    /// Moves, as the constructor does.
    ExerciseVariants& operator=(ExerciseVariants&&) noexcept;
    ~ExerciseVariants();

    /// The next variant; none where all combinations have been looked at, or 20,000 in a row failed. Fails where the
    /// file asks for, or compares, what is not there.
    Expected<std::optional<ExerciseVariant>> next();
    /// How many combinations the file has.
    std::uint64_t combinations() const;
    /// How many of them have been looked at.
    std::uint64_t looked_at() const;

private:
    struct State;
    explicit ExerciseVariants(State* state) : state_(state) {}
    State* state_;  ///< owned; null where it was moved away
};

}  // namespace kinegraph
