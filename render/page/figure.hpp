// Figure: one drawing to scale, in its own millimetres (y downwards, origin anywhere), with its labels placed. A sheet
// moves figures and never scales them: the scale is chosen when the figure is made.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/file/units.hpp"
#include "render/page/page.hpp"

namespace kinegraph::render {

/// The fill of the circle round a body's number. On the tint of another body an unfilled circle would seem to belong to
/// that body.
struct BalloonGround {
    Colour paper{};
    std::optional<Colour> own{};  ///< the tint that needs no fill; none if another body has the same tint
    BodyIndex body = none;        ///< whose number it is
};

/// A label to be placed near its object.
struct LabelRequest {
    RichText text{};
    double size = 11;  ///< points (typographic)
    Colour colour{};
    Spot anchor{};  ///< the point, or the middle of the vector or line
    std::optional<Spot>
        toward{};  ///< for vectors and lines: they run from anchor toward this; the label stands beside them
    bool is_of_vector = false;  ///< nearer to its line than to any other that has a name, unless a leader leads to it
    double clearance = 2.2;     ///< distance from the anchor to the nearest ink, mm
    bool along = false;         ///< turned to run along the line, as direction marks are
    double balloon = 0;         ///< radius of a circle round the text (body numbers), mm; 0: none
    BodyIndex body = none;      ///< whose number, ω or α it is: its leader may cross that body
    StatementIndex statement =
        none;  ///< the statement of the solution that draws the named object; none: present from the beginning
    std::vector<std::string> names{};       ///< see TextMark::names
    std::string in_file{};                  ///< see TextMark::in_file
    std::size_t detail = 0;                 ///< see TextMark::detail
    std::vector<double> dashes{};           ///< line kind of the balloon, mm
    Holds holds{};                          ///< see Path::holds
    std::optional<BalloonGround> ground{};  ///< fill of the balloon; none: never filled

    /// Of another thing at the same place: "B ≡ P_13".
    void add_name(const RichText& other);
};

/// The leader of a name, from the named object.
struct DrawnLeader {
    Spot from, to;
    BodyIndex body = none;   ///< whose ω or α is named
    bool is_astray = false;  ///< it crosses another body or passes another point; see Figure::strokes
};

/// A stroke of a body of a mechanism.
struct BodyStroke {
    BodyIndex body = none;
    Spot from, to;
};

/// The axis of a vector that is drawn to scale, on paper.
struct DrawnAxis {
    std::string name;  ///< its data-name attribute
    Spot tail, tip;
    std::string detail;  ///< letter of the detail in which it is drawn; empty: the figure itself
};
/// A vector's length on paper.
struct Measured {
    double millimetres = 0;
    std::string detail;  ///< see DrawnAxis::detail
};
/// A region of a figure that is drawn again beside it, enlarged. A circle marks the region.
struct DetailOn {
    std::string letter;
    Spot circle;
    double radius = 0;
    double scale = 0;        ///< in the figure's unit per mm; 0: it is not drawn
    std::size_t number = 0;  ///< in its figure, from 1; letters go on from figure to figure
};

/// What the readers of a figure may do with it; the same for all figures of a kind.
struct FigureTraits {
    /// The results whose constructions need the figure.
    enum class Needed : std::uint8_t { never, always, velocities, accelerations, forces };

    std::optional<QuantityKind> measured{};  ///< what its scale measures: lengths of the mechanism, or vectors
    Needed needed = Needed::never;
    bool lists_scale = true;      ///< among the scales of an exercise
    bool names_unknowns = false;  ///< of the closure equations
    bool has_bars = false;        ///< with the forces of a truss as lengths
};

struct Figure {
    FigureTraits traits;
    std::string data_figure;           ///< text of its attribute data-figure: mechanism, centres, velocity, …
    std::string id;                    ///< of its group: "velocity", "velocity-E-2"
    std::string detail;                ///< the letter of the detail of that figure which it is; empty: the figure
    RichText caption;                  ///< without number and scale
    double scale = 1;                  ///< units of `unit` per mm
    std::string unit;                  ///< SI unit of the data-value attributes: "m", "m/s", "m/s²"
    std::string further_scale;         ///< a second scale, printed beside the first: "1 mm ≙ 5 N"
    Box box;                           ///< bounding box of everything, labels included
    Spot origin;                       ///< position of the origin of coordinates
    double places = 0;                 ///< of a drawing of places: m per mm, whatever the scale of its vectors
    std::optional<double> by_load;     ///< the power of its load with which its lengths grow; empty: not all of them do
    std::vector<Mark> marks;           ///< drawing order; groups nest within the figure
    std::vector<LabelRequest> labels;  ///< empty after place_labels has placed them
    std::vector<BodyStroke> strokes;   ///< of the bodies, one body after the other; labels keep clear of other bodies
    std::vector<RichText> unnamed;     ///< names left out: with all of them none could be read
    std::size_t leaders = 0;           ///< number of names with a leader
    std::vector<DrawnLeader> leader_lines;  ///< the same, one by one
    bool has_scale = true;                  ///< false for a diagram, and for a polygon whose vectors are all zero
    bool has_table = false;                 ///< it contains a table of its vectors or of their powers
    bool has_key = false;                   ///< a key below it lists the names that found no place
    bool lacks_details = false;  ///< some vectors are too short to read, and there was no room for an enlarged detail

    // Filled in by the drawing functions.
    std::vector<DrawnAxis> axes;    ///< all vectors drawn to the figure's scale or to a detail's
    std::vector<DetailOn> details;  ///< in drawing order; nested details after their parents
    std::vector<int> polygons;      ///< of forces that it shows, by their indices in the protocol

    void move(double dx, double dy);
    static Figure empty_at(double scale);
};

/// The id of an element of it.
GroupId id_in(const Figure& figure, std::string element);
/// Opens its group, with scale and unit if it is `to_scale`.
GroupBegin group_of(const Figure& figure, bool to_scale = true, StatementIndex statement = none);

/// The longest drawn length of the vector with that data-name, in its detail if it has one. Empty if the figure does
/// not draw it.
std::optional<Measured> measured_on(const Figure& figure, const std::string& name);

/// Makes an SVG id from a user's name: every byte of UTF-8 except letters, digits, '-', '.', '_' becomes _xHH_.
std::string legal_id(std::string_view name);
/// A link, a joint, … by its name in the file: "link-2".
std::string element_of(std::string_view kind, std::string_view name);

}  // namespace kinegraph::render
