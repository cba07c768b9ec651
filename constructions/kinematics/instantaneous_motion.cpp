#include "constructions/kinematics/instantaneous_motion.hpp"

#include <utility>

#include "constructions/kinematics/instantaneous/centre.hpp"
#include "constructions/kinematics/instantaneous/settling.hpp"
#include "engine/number/assert.hpp"
#include "lang/keys/phrases.hpp"
#include "lang/keys/sentences.hpp"

namespace kinegraph {
namespace act {
namespace {

class FoundInstantaneousMotion {
public:
    FoundInstantaneousMotion(Structure& structure, Board& board, const InstantaneousMotionWishes& wishes)
        : act_(structure, board, wishes), board_(board), centre_(act_) {}

    InstantaneousMotionResult run() {
        State<Plane::velocity> velocities(act_.result.motion.velocity);
        begin_polygon(velocities, act_.mechanism.motion->velocities);
        Settling<Plane::velocity>(act_).settle(velocities);
        if (!velocities.contradicted) {
            centre_.locate_centre(velocities);
            draw_images(velocities);
            explain(velocities);
        } else if (act_.wishes.centre) {
            act_.unsolved(act_.sought_centre(), {lang::phrases::velocities_contradict, {}});
        }
        if (act_.wishes.accelerations) draw_accelerations(velocities);
        return std::move(act_.result);
    }

private:
    template <Plane plane>
    void begin_polygon(State<plane>& state, const std::vector<GivenMotion>& list) {
        state.track.tips.resize(act_.structure.nodes().size());
        state.track.spins.resize(act_.mechanism.bodies.size());
        Polygon polygon;
        polygon.id = is_velocity<plane> ? "velocity" : "acceleration";
        state.track.polygon = PolygonPen<plane>::begin(board_, std::move(polygon));
        state.track.spins[at(frame)] = board_.number(0);
        for (const NodeIndex index : act_.structure.nodes_of(frame)) {
            state.track.tips[at(index)] = board_.pole<plane>();
            act_.label_image(state, act_.node(index).label, board_.pole<plane>());
        }
        for (const GivenMotion& each : list) {
            Given<plane> given;
            given.node = act_.structure.find(each.point, act_.body_index);
            KG_ASSERT(given.node != none, "the body carries the points of its instantaneous motion");
            given.whole = std::holds_alternative<Vector>(each.value);
            const auto index = static_cast<int>(state.given.size());
            if constexpr (is_velocity<plane>) {
                given.vector = board_.act_velocity(index);
            } else {
                given.vector = board_.act_acceleration(index);
            }
            state.given.push_back(given);
        }
        state.used.assign(state.given.size(), false);
    }

    template <Plane plane>
    void draw_images(State<plane>& state) {
        if (!state.base || !act_.turns(state)) return;
        for (const NodeIndex index : act_.structure.nodes_of(act_.body_index)) {
            if (state.track.has(index)) continue;
            say_image(state, index);
            act_.set_tip(state, index, act_.image_of(state, act_.place(index)));
        }
    }

    template <Plane plane>
    void say_image(const State<plane>& state, NodeIndex index) {
        if constexpr (is_velocity<plane>) {
            if (act_.result.figure.found == InstantaneousMotionFigure::Found::rest) return;
            if (board_.is_zero(state.track.spin(act_.body_index))) {
                act_.begin<plane>(lang::sentences::translating_velocity,
                                  {act_.body(), act_.name(index), act_.absolute<plane>(index)});
            } else if (act_.centre) {
                act_.begin<plane>(
                    lang::sentences::act_velocity,
                    {act_.absolute<plane>(index), act_.name(index), act_.symbol_of_centre(), act_.spin<plane>()},
                    "Rivals");
            } else {
                act_.begin<plane>(lang::sentences::image_velocity,
                                  {act_.name(index), act_.body(), act_.absolute<plane>(index),
                                   PointName{state.base->label}, act_.spin<Plane::velocity>()},
                                  "Rivals");
            }
        } else {
            act_.begin<plane>(lang::sentences::image_acceleration,
                              {act_.name(index), act_.body(), act_.absolute<plane>(index), PointName{state.base->label},
                               act_.spin<Plane::velocity>(), act_.spin<plane>()},
                              "Rivals");
        }
    }

    /// What the velocities do not determine, and which data would.
    void explain(State<Plane::velocity>& state) {
        const Message what = act_.sought<Plane::velocity>();
        const bool located =
            act_.centre.has_value() || act_.result.figure.found == InstantaneousMotionFigure::Found::rest;
        if (state.base && act_.turns(state)) return;
        if (act_.wishes.centre && !located) {
            if (state.given.empty()) {
                act_.unsolved(act_.sought_centre(), {lang::phrases::no_velocity_given, {}});
            } else {
                act_.unsolved(act_.sought_centre(),
                              {lang::phrases::centre_on_perpendicular, {act_.name(state.given.front().node)}});
            }
        }
        if (!act_.wishes.velocities) return;
        if (located && act_.turns(state)) {
            act_.unsolved(what, {lang::phrases::speed_of_translation_open, {}});
        } else if (located) {
            // A point of the file at the centre has zero velocity.
            for (const NodeIndex index : act_.structure.nodes_of(act_.body_index)) {
                if (!state.track.has(index) && board_.coincide(act_.place(index), *act_.centre))
                    act_.set_tip(state, index, board_.pole<Plane::velocity>());
            }
            act_.unsolved(what, {lang::phrases::size_open, {}});
        } else if (state.given.empty()) {
            act_.unsolved(what, {lang::phrases::no_velocity_given, {}});
        } else {
            act_.unsolved(what, {lang::phrases::turning_open, {}});
        }
    }

    void draw_accelerations(const State<Plane::velocity>& velocities) {
        const Message what = act_.sought<Plane::acceleration>();
        if (velocities.contradicted) return act_.unsolved(what, {lang::phrases::velocities_contradict, {}});
        if (!act_.turns(velocities)) return act_.unsolved(what, {lang::phrases::omega_unknown, {}});
        if (act_.mechanism.motion->accelerations.empty())
            return act_.unsolved(what, {lang::phrases::no_acceleration_given, {}});
        State<Plane::acceleration> state(act_.result.motion.acceleration);
        begin_polygon(state, act_.mechanism.motion->accelerations);
        Settling<Plane::acceleration>(act_).settle(state);
        if (state.contradicted) return;
        draw_images(state);
        if (!state.base || !act_.turns(state)) {
            act_.unsolved(what, {lang::phrases::acceleration_open, {}});
            return;
        }
        centre_.locate_acceleration_centre(state);
    }

    InstantaneousMotionDraft act_;
    Board& board_;
    Centre centre_;
};

}  // namespace
}  // namespace act

InstantaneousMotionResult draw_instantaneous_motion(Structure& structure, Board& board,
                                                    const InstantaneousMotionWishes& wishes) {
    return act::FoundInstantaneousMotion(structure, board, wishes).run();
}

}  // namespace kinegraph
