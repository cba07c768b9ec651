// Structure: which places of which bodies move as one. A node is a place as carried by one body, or by several that a
// pin or a weld holds together there; a place that two bodies carry without a pin gives two nodes (A of the slider, A*
// of the guide). Knows how bodies hang together; nothing of where they are or how fast.
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
    int auxiliary = -1;             ///< which one, then
    std::vector<BodyIndex> bodies;  ///< in the file's order
    std::string label;              ///< "A", "A*", "S"
    bool carried = true;            ///< false: a place seen on a body that does not carry it in the file
    bool of_interest = true;        ///< its motion is wanted for its own sake, not only as a step to another
};

/// A joint in which one body slides on another, seen from body `moving` (inverse: from the guide's side).
struct Slide {
    JointIndex joint = none;
    BodyIndex other = none;
    bool inverse = false;  ///< the body asked about carries the guide
};

/// What a pair with two freedoms leaves to a place: seen from one body, its place `own` can move past the place
/// `others` of the other body along one line only. A contact of round or straight profiles is one by its equivalent
/// linkage.
struct Passage {
    enum class Kind {
        slot,     ///< in a slot of one body, straight or curved about a centre (own = others)
        link,     ///< on an imaginary link between two centres of curvature: ⟂ to it
        tangent,  ///< along the common tangent of a contact whose curvatures are not given: no word on accelerations
        mesh      ///< along the common normal of two pitch curves, which roll on each other (own = others)
    };
    Kind kind = Kind::slot;
    JointIndex joint = none;
    BodyIndex other = none;
    PointIndex own = none, others = none;
    bool inverse = false;  ///< the body asked about carries the guide (slots)
};

/// Rolling without slip, seen from one of its bodies: the points in contact have one velocity.
struct Rolling {
    JointIndex joint = none;
    BodyIndex other = none;
    PointIndex point = none;
};

class Structure {
public:
    /// `scratch` is asked whether the centres of curvature at a contact fall together.
    Structure(const Mechanism& mechanism, Board& scratch);

    const Mechanism& mechanism() const { return mechanism_; }
    const std::vector<Node>& nodes() const { return nodes_; }
    const Node& node(NodeIndex node) const { return nodes_[at_index(node)]; }
    /// The node of a point on a body, or none.
    NodeIndex find(PointIndex point, BodyIndex body) const;
    /// The same, made (not carried) where the body does not carry the point.
    NodeIndex on(PointIndex point, BodyIndex body, bool of_interest = false);
    /// How much has been added since the file was read; `rewind` takes back what came after, where a plan led nowhere.
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
    /// Sleeves (prismatic) of a body, in the file's order.
    const std::vector<Slide>& sleeves_of(BodyIndex body) const { return sleeves_[at_index(body)]; }
    /// Pin-slots, contacts and gears of a body: they hold at their own place only.
    const std::vector<Passage>& passages_of(BodyIndex body) const { return passages_[at_index(body)]; }
    const std::vector<Rolling>& rollings_of(BodyIndex body) const { return rollings_[at_index(body)]; }
    /// Whether the curvatures at a rolling joint or contact are given and differ, so that accelerations can be drawn
    /// there.
    bool has_curvatures(JointIndex joint) const { return curvatures_[at_index(joint)]; }
    /// Bodies that turn as one with a body: through sleeves and welds.
    const std::vector<std::pair<BodyIndex, JointIndex>>& same_spin(BodyIndex body) const {
        return same_spin_[at_index(body)];
    }
    /// Whether a joint holds the body to the frame.
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
    std::vector<bool> guided_;  ///< by BodyIndex: a joint holds it to the frame
    std::vector<std::array<Locus, 2>> auxiliaries_;
    int named_auxiliaries_ = 0;
};

}  // namespace kinegraph
