// Bodies whose curvature is seen without pole tangent: at rest, in translation, turning about a place that stays.
#pragma once

#include <string>

#include "constructions/kinematics/curvature/draft.hpp"

namespace kinegraph::curvature {

class SimpleBodies {
public:
    explicit SimpleBodies(CurvatureDraft& draft) : draft_(draft), board_(draft.board) {}

    /// Rest, translation, and turning about a hinge of the frame. False: the body is none of these.
    bool settle(BodyIndex body);
    /// `name_of_pole` in the sentence; `centre`: the pole's name where the file has one.
    void turn_about(BodyIndex body, Place pole, Argument name_of_pole, const std::string& centre);

private:
    void translate(BodyIndex body, NodeIndex base);

    CurvatureDraft& draft_;
    Board& board_;
};

}  // namespace kinegraph::curvature
