#include "constructions/solving/missing_motion.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>

#include "constructions/kinematics/degeneracy.hpp"
#include "engine/board/board.hpp"
#include "engine/solution/solution.hpp"
#include "lang/keys/phrases.hpp"

namespace kinegraph {
namespace {

BodyName named_body(const Mechanism& mechanism, BodyIndex body) { return {mechanism.body(body).name}; }

/// Whether the drivers that determine nothing new agree with the motion.
class IdleDrivers {
public:
    explicit IdleDrivers(const DrawnMotion& drawn)
        : solution_(drawn.solution),
          mechanism_(drawn.solution.mechanism),
          structure_(drawn.structure),
          board_(drawn.board),
          motion_(drawn.motion),
          accelerations_(drawn.accelerations) {}

    void compare(int driver) {
        const Message what = std::visit(
            [&](const auto& given) -> Message {
                if constexpr (requires { given.joint; }) {
                    return {lang::phrases::drive_of_joint, {file_name(mechanism_.joints[at_index(given.joint)])}};
                } else {
                    return {lang::phrases::drive_of_body, {named_body(mechanism_, given.body)}};
                }
            },
            mechanism_.drivers[at_index(driver)]);
        const bool agrees = std::visit([&](const auto& given) { return asks_the_same(given, driver); },
                                       mechanism_.drivers[at_index(driver)]);
        if (!agrees) solution_.unsolved.push_back({what, {idle_reason(), {}}});
    }

private:
    bool asks_the_same(const SpinDriver& spin, int driver) {
        const auto same = [&](const auto& track, ScalarHandle asked) {
            if (!track.turns(spin.body) || !track.turns(spin.relative_to)) return board_.is_zero(asked);
            const ScalarHandle found = board_.difference(track.spin(spin.body), track.spin(spin.relative_to));
            return board_.is_zero(board_.difference(found, asked));
        };
        return same(motion_.velocity, board_.driver_velocity(driver)) &&
               (!accelerations_ || same(motion_.acceleration, board_.driver_acceleration(driver)));
    }

    bool asks_the_same(const SlideDriver& slide, int driver) {
        const Joint& joint = mechanism_.joints[at_index(slide.joint)];
        const NodeIndex slider = structure_.find(joint.point, joint.bodies[0]),
                        guide = structure_.find(joint.point, joint.bodies[1]);
        const auto& v = motion_.velocity;
        const auto& a = motion_.acceleration;
        if (slider == none || guide == none || !v.has(slider) || !v.has(guide))
            return board_.is_zero(board_.driver_velocity(driver)) && board_.is_zero(board_.driver_acceleration(driver));
        const DirectionHandle along = board_.guide_unit(slide.joint);
        const auto velocity = board_.vector(v.tip(guide), v.tip(slider));
        if (!board_.is_zero(
                board_.subtract(velocity, board_.scale<Plane::velocity>(board_.driver_velocity(driver), along))))
            return false;
        if (!accelerations_ || !a.has(slider) || !a.has(guide) || !v.turns(joint.bodies[1])) return true;
        const auto coriolis = board_.scale<Plane::acceleration>(
            board_.product(board_.number(2), v.spin(joint.bodies[1])), board_.turn(velocity));
        const auto relative = board_.subtract(board_.vector(a.tip(guide), a.tip(slider)), coriolis);
        return board_.is_zero(
            board_.subtract(relative, board_.scale<Plane::acceleration>(board_.driver_acceleration(driver), along)));
    }

    bool asks_the_same(const PointDriver& point, int driver) {
        const NodeIndex node = structure_.find(point.at, point.body);
        const auto same = [&]<Plane plane>(const Track<plane>& track, ScalarHandle asked) {
            if (node == none || !track.has(node)) return board_.is_zero(asked);
            const DirectionHandle along = board_.driver_unit(driver);
            const auto rest = board_.subtract(board_.vector(board_.pole<plane>(), track.tip(node)),
                                              board_.scale<plane>(asked, along));
            return board_.is_zero(rest) || board_.parallel(board_.direction(rest), board_.perpendicular(along));
        };
        return same(motion_.velocity, board_.driver_velocity(driver)) &&
               (!accelerations_ || same(motion_.acceleration, board_.driver_acceleration(driver)));
    }

    Key idle_reason() const {
        if (solution_.mobility.effective == 0) return lang::phrases::locked;
        return solution_.mobility.driven < solution_.mobility.effective ? lang::phrases::undrivable
                                                                        : lang::phrases::driven_otherwise;
    }

    Solution& solution_;
    const Mechanism& mechanism_;
    const Structure& structure_;
    Board& board_;
    const Motion& motion_;
    bool accelerations_;
};

/// Bodies whose motion or curvature is not found, each with its reason.
class MissingMotion {
public:
    explicit MissingMotion(const DrawnMotion& drawn)
        : solution_(drawn.solution),
          mechanism_(drawn.solution.mechanism),
          structure_(drawn.structure),
          plan_(drawn.plan),
          motion_(drawn.motion),
          accelerations_(drawn.accelerations),
          mistakes_(drawn.mistakes) {}

    void explain_missing_motion() {
        for (const Contradiction& contradiction : motion_.contradictions) {
            const auto label = [&](NodeIndex node) { return PointName{structure_.node(node).label}; };
            unsolved({lang::phrases::velocity_of_body, {named(contradiction.body)}},
                     {lang::phrases::no_rigid_motion, {label(contradiction.first), label(contradiction.second)}});
        }
        for (const BodyIndex body : mechanism_.moving_bodies()) {
            if (!reached(body)) {
                unsolved({lang::phrases::motion_of_body, {named(body)}}, reason_for(body));
            } else if (accelerations_ && !wholly_accelerated(body)) {
                unsolved({lang::phrases::acceleration_of_body, {named(body)}}, missing_acceleration());
            }
        }
    }

    void explain_missing_curvature() {
        for (const BodyIndex body : mechanism_.moving_bodies()) {
            const bool found = std::any_of(solution_.curvature.begin(), solution_.curvature.end(),
                                           [&](const Curvature& each) { return each.body == body; });
            if (!found && reached(body))
                unsolved({lang::phrases::curvature_of_body, {named(body)}}, missing_acceleration());
        }
    }

private:
    BodyName named(BodyIndex body) const { return named_body(mechanism_, body); }
    void unsolved(Message what, Message why) { solution_.unsolved.push_back({std::move(what), std::move(why)}); }

    bool reached(BodyIndex body) const {
        if (!motion_.velocity.turns(body)) return false;
        for (const NodeIndex node : structure_.nodes_of(body)) {
            if (motion_.velocity.has(node)) return true;
        }
        return false;
    }

    bool wholly_accelerated(BodyIndex body) const {
        const auto& nodes = structure_.nodes_of(body);
        return motion_.acceleration.turns(body) && std::all_of(nodes.begin(), nodes.end(), [&](NodeIndex node) {
                   return !structure_.node(node).carried || motion_.acceleration.has(node);
               });
    }

    Message missing_acceleration() const {
        for (const JointIndex index : indices_of(mechanism_.joints)) {
            const Joint& joint = mechanism_.joint(index);
            if (!joint.pair().asks_curvatures() || structure_.has_curvatures(index)) continue;
            const bool given = joint.profiles.contains(joint.bodies[0]) && joint.profiles.contains(joint.bodies[1]);
            return {given ? lang::phrases::curvatures_coincide : lang::phrases::curvatures_wanted, {file_name(joint)}};
        }
        return {lang::phrases::hangs_on_undetermined, {}};
    }

    Message reason_for(BodyIndex body) const {
        const Mobility& mobility = solution_.mobility;
        if (mechanism_.drivers.empty()) return {lang::phrases::nothing_drives, {Count{mobility.effective}}};
        if (at_index(body) < mobility.determined.size() && !mobility.determined[at_index(body)]) {
            if (!mobility.idle_drivers.empty()) return {lang::phrases::stays_free, {}};
            for (const DeadPoint& dead : plan_.dead_points) {
                if (carries(dead.node, body))
                    return {lang::phrases::dead_point_at, {PointName{structure_.node(dead.node).label}}};
            }
            Message lacks{lang::phrases::lacks_drivers, {Count{mobility.effective}, Count{mobility.driven}}};
            // If there is a likely mistake, more drivers are not the remedy; the remarks give it.
            if (const int more = mobility.effective - mobility.driven; mistakes_.empty()) {
                lacks.arguments.emplace_back(Count{more});
                if (more > 1) lacks.arguments.emplace_back(Count{more});
            }
            return lacks;
        }
        return {mobility.idle_drivers.empty() ? lang::phrases::beyond_groups : lang::phrases::stands_still, {}};
    }

    bool carries(NodeIndex node, BodyIndex body) const {
        for (const BodyIndex carrier : structure_.node(node).bodies) {
            if (carrier == body) return true;
        }
        return false;
    }

    Solution& solution_;
    const Mechanism& mechanism_;
    const Structure& structure_;
    const Plan& plan_;
    const Motion& motion_;
    bool accelerations_;
    const std::vector<Message>& mistakes_;
};

}  // namespace

void explain_idle_drivers(const DrawnMotion& drawn) {
    IdleDrivers drivers(drawn);
    for (const int idle : drawn.solution.mobility.idle_drivers) drivers.compare(idle);
}
void explain_missing_motion(const DrawnMotion& drawn) { MissingMotion(drawn).explain_missing_motion(); }
void explain_missing_curvature(const DrawnMotion& drawn) { MissingMotion(drawn).explain_missing_curvature(); }

}  // namespace kinegraph
