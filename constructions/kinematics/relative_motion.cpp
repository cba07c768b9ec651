#include "constructions/kinematics/relative_motion.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "constructions/kinematics/polygon_pen.hpp"
#include "constructions/kinematics/space_diagram.hpp"
#include "engine/number/assert.hpp"
#include "engine/solution/sliding.hpp"
#include "lang/keys/sentences.hpp"

namespace kinegraph {
namespace {

/// The node of a point on the moving body: any of its nodes except the observer's own.
NodeIndex node_of_point(const Structure& structure, PointIndex point, BodyIndex observer) {
    NodeIndex best = none;
    for (const NodeIndex node : indices_of(structure.nodes())) {
        if (structure.node(node).point != point) continue;
        const auto& bodies = structure.node(node).bodies;
        const bool observers = std::find(bodies.begin(), bodies.end(), observer) != bodies.end();
        if (!observers && structure.node(node).carried) return node;
        if (best == none || structure.node(node).carried) best = node;
    }
    return best;
}

class Observer {
public:
    Observer(Structure& structure, Board& board, const Motion& motion)
        : structure_(structure), board_(board), diagram_(structure, board), motion_(motion) {}

    RelativeMotion see(const RelativeMotionQuery& query, bool with_accelerations) {
        RelativeMotion result;
        result.query = query;
        translating_ = query.translating_with != none;
        point_ = node_of_point(structure_, query.point, translating_ ? none : query.observer);
        transport_ = translating_ ? node_of_point(structure_, query.translating_with, none)
                                  : structure_.on(query.point, query.observer);
        observer_ = query.observer;
        if (!motion_.velocity.has(point_) || !motion_.velocity.has(transport_)) return result;
        const auto v = velocities();
        result.velocity = found(motion_.velocity.tip(point_));
        result.transport_velocity = found(motion_.velocity.tip(transport_));
        result.relative_velocity = found(v);
        const bool drawn = motion_.acceleration.has(point_) && motion_.acceleration.has(transport_);
        if (with_accelerations && drawn && (translating_ || motion_.velocity.turns(observer_)))
            accelerations(v, result);
        return result;
    }

private:
    static Recorded<Vector> found(auto handle) { return Recorded<Vector>::at(handle.element); }

    template <Plane plane>
    int polygon(const char* kind) {
        Polygon polygon;
        polygon.point = structure_.node(point_).label;
        polygon.kind = Polygon::Kind::relative_motion;
        polygon.translating = translating_;
        polygon.observer = translating_ ? structure_.node(transport_).label : structure_.body_name(observer_);
        polygon.id = std::string(kind) + "-" + polygon.point + (translating_ ? "-with-" : "-on-") + polygon.observer;
        return PolygonPen<plane>::begin(board_, std::move(polygon));
    }

    /// "tr", or "tr,2" with the observer's name if another query is about the same point.
    std::string term_of(const char* term) const {
        const auto& queries = structure_.mechanism().find.relative_motion;
        const PointIndex point = structure_.node(point_).point;
        const bool alone =
            std::count_if(queries.begin(), queries.end(), [&](const auto& each) { return each.point == point; }) < 2;
        if (alone || *term == '\0') return term;
        return std::string(term) + "," +
               (translating_ ? structure_.node(transport_).label : structure_.body_name(observer_));
    }

    template <Plane plane>
    void draw(int polygon, const char* term, PointOn<plane> tail, PointOn<plane> tip, DrawnVector::Role role) {
        const BodyIndex body =
            role == DrawnVector::Role::transport && !translating_ ? observer_ : structure_.node(point_).bodies.front();
        PolygonPen<plane>(board_, polygon)
            .vector(motion_symbol<plane>(structure_.node(point_).label, term_of(term)), seen_as(role), tail, tip, body,
                    role);
    }

    CarriedPlace carried(NodeIndex node) { return carried(node, structure_.node(node).bodies.front()); }
    CarriedPlace carried(NodeIndex node, BodyIndex body) {
        return {diagram_.place(node).element, body, structure_.node(node).point};
    }
    /// At a hinge the place is on several bodies; the observer's rotation is that of its own body.
    CarriedPlace transport() { return translating_ ? carried(transport_) : carried(transport_, observer_); }
    Seen seen_as(DrawnVector::Role role) {
        if (role == DrawnVector::Role::absolute) return {carried(point_), {}, none};
        // An observer that translates does not turn, like the frame.
        if (role == DrawnVector::Role::coriolis && translating_)
            return {carried(point_), carried(transport_, frame), none};
        if (role == DrawnVector::Role::transport) return {transport(), {}, none};
        return {carried(point_), transport(), none};
    }

    void say(Key rotating, Key translating, Symbol::Letter letter, const char* source) {
        Statement statement;
        const std::string& name = structure_.node(point_).label;
        const auto symbol = [&](const char* term) { return Symbol{letter, name, term_of(term)}; };
        std::vector<Argument> arguments{PointName{name}};
        if (translating_) {
            arguments.emplace_back(PointName{structure_.node(transport_).label});
        } else {
            arguments.emplace_back(BodyName{structure_.body_name(observer_)});
        }
        arguments.emplace_back(symbol("tr"));
        if (letter == Symbol::Letter::a && !translating_) arguments.emplace_back(symbol("cor"));
        arguments.emplace_back(symbol("rel"));
        statement.message = {translating_ ? translating : rotating, std::move(arguments)};
        statement.section = Topic::relative_motion;
        statement.source = source;
        board_.state(std::move(statement));
    }

    /// v_P = v_tr + v_rel
    VectorOn<Plane::velocity> velocities() {
        say(lang::sentences::relative_transport_velocity, lang::sentences::relative_translating_velocity,
            Symbol::Letter::v, "");
        const auto from = motion_.velocity.tip(transport_), to = motion_.velocity.tip(point_);
        const int figure = polygon<Plane::velocity>("velocity");
        draw(figure, "", board_.pole<Plane::velocity>(), to, DrawnVector::Role::absolute);
        draw(figure, "tr", board_.pole<Plane::velocity>(), from, DrawnVector::Role::transport);
        draw(figure, "rel", from, to, DrawnVector::Role::relative);
        return board_.vector(from, to);
    }

    /// a_P = a_tr + a_cor + a_rel, a_cor = 2 ω ∧ v_rel, which is zero for a translating observer.
    void accelerations(VectorOn<Plane::velocity> relative, RelativeMotion& result) {
        say(lang::sentences::relative_transport_acceleration, lang::sentences::relative_translating_acceleration,
            Symbol::Letter::a, "Coriolis");
        const auto from = motion_.acceleration.tip(transport_), to = motion_.acceleration.tip(point_);
        const ScalarHandle omega = translating_ ? board_.number(0) : motion_.velocity.spin(observer_);
        const auto coriolis =
            board_.scale<Plane::acceleration>(board_.product(board_.number(2), omega), board_.turn(relative));
        const auto middle = board_.carry(from, coriolis);
        const int figure = polygon<Plane::acceleration>("acceleration");
        draw(figure, "", board_.pole<Plane::acceleration>(), to, DrawnVector::Role::absolute);
        draw(figure, "tr", board_.pole<Plane::acceleration>(), from, DrawnVector::Role::transport);
        draw(figure, "cor", from, middle, DrawnVector::Role::coriolis);
        draw(figure, "rel", middle, to, translating_ ? DrawnVector::Role::relative : DrawnVector::Role::sliding);
        result.acceleration = found(to);
        result.transport_acceleration = found(from);
        result.coriolis = found(coriolis);
        const auto seen = board_.vector(middle, to);
        result.relative_acceleration = found(seen);
        if (!translating_ && observer_ != frame) result.apart = apart(relative, seen);
    }

    /// Origin of the moving axes: a place on the observer's body with known motion, at rest if possible.
    NodeIndex origin() const {
        NodeIndex best = none;
        for (const NodeIndex node : structure_.nodes_of(observer_)) {
            if (structure_.node(node).point == none || !motion_.velocity.has(node) || !motion_.acceleration.has(node))
                continue;
            const auto& bodies = structure_.node(node).bodies;
            if (std::find(bodies.begin(), bodies.end(), frame) != bodies.end()) return node;
            if (best == none || best == transport_) best = node;
        }
        return best;
    }
    /// a_tr = a_O′ + α ∧ O′P − ω² O′P, and the components in the observer's axes. None if α is not known.
    std::optional<RelativeMotion::Apart> apart(VectorOn<Plane::velocity> velocity,
                                               VectorOn<Plane::acceleration> acceleration) {
        const NodeIndex from = origin();
        if (from == none || !motion_.acceleration.turns(observer_)) return std::nullopt;
        RelativeMotion::Apart result;
        result.origin = structure_.node(from).point;
        const auto at = diagram_.place(from);
        const auto reach = board_.vector(at, diagram_.place(transport_));
        const ScalarHandle omega = motion_.velocity.spin(observer_), alpha = motion_.acceleration.spin(observer_);
        result.omega = Recorded<Exact>::at(omega.element);
        result.alpha = Recorded<Exact>::at(alpha.element);
        result.origin_velocity = found(motion_.velocity.tip(from));
        result.turning_velocity = found(board_.scale<Plane::velocity>(omega, board_.turn(reach)));
        result.origin_acceleration = found(motion_.acceleration.tip(from));
        result.tangential = found(board_.scale<Plane::acceleration>(alpha, board_.turn(reach)));
        result.normal = found(board_.negate(board_.scale<Plane::acceleration>(board_.product(omega, omega), reach)));
        DirectionHandle axis = board_.own_direction({1, 0});
        for (const PointIndex point : structure_.mechanism().body(observer_).points) {
            if (board_.coincide(board_.place(point), at)) continue;
            result.towards = point;
            axis = board_.direction(board_.vector(at, board_.place(point)));
            break;
        }
        parted(velocity, axis, result.velocity_along, result.velocity_across);
        parted(acceleration, axis, result.acceleration_along, result.acceleration_across);
        using NoCoriolis = RelativeMotion::Apart::NoCoriolis;
        result.no_coriolis = board_.is_zero(omega)      ? NoCoriolis::observer_does_not_turn
                             : board_.is_zero(velocity) ? NoCoriolis::rests_for_observer
                                                        : NoCoriolis::there_is;
        return result;
    }
    /// Resolves a vector along a direction and perpendicular to it.
    template <Plane plane>
    void parted(VectorOn<plane> whole, DirectionHandle axis, Recorded<Vector>& along, Recorded<Vector>& across) {
        const auto pole = board_.pole<plane>();
        const auto tip = board_.carry(pole, whole);
        const auto foot = board_.meet(board_.through(pole, axis), board_.through(tip, board_.perpendicular(axis)));
        KG_ASSERT(foot.has_value(), "lines square to each other meet");
        along = found(board_.vector(pole, *foot));
        across = found(board_.vector(*foot, tip));
    }

    Structure& structure_;
    Board& board_;
    SpaceDiagram diagram_;
    const Motion& motion_;
    NodeIndex point_ = none, transport_ = none;
    BodyIndex observer_ = none;
    bool translating_ = false;
};

}  // namespace

void add_nodes_of_interest(Structure& structure) {
    const Mechanism& mechanism = structure.mechanism();
    for (const Joint& joint : mechanism.joints) {
        if (!joint.pair().slides() && !joint.pair().rolls()) continue;
        // The name without star belongs to the slider's point, or to the moving body.
        const bool guide_first = joint.bodies.front() == frame && !joint.pair().is_sleeve();
        for (const BodyIndex body : joint.bodies) {
            if (!guide_first || body != frame) structure.on(joint.point, body, true);
        }
        if (guide_first) structure.on(joint.point, frame, true);
    }
    for (const RelativeMotionQuery& query : mechanism.find.relative_motion) {
        if (query.translating_with == none) structure.on(query.point, query.observer, true);
    }
}

std::vector<Sliding> draw_slidings(Structure& structure, Board& board, const Motion& motion, bool with_accelerations) {
    const Mechanism& mechanism = structure.mechanism();
    std::vector<Sliding> results;
    for (const JointIndex index : indices_of(mechanism.joints)) {
        const Joint& joint = mechanism.joint(index);
        if (!joint.pair().slides()) continue;
        const NodeIndex slider = structure.find(joint.point, joint.bodies[0]),
                        guide = structure.find(joint.point, joint.bodies[1]);
        if (slider == none || guide == none || !motion.velocity.has(slider) || !motion.velocity.has(guide)) continue;
        Sliding result;
        result.joint = index;
        const Symbol relative{
            Symbol::Letter::v, relative_name(structure.node(slider).label, structure.node(guide).label), {}};
        const bool on_rest = joint.bodies[1] == frame;
        const auto say = [&](Key sentence, const Symbol& symbol, Topic section) {
            Statement statement;
            statement.message = {sentence, {symbol, PointName{structure.node(slider).label}}};
            if (on_rest) {
                statement.message.arguments.emplace_back(Symbol{symbol.letter, structure.node(slider).label, {}});
            } else {
                for (const BodyIndex body : joint.bodies)
                    statement.message.arguments.emplace_back(BodyName{structure.body_name(body)});
            }
            statement.section = section;
            board.state(std::move(statement));
        };
        say(on_rest ? lang::sentences::slide_velocity_on_rest : lang::sentences::slide_velocity, relative,
            Topic::velocity);
        const auto velocity = board.vector(motion.velocity.tip(guide), motion.velocity.tip(slider));
        result.velocity = Recorded<Vector>::at(velocity.element);
        if (with_accelerations && motion.acceleration.has(slider) && motion.acceleration.has(guide) &&
            motion.velocity.turns(joint.bodies[1])) {
            Symbol symbol = relative;
            symbol.letter = Symbol::Letter::a;
            symbol.term = "rel";
            say(on_rest ? lang::sentences::slide_acceleration_on_rest : lang::sentences::slide_acceleration, symbol,
                Topic::acceleration);
            const ScalarHandle twice = board.product(board.number(2), motion.velocity.spin(joint.bodies[1]));
            const auto coriolis = board.scale<Plane::acceleration>(twice, board.turn(velocity));
            const auto difference = board.vector(motion.acceleration.tip(guide), motion.acceleration.tip(slider));
            result.coriolis = Recorded<Vector>::at(coriolis.element);
            result.acceleration = Recorded<Vector>::at(board.subtract(difference, coriolis).element);
        }
        results.push_back(std::move(result));
    }
    return results;
}

std::vector<RelativeMotion> draw_relative_motions(Structure& structure, Board& board, const Motion& motion,
                                                  bool with_accelerations) {
    std::vector<RelativeMotion> results;
    for (const RelativeMotionQuery& query : structure.mechanism().find.relative_motion) {
        results.push_back(Observer(structure, board, motion).see(query, with_accelerations));
    }
    return results;
}

}  // namespace kinegraph
