// Nodes found at the intersection of two loci, and Assur's auxiliary points of bodies with two loci. The easiest
// constructions come first.
#pragma once

#include <vector>

#include "constructions/kinematics/planning/loci.hpp"

namespace kinegraph::planning {

class Meets {
public:
    Meets(Structure& structure, Board& board, KnownMotion& known, Loci& loci)
        : structure_(structure), board_(board), mechanism_(structure.mechanism()), known_(known), loci_(loci) {}

    /// Nodes to try: those of the file, then the places where a sleeve shows a known point of one body on the other.
    std::vector<NodeIndex> candidates();
    /// Intersects two loci; first with places that bodies of the file carry, then with any place on a sleeve.
    bool meet_some_node();
    /// Class III: for a body with two loci, finds its auxiliary point (Assur), or its ω if the loci are parallel.
    bool find_auxiliary();

private:
    /// Adds the places of this body that coincide with known places of a slide's other body.
    void add_places_of_slides(BodyIndex body, bool on_guide);
    /// First what the file asks to find through an observer: the point, or the place under it, by the direction that
    /// the observer's guide allows.
    bool meet_through_observer();
    /// The node's own loci first: their intersection is easier to follow than one of carried loci.
    bool meet_among(const std::vector<NodeIndex>& nodes);
    bool meet_at(NodeIndex node, bool with_carried);
    /// Loci that a body's own slides give to its nodes.
    void own_slides(BodyIndex body, const std::vector<NodeIndex>& nodes, std::vector<Locus>& loci);
    bool auxiliary_from(BodyIndex body, const std::vector<Locus>& loci);

    Structure& structure_;
    Board& board_;
    const Mechanism& mechanism_;
    KnownMotion& known_;
    Loci& loci_;
};

}  // namespace kinegraph::planning
