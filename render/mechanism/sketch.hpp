// Sketch: a mechanism being drawn at one scale, with its layout and the layers of its marks. The drawing functions are
// declared below; each has its own file and is independent of the others.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/motion/positions.hpp"
#include "render/mechanism/layout.hpp"
#include "render/page/figure.hpp"
#include "render/page/labels.hpp"
#include "render/page/scale.hpp"
#include "render/scene/drawing_context.hpp"

namespace kinegraph::render::drawing {

/// Marks by layer, bottom layer first.
struct Layers {
    std::vector<Mark> tints, construction, ground, bodies;
    std::vector<Mark> over_bodies;  ///< construction lines that a filled body would hide
    std::vector<Mark> pins, arrows, centres, dimensions;
    std::vector<LabelRequest> labels;
};

/// What the scale bar below leaves of the room of a figure.
Spot room_for_labels(Spot room);

class FreePaper;

class Sketch : public Layout, public Layers {
public:
    /// `figure`: in whose name its elements have their ids; empty: in that of the mechanism, as on any figure.
    Sketch(const Subject& of, const DrawingContext& drawing, double metres_per_millimetre, std::string figure)
        : Layout(of, drawing.theme, metres_per_millimetre), context(drawing), figure_(std::move(figure)) {}

    const DrawingContext& context;
    std::set<std::pair<BodyIndex, BodyIndex>> poles;  ///< absolute centres drawn by draw_pole()
    std::shared_ptr<FreePaper> paper{};               ///< see paper_of()
    std::optional<Spot> space{};  ///< width and height that marks and labels should not exceed, mm; none: unlimited

    /// An id that is unique within the figure.
    GroupId id(std::string_view kind, std::string_view name);
    RichText name_of_point(PointIndex point) const;
    /// Requests a label beside a place, in the usual size. Returns the request, for further settings.
    LabelRequest& add_label(RichText text, Colour colour, Spot at, double clearance, StatementIndex statement = none);

    Pen thin() const { return {theme.thin, theme.secondary, {}, false}; }  ///< for construction
    Pen axis() const { return {theme.thin, theme.secondary, dash_dot(), false}; }
    Pen outline() const { return {theme.outline, theme.text, {}, false}; }
    /// Colour and line kind of the body.
    Pen pen_of(BodyIndex body, double width) const {
        BodyColour colour = theme.colour_of(body);
        return {width, colour.line, std::move(colour.dashes), false};
    }

    /// Fills a figure without marks with all layers.
    Figure finish(Figure blank, std::string unit_name);
    /// Completes a figure: adds the scale bar below, places the labels, groups everything and moves the top left corner
    /// to the origin.
    void close(Figure& figure, Spot room, bool fixed, double bar_scale, const Unit& bar_unit,
               bool strict = false) const;

    /// The box of a drawing, larger on the side where wider names stand out of it than on the other: room is left for
    /// names on both sides alike.
    Box with_more_on_one_side(const Box& own, const std::vector<LabelRequest>& requests, Spot within) const;

private:
    std::string figure_;
    std::set<std::string> elements_;
};

// The whole mechanism.

/// `acts`: which distributed loads are drawn; empty: all.
void draw_in_colour(Sketch& sketch, const std::function<bool(const DistributedLoad&)>& acts = {});
/// The same as a thin grey skeleton, under vectors.
void draw_in_grey(Sketch& sketch);
/// The outline of one free body. `Subject::shown` selects its points.
void draw_alone(Sketch& sketch, BodyIndex body);
/// The outlines of a body in another position: strokes, blocks, barrels, slots and rims, in its shape as drawn.
std::vector<Path> moved_outlines(Sketch& sketch, BodyIndex body, const RigidMotion& motion, const Pen& pen);

// Annotations.

/// Names of points; coincident points share a label.
void name_points(Sketch& sketch);
/// The name of a point shown at a place (mm).
std::optional<RichText> name_of_point_at(const Sketch& sketch, Spot at);
/// "  (AH = 2.31 m)": distance between a place outside the drawing and one inside it. The argument is in mm on paper.
RichText how_far(const Sketch& sketch, const RichText& from, const RichText& to, double millimetres);
/// The compass arcs that determine the points.
void draw_compass(Sketch& sketch);
/// Which arrows of motion are drawn.
struct MotionWish {
    bool drivers = true;                    ///< ω of a driven body as an arc, the speed of a driven slide or point
    bool undrivable = false;                ///< also of drivers that move nothing here, as data of a problem
    bool accelerations_of_drivers = false;  ///< as far as they are given, as separate arcs and arrows
    std::size_t most_without_room = most_names;  ///< names of what is found that may stand away from their arcs
    std::vector<Symbol::Letter> found{};  ///< computed ω or α of the bodies, each with the statement that finds it
    bool only_readable = false;  ///< of what is found, only those whose arc finds a place where it is read as theirs
    std::vector<BodyIndex> left_out{};  ///< bodies of which nothing is drawn that is found
};
/// Draws them where they and their names meet nothing that is drawn so far. False if too many names have no such place
/// (not all are drawn then), or if nothing that was found is readable.
bool draw_arrows_of_motion(Sketch& sketch, const MotionWish& wish);
/// The statement that determines the angular velocity or acceleration of a body; none if there is no such statement.
StatementIndex statement_of_turning(const Solution& solution, const Quantity& sought);
/// Instant centres and the lines that determine them. Returns the names of centres that were left out because they
/// would crowd the figure.
std::vector<RichText> draw_centres(Sketch& sketch);
/// An absolute centre in the figure of velocities: a dot with its name, once. Nothing if a pin stands there.
void draw_pole(Sketch& sketch, const InstantCentre& centre);
Symbol symbol_of(const Mechanism& mechanism, const InstantCentre& centre);
void draw_equivalent_linkages(Sketch& sketch);
/// Which given data become dimensions, and where they may stand.
struct DimensionWish {
    bool all = false;              ///< draw all, even where no place is free
    std::size_t most = 8;          ///< maximum number, unless `all`
    std::set<GroupId> left_out{};  ///< groups that are not drawn
    bool sought_far = false;      ///< extended search: further out, across links and with the text outside, rather than
                                  ///< leave a dimension out
    std::optional<Box> within{};  ///< the available part of the paper, mm from the origin of coordinates
};
/// Draws given data as dimensions, each where its place is free. `room`: available width and height of the whole
/// drawing, mm.
void draw_dimensions(Sketch& sketch, Spot room, const DimensionWish& wish);
/// Adds dimensions to the completed figure of the sketch, where they collide with nothing (its labels included) and
/// stay within the room.
void add_dimensions(Sketch& sketch, Figure& figure, Spot room, const DimensionWish& wish = {});
/// Takes the dimensions of a finished figure of the same scale, so that what is drawn from now on avoids them.
void keep_dimensions(Sketch& sketch, const Figure& figure);
/// Ids of the dimensions of a finished figure.
std::set<GroupId> dimensions_of(const Figure& figure);
/// Ids of the dimensions whose text is crossed by a foreign line, such as the leader of a label placed later. Of two
/// dimensions that collide one is returned.
std::set<GroupId> covered_dimensions(const Figure& figure, const Fonts& fonts);
/// A given number: six significant digits without trailing zeros; four if the value is not round.
std::string given_number(double value, Language language);

}  // namespace kinegraph::render::drawing
