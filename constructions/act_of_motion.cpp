#include "constructions/act_of_motion.hpp"

#include <algorithm>
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

/// What the file says of one point.
template <Plane plane>
struct Given {
    NodeIndex node = none;
    bool whole = true;       ///< else `vector` is its direction only
    VectorOn<plane> vector;  ///< not zero where it is a direction
};

/// A place of the body whose vector is known: a point of the file, or Assur's auxiliary one (node none).
template <Plane plane>
struct Base {
    NodeIndex node = none;
    std::string label;
    PointOn<Plane::drawing> place;
    PointOn<plane> tip;
};

/// What one plane has told so far.
template <Plane plane>
struct State {
    Track<plane>& track;
    std::vector<Given<plane>> given;
    std::vector<bool> used;  ///< by `given`: a construction went on with it
    std::optional<Base<plane>> base;
    NodeIndex second = none;  ///< the point that gave the spin together with the base
    bool contradicted = false;

    explicit State(Track<plane>& of) : track(of) {}
};

class Act {
public:
    Act(Structure& structure, Board& board, const ActWishes& wishes)
        : structure_(structure),
          board_(board),
          diagram_(structure, board),
          mechanism_(structure.mechanism()),
          body_(mechanism_.motion->body),
          wishes_(wishes) {
        result_.figure.body = body_;
        result_.centre.second = body_;
    }

    ActOfMotionResult run() {
        State<Plane::velocity> velocities(result_.motion.velocity);
        begin_polygon(velocities, mechanism_.motion->velocities);
        settle(velocities);
        if (!velocities.contradicted) {
            locate_centre(velocities);
            draw_images(velocities);
            explain(velocities);
        } else if (wishes_.centre) {
            unsolved(sought_centre(), {Sentence::velocities_contradict, {}});
        }
        if (wishes_.accelerations) draw_accelerations(velocities);
        return std::move(result_);
    }

private:
    using Found = ActFigure::Found;

    const Node& node(NodeIndex index) const { return structure_.node(index); }
    PointOn<Plane::drawing> place(NodeIndex index) { return diagram_.place(index); }
    BodyName body() const { return {structure_.body_name(body_)}; }
    CarriedPlace carried(NodeIndex index) { return {place(index).element, body_, node(index).point}; }
    template <Plane plane>
    CarriedPlace carried(const Base<plane>& base) {
        return base.node != none ? carried(base.node) : CarriedPlace{base.place.element, body_};
    }
    PointName name(NodeIndex index) const { return {node(index).label}; }
    Message sought_centre() const { return {Sentence::centre_of_bodies, {BodyName{structure_.body_name(frame)}, body()}}; }
    template <Plane plane>
    Message sought() const {
        return {is_velocity<plane> ? Sentence::velocity_of_body : Sentence::acceleration_of_body, {body()}};
    }
    void unsolved(Message what, Message why) { result_.unsolved.push_back({std::move(what), std::move(why)}); }

    // --- symbols -----------------------------------------------------------------------------------------------------------
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
        return spin_symbol<plane>(structure_.body_name(body_));
    }
    Symbol symbol_of_centre() {
        return centre_symbol(structure_.mechanism(), frame, body_, centre_ && board_.is_at_infinity(*centre_));
    }
    /// In what words the direction given at a point is named.
    template <Plane plane>
    LineReason reason_of(const Given<plane>& given) const {
        return {LineReason::Kind::given_direction, node(given.node).label, {}};
    }
    template <Plane plane>
    LineReason across(const Base<plane>& base, NodeIndex index) const {
        return {LineReason::Kind::perpendicular_to_segment, base.label, node(index).label};
    }

    // --- drawing -----------------------------------------------------------------------------------------------------------
    template <Plane plane>
    StatementIndex begin(Sentence sentence, std::vector<Argument> arguments, std::string source = {}) {
        return state<plane>(board_, sentence, std::move(arguments), std::move(source));
    }

    /// A sentence by which the centre, or that it lies at infinity, is known.
    StatementIndex begin_centre(Sentence sentence, std::vector<Argument> arguments, std::string source) {
        const StatementIndex statement = begin<Plane::velocity>(sentence, std::move(arguments), std::move(source));
        if (result_.figure.centre_statement == none) result_.figure.centre_statement = statement;
        return statement;
    }
    /// A sentence that ends with the body's ω or α.
    template <Plane plane>
    void begin_spin(Sentence sentence, std::vector<Argument> arguments, std::string source) {
        const StatementIndex statement = begin<plane>(sentence, std::move(arguments), std::move(source));
        board_.statement(statement).finds = {spin_quantity<plane>(body_)};
    }

    template <Plane plane>
    PolygonPen<plane> pen(const State<plane>& state) {
        return {board_, state.track.polygon};
    }
    template <Plane plane>
    void draw_vector(const State<plane>& state, Symbol symbol, const Seen& seen, PointOn<plane> tail, PointOn<plane> tip,
                     DrawnVector::Role role) {
        pen(state).vector(std::move(symbol), seen, tail, tip, body_, role);
    }
    template <Plane plane>
    void draw_line(const State<plane>& state, LineOn<plane> line, LineReason reason, std::vector<ElementIndex> points) {
        pen(state).line(line, std::move(reason), std::move(points));
    }
    template <Plane plane>
    void label_image(const State<plane>& state, const std::string& label, PointOn<plane> tip) {
        pen(state).image(image_symbol<plane>(label), tip, body_);
    }
    template <Plane plane>
    void set_tip(State<plane>& state, NodeIndex index, PointOn<plane> tip) {
        state.track.tips[at(index)] = tip;
        label_image(state, node(index).label, tip);
        draw_vector(state, absolute<plane>(index), {carried(index), {}, none}, board_.pole<plane>(), tip,
                    DrawnVector::Role::absolute);
    }
    template <Plane plane>
    void set_base(State<plane>& state, NodeIndex index, PointOn<plane> tip) {
        state.base = {index, node(index).label, place(index), tip};
    }
    template <Plane plane>
    bool turns(const State<plane>& state) const {
        return state.track.turns(body_);
    }

    template <Plane plane>
    void begin_polygon(State<plane>& state, const std::vector<GivenMotion>& list) {
        state.track.tips.resize(structure_.nodes().size());
        state.track.spins.resize(mechanism_.bodies.size());
        Polygon polygon;
        polygon.id = is_velocity<plane> ? "velocity" : "acceleration";
        state.track.polygon = PolygonPen<plane>::begin(board_, std::move(polygon));
        state.track.spins[at(frame)] = board_.number(0);
        for (const NodeIndex index : structure_.nodes_of(frame)) {
            state.track.tips[at(index)] = board_.pole<plane>();
            label_image(state, node(index).label, board_.pole<plane>());
        }
        for (const GivenMotion& each : list) {
            Given<plane> given;
            given.node = structure_.find(each.point, body_);
            KG_ASSERT(given.node != none, "the body carries the points of its act of motion");
            given.whole = std::holds_alternative<Vector>(each.value);
            const auto index = static_cast<int>(state.given.size());
            if constexpr (is_velocity<plane>) {
                given.vector = board_.act_velocity(index);
            } else {
                given.vector = board_.act_acceleration(index);
            }
            state.given.push_back(given);
        }
        state.used.assign(state.given.size(), false);
    }

    // --- two points of a rigid body ------------------------------------------------------------------------------------------
    /// a_YX^n = −ω²·XY, for accelerations of a body that turns.
    template <Plane plane>
    std::optional<VectorOn<plane>> normal(PointOn<Plane::drawing> from, PointOn<Plane::drawing> to) {
        if constexpr (is_velocity<plane>) {
            return std::nullopt;
        } else {
            const ScalarHandle omega = result_.motion.velocity.spin(body_);
            if (board_.is_zero(omega)) return std::nullopt;
            return board_.scale<plane>(board_.product(omega, omega), board_.vector(to, from));
        }
    }
    /// Where the tip of Y's vector would be but for the part ⟂ XY.
    template <Plane plane>
    PointOn<plane> without_tangential(const Base<plane>& base, PointOn<Plane::drawing> place) {
        const auto part = normal<plane>(base.place, place);
        return part ? board_.carry(base.tip, *part) : base.tip;
    }
    /// v_Y = v_X + ω ∧ XY; a_Y = a_X − ω² XY + α ∧ XY.
    template <Plane plane>
    PointOn<plane> image_of(const State<plane>& state, PointOn<Plane::drawing> place) {
        const auto turned = board_.turn(board_.vector(state.base->place, place));
        return board_.carry(without_tangential(*state.base, place), board_.scale<plane>(state.track.spin(body_), turned));
    }
    template <Plane plane>
    PointOn<plane> tip_of(const Given<plane>& given) {
        return board_.carry(board_.pole<plane>(), given.vector);
    }
    /// Whether two whole vectors differ by a part ⟂ to the join of their places, normal part aside.
    template <Plane plane>
    bool fits_rigid(const Base<plane>& base, PointOn<Plane::drawing> place, PointOn<plane> tip) {
        const auto rest = board_.vector(without_tangential(base, place), tip);
        if (board_.is_zero(rest)) return true;
        const auto join = board_.vector(base.place, place);
        return !board_.is_zero(join) && board_.parallel(board_.direction(rest), board_.perpendicular(board_.direction(join)));
    }

    // --- from what is given to one vector and the spin -------------------------------------------------------------------
    template <Plane plane>
    void settle(State<plane>& state) {
        for (std::size_t i = 0; i < state.given.size() && !state.contradicted; ++i) {
            if (state.given[i].whole) take_whole(state, i);
        }
        if (!state.contradicted && !state.base) combine_directions(state);
        for (std::size_t i = 0; i < state.given.size() && !state.contradicted; ++i) {
            if (!state.given[i].whole && !state.used[i]) take_direction(state, i);
        }
        // What was of no use yet must agree with what was found after it.
        for (std::size_t i = 0; i < state.given.size() && !state.contradicted; ++i) {
            if (!state.used[i] && state.base && turns(state)) verify(state, i);
        }
        if (state.contradicted) forget(state);
    }

    /// What contradicts itself is no result; the polygon keeps what was drawn of it.
    template <Plane plane>
    void forget(State<plane>& state) {
        for (const NodeIndex index : structure_.nodes_of(body_)) state.track.tips[at(index)].reset();
        state.track.spins[at(body_)].reset();
    }

    template <Plane plane>
    void take_whole(State<plane>& state, std::size_t index) {
        const Given<plane>& given = state.given[index];
        if (!state.base) {
            begin<plane>(Sentence::act_given, {absolute<plane>(given.node)});
            const auto tip = tip_of(given);
            set_base(state, given.node, tip);
            set_tip(state, given.node, tip);
            state.used[index] = true;
        } else if (!turns(state) && !board_.coincide(state.base->place, place(given.node))) {
            take_pair(state, index);
        } else {
            verify(state, index);
        }
    }

    /// Two whole vectors: what remains of their difference, ⟂ to the join, is the spin's.
    template <Plane plane>
    void take_pair(State<plane>& state, std::size_t index) {
        const Given<plane>& given = state.given[index];
        const Base<plane>& base = *state.base;
        begin<plane>(Sentence::act_given, {absolute<plane>(given.node)});
        const auto tip = tip_of(given);
        set_tip(state, given.node, tip);
        state.used[index] = true;
        if (!fits_rigid(base, place(given.node), tip)) return differ(state, base.node, given.node);
        std::vector<Argument> arguments{Segment{base.label, node(given.node).label}, absolute<plane>(base.label),
                                        absolute<plane>(given.node)};
        if (!is_velocity<plane>) arguments.emplace_back(spin<Plane::velocity>());
        begin<plane>(either<plane>(Sentence::act_projections, Sentence::act_projections_acceleration), std::move(arguments),
                     "Rivals");
        take_spin(state, given.node, tip);
    }

    /// ω = v_YX / XY, α = a_YX^t / XY; the parts are drawn from the base's tip.
    template <Plane plane>
    void take_spin(State<plane>& state, NodeIndex index, PointOn<plane> tip) {
        const Base<plane>& base = *state.base;
        const PointOn<plane> middle = without_tangential(base, place(index));
        const auto tangential = board_.vector(middle, tip);
        const bool vanishes = board_.is_zero(tangential);
        if (!vanishes || !is_velocity<plane>) {
            const Seen seen{carried(index), carried(base), base.place.element};
            if (middle.element != base.tip.element)
                draw_vector(state, relative(index, base, "n"), seen, base.tip, middle, DrawnVector::Role::normal);
            draw_vector(state, relative(index, base, is_velocity<plane> ? "" : "t"), seen, middle, tip,
                        is_velocity<plane> ? DrawnVector::Role::relative : DrawnVector::Role::tangential);
        }
        if (vanishes && is_velocity<plane>) {
            state.track.spins[at(body_)] = board_.number(0);  // said with the centre: a translation, or rest
        } else {
            begin_spin<plane>(either<plane>(Sentence::omega_from_pair, Sentence::alpha_from_pair),
                              {spin<plane>(), relative(index, base, is_velocity<plane> ? "" : "t"),
                               Segment{base.label, node(index).label}, body()},
                              "Rivals");
            state.track.spins[at(body_)] = board_.ratio(tangential, board_.turn(board_.vector(base.place, place(index))));
        }
        state.second = index;
    }

    /// A direction is of use beside a known vector: from its tip ⟂ to the join, from the pole along the direction.
    template <Plane plane>
    void take_direction(State<plane>& state, std::size_t index) {
        const Given<plane>& given = state.given[index];
        const auto here = place(given.node);
        if (!state.base) {
            if (turns(state)) take_second_direction(state, index);
            return;
        }
        if (turns(state)) return;
        const Base<plane>& base = *state.base;
        const auto along = board_.direction(given.vector);
        if (board_.coincide(base.place, here)) {
            const auto known = board_.vector(board_.pole<plane>(), base.tip);
            if (!board_.is_zero(known) && !board_.parallel(board_.direction(known), along)) miss(state, given.node, base.node);
            state.used[index] = true;
            return;
        }
        const auto across_join = board_.perpendicular(board_.direction(board_.vector(base.place, here)));
        const PointOn<plane> start = without_tangential(base, here);
        if (board_.parallel(across_join, along)) {
            // Its projection on the join is zero whatever its size: it says nothing more, or what cannot be.
            if (!board_.on_line(start, board_.through(board_.pole<plane>(), along))) differ(state, base.node, given.node);
            return;
        }
        state.used[index] = true;
        if (is_velocity<plane> && base.node == none) return rest_by_lines(state, given.node);
        const StatementIndex statement =
            begin<plane>(either<plane>(Sentence::act_direction, Sentence::act_direction_acceleration),
                         {image_symbol<plane>(node(given.node).label), absolute<plane>(given.node),
                          Segment{base.label, node(given.node).label}, absolute<plane>(base.label)},
                         "Rivals");
        const auto first = board_.through(start, across_join);
        const auto second = board_.through(board_.pole<plane>(), along);
        const auto met = board_.meet(first, second);
        KG_ASSERT(met && !board_.is_at_infinity(*met), "only lines that are not parallel are met");
        board_.statement(statement).equation = equation(state, given, start.element != base.tip.element);
        draw_line(state, first, across(base, given.node), {start.element, met->element});
        draw_line(state, second, reason_of(given), {board_.pole<plane>().element, met->element});
        set_tip(state, given.node, *met);
        take_spin(state, given.node, *met);
    }

    /// v_Y = v_X + v_YX, a_Y = a_X + a_YX^n + a_YX^t, of v_Y the direction known.
    template <Plane plane>
    Equation equation(const State<plane>& state, const Given<plane>& given, bool has_normal) const {
        const Base<plane>& base = *state.base;
        const LineReason known{LineReason::Kind::known, {}, {}};
        std::vector<Term> right{{absolute<plane>(base.label), true, true, known, body_}};
        if (has_normal) {
            const LineReason along{LineReason::Kind::parallel_to_segment, base.label, node(given.node).label};
            right.push_back({relative(given.node, base, "n"), true, true, along, body_});
        }
        right.push_back(
            {relative(given.node, base, is_velocity<plane> ? "" : "t"), false, true, across(base, given.node), body_});
        return {{{{absolute<plane>(given.node), false, true, reason_of(given), body_}}, std::move(right)}};
    }

    /// Directions alone. Where the perpendiculars to two of them meet, a place of the body has both projections known: of
    /// velocities it is the centre, at rest; of accelerations Assur's auxiliary point. Parallel ones give the spin.
    template <Plane plane>
    void combine_directions(State<plane>& state) {
        const auto is_direction = [](const Given<plane>& given) { return !given.whole; };
        const auto first = std::find_if(state.given.begin(), state.given.end(), is_direction);
        if (first == state.given.end()) return;
        const auto perpendicular = [&](const Given<plane>& given) {
            return board_.through(place(given.node), board_.perpendicular(board_.direction(given.vector)));
        };
        const auto line = perpendicular(*first);
        for (auto other = first + 1; other != state.given.end(); ++other) {
            const auto met = board_.meet(line, perpendicular(*other));
            if (!met) continue;
            state.used[static_cast<std::size_t>(first - state.given.begin())] = true;
            state.used[static_cast<std::size_t>(other - state.given.begin())] = true;
            if (board_.is_at_infinity(*met)) return spin_from_parallels(state, *first, *other);
            return auxiliary_place(state, *first, *other, *met);
        }
    }

    template <Plane plane>
    void auxiliary_place(State<plane>& state, const Given<plane>& first, const Given<plane>& second,
                         PointOn<Plane::drawing> met_at) {
        if constexpr (is_velocity<plane>) {
            settle_centre(met_at, Found::perpendiculars, {first.node, second.node});
            if (wishes_.centre)
                begin_centre(Sentence::act_perpendiculars, {symbol_of_centre(), name(first.node), name(second.node)},
                             "Euler–Chasles");
            state.base = {none, {}, met_at, board_.pole<plane>()};
        } else {
            const std::string label = free_name("S");
            const Symbol symbol{Symbol::Letter::point, label, {}};
            begin<plane>(Sentence::auxiliary_point, {symbol, body(), reason_of(first), reason_of(second)}, "Assur");
            LineOn<plane> lines[2];
            PointOn<plane> ends[2];
            const Given<plane>* sources[2] = {&first, &second};
            for (int i = 0; i < 2; ++i) {
                ends[i] = without_tangential(Base<plane>{none, {}, place(sources[i]->node), board_.pole<plane>()}, met_at);
                lines[i] = board_.through(ends[i], board_.direction(sources[i]->vector));
            }
            const auto met = board_.meet(lines[0], lines[1]);
            KG_ASSERT(met && !board_.is_at_infinity(*met), "perpendiculars that meet have directions that do");
            for (int i = 0; i < 2; ++i) draw_line(state, lines[i], reason_of(*sources[i]), {ends[i].element, met->element});
            label_image(state, label, *met);
            draw_vector(state, absolute<plane>(label), {CarriedPlace{met_at.element, body_}, {}, none}, board_.pole<plane>(),
                        *met, DrawnVector::Role::absolute);
            state.base = {none, label, met_at, *met};
        }
    }

    template <Plane plane>
    void spin_from_parallels(State<plane>& state, const Given<plane>& first, const Given<plane>& second) {
        parallel_base_ = first.node;
        if constexpr (is_velocity<plane>) {
            state.track.spins[at(body_)] = board_.number(0);
            settle_centre(board_.at_infinity(board_.perpendicular(board_.direction(first.vector))), Found::translation,
                          {first.node, second.node});
            begin_centre(Sentence::act_parallels, {body(), name(first.node), name(second.node)}, "Rivals");
        } else {
            begin_spin<plane>(Sentence::alpha_from_parallels,
                              {spin<plane>(), Segment{node(first.node).label, node(second.node).label}, body()}, "Rivals");
            // From a place of the first locus, the line ⟂ to the join meets the second.
            const auto pole = board_.pole<plane>();
            const auto along = board_.direction(first.vector);
            const auto locus = board_.through(pole, along);
            const PointOn<plane> from = without_tangential(Base<plane>{none, {}, place(first.node), pole}, place(second.node));
            const auto turned = board_.turn(board_.vector(place(first.node), place(second.node)));
            const auto met = board_.meet(board_.through(from, board_.direction(turned)), locus);
            KG_ASSERT(met && !board_.is_at_infinity(*met), "perpendiculars that coincide are no two loci");
            draw_line(state, locus, reason_of(first), {pole.element, met->element});
            state.track.spins[at(body_)] = board_.ratio(board_.vector(from, *met), turned);
        }
    }

    /// The spin is known from two parallel directions, a vector from a third that is not parallel to them.
    template <Plane plane>
    void take_second_direction(State<plane>& state, std::size_t index) {
        const Given<plane>& given = state.given[index];
        const auto first = std::find_if(state.given.begin(), state.given.end(),
                                        [&](const Given<plane>& each) { return each.node == parallel_base_; });
        const auto pole = board_.pole<plane>();
        const auto along = board_.direction(given.vector), other = board_.direction(first->vector);
        const Base<plane> from{first->node, node(first->node).label, place(first->node), pole};
        const auto join = board_.vector(from.place, place(given.node));
        const auto end = board_.carry(without_tangential(from, place(given.node)),
                                      board_.scale<plane>(state.track.spin(body_), board_.turn(join)));
        state.used[index] = true;
        const auto own = board_.through(pole, along);
        if (board_.parallel(along, other)) {
            if (!board_.on_line(end, own)) miss(state, given.node, first->node);
            return;
        }
        if (is_velocity<plane>) return rest_by_lines(state, given.node);
        begin<plane>(Sentence::two_lines_acceleration,
                     {image_symbol<plane>(node(given.node).label), reason_of(*first), reason_of(given)}, "Rivals");
        const auto shifted = board_.through(end, other);
        const auto met = board_.meet(shifted, own);
        KG_ASSERT(met && !board_.is_at_infinity(*met), "only lines that are not parallel are met");
        draw_line(state, shifted, reason_of(*first), {end.element, met->element});
        draw_line(state, own, reason_of(given), {pole.element, met->element});
        set_tip(state, given.node, *met);
        set_base(state, given.node, *met);
    }

    /// A third perpendicular that does not pass through the centre of the first two: only rest has these directions.
    template <Plane plane>
    void rest_by_lines(State<plane>& state, NodeIndex index) {
        begin<plane>(Sentence::act_rest_by_lines, {body(), name(index)});
        set_base(state, index, board_.pole<plane>());
        set_tip(state, index, board_.pole<plane>());
        state.track.spins[at(body_)] = board_.number(0);
        if constexpr (is_velocity<plane>) {
            centre_.reset();
            result_.centre = {};
            result_.centre.second = body_;
        }
    }

    // --- agreement -----------------------------------------------------------------------------------------------------------
    /// What is given once more must be what the body has there.
    template <Plane plane>
    void verify(State<plane>& state, std::size_t index) {
        const Given<plane>& given = state.given[index];
        state.used[index] = true;
        const PointOn<plane> tip =
            turns(state) ? image_of(state, place(given.node)) : state.base->tip;  // the same place, or known by the image
        if (given.whole) {
            if (!board_.coincide(tip, tip_of(given))) {
                set_tip(state, given.node, tip_of(given));
                return disagree(state, index);
            }
        } else {
            const auto vector = board_.vector(board_.pole<plane>(), tip);
            if (!board_.is_zero(vector) && !board_.parallel(board_.direction(vector), board_.direction(given.vector)))
                return miss(state, given.node, state.base->node);
        }
        begin<plane>(Sentence::act_agrees, {absolute<plane>(given.node)}, "Rivals");
        if (!state.track.has(given.node)) set_tip(state, given.node, tip);
    }

    /// With which of the points before does it disagree? One of them shows it by projections, unless all lie on one line.
    template <Plane plane>
    void disagree(State<plane>& state, std::size_t index) {
        const Given<plane>& given = state.given[index];
        for (std::size_t i = 0; i < index; ++i) {
            const Given<plane>& other = state.given[i];
            if (!other.whole || board_.coincide(place(other.node), place(given.node))) continue;
            const Base<plane> from{other.node, node(other.node).label, place(other.node), tip_of(other)};
            if (!fits_rigid(from, place(given.node), tip_of(given))) return differ(state, other.node, given.node);
        }
        miss(state, given.node, state.base->node);
    }

    /// Two points whose vectors no rigid body has: their projections on the join differ (of accelerations by other than ω²·XY).
    template <Plane plane>
    void differ(State<plane>& state, NodeIndex first, NodeIndex second) {
        if (first == none) return miss(state, second, first);  // an auxiliary place is none of the file's
        state.contradicted = true;
        const Segment segment{node(first).label, node(second).label};
        if constexpr (is_velocity<plane>) {
            result_.figure.found = Found::contradiction;
            result_.figure.points = {node(first).point, node(second).point};
            const StatementIndex statement = begin<plane>(Sentence::act_unequal_projections, {}, "Rivals");
            const auto from = place(first), to = place(second);
            const auto line = board_.join(from, to);
            const auto join = board_.vector(from, to);
            const auto projection = [&](PointOn<Plane::drawing> place, NodeIndex index) {
                // A second for the velocities' tips in the drawing; projections go with it.
                const auto tip = board_.carry(place, board_.scale<Plane::drawing>(board_.number(1), vector_of(state, index)));
                const auto foot = board_.meet(board_.through(tip, board_.perpendicular(board_.direction(join))), line);
                KG_ASSERT(foot && !board_.is_at_infinity(*foot), "a perpendicular meets its line");
                return board_.vector(place, *foot);
            };
            const auto of_first = projection(from, first), of_second = projection(to, second);
            // How large they are is said once the record is read.
            result_.figure.differing = {node(first).point,
                                        node(second).point,
                                        Recorded<Vector>::at(of_first.element),
                                        Recorded<Vector>::at(of_second.element),
                                        Recorded<Vector>::at(join.element),
                                        statement};
            board_.statement(statement).message.arguments = {segment, absolute<plane>(first), absolute<plane>(second)};
            unsolved(sought<plane>(), {Sentence::unequal_projections, {segment, name(first), name(second)}});
        } else {
            begin<plane>(Sentence::act_unequal_projections_acceleration,
                         {segment, absolute<plane>(first), absolute<plane>(second)}, "Rivals");
            unsolved(sought<plane>(), {Sentence::unequal_normal_parts, {name(first), name(second)}});
        }
    }

    /// The vector given at a point; of a direction ⟂ to the join nothing projects.
    VectorOn<Plane::velocity> vector_of(const State<Plane::velocity>& state, NodeIndex index) {
        for (const auto& given : state.given)
            if (given.node == index) return given.vector;
        KG_ASSERT(false, "projections are of given velocities");
    }

    template <Plane plane>
    void miss(State<plane>& state, NodeIndex index, NodeIndex against) {
        state.contradicted = true;
        begin<plane>(Sentence::act_misses, {absolute<plane>(index)}, "Rivals");
        if constexpr (is_velocity<plane>) {
            result_.figure.found = Found::contradiction;
            result_.figure.points = {node(index).point};
        }
        const bool same_place = against != none && board_.coincide(place(index), place(against));
        if (same_place) {
            unsolved(sought<plane>(),
                     {is_velocity<plane> ? Sentence::two_velocities_at_one_place : Sentence::two_accelerations_at_one_place,
                      {name(index), name(against)}});
        } else {
            unsolved(sought<plane>(),
                     {is_velocity<plane> ? Sentence::velocity_misses : Sentence::acceleration_misses, {name(index)}});
        }
    }

    // --- the centre ----------------------------------------------------------------------------------------------------------
    void settle_centre(PointOn<Plane::drawing> place, Found found, const std::vector<NodeIndex>& by) {
        result_.figure.found = found;
        result_.figure.points.clear();
        for (const NodeIndex index : by) result_.figure.points.push_back(node(index).point);
        centre_ = place;
        if (!wishes_.centre) return;
        result_.centre.how = InstantCentre::How::velocities;
        result_.centre.at = Recorded<ProjectivePoint>::at(place.element);
        if (found == Found::perpendiculars) result_.centre.normals = result_.figure.points;
    }

    /// The place of the body that is at rest, by a construction that suits the velocities at hand.
    void locate_centre(State<Plane::velocity>& state) {
        if (!state.base || !wishes_.centre || (centre_ && !turns(state))) return;
        const auto pole = board_.pole<Plane::velocity>();
        const Base<Plane::velocity>& base = *state.base;
        const auto v_base = board_.vector(pole, base.tip);
        const bool base_rests = board_.is_zero(v_base);
        const bool still = turns(state) && board_.is_zero(state.track.spin(body_));
        if (still && base_rests) {
            result_.figure.found = Found::rest;
            result_.figure.points.clear();
            result_.centre.everywhere = true;
            result_.centre.how = InstantCentre::How::velocities;
            begin<Plane::velocity>(Sentence::act_rest, {body()});
            return;
        }
        if (base_rests) return centre_at_rest(base.node);
        if (!turns(state)) return;
        const NodeIndex second = state.second;
        const auto v_second = board_.vector(pole, state.track.tip(second));
        if (still) {
            begin_centre(Sentence::act_translation,
                         {body(), absolute<Plane::velocity>(base.node), absolute<Plane::velocity>(second)}, "Rivals");
            settle_centre(board_.at_infinity(board_.perpendicular(board_.direction(v_base))), Found::translation,
                          {base.node, second});
            return;
        }
        if (board_.is_zero(v_second)) return centre_at_rest(second);
        const auto other = place(second);
        if (board_.parallel(board_.direction(v_base), board_.direction(v_second))) {
            // Rigid and turning, they are ⟂ to the join: speeds go with the distance from the centre.
            const StatementIndex statement = begin_centre(Sentence::act_tips, {}, "Euler–Chasles");
            const auto tip = [&](PointOn<Plane::drawing> from, VectorOn<Plane::velocity> velocity) {
                return board_.carry(from, board_.scale<Plane::drawing>(board_.number(1), velocity));
            };
            const auto met =
                board_.meet(board_.join(tip(base.place, v_base), tip(other, v_second)), board_.join(base.place, other));
            KG_ASSERT(met && !board_.is_at_infinity(*met), "velocities of different size have no parallel joins");
            settle_centre(*met, Found::tips, {base.node, second});
            board_.statement(statement).message.arguments = {symbol_of_centre(), absolute<Plane::velocity>(base.node),
                                                             absolute<Plane::velocity>(second),
                                                             Segment{base.label, node(second).label}};
            return;
        }
        const StatementIndex statement = begin_centre(Sentence::act_perpendiculars, {}, "Euler–Chasles");
        const auto perpendicular = [&](PointOn<Plane::drawing> at_place, VectorOn<Plane::velocity> velocity) {
            return board_.through(at_place, board_.perpendicular(board_.direction(velocity)));
        };
        const auto met = board_.meet(perpendicular(base.place, v_base), perpendicular(other, v_second));
        KG_ASSERT(met && !board_.is_at_infinity(*met), "velocities that are not parallel have perpendiculars that meet");
        settle_centre(*met, Found::perpendiculars, {base.node, second});
        board_.statement(statement).message.arguments = {symbol_of_centre(), name(base.node), name(second)};
    }

    void centre_at_rest(NodeIndex index) {
        settle_centre(place(index), Found::point_at_rest, {index});
        begin_centre(Sentence::act_point_at_rest, {symbol_of_centre(), name(index)}, "Euler–Chasles");
    }

    // --- all other points ----------------------------------------------------------------------------------------------------
    template <Plane plane>
    void draw_images(State<plane>& state) {
        if (!state.base || !turns(state)) return;
        for (const NodeIndex index : structure_.nodes_of(body_)) {
            if (state.track.has(index)) continue;
            say_image(state, index);
            set_tip(state, index, image_of(state, place(index)));
        }
    }

    template <Plane plane>
    void say_image(const State<plane>& state, NodeIndex index) {
        if constexpr (is_velocity<plane>) {
            if (result_.figure.found == Found::rest) return;
            if (board_.is_zero(state.track.spin(body_))) {
                begin<plane>(Sentence::translating_velocity, {body(), name(index), absolute<plane>(index)});
            } else if (centre_) {
                begin<plane>(Sentence::act_velocity, {absolute<plane>(index), name(index), symbol_of_centre(), spin<plane>()},
                             "Rivals");
            } else {
                begin<plane>(Sentence::image_velocity,
                             {name(index), body(), absolute<plane>(index), PointName{state.base->label}, spin<Plane::velocity>()},
                             "Rivals");
            }
        } else {
            begin<plane>(Sentence::image_acceleration,
                         {name(index), body(), absolute<plane>(index), PointName{state.base->label}, spin<Plane::velocity>(),
                          spin<plane>()},
                         "Rivals");
        }
    }

    /// What the velocities leave open, and what would close it.
    void explain(State<Plane::velocity>& state) {
        const Message what = sought<Plane::velocity>();
        const bool located = centre_.has_value() || result_.figure.found == Found::rest;
        if (state.base && turns(state)) return;
        if (wishes_.centre && !located) {
            if (state.given.empty()) {
                unsolved(sought_centre(), {Sentence::no_velocity_given, {}});
            } else {
                unsolved(sought_centre(), {Sentence::centre_on_perpendicular, {name(state.given.front().node)}});
            }
        }
        if (!wishes_.velocities) return;
        if (located && turns(state)) {
            unsolved(what, {Sentence::speed_of_translation_open, {}});
        } else if (located) {
            // Where the centre is a point of the file, that one is known.
            for (const NodeIndex index : structure_.nodes_of(body_)) {
                if (!state.track.has(index) && board_.coincide(place(index), *centre_))
                    set_tip(state, index, board_.pole<Plane::velocity>());
            }
            unsolved(what, {Sentence::size_open, {}});
        } else if (state.given.empty()) {
            unsolved(what, {Sentence::no_velocity_given, {}});
        } else {
            unsolved(what, {Sentence::turning_open, {}});
        }
    }

    // --- accelerations -------------------------------------------------------------------------------------------------------
    void draw_accelerations(const State<Plane::velocity>& velocities) {
        const Message what = sought<Plane::acceleration>();
        if (velocities.contradicted) return unsolved(what, {Sentence::velocities_contradict, {}});
        if (!turns(velocities)) return unsolved(what, {Sentence::omega_unknown, {}});
        if (mechanism_.motion->accelerations.empty()) return unsolved(what, {Sentence::no_acceleration_given, {}});
        State<Plane::acceleration> state(result_.motion.acceleration);
        begin_polygon(state, mechanism_.motion->accelerations);
        settle(state);
        if (state.contradicted) return;
        draw_images(state);
        if (!state.base || !turns(state)) {
            unsolved(what, {Sentence::acceleration_open, {}});
            return;
        }
        locate_acceleration_centre(state);
    }

    /// The place K without acceleration: AK = (ω² a_A + α z∧a_A) : (ω⁴ + α²).
    void locate_acceleration_centre(const State<Plane::acceleration>& state) {
        const ScalarHandle omega = result_.motion.velocity.spin(body_), alpha = state.track.spin(body_);
        const ScalarHandle square = board_.product(omega, omega);
        const ScalarHandle whole = board_.sum(board_.product(square, square), board_.product(alpha, alpha));
        if (board_.is_zero(whole)) return;
        result_.figure.acceleration_centre_name = free_name("K");
        result_.figure.acceleration_centre_statement = begin<Plane::acceleration>(
            Sentence::act_acceleration_centre, {PointName{result_.figure.acceleration_centre_name}, PointName{state.base->label}},
            "Burmester");
        const auto a = board_.vector(board_.pole<Plane::acceleration>(), state.base->tip);
        const auto along = board_.scale<Plane::drawing>(board_.quotient(square, whole), a);
        const auto aside = board_.scale<Plane::drawing>(board_.quotient(alpha, whole), board_.turn(a));
        result_.figure.acceleration_centre =
            Recorded<Vector>::at(board_.carry(board_.carry(state.base->place, along), aside).element);
    }

    std::string free_name(const std::string& letter) const { return kinegraph::free_name(mechanism_, letter); }

    Structure& structure_;
    Board& board_;
    SpaceDiagram diagram_;
    const Mechanism& mechanism_;
    BodyIndex body_;
    ActWishes wishes_;
    ActOfMotionResult result_;
    std::optional<PointOn<Plane::drawing>> centre_;
    NodeIndex parallel_base_ = none;  ///< the first of two parallel directions
};

}  // namespace

ActOfMotionResult draw_act_of_motion(Structure& structure, Board& board, const ActWishes& wishes) {
    return Act(structure, board, wishes).run();
}

}  // namespace kinegraph
