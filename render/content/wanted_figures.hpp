// Wanted figures: the figures that a solution can show, in the order of the sheet, each with its extent and the
// function that draws it. Chooses no position; computes no mechanics.
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

constexpr double hardly_readable = 10;  // mm, the longer extent of a figure

bool has_forces(const Solution& solution);
bool has_motion(const Solution& solution);
/// Whether it has both motion and forces; each has pages of its own then.
bool is_mixed(const Solution& solution);
/// "curvature-3".
std::string name_of(const Solution& solution, const Curvature& found);
/// A free body or a pin: "body-2", "pin-B".
std::string name_of(const Solution& solution, const FreeBody& body);

/// Bodies cut free together: "forces-3-4".
std::string name_of(const Solution& solution, const TakenTogether& together);

/// A figure to be placed: its extent, an estimate of its size on paper, and the functions that draw it.
struct Wanted {
    std::string name;                   ///< the name in the command line
    double extent_x = 0, extent_y = 0;  ///< in the units of its scale; 0: the size does not depend on it
    double rim_x = 20, rim_y = 14;      ///< estimated space for labels beside the strokes, mm
    double least = 18;                  ///< mm; nothing can be read off the figure if its longer extent is less
    std::map<double, Spot> taken{};     ///< size as drawn with labels but without caption, mm, by scale
    Spot least_room{};                  ///< mm, without caption: its size when it was larger than its room
    std::size_t letters = 0;            ///< number of labels
    double enough = 200;                ///< mm; it gains nothing from a larger size
    double weight = 1;                  ///< of its score, relative to other figures
    double finest = 0;                  ///< limit of the scale: it was not drawn finer in rooms planned for that
    std::optional<double> asked;
    std::function<Figure(double room_x, double room_y)> draw;
    /// The same, but empty and at any_scale if it has no room at `coarsest`. Null: it cannot refuse a room.
    std::function<Figure(Spot room, double coarsest)> draw_or_refuse{};
    /// Adds optional content to a figure once its room is final. Empty and at any_scale if there is no space for it.
    /// Null: there is nothing to add.
    std::function<Figure(const Figure& plain, Spot room)> enrich{};
    /// Draws a force polygon that is small at the common scale at a finer one, if its room allows it. Null: the common
    /// scale is kept.
    std::function<Figure(Spot room)> larger{};
    /// By how many mm the room must be wider, at a scale, for a block (width, height) in a corner. Null: it has no free
    /// corner.
    std::function<double(double scale, Spot block)> wider_for{};
    /// The size of its strokes at a scale, mm. Null: extent divided by scale.
    std::function<Spot(double scale)> strokes{};
    bool empty = false;           ///< all vectors are zero: a pole and names
    bool spare = false;           ///< shown alone, or if there is room
    bool to_force_scale = false;  ///< has the common scale of forces
    bool fills = false;           ///< drawn to fill its room; its scale is that of the vectors
    bool shrinks = false;  ///< if it fills its room: it may shrink to almost nothing, since no larger room was found
    bool tells_vectors = false;  ///< its scale is that of the vectors, but it keeps the planned size

    /// Whether the scale of the drawn figure is comparable with the planned scale.
    bool tells_its_extents() const { return !empty && !fills && !tells_vectors && !spare; }
    Spot strokes_at(double scale) const { return strokes ? strokes(scale) : Spot{extent_x / scale, extent_y / scale}; }
};

/// The list of figures. Not movable, because the drawing functions refer to it.
class WantedFigures {
public:
    /// `joukowsky`: with the lever, if there is one. Brief: instant centres only if the file asks for them.
    WantedFigures(const DrawingContext& context, bool joukowsky, SolutionDetail detail = SolutionDetail::full);
    WantedFigures(const WantedFigures&) = delete;
    WantedFigures& operator=(const WantedFigures&) = delete;

    /// Polygons of motion are named by their ids; a free body is "body-2", its force polygon, if any, "forces-2".
    std::vector<Wanted> list;
    std::optional<double> force_scale;  ///< of all force polygons, once one could not be drawn larger
    bool keeps_force_scale = false;     ///< all are planned at exactly force_scale

    /// Index into list; empty if no figure has that name.
    std::optional<std::size_t> named(const std::string& name) const;
    /// The solution that a statement belongs to: with all loads, or with those of one body alone.
    const DrawingContext& context_at(StatementIndex statement) const;
    /// Scenes of the polygons of motion, in order.
    const std::deque<PolygonScene>& scenes() const { return scenes_; }
    /// Whether the instant centres are shown.
    bool shows_centres() const;
    /// Whether a figure has so many labels that drawing it for several rooms takes too much time.
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
    std::deque<PolygonScene> scenes_;   // of the polygons of motion; a deque, because references to them are kept
    std::optional<Solution> unscaled_;  // without the scales of the file; made if one of them does not fit
    std::optional<DrawingContext> unscaled_context_;
    std::deque<Solution> alone_;  // by part of the superposition
    std::deque<DrawingContext> alone_contexts_;
};

}  // namespace kinegraph::render
