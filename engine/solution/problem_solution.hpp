// Results of a problem without joints (engine/mechanism/problem.hpp), and of contacts at joints, as values in SI units.
#pragma once

#include <any>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/file/error.hpp"
#include "engine/file/units.hpp"
#include "engine/mechanism/problem.hpp"

namespace kinegraph {

/// One scalar result, for tables, results and checks.
struct ProblemValue {
    std::string key;     ///< in the results file and its checks, and for `ask`: "half width", "velocity 1 x"
    Words name;          ///< for readers
    std::string symbol;  ///< "p_0", "σ_z": a letter and its subscript
    QuantityKind kind = QuantityKind::dimensionless;
    double value = 0;                ///< SI
    std::optional<double> numeric;   ///< by the check
    bool in_file = true;             ///< false: the results file has a special form for it
    std::string unit{};              ///< SI unit of a value without a kind: "N s", "J"
    std::optional<Unit> shown_in{};  ///< of such a value: the unit for readers, where it is not the SI unit
};

struct ProblemSolution {
    Words subject;  ///< subject of the sheet, for its title block
    std::any of;    ///< what the kind of the problem found
    std::vector<ProblemValue> values;
    std::vector<Words> remarks;

    /// Precondition: the problem is of the kind that finds this.
    template <class Found>
    const Found& as() const {
        return std::any_cast<const Found&>(of);
    }
};

/// The contact at one joint: its problem, and the solution.
struct SolvedContact {
    JointIndex joint = none;
    double load = 0;  ///< normal force, N
    std::shared_ptr<const Problem> stated;
    std::shared_ptr<const ProblemSolution> found;
};
struct SolvedContacts {
    const ProblemKind* kind = nullptr;  ///< of the problem at each joint
    std::vector<SolvedContact> at_joints;
    std::vector<Words> remarks;  ///< on these, and on contacts that have no solution
};

/// Values that differ from the check by more than 1e-6 of the largest of their kind and unit, a remark for each.
std::vector<Words> remarks_on_check(const std::vector<ProblemValue>& values);

/// The error if a result or its check is not a finite number because the data differ too much in size. `where`: the
/// problem's place.
std::optional<Errors> why_no_numbers(const std::vector<ProblemValue>& values, const std::string& where);

}  // namespace kinegraph
