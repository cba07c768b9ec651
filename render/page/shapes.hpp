// Shapes: the strokes and symbols of figures, as marks of the page (mm, y downwards), and their bounding boxes.
// Independent of mechanisms; the only scale used here is that of the scale bar.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "render/page/page.hpp"
#include "render/page/theme.hpp"
#include "render/text/words.hpp"

namespace kinegraph::render {

/// Line kinds: dash-dot for axes and lines of action, dashed for internal sides.
const std::vector<double>& dash_dot();
const std::vector<double>& dashes();

/// Stretches or shrinks a dash pattern a little, so that a whole number of periods fits the length of a closed curve.
std::vector<double> going_round(std::vector<double> dashes, double length);

Path line(Spot from, Spot to, Pen pen);
Path polyline(const std::vector<Spot>& spots, Pen pen, bool closed = false);
/// The corners of the convex hull, in order round it.
std::vector<Spot> hull_of(std::vector<Spot> spots);
/// A filled polygon without an edge.
Path filled(const std::vector<Spot>& spots, Colour fill);
/// A stroked polygon, filled with a body's tint or with the paper colour: blocks, slots, grounds.
Path panel(const std::vector<Spot>& spots, Colour tint, Pen pen);
/// The four corners middle ± u ± w.
std::vector<Spot> corners_about(Spot middle, Spot u, Spot w);
Path circle(Spot centre, double radius, Pen pen);
Path arc(Spot centre, double radius, double from, double to, Pen pen);
Path disc(Spot centre, double radius, Colour fill);
/// Marks the fill as a body's tint or as the paper colour (see Path::tinted).
Path tinted(Path path);
/// A stroked circle, filled with a tint or with the paper colour: pins, balloons, poles.
Path ring(Spot centre, double radius, Colour tint, Pen pen);
/// If the body has a line kind, redraws the heavy strokes of `marks` (of width `least` or more, from index `first` on)
/// in it: an edge in the body's colour, with dashes on the paper colour inside.
void draw_line_kind(std::vector<Mark>& marks, std::size_t first, double least, const BodyColour& body,
                    const Theme& theme);

/// Appends a slender filled arrow from tail to tip (measures of VISUAL). The shaft stops inside the head; the tip is
/// exactly at `tip`. A vector shorter than its head gets a smaller head. `dashes` (mm) apply to the shaft.
void draw_arrow(std::vector<Mark>& marks, Spot tail, Spot tip, double width, Colour colour,
                const std::vector<double>& dashes = {});
/// The same with a second head behind the first: a resultant, which acts on nothing, and for which its forces stand.
void draw_double_arrow(std::vector<Mark>& marks, Spot tail, Spot tip, double width, Colour colour);

/// Appends an arc with an arrowhead at its end `to` (radians, clockwise on paper); head 3.2 × 1.15 mm.
void draw_arc_arrow(std::vector<Mark>& marks, Spot centre, double radius, double from, double to, double width,
                    Colour colour);

/// Appends text whose baseline starts at `origin`: one TextMark per colour. The first one carries the words and the
/// rich text.
void set_text(std::vector<Mark>& marks, ShapedLine shaped, Spot origin, Colour colour, const std::string& cls);

/// Appends a two-tone scale bar of a round length of at most `target` mm, with its end values, its top left corner at
/// `origin`. A bar stays true in enlarged copies. `scale`: SI units per mm; `unit_in_si`: size of the printed unit.
void draw_scale_bar(std::vector<Mark>& marks, const Fonts& fonts, const Theme& theme, Spot origin, double target,
                    double scale, double unit_in_si, const std::string& unit, Language language);

/// Sets the statement of the marks from index `first` on, if they have none.
void belong(std::vector<Mark>& marks, std::size_t first, StatementIndex statement);
/// Sets `holds` of the paths from index `first` on, inside groups as well.
void hang(std::vector<Mark>& marks, std::size_t first, const Holds& holds);
/// Bounding box of all marks: strokes with their width, text with its ink. Empty box at the origin for an empty list.
Box box_of(std::span<const Mark> marks);
/// The farthest that a mark may lie from the corner of its page, mm: a kilometre, which every format can write.
constexpr double farthest_mark = 1e6;
/// Whether every coordinate of the marks is a number and none is farther away than that.
bool can_be_written(std::span<const Mark> marks);
/// Translates marks, or one spot. Coordinates are snapped to 1e-8 mm.
void move(std::span<Mark> marks, double dx, double dy);
void move(Spot& spot, double dx, double dy);

}  // namespace kinegraph::render
