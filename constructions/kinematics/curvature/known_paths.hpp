// Paths whose centres of curvature are known before the body's own motion: of pins on bodies solved earlier, and by
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
    std::string label, centre_name;  ///< `centre_name` is empty if the centre is at infinity
    Place place, centre;
};

class KnownPaths {
public:
    explicit KnownPaths(CurvatureDraft& draft) : draft_(draft), board_(draft.board) {}

    std::vector<KnownPath> of(BodyIndex body);
    /// The path of one point, if a guide or slot of the frame, or a pin of another body, gives it.
    std::optional<KnownPath> of_point(NodeIndex node, BodyIndex body);

private:
    KnownPath straight_path(PointIndex point, DirectionHandle along);
    std::optional<KnownPath> by_pin(NodeIndex node, BodyIndex body);
    std::optional<KnownPath> by_frame(const Passage& passage);

    CurvatureDraft& draft_;
    Board& board_;
};

}  // namespace kinegraph::curvature
