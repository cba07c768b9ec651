// Structure: which places of which bodies move together. A node is a place on one body, or on several that a pin or a
// weld joins there. A place on two bodies without a pin gives two nodes (A of the slider, A* of the guide). Contains
// the topology only, no positions and no velocities.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "constructions/kinematics/locus.hpp"
#include "engine/board/board.hpp"
#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

struct Node {
    PointIndex point = none;        ///< none: an auxiliary point of the construction
    int auxiliary = -1;             ///< index of the auxiliary point, if it is one
    std::vector<BodyIndex> bodies;  ///< in the file's order
    std::string label;              ///< "A", "A*", "S"
    bool carried = true;            ///< false: the body does not carry this place in the file
    bool of_interest = true;        ///< its motion is wanted as a result, not only as an intermediate step
};

/// A joint in which one body slides on another, as seen from one of them.
struct Slide {
    JointIndex joint = none;
    BodyIndex other = none;
    bool inverse = false;  ///< this body carries the guide
};

/// A pair with two freedoms, as seen from one body: its place `own` can move past the place `others` of the other body
/// along one line only. A contact of circular or straight profiles is one, by its equivalent linkage.
struct Passage {
    enum class Kind {
        slot,     ///< in a slot of one body, straight or curved about a centre (own = others)
        link,     ///< on the equivalent link between two centres of curvature: ⟂ to it
        tangent,  ///< along the common tangent of a contact of unknown curvatures: accelerations are not determined
        mesh      ///< along the common normal of two pitch curves, which roll on each other (own = others)
    };
    Kind kind = Kind::slot;
    JointIndex joint = none;
    BodyIndex other = none;
    PointIndex own = none, others = none;
    bool inverse = false;  ///< this body carries the guide (slots)
};

/// Rolling without slip, as seen from one body: the points in contact have equal velocities.
struct Rolling {
    JointIndex joint = none;
    BodyIndex other = none;
    PointIndex point = none;
};

class Structure {
public:
    /// Uses `scratch` to test whether the centres of curvature at a contact coincide.
    Structure(const Mechanism& mechanism, Board& scratch);

    const Mechanism& mechanism() const { return mechanism_; }
    const std::vector<Node>& nodes() const { return nodes_; }
    const Node& node(NodeIndex node) const { return nodes_[at_index(node)]; }
    /// The node of a point on a body, or none.
    NodeIndex find(PointIndex point, BodyIndex body) const;
    /// The same; adds the node (with carried = false) if the body does not carry the point.
    NodeIndex on(PointIndex point, BodyIndex body, bool of_interest = false);
    /// The size of the structure at some time; `rewind` removes what was added later, when a plan fails.
    struct Mark {
        std::size_t nodes = 0, auxiliaries = 0;
        int named = 0;
    };
    Mark mark() const { return {nodes_.size(), auxiliaries_.size(), named_auxiliaries_}; }
    void rewind(const Mark& mark);
    /// Assur's point of a body: where the perpendiculars to two loci meet.
    NodeIndex add_auxiliary(BodyIndex body, const Locus& first, const Locus& second);
    const std::array<Locus, 2>& auxiliary(int index) const { return auxiliaries_[at_index(index)]; }
    const std::vector<NodeIndex>& nodes_of(BodyIndex body) const { return nodes_of_[at_index(body)]; }
    /// Sleeves (prismatic pairs) of a body, in the file's order.
    const std::vector<Slide>& sleeves_of(BodyIndex body) const { return sleeves_[at_index(body)]; }
    /// Pin-slots, contacts and gears of a body: they constrain one place only.
    const std::vector<Passage>& passages_of(BodyIndex body) const { return passages_[at_index(body)]; }
    const std::vector<Rolling>& rollings_of(BodyIndex body) const { return rollings_[at_index(body)]; }
    /// Whether the curvatures at a rolling joint or contact are given and differ, so that accelerations can be drawn.
    bool has_curvatures(JointIndex joint) const { return curvatures_[at_index(joint)]; }
    /// Bodies that turn together with a body: through sleeves and welds.
    const std::vector<std::pair<BodyIndex, JointIndex>>& same_spin(BodyIndex body) const {
        return same_spin_[at_index(body)];
    }
    /// Whether a joint connects the body to the frame.
    bool is_guided_by_frame(BodyIndex body) const { return guided_[at_index(body)]; }
    const std::string& body_name(BodyIndex body) const { return mechanism_.bodies[at_index(body)].name; }

private:
    NodeIndex add(Node node);
    static bool finds_curvatures(const Joint& joint, Board& scratch);
    void add_passages(JointIndex joint);
    void add_passage(Passage::Kind kind, JointIndex joint, BodyIndex slider, PointIndex place, BodyIndex guide,
                     PointIndex guides_place);
    const Mechanism& mechanism_;
    std::vector<Node> nodes_;
    std::vector<std::vector<NodeIndex>> nodes_of_;
    std::vector<std::vector<NodeIndex>> nodes_at_;  ///< by PointIndex
    std::vector<std::vector<Slide>> sleeves_;
    std::vector<std::vector<Passage>> passages_;
    std::vector<std::vector<Rolling>> rollings_;
    std::vector<bool> curvatures_;  ///< by JointIndex
    std::vector<std::vector<std::pair<BodyIndex, JointIndex>>> same_spin_;
    std::vector<bool> guided_;  ///< by BodyIndex: a joint connects it to the frame
    std::vector<std::array<Locus, 2>> auxiliaries_;
    int named_auxiliaries_ = 0;
};

}  // namespace kinegraph
