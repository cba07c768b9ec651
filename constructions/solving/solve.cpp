#include "constructions/solving/solve.hpp"

#include <algorithm>
#include <memory>
#include <string>

#include "constructions/kinematics/curvature.hpp"
#include "constructions/kinematics/degeneracy.hpp"
#include "constructions/kinematics/instant_centres.hpp"
#include "constructions/kinematics/instantaneous_motion.hpp"
#include "constructions/kinematics/motion.hpp"
#include "constructions/kinematics/plan.hpp"
#include "constructions/kinematics/relative_motion.hpp"
#include "constructions/kinematics/structure.hpp"
#include "constructions/solving/missing_motion.hpp"
#include "constructions/statics/forces.hpp"
#include "constructions/statics/free_bodies.hpp"
#include "constructions/statics/virtual_work.hpp"
#include "constructions/verdicts/check_rows.hpp"
#include "constructions/verdicts/verdicts.hpp"
#include "engine/equations/equations.hpp"
#include "engine/solution/found_elements.hpp"
#include "engine/solution/problem_kind.hpp"
#include "lang/keys/phrases.hpp"
#include "lang/keys/sentences.hpp"

namespace kinegraph {
namespace {

/// What to find: what the file requests, else everything that its data allow.
struct Wanted {
    bool centres = false, velocities = false, accelerations = false, forces = false;
    bool stated = false;
    bool curvature = false;  ///< only on request
};

Wanted wanted_of(const Mechanism& mechanism) {
    const Find& find = mechanism.find;
    const bool driven = !mechanism.drivers.empty();
    const bool loaded =
        !mechanism.loads.empty() || (mechanism.gravity && !mechanism.masses.empty()) || mechanism.inertia_forces;
    if (!find.stated && mechanism.motion)
        return {true, true, !mechanism.motion->accelerations.empty(), loaded, false, find.curvature};
    // Loads without drivers: find the forces.
    if (!find.stated) return {driven || !loaded, driven, driven, loaded, false, find.curvature};
    Wanted wanted{find.instant_centres, find.velocity, find.acceleration, find.forces && loaded, true, find.curvature};
    // The equations' values are compared with the polygons.
    if (find.curvature || (find.equations && driven)) wanted.velocities = wanted.accelerations = true;
    // Inertia forces depend on the motion.
    if ((find.virtual_work || find.forces) && driven && mechanism.inertia_forces)
        wanted.velocities = wanted.accelerations = true;
    if (!find.relative_motion.empty()) {
        wanted.velocities = true;
        wanted.accelerations = wanted.accelerations || !mechanism.motion || !mechanism.motion->accelerations.empty();
    }
    return wanted;
}

template <class Rates>
bool any_driver(const Mechanism& mechanism, Rates is) {
    return std::any_of(mechanism.drivers.begin(), mechanism.drivers.end(), [&](const Driver& driver) {
        return std::visit(
            [&](const auto& given) {
                if constexpr (requires { given.omega; }) {
                    return is(given.omega, given.alpha);
                } else {
                    return is(given.speed, given.acceleration);
                }
            },
            driver);
    });
}

bool is_moving(const Mechanism& mechanism) {
    return any_driver(mechanism, [](const Exact& rate, const Exact&) { return !rate.is_zero(); });
}

/// Whether a driver that rests begins to move.
bool begins_to_move(const Mechanism& mechanism) {
    return any_driver(mechanism,
                      [](const Exact& rate, const Exact& change) { return rate.is_zero() && !change.is_zero(); });
}

/// Draws everything on one board and collects the results.
class Solver {
public:
    Solver(Solution& solution, FinerPose finer, Arithmetic arithmetic, bool displaces = false)
        : arithmetic_(arithmetic),
          displaces_(displaces),
          solution_(solution),
          draw_finer_(std::move(finer)),
          mechanism_(solution.mechanism),
          wanted_(wanted_of(mechanism_)),
          board_(mechanism_, solution.pose, [this]() -> const Pose& { return finer_pose(); }),
          scratch_(mechanism_, solution.pose, [this]() -> const Pose& { return finer_pose(); }),
          structure_(mechanism_, scratch_) {}

    void run() {
        solution_.remarks = solution_.pose.remarks;
        remark_degeneracies();
        likely_mistakes_ = likely_mistakes(mechanism_, solution_.pose, solution_.mobility, false);
        add_nodes_of_interest(structure_);
        solution_.bodies.resize(mechanism_.bodies.size());
        if (mechanism_.motion) {
            draw_act();
        } else {
            draw_mechanism();
        }
        collect_points();
        solution_.settled.accelerations = board_.strokes();
        if (mechanism_.motion) solution_.settled.velocities = board_.strokes();
        if (wanted_.forces) collect_forces();
        solution_.settled.forces = board_.strokes();
        lead_with_likely_mistakes();
        finish_record();
        for (Message& remark : remarks_on_ill_conditioning(solution_)) solution_.remarks.push_back(std::move(remark));
        if (!is_checked()) return;
        Comparison comparison = compare_with_check(solution_);
        const std::vector<Comparison::Moved> moved = comparison.bodies;
        enter(std::move(comparison), solution_);
        for (Message& remark : disagreements(solution_, moved)) solution_.remarks.push_back(std::move(remark));
    }

private:
    /// Centres follow from the joints alone; without velocities the check has nothing to compare.
    bool is_checked() const {
        return wanted_.velocities || wanted_.accelerations || wanted_.forces || (mechanism_.motion && wanted_.centres);
    }

    void draw_mechanism() {
        InstantCentres centres(structure_, board_, wanted_.centres ? rest_here() : RelativeRest{});
        if (wanted_.centres) centres.draw();
        if (wanted_.centres && !centres.are_found()) want_motion_for_centres();
        if (wanted_.velocities || wanted_.accelerations) {
            draw_motion_of_bodies();
            if (wanted_.centres) {
                second_way(centres);
                if (is_moving(mechanism_) || begins_to_move(mechanism_))
                    centres.complete(motion_, solution_.mobility.effective);
            }
            solution_.sliding = draw_slidings(structure_, board_, motion_, wanted_.accelerations);
            solution_.relative_motion = draw_relative_motions(structure_, board_, motion_, wanted_.accelerations);
            if (wanted_.curvature) solution_.curvature = draw_curvature(structure_, board_, motion_);
            if (displaces_) solution_.virtual_work = works_of_displacement(structure_, board_, motion_);
            collect_motion();
            explain_missing_motion(drawn_motion());
            if (wanted_.curvature) explain_missing_curvature(drawn_motion());
        }
        if (wanted_.centres) collect_centres(centres);
    }

    /// Centres that depend on the drivers are the same whatever else is asked: they take the motion that gives them.
    void want_motion_for_centres() {
        wanted_.velocities = wanted_.velocities || is_moving(mechanism_) || begins_to_move(mechanism_);
        wanted_.accelerations = wanted_.accelerations || begins_to_move(mechanism_);
    }

    RelativeRest rest_here() {
        if (solution_.mobility.effective == 0) solution_.remarks.push_back({lang::sentences::nothing_moves, {}});
        return relative_rest(mechanism_, solution_.pose, solution_.mobility, [this] { return finer_pose(); });
    }

    /// Reduces the record to what is drawn and found; its values become the solution's.
    void finish_record() {
        Protocol& protocol = solution_.protocol = std::move(board_).finish();
        std::vector<ElementIndex> wanted;
        for_each_drawn(protocol, [&](ElementIndex& element) { wanted.push_back(element); });
        for_each_found(solution_, [&](ElementIndex& element, auto&) { wanted.push_back(element); });
        Cut record = cut(protocol.program, wanted, static_cast<int>(protocol.program.strokes.size()));
        const auto renumber = [&](ElementIndex& element) { element = record.element[at_index(element)]; };
        for_each_drawn(protocol, renumber);
        for_each_found(solution_, [&](ElementIndex& element, auto&) { renumber(element); });
        for (int* settled :
             {&solution_.settled.velocities, &solution_.settled.accelerations, &solution_.settled.forces})
            *settled = static_cast<int>(std::count_if(record.element.begin(), record.element.begin() + *settled,
                                                      [](ElementIndex kept) { return kept != none; }));
        const auto keep = [&](std::vector<Value>& all) {
            // The kept elements stay in order.
            std::vector<Value> values;
            values.reserve(record.program.strokes.size());
            for (std::size_t i = 0; i < record.element.size(); ++i)
                if (record.element[i] != none) values.push_back(std::move(all[i]));
            all = std::move(values);
        };
        keep(protocol.values);
        std::for_each(protocol.shifted.begin(), protocol.shifted.end(), keep);
        protocol.program = std::move(record.program);
        remark_observers();
        read_values(solution_, protocol.values);
        forget_noise(solution_, [this] { return finer_pose(); });
        statics::note_first_use_of_lines(solution_.free_bodies, solution_.pose);
        if (solution_.superposition)
            for (Superposition::Part& part : solution_.superposition->parts)
                statics::note_first_use_of_lines(part.bodies, solution_.pose);
        say_projections();
        if (arithmetic_ == Arithmetic::told) add_worked_arithmetic(solution_);
    }

    /// Requested observers that the motion was not found through.
    void remark_observers() {
        for (const RelativeMotionQuery& query : mechanism_.find.relative_motion) {
            if (!query.solves) continue;
            const std::string &point = mechanism_.point(query.point).name, &body = body_name(query.observer);
            const auto& said = solution_.protocol.statements;
            const bool through = std::any_of(said.begin(), said.end(), [&](const Statement& each) {
                return each.message.sentence == lang::sentences::observer_velocity &&
                       std::get<PointName>(each.message.arguments[0]).name == point &&
                       std::get<BodyName>(each.message.arguments[1]).name == body;
            });
            if (!through)
                solution_.remarks.push_back(
                    {lang::sentences::not_through_observer, {PointName{point}, BodyName{body}}});
        }
    }

    /// The difference of the projections of two velocities on the join of their points, in the file's unit.
    void say_projections() {
        if (!solution_.instantaneous_motion || !solution_.instantaneous_motion->differing) return;
        const auto& differing = *solution_.instantaneous_motion->differing;
        const Unit& unit = mechanism_.units.velocity;
        const auto measure = [&](const Vector& projection) {
            const Exact share = ratio_of(projection, *differing.join) / unit.si;
            return Amount{share.to_double() * length(*differing.join), unit.symbol};
        };
        const Amount first = measure(*differing.of_first), second = measure(*differing.of_second);
        auto& said = solution_.protocol.statements[at_index(differing.statement)].message.arguments;
        said.insert(said.end(), {first, second});
        for (Unsolved& missing : solution_.unsolved) {
            if (missing.why.sentence != lang::phrases::unequal_projections) continue;
            auto& arguments = missing.why.arguments;  // segment, first point, second point
            arguments.insert(arguments.begin() + 2, first);
            arguments.emplace_back(second);
        }
    }

    /// The instantaneous motion of one body; the file says nothing about other bodies.
    void draw_act() {
        InstantaneousMotionResult act = draw_instantaneous_motion(
            structure_, board_, {wanted_.centres, wanted_.velocities || wanted_.accelerations, wanted_.accelerations});
        if (wanted_.velocities || wanted_.accelerations) motion_ = std::move(act.motion);
        solution_.instantaneous_motion = std::move(act.figure);
        if (motion_.velocity.polygon >= 0) {
            solution_.relative_motion = draw_relative_motions(structure_, board_, motion_, wanted_.accelerations);
            if (wanted_.curvature) solution_.curvature = draw_curvature(structure_, board_, motion_);
            collect_motion();
        }
        for (Unsolved& missing : act.unsolved) solution_.unsolved.push_back(std::move(missing));
        const BodyIndex moved = mechanism_.motion->body;
        for (const BodyIndex body : mechanism_.moving_bodies()) {
            if (body != moved)
                unsolved({lang::phrases::motion_of_body, {named(body)}},
                         {lang::phrases::one_body_only, {named(moved)}});
        }
        if (!wanted_.centres) return;
        for (const BodyIndex first : indices_of(mechanism_.bodies)) {
            for (const BodyIndex second : mechanism_.bodies_after(first)) {
                InstantCentre centre;
                centre.first = first;
                centre.second = second;
                solution_.centres.push_back(first == frame && second == moved ? act.centre : centre);
            }
        }
    }

    const std::string& body_name(BodyIndex body) const { return mechanism_.bodies[at_index(body)].name; }
    BodyName named(BodyIndex body) const { return {body_name(body)}; }
    void unsolved(Message what, Message why) { solution_.unsolved.push_back({std::move(what), std::move(why)}); }

    const Pose& finer_pose() {
        if (!finer_) {
            finer_ = std::make_unique<Pose>(draw_finer_());
        }
        return *finer_;
    }

    void remark_degeneracies() {
        solution_.instant_motion = degenerate_motion(mechanism_, solution_.pose, solution_.mobility);
        for (Message& remark : remarks_on_mobility(mechanism_, solution_.mobility, solution_.instant_motion))
            solution_.remarks.push_back(std::move(remark));
        for (Message& remark : remarks_on_lengths(mechanism_, solution_.pose))
            solution_.remarks.push_back(std::move(remark));
        for (Message& remark : remarks_on_gravity(mechanism_)) solution_.remarks.push_back(std::move(remark));
    }

    /// If results are missing for lack of drivers or input forces, a likely mistake is the probable cause, so it comes
    /// first.
    void lead_with_likely_mistakes() {
        const bool wanting =
            std::any_of(solution_.unsolved.begin(), solution_.unsolved.end(), [](const Unsolved& missing) {
                const Key why = missing.why.sentence;
                return why == lang::phrases::lacks_drivers || why == lang::phrases::nothing_drives ||
                       why == lang::phrases::unbalanced;
            });
        if (wanting)
            solution_.remarks.insert(solution_.remarks.begin(), likely_mistakes_.begin(), likely_mistakes_.end());
    }

    DrawnMotion drawn_motion() {
        return {solution_, structure_, board_, plan_, motion_, wanted_.accelerations, likely_mistakes_};
    }
    void draw_motion_of_bodies() {
        std::vector<bool> use(mechanism_.drivers.size(), true);
        for (const int idle : solution_.mobility.idle_drivers) use[at_index(idle)] = false;
        // No trials at a dead point or a lock: the missing motion is then not determined.
        const bool tries = !mechanism_.drivers.empty() && solution_.mobility.idle_drivers.empty();
        plan_ = plan_motion(structure_, scratch_, use, tries ? solution_.mobility.determined : std::vector<bool>());
        motion_ = draw_motion(structure_, board_, plan_, wanted_.accelerations);
        solution_.equivalent_linkages = motion_.equivalents;
        solution_.settled.velocities = motion_.velocities_settled;
        explain_idle_drivers(drawn_motion());
    }

    void second_way(InstantCentres& centres) {
        if (solution_.mobility.effective != 1 || !is_moving(mechanism_)) return;
        for (const Driver& driver : mechanism_.drivers) {
            const auto* spin = std::get_if<SpinDriver>(&driver);
            if (spin != nullptr && spin->relative_to == frame)
                return centres.second_way(motion_, spin->body, solution_.second_way);
        }
    }

    void collect_motion() {
        for (const BodyIndex body : indices_of(mechanism_.bodies)) {
            BodyMotion& found = solution_.bodies[at_index(body)];
            if (motion_.velocity.turns(body)) found.omega = Recorded<Exact>::at(motion_.velocity.spin(body).element);
            if (wanted_.accelerations && motion_.acceleration.polygon >= 0 && motion_.acceleration.turns(body))
                found.alpha = Recorded<Exact>::at(motion_.acceleration.spin(body).element);
        }
    }

    void collect_points() {
        for (const NodeIndex node : indices_of(structure_.nodes())) {
            const Node& here = structure_.node(node);
            if (!here.carried) continue;
            PointMotion point;
            point.point = here.point;
            point.bodies = here.bodies;
            point.label = here.label;
            if (motion_.velocity.polygon >= 0 && motion_.velocity.has(node))
                point.velocity = Recorded<Vector>::at(motion_.velocity.tip(node).element);
            if (motion_.acceleration.polygon >= 0 && motion_.acceleration.has(node)) {
                point.acceleration = Recorded<Vector>::at(motion_.acceleration.tip(node).element);
            }
            solution_.points.push_back(std::move(point));
        }
    }

    void collect_forces() {
        ForceResults forces = draw_forces(structure_, board_, motion_, solution_.mobility);
        solution_.forces = std::move(forces.joints);
        solution_.efforts = std::move(forces.efforts);
        solution_.free_bodies = std::move(forces.bodies);
        solution_.resultants = std::move(forces.resultants);
        solution_.truss = std::move(forces.truss);
        solution_.virtual_motions = std::move(forces.virtual_motions);
        solution_.taken_together = std::move(forces.together);
        solution_.superposition = std::move(forces.superposition);
        for (Unsolved& missing : forces.unsolved) solution_.unsolved.push_back(std::move(missing));
        for (Message& remark : forces.remarks) solution_.remarks.push_back(std::move(remark));
        // An unknown input force would be missing in the sum.
        const bool all_efforts = std::all_of(solution_.efforts.begin(), solution_.efforts.end(),
                                             [](const EffortValue& each) { return each.value.has_value(); });
        if (wanted_.velocities && is_moving(mechanism_) && all_efforts)
            solution_.virtual_work = virtual_work(structure_, board_, motion_.velocity, solution_.free_bodies);
    }

    void collect_centres(const InstantCentres& centres) {
        solution_.centres = centres.results();
        for (const InstantCentre& centre : solution_.centres) {
            if (centre.at || centre.everywhere) continue;
            const bool determined = solution_.mobility.effective <= solution_.mobility.driven;
            unsolved({lang::phrases::centre_of_bodies, {named(centre.first), named(centre.second)}},
                     {determined ? lang::phrases::one_line_unknown : lang::phrases::one_line_undetermined, {}});
        }
    }

    Arithmetic arithmetic_;
    bool displaces_;  ///< its velocities are virtual displacements
    Solution& solution_;
    FinerPose draw_finer_;
    const Mechanism& mechanism_;
    Wanted wanted_;
    std::unique_ptr<Pose> finer_;
    std::vector<Message> likely_mistakes_;
    Board board_;
    Board scratch_;  ///< for the planner
    Structure structure_;
    Plan plan_;
    Motion motion_;
};

/// The closure equations on request; the constructions do not use them.
void add_equations(Solution& solution, const FinerPose& finer) {
    if (!solution.mechanism.find.equations) return;
    Equations equations = equations_of(solution.mechanism, solution.pose);
    forget_noise(equations, solution, finer);
    solution.equations = std::make_shared<const Equations>(std::move(equations));
}

/// For a pose that was drawn from the file. One that closes at 100 bits and not at 200 depends on a coincidence of its
/// numbers; then nothing shrinks.
Pose drawn_finer(const Solution& solution) {
    auto finer = draw_pose(solution.mechanism, 2 * solution.pose.bits);
    return finer ? *std::move(finer) : solution.pose;
}

/// Draws a mechanism with known pose and mobility.
void draw(Solution& solution, Arithmetic arithmetic, bool displaces = false) {
    Solver(
        solution, [&solution] { return drawn_finer(solution); }, arithmetic, displaces)
        .run();
}

/// Problems at the joints of a mechanism whose forces are found: the contacts.
void add_problems_at_joints(Solution& solution) {
    for (const ProblemKind* each : problem_kinds())
        if (each->add_at_joints != nullptr) each->add_at_joints(solution);
}

/// The same pose, with the directions of these drivers.
Pose driven_as(const Mechanism& mechanism, Pose pose) {
    const std::size_t count = mechanism.drivers.size();
    pose.driver_directions.assign(count, {});
    pose.driver_units.assign(count, {});
    for (std::size_t i = 0; i < count; ++i)
        if (const auto* point = std::get_if<PointDriver>(&mechanism.drivers[i])) {
            pose.driver_directions[i] = direction_of(point->along, pose);
            pose.driver_units[i] = unit_along(pose.driver_directions[i], pose.bits);
        }
    return pose;
}

}  // namespace

bool finds_centres(const Mechanism& mechanism) { return wanted_of(mechanism).centres; }

Result<Solution> solve(Mechanism mechanism, Arithmetic arithmetic) {
    auto pose = draw_pose(mechanism);
    if (!pose) return tl::unexpected(std::move(pose.error()));
    Solution solution;
    solution.mechanism = std::move(mechanism);
    solution.pose = *std::move(pose);
    if (stands_for_joints(solution.mechanism)) {
        const Problem& problem = *solution.mechanism.problem;
        auto found = problem.kind->solve(problem, solution.mechanism, solution.pose);
        if (!found) return tl::unexpected(std::move(found.error()));
        for (Words& each : remarks_on_check(found->values)) found->remarks.push_back(std::move(each));
        solution.problem = std::make_shared<const ProblemSolution>(*std::move(found));
        return solution;
    }
    solution.mobility = mobility_of(solution.mechanism, solution.pose);
    draw(solution, arithmetic);
    add_problems_at_joints(solution);
    add_equations(solution, [&solution] { return drawn_finer(solution); });
    if (solution.mechanism.find.virtual_work) add_displacements(solution);
    return solution;
}

Result<Solution> solve_displaced(Mechanism mechanism, const Pose& like, const FinerPose& finer) {
    auto pose = draw_pose(mechanism, like.bits);
    if (!pose) return tl::unexpected(std::move(pose.error()));
    Solution solution;
    solution.mechanism = std::move(mechanism);
    solution.pose = *std::move(pose);
    solution.pose.exact = like.exact;
    solution.pose.leftover = like.leftover;
    if (!finer) {
        solution.mobility = mobility_of(solution.mechanism, solution.pose);
        draw(solution, Arithmetic::told, true);
        return solution;
    }
    const FinerPose with_drivers = [&] { return driven_as(solution.mechanism, finer()); };
    solution.mobility = mobility_of(solution.mechanism, solution.pose, with_drivers);
    Solver(solution, with_drivers, Arithmetic::told, true).run();
    return solution;
}

Solution solve(Mechanism mechanism, Pose pose, const FinerPose& finer, Arithmetic arithmetic) {
    Solution solution;
    solution.mechanism = std::move(mechanism);
    solution.pose = std::move(pose);
    solution.mobility = mobility_of(solution.mechanism, solution.pose, finer);
    Solver(solution, finer, arithmetic).run();
    add_problems_at_joints(solution);
    add_equations(solution, finer);
    if (solution.mechanism.find.virtual_work) add_displacements(solution, finer);
    return solution;
}

}  // namespace kinegraph
