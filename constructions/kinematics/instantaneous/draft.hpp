// The instantaneous motion of a body during its construction: what is known in each plane, the symbols and drawing
// functions that all parts use, relations of two points of a rigid body.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "constructions/kinematics/instantaneous_motion.hpp"
#include "constructions/kinematics/polygon_pen.hpp"
#include "constructions/kinematics/space_diagram.hpp"
#include "engine/sentences/centre_symbol.hpp"
#include "engine/solution/sliding.hpp"
#include "lang/keys/phrases.hpp"

namespace kinegraph::act {

inline std::size_t at(auto index) { return at_index(index); }

/// The given vector or direction of one point.
template <Plane plane>
struct Given {
    NodeIndex node = none;
    bool whole = true;       ///< false: `vector` is a direction only
    VectorOn<plane> vector;  ///< not zero if it is a direction
};

/// A place of the body with a known vector: a point of the file, or Assur's auxiliary one (node none).
template <Plane plane>
struct Base {
    NodeIndex node = none;
    std::string label;
    PointOn<Plane::drawing> place;
    PointOn<plane> tip;
};

/// What is known in one plane so far.
template <Plane plane>
struct State {
    Track<plane>& track;
    std::vector<Given<plane>> given;
    std::vector<bool> used;  ///< by `given`: whether a construction used it
    std::optional<Base<plane>> base;
    NodeIndex second = none;  ///< the point that, with the base, gave the spin
    bool contradicted = false;

    explicit State(Track<plane>& of) : track(of) {}
};

class InstantaneousMotionDraft {
public:
    using Found = InstantaneousMotionFigure::Found;

    InstantaneousMotionDraft(Structure& of, Board& on, const InstantaneousMotionWishes& what)
        : structure(of),
          board(on),
          diagram(of, on),
          mechanism(of.mechanism()),
          body_index(mechanism.motion->body),
          wishes(what) {
        result.figure.body = body_index;
        result.centre.second = body_index;
    }

    Structure& structure;
    Board& board;
    SpaceDiagram diagram;
    const Mechanism& mechanism;
    BodyIndex body_index;
    InstantaneousMotionWishes wishes;
    InstantaneousMotionResult result;
    std::optional<PointOn<Plane::drawing>> centre;

    const Node& node(NodeIndex index) const { return structure.node(index); }
    PointOn<Plane::drawing> place(NodeIndex index) { return diagram.place(index); }
    BodyName body() const { return {structure.body_name(body_index)}; }
    CarriedPlace carried(NodeIndex index) { return {place(index).element, body_index, node(index).point}; }
    template <Plane plane>
    CarriedPlace carried(const Base<plane>& base) {
        return base.node != none ? carried(base.node) : CarriedPlace{base.place.element, body_index};
    }
    PointName name(NodeIndex index) const { return {node(index).label}; }
    Message sought_centre() const {
        return {lang::phrases::centre_of_bodies, {BodyName{structure.body_name(frame)}, body()}};
    }
    template <Plane plane>
    Message sought() const {
        return {is_velocity<plane> ? lang::phrases::velocity_of_body : lang::phrases::acceleration_of_body, {body()}};
    }
    void unsolved(Message what, Message why) { result.unsolved.push_back({std::move(what), std::move(why)}); }
    std::string free_name(const std::string& letter) const { return kinegraph::free_name(mechanism, letter); }

    template <Plane plane>
    Symbol absolute(const std::string& label, std::string term = {}) const {
        return motion_symbol<plane>(label, std::move(term));
    }
    template <Plane plane>
    Symbol absolute(NodeIndex index) const {
        return absolute<plane>(node(index).label);
    }
    template <Plane plane>
    Symbol relative(NodeIndex of, const Base<plane>& to, std::string term = {}) const {
        return absolute<plane>(relative_name(node(of).label, to.label), std::move(term));
    }
    template <Plane plane>
    Symbol spin() const {
        return spin_symbol<plane>(structure.body_name(body_index));
    }
    Symbol symbol_of_centre() {
        return centre_symbol(structure.mechanism(), frame, body_index, centre && board.is_at_infinity(*centre));
    }
    /// How a sentence names the direction given at a point.
    template <Plane plane>
    LineReason reason_of(const Given<plane>& given) const {
        return {LineReason::Kind::given_direction, node(given.node).label, {}};
    }
    template <Plane plane>
    LineReason across(const Base<plane>& base, NodeIndex index) const {
        return {LineReason::Kind::perpendicular_to_segment, base.label, node(index).label};
    }

    template <Plane plane>
    StatementIndex begin(Key sentence, std::vector<Argument> arguments, std::string source = {}) {
        return state<plane>(board, sentence, std::move(arguments), std::move(source));
    }
    /// A sentence that gives the centre, or states that it is at infinity.
    StatementIndex begin_centre(Key sentence, std::vector<Argument> arguments, std::string source) {
        const StatementIndex statement = begin<Plane::velocity>(sentence, std::move(arguments), std::move(source));
        if (result.figure.centre_statement == none) result.figure.centre_statement = statement;
        return statement;
    }
    /// A sentence whose result is the body's ω or α.
    template <Plane plane>
    void begin_spin(Key sentence, std::vector<Argument> arguments, std::string source) {
        const StatementIndex statement = begin<plane>(sentence, std::move(arguments), std::move(source));
        board.statement(statement).finds = {spin_quantity<plane>(body_index)};
    }
    template <Plane plane>
    PolygonPen<plane> pen(const State<plane>& state) {
        return {board, state.track.polygon};
    }
    template <Plane plane>
    void draw_vector(const State<plane>& state, Symbol symbol, const Seen& seen, PointOn<plane> tail,
                     PointOn<plane> tip, DrawnVector::Role role) {
        pen(state).vector(std::move(symbol), seen, tail, tip, body_index, role);
    }
    template <Plane plane>
    void draw_line(const State<plane>& state, LineOn<plane> line, LineReason reason, std::vector<ElementIndex> points) {
        pen(state).line(line, std::move(reason), std::move(points));
    }
    template <Plane plane>
    void label_image(const State<plane>& state, const std::string& label, PointOn<plane> tip) {
        pen(state).image(image_symbol<plane>(label), tip, body_index);
    }
    template <Plane plane>
    void set_tip(State<plane>& state, NodeIndex index, PointOn<plane> tip) {
        state.track.tips[at(index)] = tip;
        label_image(state, node(index).label, tip);
        draw_vector(state, absolute<plane>(index), {carried(index), {}, none}, board.pole<plane>(), tip,
                    DrawnVector::Role::absolute);
    }
    template <Plane plane>
    void set_base(State<plane>& state, NodeIndex index, PointOn<plane> tip) {
        state.base = {index, node(index).label, place(index), tip};
    }
    template <Plane plane>
    bool turns(const State<plane>& state) const {
        return state.track.turns(body_index);
    }

    /// a_YX^n = −ω²·XY for accelerations; none for velocities and if ω = 0.
    template <Plane plane>
    std::optional<VectorOn<plane>> normal(PointOn<Plane::drawing> from, PointOn<Plane::drawing> to) {
        if constexpr (is_velocity<plane>) {
            return std::nullopt;
        } else {
            const ScalarHandle omega = result.motion.velocity.spin(body_index);
            if (board.is_zero(omega)) return std::nullopt;
            return board.scale<plane>(board.product(omega, omega), board.vector(to, from));
        }
    }
    /// The tip of Y's vector without its part ⟂ XY.
    template <Plane plane>
    PointOn<plane> without_tangential(const Base<plane>& base, PointOn<Plane::drawing> place) {
        const auto part = normal<plane>(base.place, place);
        return part ? board.carry(base.tip, *part) : base.tip;
    }
    /// v_Y = v_X + ω ∧ XY; a_Y = a_X − ω² XY + α ∧ XY.
    template <Plane plane>
    PointOn<plane> image_of(const State<plane>& state, PointOn<Plane::drawing> place) {
        const auto turned = board.turn(board.vector(state.base->place, place));
        return board.carry(without_tangential(*state.base, place),
                           board.scale<plane>(state.track.spin(body_index), turned));
    }
    template <Plane plane>
    PointOn<plane> tip_of(const Given<plane>& given) {
        return board.carry(board.pole<plane>(), given.vector);
    }
    /// Whether two whole vectors differ only by a part ⟂ to the join of their places, apart from the normal part.
    template <Plane plane>
    bool fits_rigid(const Base<plane>& base, PointOn<Plane::drawing> place, PointOn<plane> tip) {
        const auto rest = board.vector(without_tangential(base, place), tip);
        if (board.is_zero(rest)) return true;
        const auto join = board.vector(base.place, place);
        return !board.is_zero(join) &&
               board.parallel(board.direction(rest), board.perpendicular(board.direction(join)));
    }

    void settle_centre(PointOn<Plane::drawing> place, Found found, const std::vector<NodeIndex>& by) {
        result.figure.found = found;
        result.figure.points.clear();
        for (const NodeIndex index : by) result.figure.points.push_back(node(index).point);
        centre = place;
        if (!wishes.centre) return;
        result.centre.how = InstantCentre::How::velocities;
        result.centre.at = Recorded<ProjectivePoint>::at(place.element);
        if (found == Found::perpendiculars) result.centre.normals = result.figure.points;
    }
};

}  // namespace kinegraph::act
