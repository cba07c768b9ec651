// Equations: the closure equations of a mechanism in complex form, as they are written by hand, with their derivatives
// as linear systems in symbols, and what follows from them in numbers: Jacobian, velocity ratios, dead points,
// velocities, accelerations. Takes the mechanism and its pose; nothing of the constructions nor of the numeric check.
//
// Source: vector loops in complex numbers (Raven's method), e.g. Uicker, Pennock, Shigley, Theory of Machines and
// Mechanisms, ch. 2–4; Funaioli, Maggiore, Meneghetti, Lezioni di meccanica applicata, vol. 1.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/drawing/pose.hpp"
#include "engine/file/words.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "engine/motion/mobility.hpp"

namespace kinegraph {

struct Equations {
    /// A letter of the equations: a length (m) or an angle (rad), counter-clockwise positive.
    struct Letter {
        std::string symbol;  ///< "a", "alpha"
        std::string sub;     ///< "", "1"
        bool is_angle = false;
        enum class Role { given, free, dependent } role = Role::given;
        std::string name;          ///< of what varies: "theta 3", "s D", "phi P"; empty of what is given
        BodyIndex body = none;     ///< whose turn it is
        BodyIndex against = none;  ///< … where it is counted from this body
        JointIndex joint = none;   ///< whose slide, distance or direction it is
        double value = 0;          ///< in the drawn position
        Exact exact;               ///< of a length
        Vector unit{1, 0};         ///< of an angle: (cos, sin), within 2^-bits of the pose
        std::optional<double> rate, acceleration;
    };
    /// Indices into `letters`.
    using LetterIndex = int;

    /// The sum of letters and of quarter turns.
    struct Angle {
        std::vector<LetterIndex> letters{};
        int quarters = 0;  ///< 0 … 3
        friend bool operator==(const Angle&, const Angle&) = default;
    };
    /// A vector `length e^{i angle}` from one place to another, as drawn.
    struct Side {
        LetterIndex length = -1;
        Angle angle;
        bool on_the_right = false;  ///< of the equation: passed backwards
        Vector from, to;            ///< m
        BodyIndex body = none;      ///< that carries it; none: a link that stands for a contact or a curved slot
    };

    /// A product: coefficient · letters and sums of rates with powers · cos or sin of an angle.
    struct Term {
        int coefficient = 1;
        std::vector<LetterIndex> lengths{};  ///< factors
        struct Rate {
            std::vector<LetterIndex> sum;  ///< of letters …
            int dots = 1, power = 1;       ///< … derived so often, to that power
        };
        std::vector<Rate> rates{};
        enum class Turn { plain, cos, sin } turn = Turn::plain;
        std::vector<LetterIndex> angle{};
    };
    using Sum = std::vector<Term>;

    /// How the two unknowns of a loop follow from what is known.
    struct Solved {
        enum class Kind {
            iterative,               ///< no closed form
            nothing,                 ///< all is known already
            two_turns,               ///< two constant lengths that turn: law of cosines
            turn_and_slide,          ///< one turns, the other slides in a known direction: projection
            turn_with_slide,         ///< it slides along its own direction
            turn_with_offset_slide,  ///< the same at the end of an arm square to it, which is second: a right triangle
            two_slides               ///< both slide in known directions
        } kind = Kind::iterative;
        int first = -1, second = -1;          ///< of the loop's sides; the one that turns first
        double resultant = 0, direction = 0;  ///< of the known sides, m and rad: what first and second add up to
        /// Where the dyad is stretched or its slide stands square: values of the one driven letter, in (−π, π] or m;
        /// only where nothing else but that letter varies. No value: no such position, a crank turns fully.
        std::optional<std::vector<double>> dead_points;
        /// Where the dyad only touches such a place, so that it goes on beyond it: on one branch or the other.
        std::vector<double> change_points;
        /// Where a crank and the rod of a slide lie in one line, so that the slide rests: the crank's letter and the
        /// slide.
        std::vector<std::pair<double, double>> standstills;
    };
    struct Loop {
        std::vector<Side> sides;
        std::vector<std::string> through;   ///< the joints' names, in order
        std::vector<LetterIndex> unknowns;  ///< that no loop before has
        Solved solved;
    };
    /// Rolling or gears: the sum of its parts keeps its value. A part is ± radius · (sum of ± letters); radius −1: one.
    struct Law {
        enum class Kind { rolling, gear, driver } kind = Kind::rolling;
        JointIndex joint = none;
        struct Part {
            int sign = 1;
            LetterIndex radius = -1;
            std::vector<std::pair<int, LetterIndex>> sum;
        };
        std::vector<Part> parts;
    };
    /// Equations that hold their unknowns together, once those of the blocks before are known.
    struct Block {
        std::vector<int> rows;              ///< of the matrices
        std::vector<LetterIndex> unknowns;  ///< as many, where they can be solved by themselves
    };
    /// An open chain's end: z = sum of its sides.
    struct Reach {
        PointIndex point = none;
        BodyIndex body = none;
        std::vector<Side> sides;
    };

    Words why_not;  ///< not empty: there are none, and this is the reason
    /// Contacts of which only the tangent is known: a slide along it in their place has their velocities, and no more.
    /// Where there are some, nothing is said of accelerations and of other positions.
    std::vector<JointIndex> by_tangent;
    std::vector<Letter> letters;
    std::vector<Loop> loops;
    std::vector<Law> laws;
    std::vector<Reach> reaches;
    std::vector<LetterIndex> unknowns, free;
    std::vector<Block> blocks;

    /// Rows: real and imaginary part of each loop (m), then the laws. f_y by unknowns, f_x by what is free.
    std::vector<std::vector<Sum>> f_y, f_x;
    std::vector<Sum> second_order;                     ///< what the second derivative has besides f_y ÿ + f_x ẍ
    std::vector<std::vector<double>> jacobian, drive;  ///< f_y and f_x in numbers, SI
    int rank = 0;                                      ///< of f_y
    std::optional<double> determinant;                 ///< of f_y, where it is square; zero where it is singular
    bool is_regular() const { return rank == static_cast<int>(unknowns.size()); }
    /// dy/dx by unknown and free letter, and d²y/dx dx′; none where it is not determined.
    std::vector<std::vector<std::optional<double>>> ratios;
    std::vector<std::vector<std::vector<std::optional<double>>>> second_ratios;
    std::vector<LetterIndex> cannot_be_driven;  ///< at a dead point: free letters that rest in every motion

    /// A body's motion by the equations (rad/s, rad/s², m, m/s, m/s²).
    struct BodyState {
        std::optional<double> omega, alpha;
        Vector reference;
        std::optional<std::array<double, 2>> velocity, acceleration;
        std::optional<std::array<double, 2>> velocity_of(const Vector& place) const;
        std::optional<std::array<double, 2>> acceleration_of(const Vector& place) const;
    };
    std::vector<BodyState> bodies;

    const Letter& letter(LetterIndex index) const { return letters[static_cast<std::size_t>(index)]; }
    /// Whose turn against the frame this is the last letter of.
    std::vector<LetterIndex> turn_of(BodyIndex body) const { return turns[at_index(body)]; }
    std::vector<std::vector<LetterIndex>> turns;  ///< by body: the letters that add up to its direction
};

/// The equations of a mechanism in its drawn pose. Where a joint's shape is left open, or there are no joints,
/// `why_not` says so.
Equations equations_of(const Mechanism& mechanism, const Pose& pose);

/// A loop as the results file spells it: "a e^{i alpha} + b e^{i beta} = c".
std::string spelt(const Equations& equations, const Equations::Loop& loop);
std::string spelt(const Equations& equations, const Equations::Law& law);
/// The value of "equations" in the results file (docs/results.md).
std::string equations_json(const Equations& equations);
/// "alpha", "alpha_1".
std::string spelt(const Equations::Letter& letter);

}  // namespace kinegraph
