// Paths whose centres of curvature are known before the body's own motion is: by pins of bodies solved before, by
// guides and slots of the frame.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "constructions/kinematics/curvature/draft.hpp"

namespace kinegraph::curvature {

/// A moving point of a body and the centre of curvature of its path; the pole lies on the line through both.
struct KnownPath {
    PointIndex point = none;
    std::string label, centre_name;  ///< no centre's name where it lies at infinity
    Place place, centre;
};

class KnownPaths {
public:
    explicit KnownPaths(CurvatureDraft& draft) : draft_(draft), board_(draft.board) {}

    std::vector<KnownPath> of(BodyIndex body);
    /// Of one point, what a ray of the body or another body's pin says already.
    std::optional<KnownPath> of_point(NodeIndex node, BodyIndex body);

private:
    KnownPath straight_path(PointIndex point, DirectionHandle along);
    std::optional<KnownPath> by_pin(NodeIndex node, BodyIndex body);
    std::optional<KnownPath> by_frame(const Passage& passage);

    CurvatureDraft& draft_;
    Board& board_;
};

}  // namespace kinegraph::curvature
