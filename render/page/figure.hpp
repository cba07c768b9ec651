// A Figure: one drawing to scale, in mm of its own (y downwards, origin anywhere), with its labels placed. Sheets put
// figures on paper by moving them, never by scaling: the scale is chosen when the figure is made.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/page/page.hpp"

namespace kinegraph::render {

/// What fills the circle round a body's number where it stands on a tint, which would seem to be its own.
struct BalloonGround {
    Colour paper{};
    std::optional<Colour> own{};  ///< the tint that needs no ground; none where another body has the same
};

/// A label that wants a place near its object.
struct LabelRequest {
    RichText text{};
    double size = 11;  ///< points
    Colour colour{};
    Spot anchor{};  ///< the point, or the middle of the vector or line
    std::optional<Spot>
        toward{};  ///< for vectors and lines: the direction they run (anchor → toward), the label stands beside it
    double clearance = 2.2;  ///< from the anchor to the nearest ink, mm
    bool along = false;      ///< set along the line (turned with it), as direction marks are
    std::string id{};        ///< empty, or the SVG id of the label's group
    double balloon = 0;      ///< radius of a circle round the text (body numbers), mm; 0: none
    StatementIndex statement =
        none;  ///< of the solution, that what it names is drawn by; none: it is there from the beginning
    std::vector<std::string> names{};       ///< as TextMark's
    std::vector<double> dashes{};           ///< line kind of the balloon, mm
    Holds holds{};                          ///< as a Path's
    std::optional<BalloonGround> ground{};  ///< of the balloon; none: it has no ground on any tint
};

/// A vector drawn to scale, where it lies on paper.
struct DrawnAxis {
    std::string name;  ///< its data-name
    Spot tail, tip;
    std::string detail;  ///< letter of the detail that it is drawn in; empty: the figure itself
};
/// A vector's length on paper.
struct Measured {
    double millimetres = 0;
    std::string detail;  ///< as DrawnAxis's
};
/// A place of a figure that is drawn again beside it, larger, with a circle round it.
struct DetailOn {
    std::string id, letter;
    Spot circle;
    double radius = 0;
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
    double places = 0;                 ///< of a drawing of places: m for each mm, whatever its vectors' scale is
    std::vector<Mark> marks;           ///< drawing order; groups nest within the figure
    std::vector<LabelRequest> labels;  ///< until place_labels has set them
    std::vector<RichText> unnamed;     ///< names left out, since with all of them none could be read
    std::size_t leaders = 0;           ///< names that one ties to what they name
    bool has_scale = true;             ///< a diagram has none, nor has a polygon of which all vectors are zero
    bool has_table = false;            ///< what is known of its vectors, or their powers, stands in it
    bool has_key = false;              ///< names that found no place are listed under it
    bool lacks_details = false;        ///< it has vectors too short to be read, and had no room to draw them again

    // What it shows, told by those who draw it.
    std::vector<DrawnAxis> axes;    ///< of all vectors drawn to its scale or to a detail's
    std::vector<DetailOn> details;  ///< in the order drawn; those within others after them

    void move(double dx, double dy);
    static Figure empty_at(double scale);
};

/// The longest stroke of the vector with that data-name: its detail's, where it has one. Nothing where the figure has
/// none.
std::optional<Measured> measured_on(const Figure& figure, const std::string& name);

/// SVG-legal id from a user's name: all but letters, digits, '-', '.', '_' as _xHH_ (bytes of UTF-8).
std::string legal_id(std::string_view name);

}  // namespace kinegraph::render
