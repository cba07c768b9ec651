#include "constructions/positions/cycle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "constructions/positions/driver_clock.hpp"
#include "constructions/positions/effort_columns.hpp"
#include "constructions/positions/expression_columns.hpp"
#include "constructions/positions/followed_columns.hpp"
#include "constructions/positions/givens_here.hpp"
#include "constructions/positions/kept_records.hpp"
#include "constructions/positions/named_results.hpp"
#include "constructions/positions/noise_levels.hpp"
#include "constructions/positions/pushing_contacts.hpp"
#include "constructions/positions/row_check.hpp"
#include "constructions/positions/smooth_stretches.hpp"
#include "constructions/solving/solve.hpp"
#include "engine/mechanism/drivers.hpp"
#include "engine/motion/repositioned.hpp"
#include "engine/number/functions.hpp"
#include "engine/results/result_names.hpp"
#include "engine/sentences/result_catalogue.hpp"
#include "engine/solution/sliding.hpp"

namespace kinegraph {
namespace {

using Spot = VectorOf<double>;
using Kind = Quantity::Kind;

/// The results to find at each position: the file's `find` without those that have no column.
Find found_in_rows(const Mechanism& mechanism, const std::vector<Column>& on_request) {
    const Find& asked = mechanism.find;
    Find find;
    find.stated = true;
    const bool whole_motion = !asked.stated || !asked.relative_motion.empty() || asked.curvature || asked.equations ||
                              (asked.virtual_work && mechanism.inertia_forces);
    find.velocity = whole_motion || asked.velocity;
    find.acceleration = whole_motion || asked.acceleration;
    find.forces = !asked.stated || asked.forces;
    find.virtual_work = asked.virtual_work && !mechanism.efforts.empty();
    for (const Column& each : on_request) {
        find.instant_centres = find.instant_centres || each.quantity.kind == Kind::centre;
        find.curvature = find.curvature || result_kind(each.quantity).is_of_curvature();
    }
    return find;
}

bool is_of_forces(const Column& column) { return result_kind(column.quantity).is_of_forces(); }

/// Radii and diameters, which are read between two elements of a record.
bool is_distance(const Column& column) {
    const ResultKind& kind = result_kind(column.quantity);
    return kind.is_of_curvature() && kind.shape == ResultKind::Shape::scalar;
}
/// Infinite where the point is at infinity.
double distance(const PointOf<double>& to, const Spot& from) {
    if (to.at_infinity()) return HUGE_VAL;
    const Spot apart = to.place() - from;
    return std::sqrt(dot(apart, apart));
}

/// Irrational fractions of the travel, to avoid special positions.
constexpr std::array sample_shares{0.381966, 0.618034, 0.236068, 0.854102};

/// For each body: the direction from its first point to its second, as drawn.
std::vector<double> drawn_directions(const Mechanism& mechanism, const Pose& pose) {
    std::vector<double> directions;
    for (const Body& body : mechanism.bodies) {
        double angle = 0;
        for (std::size_t i = 1; i < body.points.size() && angle == 0; ++i) {
            const Spot along = to_double(pose.at(body.points[i]) - pose.at(body.points[0]));
            if (along.x == 0 && along.y == 0) continue;
            angle = nearest::atan2(along.y, along.x);
            break;
        }
        directions.push_back(angle);
    }
    return directions;
}

}  // namespace

// --- rows

class Cycle::Rows {
public:
    Rows(const Mechanism& mechanism, const Pose& pose, const Course& course, Positions positions)
        : mechanism_(mechanism),
          pose_(pose),
          turns_(turns(mechanism.drivers[at_index(course.driver)])),
          clock_(mechanism, course),
          positions_(std::move(positions)),
          mover_(mechanism, pose),
          levels_(mechanism, pose),
          givens_(mechanism, pose),
          efforts_(mechanism, givens_),
          directions_(drawn_directions(mechanism, pose)),
          couplers_(transmission_columns(mechanism, course.driver)),
          check_(mechanism) {}

    std::vector<Unsolved> begin(const Travel& travel, bool checked, const std::vector<Column>& on_request) {
        is_checked_ = checked;
        on_request_ = on_request;
        for (const double share : sample_shares) {
            if (!go_to(travel.at(share))) continue;
            auto planned = planned_here();
            if (!planned) continue;
            Solution& solution = *planned;
            columns_ = {{Column::Kind::turn, {}, "turn", turns_ ? QuantityKind::angle : QuantityKind::length}};
            if (clock_.has_time()) columns_.push_back({Column::Kind::time, {}, "time", QuantityKind::time});
            for (Column& column : columns_found(solution))
                if (!result_kind(column.quantity).on_request) columns_.push_back(std::move(column));
            add_on_request(columns_found(solution, true));
            efforts_.add(solution, columns_);
            values_.resize(columns_.size());
            empty_.assign(columns_.size(), false);
            lacking_.assign(columns_.size(), false);
            contacts_ = pushing_contacts(mechanism_, columns_);
            teeth_ = meshing_teeth(mechanism_, columns_);
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
        std::fill(empty_.begin(), empty_.end(), false);
        for (std::size_t i = 0; i < followed_.columns.size(); ++i)
            empty_[i] = followed_.columns[i].is_pole(at, travelled_);
        if (std::find(empty_.begin(), empty_.end(), true) != empty_.end()) return row_on_pole(at);
        if (!find_values(at)) return std::nullopt;
        for (std::size_t i = 0; i < empty_.size(); ++i) empty_[i] = lacks_value(i);
        if (is_checked_) {
            clock_.put_rates(check_.mechanism());
            check_.compare({columns_, values_, noise_, empty_, places_, positions_, has_forces_ || !efforts_.empty()});
        }
        silence();
        return values_;
    }

    /// Rows do not depend on whether the columns were followed before: the positions and records are put back.
    const FollowedCycle& follow(const Travel& travel, const std::vector<std::size_t>& whole) {
        const bool is_first = followed_.columns.empty();
        const Positions here = positions_;
        KeptRecords kept = records_;
        const int planned = planned_;
        const std::vector<std::size_t> watched =
            with_values(is_first ? watched_columns(travel, whole) : not_yet_followed(whole), travel);
        followed_.columns.resize(columns_.size());
        travelled_ = travel.at(1) - travel.at(0);
        if (!watched.empty()) follow_watched(travel, watched, whole, is_first);
        positions_ = here;
        records_ = std::move(kept);
        planned_ = planned;
        return followed_;
    }
    void follow_watched(const Travel& travel, const std::vector<std::size_t>& watched,
                        const std::vector<std::size_t>& whole, bool is_first) {
        std::vector<FollowedCurve> curves;
        for (const auto& [stretch, intervals] : smooth_stretches(travel, turns_, clock_.law())) {
            curves.emplace_back(stretch, [&](double at) { return values_at(at, watched); });
            curves.back().sample(intervals);
            if (curves.back().nodes().empty()) curves.pop_back();
        }
        const FollowedColumns columns(std::move(curves));
        for (std::size_t i = 0; i < watched.size(); ++i)
            followed_.columns[watched[i]] =
                columns.column(i, std::find(whole.begin(), whole.end(), watched[i]) != whole.end());
        for (std::size_t i = 0; is_first && i < contacts_.size(); ++i)
            for (const auto& [from, to] : columns.negative(watched.size() + i))
                followed_.separations.push_back({contacts_[i].joint, from, to});
        for (std::size_t i = 0; is_first && i < teeth_.size(); ++i)
            for (const auto& [from, to] : columns.negative(watched.size() + contacts_.size() + i))
                for (const double each : {from, to}) {
                    constexpr double same = 1e-9;
                    const double off = std::min(std::abs(each - travel.at(0)), std::abs(each - travel.at(1)));
                    if (off > same * std::abs(travelled_)) flank_changes_.push_back({teeth_[i].joint, each});
                }
    }
    std::size_t add(const ResultExpression& expression) {
        const std::size_t column = expressions_.add(expression, columns_, mechanism_.parameters);
        values_.resize(columns_.size());
        empty_.resize(columns_.size());
        lacking_.resize(columns_.size());
        return column;
    }
    const std::vector<FlankChange>& flank_changes() const { return flank_changes_; }
    const std::vector<bool>& empty_cells() const { return empty_; }

    /// Near a limit positions vary as the root of the distance from it. Two positions, one four times as far as the
    /// other, give the limit by Richardson's extrapolation.
    std::vector<std::optional<double>> at_limit(double limit, double inward) {
        if (columns_.empty()) return {};
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
        const std::vector<double> noise = levels_.of_row(columns_, {});
        for (std::size_t i = 0; i < columns_.size(); ++i)
            if (values[i] && std::abs(*values[i]) < noise[i]) values[i] = 0;
        return values;
    }

    Difference difference() const {
        const LargestDifference::Found found = check_.largest().found(columns_, pose_.size.to_double());
        return {found.share, found.column, found.coordinate};
    }
    Positions& positions() { return positions_; }
    const std::vector<Column>& columns() const { return columns_; }
    int plans() const { return planned_; }
    bool is_spent() const { return all_planned_ > always_planned && spent_ > most_planned_bits; }

private:
    /// Sets values_ to the row at this position; false if the mechanism gives no unique answer.
    bool find_values(double at) {
        if (is_spent() || !go_to(at)) return false;
        const KeptRecords::Record* record = records_.replayed([&](const Given& given) { return value_here(given); });
        if (record != nullptr && !fill(*record)) return false;
        if (record == nullptr || !efforts_.replay(places_, positions_, values_)) {
            // Guards evaluated in doubles may fail in a nearly special position (a body nearly at rest), but its exact
            // values are valid.
            const std::optional<Solution> solution = planned_here();
            if (!solution) return false;
            keep(*solution);
            if (!fill_from(*solution)) return false;
            efforts_.take(*solution);
        }
        if (!efforts_.fill(values_, expressions_.size())) return false;
        finish_row();
        return true;
    }
    /// The noise of the row's values, and the expressions of them.
    void finish_row() {
        noise_ = levels_.of_row(columns_, values_);
        expressions_.fill(values_, noise_, lacking_, mechanism_.parameters);
    }
    /// Whether the last row has no value in a column.
    bool lacks_value(std::size_t column) const { return lacking_[column] || expressions_.is_undetermined(column); }

    /// What is noise of the arithmetic is zero.
    void silence() {
        for (std::size_t i = 0; i < values_.size(); ++i)
            if (std::abs(values_[i]) < noise_[i]) values_[i] = 0;
    }

    /// On a pole of some columns. Forces that have none are computed there from parts that grow, so they are
    /// interpolated from four positions beside it.
    std::optional<std::span<const double>> row_on_pole(double at) {
        const double step = 1e-4 * travelled_;
        std::vector<double> row(columns_.size());
        for (const auto& [steps, share] : {std::pair(-2, -1), {-1, 4}, {1, 4}, {2, -1}}) {
            if (!find_values(at + steps * step)) return std::nullopt;
            for (std::size_t i = 0; i < row.size(); ++i) row[i] += share * values_[i] / 6;
        }
        if (!go_to(at)) return std::nullopt;
        values_ = row;
        // What is found without forces is exact here.
        if (const std::optional<Solution> solution = planned_here()) fill_from(*solution);
        for (std::size_t i = 0; i < row.size(); ++i)
            if (empty_[i] || is_of_forces(columns_[i])) values_[i] = empty_[i] ? 0 : row[i];
        finish_row();
        for (std::size_t i = 0; i < row.size(); ++i) {
            empty_[i] = empty_[i] || lacks_value(i) || expressions_.lacks_part(i, empty_);
            if (empty_[i]) values_[i] = 0;
        }
        silence();
        return values_;
    }

    // --- columns as functions
    /// The watched columns, and after them the forces with which contacts push, and those that teeth transmit.
    std::optional<FollowedCurve::Values> values_at(double at, const std::vector<std::size_t>& watched) {
        if (!find_values(at)) return std::nullopt;
        const auto lacks = [&](std::size_t column) { return lacks_value(column); };
        if (std::any_of(watched.begin(), watched.end(), lacks)) return std::nullopt;
        constexpr double grains = 0x1p7;  // in noise: near a limit velocities have lost some digits
        const double noise_of_forces = levels_.of_forces(columns_, values_);
        silence();
        FollowedCurve::Values found;
        for (const std::size_t i : watched) {
            found.values.push_back(values_[i]);
            found.grains.push_back(grains * noise_[i]);
        }
        for (const PushingContact& each : contacts_) {
            found.values.push_back(each.push(values_, givens_, places_));
            found.grains.push_back(grains * noise_of_forces);
        }
        for (const PushingContact& each : teeth_) {
            found.values.push_back(each.push(values_, places_.tangents[at_index(each.joint)]));
            found.grains.push_back(grains * noise_of_forces);
        }
        return found;
    }
    /// Those that have a value somewhere: not a quotient by what is always zero, not a centre that stays at infinity.
    std::vector<std::size_t> with_values(std::vector<std::size_t> columns, const Travel& travel) {
        if (expressions_.size() == 0 && on_request_.empty()) return columns;
        std::vector<std::size_t> without = columns;
        for (const double share : sample_shares)
            if (find_values(travel.at(share)))
                std::erase_if(without, [&](std::size_t column) { return !lacks_value(column); });
        std::erase_if(columns, [&](std::size_t column) {
            return std::find(without.begin(), without.end(), column) != without.end();
        });
        return columns;
    }
    std::vector<std::size_t> not_yet_followed(const std::vector<std::size_t>& whole) const {
        std::vector<std::size_t> missing;
        for (const std::size_t i : whole)
            if (!followed_.columns[i].is_followed && std::find(missing.begin(), missing.end(), i) == missing.end())
                missing.push_back(i);
        return missing;
    }
    /// Quantities that may have a pole, and all that is asked.
    std::vector<std::size_t> watched_columns(const Travel& travel, const std::vector<std::size_t>& whole) const {
        const bool ends = travel.starts_at_limit || travel.ends_at_limit;
        std::vector<std::size_t> watched;
        for (std::size_t i = 0; i < columns_.size(); ++i) {
            const bool is_result = columns_[i].kind == Column::Kind::result || columns_[i].kind == Column::Kind::along;
            // An expression may divide by what vanishes, and a centre go to infinity.
            const bool may_grow = is_of_forces(columns_[i]) || result_kind(columns_[i].quantity).on_request || ends;
            if (columns_[i].kind == Column::Kind::named || (is_result && may_grow) ||
                std::find(whole.begin(), whole.end(), i) != whole.end())
                watched.push_back(i);
        }
        return watched;
    }
    /// False if the position cannot be reached or is not unique.
    bool go_to(double at) {
        if (!positions_.move_to(clock_.go_to(at)) || positions_.is_singular()) return false;
        positions_.read(places_);
        return true;
    }
    /// Those of the columns on request that are not there: of actions, which a solution has or has not, the reactions.
    void add_on_request(const std::vector<Column>& found) {
        const auto is_in = [](const std::vector<Column>& columns, const Column& column) {
            return std::any_of(columns.begin(), columns.end(),
                               [&](const Column& each) { return each.name == column.name; });
        };
        for (const Column& column : on_request_)
            if (result_kind(column.quantity).on_request || (is_in(found, column) && !is_in(columns_, column)))
                columns_.push_back(column);
    }

    // --- by record
    std::optional<Solution> planned_here() {
        ++planned_;
        ++all_planned_;
        const std::size_t refined_before = positions_.refined_bits();
        auto repositioned = mover_.moved(positions_, Exact::from_double(positions_.coordinate()));
        spent_ += positions_.refined_bits() - refined_before;
        if (!repositioned) return std::nullopt;
        Repositioned& moved = *repositioned;
        moved.mechanism.find = found_in_rows(mechanism_, on_request_);
        moved.mechanism.contacts.reset();  // no column has their pressures
        clock_.put_rates(moved.mechanism);
        Solution solution = solve(std::move(moved.mechanism), std::move(moved.pose), [&moved] { return moved.finer; });
        spent_ += solution.protocol.bits;
        return solution;
    }

    void keep(const Solution& solution) {
        if (!records_.is_usual(solution)) return;
        if (solution.displacements) efforts_.keep(*solution.displacements);
        records_.keep(solution, columns_, has_forces_ ? solution.settled.forces : solution.settled.accelerations,
                      [&](const Given& given) { return hangs_here(given); });
    }
    bool hangs_here(const Given& given) const {
        return DriverClock::is_rate(given) ? clock_.changes(given) : givens_.hangs(given);
    }
    ValueOf<double> value_here(const Given& given) const {
        if (DriverClock::is_rate(given)) return clock_.value(given);
        return givens_.value(given, places_, positions_);
    }

    bool fill(const KeptRecords::Record& record) {
        return fill_each([&](std::size_t i) -> std::optional<std::pair<Spot, double>> {
            const auto& [known, element, from] = record.sources[i];
            if (!known) return std::nullopt;
            if (element == none) return std::pair{Spot{}, 0.0};
            if (is_distance(columns_[i])) {
                const PointIndex point = columns_[i].quantity.point;
                const Spot start = from != none ? record.replay.point(from).place() : places_.points[at_index(point)];
                return std::pair{Spot{}, distance(record.replay.point(element), start)};
            }
            if (result_kind(columns_[i].quantity).shape == ResultKind::Shape::place)
                return std::pair{record.replay.point(element).place() + places_.origin, 0.0};
            return std::pair{record.replay.vector(element), record.replay.scalar(element)};
        });
    }
    bool fill_from(const Solution& solution) {
        const std::vector<FoundValue> entries = found_values(solution, true);
        return fill_each([&](std::size_t i) -> std::optional<std::pair<Spot, double>> {
            for (const FoundValue& entry : entries)
                if (entry.quantity == columns_[i].quantity) return std::pair{entry.vector, entry.scalar};
            return std::nullopt;
        });
    }
    /// `found(i)` is the vector or scalar for column i. False if one is missing or not finite.
    template <class Found>
    bool fill_each(Found found) {
        for (std::size_t i = 0; i < columns_.size() - efforts_.size() - expressions_.size(); ++i) {
            const auto place = place_value(columns_[i]);
            const auto result = place ? std::nullopt : found(i);
            const bool may_lack = result_kind(columns_[i].quantity).on_request;
            lacking_[i] =
                may_lack && !place && (!result || !is_within_reach(columns_[i], result->first, result->second));
            if (!place && !result && !may_lack) return false;
            values_[i] = lacking_[i] ? 0 : place ? *place : part_of(columns_[i], result->first, result->second);
            if (!std::isfinite(values_[i])) return false;
        }
        return true;
    }
    /// Values that depend on the position only.
    std::optional<double> place_value(const Column& column) const {
        const Quantity& q = column.quantity;
        switch (column.kind) {
            case Column::Kind::turn: return positions_.coordinate();
            case Column::Kind::time: return clock_.time(positions_.coordinate());
            case Column::Kind::angle: return directions_[at_index(q.body)] + positions_.turn(q.body);
            case Column::Kind::place_x: return places_.points[at_index(q.point)].x + places_.origin.x;
            case Column::Kind::place_y: return places_.points[at_index(q.point)].y + places_.origin.y;
            case Column::Kind::slid: return positions_.slid(q.joint);
            case Column::Kind::result:
                if (q.kind == Kind::transmission_angle) return angle_at(q);
                return std::nullopt;
            default: return std::nullopt;
        }
    }
    std::optional<double> angle_at(const Quantity& transmission) const {
        for (const auto& [column, coupler] : couplers_)
            if (column.quantity == transmission) return transmission_angle(coupler, places_);
        return std::nullopt;
    }
    /// A place further away than this is at infinity within the accuracy of doubles.
    bool is_within_reach(const Column& column, const Spot& place, double scalar) const {
        const double most = 0x1p40 * pose_.size.to_double();
        if (is_distance(column)) return scalar < most;
        if (result_kind(column.quantity).shape != ResultKind::Shape::place) return true;
        const Spot apart = place - places_.origin;
        return std::abs(apart.x) < most && std::abs(apart.y) < most;
    }
    double part_of(const Column& column, const Spot& vector, double scalar) const {
        if (column.kind == Column::Kind::along)
            return dot(direction_of_sliding(places_, column.quantity.joint), vector);
        if (column.quantity.component == Quantity::Component::whole) return scalar;
        return column.quantity.component == Quantity::Component::x ? vector.x : vector.y;
    }

    const Mechanism& mechanism_;
    const Pose& pose_;
    bool turns_;
    DriverClock clock_;
    Positions positions_;
    Mover mover_;
    NoiseLevels levels_;
    GivensHere givens_;
    EffortColumns efforts_;
    std::vector<double> directions_;
    std::vector<std::pair<Column, Coupler>> couplers_;
    Places places_;
    std::vector<Column> columns_;
    std::vector<Column> on_request_;  ///< those of the columns that are found only where they are asked for
    std::vector<double> values_;
    std::vector<double> noise_;  ///< by column: smaller values of this row are zero
    std::vector<bool> empty_;    ///< by column: none in this row
    std::vector<bool> lacking_;  ///< by column: on request, and not found in this position or at infinity
    std::vector<PushingContact> contacts_, teeth_;
    std::vector<FlankChange> flank_changes_;
    FollowedCycle followed_;
    double travelled_ = 0;  ///< from end to end, when followed_ was found
    bool has_forces_ = false, is_checked_ = true;
    ExpressionColumns expressions_;
    KeptRecords records_;
    int planned_ = 0;
    int all_planned_ = 0;    ///< those whose records were put back, too
    std::size_t spent_ = 0;  ///< bits of all numbers of the positions that were planned, and of the passes to them
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
std::vector<Unsolved> Cycle::begin(const Travel& travel, bool checked, const std::vector<Column>& on_request) {
    return rows_->begin(travel, checked, on_request);
}
std::size_t Cycle::add(const ResultExpression& expression) { return rows_->add(expression); }
const std::vector<Column>& Cycle::columns() const { return rows_->columns(); }
std::optional<std::span<const double>> Cycle::row(double at) { return rows_->row(at); }
const FollowedCycle& Cycle::follow(const Travel& travel, const std::vector<std::size_t>& whole) {
    return rows_->follow(travel, whole);
}
const std::vector<FlankChange>& Cycle::flank_changes() const { return rows_->flank_changes(); }
const std::vector<bool>& Cycle::empty_cells() const { return rows_->empty_cells(); }
std::vector<std::optional<double>> Cycle::at_limit(double limit, double inward) {
    return rows_->at_limit(limit, inward);
}
Cycle::Difference Cycle::difference() const { return rows_->difference(); }
int Cycle::plans() const { return rows_->plans(); }
bool Cycle::is_spent() const { return rows_->is_spent(); }

}  // namespace kinegraph
