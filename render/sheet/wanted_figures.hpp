// Wanted figures: what a solution has to show on its sheet, in order, each with what it measures and who draws it. Chooses no
// place; computes no mechanics.
#pragma once

#include <array>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "render/figures/figure.hpp"
#include "render/tables/tables.hpp"

namespace kinegraph::render {

bool has_forces(const Solution& solution);
bool has_motion(const Solution& solution);
/// Motion and forces: each on pages of its own.
bool is_mixed(const Solution& solution);
/// Whether the text pages show the circle of the centres, and the velocities on the mechanism.
bool has_circle(const Solution& solution);
bool has_velocities(const Solution& solution);

/// A drawing that wants a cell: what it measures and who draws it.
struct Wanted {
    std::string name;                   ///< by which it may be asked for alone
    double extent_x = 0, extent_y = 0;  ///< in the units of its scale; 0 where nothing depends on it
    double rim_x = 20, rim_y = 14;      ///< what lettering takes, mm
    std::optional<double> asked;
    std::function<Figure(double room_x, double room_y, double coarsest)> draw;
    bool has_equations = false;
    std::array<Block, 2> equations;  ///< beside it: one under the other, side by side
    bool empty = false;              ///< all its vectors are zero: a pole and names
    double weight = 1;               ///< against the other figures of the page
    bool starts_page = false;
    bool to_force_scale = false;  ///< one scale for all of these
    bool fills = false;           ///< drawn to fill its room; its scale is that of its vectors
    int items = 1;                ///< several drawings side by side or in rows
    double caption_width = 60;
    struct Drawn {
        double room_x, room_y;
        Figure figure;
    };
    std::deque<Drawn> drawn;  ///< they stay where they are
    Figure too_coarse;        ///< the last that was
    /// In a room no larger than this it comes no finer.
    struct NoFiner {
        double room_x, room_y;
        double scale;
        bool lacks_details;
    };
    std::vector<NoFiner> no_finer;
    std::vector<Spot> no_corner;  ///< rooms in which it left its equations no corner

    /// Whether its scale is the finest at which it fits its room, so that one drawing of it tells of other rooms.
    bool is_fitted() const { return !fills && !empty && !asked && !to_force_scale && items == 1; }
    /// How it would come in a room, by what was drawn so far, else by its extent and rim; any_scale: not at all.
    struct Expected {
        double scale;
        bool lacks_details;
    };
    Expected expected(double room_x, double room_y) const;
    /// Drawn once for all rooms between the one it was drawn for and what it takes, for the scale is the largest that fits; and
    /// for all that it fits into where no larger scale could. `coarsest`: as of figures.
    const Figure& drawn_into(double room_x, double room_y, double coarsest = any_scale);

private:
    /// Of the drawings that a room would hold.
    const Drawn* finest_within(double room_x, double room_y) const;
    void learn(double room_x, double room_y, const Figure& figure, double scale);
};

/// Their list. Not to be moved: those who draw refer to it.
class WantedFigures {
public:
    /// `measure`: width of a text column, mm; `joukowsky`: with the lever, where there is one.
    WantedFigures(const DrawingContext& context, double measure, bool joukowsky);
    WantedFigures(const WantedFigures&) = delete;
    WantedFigures& operator=(const WantedFigures&) = delete;

    std::vector<Wanted> list;
    std::vector<Wanted> late;          ///< on the pages of text
    std::size_t first_of_forces = 0;   ///< index into list
    std::optional<std::size_t> lever;  ///< index into list
    Block lever_table;
    std::map<StatementIndex, std::size_t> equation_polygon;  ///< statement → index into list
    std::optional<double> force_scale;  ///< common to triangles and closed polygon, once one could not be drawn larger

private:
    using DrawForces = std::function<Figure(double room_x, double room_y, std::optional<double> scale, bool fixed)>;

    void collect_motion();
    void add_mechanism();
    void add_polygon(int polygon, const std::map<StatementIndex, int>& polygon_of);
    void collect_forces(bool joukowsky);
    void add_lines_of_action();
    void add_force_polygons(const std::string& kind, const std::string& name, double extent_x, double extent_y, DrawForces draw);
    void add_free_bodies();
    void add_lever();
    Wanted mechanism(const std::string& name, double extent_x, double extent_y) const;
    Figure lever_with_table(double room_x, double room_y) const;
    std::optional<double> asked(const std::string& figure, double si) const;
    const DrawingContext& unscaled();

    const DrawingContext& context_;
    double measure_;
    std::deque<PolygonScene> scenes_;   // of the polygons of motion; they stay where they are
    std::optional<Solution> unscaled_;  // the same without the file's scales, made when one of them does not fit
    std::optional<DrawingContext> unscaled_context_;
};

}  // namespace kinegraph::render
