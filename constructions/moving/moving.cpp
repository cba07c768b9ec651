#include "constructions/moving/moving.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "constructions/moving/moving_rules.hpp"
#include "constructions/moving/turned_loads.hpp"
#include "constructions/positions/cycle.hpp"
#include "constructions/positions/named_results.hpp"
#include "constructions/solving/solve.hpp"
#include "engine/board/replay.hpp"
#include "engine/mechanism/drivers.hpp"
#include "engine/motion/closure.hpp"
#include "engine/motion/place_rules.hpp"
#include "engine/motion/repositioned.hpp"
#include "engine/number/functions.hpp"
#include "engine/sentences/centre_symbol.hpp"
#include "engine/sentences/result_catalogue.hpp"
#include "engine/solution/displacements.hpp"
#include "engine/solution/problem_solution.hpp"
#include "engine/solution/sliding.hpp"

namespace kinegraph {
namespace {

/// Samples along the travel, every five degrees of a full turn, since special positions are often at such angles; and
/// the distance of the last sample from a limit, as a fraction of the travel.
constexpr int samples_of_way = 72;
constexpr double short_of_limit = 1e-6;
/// Limit: plans of special positions (a body at rest, two parallel lines) are not valid elsewhere, and few plans are
/// needed for the other positions.
constexpr std::size_t most_plans = 12;

// --- plans

/// The drawn elements, under names that are the same in all plans of the mechanism, and the values of the columns.
class Planned {
public:
    Planned(const Solution& solution, const std::vector<Column>& columns) : solution_(solution), columns_(columns) {}

    /// `has_figures`: whether figures of this record are shown, not only marks that are bound by name. `given`: the
    /// mechanism whose values the plan has; null: that of the solution.
    MovingPlan plan(const MovingRules& rules, bool has_figures = true, const Mechanism* given = nullptr) {
        read_sources();
        if (has_figures) {
            read_vectors();
            read_spots();
            read_lines();
        }
        plan_.held = bindings_of(solution_);
        const Protocol& protocol = solution_.protocol;
        Cut record = cut(protocol.program, wanted(), static_cast<int>(protocol.program.strokes.size()));
        renumber(record.element);
        for (const Value& value :
             givens_of(record.program, given != nullptr ? *given : solution_.mechanism, solution_.pose))
            plan_.givens.push_back(to_double(value));
        for (std::size_t i = 0; i < record.program.givens.size(); ++i)
            if (const auto rule = rules.of(record.program.givens[i], static_cast<int>(i)))
                plan_.moving.push_back(*rule);
        plan_.program = std::move(record.program);
        return std::move(plan_);
    }

private:
    void read_sources() {
        const std::vector<FoundValue> entries = found_values(solution_);
        for (const Column& column : columns_) {
            MovingPlan::Source& source = plan_.sources.emplace_back();
            for (const FoundValue& entry : entries)
                if (entry.quantity == column.quantity) source = {true, entry.element};
        }
    }
    const std::string& figure(int polygon) const { return solution_.protocol.polygons[at_index(polygon)].id; }
    void read_vectors() {
        for (const DrawnVector& drawn : solution_.protocol.vectors)
            if (drawn.trial == 0)
                plan_.vectors.push_back(
                    {figure(drawn.polygon), name_of(drawn.symbol), drawn.tail, drawn.tip, drawn.vanishes});
    }
    void read_spots() {
        for (const Image& image : solution_.protocol.images)
            if (image.trial == 0) plan_.spots.push_back({figure(image.polygon), name_of(image.symbol), image.point});
        for (const InstantCentre& centre : solution_.centres)
            if (centre.at.element() != none)
                plan_.spots.push_back({"",
                                       name_of(centre_symbol(solution_.mechanism, centre.first, centre.second, false)),
                                       centre.at.element()});
    }
    void read_lines() {
        std::map<std::string, int> count;
        for (const DrawnLine& line : solution_.protocol.lines) {
            if (line.trial != 0) continue;
            std::string name = line.polygon < 0 ? "" : figure(line.polygon);
            std::string key =
                std::to_string(static_cast<int>(line.reason.kind)) + " " + line.reason.from + " " + line.reason.to;
            key += " " + std::to_string(count[name + " " + key]++);
            plan_.lines.push_back({std::move(name), std::move(key), line.statement, line.line, line.points});
        }
    }
    template <class See>
    void each_element(See see) {
        for (auto& source : plan_.sources) see(source.element);
        for (auto& vector : plan_.vectors) see(vector.tail), see(vector.tip);
        for (auto& spot : plan_.spots) see(spot.point);
        for (auto& line : plan_.lines) {
            see(line.line);
            for (ElementIndex& point : line.points) see(point);
        }
        for (auto& held : plan_.held) see(held.place), see(held.vector), see(held.couple);
    }
    std::vector<ElementIndex> wanted() {
        std::vector<ElementIndex> all;
        each_element([&](const ElementIndex& element) {
            if (element != none) all.push_back(element);
        });
        return all;
    }
    void renumber(const std::vector<ElementIndex>& now) {
        each_element([&](ElementIndex& element) {
            if (element != none) element = now[at_index(element)];
        });
    }

    const Solution& solution_;
    const std::vector<Column>& columns_;
    MovingPlan plan_;
};

// --- courses

class Courses {
public:
    /// `is_displaced`: a solution of virtual displacements. Its rates are no speeds, and none of its polygons is shown.
    explicit Courses(const Solution& solution, bool is_displaced = false)
        : solution_(solution),
          mechanism_(solution.mechanism),
          pose_(solution.pose),
          rules_(mechanism_, pose_),
          is_displaced_(is_displaced) {}

    std::optional<Moving> moving(const Rereading& rereading) {
        if (!closure_of(mechanism_, pose_) || !carriers_of(mechanism_)) return std::nullopt;
        add_columns();
        add_plan(solution_);
        mover_.emplace(mechanism_, pose_);
        for (std::size_t i = 0; i < mechanism_.drivers.size(); ++i) add_course(static_cast<int>(i));
        if (moving_.courses.empty()) return std::nullopt;
        moving_.size = pose_.size.to_double();
        for (const Body& body : mechanism_.bodies) moving_.directions.push_back(direction_of(body));
        moving_.settings = is_displaced_ ? std::vector<MovingSetting>{} : rules_.settings();
        if (is_displaced_) {
            for (MovingPlan& plan : moving_.plans)
                std::erase_if(plan.moving,
                              [](const MovingGiven& each) { return each.rule == MovingGiven::Rule::setting; });
            return std::move(moving_);
        }
        for (MovingSetting& each : moving_.settings) {
            const bool is_speed = each.kind == MovingSetting::Kind::velocity;
            if (!is_speed && each.kind != MovingSetting::Kind::acceleration) continue;
            if (static_cast<std::size_t>(each.of) < rereading.rates.size())
                each.written_unit = rereading.rates[static_cast<std::size_t>(each.of)][is_speed ? 0 : 1];
        }
        for (MovingSetting& length : lengths_of(mechanism_, pose_)) moving_.settings.push_back(std::move(length));
        add_parameters(moving_, mechanism_, pose_, rereading);
        return std::move(moving_);
    }

    Moving standing() {
        add_columns();
        add_plan(solution_);
        add_plans_of_directions();
        moving_.size = pose_.size.to_double();
        for (const Body& body : mechanism_.bodies) moving_.directions.push_back(direction_of(body));
        moving_.settings = rules_.settings();
        put_rest();
        moving_.courses.emplace_back().samples.emplace_back().plan = 0;
        return std::move(moving_);
    }

private:
    /// Those of a sweep. What a sweep gives on request only would double the page.
    void add_columns() {
        if (is_displaced_) return;
        for (Column& column : columns_found(solution_))
            if (!result_kind(column.quantity).on_request) moving_.columns.push_back(std::move(column));
    }
    void add_plan(const Solution& solution) {
        moving_.plans.push_back(Planned(solution, moving_.columns).plan(rules_, !is_displaced_));
    }

    void add_plans_of_directions() {
        TurnedLoads loads(mechanism_, pose_, rules_.settings());
        for (const MovingPlan& plan : moving_.plans) loads.add(plan.program);
        loads.each_unplanned([&](const Mechanism& changed) {
            if (moving_.plans.size() >= most_plans) return false;
            const auto solution = solve(changed);
            if (!solution) return true;
            MovingPlan plan = Planned(*solution, moving_.columns).plan(rules_, true, &mechanism_);
            if (!replays(plan, changed, pose_)) return true;
            loads.add(plan.program);
            moving_.plans.push_back(std::move(plan));
            return moving_.plans.size() < most_plans;
        });
    }

    double direction_of(const Body& body) const {
        for (std::size_t i = 1; i < body.points.size(); ++i) {
            const Vector along = pose_.at(body.points[i]) - pose_.at(body.points[0]);
            if (!along.is_zero()) return nearest::atan2(along.y.to_double(), along.x.to_double());
        }
        return 0;
    }

    void add_course(int driver) {
        const Driver& given = mechanism_.drivers[at_index(driver)];
        MovingCourse course;
        course.driver = driver;
        course.name = name_of_course(mechanism_, given);
        course.turns = turns(given);
        auto positions = Positions::of(mechanism_, pose_, Course{driver});
        if (!positions) {
            moving_.still.emplace_back(course.name, positions.error().front());
            return;
        }
        const Law* law = law_of(given);
        const auto travel = law != nullptr ? travel_of_law(*positions, *law, std::nullopt, std::nullopt)
                                           : travel_of(*positions, course.turns, std::nullopt, std::nullopt);
        if (!travel) return;
        course.travel = *travel;
        course.by_law = law != nullptr;
        const Rates rates = rates_of(given);
        if (law == nullptr && rates.second.is_zero()) course.rate = rates.first.to_double();
        if (moving_.courses.empty()) put_closure(*positions);
        course.shares = positions->shares();
        for (const double at : ways_of(course)) add_sample(course, *positions, given, at);
        moving_.courses.push_back(std::move(course));
    }
    /// Nothing moves: places are those of the drawing, in m, each on its body, and no row has to be closed.
    void put_rest() {
        moving_.unit = 1;
        for (std::size_t i = 0; i < mechanism_.bodies.size(); ++i)
            moving_.bodies.push_back({Vector{}, -1, static_cast<int>(i)});
        moving_.frozen.assign(mechanism_.bodies.size(), true);
        const auto carriers = carriers_of(mechanism_);
        for (const PointIndex point : indices_of(mechanism_.points)) {
            Positions::PointRule& rule = moving_.points.emplace_back();
            const BodyIndex known = carriers ? (*carriers)[at_index(point)].body : frame;
            rule.carrier.body = known != none ? known : frame;
            rule.local = {pose_.at(point).x.to_double(), pose_.at(point).y.to_double()};
        }
        for (const Joint& joint : mechanism_.joints) {
            Positions::JointRule& rule = moving_.joints.emplace_back();
            const std::size_t index = at_index(mechanism_.index_of(joint));
            if (joint.pair().has_common_point()) continue;
            rule.bodies = {joint.bodies[0], joint.bodies[1]};
            rule.point = joint.point;
            rule.turns_with = frame;
            rule.guide = closing::rough(pose_.guides[index]);
            rule.tangent = closing::rough(pose_.tangents[index]);
            rule.touches = joint.pair().touches();
        }
    }
    void put_closure(const Positions& positions) {
        moving_.unit = positions.size();
        moving_.rows = positions.rows();
        moving_.bodies = positions.bodies();
        moving_.frozen = positions.frozen();
        moving_.points = positions.point_rules();
        moving_.joints = positions.joint_rules();
    }
    /// Evenly spaced; near a limit, where positions vary as the root of the distance, each interval is half the last
    /// one.
    static std::vector<double> ways_of(const MovingCourse& course) {
        std::vector<double> shares;
        for (int i = 0; i <= samples_of_way; ++i) shares.push_back(static_cast<double>(i) / samples_of_way);
        if (!course.by_law) {
            const double drawn = (0 - course.travel.from) / (course.travel.to - course.travel.from);
            if (drawn >= 0 && drawn <= 1) shares.push_back(drawn);
            for (double near = 0.5 / samples_of_way; near > short_of_limit; near /= 2) {
                if (course.travel.starts_at_limit) shares.push_back(near);
                if (course.travel.ends_at_limit) shares.push_back(1 - near);
            }
            for (double& share : shares)
                share = std::clamp(share, course.travel.starts_at_limit ? short_of_limit : 0,
                                   course.travel.ends_at_limit ? 1 - short_of_limit : 1);
        }
        std::sort(shares.begin(), shares.end());
        shares.erase(std::unique(shares.begin(), shares.end()), shares.end());
        std::vector<double> ways;
        for (const double share : shares) ways.push_back(course.travel.at(share));
        return ways;
    }

    void add_sample(MovingCourse& course, Positions& positions, const Driver& given, double at) {
        MovingCourse::Sample sample;
        sample.at = sample.coordinate = at;
        std::optional<Rates> rates;
        if (const Law* law = law_of(given)) {
            const double drawn = law->drawn.to_double();
            const LawState state = law->at(drawn + at);
            sample.coordinate = state.s - law->at(drawn).s;
            sample.rate = state.first;
            sample.acceleration = state.second;
            rates = Rates{Exact::from_double(state.first), Exact::from_double(state.second)};
        }
        if (!positions.move_to(sample.coordinate)) return;
        sample.q = positions.state();
        if (!positions.is_singular()) find_plan(sample, positions, course.driver, rates);
        course.samples.push_back(std::move(sample));
    }

    /// Uses the first existing plan whose guards hold here, else makes a new one.
    void find_plan(MovingCourse::Sample& sample, Positions& positions, int driver, const std::optional<Rates>& rates) {
        if (sample.coordinate == 0 && !rates) {
            sample.plan = 0;
            return;
        }
        auto repositioned = mover_->moved(positions, Exact::from_double(sample.coordinate));
        if (!repositioned) return;
        Repositioned& moved = *repositioned;
        if (rates)
            moved.mechanism.drivers[at_index(driver)] = with_rates(moved.mechanism.drivers[at_index(driver)], *rates);
        for (std::size_t i = 0; i < moving_.plans.size(); ++i) {
            const std::size_t tried = (i + last_) % moving_.plans.size();
            if (!replays(moving_.plans[tried], moved.mechanism, moved.pose)) continue;
            last_ = tried;
            sample.plan = static_cast<int>(tried);
            return;
        }
        const Solution solution =
            solve(std::move(moved.mechanism), std::move(moved.pose), [&moved] { return moved.finer; });
        MovingPlan plan = Planned(solution, moving_.columns).plan(rules_, !is_displaced_);
        if (moving_.plans.size() < most_plans && replays(plan, solution.mechanism, solution.pose)) {
            last_ = moving_.plans.size();
            sample.plan = static_cast<int>(last_);
            moving_.plans.push_back(std::move(plan));
        } else {
            sample.values = values_of(solution);
        }
    }
    static bool replays(const MovingPlan& plan, const Mechanism& mechanism, const Pose& pose) {
        return !Replay(plan.program, givens_of(plan.program, mechanism, pose), pose.size.to_double()).run();
    }
    /// Omits values that depend on the position only.
    std::vector<std::optional<double>> values_of(const Solution& solution) const {
        const std::vector<FoundValue> entries = found_values(solution);
        std::vector<std::optional<double>> values;
        for (const Column& column : moving_.columns) {
            const Quantity& q = column.quantity;
            const auto entry = std::find_if(entries.begin(), entries.end(),
                                            [&](const FoundValue& each) { return each.quantity == q; });
            std::optional<double>& value = values.emplace_back();
            if (entry == entries.end()) continue;
            if (column.kind == Column::Kind::along) {
                const auto rough = [&](const std::vector<Vector>& list) {
                    const Vector& v = list[at_index(q.joint)];
                    return VectorOf<double>{v.x.to_double(), v.y.to_double()};
                };
                const Pose& pose = solution.pose;
                value = dot(direction_of_sliding(rough(pose.guides), rough(pose.tangents), rough(pose.normals)),
                            entry->vector);
            } else if (column.kind == Column::Kind::result) {
                value = q.component == Quantity::Component::whole ? entry->scalar
                        : q.component == Quantity::Component::x   ? entry->vector.x
                                                                  : entry->vector.y;
            }
        }
        return values;
    }

    const Solution& solution_;
    const Mechanism& mechanism_;
    const Pose& pose_;
    std::optional<Mover> mover_;  ///< of what moves
    MovingRules rules_;
    bool is_displaced_;
    Moving moving_;
    std::size_t last_ = 0;
};

}  // namespace

bool is_beyond_moving(const Mechanism& mechanism) {
    return mechanism.bodies.size() > most_moved_bodies || mechanism.drivers.size() > most_moved_drivers;
}

std::optional<Moving> moving_of(const Solution& solution, const Rereading& rereading) {
    if (stands_for_joints(solution.mechanism) || solution.mechanism.drivers.empty()) return std::nullopt;
    if (!solution.mechanism.cam_file.empty() || is_beyond_moving(solution.mechanism)) return std::nullopt;
    return Courses(solution).moving(rereading);
}

std::optional<Moving> standing_of(const Solution& solution) {
    const Mechanism& mechanism = solution.mechanism;
    if (stands_for_joints(mechanism) || !mechanism.drivers.empty() || is_beyond_moving(mechanism)) return std::nullopt;
    if (!mechanism.cam_file.empty()) return std::nullopt;
    if (!solution.free_bodies.empty() || solution.truss || solution.instantaneous_motion)
        return Courses(solution).standing();
    if (!solution.displacements || solution.displacements->freedoms.empty()) return std::nullopt;
    return Courses(*solution.displacements->freedoms.front().moved, true).moving({});
}

}  // namespace kinegraph
