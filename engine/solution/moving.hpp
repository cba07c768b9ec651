// Moving: what it takes to move a mechanism and its construction elsewhere than here, as data: the closure of the
// joints with a start for Newton's method all along each driver's travel, and for each stretch of it the program whose
// guards hold there. Knows no figure and no page. Made by constructions/moving/moving.hpp.
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

/// A given whose value hangs on the position, and the rule by which it follows from the places.
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
        rate,     ///< of a driver with a law
        acceleration,
        setting  ///< as it was planned with, times what Moving::settings[index] has become
    } rule = Rule::place;
    int given = 0;  ///< index in Program::givens
    int index = -1;
    std::array<PointIndex, 2> ends{};
    std::array<BodyIndex, 2> bodies{};
    double factor = 1, offset = 0;
};

/// A construction that holds for a stretch: its program, and which elements are drawn, under names that are the same in
/// all plans.
struct MovingPlan {
    Program program;
    std::vector<ValueOf<double>> givens;  ///< in the position where it was planned
    std::vector<MovingGiven> moving;
    /// By column of Moving::columns: the element that holds it; none: it is zero where `known`.
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
    /// A vertex of a polygon under its label's name, an instant centre ("P_13", figure empty).
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
    /// What marks of figures of forces, curvature and the lever go with (engine/solution/held.hpp).
    struct Held {
        std::string name;
        ElementIndex place, vector, couple;
    };
    std::vector<Held> held;
};

/// One driver on its way, the others at rest as drawn.
struct MovingCourse {
    int driver = 0;
    std::string name;
    bool turns = true;
    double rate = 0;  ///< of the coordinate as drawn; zero: it has no time of its own
    Travel travel;
    bool by_law = false;  ///< `at` of the samples is a time, and only these positions are shown
    std::vector<double> shares;
    struct Sample {
        double at = 0, coordinate = 0;  ///< rad or m, zero as drawn
        std::vector<double> q;          ///< by column of the closure; a start for Newton's method
        int plan = -1;                  ///< index in Moving::plans; −1: no construction holds here
        double rate = 0, acceleration = 0;
        /// Where a verdict drowns in doubles (a body all but at rest): by column what the exact construction found;
        /// else empty.
        std::vector<std::optional<double>> values;
    };
    std::vector<Sample> samples;  ///< in the order of the way
};

/// Something given that may be changed while all else stays: a driver's rate, the size of a load, the length of a bar,
/// how far apart the frame's two hinges are, a parameter of the file. Never zero: verdicts hang on that.
struct MovingSetting {
    enum class Kind {
        velocity,
        acceleration,
        load,
        bar,       ///< of a body that two hinges hold: all its places, seen from its reference, in proportion
        ground,    ///< the hinge at `ends[1]` goes along the line from the one at `ends[0]`
        parameter  ///< see MovingEffect
    } kind = Kind::velocity;
    int of = 0;  ///< index of the driver, the load or the body in the mechanism
    std::string name;
    QuantityKind unit = QuantityKind::angular_velocity;
    double value = 0;               ///< SI, as given; of a parameter in `written_unit`
    std::string written_unit = {};  ///< of a parameter, as the file writes it: "mm"; of a bare number empty
    std::array<PointIndex, 2> ends{};
    double radians = 0;  ///< of a parameter that is an angle: its written unit; else 0
};

/// A number of the closure, of a plan or of the settings that follows from parameters of the file:
///   number = (what the file gives) + Σ by · Δ_first · Δ_second,
/// where Δ_2i of setting i is its value less what the file gives; of an angle Δ_2i is that of its cosine, Δ_2i+1 of its
/// sine.
struct MovingEffect {
    enum class List {
        row,    ///< `item` of Moving::rows; `part` 0 … 9 as they stand in ClosureRowOf, from p.x to share_j
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
    std::vector<MovingEffect> effects;  ///< of the settings that are parameters
    /// A parameter that can be changed in the file alone, and why.
    struct Fixed {
        enum class Why {
            otherwise,  ///< what follows from it does so in another way, or makes another mechanism
            nothing,    ///< nothing follows, but at most where the mechanism is drawn
            zero,       ///< verdicts hang on that
            many        ///< enough were taken before
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
