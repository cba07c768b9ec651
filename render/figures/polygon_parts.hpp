// Polygon parts: what a polygon figure shows, vectors, construction lines, images, right angles, in mm about its pole;
// and the details, places where vectors are too short to be drawn as such, drawn again at a larger scale. Owns how
// these look and which of them get a detail; knows no protocol and no mechanics.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/figures/figure.hpp"
#include "render/scene/polygon_scene.hpp"

namespace kinegraph::render {

inline constexpr double pole_radius = 0.9;  // mm
inline constexpr double coincident = 0.02;  // mm: drawn as one

/// A thin line; where it is a direction of the construction, with its words beyond the meet that it was drawn to.
struct PolygonLine {
    Spot from, to;
    Pen pen;
    RichText mark;  ///< empty: none
    Spot mark_at, mark_toward;
    bool mark_along = true;  ///< it is turned with the line
    StatementIndex statement = none;
};
struct PolygonVector {
    Spot tail, tip;
    std::string name;  ///< unique in the polygon
    double value = 0;  ///< in the figure's unit
    RichText text;
    BodyColour colour;
    bool internal = false;          ///< a broken line without a head: it falls out of the sum
    bool has_right_angles = false;  ///< a line ⟂ to it through one of its ends is so by construction
    StatementIndex statement = none;
    Spot aside{};  ///< from its place to where it is drawn: beside others that lie on the same line
};
/// Begins the group of a polygon, once it has its kind, caption, scale and unit; drawn by a statement where one is
/// named.
void open_group(Figure& figure, StatementIndex statement = none);

/// What a detail shows of a vector that leaves it.
struct PolygonPiece {
    Spot from, to;
    bool has_tip = false;
    BodyColour colour;
    bool internal = false;
    StatementIndex statement = none;
    Spot aside{};  ///< as PolygonVector's
};
struct PolygonImage {
    using Kind = SceneImage::Kind;
    Kind kind = Kind::image;
    Spot at;
    std::string name;
    RichText text;
    StatementIndex statement = none;
};
/// A right angle of the construction: at an end of a known vector the line of the next one begins.
struct PolygonCorner {
    Spot at;
    Spot first, second;  ///< unit vectors of its legs
    double shorter_leg = 0;
    StatementIndex statement = none;
};
struct PolygonParts {
    std::vector<PolygonLine> lines;
    std::vector<PolygonVector> vectors;
    std::vector<PolygonPiece> pieces;
    std::vector<PolygonImage> images;
    std::vector<PolygonCorner> corners;
    bool opposites_share_label = false;  ///< as forces do: F_32 = −F_23
    bool has_names = true;               ///< else it is drawn for what its strokes take: no labels, no groups
};

/// Vectors that would lie upon each other stand side by side, as in books: the first in its place, each other in the
/// first lane that is free beside it. Their ends are led back to their places by thin lines.
void set_side_by_side(PolygonParts& parts);

/// A place of a figure that is drawn again, larger.
struct Detail {
    Spot centre;
    double radius = 0;  ///< of what it shows, mm of the figure
    double scale = 1;   ///< its own, units per mm
    double magnification = 1;
    std::string letter;  ///< "I", "II", …
};
/// The details that the parts of a figure want; none overlaps another. `letters`: how many the sheet's figure has
/// already; it counts on. `magnified`: how much larger than the polygon the figure is already.
std::vector<Detail> details_of(const PolygonParts& parts, double scale, double magnified, std::size_t& letters);

/// Marks and label requests of the parts. What lies in a detail gets its label there, and the detail a circle here.
void draw_parts(Figure& figure, const DrawingContext& context, const PolygonParts& parts,
                const std::vector<Detail>& details);

/// Whether the details may find places in the room, as far as the strokes of the figure tell, which has neither names
/// nor details yet: what this says no to set_details() can only draw out of the room.
bool may_hold_details(const Figure& strokes, const DrawingContext& context, const std::vector<Detail>& details,
                      Spot room);
/// Draws the details, and their own, each into a free place of the figure or beside it, as figures of kind "detail"
/// after its own group. The figure is finished, its labels are placed. `room`: mm; the figure leaves it only where it
/// has no more. `letters` as above. False where a label of a detail found no free place; the figure is of no use then.
bool set_details(Figure& figure, const DrawingContext& context, const PolygonParts& parts,
                 const std::vector<Detail>& details, Spot room, std::size_t& letters);

/// Letters the details of a finished figure anew, from the `before` that the sheet has already.
void letter_details_on(Figure& figure, const DrawingContext& context, std::size_t before);

}  // namespace kinegraph::render
