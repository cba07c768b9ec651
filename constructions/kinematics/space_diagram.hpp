// The space diagram: the mechanism as it stands on one board. Gives the places of nodes and the directions of loci as
// strokes of that board, so that a plan made on scratch paper can be drawn on another. Knows no velocity.
#pragma once

#include "constructions/kinematics/structure.hpp"
#include "engine/board/board.hpp"

namespace kinegraph {

class SpaceDiagram {
public:
    SpaceDiagram(const Structure& structure, Board& board) : structure_(structure), board_(board) {}

    /// An auxiliary point is constructed where the perpendiculars to its two loci meet, drawn through their nodes
    /// (Assur).
    PointOn<Plane::drawing> place(NodeIndex node);
    VectorOn<Plane::drawing> join(NodeIndex from, NodeIndex to) { return board_.vector(place(from), place(to)); }
    /// The line through a node along which the tip of its velocity lies on a locus, turned a quarter: an absolute
    /// centre of the body, or Assur's point, is on it.
    LineOn<Plane::drawing> perpendicular_at(const Locus& locus);
    /// Along which a locus runs.
    DirectionHandle direction(const Locus& locus);

private:
    DirectionHandle across_join(NodeIndex a, NodeIndex b);

    const Structure& structure_;
    Board& board_;
};

}  // namespace kinegraph
