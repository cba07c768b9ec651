// Load case: the bodies cut free under all loads, or under those of one body or pin alone (a part of a superposition).
// A view of the solution; computes nothing.
#pragma once

#include <string>

#include "engine/solution/forces.hpp"

namespace kinegraph {
struct Solution;
}

namespace kinegraph::render {

/// In place of the index of a part of the superposition: all loads act.
constexpr int all_loads = -1;

class LoadCase {
public:
    /// `part`: of the superposition, or all_loads.
    // NOLINTNEXTLINE(google-explicit-constructor): where a solution stands for its forces, all loads act
    LoadCase(const Solution& solution, int part = all_loads);

    const Solution& solution() const { return *solution_; }
    const std::vector<FreeBody>& bodies() const { return *bodies_; }
    const std::vector<TakenTogether>& together() const { return *together_; }
    int part() const { return part_; }
    bool is_alone() const { return part_ != all_loads; }
    /// Name of the body or the pin whose loads act alone: "3", "K". Empty: all loads act.
    const std::string& load() const { return load_; }

private:
    const Solution* solution_;
    const std::vector<FreeBody>* bodies_;
    const std::vector<TakenTogether>* together_;
    int part_;
    std::string load_;
};

/// Name of the body or the pin whose loads act: "3", "K".
const std::string& name_of(const Mechanism& mechanism, const Superposition::Part& part);
/// The number of loads that act alone; 0 without a superposition.
int parts_of(const Solution& solution);
/// The part of the superposition that a statement belongs to; all_loads if it refers to all.
int part_of(const Solution& solution, StatementIndex statement);
/// Bodies that are balanced together: "3 + 4"; of more than four only the first and the last.
std::string names_of(const Mechanism& mechanism, const TakenTogether& together);

}  // namespace kinegraph::render
