// A Figure: one drawing to scale, in mm of its own (y downwards, origin anywhere), with its labels placed. Sheets put figures on
// paper by moving them, never by scaling: the scale is chosen when the figure is made.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "engine/solution.hpp"
#include "render/page/page.hpp"
#include "render/page/theme.hpp"
#include "render/text/text.hpp"
#include "render/text/words.hpp"

namespace kinegraph::render {

struct Box {
    Spot min, max;
    double width() const { return max.x - min.x; }
    double height() const { return max.y - min.y; }
    bool operator==(const Box&) const = default;
};

/// A label that wants a place near its object.
struct LabelRequest {
    RichText text;
    double size = 11;  ///< points
    Colour colour;
    Spot anchor;                 ///< the point, or the middle of the vector or line
    std::optional<Spot> toward;  ///< for vectors and lines: the direction they run (anchor → toward), the label stands beside it
    double clearance = 2.2;      ///< from the anchor to the nearest ink, mm
    bool along = false;          ///< set along the line (turned with it), as direction marks are
    std::string id;              ///< empty, or the SVG id of the label's group
    double balloon = 0;          ///< radius of a circle round the text (body numbers), mm; 0: none
    int statement = -1;          ///< of the solution, that what it names is drawn by; −1: it is there from the beginning
    std::vector<std::string> names;  ///< as TextMark's
    std::vector<double> dashes;      ///< line kind of the balloon, mm
};

struct Figure {
    std::string kind;                  ///< data-figure: mechanism, centres, velocity, acceleration, …
    std::string id;                    ///< SVG id: "velocity", "velocity-E-2"
    RichText caption;                  ///< without number and scale
    double scale = 1;                  ///< `unit` for each mm
    std::string unit;                  ///< SI unit of the data-value's: "m", "m/s", "m/s²"
    std::string further_scale;         ///< of what is drawn to another one, said beside the first: "1 mm ≙ 5 N"
    Box box;                           ///< of everything, labels included
    Spot origin;                       ///< where the origin of its coordinates lies
    std::vector<Mark> marks;           ///< drawing order; groups nest within the figure
    std::vector<LabelRequest> labels;  ///< until place_labels has set them
    bool has_table = false;            ///< what is known of its vectors, or their powers, stands in it
    bool lacks_details = false;        ///< it has vectors too short to be read, and had no room to draw them again

    void move(double dx, double dy);
    static Figure empty_at(double scale);
};

/// Whether the mechanism figure shows the given lengths, radii and angles as dimensions: each that finds a free place, all, none.
enum class Dimensions { automatic, on, off };

struct DrawingContext {
    const Solution& solution;
    const Theme& theme;
    const Fonts& fonts;
    Language language = Language::en;
    Dimensions dimensions = Dimensions::automatic;
};

/// The largest scale of 1-2-2.5-5 × 10ⁿ units per mm at which `extent` units fit into `room` mm; the file's own where it asks
/// one.
double choose_scale(double extent_x, double extent_y, double room_x, double room_y, std::optional<double> asked);
/// The next coarser one of these after any scale.
inline double next_scale(double scale) { return choose_scale(1.001 * scale, 0, 1, 1, std::nullopt); }

/// Of the figures that take a `coarsest` scale (units per mm): one that would have to be drawn coarser, or leave its room, comes
/// empty and at any_scale; whoever sets such a limit has no use for it.
constexpr double any_scale = std::numeric_limits<double>::infinity();

/// SVG-legal id from a user's name: all but letters, digits, '-', '.', '_' as _xHH_ (bytes of UTF-8).
std::string legal_id(std::string_view name);

enum class Labelling {
    free,        ///< labels leave the room where nothing in it is free
    strict,      ///< rather than leave the room, a label goes into the key
    if_it_fits,  ///< none is set where figure and labels do not fit into the room
    if_all_free  ///< none is set where one of them finds no free place
};

/// Gives every request a place where it covers no stroke, no arrowhead and no other label, near its object; deterministic.
/// Appends the TextMarks (class "label") and grows the box. Obstacles are the figure's own marks.
/// `room`: the width and height (mm) that figure and labels should not exceed; a label wider than half of it ends in an ellipsis
/// (its aria-label says it all). What finds no place is listed in a key below the figure, by a number at its object where that
/// finds one; labels that must stay in the room go there rather than leave it. False: none was set.
bool place_labels(Figure& figure, const Fonts& fonts, std::optional<Spot> room = std::nullopt,
                  Labelling labelling = Labelling::free);

/// What the names that a figure asks for will take with the air about them, mm²: places or none.
double room_of_names(const Figure& figure, const Fonts& fonts);

/// A filled slender arrow from tail to tip (VISUAL measures): the shaft stops inside the head, the tip is exactly on the vertex.
/// Appended to `marks`; a vector shorter than its head gets a smaller head.
/// `dashes` (mm) are those of its shaft.
void draw_arrow(std::vector<Mark>& marks, Spot tail, Spot tip, double width, Colour colour,
                const std::vector<double>& dashes = {});

/// The mechanism with pair symbols, ground, body numbers, centres and their lines where `with_centres`, fitted into a room (mm).
Figure mechanism_figure(const DrawingContext& context, double room_x, double room_y, bool with_centres,
                        double coarsest = any_scale);
/// The mechanism with what turns: ω of the bodies (or α), each marked with the statement that finds it.
Figure mechanism_with_turnings(const DrawingContext& context, Symbol::Letter letter, double room_x, double room_y);
/// Velocities drawn on the mechanism, ⟂ to the rays from the absolute centres.
Figure velocities_on_mechanism(const DrawingContext& context, double room_x, double room_y);
/// One body's act of motion: its points, velocities given (dark) and found (in the body's colour), the lines that meet in the
/// centre; where no rigid body moves so, the two projections. Kind and id "mechanism"; velocities are groups of class "velocity"
/// with a scale of their own, which the caption states. Only where the solution has one.
Figure act_of_motion_figure(const DrawingContext& context, double room_x, double room_y);
/// The bookkeeping circle of the instant centres: bodies on a circle, centres as chords numbered in the order found.
Figure circle_diagram(const DrawingContext& context, double room_x, double room_y);
/// One polygon of the protocol (by index): pole, vectors, images, construction lines.
Figure polygon_figure(const DrawingContext& context, int polygon, double room_x, double room_y, double coarsest = any_scale);

// Forces. Triangles and closed polygon share one scale: `least` is the smallest that the other could be drawn at (units per mm),
// and with `fixed` the one the file asks for, kept as long as it fits.

/// Whether there is a force polygon to draw, and the joined ones (indices of polygons).
bool has_force_polygons(const Solution& solution);
std::vector<int> closed_polygons(const Solution& solution);
int force_polygon_count(const Solution& solution);
/// What a force polygon spans, in the file's unit; −1: those of the bodies, one beside the other.
Box extent_of_forces(const Solution& solution, int polygon);
/// What a free body spans with its places of attack and near points of concurrency, m.
Box extent_of_free_body(const Solution& solution, std::size_t index);
/// The mechanism with its lines of action, points of concurrency and the sense of loads, efforts and ground reactions.
Figure mechanism_with_forces(const DrawingContext& context, double room_x, double room_y);
/// The force polygons of the bodies at one scale; each is a group of kind "forces", id "forces-<body>". `tables`: with what is
/// known of each force below, where there is room.
Figure force_polygons_figure(const DrawingContext& context, double room_x, double room_y,
                             std::optional<double> least = std::nullopt, bool fixed = false, bool tables = true);
/// Of a free body, whether the figure has its polygon: two equal and opposite forces make none, the steps say so.
bool has_force_polygon(const Solution& solution, const FreeBody& body);
/// The polygons joined: external forces full, internal sides dashed.
Figure closed_polygon_figure(const DrawingContext& context, int polygon, double room_x, double room_y,
                             std::optional<double> least = std::nullopt, bool fixed = false);
/// A body cut free (index into Solution::free_bodies): kind "body", id "body-<name>"; its scale is that of its forces.
Figure free_body_figure(const DrawingContext& context, std::size_t index, double room_x, double room_y);

// Joukowsky's lever: forces at the tips of the velocities turned a quarter turn; their moments about the pole are the powers
// with the sign changed.

/// Why there is none.
enum class NoLever {
    none,           ///< there is one
    no_forces,      ///< no body was cut free
    no_velocities,  ///< nothing is driven, or not all velocities are known
    nothing_moves,  ///< no force acts at a point that moves
};
NoLever no_lever(const Solution& solution);
/// What the turned velocities span with the pole, in the file's unit of velocity.
Box extent_of_lever(const Solution& solution);
/// Kind "velocity", id "joukowsky"; forces are groups of class "force", with a scale of their own that the caption states. Only
/// where there is one.
Figure joukowsky_figure(const DrawingContext& context, double room_x, double room_y);

}  // namespace kinegraph::render
