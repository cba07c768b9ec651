// Displacements: a mechanism's virtual displacements and the efforts that follow from them. Each freedom is displaced
// separately, the other drivers are held fixed. Ideal pairs do no work, so for every freedom the work of loads,
// weights, inertia and efforts vanishes. Owns the results; the displacements are the velocities of a separate solution
// whose driver moves at rate one.
//
// Source: the principle of virtual work, e.g. Funaioli, Maggiore, Meneghetti, Lezioni di meccanica applicata alle
// macchine, vol. 1; with inertia, d’Alembert.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/equations/equations.hpp"
#include "engine/solution/forces.hpp"

namespace kinegraph {

struct Solution;

struct Displacements {
    /// One coordinate q with its virtual displacement δq.
    struct Freedom {
        Driver driver;        ///< the driver of this coordinate, at rate one
        bool chosen = false;  ///< not a driver of the file: chosen as coordinate of a free mechanism
        /// Its velocities are displacements per rad or m of δq, its powers are works (N m/rad or N).
        /// VirtualWork::shares contains the efforts.
        std::shared_ptr<const Solution> moved;
        /// The equations of the same; their rates are the velocity ratios Λ = d/dq. `why_not` is not empty where there
        /// are none.
        std::shared_ptr<const Equations> equations;
    };
    /// An effort, N or N m.
    struct Effort {
        int given = -1;               ///< index in Mechanism::efforts
        std::optional<Exact> value;   ///< by the displacements drawn; none where undetermined
        std::optional<double> ratio;  ///< by the velocity ratios of the equations
    };
    Words why_not;  ///< not empty: there are no displacements, for this reason
    std::vector<Freedom> freedoms;
    std::vector<Effort> efforts;  ///< all of the mechanism, or none
    bool balanced = true;         ///< false: no efforts make all works vanish

    /// The value of an effort of the mechanism.
    Recorded<Exact> found(std::size_t given) const {
        if (given >= efforts.size() || !efforts[given].value) return {};
        return *efforts[given].value;
    }
};

/// The works: one equation for each freedom, linear in the efforts.
struct WorkEquations {
    std::vector<std::vector<Exact>>
        rows;  ///< by freedom: the work of one unit of each effort, then minus the work of given actions
    std::vector<double> largest;  ///< by freedom: upper bound on the work of given actions, a reference magnitude

    struct Found {
        std::vector<std::optional<Exact>> efforts;  ///< none: undetermined
        bool balanced = true;                       ///< false: no efforts make all works vanish
    };
    Found solved(std::size_t efforts) &&;
};

/// "theta 2", "theta 3 on 2", "s D": the coordinate of a driver.
std::string coordinate_name(const Mechanism& mechanism, const Driver& driver);
/// Whether it is an angle.
bool is_turn(const Driver& driver);
/// Work per unit of δq from velocity ratios: of an entry, or of one unit of an effort; none where the equations do not
/// give it.
std::optional<double> work_by_ratios(const Equations& equations, const VirtualWork::Entry& entry);
std::optional<double> work_by_ratios(const Equations& equations, const Mechanism& mechanism, const Pose& pose,
                                     int effort);

/// The efforts of a solution, in the mechanism's order: from its reactions, else from virtual work; without a value
/// where neither finds it. Empty where neither was requested.
std::vector<EffortValue> efforts_found(const Solution& solution);

}  // namespace kinegraph
