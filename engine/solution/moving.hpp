// Moving: data with which a viewer moves a mechanism and its construction: the closure of the joints, with starting
// values for Newton's method along each driver's travel, and for each part of the travel a program whose guards hold
// there. Made by constructions/moving/moving.hpp.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/board/program.hpp"
#include "engine/motion/positions.hpp"
#include "engine/sentences/column.hpp"
#include "engine/sentences/statement.hpp"

namespace kinegraph {

/// A given whose value depends on the position, and the rule that computes it from the places.
struct MovingGiven {
    enum class Rule {
        place,         ///< of point `index`
        guide,         ///< of joint `index`
        guide_unit,    ///< the same as a unit vector
        normal,        ///< of joint `index`, times `factor` (−1: a contact that pushes against it)
        other_normal,  ///< the normal mirrored at the tangent
        tangent,
        between,  ///< unit vector from `ends[0]` to `ends[1]`
        spring,   ///< factor · (distance of the ends − offset), N
        torsion,  ///< −factor · (offset + turn of bodies[0] − turn of bodies[1]), N m
        rate,     ///< rate of a driver with a law
        acceleration,
        setting,  ///< its original value times the change of Moving::settings[index], and turned as that is
        turned    ///< its original value turned as Moving::settings[index] is
    } rule = Rule::place;
    int given = 0;  ///< index in Program::givens
    int index = -1;
    std::array<PointIndex, 2> ends{};
    std::array<BodyIndex, 2> bodies{};
    double factor = 1, offset = 0;
};

/// A construction that is valid on a part of the travel: its program, and the elements that are drawn, under the same
/// names in all plans.
struct MovingPlan {
    Program program;
    std::vector<ValueOf<double>> givens;  ///< in the position for which it was planned
    std::vector<MovingGiven> moving;
    /// By column of Moving::columns: the element with its value; none: it is zero if `known`, else unknown.
    struct Source {
        bool known = false;
        ElementIndex element;
    };
    std::vector<Source> sources;
    struct Vector {
        std::string figure, name;  ///< id of the polygon; data-name
        ElementIndex tail, tip;
        bool vanishes = false;
    };
    std::vector<Vector> vectors;
    /// A vertex of a polygon, named by its label, or an instant centre ("P_13", figure empty).
    struct Spot {
        std::string figure, name;
        ElementIndex point;
    };
    std::vector<Spot> spots;
    struct Line {
        std::string figure, name;  ///< name: reason and order, the same in all plans
        StatementIndex statement;
        ElementIndex line;
        std::vector<ElementIndex> points;
    };
    std::vector<Line> lines;
    /// The names that marks of figures of forces, curvature and the lever are bound to (engine/solution/bindings.hpp).
    struct Binding {
        std::string name;
        ElementIndex place, vector, couple;
        int given = -1;  ///< index of the load, or of the given velocity, that it is; −1: neither
        /// Of a force on a free body: the id of the body's figure, and its data-name.
        std::string figure = {}, symbol = {};
    };
    std::vector<Binding> held;
};

/// One driver along its travel, the others at rest as drawn.
struct MovingCourse {
    int driver = 0;
    std::string name;
    bool turns = true;
    double rate = 0;  ///< of the coordinate as drawn; zero: the course has no time scale
    Travel travel;
    bool by_law = false;  ///< `at` of the samples is a time, and only these positions can be shown
    std::vector<double> shares;
    struct Sample {
        double at = 0, coordinate = 0;  ///< rad or m, zero as drawn
        std::vector<double> q;          ///< by column of the closure; a starting value for Newton's method
        int plan = -1;                  ///< index in Moving::plans; −1: no construction is valid here
        double rate = 0, acceleration = 0;
        /// Where doubles cannot reproduce a verdict (a body nearly at rest): by column the values of the exact
        /// construction; else empty.
        std::vector<std::optional<double>> values;
    };
    std::vector<Sample> samples;  ///< in the order of the travel
};

/// A given that can be changed while everything else stays: a driver's rate, the size of a load, a velocity of a given
/// instantaneous motion, the length of a bar, the distance of the frame's two hinges, a parameter of the file. Never
/// zero, because verdicts depend on that.
struct MovingSetting {
    enum class Kind {
        velocity,
        acceleration,
        load,
        point_velocity,  ///< of the given instantaneous motion
        bar,             ///< a body with two hinges: all its places, relative to its reference, are scaled
        ground,          ///< the hinge at `ends[1]` moves along the line from the one at `ends[0]`
        parameter        ///< see MovingEffect
    } kind = Kind::velocity;
    int of = 0;  ///< index of the driver, the load or the body in the mechanism
    std::string name;
    QuantityKind unit = QuantityKind::angular_velocity;
    double value = 0;  ///< SI, as given; of a parameter in `written_unit`
    /// Of a parameter and of a rate, as the file writes it: "mm", "rpm"; of a bare number empty.
    std::string written_unit = {};
    std::array<PointIndex, 2> ends{};
    /// Of a vector that can be turned too: its direction as drawn, rad.
    std::optional<double> direction = std::nullopt;
    double radians = 0;  ///< for a parameter that is an angle: size of its written unit, rad; else 0
};

/// A number of the closure, of a plan or of the settings that depends on parameters of the file:
///   number = (value in the file) + Σ by · Δ_first · Δ_second,
/// where Δ_2i of setting i is its value minus the file's value; for an angle Δ_2i is the change of its cosine, Δ_2i+1
/// that of its sine.
struct MovingEffect {
    enum class List {
        row,    ///< `item` of Moving::rows; `part` 0 … 9 in the order of ClosureRowOf, from p.x to share_j
        body,   ///< reference of a body, x or y
        point,  ///< local of a point, x or y
        local,  ///< locals of a joint: part / 2 the side, part % 2 x or y
        reach,  ///< reaches of a joint, by side
        guide,  ///< of a joint, x or y
        tangent,
        setting,       ///< value of a setting
        given,         ///< part of a given of a plan
        given_factor,  ///< of a moving given
        given_offset
    } list = List::row;
    int plan = -1, item = 0, part = 0;
    struct Term {
        int first = 0, second = -1;  ///< indices of Δ; −1: Δ_first alone
        double by = 0;
    };
    std::vector<Term> terms;
};

struct Moving {
    double size = 0;  ///< of the drawing, m
    double unit = 1;  ///< of the closure, m
    std::vector<ClosureRowOf<double>> rows;
    std::vector<Closure::Body> bodies;
    std::vector<bool> frozen;
    std::vector<Positions::PointRule> points;
    std::vector<Positions::JointRule> joints;
    std::vector<double> directions;  ///< by body: from its first point to the next, as drawn, rad
    std::vector<MovingSetting> settings;
    std::vector<MovingEffect> effects;  ///< effects of the settings that are parameters
    /// A parameter that can only be changed in the file, and the reason.
    struct Fixed {
        enum class Why {
            otherwise,  ///< its effects have another form, or it changes the structure of the mechanism
            nothing,    ///< it has no effect, except perhaps on the position of the drawing
            zero,       ///< it is zero, and verdicts depend on that
            many        ///< the limit on settings was reached
        } why = Why::otherwise;
        std::string name;
    };
    std::vector<Fixed> fixed;
    std::vector<Column> columns;    ///< angles, places, slides and results
    std::vector<MovingPlan> plans;  ///< the first is that of the drawn position
    std::vector<MovingCourse> courses;
    std::vector<std::pair<std::string, Error>> still;  ///< drivers that cannot be moved, and why
};

}  // namespace kinegraph
