// A mechanism being drawn at one scale: what it takes from the solution (Subject), what each body is made of on paper (Shape) and
// the layers of marks (Sketch). Shared by the files that draw links, symbols and centres; of no use to others.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "render/figures/figure.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render::drawing {

constexpr double overshoot = 7.0;    // of a construction line, mm
constexpr double same_place = 0.02;  // what nobody can tell apart on paper, mm
constexpr double pi_number = std::numbers::pi;

inline std::size_t at_index(int index) { return static_cast<std::size_t>(index); }
/// A place, y downwards.
inline Spot paper_spot(const Vector& v) { return {v.x.to_double(), -v.y.to_double()}; }
/// A direction as a unit, y downwards, of whatever length it is given.
Spot paper_direction(const Vector& v);
inline Spot polar_spot(double angle) { return {std::cos(angle), std::sin(angle)}; }
inline Box grown(Box box, double by) { return {{box.min.x - by, box.min.y - by}, {box.max.x + by, box.max.y + by}}; }
bool contains(const Box& box, Spot spot);
/// The part of the line from + t·along that lies in the box, as an interval of t; from > to where it misses.
struct Interval {
    double from, to;
};
Interval within(const Box& box, Spot from, Spot along);

struct Bar {
    Spot from, to;
};
double distance(Spot spot, const Bar& bar);

/// Where a body is touched by another: the joint, and who touches.
struct Touch {
    std::size_t joint;
    BodyIndex other;
};
/// A round profile: a wheel, a gear, a cam, a roller, or only the arc on which another body slides.
struct Rim {
    enum class Form { wheel, gear, cam, roller, arc } form = Form::wheel;
    Spot centre;
    double radius = 0;
    bool hollow = false;         // the material lies outside
    std::vector<Touch> touches;  // none: a plain disc
};
/// A straight profile from end to end.
struct Flat {
    Bar bar;
    Spot inward;       // unit, into the material
    double depth = 1;  // from the profile to the middle of the stroke: its edge is what touches
    bool rack = false;
    std::vector<Touch> touches;
};

/// Piston in a barrel: a slide between two bodies that something drives, in line with the pins that hold it.
struct Cylinder {
    std::size_t joint;
    Spot rod_end;  // the pin of the rod
    Spot piston;   // on the axis
    Bar barrel;    // its axis, closed end first
};

/// What a body is drawn of, mm.
struct Shape {
    std::vector<Bar> bars;
    std::vector<Bar> edges;   // knife edges, from the end of the bar to the tip
    std::vector<Spot> plate;  // hull; empty: none
    bool solid = false;       // the plate is too slender to show its tint, and its lines are full
    std::vector<Bar> slots;   // centre lines of straight slots
    std::vector<Rim> rims;
    std::vector<Flat> flats;
    Spot middle;  // somewhere on it
};

/// The number as given: six significant digits without the zeros that only fill, four where the value is not round.
std::string given_number(double value, Language language);

/// What the figure takes from the solution, once, in metres with y downwards; scales are tried on it.
struct Subject {
    const Solution& solution;
    const Mechanism& mechanism;
    std::vector<Spot> points;
    std::vector<Spot> guides, normals;      // units, by joint
    std::vector<bool> shown;                // by point: some body carries it
    std::vector<std::vector<int>> corners;  // by body: points its strokes join
    std::vector<bool> mass_centre;          // by point
    Box box;                                // of the mechanism, m
    double shortest = 1e300;                // link, m

    explicit Subject(const Solution& s);

    double size() const { return std::max(box.width(), box.height()); }
    static bool is_fixed_pin(const Joint& joint) {
        return joint.kind == JointKind::revolute && std::find(joint.bodies.begin(), joint.bodies.end(), 0) != joint.bodies.end();
    }
    static bool is_tip(const Joint& joint, BodyIndex body) {
        const auto profile = joint.profiles.find(body);
        return profile != joint.profiles.end() && std::holds_alternative<TipProfile>(profile->second);
    }
    /// A point where the body only touches or is slid upon: no stroke leads there.
    bool touches_there(BodyIndex body, PointIndex point) const;

private:
    void add_corner(BodyIndex body, PointIndex point) {
        std::vector<int>& list = corners[at_index(body)];
        if (std::find(list.begin(), list.end(), point) == list.end()) list.push_back(point);
    }
};

/// The statement that ends with the angular velocity (or acceleration) of a body; −1: none does.
int statement_of_turning(const Solution& solution, const Quantity& sought);

class Clutter;

/// One try at a scale.
class Sketch {
public:
    Sketch(const Subject& subject, const DrawingContext& context, double scale, std::string prefix);

    std::vector<Mark> tints, construction, ground, bodies, pins, arrows, centres, dimensions;
    std::vector<Mark> over_bodies;  ///< construction that a filled body would hide
    std::vector<LabelRequest> labels;

    Spot spot(PointIndex point) const { return spots_[at_index(point)]; }
    Spot spot(const Vector& place) const { return (1 / scale_) * paper_spot(place); }
    const Shape& shape(BodyIndex body) const { return shapes_[at_index(body)]; }
    double size() const { return s_.size() / scale_; }
    double scale() const { return scale_; }  ///< m for each mm
    Box mechanism_box() const { return {(1 / scale_) * s_.box.min, (1 / scale_) * s_.box.max}; }
    /// Legal, and met once in the figure.
    std::string id(std::string_view kind, std::string_view name);

    void draw_in_colour();
    void draw_in_grey();
    /// One body cut free, outlined; `Subject::shown` says which of its points.
    void draw_alone(BodyIndex body);
    void draw_points(bool names);
    void draw_drivers();
    /// What turns, as the solution finds it: ω or α of the bodies as arcs, each with the statement that ends with it.
    void draw_turnings(Symbol::Letter letter);
    void draw_compass();
    void draw_centres();
    void draw_equivalent_linkages();
    /// What the file gives, as dimensions, each where it is free; within a room (mm) for all that is drawn. `all`: even where it
    /// is not. `left_out`: ids of groups that are not to be drawn.
    void draw_dimensions(Spot room, bool all, const std::set<std::string>& left_out);
    void draw_pole(const InstantCentre& centre);
    Symbol symbol_of(const InstantCentre& centre) const;
    /// The name of a point that is shown at a place (mm).
    std::optional<RichText> name_of_point_at(Spot at) const;
    Figure finish(std::string kind, std::string figure_id, std::string unit_name);
    void close(Figure& figure, Spot room, bool fixed, double bar_scale, const Unit& bar_unit, bool strict = false);

private:
    friend class CentresDrawing;
    friend class DimensionsDrawing;

    /// The centre line of a slot curved about a point; radius 0: too narrow to draw.
    struct CurvedSlot {
        Spot centre;
        double radius = 0, from = 0, to = 0;
    };
    CurvedSlot curved_slot(const Joint& joint) const;
    /// ω or α of a body as an arc about a place, with its name.
    struct Turning {
        BodyIndex body = -1;
        Spot pivot, arm{1, 0};
        double reach = 12;  // along the arm, mm
        bool counter_clockwise = true;
        RichText text;
        int statement = -1;
    };
    std::optional<PointIndex> pivot_of_driver(const SpinDriver& spin) const;
    void aim(Turning& turning) const;
    void draw_turning(const Turning& turning, Clutter* clutter);
    Shape shape_of(BodyIndex body) const;
    void cut_knife_edges(Shape& shape, BodyIndex body) const;
    bool covered_by_block(const Joint& hinge) const;
    void draw_crossings(BodyIndex body, const std::vector<BodyIndex>& below, std::vector<Mark>& marks);
    void draw_strokes(const Shape& shape, const Pen& stroke, std::vector<Mark>& marks) const;
    void draw_barrel(const Cylinder& cylinder, BodyIndex body, std::vector<Mark>& marks) const;
    void draw_piston(const Cylinder& cylinder, BodyIndex body, std::vector<Mark>& marks) const;
    void draw_spring(const SpringLoad& spring);
    void find_cylinders();
    const Cylinder* cylinder_of(std::size_t joint) const;
    std::vector<Rim> rims_of(BodyIndex body) const;
    std::vector<Flat> flats_of(BodyIndex body) const;
    Spot bulk_of(BodyIndex body, const Joint& joint) const;
    std::vector<double> tooth_spaces(const std::vector<Touch>& touches, Spot origin, double radius, bool hollow,
                                     BodyIndex body) const;
    void draw_rim(const Rim& rim, BodyIndex body, std::vector<Mark>& marks);
    void draw_gear(const Rim& rim, BodyIndex body, std::vector<Mark>& marks);
    void draw_arc_profile(const Rim& rim, BodyIndex body, std::vector<Mark>& marks);
    bool turns_about(Spot centre, BodyIndex body) const;
    void draw_hub(const Rim& rim, BodyIndex body, std::vector<Mark>& marks);
    void draw_rack(const Flat& flat, BodyIndex body, std::vector<Mark>& marks);
    void draw_fixed_rim(const Rim& rim, double radius, bool outside);
    void draw_bare_contacts(BodyIndex body);
    std::vector<Spot> leaving(PointIndex point) const;
    double crowding(Spot spot, Spot besides) const;
    bool lies_on(BodyIndex body, BodyIndex longer) const;
    std::vector<BodyIndex> drawing_order() const;
    void draw_body(BodyIndex body, const std::vector<BodyIndex>& below);
    void draw_block(const Joint& joint, std::size_t index, std::vector<Mark>& marks);
    void draw_profiles(BodyIndex body, std::vector<Mark>& marks);
    void hatch_arc(Spot centre, double radius, double from, double to, bool outwards);
    void draw_wall(Spot from, Spot to, Spot away);
    void draw_fixed_pin(PointIndex point);
    void draw_guides();
    void draw_slot(const Bar& slot, BodyIndex body, std::vector<Mark>& marks);
    void draw_curved_slot(const Joint& joint, std::vector<Mark>& marks);
    void draw_mass_centre(Spot centre);
    void draw_dot(Spot at);
    void draw_clamp(const Joint& joint);
    void balloon(BodyIndex body);
    Colour line_colour(BodyIndex body) const { return body == 0 ? theme_.text : theme_.body(body).line; }
    /// A thin pen of the body's, in its line kind.
    Pen pen_of(BodyIndex body, double width) const {
        return {width, line_colour(body), body == 0 ? std::vector<double>{} : theme_.body(body).dashes, false};
    }
    Colour letter_colour(BodyIndex body) const { return body == 0 ? theme_.text : theme_.body(body).letter; }
    Colour tint_colour(BodyIndex body) const { return body == 0 ? theme_.paper : theme_.body(body).tint; }
    bool is_wheel(BodyIndex body) const { return m_.bodies[at_index(body)].circle.has_value(); }

    // Measures of the symbols, mm; they shrink where the links are short.
    double shrink_ = 1;
    double pin_radius_ = 1.5 * shrink_, triangle_height_ = 6.2 * shrink_, triangle_half_ = 3.6 * shrink_,
           base_half_ = 5.4 * shrink_;
    double hatch_depth_ = 2.2 * shrink_, hatch_pitch_ = 1.5 * shrink_;
    double slider_half_ = 8.0 * shrink_, slider_side_ = 4.4 * shrink_, sleeve_half_ = 7.5 * shrink_, sleeve_side_ = 3.6 * shrink_;
    double wall_beyond_ = 9.0 * shrink_, axis_beyond_ = 14.0 * shrink_, rod_beyond_ = 9.0 * shrink_;
    double slot_half_ = 10.0 * shrink_, slot_side_ = 2.2 * shrink_;
    double module_ = 1.25;  // of all gears: height of a tooth above the pitch circle

    const Subject& s_;
    const Mechanism& m_;
    const DrawingContext& context_;
    const Theme& theme_;
    double scale_;
    std::string prefix_;
    std::set<std::string> ids_;
    std::vector<Spot> spots_;
    std::vector<Shape> shapes_;
    std::vector<Cylinder> cylinders_;
    std::vector<std::pair<Spot, Spot>> arcs_of_drivers_;  // pivot and where the arrow is: ground turns away from it
};

/// The scale that the file asks for a figure, SI units for each mm.
inline std::optional<double> asked_scale(const Mechanism& mechanism, std::string_view figure) {
    for (const AskedScale& scale : mechanism.scales)
        if (scale.figure == figure) return scale.per_millimetre.to_double();
    return std::nullopt;
}

/// Ids of the dimensions of a finished figure whose text lies on a line that is not their own: on a leader, say, that a name got
/// later. Of two dimensions in each other's way one is named.
std::set<std::string> covered_dimensions(const Figure& figure, const Fonts& fonts);

/// Draws at ever smaller scales until everything, labels too, is within the room. Names do not shrink: at half the scale at which
/// the mechanism itself has room they must take what there is.
template <class Draw>
Figure fitted_figure(double first, bool fixed, double room_x, double room_y, double coarsest, Draw draw) {
    constexpr int most_tries = 12;
    double scale = first, half = 0;
    for (int tries = 0;; ++tries) {
        const bool strict = half > 0 && scale > 0.99 * half, last = tries == most_tries;
        if (!fixed && (scale > coarsest || ((strict || last) && coarsest < any_scale))) return Figure::empty_at(any_scale);
        Figure figure = draw(scale, last, strict);
        const bool fits = figure.box.width() <= room_x && figure.box.height() <= room_y;
        if (fixed || fits || strict || last) return figure;
        const bool labelled = figure.labels.empty();
        if (labelled && half == 0) half = 2 * scale;
        scale = next_scale(scale);
    }
}

}  // namespace kinegraph::render::drawing
