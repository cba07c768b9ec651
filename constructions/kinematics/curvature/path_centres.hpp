// Results of the pole and inflection circle: the acceleration pole (Bresse), the centres of curvature of points' paths
// (Euler–Savary) and of straight lines' envelopes.
#pragma once

#include "constructions/kinematics/curvature/draft.hpp"
#include "constructions/kinematics/curvature/known_paths.hpp"

namespace kinegraph::curvature {

class PathCentres {
public:
    PathCentres(CurvatureDraft& draft, KnownPaths& known) : draft_(draft), board_(draft.board), known_(known) {}

    /// For a body that has an inflection circle.
    void draw(BodyIndex body);

private:
    using State = CurvatureDraft::State;
    void draw_acceleration_pole(BodyIndex body);
    void draw_path(BodyIndex body, NodeIndex node);
    void draw_envelopes(BodyIndex body);

    CurvatureDraft& draft_;
    Board& board_;
    KnownPaths& known_;
};

}  // namespace kinegraph::curvature
