// Loads of a structure, and velocities of an instantaneous motion, turned and of other sizes: the changes under which
// its construction may be another one. Solves nothing.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "engine/board/replay.hpp"
#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "engine/solution/moving.hpp"

namespace kinegraph {

class TurnedLoads {
public:
    /// Keeps references to all.
    TurnedLoads(const Mechanism& mechanism, const Pose& pose, const std::vector<MovingSetting>& settings);

    /// A program that was found for some change.
    void add(const Program& program);
    /// Calls `plan` with the mechanism under each change for which no program holds; it may add one. Ends where it
    /// returns false, and where as many strokes were carried out or changes without a program found as is the limit.
    void each_unplanned(const std::function<bool(const Mechanism&)>& plan);

private:
    /// How a load differs from the one in the file.
    struct Change {
        int quarters = 0;  ///< exact quarter turns: lines that are parallel stay so
        double more = 0;   ///< rad, after these
        double size = 1;   ///< a factor
    };
    struct Known {
        Program program;
        Replay replay;
    };
    void change(std::size_t setting, const Change& by);
    void restore(std::size_t setting);
    void give(std::size_t setting);
    bool is_planned();
    bool look_at(const std::function<bool(const Mechanism&)>& plan);

    const Mechanism& mechanism_;
    const Pose& pose_;
    const std::vector<MovingSetting>& settings_;
    Mechanism changed_;
    std::vector<Known> known_;
    std::size_t strokes_ = 0, unplanned_ = 0;
};

}  // namespace kinegraph
