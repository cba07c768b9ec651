// Cycle: the results of a mechanism in one position after another, a row of numbers each. The record of one position is replayed
// in doubles for as long as its guards hold; where one flips the position is planned anew, exactly. Every row is held against the
// numeric check. Knows no file, no format and no plot.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/positions.hpp"
#include "engine/quantity.hpp"
#include "engine/solution.hpp"
#include "engine/units.hpp"

namespace kinegraph {

/// What one column of a cycle holds, in SI units (rad, m, s).
struct Column {
    enum class Kind {
        turn,     ///< the driver's coordinate: 0 as drawn
        time,     ///< since the drawn position, where the driver's rate does not change
        angle,    ///< of a body: of its first point to its second from +x, or since the drawn pose; goes on past a full turn
        place_x,  ///< of a point
        place_y,
        slid,    ///< at a straight slide, along X, since the drawn pose
        result,  ///< `quantity`: a scalar or a component
        along    ///< `quantity`, a sliding: along X, or along the common tangent of a contact
    } kind = Kind::turn;
    Quantity quantity;  ///< places: the velocity of the point; angle: ω; slid: the sliding velocity
    std::string name;   ///< as docs/format.md lists them: "omega 3", "vx B", "Fx A 3 on 2"
    QuantityKind unit = QuantityKind::dimensionless;
};

/// How far a driver goes.
struct Travel {
    double from = 0, to = 0;
    bool starts_at_limit = false, ends_at_limit = false;  ///< the driver stops there: a dead point
    std::vector<double> change_points;
};
/// Why it cannot: `wanted` lies beyond the limit; without a limit, it goes on for ever.
struct TravelFault {
    double wanted = 0;
    std::optional<double> limit;
};
/// From `from` to `to`; what is not given is a full turn from the drawn position, or, where the driver does not make one, from
/// limit to limit. `turns`: the coordinate is an angle.
tl::expected<Travel, TravelFault> travel_of(const Positions& positions, bool turns, std::optional<double> from,
                                            std::optional<double> to);

class Cycle {
public:
    /// Of one driver (index). `mechanism` must outlive the cycle. Errors: those of Positions::of.
    static Result<Cycle> of(const Mechanism& mechanism, const Pose& pose, int driver);
    Cycle(Cycle&&) noexcept;
    ~Cycle();

    const Positions& positions() const;
    /// Chooses the columns by what is found somewhere between; to be called once, before the first row. Not empty: why some
    /// results are in no row. Without `checked` no row is held against the check.
    std::vector<Unsolved> begin(const Travel& travel, bool checked = true);
    const std::vector<Column>& columns() const;
    /// The row of a position within the travel, one number a column; none where the mechanism gives no unique answer.
    std::optional<std::span<const double>> row(double coordinate);

    /// The largest difference from the check so far, as a share of the largest of its kind, and where. `column` < 0: none was
    /// held.
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
