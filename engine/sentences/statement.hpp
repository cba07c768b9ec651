// Statements: the sentences of a solution as data. A symbol is the written form of a quantity, a message is a sentence
// that can be rendered in any language, an equation is a vector equation with what is known of each term. Independent
// of languages and fonts.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/mechanism/mechanism.hpp"
#include "lang/words.hpp"

namespace kinegraph {

/// The written form of a quantity: v_B, a_BA^t, ω_3, α_3, P_13, a (image of A). See docs/notation.md.
struct Symbol {
    enum class Letter {
        point,
        image,
        pole,
        v,
        a,
        omega,
        alpha,
        centre,
        length,
        radius,
        diameter,
        error,
        F,
        M,
        speed,
        body
    };
    Letter letter = Letter::point;
    std::string about;  ///< subscript: "B", "BA" (of B relative to A), "3"; for point, image and body the name itself
    std::string term;   ///< superscript: "n", "t", "rel", "tr", "cor", "∞", "′"
    friend bool operator==(const Symbol&, const Symbol&) = default;
};
/// Whether the file's name of a force or couple is a complete symbol: F, F_gas, F1, M4, T4. Otherwise it is the
/// subscript of F or M.
bool has_own_name(const Symbol& symbol);
/// The relative velocity of a Coriolis term: v_AA* of a_AA*^cor, v_B^rel of a_B^cor. `observed`: seen by an observer.
Symbol velocity_of_coriolis(Symbol coriolis, bool observed);
/// A force where its couple moves it, F_i3′: one force in place of both. With the name of the first it would be added
/// twice.
Symbol moved_aside(Symbol force);
bool is_moved_aside(const Symbol& symbol);
Symbol where_it_acts(Symbol force);  ///< F_i3 of both
/// Plain name for ids, tables and results: "v_B", "a_BA_t", "omega_3", "P_13", "b", "b'".
std::string name_of(const Symbol& symbol);

/// Whether it is a part of a sentence, before or after a colon. The sentences and phrases are in lang/en.txt, with what
/// their places hold.
bool is_phrase(const Key& sentence);

/// One argument of a sentence.
struct PointName {
    std::string name;
};
struct BodyName {
    /// Bodies: several, "2 + 3". With pin: one with a pin on it, "2+C". Truss: all of it, cut free whole, or a bar of
    /// it. Pin: of a hinge, a node of its own, named by its point.
    enum class As { body, bodies, with_pin, truss, pin };
    std::string name;
    As as = As::body;
};
/// The name of a joint for readers: its point, which is in the drawing, or its own name, which is not.
struct JointName {
    std::string name;
    bool own = false;
};
struct Segment {
    std::string from, to;
};  ///< the join of two points: "O2A"
/// Direction of a line: perpendicular or parallel to a segment, a guide, the normal of a contact …
struct LineReason {
    enum class Kind {
        perpendicular_to_segment,
        parallel_to_segment,
        parallel_to_guide,
        perpendicular_to_guide,
        known,
        driver_component,
        parallel_to_locus,
        given_direction,
        parallel_to_tangent,  ///< common tangent of a contact
        parallel_to_normal    ///< common normal of a contact, of pitch curves
    } kind = Kind::known;
    std::string from,
        to;                 ///< the segment's ends, or `from` the guide's joint or the point with a given direction;
                            ///< `to` then tells drivers of one point apart
    bool own_name = false;  ///< `from` is the name of a joint, not of a point
    friend bool operator==(const LineReason&, const LineReason&) = default;
};
/// The lever that ω² is multiplied by at a rolling contact: from the radii R and r, or r alone on a straight line.
enum class RollingLever { on_straight, outside, inside };
/// A value with its unit; rounded only when printed.
struct Amount {
    double value = 0;
    std::string unit;
};
/// A count, which selects singular or plural.
struct Count {
    int value = 0;
};
/// ω_4/ω_2 = −3.
struct Ratio {
    Symbol above, below;
    double value = 0;
};
using Ratios = std::vector<Ratio>;
/// Names of points, joints or bodies, as a list.
using Names = std::vector<std::string>;
using Symbols = std::vector<Symbol>;
using Argument = std::variant<PointName, BodyName, JointName, Segment, LineReason, Symbol, RollingLever, Amount, Count,
                              Ratios, Names, Symbols, std::string>;

/// Its point; its own name where another sliding joint has the same point.
JointName reader_name(const Mechanism& mechanism, const Joint& joint);
/// Its name in the file.
inline JointName file_name(const Joint& joint) { return {joint.name, joint.named}; }

/// Worked arithmetic where a sentence computes a number: ω_3 = 0.196/0.15 = 1.31 rad/s.
struct Working {
    Symbol of;
    struct Factor {
        double value = 0;  ///< in units that combine to the result's unit
        bool squared = false;
        bool own_sign = false;  ///< its minus stays with it: −0.07 in brackets
    };
    std::vector<Factor> factors;  ///< none: measured in the drawing
    std::optional<double> divisor;
    Amount result;
    /// Without factors: it is their sum. With factors: each factor is multiplied by one of these: ΣF·b.
    std::vector<double> summands = {};
    /// The direction of a Coriolis term: the relative velocity turned by a quarter turn in the sense of ω.
    struct Turned {
        Symbol velocity, with;
    };
    std::optional<Turned> turned = {};
};
struct Message {
    Key sentence;  ///< of lang::sentences or lang::phrases
    std::vector<Argument> arguments;
    std::vector<Working> worked_arithmetic = {};  ///< printed after the sentence
};

/// A term of a vector equation and what is known of it before the polygon is drawn.
struct Term {
    Symbol symbol;
    bool magnitude_known = false;
    bool direction_known = true;
    LineReason line;        ///< the reason for its direction, for the table's third row
    BodyIndex body = none;  ///< the body whose colour it has
};
/// side[0] = side[1] (= side[2]): each side a sum of terms.
struct Equation {
    std::vector<std::vector<Term>> sides;
};

}  // namespace kinegraph
