
#include <algorithm>
#include <cmath>
#include <utility>

#include "constructions/solving/solve.hpp"
#include "engine/check/check.hpp"
#include "engine/check/check_forces.hpp"
#include "engine/solution/displacements.hpp"
#include "lang/keys/positions.hpp"
#include "lang/keys/sentences.hpp"

namespace kinegraph {
namespace {

/// The same drivers, all at rest except the one at `moving`, which has unit rate.
std::vector<Driver> at_unit_rate(std::vector<Driver> drivers, std::size_t moving) {
    for (std::size_t i = 0; i < drivers.size(); ++i)
        std::visit(
            [&](auto& driver) {
                const Exact rate = i == moving ? 1 : 0;
                driver.law.reset();
                if constexpr (requires { driver.omega; }) {
                    driver.omega = rate;
                    driver.alpha = 0;
                } else {
                    driver.speed = rate;
                    driver.acceleration = 0;
                }
            },
            drivers[i]);
    return drivers;
}

/// Coordinates along which a mechanism may be displaced, the most convenient first.
std::vector<Driver> candidates(const Mechanism& mechanism) {
    std::vector<Driver> on_frame, slides_on_frame, turns, slides, points;
    for (const BodyIndex body : mechanism.moving_bodies()) {
        const bool hinged = std::any_of(mechanism.joints.begin(), mechanism.joints.end(), [&](const Joint& joint) {
            return joint.pair().is_hinge() && joint.connects(body) && joint.connects(frame);
        });
        SpinDriver spin;
        spin.body = body;
        (hinged ? on_frame : turns).emplace_back(spin);
        for (const PointIndex point : mechanism.body(body).points)
            for (const int degrees : {0, 90}) {
                PointDriver moved;
                moved.body = body;
                moved.at = point;
                moved.along.form = degrees == 0 ? Vector{1, 0} : Vector{0, 1};
                points.emplace_back(moved);
            }
    }
    for (const JointIndex index : indices_of(mechanism.joints)) {
        const Joint& joint = mechanism.joint(index);
        if (!joint.pair().has_guide() || !joint.pair().is_sleeve()) continue;
        SlideDriver slide;
        slide.joint = index;
        (joint.connects(frame) ? slides_on_frame : slides).emplace_back(slide);
    }
    std::vector<Driver> all = std::move(on_frame);
    for (auto* more : {&slides_on_frame, &turns, &slides, &points}) all.insert(all.end(), more->begin(), more->end());
    return all;
}

class Displacer {
public:
    Displacer(const Solution& solution, const FinerPose& finer)
        : solution_(solution), finer_(finer), mechanism_(solution.mechanism) {}

    Displacements find() {
        if (mechanism_.motion) {
            found_.why_not = {lang::positions::the_file_gives_the_motion};
        } else if (solution_.mobility.effective == 0) {
            found_.why_not = {lang::positions::nothing_can_move_it_has_no};
        } else if (choose_coordinates()) {
            add_inertia();
            for (std::size_t i = 0; i < drivers_.size() && found_.why_not.empty(); ++i) displace(i);
            if (found_.why_not.empty()) find_efforts();
        }
        if (!found_.why_not.empty()) found_.freedoms.clear();
        return std::move(found_);
    }

private:
    /// The drivers that move the mechanism; further coordinates if these leave freedoms.
    bool choose_coordinates() {
        const std::vector<int>& idle = solution_.mobility.idle_drivers;
        for (std::size_t i = 0; i < mechanism_.drivers.size(); ++i)
            if (std::find(idle.begin(), idle.end(), static_cast<int>(i)) == idle.end())
                drivers_.push_back(mechanism_.drivers[i]);
        of_file_ = drivers_.size();
        const auto wanted = static_cast<std::size_t>(solution_.mobility.effective);
        if (drivers_.size() < wanted)
            for (const Driver& candidate : candidates(mechanism_)) {
                if (drivers_.size() == wanted) break;
                if (moves_more(candidate)) drivers_.push_back(candidate);
            }
        if (drivers_.size() == wanted) return true;
        found_.why_not = {lang::positions::no_coordinates_were_found_that_move};
        return false;
    }
    bool moves_more(const Driver& candidate) const {
        Mechanism tried = mechanism_;
        tried.drivers = drivers_;
        tried.drivers.push_back(candidate);
        const auto pose = draw_pose(tried, solution_.pose.bits);
        return pose && mobility_of(tried, *pose).idle_drivers.empty();
    }

    /// Adds inertia forces as loads, because the motion that causes them is not the displacement.
    void add_inertia() {
        loads_ = mechanism_.loads;
        if (!mechanism_.inertia_forces) return;
        for (const Mass& mass : mechanism_.masses) {
            const auto motion =
                std::find_if(solution_.points.begin(), solution_.points.end(), [&](const PointMotion& each) {
                    return each.point == mass.centre &&
                           std::find(each.bodies.begin(), each.bodies.end(), mass.body) != each.bodies.end();
                });
            const auto& alpha = solution_.bodies[at_index(mass.body)].alpha;
            if (motion == solution_.points.end() || !motion->acceleration || !alpha) {
                found_.why_not =
                    Words(lang::positions::the_acceleration_of_body_is_not, mechanism_.body(mass.body).name);
                return;
            }
            const std::string name = mechanism_.masses.size() == 1 ? "i" : "i" + mechanism_.body(mass.body).name;
            ForceLoad force;
            force.name = name;
            force.body = mass.body;
            force.at = mass.centre;
            force.value = -(mass.mass * *motion->acceleration);
            loads_.emplace_back(std::move(force));
            CoupleLoad couple;
            couple.name = name;
            couple.body = mass.body;
            couple.value = -(mass.inertia * *alpha);
            loads_.emplace_back(std::move(couple));
        }
    }

    void displace(std::size_t moving) {
        Mechanism displaced = mechanism_;
        displaced.drivers = at_unit_rate(drivers_, moving);
        displaced.loads = loads_;
        displaced.inertia_forces = false;
        displaced.contacts.reset();
        displaced.exercise.reset();
        displaced.find = {};
        displaced.find.stated = displaced.find.velocity = true;
        auto moved = solve_displaced(std::move(displaced), solution_.pose, finer_);
        if (!moved || !moved->virtual_work) {
            found_.why_not = {lang::positions::the_motion_was_not_found};
            return;
        }
        Displacements::Freedom freedom;
        freedom.driver = moved->mechanism.drivers[moving];
        freedom.chosen = moving >= of_file_;
        freedom.equations = std::make_shared<const Equations>(equations_of(moved->mechanism, moved->pose));
        freedom.moved = std::make_shared<const Solution>(*std::move(moved));
        found_.freedoms.push_back(std::move(freedom));
    }

    /// One equation for each freedom, linear in the input forces and couples. Solved from the works of both
    /// computations.
    void find_efforts() {
        const std::size_t count = mechanism_.efforts.size();
        WorkEquations drawn, by_ratios;
        bool have_ratios = true;
        for (const Displacements::Freedom& freedom : found_.freedoms) {
            const VirtualWork& work = *freedom.moved->virtual_work;
            std::vector<Exact>& row = drawn.rows.emplace_back(count + 1);
            std::vector<Exact>& other = by_ratios.rows.emplace_back(count + 1);
            for (const VirtualWork::Share& share : work.shares) {
                row[at_index(share.effort)] = share.rests ? Exact(0) : *share.power;
                const auto ratio =
                    work_by_ratios(*freedom.equations, freedom.moved->mechanism, freedom.moved->pose, share.effort);
                have_ratios = have_ratios && ratio;
                other[at_index(share.effort)] = share.rests ? Exact(0) : Exact::from_double(ratio.value_or(0));
            }
            row[count] = -work.total;
            double total = 0;
            for (const VirtualWork::Entry& entry : work.entries) {
                const auto ratio = work_by_ratios(*freedom.equations, entry);
                have_ratios = have_ratios && ratio;
                total += ratio.value_or(0);
            }
            other[count] = Exact::from_double(-total);
            drawn.largest.push_back(size_of(work));
            by_ratios.largest.push_back(size_of(work));
        }
        const WorkEquations::Found found = std::move(drawn).solved(count);
        found_.balanced = found.balanced;
        const auto others =
            have_ratios ? std::move(by_ratios).solved(count).efforts : std::vector<std::optional<Exact>>(count);
        for (std::size_t e = 0; e < count; ++e) {
            Displacements::Effort effort;
            effort.given = static_cast<int>(e);
            // If no input forces balance the loads, none of them has a value.
            if (found.balanced) effort.value = found.efforts[e];
            if (found.balanced && others[e]) effort.ratio = others[e]->to_double();
            found_.efforts.push_back(std::move(effort));
        }
    }
    static double size_of(const VirtualWork& work) {
        double largest = 0;
        for (const VirtualWork::Entry& entry : work.entries)
            largest = std::max({largest, length(entry.force) * length(entry.velocity),
                                std::abs((entry.couple * entry.omega).to_double())});
        return largest;
    }
    const Solution& solution_;
    const FinerPose& finer_;
    const Mechanism& mechanism_;
    std::vector<Driver> drivers_;
    std::size_t of_file_ = 0;
    std::vector<Load> loads_;
    Displacements found_;
};

/// The check of forces has all reactions, and no displacement.
void hold_against_check(Solution& solution, const Displacements& found) {
    if (found.efforts.empty()) return;
    const NumericForces numeric =
        check_forces(solution.mechanism, solution.pose, check_motion(solution.mechanism, solution.pose));
    for (const Displacements::Effort& effort : found.efforts) {
        if (!effort.value || !numeric.effort_known[at_index(effort.given)]) continue;
        const double value = effort.value->to_double(), other = numeric.efforts[at_index(effort.given)];
        solution.checks.push_back(
            {{.kind = Quantity::Kind::virtual_effort, .given = effort.given}, value, other, value - other});
    }
}

}  // namespace

void add_displacements(Solution& solution, const FinerPose& finer) {
    const auto found = std::make_shared<const Displacements>(Displacer(solution, finer).find());
    for (const Displacements::Freedom& freedom : found->freedoms)
        for (const Message& remark : freedom.moved->remarks) {
            const Key said = remark.sentence;
            if (said == lang::sentences::check_differs || said == lang::sentences::check_stands_still ||
                said == lang::sentences::check_moves)
                solution.remarks.push_back(remark);
        }
    hold_against_check(solution, *found);
    solution.displacements = found;
}

}  // namespace kinegraph
