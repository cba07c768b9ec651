// Cycle: the results of a mechanism in one position after another, a row of numbers each. The record of one position is
// replayed in doubles for as long as its guards hold; where one flips the position is planned anew, exactly. Every row
// is held against the numeric check. Knows no file, no format and no plot.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/motion/positions.hpp"
#include "engine/sentences/column.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {

/// Why it cannot: `wanted` lies beyond the limit; without a limit, it goes on for ever.
struct TravelFault {
    double wanted = 0;
    std::optional<double> limit;
};
/// From `from` to `to`; what is not given is a full turn from the drawn position, or, where the driver does not make
/// one, from limit to limit. `turns`: the coordinate is an angle.
tl::expected<Travel, TravelFault> travel_of(const Positions& positions, bool turns, std::optional<double> from,
                                            std::optional<double> to);

/// Of a driver with a law: from and to are times, s, zero as drawn; what is not given is the law's beginning or end.
tl::expected<Travel, TravelFault> travel_of_law(const Positions& positions, const Law& law, std::optional<double> from,
                                                std::optional<double> to);

/// The travel of the first driver, as far as it goes or as its law says, and the positions; nothing where there is
/// none.
std::optional<std::pair<Positions, Travel>> own_travel(const Mechanism& mechanism, const Pose& pose);

/// Of all couplers that are pushed at one pin, from the driven body onwards, and push at another a body hinged or
/// sliding on the frame: the least angle between the line of both pins and the follower's link (or the normal of its
/// guide). Nothing where there is none.
std::optional<Transmission> transmission_of(const Mechanism& mechanism, const Positions& positions, int driver,
                                            const Travel& travel);

class Cycle {
public:
    /// `mechanism` and `pose` must outlive the cycle. Rates are the file's at every position; those of the course's
    /// driver follow its law, where it has one. Errors: those of Positions::of.
    static Result<Cycle> of(const Mechanism& mechanism, const Pose& pose, const Course& course);
    static Result<Cycle> of(const Mechanism& mechanism, const Pose& pose, int driver) {
        return of(mechanism, pose, Course{driver});
    }
    Cycle(Cycle&&) noexcept;
    ~Cycle();

    const Positions& positions() const;
    /// Chooses the columns by what is found somewhere between; to be called once, before the first row. Not empty: why
    /// some results are in no row. Without `checked` no row is held against the check.
    std::vector<Unsolved> begin(const Travel& travel, bool checked = true);
    const std::vector<Column>& columns() const;
    /// The row of a position within the travel, one number a column; none where the mechanism gives no unique answer.
    /// `at` is a coordinate of the driver, or a time where it has a law, as Travel::at gives it.
    std::optional<std::span<const double>> row(double at);

    /// By column what the place alone gives at a limit of the travel, which has no row: turn, angles, places, slides.
    /// `inward`: from the limit to the other end. Nothing where it cannot be approached.
    std::vector<std::optional<double>> at_limit(double limit, double inward);

    /// The largest difference from the check so far, as a share of the largest of its kind, and where. `column` < 0:
    /// none was held.
    struct Difference {
        double share = 0;
        int column = -1;
        double coordinate = 0;
    };
    Difference difference() const;
    int plans() const;  ///< how often a position was planned

private:
    class Rows;
    explicit Cycle(std::unique_ptr<Rows> rows);
    std::unique_ptr<Rows> rows_;
};

}  // namespace kinegraph
