// Columns: what the numbers of a cycle are, position by position, and the table that they make. Knows neither how they
// are found nor how they are drawn.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/file/units.hpp"
#include "engine/file/words.hpp"
#include "engine/sentences/quantity.hpp"

namespace kinegraph {

/// What one column holds, in SI units (rad, m, s).
struct Column {
    enum class Kind {
        turn,     ///< the driver's coordinate: 0 as drawn
        time,     ///< since the drawn position, where the driver's rate does not change
        angle,    ///< of a body: of its first point to its second from +x, or since the drawn pose; goes on past a full
                  ///< turn
        place_x,  ///< of a point
        place_y,
        slid,    ///< at a straight slide, along X, since the drawn pose
        result,  ///< `quantity`: a scalar or a component
        along,   ///< `quantity`, a sliding: along X, or along the common tangent of a contact
        named    ///< what `name` says, a word of the sheet
    } kind = Kind::turn;
    Quantity quantity;  ///< places: the velocity of the point; angle: ω; slid: the sliding velocity
    std::string name;   ///< as docs/command_line.md lists them: "omega 3", "vx B", "Fx A 3 on 2"
    QuantityKind unit = QuantityKind::dimensionless;
};

/// How far a driver goes.
struct Travel {
    double from = 0, to = 0;
    bool starts_at_limit = false, ends_at_limit = false;  ///< the driver stops there: a dead point
    std::vector<double> change_points;
    /// Where the driver has a law: from when to when, s, zero as drawn; positions then follow each other in equal
    /// times, and `from` and `to` are the least and the greatest coordinate.
    std::optional<std::pair<double, double>> times = std::nullopt;

    /// The share of the way, from 0 to 1, as a time where there is a law, else as a coordinate.
    double at(double share) const {
        const double first = times ? times->first : from, last = times ? times->second : to;
        return share == 1 ? last : first + share * (last - first);
    }
};

/// The least angle (rad, at most a right one) under which a coupler pushes what it drives, and where.
struct Transmission {
    BodyIndex coupler, driven;
    JointIndex pin;  ///< between the two
    double least = 0, at = 0;
};

/// A cycle as it is drawn: some of its rows.
struct CycleTable {
    std::string driver;  ///< its name
    bool turns = true;   ///< rad, else m
    Travel travel;
    std::vector<Column> columns;  ///< the first is the driver's coordinate
    std::vector<std::vector<double>> rows;
    /// Limits of the travel, which have no row: by column what the place alone gives there (turns, angles, places,
    /// slides).
    std::vector<std::vector<std::optional<double>>> limits;
    std::vector<double> left_out;  ///< positions without a row, as Travel::at gives them
    std::optional<Transmission> transmission;
    std::vector<Words> facts;  ///< what else is told below the extremes
    bool is_of_cam = false;    ///< a cam's whole turn, else a mechanism's motion

    /// A parameter in place of the driver: `driver` is its name, the travel and the first column its values.
    struct Parameter {
        Unit unit;                    ///< in which it is told; without a symbol: bare numbers
        std::optional<double> drawn;  ///< its value as drawn, SI
    };
    std::optional<Parameter> parameter = std::nullopt;

    /// The column over which the others are drawn: the driver's coordinate, or the time where it has a law.
    std::size_t over() const { return travel.times ? 1 : 0; }
};

}  // namespace kinegraph
