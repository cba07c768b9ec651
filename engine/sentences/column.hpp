// Columns: the quantity in each column of a cycle's table, and the table itself. Independent of the computation and of
// the drawing.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/file/formula.hpp"
#include "engine/file/units.hpp"
#include "engine/sentences/quantity.hpp"
#include "lang/words.hpp"

namespace kinegraph {

/// The quantity of one column, in SI units (rad, m, s).
struct Column {
    enum class Kind {
        turn,     ///< the driver's coordinate: 0 as drawn
        time,     ///< since the drawn position, where the driver's rate is constant
        angle,    ///< of a body: angle from +x of the line from its first to its second point, or since the drawn pose;
                  ///< continues past a full turn
        place_x,  ///< of a point
        place_y,
        slid,      ///< displacement at a straight slide, along X, since the drawn pose
        result,    ///< `quantity`: a scalar or a component
        along,     ///< `quantity`, a sliding: along X, or along the common tangent of a contact
        named,     ///< the text `name`
        parameter  ///< of the file, named `name`: within expressions only
    } kind = Kind::turn;
    Quantity quantity;  ///< places: the velocity of the point; angle: ω; slid: the sliding velocity
    std::string name;   ///< as docs/command_line.md lists them: "omega 3", "vx B", "Fx A 3 on 2"
    QuantityKind unit = QuantityKind::dimensionless;
    std::string expression = {};                        ///< of an expression of results: its text
    std::string si_unit = {};                           ///< of an expression whose quantity has no kind: "m²/s³"
    std::optional<Dimension> dimension = std::nullopt;  ///< of an expression or a parameter
    std::optional<Key> said = std::nullopt;             ///< on paper, where it is not called by its name
    bool names_carrier = false;  ///< of a point: as one of several bodies carries it, "vx A on 4"
    std::string vector = {};     ///< of a component: the name of its vector, "v B" of "vx B"
};

/// The travel of a driver.
struct Travel {
    double from = 0, to = 0;
    bool starts_at_limit = false, ends_at_limit = false;  ///< whether the driver stops there: a dead point
    std::vector<double> change_points;
    /// For a driver with a law: start and end time, s, zero as drawn. Positions are then equally spaced in time, and
    /// `from` and `to` are the least and the greatest coordinate.
    std::optional<std::pair<double, double>> times = std::nullopt;
    bool starts_far = false, ends_far = false;  ///< whether a place goes to infinity at that limit

    /// The position at this fraction of the travel, from 0 to 1: a time where there is a law, else a coordinate.
    double at(double share) const {
        const double first = times ? times->first : from, last = times ? times->second : to;
        return share == 1 ? last : first + share * (last - first);
    }
};

/// The smallest transmission angle (rad, at most π/2) between a coupler and the link it drives, and where it occurs.
struct Transmission {
    BodyIndex coupler, driven;
    JointIndex pin;  ///< between the two
    double least = 0, at = 0;
};

/// A column followed as a function over a travel, also between its rows, SI. Positions are in the terms of Travel::at,
/// known to 1e-9 of the travel, and the same for any number of rows.
struct FollowedColumn {
    struct Extreme {
        double at = 0, value = 0;
    };
    bool is_followed = false;      ///< whether zeros, extremes and the mean are known
    std::vector<double> poles;     ///< where it grows without limit, in order; a limit of the travel may be one
    std::vector<double> zeros;     ///< in order; not intervals on which it stays zero
    std::optional<Extreme> least;  ///< none: without limit
    std::optional<Extreme> greatest;
    std::optional<double> mean;  ///< none: without limit, or not determined

    /// Whether a position is that of a pole. `travel`: the length of the whole one.
    bool is_pole(double at, double travel) const {
        for (const double pole : poles)
            if (std::abs(at - pole) <= 1e-9 * std::abs(travel)) return true;
        return false;
    }
};

/// A contact that can only push would have to pull between these positions: it separates.
struct Separation {
    JointIndex joint;
    double from = 0, to = 0;  ///< in the terms of Travel::at, as FollowedColumn
};

/// All columns of a cycle, by index, and its contacts.
struct FollowedCycle {
    std::vector<FollowedColumn> columns;  ///< empty: not followed
    std::vector<Separation> separations;
};

/// A cycle as it is drawn: a selection of its rows.
struct CycleTable {
    std::string driver;  ///< its name
    bool turns = true;   ///< rad, else m
    Travel travel;
    std::vector<Column> columns;  ///< the first is the driver's coordinate
    std::vector<std::vector<double>> rows;
    /// Limits of the travel, which have no row: by column, the values that follow from the position alone (rotations,
    /// angles, places, slides).
    std::vector<std::vector<std::optional<double>>> limits;
    std::vector<double> left_out;  ///< positions without a row, in the terms of Travel::at
    std::optional<Transmission> transmission;
    FollowedCycle followed;    ///< with it extremes and zeros are not interpolated
    std::vector<Words> facts;  ///< further facts, printed below the extremes
    bool is_of_cam = false;    ///< a cam's whole turn, else a mechanism's motion

    /// A sweep of a parameter in place of the driver: `driver` is its name; the travel and the first column are its
    /// values.
    struct Parameter {
        Unit unit;                    ///< unit in which it is printed; without a symbol: bare numbers
        std::optional<double> drawn;  ///< its value as drawn, SI
    };
    std::optional<Parameter> parameter = std::nullopt;

    /// The column over which the others are plotted: the driver's coordinate, or the time where it has a law.
    std::size_t over() const { return travel.times ? 1 : 0; }
};

}  // namespace kinegraph
