// The kinds of problems that a file may state in place of joints, as a table: reading, solving and results of each. The
// kinds are defined in the folders of problems/; app/library lists them, with their sheets.
#pragma once

#include <any>
#include <span>
#include <string>
#include <string_view>

#include "engine/drawing/pose.hpp"
#include "engine/file/json_source.hpp"
#include "engine/solution/problem_solution.hpp"

namespace kinegraph {

class JsonWriter;
struct Solution;
class FormReader;
struct FormValue;

struct ProblemKind {
    std::string_view key;                ///< of its section in a file, and of its results in the results file
    const FormValue* section = nullptr;  ///< what stands at the key

    /// Whether the value at the key states this problem; null: every value does. The section may be absent.
    bool (*is_stated_by)(JsonValue section) = nullptr;
    /// The data of the section; empty where it is unreadable. Adds its bodies to the mechanism.
    std::any (*read)(FormReader& file, Mechanism& mechanism, JsonValue section) = nullptr;

    /// Errors: values impossible for the problem, with their place; bodies that do not interact.
    Result<ProblemSolution> (*solve)(const Problem& problem, const Mechanism& mechanism, const Pose& pose) = nullptr;
    /// Adds the problems of this kind at the joints of a mechanism whose forces are found; null: there are none.
    void (*add_at_joints)(Solution& solution) = nullptr;

    /// Writes the value of `key` in the results file (docs/results.md); `exact` adds fractions.
    void (*results)(const Solution& solution, bool exact, JsonWriter& json) = nullptr;

    /// For the title block: how many bodies or points it is about, and the units that stand beside that of length.
    struct TitleBlock {
        int count = 2;
        bool of_points = false;
        bool has_forces = true;
        bool has_time = false;
    } title_block{};
};

/// The kinds in the order of app/library/problem_kinds.cpp, which defines this function.
std::span<const ProblemKind* const> problem_kinds();

}  // namespace kinegraph
