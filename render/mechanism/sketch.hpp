// A mechanism being drawn at one scale: its layout on paper and the layers of marks that symbols are drawn in. What can
// be drawn of it stands below, each in a file of its own that knows nothing of the others.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "render/mechanism/layout.hpp"
#include "render/page/figure.hpp"
#include "render/page/labels.hpp"
#include "render/page/scale.hpp"
#include "render/scene/drawing_context.hpp"

namespace kinegraph::render::drawing {

/// Marks by the role that they play, from the paper up.
struct Layers {
    std::vector<Mark> tints, construction, ground, bodies;
    std::vector<Mark> over_bodies;  ///< construction that a filled body would hide
    std::vector<Mark> pins, arrows, centres, dimensions;
    std::vector<LabelRequest> labels;
};

class Sketch : public Layout, public Layers {
public:
    Sketch(const Subject& of, const DrawingContext& drawing, double metres_per_millimetre, std::string prefix)
        : Layout(of, drawing.theme, metres_per_millimetre), context(drawing), prefix_(std::move(prefix)) {}

    const DrawingContext& context;
    std::vector<Bar> arcs_of_drivers;  ///< from the pivot to the arrow: ground turns away from it

    /// Legal, and met once in the figure.
    std::string id(std::string_view kind, std::string_view name);
    RichText name_of_point(PointIndex point) const;
    /// Beside a place, in the usual size; what it is told further is set in the label.
    LabelRequest& add_label(RichText text, Colour colour, Spot at, double clearance, StatementIndex statement = none);

    Pen thin() const { return {theme.thin, theme.secondary, {}, false}; }  ///< of construction
    Pen axis() const { return {theme.thin, theme.secondary, dash_dot(), false}; }
    Pen outline() const { return {theme.outline, theme.text, {}, false}; }
    /// In the body's colour and line kind.
    Pen pen_of(BodyIndex body, double width) const {
        BodyColour colour = theme.colour_of(body);
        return {width, colour.line, std::move(colour.dashes), false};
    }

    /// All layers as one figure.
    Figure finish(std::string kind, std::string figure_id, std::string unit_name);
    /// Scale bar below, labels placed, all in its group, its top left corner at the origin.
    void close(Figure& figure, Spot room, bool fixed, double bar_scale, const Unit& bar_unit,
               bool strict = false) const;

private:
    std::string prefix_;
    std::set<std::string> ids_;
};

// The whole mechanism.

void draw_in_colour(Sketch& sketch);
/// The same as a thin grey skeleton, under vectors.
void draw_in_grey(Sketch& sketch);
/// One body cut free, outlined; `Subject::shown` says which of its points.
void draw_alone(Sketch& sketch, BodyIndex body);

// What is said on it.

/// Names of points; those at one place share a label.
void name_points(Sketch& sketch);
/// The name of a point that is shown at a place (mm).
std::optional<RichText> name_of_point_at(const Sketch& sketch, Spot at);
/// "  (AH = 2.31 m)": how far (mm) a place that the drawing cannot hold is from one that it shows.
RichText how_far(const Sketch& sketch, const RichText& from, const RichText& to, double millimetres);
/// The compass strokes that found the points.
void draw_compass(Sketch& sketch);
/// ω of a driven body as an arc about its pivot, the speed of a driven slide or point as an arrow beside it.
void draw_drivers(Sketch& sketch);
/// What the file gives of their accelerations, as arcs and arrows of their own.
void draw_accelerations_of_drivers(Sketch& sketch);
/// What turns, as the solution finds it: ω or α of the bodies as arcs, each with the statement that ends with it.
void draw_turnings(Sketch& sketch, Symbol::Letter letter);
/// The statement that ends with the angular velocity (or acceleration) of a body; none: no one does.
StatementIndex statement_of_turning(const Solution& solution, const Quantity& sought);
/// Instant centres and the lines that find them. The names of those that are left out, where all of them would crowd
/// the figure.
std::vector<RichText> draw_centres(Sketch& sketch);
/// An absolute centre under the velocities: a dot and its name, once; none where a pin stands.
void draw_pole(Sketch& sketch, const InstantCentre& centre);
Symbol symbol_of(const Mechanism& mechanism, const InstantCentre& centre);
void draw_equivalent_linkages(Sketch& sketch);
/// Which of the file's data become dimensions, and where they may not stand.
struct DimensionWish {
    bool all = false;                  ///< even where no place is free
    std::size_t most = 8;              ///< where not all are drawn
    std::set<std::string> left_out{};  ///< ids of groups
    bool sought_far = false;           ///< further out, across links and with the text outside rather than not at all
    std::optional<Box> within{};       ///< which part of the paper they have, mm about the origin of coordinates
};
/// What the file gives, as dimensions, each where it is free; within a room (mm) for all that is drawn.
void draw_dimensions(Sketch& sketch, Spot room, const DimensionWish& wish);
/// The same beside all that the sketch's closed figure has, its names among it: where nothing is in the way, and within
/// the room.
void add_dimensions(Sketch& sketch, Figure& figure, Spot room, const DimensionWish& wish = {});
/// Ids of the dimensions of a finished figure.
std::set<std::string> dimensions_of(const Figure& figure);
/// Ids of the dimensions of a finished figure whose text lies on a line that is not their own: on a leader, say, that a
/// name got later. Of two dimensions in each other's way one is named.
std::set<std::string> covered_dimensions(const Figure& figure, const Fonts& fonts);
/// The number as given: six significant digits without the zeros that only fill, four where the value is not round.
std::string given_number(double value, Language language);

}  // namespace kinegraph::render::drawing
