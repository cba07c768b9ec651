// The graph from which loops are chosen: each pair as the vectors between its bodies (none at a hinge, a slide along a
// guide and its perpendicular offset, the link that replaces a curved slot or two round profiles), bodies that rotate
// together, rolling pairs, and the coordinate of each driver. Without letters.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/equations/equations.hpp"

namespace kinegraph::vector_loops {

using Letter = Equations::Letter;
using LetterIndex = Equations::LetterIndex;
using Angle = Equations::Angle;
using Side = Equations::Side;
using Law = Equations::Law;

/// The mechanism as drawn, and the tolerance for zero lengths.
struct AsDrawn {
    AsDrawn(const Mechanism& of, const Pose& drawn)
        : mechanism(of), pose(drawn), near(std::max(std::ldexp(1.0, -70), 4 * drawn.rounding())) {}

    bool is_nothing(const Exact& length) const { return std::abs(length.to_double()) <= near * pose.size.to_double(); }
    bool is_small(const Exact& share) const { return std::abs(share.to_double()) <= near; }
    Vector unit(const Vector& v) const { return unit_along(v, pose.bits); }
    std::string name_of(BodyIndex body) const { return mechanism.body(body).name; }
    bool are_pinned_at(BodyIndex a, BodyIndex b, const Vector& place) const;

    const Mechanism& mechanism;
    const Pose& pose;
    double near;  ///< lengths below this share of the drawing's size are zero
};

/// The connection of two bodies, as vectors from its carrier to its rider.
struct Edge {
    enum class Kind {
        pin,    ///< no vector
        guide,  ///< a slide along `along` of the carrier, and a perpendicular offset
        link    ///< a constant length with its own direction
    } kind = Kind::pin;
    JointIndex joint = none;
    std::string name;
    BodyIndex carrier = frame, rider = frame;
    Vector along;                      ///< unit, as drawn
    std::optional<Vector> base, head;  ///< its ends on carrier and rider, once chosen
    Vector place;                      ///< of the joint
    bool is_unsupported = false;       ///< the offset, or the link's length, varies too
    int driver = -1;                   ///< the driver of its slide …
    int sense = 1;                     ///< … positive in this sense of `along` as it is now
    std::vector<Side> sides{};         ///< once it has letters: carrier → rider
    LetterIndex slide = -1, across = -1, direction = -1, length = -1;

    std::optional<Vector>& end_on(BodyIndex body) { return body == carrier ? base : head; }
};

/// Bodies that rotate together, and the direction from which their rotation is counted.
struct TurningClass {
    std::vector<BodyIndex> bodies;
    int driver = -1;
    int against = -1;             ///< class relative to which the driver counts its rotation; −1: the frame
    std::optional<Vector> datum;  ///< unit vector: the direction that its letters name
    std::vector<LetterIndex> letters{};
    std::vector<std::pair<Vector, LetterIndex>>
        others{};  ///< other directions of the same bodies, each with the letter of its angle from the datum
};

/// A rolling or meshing pair: the rider's centre lies at `reach` along the normal from the contact.
struct Rolling {
    JointIndex joint;
    int edge = -1;  ///< the edge along whose slide or direction it rolls
    BodyIndex rider, carrier;
    Exact reach, reach_of_carrier;
    bool straight = false;
    BodyIndex arm;           ///< gears: the body that carries both centres, or the centre and the rack's guide
    JointIndex rack = none;  ///< joint between arm and rack
};

/// The graph of the pairs: edges are vectors, nodes are bodies.
struct VectorGraph {
    std::vector<int> class_indices;  ///< by body
    std::vector<TurningClass> classes;
    std::vector<Edge> edges;
    std::vector<Rolling> rollings;
    std::vector<int> driven_apart;  ///< drivers without a coordinate of their own
    std::vector<JointIndex> by_tangent;
    Words why_not;  ///< not empty: the graph does not exist, for this reason

    int class_of(BodyIndex body) const { return class_indices[at_index(body)]; }
};

class PairsAsEdges {
public:
    explicit PairsAsEdges(const AsDrawn& drawn) : drawn_(drawn) {}

    VectorGraph graph();

private:
    void collect_classes();
    void unite(int a, int b);
    void collect_edges();
    Edge edge_of(const Joint& joint, Edge::Kind kind, BodyIndex carrier, BodyIndex rider) const;
    void add_pins(const Joint& joint);
    void add_guide(const Joint& joint);
    void add_contact(const Joint& joint);
    /// A contact of unknown curvatures: the point of one body slides along the common tangent of the other, to first
    /// order.
    void add_tangent(const Joint& joint);
    /// Finds the body that carries both centres of a pair of gears, so that it rotates with their line; or a pinion's
    /// centre and its rack.
    bool find_arm(Rolling& rolling, const Joint& joint, const Vector& centre, const std::optional<Vector>& other) const;
    /// Bodies that no pair connects to the frame get their position as coordinates.
    void hold_unsupported_bodies();
    void take_drivers();
    void take(const SpinDriver& driver, int index);
    void take(const SlideDriver& driver, int index);
    /// A point driver acts on the slide along the same direction that carries the point.
    void take(const PointDriver& driver, int index);

    const AsDrawn& drawn_;
    VectorGraph graph_;
};

}  // namespace kinegraph::vector_loops
