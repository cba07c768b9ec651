// Equations: the closure equations of a mechanism in complex form, as written by hand, with their derivatives as linear
// systems in symbols, and the numbers that follow: Jacobian, velocity ratios, dead points, velocities, accelerations.
// Uses the mechanism and its pose only; independent of the constructions and of the numeric check.
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
#include "engine/mechanism/mechanism.hpp"
#include "engine/motion/mobility.hpp"
#include "lang/words.hpp"

namespace kinegraph {

struct Equations {
    /// A letter of the equations: a length (m) or an angle (rad), counter-clockwise positive.
    struct Letter {
        std::string symbol;  ///< "a", "alpha"
        std::string sub;     ///< "", "1"
        bool is_angle = false;
        bool is_radius = false;  ///< of a wheel
        enum class Role { given, free, dependent } role = Role::given;
        std::string name;          ///< for a variable: "theta 3", "s D", "phi P"; empty for a given letter
        BodyIndex body = none;     ///< the body whose rotation it is
        BodyIndex against = none;  ///< … relative to this body
        JointIndex joint = none;   ///< the joint whose slide, distance or direction it is
        double value = 0;          ///< in the drawn position
        Exact exact;               ///< value of a length, m
        Vector unit{1, 0};         ///< (cos, sin) of an angle, within 2^-bits of the pose
        std::optional<double> rate, acceleration;
    };
    /// Indices into `letters`.
    using LetterIndex = int;

    /// A sum of letters and quarter turns.
    struct Angle {
        std::vector<LetterIndex> letters{};
        int quarters = 0;  ///< 0 … 3
        friend bool operator==(const Angle&, const Angle&) = default;
    };
    /// A vector `length e^{i angle}` from one place to another, as drawn.
    struct Side {
        LetterIndex length = -1;
        Angle angle;
        bool on_the_right = false;  ///< whether it stands on the right of the equation: traversed backwards
        Vector from, to;            ///< m
        BodyIndex body = none;      ///< the body that carries it; none: a link that replaces a contact or a curved slot
    };

    /// A product: coefficient · letters and sums of rates with powers · cos or sin of an angle.
    struct Term {
        int coefficient = 1;
        std::vector<LetterIndex> lengths{};  ///< factors
        struct Rate {
            std::vector<LetterIndex> sum;  ///< of letters …
            int dots = 1, power = 1;       ///< … their derivative of this order, to this power
        };
        std::vector<Rate> rates{};
        enum class Turn { plain, cos, sin } turn = Turn::plain;
        std::vector<LetterIndex> angle{};
    };
    using Sum = std::vector<Term>;

    /// How the two unknowns of a loop are computed from the known letters.
    struct Solved {
        enum class Kind {
            iterative,               ///< no closed form
            nothing,                 ///< everything is known already
            two_turns,               ///< two constant lengths that rotate: law of cosines
            turn_and_slide,          ///< one rotates, the other slides in a known direction: projection
            turn_with_slide,         ///< it slides along its own direction
            turn_with_offset_slide,  ///< the same at the end of an arm perpendicular to it, which is second: a right
                                     ///< triangle
            two_slides               ///< both slide in known directions
        } kind = Kind::iterative;
        int first = -1, second = -1;          ///< of the loop's sides; the one that turns first
        double resultant = 0, direction = 0;  ///< sum of the known sides, m and rad; first and second add up to it
        /// Where the dyad is stretched or folded, or its arm is perpendicular to the slide: values of the single driven
        /// letter, in (−π, π] or m; only where no other letter varies. Empty: no such position, a crank turns fully.
        std::optional<std::vector<double>> dead_points;
        /// Values where the dyad only touches such a position and moves on past it, on one branch or the other.
        std::vector<double> change_points;
        /// Values where a crank and the connecting rod of a slide are in line, so that the slide is at rest: the
        /// crank's letter and the slide.
        std::vector<std::pair<double, double>> standstills;
    };
    struct Loop {
        std::vector<Side> sides;
        std::vector<std::string> through;   ///< the joints' names, in order
        std::vector<LetterIndex> unknowns;  ///< those that no earlier loop contains
        Solved solved;
    };
    /// Rolling or gears: the sum of its parts is constant. A part is ± radius · (sum of ± letters); radius −1 stands
    /// for 1.
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
    /// Equations to be solved simultaneously, after those of the earlier blocks.
    struct Block {
        std::vector<int> rows;              ///< of the matrices
        std::vector<LetterIndex> unknowns;  ///< as many as rows, where the block can be solved by itself
    };
    /// The end of an open chain: z = sum of its sides.
    struct Reach {
        PointIndex point = none;
        BodyIndex body = none;
        std::vector<Side> sides;
    };

    Words why_not;  ///< not empty: there are no equations, for this reason
    /// Contacts of which only the tangent is given. A slide along it replaces them; it gives correct velocities only.
    /// If there are any, accelerations and other positions are not available.
    std::vector<JointIndex> by_tangent;
    std::vector<Letter> letters;
    std::vector<Loop> loops;
    std::vector<Law> laws;
    std::vector<Reach> reaches;
    std::vector<LetterIndex> unknowns, free;
    std::vector<Block> blocks;

    /// Rows: real and imaginary part of each loop (m), then the laws. f_y by unknowns, f_x by free letters.
    std::vector<std::vector<Sum>> f_y, f_x;
    std::vector<Sum> second_order;                     ///< the terms of the second derivative besides f_y ÿ + f_x ẍ
    std::vector<std::vector<double>> jacobian, drive;  ///< f_y and f_x in numbers, SI
    int rank = 0;                                      ///< of f_y
    std::optional<double> determinant;                 ///< of f_y, where it is square; zero where it is singular
    bool is_regular() const { return rank == static_cast<int>(unknowns.size()); }
    /// dy/dx by unknown and free letter, and d²y/dx dx′; none where undetermined.
    std::vector<std::vector<std::optional<double>>> ratios;
    std::vector<std::vector<std::vector<std::optional<double>>>> second_ratios;
    std::vector<LetterIndex> cannot_be_driven;  ///< at a dead point: free letters that are at rest in every motion

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
    std::vector<std::vector<LetterIndex>> turns;  ///< by body: the letters whose sum is its direction
};

/// The equations of a mechanism in its drawn pose. Where the file does not give the shape of a joint, or there are no
/// joints, `why_not` gives the reason.
Equations equations_of(const Mechanism& mechanism, const Pose& pose);

/// A loop as the results file writes it: "a e^{i alpha} + b e^{i beta} = c".
std::string spelt(const Equations& equations, const Equations::Loop& loop);
std::string spelt(const Equations& equations, const Equations::Law& law);
/// "alpha", "alpha_1".
std::string spelt(const Equations::Letter& letter);

}  // namespace kinegraph
