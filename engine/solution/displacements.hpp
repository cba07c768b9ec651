// Displacements: what a mechanism's virtual displacements say of its efforts. Each freedom is displaced by itself, the
// rest of the drivers held still; ideal pairs do no work, so for every freedom the work of loads, weights, inertia and
// efforts vanishes. Holds what was found; the displacements are the velocities of a solution of their own, whose driver
// moves at the rate one.
//
// Source: the principle of virtual work as courses on machines have it, e.g. Funaioli, Maggiore, Meneghetti, Lezioni di
// meccanica applicata alle macchine, vol. 1; with inertia, d’Alembert.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/equations/equations.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {

struct Displacements {
    /// One coordinate q displaced by δq.
    struct Freedom {
        Driver driver;        ///< whose coordinate it is; its rate is one
        bool chosen = false;  ///< no driver of the file: the mechanism's own freedom
        /// Its velocities are displacements for each rad or m of δq, its powers works for each (N m/rad or N).
        /// VirtualWork::shares has the efforts.
        std::shared_ptr<const Solution> moved;
        /// Of the same: their rates are the velocity ratios Λ = d/dq. `why_not` is not empty where there are none.
        std::shared_ptr<const Equations> equations;
    };
    /// An effort, N or N m.
    struct Effort {
        int given = -1;               ///< index in Mechanism::efforts
        std::optional<Exact> value;   ///< by the displacements drawn; none where they leave it open
        std::optional<double> ratio;  ///< by the velocity ratios of the equations
    };
    Words why_not;  ///< not empty: there are none, and this is the reason
    std::vector<Freedom> freedoms;
    std::vector<Effort> efforts;
    bool balanced = true;  ///< false: no efforts make all works vanish
};

/// The works, one equation for each freedom, linear in the efforts.
struct WorkEquations {
    std::vector<std::vector<Exact>>
        rows;  ///< of each freedom: the work of one unit of each effort, then minus that of what is given
    std::vector<double> largest;  ///< by freedom: the largest work that what is given could do

    struct Found {
        std::vector<std::optional<Exact>> efforts;  ///< none: left open
        bool balanced = true;                       ///< false: no efforts make all works vanish
    };
    Found solved(std::size_t efforts) &&;
};

/// "theta 2", "theta 3 on 2", "s D": the coordinate of a driver.
std::string coordinate_name(const Mechanism& mechanism, const Driver& driver);
/// Whether it is an angle.
bool is_turn(const Driver& driver);
/// Work for each unit of δq by velocity ratios: of an entry, of one unit of an effort; none where the equations do not
/// say.
std::optional<double> work_by_ratios(const Equations& equations, const VirtualWork::Entry& entry);
std::optional<double> work_by_ratios(const Equations& equations, const Mechanism& mechanism, const Pose& pose,
                                     int effort);

/// The efforts of a solution, those of the mechanism's in order: by its reactions, else by virtual work; without a
/// value where neither finds it. Empty where neither was asked for.
std::vector<EffortValue> efforts_found(const Solution& solution);

/// The value of "virtual work" in the results file (docs/results.md).
std::string displacements_json(const Mechanism& mechanism, const Displacements& displacements);

}  // namespace kinegraph
