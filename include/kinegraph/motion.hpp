/// \file
/// Whole cycles: the positions of a mechanism along the travel of a driver, and cams computed from their follower's
/// law.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <kinegraph/error.hpp>
#include <kinegraph/mechanism.hpp>

namespace kinegraph {

/// Which driver moves, and its range.
struct SweepOptions {
    std::string driver;  ///< name of its body, joint or point; empty: the first driver of the file
    std::string from;    ///< coordinate of the driver as in a file ("30°"), or a time of its law; empty: the start
    std::string to;      ///< the same; if both are empty: a full turn, or from limit to limit, or the whole law
    long steps = 360;    ///< at least 2; gives steps + 1 rows
    int branch = 0;      ///< branch to take if the drawn position is a change point, from 1; 0: the first
};

/// A column of a sweep.
struct SweepColumn {
    std::string name;  ///< as in the CSV: "turn", "omega 4", "vx B" (docs/command_line.md)
    std::string unit;  ///< SI: "rad", "m/s"; empty for a bare number
};

/// The results of a mechanism in successive positions, row by row. A recorded construction is replayed in doubles while
/// its decisions stay valid, and planned again, exactly, where one changes. Every row is compared with the numeric
/// check. A sweep may be used by one thread at a time.
class Sweep {
public:
    /// Prepares the sweep of a file with drivers. Fails if the mechanism has no driver, a name is unknown, or a
    /// quantity is invalid or out of reach.
    static Expected<Sweep> of(const MechanismFile& file, const SweepOptions& options = {});
    /// Moves; a moved-from object may only be destroyed or assigned to.
    Sweep(Sweep&&) noexcept;
    /// Moves, as the constructor does.
    Sweep& operator=(Sweep&&) noexcept;
    ~Sweep();

    /// The columns; the first is the driver's coordinate ("turn").
    const std::vector<SweepColumn>& columns() const;
    /// The driver's coordinates (rad or m) if it stops at the beginning and at the end; none if it could go on.
    std::array<std::optional<double>, 2> limits() const;
    /// Change points within the travel, in the driver's coordinate.
    std::vector<double> change_points() const;
    /// Calls `see` for each row in order: one number for each column, SI. There is no row for a position without a
    /// unique answer, nor for a limit, where the driver's velocity cannot be imposed. `see` returns false to stop.
    void for_each_row(const std::function<bool(const std::vector<double>& row)>& see);
    /// All rows at once.
    std::vector<std::vector<double>> rows();
    /// Results that are in no row, with the reason.
    std::vector<Solved::Missing> unsolved() const;
    /// The largest difference from the numeric check so far, relative to the largest value of its kind.
    double largest_difference() const;

private:
    struct State;
    explicit Sweep(State* state);
    State* state_;  ///< owned; null after a move
};

/// A cam and its follower at one turn of the cam.
struct CamPosition {
    double turn = 0;                  ///< of the cam in its direction of rotation, rad
    double rise = 0;                  ///< of the follower: m, or rad if it oscillates
    std::array<double, 2> contact{};  ///< in the frame, m; the cam turns about (0, 0)
    double pressure_angle = 0;        ///< between the normal and the path of the driven point, rad, signed
    double curvature = 0;             ///< of the working profile, 1/m, positive if convex
};

/// A cam file: a disc cam for a given law of its follower. An immutable value; several threads may use the same one.
/// Sources of the method: pitch curve and its envelope (Dijksman, Motion Geometry of Mechanisms; Norton, Cam Design).
class CamFile {
public:
    /// Reads the text of a cam file. Fails with all faults at once, and if the follower cannot touch the cam.
    static Expected<CamFile> parse(std::string_view text, std::string name);
    /// Reads a file. Fails as parse() does, and if the file cannot be read.
    static Expected<CamFile> open(const std::string& path);

    /// The cam at a turn from 0 to 2π.
    CamPosition at(double turn) const;
    /// The closed working profile in the cam's own frame: x and y in m, at least `positions` points.
    std::vector<std::array<double, 2>> profile(int positions = 360) const;
    /// The mechanism file of the position at a turn: the osculating circle at the contact replaces the profile. It is
    /// valid in this position only and does not move as the cam does.
    std::string mechanism_at(double turn) const;

private:
    struct State;
    explicit CamFile(Shared<const State> state) : state_(std::move(state)) {}
    Shared<const State> state_;
};

}  // namespace kinegraph
