// Rules by which the givens of a program depend on the position; and the givens that the user may change: rates of
// drivers and sizes of loads.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/board/program.hpp"
#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "engine/solution/moving.hpp"

namespace kinegraph {

/// Name of the body that turns, the joint that slides, or the point that is driven.
std::string name_of_course(const Mechanism& mechanism, const Driver& driver);

class MovingRules {
public:
    /// Keeps references to both.
    MovingRules(const Mechanism& mechanism, const Pose& pose);

    /// Rates of drivers without a law, sizes of loads, velocities of a given instantaneous motion; no zeros.
    const std::vector<MovingSetting>& settings() const { return settings_; }
    /// The rule of a given with this index; none if it is the same in every position.
    std::optional<MovingGiven> of(const Given& given, int index) const;

private:
    std::optional<MovingGiven> of_driver(MovingGiven rule, bool is_velocity) const;
    std::optional<MovingGiven> of_load(MovingGiven rule, Given::Kind kind, const Load& load) const;
    std::optional<MovingGiven> setting(MovingGiven rule, MovingSetting::Kind kind) const;
    double push_of(std::size_t joint) const;

    const Mechanism& mechanism_;
    const Pose& pose_;
    std::vector<MovingSetting> settings_;
};

}  // namespace kinegraph
