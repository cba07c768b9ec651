// States of a cam file and of its whole turn.
#pragma once

#include <vector>

#include "app/library/state.hpp"
#include "engine/mechanism/cam.hpp"
#include "kinegraph/motion.hpp"

namespace kinegraph {

struct CamFile::State : Owned {
    explicit State(Cam read) : cam(std::move(read)) {}
    Cam cam;
    CamGeometry geometry;  ///< refers to the cam, which must not move
};

struct CamCycle::State : Owned {
    State(CamFile cam, long steps, double turn);

    const Cam& cam() const { return file.state().cam; }
    const CamGeometry& geometry() const { return file.state().geometry; }
    bool translates() const { return cam().follower.moves == Follower::Moves::translating; }
    bool is_flat() const { return cam().follower.face == Follower::Face::flat; }
    double speed(const CamState& state) const { return state.rise.first * rate; }
    double acceleration(const CamState& state) const { return state.rise.second * rate * rate; }
    std::vector<Words> facts() const;
    std::vector<Words> jumps() const;  ///< of the follower's speed

    CamFile file;
    double at = 0;                 ///< turn in the drawn position, rad
    double rate = 0;               ///< |ω| of the cam
    std::vector<CamState> states;  ///< by row
    CamSummary summary;
    long solved = 0, not_solved = 0;
    double difference = 0;  ///< of the solved mechanisms from the law, relative to the largest value
};

}  // namespace kinegraph
