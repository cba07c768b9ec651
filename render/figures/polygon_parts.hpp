// Polygon parts: the content of a polygon figure, that is vectors, construction lines, images and right angles, in mm
// about its pole; and the details, which show places with very short vectors at a larger scale. Owns their look and the
// choice of details; depends on no protocol and no mechanics.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/figures/figure.hpp"
#include "render/scene/polygon_scene.hpp"

namespace kinegraph::render {

inline constexpr double pole_radius = 0.9;  // mm
inline constexpr double coincident = 0.02;  // mm; points closer than this are drawn as one

/// A thin line. A direction of the construction has a label beyond the intersection that it was drawn to.
struct PolygonLine {
    Spot from, to;
    Pen pen;
    RichText mark;  ///< empty: none
    Spot mark_at, mark_toward;
    bool mark_along = true;  ///< the label is turned with the line
    StatementIndex statement = none;
};
struct PolygonVector {
    Spot tail, tip;
    std::string name;  ///< unique in the polygon
    double value = 0;  ///< in the figure's unit
    RichText text;
    BodyColour colour;
    bool internal = false;          ///< dashed and without a head, because it cancels in the sum
    bool is_thin = false;           ///< a part of a force
    bool is_resultant = false;      ///< has two heads
    bool has_right_angles = false;  ///< a line through one of its ends is ⟂ to it by construction
    StatementIndex statement = none;
    Spot aside{};  ///< offset that separates it from others on the same line
};
/// Opens the group of a polygon whose kind, caption, scale and unit are set. `statement`: the one that draws it.
void open_group(Figure& figure, StatementIndex statement = none);

/// The part within a detail of a vector that leaves it.
struct PolygonPiece {
    Spot from, to;
    bool has_tail = false, has_tip = false;  ///< that they are ends of the vector
    bool is_resultant = false;
    BodyColour colour;
    bool internal = false;
    StatementIndex statement = none;
    Spot aside{};  ///< as in PolygonVector
};
struct PolygonImage {
    using Kind = SceneImage::Kind;
    Kind kind = Kind::image;
    Spot at;
    std::string name;
    RichText text;
    StatementIndex statement = none;
};
/// A right angle of the construction: at the end of a known vector the line of the next one begins.
struct PolygonCorner {
    Spot at;
    Spot first, second;  ///< unit vectors along its legs
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
};

/// The extent below which so many vectors are a knot, mm: few of their names would find places beside them. 0: so few
/// never are.
double apart_of_knot(std::size_t vectors);

/// Moves vectors that would cover each other apart, as in textbooks: the first on a line keeps its place, dashed sides
/// last, each other one takes the first free lane beside it; of two in a polygon of motion at a very small angle the
/// shorter one is moved. Thin lines connect their ends with their true positions.
void set_side_by_side(PolygonParts& parts);

/// A part of a figure that is drawn again at a larger scale.
struct Detail {
    Spot centre;
    double radius = 0;  ///< of the circle that it shows, mm in the figure
    double scale = 1;   ///< of the detail, units per mm
    double magnification = 1;
    std::size_t number = 0;  ///< in its figure, from 1
    std::string letter;      ///< "I", "II", …
};
/// The necessary details of a figure. They do not overlap. `letters`: number of letters used on the sheet, which is
/// increased. `magnified`: scale of the figure relative to that of the polygon.
std::vector<Detail> details_of(const PolygonParts& parts, double scale, double magnified, std::size_t& letters);

/// Adds the marks and label requests of the parts. Vectors in a detail are labelled there; the detail gets a circle
/// here.
void draw_parts(Figure& figure, const DrawingContext& context, const PolygonParts& parts,
                const std::vector<Detail>& details);

/// A quick test whether the details may find positions in the room, based on the strokes only. If false, set_details()
/// would leave the room.
bool may_hold_details(const Figure& strokes, const DrawingContext& context, const std::vector<Detail>& details,
                      Spot room);
/// Draws the details, and details of these, each at a free position in the figure or beside it, as figures of kind
/// "detail" after its own group. Requires that the labels of the figure are placed. `room`: mm; the figure exceeds it
/// only if there is no space. `letters`: as above. False if a label of a detail found no position; then the figure
/// cannot be used.
bool set_details(Figure& figure, const DrawingContext& context, const PolygonParts& parts,
                 const std::vector<Detail>& details, Spot room, std::size_t& letters);

/// Replaces the letters of the details of a finished figure. `before`: number of letters used earlier on the sheet.
void letter_details_on(Figure& figure, const DrawingContext& context, std::size_t before);

}  // namespace kinegraph::render
