#include "constructions/kinematics/curvature.hpp"

#include <algorithm>

#include "constructions/kinematics/curvature/draft.hpp"
#include "constructions/kinematics/curvature/inflection_circle.hpp"
#include "constructions/kinematics/curvature/known_paths.hpp"
#include "constructions/kinematics/curvature/path_centres.hpp"
#include "constructions/kinematics/curvature/simple_bodies.hpp"

namespace kinegraph {

std::vector<Curvature> draw_curvature(Structure& structure, Board& board, const Motion& motion) {
    curvature::CurvatureDraft draft(structure, board, motion);
    curvature::KnownPaths known(draft);
    curvature::SimpleBodies simple(draft);
    curvature::InflectionCircle circle(draft, known, simple);
    curvature::PathCentres centres(draft, known);
    std::vector<BodyIndex> open;
    for (const BodyIndex body : draft.mechanism.moving_bodies())
        if (draft.is_known(body) && !simple.settle(body)) open.push_back(body);
    // A body with two known paths gives the paths of its pins. If there is no such body, accelerations are used.
    while (!open.empty()) {
        const auto next =
            std::find_if(open.begin(), open.end(), [&](BodyIndex body) { return circle.by_known_paths(body); });
        const BodyIndex body = next == open.end() ? open.front() : *next;
        if (next == open.end()) circle.by_acceleration(body);
        draft.of(body).solved = true;
        if (draft.of(body).inflection_pole) centres.draw(body);
        open.erase(std::find(open.begin(), open.end(), body));
    }
    return draft.take_results();
}

}  // namespace kinegraph
