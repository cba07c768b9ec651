// Bodies whose curvature needs no pole tangent: at rest, in translation, or turning about a fixed place.
#pragma once

#include <string>

#include "constructions/kinematics/curvature/draft.hpp"

namespace kinegraph::curvature {

class SimpleBodies {
public:
    explicit SimpleBodies(CurvatureDraft& draft) : draft_(draft), board_(draft.board) {}

    /// Handles rest, translation, and rotation about a hinge of the frame. False: none of these.
    bool settle(BodyIndex body);
    /// `name_of_pole` is for the sentence; `centre` is the pole's name in the file, or empty.
    void turn_about(BodyIndex body, Place pole, Argument name_of_pole, const std::string& centre);

private:
    void translate(BodyIndex body, NodeIndex base);

    CurvatureDraft& draft_;
    Board& board_;
};

}  // namespace kinegraph::curvature
