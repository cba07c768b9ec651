#include "constructions/kinematics/curvature/draft.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include "engine/sentences/centre_symbol.hpp"

namespace kinegraph::curvature {

CurvatureDraft::CurvatureDraft(Structure& of_mechanism, Board& on, const Motion& known)
    : structure(of_mechanism),
      board(on),
      diagram(structure, board),
      mechanism(structure.mechanism()),
      motion(known),
      bodies_(mechanism.bodies.size()) {}

std::vector<Curvature> CurvatureDraft::take_results() {
    std::vector<Curvature> results;
    for (State& state : bodies_)
        if (state.solved) results.push_back(std::move(state.result));
    return results;
}

NodeIndex CurvatureDraft::base_of(BodyIndex body) const {
    for (const NodeIndex node : structure.nodes_of(body))
        if (motion.velocity.has(node) && structure.node(node).point != none) return node;
    return none;
}

bool CurvatureDraft::is_known(BodyIndex body) const {
    const NodeIndex base = base_of(body);
    return motion.velocity.turns(body) && base != none && motion.acceleration.polygon >= 0 &&
           motion.acceleration.turns(body) && motion.acceleration.has(base);
}

bool CurvatureDraft::is_on_frame(NodeIndex node) const {
    const auto& bodies = structure.node(node).bodies;
    return std::find(bodies.begin(), bodies.end(), frame) != bodies.end();
}

Symbol CurvatureDraft::symbol_of_pole(BodyIndex body) const { return centre_symbol(mechanism, frame, body, false); }

std::string CurvatureDraft::free_name(const std::string& letter) const {
    return kinegraph::free_name(mechanism, letter);
}

/// C₀ of C, B1′ of B1.
std::string CurvatureDraft::name_of_centre(const std::string& point) const {
    const bool numbered = !point.empty() && std::isdigit(static_cast<unsigned char>(point.back())) != 0;
    std::string candidate = point + (numbered ? "'" : "0");
    while (mechanism.point_named(candidate)) candidate += "'";
    return candidate;
}

StatementIndex CurvatureDraft::say(BodyIndex body, Key sentence, std::vector<Argument> arguments, const char* source) {
    Statement statement;
    statement.message = {sentence, std::move(arguments)};
    statement.section = Topic::curvature;
    statement.source = source;
    statement.bodies = {body};
    return board.state(std::move(statement));
}

std::vector<NodeIndex> CurvatureDraft::paths_of(BodyIndex body) const {
    std::vector<NodeIndex> nodes;
    for (const NodeIndex node : structure.nodes_of(body))
        if (structure.node(node).point != none && structure.node(node).carried) nodes.push_back(node);
    std::sort(nodes.begin(), nodes.end(),
              [&](NodeIndex a, NodeIndex b) { return structure.node(a).point < structure.node(b).point; });
    return nodes;
}

PathCentre& CurvatureDraft::add_path(BodyIndex body, NodeIndex node) {
    PathCentre& path = of(body).result.points.emplace_back();
    path.point = structure.node(node).point;
    path.label = structure.node(node).label;
    path.name = name_of_centre(name_of(path.point));
    return path;
}

void CurvatureDraft::set_pole(State& state, Place pole) {
    state.pole = pole;
    state.result.pole = Recorded<ProjectivePoint>::at(pole.element);
}

void CurvatureDraft::set_inflection_pole(State& state, Place end) {
    Curvature& result = state.result;
    state.inflection_pole = end;
    result.inflection_pole = Recorded<Vector>::at(end.element);
    const Arrow diameter = board.vector(*state.pole, end);
    const ScalarHandle half = board.quotient(board.number(1), board.number(2));
    result.inflection_centre =
        Recorded<Vector>::at(board.carry(*state.pole, board.scale<Plane::drawing>(half, diameter)).element);
    result.tangent = Recorded<Vector>::at(board.turn(diameter).element);
}

}  // namespace kinegraph::curvature
