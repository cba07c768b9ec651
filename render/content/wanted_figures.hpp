// Wanted figures: what a solution can show, in the order of the sheet, each with what it measures and who draws it.
// Chooses no place; computes no mechanics.
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "render/content/sheet_parts.hpp"
#include "render/figures/figure.hpp"

namespace kinegraph::render {

constexpr double hardly_readable = 10;  // mm, of the longer extent of a figure

bool has_forces(const Solution& solution);
bool has_motion(const Solution& solution);
/// Motion and forces: each on pages of its own.
bool is_mixed(const Solution& solution);
/// "curvature-3".
std::string name_of(const Solution& solution, const Curvature& found);
/// A body cut free, or a pin: "body-2", "pin-B".
std::string name_of(const Solution& solution, const FreeBody& body);

/// Bodies taken together: "forces-3-4".
std::string name_of(const Solution& solution, const TakenTogether& together);

/// A drawing that wants a room: what it measures and who draws it.
struct Wanted {
    std::string name;                   ///< by which it may be asked for alone
    double extent_x = 0, extent_y = 0;  ///< in the units of its scale; 0 where nothing depends on it
    double rim_x = 20, rim_y = 14;      ///< what lettering takes beside the strokes, mm
    double least = 18;                  ///< mm of its longer extent below which nothing can be read off it
    std::map<double, Spot> taken{};     ///< mm, letters and all, its caption apart, at the scales at which it was drawn
    Spot least_room{};                  ///< mm, its caption apart: what it took where it was drawn into less
    std::size_t letters = 0;            ///< how many names it carries
    double enough = 200;                ///< mm beyond which it gains nothing
    double weight = 1;                  ///< against the other figures
    double finest = 0;                  ///< scale: in rooms that were to hold a finer one it came no larger
    std::optional<double> asked;
    std::function<Figure(double room_x, double room_y)> draw;
    /// The same, but empty and at any_scale where it has no room at `coarsest`; none: it is drawn as it comes.
    std::function<Figure(Spot room, double coarsest)> draw_or_refuse{};
    /// The figure with all that there is room for, once its room is known; empty and at any_scale: there is no room for
    /// more. None: nothing more can be shown.
    std::function<Figure(const Figure& plain, Spot room)> enrich{};
    /// Of a force polygon that is small at the scale of all: at a finer one, as far as its room has it. None: it is
    /// drawn as it is planned.
    std::function<Figure(Spot room)> larger{};
    /// By how many mm it must be wider at a scale for a block (width, height) in one of its corners; none: it has no
    /// such corner.
    std::function<double(double scale, Spot block)> wider_for{};
    /// What its strokes take at a scale, mm, where that is not in proportion to its extents.
    std::function<Spot(double scale)> strokes{};
    bool empty = false;           ///< all its vectors are zero: a pole and names
    bool spare = false;           ///< shown only where there is room, or alone
    bool to_force_scale = false;  ///< one scale for all of these
    bool fills = false;           ///< drawn to fill its room; its scale is that of its vectors
    bool shrinks = false;         ///< of what fills its room: to next to nothing, for there is no larger room
    bool tells_vectors =
        false;  ///< the scale of its figure is that of its vectors, too, but it is drawn as it is planned

    /// Whether the scale of its figure is that which its room was planned for.
    bool tells_its_extents() const { return !empty && !fills && !tells_vectors && !spare; }
    Spot strokes_at(double scale) const { return strokes ? strokes(scale) : Spot{extent_x / scale, extent_y / scale}; }
};

/// Their list. Not to be moved: those who draw refer to it.
class WantedFigures {
public:
    /// `joukowsky`: with the lever, where there is one. Brief: centres only where the file asks for them.
    WantedFigures(const DrawingContext& context, bool joukowsky, SolutionDetail detail = SolutionDetail::full);
    WantedFigures(const WantedFigures&) = delete;
    WantedFigures& operator=(const WantedFigures&) = delete;

    /// Polygons of motion are called by their ids; of a body cut free there are "body-2" and, where it has one,
    /// "forces-2".
    std::vector<Wanted> list;
    std::optional<double> force_scale;  ///< common to all force polygons, once one could not be drawn larger
    bool keeps_force_scale = false;     ///< none is planned smaller than at that

    /// Index into list; nothing where no figure has that name.
    std::optional<std::size_t> named(const std::string& name) const;
    /// The solution as a sentence speaks of it: with all loads, or with those of one body alone.
    const DrawingContext& context_at(StatementIndex statement) const;
    /// Of the polygons of motion, in their order.
    const std::deque<PolygonScene>& scenes() const { return scenes_; }
    /// Whether the instant centres are shown.
    bool shows_centres() const;
    /// Whether one of them has so many names that it costs more to letter it for other rooms than they gain.
    bool are_crowded() const;

private:
    static void know_strokes(Wanted& wanted, std::function<Spot(double scale)> strokes);
    using DrawForces = std::function<Figure(double room_x, double room_y, std::optional<double> scale, bool fixed)>;

    static std::function<Figure(Spot room)> at_own_scale(DrawForces draw);

    Wanted& add(Wanted wanted);
    void collect_motion();
    void add_mechanism();
    void add_polygon(int polygon);
    void collect_forces(bool joukowsky);
    void add_truss();
    void add_lines_of_action();
    void add_force_polygons(const std::string& kind, const std::string& name, const Box& extent, DrawForces draw);
    void add_free_bodies();
    void add_free_body(const DrawingContext& context, std::size_t index, const std::string& load);
    void add_polygons_of_bodies(const DrawingContext& context);
    void add_superposition();
    void leave_room_for(std::size_t polygons);
    void keep_forces_readable();
    void keep_larger_to_small_ones();
    Wanted* largest_of_forces();
    void add_curvature();
    void add_loops();
    void add_displacements();
    void add_moving_axes();
    void add_small();
    Wanted mechanism(const std::string& name, bool with_centres) const;
    std::optional<double> asked(const std::string& figure, double si) const;
    const DrawingContext& unscaled();

    const DrawingContext& context_;
    SolutionDetail detail_;
    std::deque<PolygonScene> scenes_;   // of the polygons of motion; they stay where they are
    std::optional<Solution> unscaled_;  // the same without the file's scales, made when one of them does not fit
    std::optional<DrawingContext> unscaled_context_;
    std::deque<Solution> alone_;  // by part of the superposition
    std::deque<DrawingContext> alone_contexts_;
};

}  // namespace kinegraph::render
