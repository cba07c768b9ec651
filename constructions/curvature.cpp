#include "constructions/curvature.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string>
#include <utility>

#include "constructions/polygon_pen.hpp"
#include "constructions/space_diagram.hpp"
#include "engine/assert.hpp"
#include "engine/centre_symbol.hpp"

namespace kinegraph {
namespace {

std::size_t at(auto index) { return at_index(index); }
using Drawing = PointOn<Plane::drawing>;
using Line = LineOn<Plane::drawing>;
using Arrow = VectorOn<Plane::drawing>;
using Kind = Curvature::Kind;

/// A moving point of a body and the centre of curvature of its path; the pole lies on the line through both.
struct KnownPath {
    PointIndex point = none;
    std::string label, centre_name;  ///< no centre's name where it lies at infinity
    Drawing place, centre;
};

class Curvatures {
public:
    Curvatures(Structure& structure, Board& board, const Motion& motion)
        : structure_(structure),
          board_(board),
          diagram_(structure, board),
          mechanism_(structure.mechanism()),
          motion_(motion),
          bodies_(mechanism_.bodies.size()) {}

    std::vector<Curvature> draw() {
        std::vector<BodyIndex> open;
        for (const BodyIndex body : mechanism_.moving_bodies())
            if (is_known(body) && !settle_simple(body)) open.push_back(body);
        // A body of which two paths are known makes known the paths of its pins; where none is, accelerations help.
        while (!open.empty()) {
            const auto next = std::find_if(open.begin(), open.end(), [&](BodyIndex body) { return by_known_paths(body); });
            const BodyIndex body = next == open.end() ? open.front() : *next;
            if (next == open.end()) by_acceleration(body);
            complete(body);
            open.erase(std::find(open.begin(), open.end(), body));
        }
        std::vector<Curvature> results;
        for (State& state : bodies_)
            if (state.solved) results.push_back(std::move(state.result));
        return results;
    }

private:
    struct State {
        bool solved = false;
        Curvature result;
        std::optional<Drawing> pole, inflection_pole;  ///< inflection pole: where the pole moves
    };

    // --- names and sentences ---------------------------------------------------------------------------------------------------
    State& of(BodyIndex body) { return bodies_[at(body)]; }
    BodyName name(BodyIndex body) const { return {structure_.body_name(body)}; }
    Symbol symbol_of_pole(BodyIndex body) const { return centre_symbol(mechanism_, frame, body, false); }
    const std::string& name_of(PointIndex point) const { return mechanism_.point(point).name; }
    Symbol omega(BodyIndex body) const { return spin_symbol<Plane::velocity>(structure_.body_name(body)); }

    StatementIndex say(BodyIndex body, Sentence sentence, std::vector<Argument> arguments, const char* source = "") {
        Statement statement;
        statement.message = {sentence, std::move(arguments)};
        statement.section = Topic::curvature;
        statement.source = source;
        statement.bodies = {body};
        return board_.state(std::move(statement));
    }
    std::string free_name(const std::string& letter) const { return kinegraph::free_name(mechanism_, letter); }
    /// C₀ of C, B1′ of B1.
    std::string name_of_centre(const std::string& point) const {
        const bool numbered = !point.empty() && std::isdigit(static_cast<unsigned char>(point.back())) != 0;
        std::string candidate = point + (numbered ? "'" : "0");
        while (mechanism_.point_named(candidate)) candidate += "'";
        return candidate;
    }

    // --- what is known
    // -----------------------------------------------------------------------------------------------------------
    NodeIndex base_of(BodyIndex body) const {
        for (const NodeIndex node : structure_.nodes_of(body))
            if (motion_.velocity.has(node) && structure_.node(node).point != none) return node;
        return none;
    }
    bool is_known(BodyIndex body) const {
        const NodeIndex base = base_of(body);
        return motion_.velocity.turns(body) && base != none && motion_.acceleration.polygon >= 0 &&
               motion_.acceleration.turns(body) && motion_.acceleration.has(base);
    }
    bool is_on_frame(NodeIndex node) const {
        const auto& bodies = structure_.node(node).bodies;
        return std::find(bodies.begin(), bodies.end(), frame) != bodies.end();
    }
    VectorOn<Plane::velocity> velocity(NodeIndex node) {
        return board_.vector(board_.pole<Plane::velocity>(), motion_.velocity.tip(node));
    }
    bool rests(NodeIndex node) { return is_on_frame(node) || board_.is_zero(velocity(node)); }

    // --- bodies that are simple ------------------------------------------------------------------------------------------------
    /// Rest, translation, and turning about a hinge of the frame.
    bool settle_simple(BodyIndex body) {
        State& state = of(body);
        state.result.body = body;
        const NodeIndex base = base_of(body);
        if (board_.is_zero(motion_.velocity.spin(body))) {
            if (rests(base)) {
                state.result.kind = Kind::rest;
                say(body, Sentence::curvature_rest, {name(body)});
                for (const NodeIndex node : paths_of(body)) add_path(body, node).centre = {};
            } else {
                translate(body, base);
            }
            return state.solved = true;
        }
        for (const NodeIndex node : structure_.nodes_of(body)) {
            if (structure_.node(node).point == none || !is_on_frame(node)) continue;
            turn_about(body, diagram_.place(node), PointName{structure_.node(node).label}, name_of(structure_.node(node).point));
            return state.solved = true;
        }
        return false;
    }

    /// `centre`: the pole's name where the file has one.
    void turn_about(BodyIndex body, Drawing pole, Argument name_of_pole, const std::string& centre) {
        State& state = of(body);
        state.pole = pole;
        state.result.kind = Kind::turning;
        state.result.pole = Recorded<ProjectivePoint>::at(pole.element);
        state.result.inflection_centre = Recorded<Vector>::at(pole.element);
        state.result.acceleration_pole = Recorded<Vector>::at(pole.element);
        state.result.pole_statement = say(body, Sentence::curvature_turning, {name(body), std::move(name_of_pole)});
        for (const NodeIndex node : paths_of(body)) {
            PathCentre& path = add_path(body, node);
            path.is_pin = true;
            if (!centre.empty()) path.name = centre;
            if (rests(node) || board_.coincide(diagram_.place(node), pole)) continue;
            path.centre = Recorded<ProjectivePoint>::at(pole.element);
        }
    }

    /// Of a body that translates the accelerations alone tell the curvature: κ = v ∧ a / v³.
    void translate(BodyIndex body, NodeIndex base) {
        State& state = of(body);
        state.result.kind = Kind::translation;
        state.result.pole_statement = say(body, Sentence::curvature_translation, {name(body)});
        const auto v = velocity(base);
        state.result.pole = Recorded<ProjectivePoint>::at(board_.at_infinity(board_.perpendicular(board_.direction(v))).element);
        const ScalarHandle one = board_.number(1);
        for (const NodeIndex node : paths_of(body)) {
            if (!motion_.velocity.has(node) || !motion_.acceleration.has(node)) continue;
            PathCentre& path = add_path(body, node);
            const Arrow v_here = board_.scale<Plane::drawing>(one, velocity(node));
            const Arrow a_here = board_.scale<Plane::drawing>(
                one, board_.vector(board_.pole<Plane::acceleration>(), motion_.acceleration.tip(node)));
            const bool straight = board_.is_zero(a_here) || board_.parallel(board_.direction(v_here), board_.direction(a_here));
            const PointName here{path.label};
            if (straight) {
                path.statement = say(body, Sentence::curvature_by_normal_straight, {here});
                path.centre =
                    Recorded<ProjectivePoint>::at(board_.at_infinity(board_.perpendicular(board_.direction(v_here))).element);
                continue;
            }
            path.statement = say(body, Sentence::curvature_by_normal, {here, PointName{path.name}}, "Huygens");
            const Arrow across = board_.turn(v_here);
            const ScalarHandle share =
                board_.quotient(board_.moment(v_here, board_.direction(across)), board_.moment(v_here, board_.direction(a_here)));
            const Drawing centre =
                board_.carry(diagram_.place(node), board_.scale<Plane::drawing>(share, board_.direction(across)));
            path.centre = Recorded<ProjectivePoint>::at(centre.element);
        }
    }

    // --- Bobillier, Euler and Savary
    // ---------------------------------------------------------------------------------------------
    /// By two points whose paths are known and whose rays differ. False: there are none.
    bool by_known_paths(BodyIndex body) {
        const std::vector<KnownPath> known = known_paths(body);
        for (std::size_t i = 0; i < known.size(); ++i)
            for (std::size_t j = i + 1; j < known.size(); ++j) {
                if (!rays_meet(known[i], known[j])) continue;
                draw_pole_tangent(body, known[i], known[j]);
                return true;
            }
        return false;
    }
    bool rays_meet(const KnownPath& a, const KnownPath& b) {
        const Board::Mark before = board_.mark();
        // Two circles about one centre are those of a body that turns about it.
        const bool same_centre = board_.coincide(a.centre, b.centre);
        const auto met = board_.meet(board_.join(a.place, a.centre), board_.join(b.place, b.centre));
        const bool meets = !same_centre && met && !board_.is_at_infinity(*met) && !board_.coincide(*met, a.place) &&
                           !board_.coincide(*met, b.place);
        board_.rewind(before);
        return meets;
    }

    Argument ray_of(const KnownPath& path) const {
        if (!path.centre_name.empty()) return Segment{path.label, path.centre_name};
        return LineReason{LineReason::Kind::parallel_to_normal, path.label, {}};
    }
    Argument join_of_centres(const KnownPath& a, const KnownPath& b) const {
        if (a.centre_name.empty()) return ray_of(a);
        return b.centre_name.empty() ? ray_of(b) : Argument{Segment{a.centre_name, b.centre_name}};
    }

    void draw_pole_tangent(BodyIndex body, const KnownPath& a, const KnownPath& b) {
        State& state = of(body);
        Curvature& result = state.result;
        const Symbol pole_symbol = symbol_of_pole(body);
        result.pole_statement = say(body, Sentence::curvature_rays, {pole_symbol, ray_of(a), ray_of(b)}, "Aronhold–Kennedy");
        const Drawing pole = *board_.meet(board_.join(a.place, a.centre), board_.join(b.place, b.centre));
        set_pole(state, pole);
        for (const KnownPath* path : {&a, &b})
            result.rays.push_back({path->point, path->label, path->centre_name, Recorded<Vector>::at(path->place.element),
                                   Recorded<ProjectivePoint>::at(path->centre.element)});

        const Segment join{a.label, b.label};
        const bool both_far = a.centre_name.empty() && b.centre_name.empty();
        result.tangent_statement =
            both_far
                ? say(body, Sentence::curvature_bobillier_at_infinity, {pole_symbol, join, ray_of(a), ray_of(b)}, "Bobillier")
                : say(body, Sentence::curvature_bobillier,
                      {pole_symbol, join, join_of_centres(a, b), ray_of(a), ray_of(b), PointName{free_name("Q")}}, "Bobillier");
        const auto axis_point = board_.meet(board_.join(a.place, b.place), board_.join(a.centre, b.centre));
        KG_ASSERT(axis_point, "the join of two points is that of their centres only through the pole");
        result.axis_point = Recorded<ProjectivePoint>::at(axis_point->element);
        // As directions in the complex plane t = a·b/c, up to a real factor: t = (a·c) b + (c∧a) z∧b.
        const Arrow to_a = board_.vector(pole, a.place), to_b = board_.vector(pole, b.place);
        const Arrow axis = board_.scale<Plane::drawing>(board_.number(1), board_.direction(board_.join(pole, *axis_point)));
        const ScalarHandle along = board_.moment(axis, board_.direction(board_.turn(to_a)));
        const ScalarHandle across = board_.moment(axis, board_.direction(to_a));
        const Arrow tangent =
            board_.add(board_.scale<Plane::drawing>(along, to_b), board_.scale<Plane::drawing>(across, board_.turn(to_b)));
        const Line normal = board_.through(pole, board_.perpendicular(board_.direction(tangent)));
        draw_inflection_pole(body, a, b, normal);
    }

    /// Euler and Savary on the first ray whose centre is not the pole: AW = AP²/AA₀, and the angle at W is a right one.
    void draw_inflection_pole(BodyIndex body, const KnownPath& a, const KnownPath& b, Line normal) {
        State& state = of(body);
        const Drawing pole = *state.pole;
        const bool far = a.centre_name.empty();
        // A point on the pole tangent has its centre in the pole, and its ray says nothing of the diameter.
        const KnownPath& path = !far && board_.coincide(a.centre, pole) ? b : a;
        const bool straight = path.centre_name.empty();
        state.result.inflection_name = free_name("J");
        const PointName end{state.result.inflection_name};
        state.result.inflection_statement =
            straight ? say(body, Sentence::curvature_inflection_straight, {symbol_of_pole(body), PointName{path.label}, end},
                           "Euler–Savary")
                     : say(body, Sentence::curvature_inflection,
                           {symbol_of_pole(body), PointName{path.label}, PointName{path.centre_name}, end}, "Euler–Savary");
        Drawing foot = path.place;
        if (!straight) {
            const Arrow to_pole = board_.vector(path.place, pole), to_centre = board_.vector(path.place, path.centre);
            foot = board_.carry(path.place, board_.scale<Plane::drawing>(board_.ratio(to_pole, to_centre), to_pole));
        }
        const DirectionHandle ray = board_.direction(board_.vector(pole, path.place));
        const auto met = board_.meet(board_.through(foot, board_.perpendicular(ray)), normal);
        KG_ASSERT(met && !board_.is_at_infinity(*met), "a ray that is not the pole tangent meets the inflection circle again");
        set_inflection_pole(state, *met);
    }

    void set_pole(State& state, Drawing pole) {
        state.pole = pole;
        state.result.pole = Recorded<ProjectivePoint>::at(pole.element);
    }
    void set_inflection_pole(State& state, Drawing end) {
        Curvature& result = state.result;
        state.inflection_pole = end;
        result.inflection_pole = Recorded<Vector>::at(end.element);
        const Arrow diameter = board_.vector(*state.pole, end);
        const ScalarHandle half = board_.quotient(board_.number(1), board_.number(2));
        result.inflection_centre =
            Recorded<Vector>::at(board_.carry(*state.pole, board_.scale<Plane::drawing>(half, diameter)).element);
        result.tangent = Recorded<Vector>::at(board_.turn(diameter).element);
    }

    /// The paths of a body's points that other bodies, or guides in the frame, make known.
    std::vector<KnownPath> known_paths(BodyIndex body) {
        std::vector<KnownPath> known;
        for (const NodeIndex node : paths_of(body)) {
            if (!motion_.velocity.has(node) || rests(node)) continue;
            if (auto path = known_by_pin(node, body)) known.push_back(*std::move(path));
        }
        for (const Passage& passage : structure_.passages_of(body))
            if (auto path = known_by_frame(passage)) known.push_back(*std::move(path));
        return known;
    }
    KnownPath straight_path(PointIndex point, DirectionHandle along) {
        return {point, name_of(point), "", board_.place(point), board_.at_infinity(board_.perpendicular(along))};
    }
    /// By a pin: the other body turns about a hinge of the frame, slides on it, or was solved before.
    std::optional<KnownPath> known_by_pin(NodeIndex node, BodyIndex body) {
        const Node& here = structure_.node(node);
        for (const BodyIndex other : here.bodies) {
            if (other == body || other == frame || !of(other).solved) continue;
            for (const PathCentre& path : of(other).result.points) {
                if (path.point != here.point || !path.centre) continue;
                const Drawing centre{path.centre.element()};
                const bool far = board_.is_at_infinity(centre);
                return KnownPath{here.point, here.label, far ? "" : path.name, diagram_.place(node), centre};
            }
        }
        return std::nullopt;
    }
    /// A pin in a slot of the frame, a round profile on one of the frame's.
    std::optional<KnownPath> known_by_frame(const Passage& passage) {
        if (passage.other != frame || passage.inverse) return std::nullopt;
        const Joint& joint = mechanism_.joint(passage.joint);
        if (passage.kind == Passage::Kind::link)
            return KnownPath{passage.own, name_of(passage.own), name_of(passage.others), board_.place(passage.own),
                             board_.place(passage.others)};
        if (passage.kind != Passage::Kind::slot || joint.pair().touches()) return std::nullopt;
        if (joint.along) return straight_path(passage.own, board_.guide(passage.joint));
        return KnownPath{passage.own, name_of(passage.own), name_of(joint.arc), board_.place(passage.own),
                         board_.place(joint.arc)};
    }

    // --- by accelerations
    // --------------------------------------------------------------------------------------------------------
    /// P = A + z∧v_A/ω, J = P + a_P/ω², a_P = a_A + α z∧AP − ω² AP.
    void by_acceleration(BodyIndex body) {
        State& state = of(body);
        const NodeIndex base = base_of(body);
        const ScalarHandle omega = motion_.velocity.spin(body), alpha = motion_.acceleration.spin(body);
        const ScalarHandle one = board_.number(1), square = board_.product(omega, omega);
        const std::string& label = structure_.node(base).label;
        state.result.pole_statement =
            say(body, Sentence::curvature_pole,
                {symbol_of_pole(body), PointName{label}, motion_symbol<Plane::velocity>(label), this->omega(body)}, "Euler");
        const Drawing from = diagram_.place(base);
        const Arrow to_pole = board_.scale<Plane::drawing>(board_.quotient(one, omega), board_.turn(velocity(base)));
        const Drawing pole = board_.carry(from, to_pole);
        const auto normal = board_.scale<Plane::acceleration>(board_.opposite(square), to_pole);
        const auto tangential = board_.scale<Plane::acceleration>(alpha, board_.turn(to_pole));
        const auto tip = board_.carry(board_.carry(motion_.acceleration.tip(base), normal), tangential);
        const auto acceleration = board_.vector(board_.pole<Plane::acceleration>(), tip);
        if (board_.is_zero(acceleration)) return turn_about(body, pole, symbol_of_pole(body), "");
        set_pole(state, pole);
        state.result.inflection_name = free_name("J");
        state.result.tangent_statement = state.result.inflection_statement =
            say(body, Sentence::curvature_by_acceleration,
                {symbol_of_pole(body), PointName{state.result.inflection_name}, this->omega(body)}, "Bresse");
        set_inflection_pole(state, board_.carry(pole, board_.scale<Plane::drawing>(board_.quotient(one, square), acceleration)));
    }

    // --- what follows from pole and inflection circle
    // ----------------------------------------------------------------------------
    void complete(BodyIndex body) {
        State& state = of(body);
        state.solved = true;
        if (!state.inflection_pole) return;
        draw_acceleration_pole(body);
        for (const NodeIndex node : paths_of(body)) draw_path(body, node);
        draw_envelopes(body);
    }

    /// H = P + z∧PJ·ω²/α; the foot of P on JH lies on both circles.
    void draw_acceleration_pole(BodyIndex body) {
        State& state = of(body);
        Curvature& result = state.result;
        const ScalarHandle omega = motion_.velocity.spin(body), alpha = motion_.acceleration.spin(body);
        result.acceleration_name = free_name("K");
        const Drawing pole = *state.pole, end = *state.inflection_pole;
        if (board_.is_zero(alpha)) {
            result.bresse_statement =
                say(body, Sentence::curvature_bresse_uniform, {PointName{result.inflection_name}, name(body)}, "Bresse");
            result.acceleration_name = result.inflection_name;
            result.acceleration_pole = Recorded<Vector>::at(end.element);
            return;
        }
        result.tangential_name = free_name("H");
        result.bresse_statement = say(body, Sentence::curvature_bresse,
                                      {PointName{result.acceleration_name}, symbol_of_pole(body),
                                       PointName{result.inflection_name}, PointName{result.tangential_name}},
                                      "Bresse");
        const Arrow aside = board_.turn(board_.vector(pole, end));
        const ScalarHandle share = board_.quotient(board_.product(omega, omega), alpha);
        const Drawing second = board_.carry(pole, board_.scale<Plane::drawing>(share, aside));
        result.tangential_pole = Recorded<Vector>::at(second.element);
        const Line join = board_.join(end, second);
        const auto foot = board_.meet(board_.through(pole, board_.perpendicular(board_.direction(join))), join);
        KG_ASSERT(foot && !board_.is_at_infinity(*foot), "a perpendicular meets its line");
        result.acceleration_pole = Recorded<Vector>::at(foot->element);
    }

    /// The points that a body carries by the file.
    std::vector<NodeIndex> paths_of(BodyIndex body) const {
        std::vector<NodeIndex> nodes;
        for (const NodeIndex node : structure_.nodes_of(body))
            if (structure_.node(node).point != none && structure_.node(node).carried) nodes.push_back(node);
        std::sort(nodes.begin(), nodes.end(),
                  [&](NodeIndex a, NodeIndex b) { return structure_.node(a).point < structure_.node(b).point; });
        return nodes;
    }
    PathCentre& add_path(BodyIndex body, NodeIndex node) {
        PathCentre& path = of(body).result.points.emplace_back();
        path.point = structure_.node(node).point;
        path.label = structure_.node(node).label;
        path.name = name_of_centre(name_of(path.point));
        return path;
    }

    /// Hartmann, both velocities over ω: the tips of z∧PC at C and of its share for the pole, z∧PW at P, are joined. W is the
    /// foot of J on the ray.
    void draw_path(BodyIndex body, NodeIndex node) {
        const State& state = of(body);
        const Drawing pole = *state.pole, place = diagram_.place(node);
        PathCentre& path = add_path(body, node);
        if (const auto known = known_path(node, body, state.result)) {
            path.is_pin = true;
            if (!known->centre_name.empty()) path.name = known->centre_name;
            path.centre = Recorded<ProjectivePoint>::at(known->centre.element);
            return;
        }
        const PointName here{path.label};
        if (board_.coincide(place, pole)) {
            path.statement = say(body, Sentence::curvature_at_pole, {here});
            return;
        }
        path.statement = say(body, Sentence::curvature_hartmann, {here, PointName{path.name}, symbol_of_pole(body)}, "Hartmann");
        const Line ray = board_.join(pole, place);
        const auto foot = board_.meet(board_.through(*state.inflection_pole, board_.perpendicular(board_.direction(ray))), ray);
        KG_ASSERT(foot && !board_.is_at_infinity(*foot), "a perpendicular meets its line");
        path.foot = Recorded<ProjectivePoint>::at(foot->element);
        if (board_.coincide(*foot, place)) {
            board_.statement(path.statement).message = {Sentence::curvature_straight, {here}};
            board_.statement(path.statement).source = "Euler–Savary";
            path.centre = Recorded<ProjectivePoint>::at(board_.at_infinity(board_.direction(ray)).element);
            return;
        }
        const Drawing tip = board_.carry(place, board_.turn(board_.vector(pole, place)));
        const Drawing tip_of_pole = board_.carry(pole, board_.turn(board_.vector(pole, *foot)));
        const auto centre = board_.meet(board_.join(tip, tip_of_pole), ray);
        KG_ASSERT(centre, "a tip lies beside its ray");
        path.centre = Recorded<ProjectivePoint>::at(centre->element);
    }
    /// What another body's pin, or the frame's guide, says of a path already.
    std::optional<KnownPath> known_path(NodeIndex node, BodyIndex body, const Curvature& result) {
        const PointIndex point = structure_.node(node).point;
        for (const Curvature::Ray& ray : result.rays)
            if (ray.point == point) return KnownPath{point, ray.from, ray.to, diagram_.place(node), {ray.centre.element()}};
        return rests(node) ? std::nullopt : known_by_pin(node, body);
    }

    /// Of straight guides, slots and profiles that the body carries: their centre lies as far beyond the pole as the foot of J on
    /// the normal lies before it.
    void draw_envelopes(BodyIndex body) {
        for (const JointIndex index : indices_of(mechanism_.joints)) {
            const Joint& joint = mechanism_.joint(index);
            if (!carries_line(joint, body)) continue;
            const State& state = of(body);
            EnvelopeCentre envelope;
            envelope.joint = index;
            const std::size_t before = state.result.envelopes.size();
            envelope.name = free_name(before == 0 ? "E" : "E" + std::to_string(before + 1));
            envelope.statement =
                say(body, Sentence::curvature_envelope,
                    {reader_name(mechanism_, joint), PointName{envelope.name}, symbol_of_pole(body)}, "Euler–Savary");
            const DirectionHandle along = joint.along ? board_.guide(index) : board_.tangent(index);
            const Line normal = board_.through(*state.pole, board_.perpendicular(along));
            const auto touches = board_.meet(normal, board_.through(board_.place(joint.point), along));
            const auto foot = board_.meet(normal, board_.through(*state.inflection_pole, along));
            KG_ASSERT(touches && foot, "a normal meets its line");
            envelope.touches = Recorded<Vector>::at(touches->element);
            envelope.centre = Recorded<Vector>::at(board_.carry(*state.pole, board_.vector(*foot, *state.pole)).element);
            of(body).result.envelopes.push_back(std::move(envelope));
        }
    }
    static bool carries_line(const Joint& joint, BodyIndex body) {
        if (joint.along) return joint.bodies[1] == body;
        const auto profile = joint.profiles.find(body);
        return profile != joint.profiles.end() && std::holds_alternative<LineProfile>(profile->second);
    }

    Structure& structure_;
    Board& board_;
    SpaceDiagram diagram_;
    const Mechanism& mechanism_;
    const Motion& motion_;
    std::vector<State> bodies_;  ///< by BodyIndex
};

}  // namespace

std::vector<Curvature> draw_curvature(Structure& structure, Board& board, const Motion& motion) {
    return Curvatures(structure, board, motion).draw();
}

}  // namespace kinegraph
