// Columns: what the numbers of a cycle are, position by position, and the table that they make. Knows neither how they are found
// nor how they are drawn.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/quantity.hpp"
#include "engine/units.hpp"

namespace kinegraph {

/// What one column holds, in SI units (rad, m, s).
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

/// The least angle (rad, at most a right one) under which a coupler pushes what it drives, and where.
struct Transmission {
    BodyIndex coupler, driven;
    double least = 0, at = 0;
};

/// A cycle as it is drawn: some of its rows.
struct CycleTable {
    std::string driver;  ///< its name
    bool turns = true;   ///< rad, else m
    Travel travel;
    std::vector<Column> columns;  ///< the first is the driver's coordinate
    std::vector<std::vector<double>> rows;
    std::vector<double> left_out;  ///< coordinates of positions without a row
    std::optional<Transmission> transmission;
};

}  // namespace kinegraph
