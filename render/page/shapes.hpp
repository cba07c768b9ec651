// Shapes: the strokes and symbols that figures are made of, as marks of the page (mm, y downwards). Owns their geometry
// and the box they cover; knows no mechanism and no scale but that of the bar it draws.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "render/page/page.hpp"
#include "render/page/theme.hpp"
#include "render/text/words.hpp"

namespace kinegraph::render {

/// Line kinds of the drawing: dash-dot axes and lines of action, dashed auxiliary sides.
const std::vector<double>& dash_dot();
const std::vector<double>& dashes();

/// A line kind stretched or shrunk a little, so that it goes round a length a whole number of times.
std::vector<double> going_round(std::vector<double> dashes, double length);

Path line(Spot from, Spot to, Pen pen);
Path polyline(const std::vector<Spot>& spots, Pen pen, bool closed = false);
/// The corners of the convex outline of spots, in order round it.
std::vector<Spot> hull_of(std::vector<Spot> spots);
/// A filled polygon with no edge.
Path filled(const std::vector<Spot>& spots, Colour fill);
/// The same filled with a body's tint or the paper, and stroked: blocks, slots, grounds.
Path panel(const std::vector<Spot>& spots, Colour tint, Pen pen);
/// The corners at ± u ± w about a middle.
std::vector<Spot> corners_about(Spot middle, Spot u, Spot w);
Path circle(Spot centre, double radius, Pen pen);
Path arc(Spot centre, double radius, double from, double to, Pen pen);
Path disc(Spot centre, double radius, Colour fill);
/// The same, its fill a body's tint or the paper.
Path tinted(Path path);
/// A circle filled with a tint or the paper, and stroked: pins, balloons, poles.
Path ring(Spot centre, double radius, Colour tint, Pen pen);
/// Overlays the heavy strokes of `marks` (`least` wide or wider, from the mark `first` on) with the line kind of a body
/// that has one: an edge in its colour, dashes in it on the paper's ground.
void draw_line_kind(std::vector<Mark>& marks, std::size_t first, double least, const BodyColour& body,
                    const Theme& theme);

/// A filled slender arrow from tail to tip (VISUAL measures): the shaft stops inside the head, the tip is exactly on
/// the vertex. Appended to `marks`; a vector shorter than its head gets a smaller head. `dashes` (mm) are those of its
/// shaft.
void draw_arrow(std::vector<Mark>& marks, Spot tail, Spot tip, double width, Colour colour,
                const std::vector<double>& dashes = {});

/// An arc with an arrowhead at its end `to` (radians, clockwise on paper), head 3.2 × 1.15.
void draw_arc_arrow(std::vector<Mark>& marks, Spot centre, double radius, double from, double to, double width,
                    Colour colour);

/// Text on a baseline starting at `origin`; one TextMark for each colour, the words and the rich text on the first.
void set_text(std::vector<Mark>& marks, ShapedLine shaped, Spot origin, Colour colour, const std::string& cls);

/// A two-tone scale bar of a round length, `target` mm or less, its top left at `origin`, with its end values: copies
/// keep it true. `scale` and `unit_in_si` say what a mm is worth and in which unit the values are printed.
void draw_scale_bar(std::vector<Mark>& marks, const Fonts& fonts, const Theme& theme, Spot origin, double target,
                    double scale, double unit_in_si, const std::string& unit, Language language);

/// Marks from index `first` on are drawn by a statement of the solution, where they have none yet.
void belong(std::vector<Mark>& marks, std::size_t first, StatementIndex statement);
/// Paths from index `first` on, beside and in groups, go with that.
void hang(std::vector<Mark>& marks, std::size_t first, const Holds& holds);
/// Everything drawn, strokes with their width, text with its ink; an empty list gives an empty box at the origin.
Box box_of(std::span<const Mark> marks);
/// Moves marks, or one spot; coordinates are snapped to 1e-8 mm.
void move(std::span<Mark> marks, double dx, double dy);
void move(Spot& spot, double dx, double dy);

}  // namespace kinegraph::render
