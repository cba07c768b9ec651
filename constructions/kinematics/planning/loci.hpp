// Finds the loci of a node: those that the joints of its bodies give directly, and those carried to it from other nodes
// over bodies with known ω and over rolling contacts.
#pragma once

#include <vector>

#include "constructions/kinematics/planning/known_motion.hpp"

namespace kinegraph::planning {

class Loci {
public:
    Loci(Structure& structure, const std::vector<bool>& drivers, KnownMotion& known)
        : structure_(structure), mechanism_(structure.mechanism()), use_driver_(drivers), known_(known) {}

    /// Only uses places that bodies of the file carry.
    void look_at_carried_places_alone(bool thrifty) { thrifty_ = thrifty; }

    /// The loci of the node itself (not shifted), through any body that carries it except `except`.
    void own_loci(NodeIndex node, BodyIndex except, std::vector<Locus>& loci);
    /// All loci of a node, own and carried, through any body that carries it except `except`.
    std::vector<Locus> loci_of(NodeIndex node, BodyIndex except = none);
    /// The body turns about `base`, whose velocity is known.
    static Locus rotation(BodyIndex body, NodeIndex base, NodeIndex node);

private:
    /// A node whose loci can be carried to the node sought, and the steps from there.
    struct Reached {
        NodeIndex node = none;
        std::vector<Carry> carries;
    };
    /// The node of a point on the other body of a slide, if its velocity is known and it may be used.
    NodeIndex base_on(PointIndex point, BodyIndex other);
    /// The locus of a node of `body` that moves past `base` in a slide or passage. The caller sets the kind.
    template <class Pair>
    static Locus past(const Pair& pair, BodyIndex body, NodeIndex node, NodeIndex base) {
        Locus locus;
        locus.body = body;
        locus.node = node;
        locus.base = base;
        locus.joint = pair.joint;
        locus.guide = pair.inverse ? body : pair.other;
        locus.inverse = pair.inverse;
        return locus;
    }
    void add_sleeve(const Slide& slide, NodeIndex node, PointIndex point, BodyIndex body, std::vector<Locus>& loci);
    void add_passage(const Passage& passage, NodeIndex node, BodyIndex body, std::vector<Locus>& loci);
    /// The nodes whose loci can be carried to this one, on bodies with known ω and over rolling contacts; nearest
    /// first.
    std::vector<Reached> reached_from(NodeIndex node);

    Structure& structure_;
    const Mechanism& mechanism_;
    const std::vector<bool>& use_driver_;
    KnownMotion& known_;
    bool thrifty_ = false;
};

}  // namespace kinegraph::planning
