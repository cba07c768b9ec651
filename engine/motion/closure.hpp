// Closure: the loops of a mechanism as equations between the positions of its bodies, one scalar equation a row, valid
// in every position that the joints and drivers allow. Owns the equations and their gradients; Positions solves them.
#pragma once

#include <array>
#include <vector>

#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

/// Position of a body: the place of its reference (from `Closure::origin`, in `Closure::unit`), its rotation since the
/// drawn pose (rad), and (cos, sin) of that.
template <class Number>
struct BodyPlaceOf {
    VectorOf<Number> at;
    Number turn{};
    VectorOf<Number> facing{1, 0};
};

/// `facing` · `drawn` as complex numbers: a direction that rotates with the body.
template <class Number>
VectorOf<Number> faced(const VectorOf<Number>& facing, const VectorOf<Number>& drawn) {
    return {facing.x * drawn.x - facing.y * drawn.y, facing.x * drawn.y + facing.y * drawn.x};
}

/// One equation between bodies i and j. P = `p` is a place of i, Q = `q` one of j, both relative to the body's
/// reference as drawn; D = P − Q in the current position; `along` a direction of j, of length about 1.
template <class Number>
struct ClosureRowOf {
    enum class Kind {
        together,     ///< along · D = 0, `along` fixed in the frame (+x or +y)
        on_line,      ///< along · D = offset, `along` turning with j; it rolls by `lever`: … + lever (θ_i − θ_j)
        at_distance,  ///< (D² − offset²) / (2 offset) = 0
        turns,        ///< θ_i − θ_j = 0
        rolls_round  ///< D has the direction `along` (as drawn) turned by ψ = share_i θ_i + share_j θ_j:  along(ψ) × D
                     ///< = 0
    } kind = Kind::together;
    BodyIndex i, j;
    VectorOf<Number> p, q, along;
    Number offset{}, lever{}, share_i{}, share_j{};
    int driver = -1;  ///< the driver whose coordinate is added to the right side
};

/// The residual of a row without the driver's coordinate. `facing(ψ)` gives (cos ψ, sin ψ).
template <class Number, class Facing>
Number excess(const ClosureRowOf<Number>& row, const BodyPlaceOf<Number>& i, const BodyPlaceOf<Number>& j,
              Facing facing) {
    using Kind = typename ClosureRowOf<Number>::Kind;
    if (row.kind == Kind::turns) return i.turn - j.turn;
    const VectorOf<Number> d = i.at + faced(i.facing, row.p) - j.at - faced(j.facing, row.q);
    switch (row.kind) {
        case Kind::together: return dot(row.along, d);
        case Kind::on_line: return dot(faced(j.facing, row.along), d) - row.offset - row.lever * (i.turn - j.turn);
        case Kind::at_distance: return (squared_length(d) - row.offset * row.offset) / (Number(2) * row.offset);
        default: return cross(faced(facing(Number(row.share_i * i.turn + row.share_j * j.turn)), row.along), d);
    }
}

/// The equations of a mechanism. Lengths are in `unit`, a power of two near the drawing's size; places are from
/// `origin`.
struct Closure {
    using Row = ClosureRowOf<Exact>;
    struct Body {
        Vector reference;  ///< as drawn, from `origin`
        int x = -1,
            turn = -1;  ///< columns of its place (x, then y) and rotation; x < 0: a hinge on the frame fixes its
                        ///< reference
    };
    Exact unit;
    Vector origin;   ///< m; zero unless the drawing is far from that of the file, where doubles would lose digits
    int bits = 100;  ///< of the pose
    std::vector<Body> bodies;
    std::vector<Row> rows;
    int columns = 0;

    /// A place (m), from `origin` and in `unit`.
    Vector seen(const Vector& place) const { return (1 / unit) * (place - origin); }
    BodyPlaceOf<Exact> drawn(BodyIndex body) const { return {bodies[at_index(body)].reference, 0, {1, 0}}; }
};

/// Errors: a joint whose shape the file does not give, so that no other position is determined.
Result<Closure> closure_of(const Mechanism& mechanism, const Pose& pose);

/// The carrier of a named point: a body, or, at a contact, the profiles themselves.
struct Carrier {
    BodyIndex body;
    JointIndex contact;
};
/// By PointIndex. The pin of a slot belongs to the first body of its joint, and so does the point of a sleeve unless
/// its second body is pinned there. A point that several bodies list without a pin belongs to the first of them.
/// Errors: a point that two joints need on bodies that come apart.
Result<std::vector<Carrier>> carriers_of(const Mechanism& mechanism);

/// The profile at a contact: a straight line, or a centre at `reach` along the normal n from P (a tip is its own
/// centre).
struct ContactSide {
    bool straight = false;
    PointIndex centre;
    Exact reach;
};
/// The sides of bodies[0] and bodies[1]; none where a profile is not given.
std::optional<std::array<ContactSide, 2>> sides_of(const Mechanism& mechanism, const Pose& pose, const Joint& joint);

}  // namespace kinegraph
