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
#include <kinegraph/sheet.hpp>

namespace kinegraph {

/// A driver that moves together with the first one.
struct DriverAlong {
    std::string driver;  ///< name of its body, joint or point
    std::string step;    ///< how far it moves at each step of the first one, as in a file: "2°", "-1 mm"
};

/// What changes from row to row, its range, and what is drawn besides the plots' default.
struct SweepOptions {
    std::string driver;              ///< name of its body, joint or point; empty: the first driver of the file
    std::vector<DriverAlong> along;  ///< drivers that move with it; all others rest
    int branch = 0;                  ///< branch to take if the drawn position is a change point, from 1; 0: the first
    std::string over;  ///< a parameter of the file to vary instead of a driver; each value is solved as drawn with it
    std::string from;  ///< coordinate of the driver as in a file ("30°"), time of its law, or value of the parameter
    std::string to;    ///< the same; both empty: a full turn, or from limit to limit, or the whole law of a driver
    std::string step;  ///< from one value of the parameter to the next, as in a file; empty: equal steps
    long steps = 360;  ///< gives steps + 1 rows; at least 2, of a parameter at least 1
    std::vector<std::string> plots;      ///< columns of one unit, or expressions of them; empty: a default choice
    std::string columns;                 ///< which columns the rows show, beside the first: "v B,omega 4 / omega 2"
    std::vector<std::string> traces;     ///< paths to draw: of a point "P", or as seen from a body "P,on BODY"
    std::vector<std::string> centrodes;  ///< pairs of bodies, "1,3", whose centrodes are drawn and written as JSON
    int poses = 0;                       ///< number of positions drawn behind the mechanism
    std::string dashes;  ///< stands before the names of these options in messages: "--" in a command line's
};

/// A column of a sweep.
struct SweepColumn {
    std::string name;  ///< as in the CSV: "turn", "omega 4", "vx B" (docs/command_line.md)
    std::string unit;  ///< SI: "rad", "m/s"; empty for a bare number and for the parameter
};

/// One number for each column, SI. None where the quantity grows without limit, as an input force does where it does no
/// work; what is determined there stays.
using SweepRow = std::vector<std::optional<double>>;

/// Where a column grows without limit: a coordinate of the driver, or a time of its law, found to 1e-9 of the travel
/// whatever the number of steps.
struct SweepPole {
    std::string column;  ///< its name
    double at = 0;       ///< rad, m or s
};
/// A contact that can only push would have to pull between these positions, found as poles are: it separates.
struct SweepSeparation {
    std::string joint;  ///< its point
    double from = 0;    ///< rad, m or s
    double to = 0;      ///< rad, m or s
};

/// A text of a sweep that is written piece by piece.
struct RowsText {
    /// CSV has the names of the columns in its first line. JSON also has the travel, the largest difference and the
    /// centrodes (docs/command_line.md).
    enum class Form { csv, json };
    Form form = Form::csv;                              ///< of the text
    std::function<bool(std::string_view piece)> write;  ///< takes the next piece; returns false to stop the sweep
};

/// The results of a mechanism in successive positions, row by row. A recorded construction is replayed in doubles while
/// its decisions stay valid, and planned again, exactly, where one changes. A sweep over a parameter solves the file
/// again, exactly, for each of its values. Every row is compared with the numeric check. A sweep may be used by one
/// thread at a time.
class Sweep {
public:
    /// Prepares the sweep of a file. Fails if the mechanism has no driver, a name is unknown, options contradict each
    /// other, or a quantity is invalid or out of reach.
    static Expected<Sweep> of(const MechanismFile& file, const SweepOptions& options = {});
    /// Moves; a moved-from object may only be destroyed or assigned to.
    Sweep(Sweep&&) noexcept;
    /// Moves, as the constructor does.
    Sweep& operator=(Sweep&&) noexcept;
    ~Sweep();

    /// The columns; the first is the driver's coordinate ("turn") or the parameter. Over a parameter there are none
    /// before the first row.
    std::vector<SweepColumn> columns() const;
    /// The driver's coordinates (rad or m) if it stops at the beginning and at the end; none if it could go on, or over
    /// a parameter.
    std::array<std::optional<double>, 2> limits() const;
    /// Change points within the travel, in the driver's coordinate.
    std::vector<double> change_points() const;

    /// Where forces, input forces and couples, and what grows at a limit of the travel, grow without limit; in the
    /// order of the columns. None over a parameter.
    std::vector<SweepPole> poles() const;
    /// Where contacts would have to pull, in the order of the joints. None over a parameter.
    std::vector<SweepSeparation> separations() const;

    /// Computes all rows and calls `see` for each of them in order. There is no row for
    /// a position without a unique answer, nor for a limit, where the driver's velocity cannot be imposed. `see`
    /// returns false to stop. `progress` is called before each row. Fails, without any row, if no value of a parameter
    /// has an answer, or if its results have no column to plot.
    Expected<void> for_each_row(const std::function<bool(const SweepRow& row)>& see,
                                const std::function<void(long done, long all)>& progress = {});
    /// Computes all rows and writes them as texts while they are found. Rows over a driver take constant memory. Fails
    /// as for_each_row() does.
    Expected<void> write(const std::vector<RowsText>& texts,
                         const std::function<void(long done, long all)>& progress = {});
    /// All rows at once. Fails as for_each_row() does.
    Expected<std::vector<SweepRow>> rows();

    /// What of the options has no effect: bodies without centrodes.
    std::vector<Text> remarks() const;
    /// About the rows computed last: the travel, mean and extremes of the input forces and couples, separating
    /// contacts, rows left out, the largest difference from the numeric check; one sentence each.
    std::vector<Text> summary() const;
    /// Results that are in no row, with the reason.
    std::vector<Solved::Missing> unsolved() const;
    /// Whether every result has a column, and no row was left out but those of limits.
    bool is_complete() const;
    /// The largest difference from the numeric check so far, relative to the largest value of its kind.
    double largest_difference() const;

    /// \cond private
    struct State;
    explicit Sweep(State* state);
    State& state() const { return *state_; }
    /// \endcond

private:
    State* state_;  ///< owned; null after a move
};

/// Draws the mechanism with its paths and centrodes, the table of extremes and the plots, from the rows computed last;
/// computes them if there are none yet. Fails as draw() of a solution and for_each_row() do.
Expected<Drawing> draw(Sweep& sweep, const DrawingOptions& options = {});

/// Draws the frames of a film: the mechanism in `frames` positions at even steps of the driver, from one end of the
/// travel to the other, each on a page of 16:9 with the plots, in which a line shows the position. Scale and place are
/// the same on all pages. After a whole turn the last position leads back to the first one. Fails as draw() does, over
/// a parameter, and for fewer than 2 or more than 720 frames.
Expected<Drawing> draw_frames(Sweep& sweep, int frames, const DrawingOptions& options = {});

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

    /// \cond private
    struct State;
    explicit CamFile(Shared<const State> state);
    const State& state() const { return *state_; }
    /// \endcond

private:
    Shared<const State> state_;
};

/// Rows of a cam, and the position in which it is drawn.
struct CamOptions {
    std::string at;      ///< turn of the cam in that position, from 0 to 360°, as in a file; empty: 0
    long steps = 360;    ///< at least 2; gives steps + 1 rows over the whole turn
    std::string dashes;  ///< as in SweepOptions
};

/// The whole turn of a cam. Every row is solved as a mechanism too, and the follower's motion that results is compared
/// with the law. An immutable value: copies share their state, and several threads may read the same one.
class CamCycle {
public:
    /// Computes and solves all rows, in about the time that solving a mechanism takes for each. Fails if the turn is
    /// invalid, or for fewer than 2 steps.
    static Expected<CamCycle> of(const CamFile& cam, const CamOptions& options = {});

    /// The rows as CSV, SI: motion of the follower, profile, pressure angle, curvature (docs/command_line.md).
    std::string csv() const;
    /// The mechanism file of the drawn position, as CamFile::mechanism_at() gives it.
    std::string mechanism() const;
    /// The largest pressure angle, the least radii of curvature, undercuts, the part of a flat face that is touched;
    /// one sentence each.
    std::vector<Text> facts() const;
    /// Shocks: where the speed of the follower jumps.
    std::vector<Text> remarks() const;
    /// How far the solved mechanisms differ from the law; one sentence each.
    std::vector<Text> comparison() const;
    /// Whether the follower keeps its law: no undercut, and a unique answer in every row.
    bool keeps_law() const;

    /// \cond private
    struct State;
    explicit CamCycle(Shared<const State> state);
    const State& state() const { return *state_; }
    /// \endcond

private:
    Shared<const State> state_;
};

/// Draws the cam and its follower with the construction of the profile, its data, and plots of the motion and of the
/// pressure angle. Fails as draw() of a solution does.
Expected<Drawing> draw(const CamCycle& cycle, const DrawingOptions& options = {});
/// Makes the page on which the cam turns with its true profile and the follower keeps its law, in the language of the
/// options; ignores the paper. Fails as draw() does.
Expected<LivePage> live_page(const CamCycle& cycle, const DrawingOptions& options = {});

}  // namespace kinegraph
