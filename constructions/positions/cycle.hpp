// Cycle: the results of a mechanism in successive positions, a row of numbers each. The record of one position is
// replayed in doubles while its guards hold; if one fails the position is planned again, exactly. Every row is compared
// with the numeric check.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/motion/positions.hpp"
#include "engine/sentences/column.hpp"
#include "engine/solution/findings.hpp"

namespace kinegraph {

/// Why a travel is impossible: `wanted` is beyond the limit, or too far to walk there; without a limit, the driver
/// never stops.
struct TravelFault {
    double wanted = 0;
    std::optional<double> limit;
    bool is_too_far = false;
};
/// From `from` to `to`; by default a full turn from the drawn position or, if the driver cannot make one, from limit to
/// limit. `turns`: the coordinate is an angle.
tl::expected<Travel, TravelFault> travel_of(const Positions& positions, bool turns, std::optional<double> from,
                                            std::optional<double> to);

/// For a driver with a law: from and to are times, s, zero in the drawn position; by default the law's beginning or
/// end.
tl::expected<Travel, TravelFault> travel_of_law(const Positions& positions, const Law& law, std::optional<double> from,
                                                std::optional<double> to);

/// The whole travel of the first driver, or that of its law, and the positions; none if it has no travel.
std::optional<std::pair<Positions, Travel>> own_travel(const Mechanism& mechanism, const Pose& pose);

/// The least transmission angle: for all couplers, from the driven body onwards, driven at one pin and with another pin
/// on a body hinged or sliding on the frame, the angle between the line of both pins and the follower's link (or the
/// normal of its guide). Gears, rolling contacts and welds lead on; a coupler that a driver moves has no angle. None if
/// there is no such coupler.
std::optional<Transmission> transmission_of(const Mechanism& mechanism, const Positions& positions, int driver,
                                            const Travel& travel);

class ResultExpression;

/// Where the force that teeth transmit changes its sign, so that their other flanks push. `at` as in Travel::at.
struct FlankChange {
    JointIndex joint;
    double at = 0;
};

/// What one cycle may plan exactly: so many positions, or more as long as their numbers have so many bits together,
/// each of which takes 2 to 7 ns. Positions are planned where doubles do not tell a quantity from zero, so a cycle
/// whose quantities differ by 10^12 plans all of them.
constexpr int always_planned = 100;
constexpr std::size_t most_planned_millions = 500, most_planned_bits = most_planned_millions * 1'000'000;

class Cycle {
public:
    /// `mechanism` and `pose` must outlive the cycle. Rates are the file's at every position; those of the course's
    /// driver follow its law, if it has one. Errors: those of Positions::of.
    static Result<Cycle> of(const Mechanism& mechanism, const Pose& pose, const Course& course);
    static Result<Cycle> of(const Mechanism& mechanism, const Pose& pose, int driver) {
        return of(mechanism, pose, Course{driver});
    }
    Cycle(Cycle&&) noexcept;
    ~Cycle();

    const Positions& positions() const;
    /// Chooses the columns by what is found in sample positions; call it once, before the first row. Returns why some
    /// results have no column. With `checked` false no row is compared with the check. `on_request`: columns of results
    /// that are found only where they are asked for (ResultKind::on_request); their cells may be empty.
    std::vector<Unsolved> begin(const Travel& travel, bool checked = true, const std::vector<Column>& on_request = {});
    const std::vector<Column>& columns() const;
    /// Adds a column for an expression of the columns (engine/results/result_expression.hpp); its index. Call it after
    /// begin(), before follow().
    std::size_t add(const ResultExpression& expression);
    /// The row of a position within the travel, one number for each column; none if the mechanism gives no unique
    /// answer. `at` is a coordinate of the driver, or a time if it has a law, as Travel::at gives it.
    std::optional<std::span<const double>> row(double at);

    /// Follows the columns as functions over the whole travel, also between the rows: the poles of all forces and
    /// efforts (and of what grows at a limit), zeros, extremes and means of `whole`, and where contacts that only push
    /// would have to pull. What is found is the same for any number of rows. Rows that are asked for afterwards have
    /// empty cells on poles. Call it after begin(); again for further columns, which changes nothing of the others.
    const FollowedCycle& follow(const Travel& travel, const std::vector<std::size_t>& whole);
    /// Gear by gear, in order; empty unless follow() was called.
    const std::vector<FlankChange>& flank_changes() const;
    /// By column: whether the last row has no value there, since the quantity grows without limit. It then contains 0.
    const std::vector<bool>& empty_cells() const;

    /// By column the values that depend on the place only, at a limit of the travel, which has no row: turn, angles,
    /// places, slides. `inward`: from the limit to the other end. None if it cannot be approached.
    std::vector<std::optional<double>> at_limit(double limit, double inward);

    /// The largest difference from the check so far, relative to the largest of its kind, and where. `column` < 0: no
    /// value was compared.
    struct Difference {
        double share = 0;
        int column = -1;
        double coordinate = 0;
    };
    Difference difference() const;
    int plans() const;      ///< number of positions planned so far
    bool is_spent() const;  ///< whether planning took all the work it may: rows that need more have no answer

private:
    class Rows;
    explicit Cycle(std::unique_ptr<Rows> rows);
    std::unique_ptr<Rows> rows_;
};

}  // namespace kinegraph
