#include "constructions/kinematics/motion.hpp"

#include <algorithm>

#include "constructions/kinematics/chains.hpp"
#include "constructions/kinematics/recipes/introduction.hpp"
#include "constructions/kinematics/recipes/points.hpp"
#include "constructions/kinematics/recipes/spins.hpp"
#include "constructions/kinematics/recipes/trials.hpp"

namespace kinegraph {
namespace recipes {
namespace {

/// Recipes and state of one plane.
template <Plane plane>
struct InPlane {
    SpinRecipes<plane> spins;
    PointRecipes<plane> points;
    TrialRecipes<plane> trials;
};

class Recipes {
public:
    Recipes(Structure& structure, Board& board, const Plan& plan)
        : chains_(structure, board),
          board_(board),
          plan_(plan),
          pen_(chains_, board),
          introduction_(chains_, pen_),
          velocity_(in_plane<Plane::velocity>()),
          acceleration_(in_plane<Plane::acceleration>()) {}
    Recipes(const Recipes&) = delete;
    Recipes& operator=(const Recipes&) = delete;

    Motion run(bool with_accelerations) {
        draw(chains_.motion().velocity, "velocity");
        chains_.motion().velocities_settled = board_.strokes();
        if (with_accelerations) draw(chains_.motion().acceleration, "acceleration");
        return std::move(chains_.motion());
    }

    /// Velocities with all drivers at rest and one assumption at the value one.
    Track<Plane::velocity> response(std::size_t assumed) {
        pen_.take(RecipePen::Hand::silent);
        chains_.rest_drivers();
        velocity_.trials.move(&plan_.steps[assumed]);
        Track<Plane::velocity> track;
        start(track);
        for (const Step& step : plan_.steps) carry_out(track, step);
        return track;
    }

    bool is_broken(Track<Plane::velocity> response, const Closing& condition) {
        pen_.take(RecipePen::Hand::silent);
        chains_.rest_drivers();
        if (!condition.locus) return !board_.is_zero(velocity_.trials.mismatch_of_spins(response, condition));
        if (!chains_.ready(response, *condition.locus)) return false;
        const auto missed = velocity_.trials.miss(response, *condition.locus);
        return !board_.is_zero(missed) &&
               !board_.parallel(board_.direction(missed), chains_.diagram().direction(*condition.locus));
    }

private:
    template <Plane plane>
    void draw(Track<plane>& track, const char* id) {
        Polygon polygon;
        polygon.id = id;
        track.polygon = PolygonPen<plane>::begin(board_, std::move(polygon));
        start(track);
        for (const Step& step : plan_.steps) carry_out(track, step);
    }

    /// The frame is at rest.
    template <Plane plane>
    void start(Track<plane>& track) {
        track.tips.resize(chains_.structure().nodes().size());
        track.spins.resize(chains_.mechanism().bodies.size());
        track.spins[at(frame)] = board_.number(0);
        for (const NodeIndex index : chains_.structure().nodes_of(frame))
            pen_.set_tip(track, index, board_.pole<plane>(), false);
    }

    template <Plane plane>
    void carry_out(Track<plane>& track, const Step& step) {
        if constexpr (is_velocity<plane>) {
            for (const Locus* locus : {&step.first, &step.second}) introduction_.introduce(*locus);
            if (step.closing.locus) introduction_.introduce(*step.closing.locus);
        }
        switch (step.kind) {
            case Step::Kind::spin_by_joint: return of<plane>().spins.spin_by_joint(track, step);
            case Step::Kind::spin_by_driver: return of<plane>().spins.spin_by_driver(track, step);
            case Step::Kind::slide_by_driver: return of<plane>().points.slide_by_driver(track, step);
            case Step::Kind::image: return of<plane>().points.draw_image(track, step);
            case Step::Kind::roll: return of<plane>().points.draw_rolling_point(track, step);
            case Step::Kind::meet: return of<plane>().points.draw_meet(track, step);
            case Step::Kind::spin_from_pair: return of<plane>().spins.spin_from_pair(track, step);
            case Step::Kind::auxiliary: return of<plane>().points.draw_auxiliary(track, step);
            case Step::Kind::spin_from_parallels: return of<plane>().spins.spin_from_parallels(track, step);
            case Step::Kind::assume: return of<plane>().trials.assume(track, step);
        }
    }

    template <Plane plane>
    InPlane<plane> in_plane() {
        return {{chains_, board_, pen_},
                {chains_, board_, pen_},
                {chains_, board_, pen_, [this](Track<plane>& track, const Step& step) { carry_out(track, step); }}};
    }
    template <Plane plane>
    InPlane<plane>& of() {
        if constexpr (is_velocity<plane>)
            return velocity_;
        else
            return acceleration_;
    }

    Chains chains_;
    Board& board_;
    const Plan& plan_;
    RecipePen pen_;
    Introduction introduction_;
    InPlane<Plane::velocity> velocity_;
    InPlane<Plane::acceleration> acceleration_;
};

}  // namespace
}  // namespace recipes

LineReason along_guide(const Mechanism& mechanism, JointIndex index, bool perpendicular) {
    const Joint& joint = mechanism.joints[at_index(index)];
    if (joint.along) {
        if (const auto* between = std::get_if<Bearing::Between>(&joint.along->form)) {
            const auto& name = [&](PointIndex point) { return mechanism.points[at_index(point)].name; };
            return {perpendicular ? LineReason::Kind::perpendicular_to_segment : LineReason::Kind::parallel_to_segment,
                    name(between->from), name(between->to)};
        }
    }
    const JointName guide = reader_name(mechanism, joint);
    return {perpendicular ? LineReason::Kind::perpendicular_to_guide : LineReason::Kind::parallel_to_guide,
            guide.name,
            {},
            guide.own};
}

Motion draw_motion(Structure& structure, Board& board, const Plan& plan, bool with_accelerations) {
    return recipes::Recipes(structure, board, plan).run(with_accelerations);
}

Track<Plane::velocity> draw_response(Structure& structure, Board& board, const Plan& plan, std::size_t assumed) {
    return recipes::Recipes(structure, board, plan).response(assumed);
}

bool is_broken(Structure& structure, Board& board, const Track<Plane::velocity>& response, const Closing& condition) {
    return recipes::Recipes(structure, board, {}).is_broken(response, condition);
}

}  // namespace kinegraph
