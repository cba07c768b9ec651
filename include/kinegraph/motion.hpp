/// \file
/// Whole cycles: a mechanism in one position after another, and cams from the law of their follower.
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

/// Which driver moves, and how far.
struct SweepOptions {
    std::string driver;  ///< by its body's, joint's or point's name; empty: the first of the file
    std::string from;  ///< a coordinate of the driver as a file writes it ("30°"), a time of its law; empty: the start
    std::string to;    ///< the same; both empty: a full turn, or from limit to limit, or the whole law
    long steps = 360;  ///< at least 2; one row more than steps
    int branch = 0;    ///< at a drawn change point: which branch is taken, from 1; 0: the first
};

/// A column of a sweep.
struct SweepColumn {
    std::string name;  ///< as in the CSV: "turn", "omega 4", "vx B" (docs/command_line.md)
    std::string unit;  ///< SI: "rad", "m/s"; empty of a bare number
};

/// The results of a mechanism in one position after another, row by row. Rows come from the construction, replayed in
/// doubles for as long as its decisions hold and planned anew, exactly, where one changes; every row is compared with
/// the numeric check. One thread at a time may use a sweep.
class Sweep {
public:
    /// Prepares the sweep of a file with drivers. Fails where nothing drives it, a name is unknown, a quantity is
    /// wrong or out of reach.
    static Expected<Sweep> of(const MechanismFile& file, const SweepOptions& options = {});
    /// Moves; what was moved from may only be destroyed or assigned to.
    Sweep(Sweep&&) noexcept;
    /// Moves, as the constructor does.
    Sweep& operator=(Sweep&&) noexcept;
    ~Sweep();

    /// The columns, the driver's coordinate ("turn") first.
    const std::vector<SweepColumn>& columns() const;
    /// Where the driver stops, in its coordinate (rad or m), at the beginning and at the end; none where it goes on.
    std::array<std::optional<double>, 2> limits() const;
    /// Change points within the travel, in the driver's coordinate.
    std::vector<double> change_points() const;
    /// Calls `see` for each row in order: one number a column, SI. Positions without a unique answer have no row; nor
    /// has a limit, where the driver has no velocity to give. `see` returns false to stop.
    void for_each_row(const std::function<bool(const std::vector<double>& row)>& see);
    /// All rows at once.
    std::vector<std::vector<double>> rows();
    /// What is in no row, with the reason.
    std::vector<Solved::Missing> unsolved() const;
    /// The largest difference from the numeric check so far, as a share of the largest of its kind.
    double largest_difference() const;

private:
    struct State;
    explicit Sweep(State* state);
    State* state_;  ///< owned; null where it was moved away
};

/// A cam and its follower when the cam has turned.
struct CamPosition {
    double turn = 0;                  ///< of the cam as it runs, rad
    double rise = 0;                  ///< of the follower: m, or rad of an oscillating one
    std::array<double, 2> contact{};  ///< in the frame, m; the cam turns about (0, 0)
    double pressure_angle = 0;        ///< between the normal and the way of the driven point, rad, signed
    double curvature = 0;             ///< of the working profile, 1/m, positive where it is convex
};

/// A cam file: a disc cam that gives its follower a law. An immutable value; several threads may use one at a time.
/// Sources of the method: pitch curve and its envelope (Dijksman, Motion Geometry of Mechanisms; Norton, Cam Design).
class CamFile {
public:
    /// Reads the text of a cam file. Fails with every fault at once, and where the follower cannot touch the cam.
    static Expected<CamFile> parse(std::string_view text, std::string name);
    /// Reads the file at a path. Fails as parse() does, and where the file cannot be read.
    static Expected<CamFile> open(const std::string& path);

    /// The cam at a turn from 0 to 2π.
    CamPosition at(double turn) const;
    /// The working profile as the cam sees it, closed: x and y in m, at least `positions` places.
    std::vector<std::array<double, 2>> profile(int positions = 360) const;
    /// The mechanism file of the position at a turn: the cam's osculating circle at the contact in place of its
    /// profile. It is one position; it does not move as the cam does.
    std::string mechanism_at(double turn) const;

private:
    struct State;
    explicit CamFile(Shared<const State> state) : state_(std::move(state)) {}
    Shared<const State> state_;
};

}  // namespace kinegraph
