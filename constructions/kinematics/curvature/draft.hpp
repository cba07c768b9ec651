// The curvature of all bodies during its construction: what is found for each body, its names and sentences.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "constructions/kinematics/motion.hpp"
#include "constructions/kinematics/polygon_pen.hpp"
#include "constructions/kinematics/space_diagram.hpp"
#include "constructions/kinematics/structure.hpp"
#include "engine/board/board.hpp"
#include "engine/solution/curvature.hpp"

namespace kinegraph::curvature {

using Place = PointOn<Plane::drawing>;
using Line = LineOn<Plane::drawing>;
using Arrow = VectorOn<Plane::drawing>;
using Kind = Curvature::Kind;

class CurvatureDraft {
public:
    struct State {
        bool solved = false;
        Curvature result;
        std::optional<Place> pole, inflection_pole;  ///< `inflection_pole` only if the pole moves
    };

    CurvatureDraft(Structure& structure, Board& board, const Motion& motion);

    Structure& structure;
    Board& board;
    SpaceDiagram diagram;
    const Mechanism& mechanism;
    const Motion& motion;

    State& of(BodyIndex body) { return bodies_[at_index(body)]; }
    /// The results of the solved bodies, in the file's order; call last.
    std::vector<Curvature> take_results();

    /// A point of the file with known velocity, or none.
    NodeIndex base_of(BodyIndex body) const;
    /// Whether velocities and accelerations, with ω and α, are known.
    bool is_known(BodyIndex body) const;
    bool is_on_frame(NodeIndex node) const;
    VectorOn<Plane::velocity> velocity(NodeIndex node) {
        return board.vector(board.pole<Plane::velocity>(), motion.velocity.tip(node));
    }
    VectorOn<Plane::acceleration> acceleration(NodeIndex node) {
        return board.vector(board.pole<Plane::acceleration>(), motion.acceleration.tip(node));
    }
    bool rests(NodeIndex node) { return is_on_frame(node) || board.is_zero(velocity(node)); }

    BodyName name(BodyIndex body) const { return {structure.body_name(body)}; }
    Symbol symbol_of_pole(BodyIndex body) const;
    const std::string& name_of(PointIndex point) const { return mechanism.point(point).name; }
    Symbol omega(BodyIndex body) const { return spin_symbol<Plane::velocity>(structure.body_name(body)); }
    std::string free_name(const std::string& letter) const;
    StatementIndex say(BodyIndex body, Key sentence, std::vector<Argument> arguments, const char* source = "");

    /// The points that a body carries in the file, in its order.
    std::vector<NodeIndex> paths_of(BodyIndex body) const;
    /// Adds the result of a point's path, without its centre.
    PathCentre& add_path(BodyIndex body, NodeIndex node);
    static void set_pole(State& state, Place pole);
    /// Also sets the circle's centre and the pole tangent, ⟂ to the diameter.
    void set_inflection_pole(State& state, Place end);

private:
    std::string name_of_centre(const std::string& point) const;

    std::vector<State> bodies_;  ///< by BodyIndex
};

}  // namespace kinegraph::curvature
