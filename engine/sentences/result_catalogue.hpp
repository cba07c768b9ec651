// The catalogue of results: what all quantities of one kind have in common, one row for each kind. Names, units, sizes,
// tables and checks are made from it; values are elsewhere (engine/solution/result_values.hpp).
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "engine/file/units.hpp"
#include "engine/sentences/quantity.hpp"
#include "engine/sentences/statement.hpp"

namespace kinegraph {

/// How far a value may be off, on paper and in the numeric check, by what it is measured in.
struct Tolerance {
    /// How it is read off the drawings, where no quotient or product of two readings is nearer.
    enum class Reading {
        calculated,  ///< from what is read: to a hundredth of it
        in_scale,    ///< to half a millimetre in the scale of a figure
        protractor   ///< to half a degree
    } reading = Reading::calculated;
    /// In the check it may be off by a share of the largest value of its kind. Kinds of one motion or of one load have
    /// one scale, that of `scale`, across the size L of the drawing: ω = v/L, M = F·L.
    QuantityKind scale = QuantityKind::dimensionless;
    int lengths = 0;  ///< the power of L: −1, 0 or 1

    /// The value of this kind that corresponds to one of `scale`.
    double across(double value, double size) const {
        return lengths > 0 ? value * size : lengths < 0 ? value / size : value;
    }
    /// The value of `scale` that corresponds to one of this kind.
    double back(double value, double size) const {
        return lengths > 0 ? value / size : lengths < 0 ? value * size : value;
    }
};
const Tolerance& tolerance_of(QuantityKind unit);

struct ResultKind {
    enum class Subject {
        nothing,
        body,
        two_bodies,
        point,      ///< as carried by a body
        path,       ///< of a point as carried by a body
        joint,      ///< between its two bodies
        action,     ///< of a body or a pin on a body, at a joint
        component,  ///< … along one direction
        load,
        mass,
        effort,
        bar,
        coupler  ///< at the pin at which it drives a link
    };
    /// `along`: a vector that has one direction, and as a column its component along it.
    /// `place`: of a point, which may lie at infinity.
    enum class Shape { scalar, vector, along, place };

    /// What its differences from the check are measured with, across the scales of its unit (Tolerance).
    enum class Scale {
        unit,     ///< the largest value of the unit, which its own values help to set
        given,    ///< the same, which its own values do not set: they may vanish, or are sums of others
        efforts,  ///< the largest of input forces and couples: over a sweep they may be far below the reactions
        own       ///< its own largest value
    };

    Quantity::Kind kind = Quantity::Kind::unnamed;
    Subject subject = Subject::nothing;
    Shape shape = Shape::scalar;
    QuantityKind unit = QuantityKind::dimensionless;  ///< of a load or an effort: of a force, see unit_kind_of
    Scale scale = Scale::own;
    Symbol::Letter letter = Symbol::Letter::point;
    std::string_view name;         ///< in checks, before its subject: "omega", "force"
    std::string_view ending = {};  ///< in checks, behind it: " couple"
    /// Where its values lie in the results file, with `*` for its subject: "bodies/*/omega". In a section with more
    /// than results the last name alone: "velocity". None: elsewhere (docs/results.md).
    std::string_view in_file = {};
    /// Of its column, before its subject: "v" of "v A", "" of "P13", "radius" of "radius C on 3"; none: it has no
    /// column. The axis of a component stands behind a letter ("vx A"), before words ("x resultant 2").
    std::optional<std::string_view> column = std::nullopt;
    /// Whether a sweep has its column only where it is asked for, since it costs time or has gaps.
    bool on_request = false;
    std::string_view sign = {};               ///< its letter where no Symbol has it: "γ"
    std::optional<Key> asked = std::nullopt;  ///< what an exercise asks for, of {0} the symbol and {1} the subject

    /// Of bodies: an angular velocity or acceleration.
    bool turns() const { return unit == QuantityKind::angular_velocity || unit == QuantityKind::angular_acceleration; }
    bool is_velocity() const { return unit == QuantityKind::velocity || unit == QuantityKind::angular_velocity; }
    bool is_acceleration() const {
        return unit == QuantityKind::acceleration || unit == QuantityKind::angular_acceleration;
    }
    bool is_of_curvature() const {
        return unit == QuantityKind::length && (subject == Subject::path || subject == Subject::body);
    }
    /// A force, a couple or a power.
    bool is_of_forces() const {
        return unit == QuantityKind::force || unit == QuantityKind::moment || unit == QuantityKind::power;
    }
};

/// The row of a kind.
const ResultKind& result_kind(Quantity::Kind kind);
inline const ResultKind& result_kind(const Quantity& quantity) { return result_kind(quantity.kind); }
/// All rows, in the order of Quantity::Kind.
std::span<const ResultKind> result_kinds();

/// What a quantity is measured in: that of its row; for a load or an effort, a force or a moment.
QuantityKind unit_kind_of(const Quantity& quantity, const Mechanism& mechanism);

/// The unit that a file uses for a kind of quantity; the SI unit where it has none of its own.
Unit unit_of(QuantityKind kind, const Units& units);

/// ω of a body, and α.
Quantity omega_of(BodyIndex body);
Quantity alpha_of(BodyIndex body);
/// The quantity that ω or α with the name of a body stands for.
Quantity turning_of(BodyIndex body, Symbol::Letter letter);

}  // namespace kinegraph
