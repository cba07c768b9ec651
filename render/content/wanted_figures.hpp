// Wanted figures: the figures that a solution can show, in the order of the sheet, each with its extent and the
// function that draws it. Chooses no position; computes no mechanics.
#pragma once

#include <algorithm>
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

/// A figure to be placed: what it shows, how large it should be, and the function that draws it.
struct Wanted {
    /// Draws it into a room, mm, within the limits of the wish.
    using Draw = std::function<Figure(Spot room, const ScaleWish& wish)>;

    std::string name;                   ///< the name in the command line
    std::string plain_name{};           ///< of the same figure without what it shows besides
    double extent_x = 0, extent_y = 0;  ///< in the units of its scale; 0: the size does not depend on it
    double subject = 0;                 ///< longer extent of what it is about, such as the links; 0: of all
    double rim_x = 20, rim_y = 14;      ///< of a figure that fills its room: space round its strokes, mm
    double least = 18;                  ///< mm; nothing can be read off the figure if its longer extent is less
    double enough = 200;                ///< mm; it gains nothing from a larger size
    double weight = 1;                  ///< of its score, relative to other figures
    std::optional<double> asked{};      ///< the scale in the file
    Draw draw{};
    /// Adds optional content to a drawn figure. Empty and at any_scale if the room has no space for it. Null: there is
    /// nothing to add.
    std::function<Figure(const Figure& plain, Spot room)> enrich{};
    bool empty = false;           ///< all vectors are zero: a pole and names
    bool spare = false;           ///< shown alone, or if there is room
    bool to_force_scale = false;  ///< has the common scale of forces
    bool may_be_larger = false;   ///< … or a finer one, if it were too small to read
    bool is_row = false;          ///< several polygons side by side, which may stand in several rows
    bool fills = false;           ///< drawn to fill its room; its scale is that of the vectors
    bool has_corner = false;      ///< equations may stand in a free corner of it

    /// The name under which its scale is kept for other sheets, where it may stand without its centres.
    const std::string& kept_as() const { return plain_name.empty() ? name : plain_name; }
    double extent() const { return std::max(extent_x, extent_y); }
    double extent_of_subject() const { return subject > 0 ? subject : extent(); }
    /// The figure in a room, at the scale in the file if it has room at that.
    Figure drawn_in(Spot room) const { return draw(room, {0, asked}); }
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

    /// Index into list; empty if no figure has that name.
    std::optional<std::size_t> named(const std::string& name) const;
    /// Scenes of the polygons of motion, in order.
    const std::deque<PolygonScene>& scenes() const { return scenes_; }
    /// Whether the instant centres are shown.
    bool shows_centres() const;

private:
    Wanted& add(Wanted wanted);
    void collect_motion();
    void add_mechanism();
    void add_polygon(int polygon);
    void collect_forces(bool joukowsky);
    void add_truss();
    void add_lines_of_action();
    Wanted& add_force_polygons(const std::string& kind, const std::string& name, const Box& extent, Wanted::Draw draw);
    void add_free_bodies();
    void add_free_body(const LoadCase& loads, std::size_t index);
    void add_polygons_of_bodies(const DrawingContext& context);
    void add_superposition();
    void keep_forces_readable();
    Wanted* largest_of_forces();
    void add_curvature();
    void add_loops();
    void add_displacements();
    void add_moving_axes();
    void add_small();
    Wanted mechanism(const std::string& name, bool with_centres) const;
    std::optional<double> asked(const std::string& figure, double si) const;

    const DrawingContext& context_;
    SolutionDetail detail_;
    std::deque<PolygonScene> scenes_;  // of the polygons of motion; a deque, because references to them are kept
};

}  // namespace kinegraph::render
