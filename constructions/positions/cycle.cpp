#include "constructions/positions/cycle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <list>
#include <numbers>
#include <utility>

#include "constructions/positions/effort_columns.hpp"
#include "constructions/positions/givens_here.hpp"
#include "constructions/positions/named_results.hpp"
#include "constructions/positions/row_check.hpp"
#include "constructions/solving/solve.hpp"
#include "engine/board/replay.hpp"
#include "engine/mechanism/drivers.hpp"
#include "engine/motion/repositioned.hpp"
#include "engine/results/result_names.hpp"
#include "engine/solution/sliding.hpp"

namespace kinegraph {
namespace {

using Spot = VectorOf<double>;
using Kind = Quantity::Kind;

/// The results to find at each position: the file's `find` without those that have no column.
Find found_in_rows(const Mechanism& mechanism) {
    const Find& asked = mechanism.find;
    Find find;
    find.stated = true;
    const bool whole_motion = !asked.stated || !asked.relative_motion.empty() || asked.curvature || asked.equations ||
                              (asked.virtual_work && mechanism.inertia_forces);
    find.velocity = whole_motion || asked.velocity;
    find.acceleration = whole_motion || asked.acceleration;
    find.forces = !asked.stated || asked.forces;
    find.virtual_work = asked.virtual_work && !mechanism.efforts.empty();
    return find;
}

/// A planned position: its record in doubles, the givens that change, and the element for each column.
struct PlannedPosition {
    struct Source {
        bool known = false;
        ElementIndex element;
    };
    Replay replay;
    std::vector<std::pair<int, Given>> moving;  ///< with their index in the program
    std::vector<Source> sources;                ///< by column
};

}  // namespace

// --- rows

class Cycle::Rows {
public:
    Rows(const Mechanism& mechanism, const Pose& pose, const Course& course, Positions positions)
        : mechanism_(mechanism),
          pose_(pose),
          driver_(course.driver),
          law_(law_of(mechanism.drivers[at_index(driver_)])),
          positions_(std::move(positions)),
          mover_(mechanism, pose),
          givens_(mechanism, pose),
          efforts_(mechanism, givens_),
          check_(mechanism) {
        const Driver& given = mechanism.drivers[at_index(driver_)];
        turns_ = turns(given);
        rate_ = rate_along(course);
        if (law_ != nullptr) drawn_ = {law_->drawn.to_double(), law_->at(law_->drawn.to_double()).s};
        find_directions();
    }

    std::vector<Unsolved> begin(const Travel& travel, bool checked) {
        is_checked_ = checked;
        // Irrational fractions of the travel, to avoid special positions.
        for (const double share : {0.381966, 0.618034, 0.236068, 0.854102}) {
            if (!go_to(travel.at(share))) continue;
            Solution solution = planned_here();
            columns_ = {{Column::Kind::turn, {}, "turn", turns_ ? QuantityKind::angle : QuantityKind::length}};
            if (law_ != nullptr || rate_ != 0) columns_.push_back({Column::Kind::time, {}, "time", QuantityKind::time});
            for (Column& column : columns_found(solution)) columns_.push_back(std::move(column));
            efforts_.add(solution, columns_);
            values_.resize(columns_.size());
            solution.mechanism.find = mechanism_.find;
            check_.begin(solution.mechanism, solution.pose);
            has_forces_ = !solution.forces.empty() || !solution.efforts.empty();
            std::vector<Unsolved> missing = solution.unsolved;
            keep(solution);
            return missing;
        }
        return {};
    }

    std::optional<std::span<const double>> row(double at) {
        if (!go_to(at)) return std::nullopt;
        PlannedPosition* plan = replayed();
        if (plan != nullptr && !fill(*plan)) return std::nullopt;
        if (plan == nullptr || !efforts_.replay(places_, positions_, values_)) {
            // Guards evaluated in doubles may fail in a nearly special position (a body nearly at rest), but its exact
            // values are valid.
            const Solution solution = planned_here();
            keep(solution);
            if (!fill_from(solution)) return std::nullopt;
            efforts_.take(solution);
        }
        if (!efforts_.fill(values_)) return std::nullopt;
        if (is_checked_) {
            put_rates(check_.mechanism());
            check_.compare({columns_, values_, places_, positions_, has_forces_ || !efforts_.empty()});
        }
        return values_;
    }

    /// Near a limit positions vary as the root of the distance from it. Two positions, one four times as far as the
    /// other, give the limit by Richardson's extrapolation.
    std::vector<std::optional<double>> at_limit(double limit, double inward) {
        constexpr double near = 1e-8;  // relative to the travel; the limit is computed to 1e-9
        // Restored in the end, because a position at a limit is a poor start for the next one.
        const Positions before = positions_;
        const auto places = [&](double share) {
            std::vector<std::optional<double>> values(columns_.size());
            if (!positions_.move_to(limit + share * inward)) return values;
            positions_.read(places_);
            for (std::size_t i = 0; i < columns_.size(); ++i) values[i] = place_value(columns_[i]);
            return values;
        };
        const auto far = places(4 * near), close = places(near);
        positions_ = before;
        std::vector<std::optional<double>> values(columns_.size());
        for (std::size_t i = 0; i < columns_.size(); ++i)
            if (far[i] && close[i]) values[i] = 2 * *close[i] - *far[i];
        if (values[0]) values[0] = limit;
        return values;
    }

    Difference difference() const {
        const LargestDifference::Found found = check_.largest().found(columns_, pose_.size.to_double());
        return {found.share, found.column, found.coordinate};
    }
    Positions& positions() { return positions_; }
    const std::vector<Column>& columns() const { return columns_; }
    int plans() const { return planned_; }

private:
    /// The driver's rate if it can serve as a clock: it is constant, and other moving drivers have proportional rates.
    /// Else zero.
    double rate_along(const Course& course) const {
        const auto rates = [&](int driver) { return rates_of(mechanism_.drivers[at_index(driver)]); };
        const Rates own = rates(course.driver);
        for (const Course::Along& each : course.along) {
            const double along = each.per.to_double() * own.first.to_double();
            if (std::abs(rates(each.driver).first.to_double() - along) > 1e-9 * std::abs(along)) return 0;
        }
        return own.second.is_zero() ? own.first.to_double() : 0;
    }
    /// False if the position cannot be reached or is not unique.
    bool go_to(double at) {
        double coordinate = at;
        if (law_ != nullptr) {
            state_ = law_->at(drawn_.first + at);
            coordinate = state_.s - drawn_.second;
            time_ = at;
        }
        if (!positions_.move_to(coordinate) || positions_.is_singular()) return false;
        positions_.read(places_);
        return true;
    }
    /// Sets the rates of the law in a mechanism moved to this position.
    void put_rates(Mechanism& moved) const {
        if (law_ == nullptr) return;
        Driver& driver = moved.drivers[at_index(driver_)];
        driver = with_rates(std::move(driver), {Exact::from_double(state_.first), Exact::from_double(state_.second)});
    }

    /// For each body: the direction from its first point to its second, as drawn.
    void find_directions() {
        for (const Body& body : mechanism_.bodies) {
            double angle = 0;
            for (std::size_t i = 1; i < body.points.size() && angle == 0; ++i) {
                const Spot along = to_double(pose_.at(body.points[i]) - pose_.at(body.points[0]));
                if (along.x != 0 || along.y != 0) {
                    angle = std::atan2(along.y, along.x);
                    break;
                }
            }
            directions_.push_back(angle);
        }
    }

    // --- by record
    Solution planned_here() {
        ++planned_;
        Repositioned moved = mover_.moved(positions_, Exact::from_double(positions_.coordinate()));
        moved.mechanism.find = found_in_rows(mechanism_);
        put_rates(moved.mechanism);
        return solve(std::move(moved.mechanism), std::move(moved.pose), [&moved] { return moved.finer; });
    }

    PlannedPosition& keep(const Solution& solution) {
        if (solution.displacements) efforts_.keep(*solution.displacements);
        const std::vector<FoundValue> entries = found_values(solution);
        std::vector<ElementIndex> wanted;
        for (const FoundValue& entry : entries)
            if (entry.element != none) wanted.push_back(entry.element);
        const Cut record = cut(solution.protocol.program, wanted,
                               has_forces_ ? solution.settled.forces : solution.settled.accelerations);
        PlannedPosition plan{Replay(record.program, givens_of(record.program, solution.mechanism, solution.pose),
                                    solution.pose.size.to_double()),
                             {},
                             std::vector<PlannedPosition::Source>(columns_.size())};
        for (std::size_t i = 0; i < record.program.givens.size(); ++i)
            if (hangs_here(record.program.givens[i]))
                plan.moving.emplace_back(static_cast<int>(i), record.program.givens[i]);
        for (std::size_t i = 0; i < columns_.size(); ++i) {
            const auto found = std::find_if(entries.begin(), entries.end(), [&](const FoundValue& entry) {
                return entry.quantity == columns_[i].quantity;
            });
            if (found == entries.end()) continue;
            plan.sources[i] = {true,
                               found->element == none ? ElementIndex() : record.element[at_index(found->element)]};
        }
        // Records of special positions (a right angle, a body at rest) are valid nowhere else; the oldest are dropped.
        constexpr std::size_t most = 24;
        if (kept_.size() == most) kept_.pop_back();
        kept_.push_front(std::move(plan));
        return kept_.front();
    }

    /// Replays plans until the guards of one hold; the last one used is tried first.
    PlannedPosition* replayed() {
        for (auto plan = kept_.begin(); plan != kept_.end(); ++plan) {
            if (replays(*plan)) continue;
            if (plan != kept_.begin()) kept_.splice(kept_.begin(), kept_, plan);
            return &kept_.front();
        }
        return nullptr;
    }
    /// The guard that failed, if any.
    std::optional<int> replays(PlannedPosition& plan) {
        for (const auto& [index, given] : plan.moving) plan.replay.give(index, value_here(given));
        return plan.replay.run();
    }

    bool hangs_here(const Given& given) const {
        if (given.kind == Given::Kind::driver_velocity || given.kind == Given::Kind::driver_acceleration)
            return static_cast<int>(given.index) == driver_ && law_ != nullptr;
        return givens_.hangs(given);
    }
    ValueOf<double> value_here(const Given& given) const {
        if (given.kind == Given::Kind::driver_velocity) return state_.first;
        if (given.kind == Given::Kind::driver_acceleration) return state_.second;
        return givens_.value(given, places_, positions_);
    }

    bool fill(const PlannedPosition& plan) {
        return fill_each([&](std::size_t i) -> std::optional<std::pair<Spot, double>> {
            const auto& [known, element] = plan.sources[i];
            if (!known) return std::nullopt;
            if (element == none) return std::pair{Spot{}, 0.0};
            return std::pair{plan.replay.vector(element), plan.replay.scalar(element)};
        });
    }
    bool fill_from(const Solution& solution) {
        const std::vector<FoundValue> entries = found_values(solution);
        return fill_each([&](std::size_t i) -> std::optional<std::pair<Spot, double>> {
            for (const FoundValue& entry : entries)
                if (entry.quantity == columns_[i].quantity) return std::pair{entry.vector, entry.scalar};
            return std::nullopt;
        });
    }
    /// `found(i)` is the vector or scalar for column i. False if one is missing or not finite.
    template <class Found>
    bool fill_each(Found found) {
        for (std::size_t i = 0; i < columns_.size() - efforts_.size(); ++i) {
            const auto place = place_value(columns_[i]);
            const auto result = place ? std::nullopt : found(i);
            if (!place && !result) return false;
            values_[i] = place ? *place : part_of(columns_[i], result->first, result->second);
            if (!std::isfinite(values_[i])) return false;
        }
        return true;
    }
    /// Values that depend on the position only.
    std::optional<double> place_value(const Column& column) const {
        const Quantity& q = column.quantity;
        switch (column.kind) {
            case Column::Kind::turn: return positions_.coordinate();
            case Column::Kind::time: return law_ != nullptr ? time_ : positions_.coordinate() / rate_;
            case Column::Kind::angle: return directions_[at_index(q.body)] + positions_.turn(q.body);
            case Column::Kind::place_x: return places_.points[at_index(q.point)].x;
            case Column::Kind::place_y: return places_.points[at_index(q.point)].y;
            case Column::Kind::slid: return positions_.slid(q.joint);
            default: return std::nullopt;
        }
    }
    double part_of(const Column& column, const Spot& vector, double scalar) const {
        if (column.kind == Column::Kind::along)
            return dot(direction_of_sliding(places_, column.quantity.joint), vector);
        if (column.quantity.component == Quantity::Component::whole) return scalar;
        return column.quantity.component == Quantity::Component::x ? vector.x : vector.y;
    }

    const Mechanism& mechanism_;
    const Pose& pose_;
    int driver_;
    const Law* law_;                         ///< null: the rates are those of the file
    std::pair<double, double> drawn_{0, 0};  ///< time and coordinate of the law in the drawn position
    LawState state_;                         ///< of the law, here
    double time_ = 0;                        ///< since the drawn position, by the law
    bool turns_ = true;
    double rate_ = 0;  ///< zero: no time
    Positions positions_;
    Mover mover_;
    GivensHere givens_;
    EffortColumns efforts_;
    std::vector<double> directions_;
    Places places_;
    std::vector<Column> columns_;
    std::vector<double> values_;
    bool has_forces_ = false, is_checked_ = true;
    std::list<PlannedPosition> kept_;
    int planned_ = 0;
    RowCheck check_;
};

Cycle::Cycle(std::unique_ptr<Rows> rows) : rows_(std::move(rows)) {}
Cycle::Cycle(Cycle&&) noexcept = default;
Cycle::~Cycle() = default;

Result<Cycle> Cycle::of(const Mechanism& mechanism, const Pose& pose, const Course& course) {
    auto positions = Positions::of(mechanism, pose, course);
    if (!positions) return tl::unexpected(std::move(positions.error()));
    return Cycle(std::make_unique<Rows>(mechanism, pose, course, *std::move(positions)));
}

const Positions& Cycle::positions() const { return rows_->positions(); }
std::vector<Unsolved> Cycle::begin(const Travel& travel, bool checked) { return rows_->begin(travel, checked); }
const std::vector<Column>& Cycle::columns() const { return rows_->columns(); }
std::optional<std::span<const double>> Cycle::row(double at) { return rows_->row(at); }
std::vector<std::optional<double>> Cycle::at_limit(double limit, double inward) {
    return rows_->at_limit(limit, inward);
}
Cycle::Difference Cycle::difference() const { return rows_->difference(); }
int Cycle::plans() const { return rows_->plans(); }

// --- travel

namespace {

constexpr double full_turn = 2 * std::numbers::pi;

}  // namespace

tl::expected<Travel, TravelFault> travel_of(const Positions& positions, bool turns, std::optional<double> from,
                                            std::optional<double> to) {
    Positions tried = positions;
    Travel travel;
    const auto note_change_points = [&] {
        for (const double each : tried.change_points())
            if (std::find(travel.change_points.begin(), travel.change_points.end(), each) == travel.change_points.end())
                travel.change_points.push_back(each);
    };
    const auto out_of_reach = [&](double wanted) {
        return tl::unexpected(TravelFault{wanted, tried.limit().value_or(tried.coordinate())});
    };
    // By default to the limits; a full turn at most if both ends are free.
    const double far = turns ? 64 * full_turn : 100 * positions.size();
    if (from) {
        if (!tried.move_to(*from)) return out_of_reach(*from);
        travel.from = *from;
    }
    if (to) {
        if (!tried.move_to(*to)) return out_of_reach(*to);
        travel.to = *to;
    } else {
        const double wanted = turns ? (from ? *from : 0) + full_turn : far;
        travel.ends_at_limit = !tried.move_to(wanted);
        if (!travel.ends_at_limit && !turns) return tl::unexpected(TravelFault{});
        travel.to = travel.ends_at_limit ? *tried.limit() : wanted;
    }
    note_change_points();
    if (!from && !to && travel.ends_at_limit) {
        tried = positions;
        travel.starts_at_limit = !tried.move_to(-far);
        if (!travel.starts_at_limit) return tl::unexpected(TravelFault{});
        travel.from = *tried.limit();
        note_change_points();
    }
    std::sort(travel.change_points.begin(), travel.change_points.end());
    std::erase_if(travel.change_points, [&](double each) {
        return each < std::min(travel.from, travel.to) - 1e-9 || each > std::max(travel.from, travel.to) + 1e-9;
    });
    return travel;
}

tl::expected<Travel, TravelFault> travel_of_law(const Positions& positions, const Law& law, std::optional<double> from,
                                                std::optional<double> to) {
    const double drawn = law.drawn.to_double(), way = law.at(drawn).s;
    Travel travel;
    travel.times = {from.value_or(0 - drawn), to.value_or(law.length() - drawn)};
    // The extremes are at the ends of the law, or where two pieces meet.
    const auto [first, last] = std::minmax({travel.times->first + drawn, travel.times->second + drawn});
    std::vector<double> turning_points{law.at(first).s - way, law.at(last).s - way};
    double end = 0;
    for (const LawPiece& piece : law.pieces) {
        end += piece.over.to_double();
        if (end > first && end < last) turning_points.push_back(law.at(end).s - way);
    }
    const auto [least, most] = std::minmax_element(turning_points.begin(), turning_points.end());
    travel.from = *least;
    travel.to = *most;
    Positions tried = positions;
    for (const double each : {travel.from, travel.to})
        if (!tried.move_to(each)) return tl::unexpected(TravelFault{each, tried.limit().value_or(tried.coordinate())});
    travel.change_points = tried.change_points();
    std::sort(travel.change_points.begin(), travel.change_points.end());
    return travel;
}

// --- transmission angle

namespace {

/// A coupler, the pin B at which it drives the follower, the pin A at which it is driven, and the follower's hinge or
/// guide on the frame.
struct Chain {
    PointIndex a, b, hinge;
    JointIndex pin, guide;  // pin: the joint at B
    BodyIndex coupler, follower;
};

/// Breadth-first from the driven bodies, through gears, rolling contacts and welds: a coupler is driven at the first
/// pin reached, and drives all followers at its other pins; the search goes on from these. A coupler that a driver
/// moves drives its followers too, but no force has to pass along it from pin to pin: it has no transmission angle.
class Couplers {
public:
    Couplers(const Mechanism& mechanism, int driver) : mechanism_(mechanism) {
        for (const Driver& each : mechanism.drivers)
            for (const BodyIndex body : moved_by(each)) driven_.push_back(body);
        for (const BodyIndex body : moved_by(mechanism.drivers[at_index(driver)])) reach(body);
        // the call appends to the list
        for (std::size_t next = 0; next < reached_.size();) go_on_from(reached_[next++]);
    }
    std::vector<Chain> all() && { return std::move(chains_); }

private:
    /// The bodies between which the driver acts, without the frame.
    std::vector<BodyIndex> moved_by(const Driver& driver) const {
        std::vector<BodyIndex> bodies;
        if (const auto* spin = std::get_if<SpinDriver>(&driver)) bodies = {spin->body, spin->relative_to};
        if (const auto* slide = std::get_if<SlideDriver>(&driver)) bodies = mechanism_.joint(slide->joint).bodies;
        if (const auto* point = std::get_if<PointDriver>(&driver)) bodies = {point->body};
        std::erase(bodies, frame);
        return bodies;
    }
    void reach(BodyIndex body) {
        if (is_reached(body)) return;
        reached_.push_back(body);
        if (is_driven(body) && !on_frame(body)) push_followers(body, nullptr);
    }
    void go_on_from(BodyIndex body) {
        for (const Joint& joint : mechanism_.joints) {
            if (!joint.connects(body)) continue;
            const PlanePair& pair = joint.pair();
            for (const BodyIndex other : joint.bodies) {
                if (other == frame || is_reached(other)) continue;
                if (pair.is_clamp() || ((pair.meshes() || pair.rolls()) && on_frame(other))) {
                    reach(other);
                } else if (pair.is_hinge() && !on_frame(other)) {
                    reach(other);
                    if (!is_driven(other)) push_followers(other, &joint);
                }
            }
        }
    }
    /// `from`: the joint that drives the coupler; null where a driver does.
    void push_followers(BodyIndex coupler, const Joint* from) {
        for (const Joint& pin : mechanism_.joints) {
            if (!pin.pair().is_hinge() || &pin == from || !pin.connects(coupler)) continue;
            for (const BodyIndex follower : pin.bodies) {
                const Joint* foot = follower == frame || is_reached(follower) ? nullptr : foot_of(follower);
                if (foot == nullptr) continue;
                const bool hinged = foot->pair().is_hinge();
                if (from != nullptr)
                    chains_.push_back({from->point, pin.point, hinged ? foot->point : PointIndex(none),
                                       mechanism_.index_of(pin), hinged ? JointIndex(none) : mechanism_.index_of(*foot),
                                       coupler, follower});
                reach(follower);
            }
        }
    }
    bool is_reached(BodyIndex body) const {
        return std::find(reached_.begin(), reached_.end(), body) != reached_.end();
    }
    bool is_driven(BodyIndex body) const { return std::find(driven_.begin(), driven_.end(), body) != driven_.end(); }
    bool on_frame(BodyIndex body) const {
        return std::any_of(mechanism_.joints.begin(), mechanism_.joints.end(),
                           [&](const Joint& joint) { return joint.connects(body) && joint.connects(frame); });
    }
    const Joint* foot_of(BodyIndex follower) const {
        for (const Joint& joint : mechanism_.joints)
            if (joint.connects(follower) && joint.connects(frame) &&
                (joint.pair().is_hinge() || joint.pair().is_sleeve()))
                return &joint;
        return nullptr;
    }

    const Mechanism& mechanism_;
    std::vector<BodyIndex> driven_;  ///< by any driver
    std::vector<BodyIndex> reached_;
    std::vector<Chain> chains_;
};

Transmission least_of(const Chain& chain, Positions positions, const Travel& travel) {
    Places places;
    const auto angle_of = [&](Positions& there, double coordinate) -> double {
        if (!there.move_to(coordinate)) return std::numbers::pi;
        there.read(places);
        const auto at = [&](PointIndex point) { return places.points[at_index(point)]; };
        const Spot rod = at(chain.b) - at(chain.a);
        const Spot link =
            chain.guide == none ? at(chain.hinge) - at(chain.b) : quarter_turn(places.guides[at_index(chain.guide)]);
        return std::atan2(std::abs(cross(rod, link)), std::abs(dot(rod, link)));
    };
    const auto angle = [&](double coordinate) { return angle_of(positions, coordinate); };
    // As in at_limit(): by two positions near it, of a copy: from a limit no other position is reached.
    const auto angle_at_limit = [&](double limit, double inward) {
        constexpr double near = 1e-6;
        Positions there = positions;
        const double far = angle_of(there, limit + 4 * near * inward), close = angle_of(there, limit + near * inward);
        return std::max(far, close) < std::numbers::pi ? std::max(2 * close - far, 0.0) : std::numbers::pi;
    };
    constexpr int samples = 360;
    const double way = travel.to - travel.from, step = way / samples;
    Transmission found{chain.coupler, chain.follower, chain.pin, std::numbers::pi, 0};
    for (int i = 0; i <= samples; ++i) {
        const double coordinate = i == samples ? travel.to : travel.from + i * step;
        const double here = i == 0 && travel.starts_at_limit       ? angle_at_limit(travel.from, way)
                            : i == samples && travel.ends_at_limit ? angle_at_limit(travel.to, -way)
                                                                   : angle(coordinate);
        if (here < found.least) found.least = here, found.at = coordinate;
    }
    // Between the neighbours of the smallest sample there is one minimum.
    const double low_end = std::min(travel.from, travel.to), high_end = std::max(travel.from, travel.to);
    double low = std::max(found.at - std::abs(step), low_end), high = std::min(found.at + std::abs(step), high_end);
    for (int i = 0; i < 60; ++i) {
        const double third = (high - low) / 3;
        (angle(low + third) < angle(high - third) ? high : low) =
            angle(low + third) < angle(high - third) ? high - third : low + third;
    }
    const double middle = (low + high) / 2;
    if (const double here = angle(middle); here < found.least) found.least = here, found.at = middle;
    return found;
}

}  // namespace

std::optional<Transmission> transmission_of(const Mechanism& mechanism, const Positions& positions, int driver,
                                            const Travel& travel) {
    std::optional<Transmission> least;
    for (const Chain& chain : Couplers(mechanism, driver).all())
        if (const Transmission found = least_of(chain, positions, travel); !least || found.least < least->least)
            least = found;
    return least;
}

std::optional<std::pair<Positions, Travel>> own_travel(const Mechanism& mechanism, const Pose& pose) {
    if (mechanism.drivers.empty()) return std::nullopt;
    auto positions = Positions::of(mechanism, pose, Course{0});
    if (!positions) return std::nullopt;
    const Driver& driver = mechanism.drivers.front();
    const Law* law = law_of(driver);
    const auto travel = law != nullptr ? travel_of_law(*positions, *law, std::nullopt, std::nullopt)
                                       : travel_of(*positions, turns(driver), std::nullopt, std::nullopt);
    if (!travel) return std::nullopt;
    return std::pair{*std::move(positions), *travel};
}

}  // namespace kinegraph
