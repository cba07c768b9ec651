// Nodes where two loci meet, and auxiliary (Assur) points of bodies with two loci; first what is easiest to see.
#pragma once

#include <vector>

#include "constructions/kinematics/planning/loci.hpp"

namespace kinegraph::planning {

class Meets {
public:
    Meets(Structure& structure, Board& board, KnownMotion& known, Loci& loci)
        : structure_(structure), board_(board), mechanism_(structure.mechanism()), known_(known), loci_(loci) {}

    /// Nodes that may be sought: those of the file, then the places where a sleeve lets one body's known point be seen
    /// on the other.
    std::vector<NodeIndex> candidates();
    /// Where two loci meet; first with the places that the file's bodies carry, then with any place a sleeve may be
    /// seen at.
    bool meet_some_node();
    /// Class III: a body with two loci has its auxiliary (Assur) point known, or its ω where the loci are parallel.
    bool find_auxiliary();

private:
    /// Places at which a slide lets a known place of the other body be seen on this one.
    void add_places_of_slides(BodyIndex body, bool on_guide);
    /// First what the file asks to be found through an observer: where the place under the point, or the point, lies by
    /// what the observer's guide lets through.
    bool meet_through_observer();
    /// Loci of the node itself first: a meet of those is easier seen than one of loci carried from elsewhere.
    bool meet_among(const std::vector<NodeIndex>& nodes);
    bool meet_at(NodeIndex node, bool with_carried);
    /// The loci that a body's own slides give its nodes.
    void own_slides(BodyIndex body, const std::vector<NodeIndex>& nodes, std::vector<Locus>& loci);
    bool auxiliary_from(BodyIndex body, const std::vector<Locus>& loci);

    Structure& structure_;
    Board& board_;
    const Mechanism& mechanism_;
    KnownMotion& known_;
    Loci& loci_;
};

}  // namespace kinegraph::planning
