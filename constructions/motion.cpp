#include "constructions/motion.hpp"

#include <algorithm>
#include <cctype>
#include <set>

#include "constructions/polygon_pen.hpp"
#include "engine/assert.hpp"

namespace kinegraph {
namespace {

constexpr BodyIndex frame = 0;
std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// One known or sought vector of a chain, with its term in the equation.
template <Plane plane>
struct Link {
    Term term;
    VectorOn<plane> vector;
    DrawnVector::Role role = DrawnVector::Role::relative;
    bool shift = false;  ///< carries the locus from one node of a body to another
    Seen seen;
};

/// A locus as drawn: from the base's tip along known vectors, then a line on which the tip sought lies.
template <Plane plane>
struct Chain {
    NodeIndex base = -1;
    PointOn<plane> start, end;
    std::vector<Link<plane>> known;  ///< set off one after the other from `start`, those of an inverse chain backwards
    LineOn<plane> line;
    LineReason reason;
    Term sought;
    Seen seen;  ///< the vector sought
    DrawnVector::Role role = DrawnVector::Role::relative;
    bool from_rest = false;
    bool inverse = false;
    bool absolute = false;  ///< the sought vector is the node's whole velocity (acceleration)
};

/// A name that is one letter with digits reads well beside another such: BA, O2A.
bool is_short(const std::string& name) {
    const auto digit = [](char c) { return c == '*' || std::isdigit(static_cast<unsigned char>(c)) != 0; };
    return !name.empty() && std::isalpha(static_cast<unsigned char>(name[0])) != 0 &&
           std::all_of(name.begin() + 1, name.end(), digit);
}

class Recipes {
public:
    Recipes(Structure& structure, Board& board, const Plan& plan)
        : structure_(structure), board_(board), plan_(plan), mechanism_(structure.mechanism()) {}

    Motion run(bool with_accelerations) {
        draw(motion_.velocity, "velocity");
        if (with_accelerations) draw(motion_.acceleration, "acceleration");
        return std::move(motion_);
    }

    /// Velocities with all drivers at rest and one assumption moved.
    Track<Plane::velocity> response(std::size_t assumed) {
        hand_ = Hand::silent;
        drivers_rest_ = true;
        moved_ = &plan_.steps[assumed];
        Track<Plane::velocity> track;
        start(track);
        for (const Step& step : plan_.steps) carry_out(track, step);
        return track;
    }

    bool is_broken(Track<Plane::velocity> response, const Closing& condition) {
        hand_ = Hand::silent;
        drivers_rest_ = true;
        if (!condition.locus) return !board_.is_zero(mismatch_of_spins(response, condition));
        if (!ready(response, *condition.locus)) return false;
        const auto missed = miss(response, *condition.locus);
        return !board_.is_zero(missed) && !board_.parallel(board_.direction(missed), condition.locus->direction);
    }

private:
    /// Who draws: the solution itself, one of the two trials of an assumption, or a trial within a trial, which leaves no mark.
    enum class Hand { solution, first_trial, second_trial, silent };

    const Node& node(NodeIndex index) const { return structure_.node(index); }
    bool at_rest(NodeIndex index) const { return node(index).bodies.front() == frame; }
    /// The body whose colour a node's vector has.
    BodyIndex colour_of(NodeIndex index) const {
        const std::vector<BodyIndex>& bodies = node(index).bodies;
        if (at_rest(index)) return frame;
        // Of several the one that the frame guides: its locus of the velocity has that colour, so the acceleration has it too.
        const auto guided =
            std::find_if(bodies.begin(), bodies.end(), [&](BodyIndex each) { return structure_.is_guided_by_frame(each); });
        return guided == bodies.end() ? bodies.front() : *guided;
    }
    BodyName body(BodyIndex index) const { return {structure_.body_name(index)}; }

    template <Plane plane>
    Symbol absolute(NodeIndex index, std::string term = {}) const {
        return motion_symbol<plane>(node(index).label, std::move(term));
    }
    template <Plane plane>
    Symbol relative(NodeIndex of, NodeIndex to, std::string term = {}) const {
        return motion_symbol<plane>(relative_name(node(of).label, node(to).label), std::move(term));
    }
    template <Plane plane>
    Symbol spin_of(BodyIndex index) const {
        return spin_symbol<plane>(structure_.body_name(index));
    }
    template <Plane plane>
    Symbol image(NodeIndex index) const {
        return image_symbol<plane>(node(index).label);
    }
    CarriedPlace carried(NodeIndex index) const { return {node(index).place.element, node(index).bodies.front()}; }
    Seen seen(NodeIndex of) const { return {carried(of), {}, -1}; }
    /// From a place about which it turns.
    Seen turning(NodeIndex of, NodeIndex to) const { return {carried(of), carried(to), node(to).place.element}; }
    /// From a place of the guide in which it slides; in a curved one it turns, which only accelerations show.
    template <Plane plane>
    Seen sliding(JointIndex joint, NodeIndex slider, NodeIndex guide) {
        const PointIndex arc = is_velocity<plane> ? -1 : mechanism_.joints[at(joint)].arc;
        return {carried(slider), carried(guide), arc >= 0 ? board_.place(arc).element : -1};
    }
    Segment segment(NodeIndex from, NodeIndex to) const { return {node(from).label, node(to).label}; }

    template <Plane plane>
    int begin(Sentence sentence, std::vector<Argument> arguments, std::string source) {
        if (hand_ != Hand::solution) return -1;
        return state<plane>(board_, sentence, std::move(arguments), std::move(source));
    }
    /// The sentence begun, to complete it; in a trial nothing is said, and what is written here is forgotten.
    Statement& said(int statement) { return statement < 0 ? unsaid_ : board_.statement(statement); }
    int trial() const { return hand_ == Hand::first_trial ? 1 : hand_ == Hand::second_trial ? 2 : 0; }

    // --- drawing -----------------------------------------------------------------------------------------------------------
    template <Plane plane>
    PolygonPen<plane> pen(const Track<plane>& track) {
        return {board_, track.polygon, trial()};
    }
    template <Plane plane>
    void draw_vector(const Track<plane>& track, Symbol symbol, const Seen& seen, PointOn<plane> tail, PointOn<plane> tip,
                     BodyIndex body_of, DrawnVector::Role role) {
        if (hand_ != Hand::silent) pen(track).vector(std::move(symbol), seen, tail, tip, body_of, role);
    }

    template <Plane plane>
    void draw_line(const Track<plane>& track, LineOn<plane> line, LineReason reason, std::vector<int> points) {
        if (hand_ != Hand::silent) pen(track).line(line, std::move(reason), std::move(points));
    }

    template <Plane plane>
    void set_tip(Track<plane>& track, NodeIndex index, PointOn<plane> tip, bool draw_absolute) {
        track.tips.resize(structure_.nodes().size());
        track.tips[at(index)] = tip;
        // Places of the frame that are only steps to others would crowd the pole.
        const bool only_a_step = at_rest(index) && !node(index).carried && !node(index).of_interest;
        if (hand_ == Hand::silent || only_a_step) return;
        pen(track).image(image<plane>(index), tip, colour_of(index));
        if (draw_absolute) {
            draw_vector(track, absolute<plane>(index), seen(index), board_.pole<plane>(), tip, colour_of(index),
                        DrawnVector::Role::absolute);
        }
    }

    // --- the plan, step by step --------------------------------------------------------------------------------------------
    template <Plane plane>
    void draw(Track<plane>& track, const char* id) {
        Polygon polygon;
        polygon.id = id;
        track.polygon = PolygonPen<plane>::begin(board_, std::move(polygon));
        start(track);
        for (const Step& step : plan_.steps) carry_out(track, step);
    }

    /// The frame rests.
    template <Plane plane>
    void start(Track<plane>& track) {
        track.tips.resize(structure_.nodes().size());
        track.spins.resize(mechanism_.bodies.size());
        track.spins[frame] = board_.given(0);
        for (const NodeIndex index : structure_.nodes_of(frame)) set_tip(track, index, board_.pole<plane>(), false);
    }

    template <Plane plane>
    void carry_out(Track<plane>& track, const Step& step) {
        if constexpr (is_velocity<plane>) {
            for (const Locus* locus : {&step.first, &step.second}) introduce(*locus);
            if (step.closing.locus) introduce(*step.closing.locus);
        }
        switch (step.kind) {
            case Step::Kind::spin_by_joint:
                return spin_by_joint(track, step);
            case Step::Kind::spin_by_driver:
                return spin_by_driver(track, step);
            case Step::Kind::slide_by_driver:
                return slide_by_driver(track, step);
            case Step::Kind::image:
                return draw_image(track, step);
            case Step::Kind::roll:
                return draw_rolling_point(track, step);
            case Step::Kind::meet:
                return draw_meet(track, step);
            case Step::Kind::spin_from_pair:
                return spin_from_pair(track, step);
            case Step::Kind::auxiliary:
                return draw_auxiliary(track, step);
            case Step::Kind::spin_from_parallels:
                return spin_from_parallels(track, step);
            case Step::Kind::assume:
                return assume(track, step);
        }
    }

    /// What a driver asks of this plane; nothing where only the effect of an assumption is wanted.
    template <Plane plane>
    ScalarHandle driven(const Exact& velocity, const Exact& acceleration) {
        if (drivers_rest_) return board_.given(0);
        return board_.given(is_velocity<plane> ? velocity : acceleration);
    }

    /// Where a joint is, for readers: its point stands in the drawing, its own name does not.
    PointName place_of(const Joint& joint) const {
        return {joint.point >= 0 ? mechanism_.points[at(joint.point)].name : joint.name};
    }

    /// A sleeve or a weld lets no relative rotation: ω_i = ω_j, always, so α_i = α_j too.
    template <Plane plane>
    void spin_by_joint(Track<plane>& track, const Step& step) {
        if (!track.turns(step.other)) return;
        const Joint& joint = mechanism_.joints[at(step.joint)];
        if (joint.kind == JointKind::prismatic && joint.bodies[1] == frame)
            begin<plane>(either<plane>(Sentence::omega_by_fixed_guide, Sentence::alpha_by_fixed_guide),
                         {spin_of<plane>(step.body), body(step.body), place_of(joint)}, "");
        else
            begin<plane>(either<plane>(Sentence::omega_by_sleeve, Sentence::alpha_by_sleeve),
                         {spin_of<plane>(step.body), spin_of<plane>(step.other), place_of(joint)}, "");
        track.spins[at(step.body)] = track.spin(step.other);
    }

    template <Plane plane>
    void spin_by_driver(Track<plane>& track, const Step& step) {
        if (!track.turns(step.other)) return;
        const auto& driver = std::get<SpinDriver>(mechanism_.drivers[at(step.driver)]);
        if (step.other != frame) {
            begin<plane>(either<plane>(Sentence::omega_by_driver, Sentence::alpha_by_driver),
                         {spin_of<plane>(step.body), spin_of<plane>(step.other)}, "");
        }
        const ScalarHandle given = driven<plane>(driver.omega, driver.alpha);
        ScalarHandle& spin = track.spins[at(step.body)].emplace(given);
        if (step.other != frame)
            spin = step.inverse ? board_.difference(track.spin(step.other), given) : board_.sum(track.spin(step.other), given);
        if (step.other == frame && step.inverse) spin = board_.difference(board_.given(0), given);
    }

    /// v_X = v_X* + ṡ u;  a_X = a_X* + 2 ω_j ∧ v_rel + s̈ u (Coriolis), the slide being driven.
    template <Plane plane>
    void slide_by_driver(Track<plane>& track, const Step& step) {
        if (!track.has(step.base)) return;
        const auto& driver = std::get<SlideDriver>(mechanism_.drivers[at(step.driver)]);
        const BodyIndex guide_body = step.inverse ? step.body : step.other;
        if (!is_velocity<plane> && !motion_.velocity.turns(guide_body)) return;
        begin<plane>(either<plane>(Sentence::driven_point_velocity, Sentence::driven_point_acceleration),
                     {absolute<plane>(step.node), PointName{mechanism_.joints[at(step.joint)].name}},
                     is_velocity<plane> ? "" : "Coriolis");
        const NodeIndex slider = step.inverse ? step.base : step.node, guide = step.inverse ? step.node : step.base;
        PointOn<plane> tip = track.tip(step.base);
        std::vector<Link<plane>> links;
        if constexpr (!is_velocity<plane>) {
            if (const auto coriolis = coriolis_of(guide_body, slider, guide)) links.push_back(*coriolis);
        }
        Link<plane> slide;
        slide.vector = board_.scale<plane>(driven<plane>(driver.speed, driver.acceleration), board_.guide_unit(step.joint));
        slide.term.symbol = relative<plane>(slider, guide, is_velocity<plane> ? "" : "rel");
        slide.role = DrawnVector::Role::sliding;
        slide.seen = sliding<plane>(step.joint, slider, guide);
        links.push_back(slide);
        const bool show_parts = !at_rest(step.base);
        for (const Link<plane>& link : links) {
            const PointOn<plane> next = board_.carry(tip, step.inverse ? board_.negate(link.vector) : link.vector);
            if (show_parts) {
                if (step.inverse) {
                    draw_vector(track, link.term.symbol, link.seen, next, tip, colour_of(slider), link.role);
                } else {
                    draw_vector(track, link.term.symbol, link.seen, tip, next, colour_of(slider), link.role);
                }
            }
            tip = next;
        }
        set_tip(track, step.node, tip, true);
    }

    /// The image of a further point: v_X = v_C + ω ∧ CX;  a_X = a_C − ω² CX + α ∧ CX (Rivals).
    template <Plane plane>
    void draw_image(Track<plane>& track, const Step& step) {
        if (!track.has(step.base) || !track.turns(step.body)) return;
        const bool rest = at_rest(step.base);
        const int statement = rest ? begin<plane>(either<plane>(Sentence::crank_velocity, Sentence::crank_acceleration),
                                                  {body(step.body), PointName{node(step.base).label},
                                                   PointName{node(step.node).label}, absolute<plane>(step.node),
                                                   is_velocity<plane> ? Argument(spin_of<plane>(step.body))
                                                                      : Argument(absolute<plane>(step.node, "t"))},
                                                  "Rivals")
                                   : begin<plane>(either<plane>(Sentence::image_velocity, Sentence::image_acceleration),
                                                  {PointName{node(step.node).label}, body(step.body), absolute<plane>(step.node),
                                                   PointName{node(step.base).label}},
                                                  "Rivals");
        const auto join = board_.vector(node(step.base).place, node(step.node).place);
        PointOn<plane> tip = track.tip(step.base);
        if constexpr (is_velocity<plane>) {
            if (!rest && board_.is_zero(track.spin(step.body))) {
                said(statement).message = {Sentence::translating_velocity,
                                           {body(step.body), PointName{node(step.node).label}, absolute<plane>(step.node)}};
            } else {
                const auto turned = board_.scale<plane>(track.spin(step.body), board_.turn(join));
                tip = board_.carry(tip, turned);
                track.tangential[{step.base, step.node}] = turned;
            }
        } else {
            const auto normal = normal_of(step.body, step.base, step.node);
            const auto tangential = board_.scale<plane>(track.spin(step.body), board_.turn(join));
            track.tangential[{step.base, step.node}] = tangential;
            const PointOn<plane> middle = board_.carry(tip, normal);
            const PointOn<plane> end = board_.carry(middle, tangential);
            if (rest) {  // a crank: its normal and tangential parts are the first vectors of the figure
                const Seen seen = turning(step.node, step.base);
                draw_vector(track, absolute<plane>(step.node, "n"), seen, tip, middle, step.body, DrawnVector::Role::normal);
                if (!board_.is_zero(tangential))
                    draw_vector(track, absolute<plane>(step.node, "t"), seen, middle, end, step.body,
                                DrawnVector::Role::tangential);
            }
            tip = end;
        }
        set_tip(track, step.node, tip, true);
    }

    /// Before a contact or a mesh is first used: what it leaves to its places, and by what linkage it is replaced.
    void introduce(const Locus& locus) {
        const bool higher = locus.kind == Locus::Kind::link || locus.kind == Locus::Kind::tangent ||
                            locus.kind == Locus::Kind::mesh ||
                            (locus.kind == Locus::Kind::slot && mechanism_.joints[at(locus.joint)].kind == JointKind::contact);
        if (hand_ != Hand::solution || !higher || !introduced_.insert(locus.joint).second) return;
        const Joint& joint = mechanism_.joints[at(locus.joint)];
        const PointName contact{mechanism_.points[at(joint.point)].name};
        const NodeIndex pin = locus.inverse ? locus.base : locus.node;
        const BodyIndex other = joint.bodies[0] == locus.body ? joint.bodies[1] : joint.bodies[0];
        const auto equivalent = [&](EquivalentLinkage::Kind kind, BodyIndex first, BodyIndex second, NodeIndex on_first,
                                    NodeIndex on_second) {
            motion_.equivalents.push_back({kind, locus.joint, {first, second}, {node(on_first).point, node(on_second).point}});
        };
        switch (locus.kind) {
            case Locus::Kind::link:
                begin<Plane::velocity>(Sentence::equivalent_link,
                                       {body(locus.body), body(other), contact, segment(locus.base, locus.node)}, "Euler–Savary");
                return equivalent(EquivalentLinkage::Kind::link, locus.body, other, locus.node, locus.base);
            case Locus::Kind::slot: {
                const BodyIndex pins = locus.inverse ? other : locus.body;
                const bool tip = node(pin).point == joint.point;
                begin<Plane::velocity>(
                    tip ? Sentence::equivalent_tip : Sentence::equivalent_slot,
                    {body(pins), body(locus.guide), contact, PointName{mechanism_.points[at(node(pin).point)].name}},
                    tip ? "" : "Euler–Savary");
                return equivalent(EquivalentLinkage::Kind::slot, pins, locus.guide, pin, pin);
            }
            case Locus::Kind::mesh:
                begin<Plane::velocity>(Sentence::pitch_curves, {body(locus.body), body(other), contact}, "");
                return;
            default:
                begin<Plane::velocity>(Sentence::contact_tangent, {body(locus.body), body(other), contact}, "");
        }
    }

    /// Rolling: v_P = v_P*;  a_P = a_P* + a_PP*^n, which is ω_rel² · r₁r₂/(r₁ ± r₂) along the common normal (a line: r alone).
    template <Plane plane>
    void draw_rolling_point(Track<plane>& track, const Step& step) {
        if (!track.has(step.base)) return;
        const PointName contact{mechanism_.points[at(mechanism_.joints[at(step.joint)].point)].name};
        const bool rest = at_rest(step.base);
        if constexpr (is_velocity<plane>) {
            begin<plane>(rest ? Sentence::rolling_point_at_rest : Sentence::rolling_velocity,
                         {contact, body(step.body), body(step.other), absolute<plane>(step.node), absolute<plane>(step.base)},
                         "");
            set_tip(track, step.node, track.tip(step.base), !rest);
        } else {
            if (!rolls_known(step.joint)) return;
            const Symbol normal = rest ? absolute<plane>(step.node) : relative<plane>(step.node, step.base, "n");
            begin<plane>(rest ? Sentence::rolling_point_on_rest_acceleration : Sentence::rolling_acceleration,
                         {contact, body(step.body), body(step.other), absolute<plane>(step.node), absolute<plane>(step.base),
                          normal, rolling_lever(mechanism_.joints[at(step.joint)])},
                         "Euler–Savary");
            const PointOn<plane> from = track.tip(step.base);
            const PointOn<plane> tip = board_.carry(from, rolling_offset(step.joint, step.body));
            if (!rest)
                draw_vector(track, normal, {carried(step.node), carried(step.base), -1}, from, tip, colour_of(step.node),
                            DrawnVector::Role::normal);
            set_tip(track, step.node, tip, true);
        }
    }

    /// Two circles curve apart where their centres are on different sides of the contact.
    RollingLever rolling_lever(const Joint& joint) const {
        std::vector<Vector> radii;
        for (const BodyIndex each : joint.bodies)
            if (const auto* circle = std::get_if<CircleProfile>(&joint.profiles.at(each)))
                radii.push_back(board_.pose().at(circle->centre) - board_.pose().at(joint.point));
        if (radii.size() < 2) return RollingLever::on_straight;
        return dot(radii[0], radii[1]).sign() < 0 ? RollingLever::outside : RollingLever::inside;
    }

    bool rolls_known(JointIndex index) const {
        const Joint& joint = mechanism_.joints[at(index)];
        const auto& before = motion_.velocity;
        return before.turns(joint.bodies[0]) && before.turns(joint.bodies[1]) && structure_.has_curvatures(index);
    }

    /// a_P − a_P*, P on `body`: with c₁, c₂ from the contact to the centres of curvature, ω_rel² c₁ · c₂/(c₂ − c₁); on a line
    /// ω_rel² c.
    VectorOn<Plane::acceleration> rolling_offset(JointIndex index, BodyIndex body_of) {
        const Joint& joint = mechanism_.joints[at(index)];
        const BodyIndex other = joint.bodies[0] == body_of ? joint.bodies[1] : joint.bodies[0];
        const auto contact = board_.place(joint.point);
        const auto centre = [&](BodyIndex of) -> std::optional<PointOn<Plane::drawing>> {
            const Profile& profile = joint.profiles.at(of);
            if (std::holds_alternative<LineProfile>(profile)) return std::nullopt;
            const auto* circle = std::get_if<CircleProfile>(&profile);
            return circle == nullptr ? contact : board_.place(circle->centre);
        };
        const auto own = centre(body_of), others = centre(other);
        VectorOn<Plane::drawing> lever = own ? board_.vector(contact, *own) : board_.vector(*others, contact);
        if (own && others)
            lever =
                board_.scale<Plane::drawing>(board_.ratio(board_.vector(contact, *others), board_.vector(*own, *others)), lever);
        const ScalarHandle turning = board_.difference(motion_.velocity.spin(body_of), motion_.velocity.spin(other));
        return board_.scale<Plane::acceleration>(board_.product(turning, turning), lever);
    }

    /// Two loci meet in the tip sought: the dyad's vector equation, closed.
    template <Plane plane>
    void draw_meet(Track<plane>& track, const Step& step) {
        if (!ready(track, step.first) || !ready(track, step.second)) return;
        const int statement = begin<plane>(either<plane>(Sentence::two_lines_velocity, Sentence::two_lines_acceleration), {}, "");
        const Chain<plane> first = chain(track, step.first);
        const Chain<plane> second = chain(track, step.second);
        const auto met = board_.meet(first.line, second.line);
        KG_ASSERT(met && !board_.is_at_infinity(*met), "the plan lets only lines meet that are not parallel");
        said(statement).message.arguments = {image<plane>(step.node), first.reason, second.reason};
        said(statement).equation = equation(step.node, first, second);
        const bool slides = step.first.kind != Locus::Kind::rotation || step.second.kind != Locus::Kind::rotation;
        said(statement).source = !is_velocity<plane> && slides ? "Coriolis" : "Rivals";
        bool absolute_drawn = false;
        for (const Chain<plane>* drawn : {&first, &second}) {
            draw_line(track, drawn->line, drawn->reason, {drawn->end.element, met->element});
            draw_chain(track, *drawn, *met, colour_of(step.node));
            absolute_drawn = absolute_drawn || drawn->absolute;
        }
        remember_tangential(track, step.first, first, *met);
        remember_tangential(track, step.second, second, *met);
        set_tip(track, step.node, *met, !absolute_drawn);
    }

    /// ω = v_BA / AB from the part of the velocity ⟂ to the join; α = a_BA^t / AB.
    template <Plane plane>
    void spin_from_pair(Track<plane>& track, const Step& step) {
        if (!track.has(step.base) || !track.has(step.node)) return;
        if (!is_velocity<plane> && !motion_.velocity.turns(step.body)) return;
        Symbol relative_symbol = at_rest(step.base) ? absolute<plane>(step.node, is_velocity<plane> ? "" : "t")
                                                    : relative<plane>(step.node, step.base, is_velocity<plane> ? "" : "t");
        begin<plane>(either<plane>(Sentence::omega_from_pair, Sentence::alpha_from_pair),
                     {spin_of<plane>(step.body), relative_symbol, segment(step.base, step.node), body(step.body)}, "Rivals");
        const auto turned = board_.turn(board_.vector(node(step.base).place, node(step.node).place));
        const auto found = track.tangential.find({step.base, step.node});
        VectorOn<plane> tangential;
        if (found != track.tangential.end()) {
            tangential = found->second;
        } else {
            tangential = board_.vector(track.tip(step.base), track.tip(step.node));
            if constexpr (!is_velocity<plane>)
                tangential = board_.subtract(tangential, normal_of(step.body, step.base, step.node));
            if (!board_.is_zero(tangential) && !board_.parallel(board_.direction(tangential), board_.direction(turned))) {
                if (hand_ == Hand::solution) {
                    if (is_velocity<plane>) motion_.contradictions.push_back({step.body, step.base, step.node});
                    return;
                }
                // A trial need not close: ω comes from the part ⟂ to the join, and the other part tells how far off it is.
                const auto foot = board_.meet(board_.through(board_.pole<plane>(), board_.direction(turned)),
                                              board_.through(board_.carry(board_.pole<plane>(), tangential),
                                                             board_.perpendicular(board_.direction(turned))));
                tangential = board_.vector(board_.pole<plane>(), *foot);
            }
        }
        track.spins[at(step.body)] = board_.ratio(tangential, turned);
    }

    /// Assur's point S of a body with two loci: v_S has the same projection as v_X on XS, so its tip lies on the locus of X as on
    /// that of Y; for accelerations each locus is first shifted by −ω²·XS.
    template <Plane plane>
    void draw_auxiliary(Track<plane>& track, const Step& step) {
        if (!ready(track, step.first) || !ready(track, step.second)) return;
        if (!is_velocity<plane> && !motion_.velocity.turns(step.body)) return;
        const int statement = begin<plane>(Sentence::auxiliary_point, {}, "Assur");
        LineOn<plane> lines[2];
        LineReason reasons[2];
        PointOn<plane> ends[2];
        const Locus* loci[2] = {&step.first, &step.second};
        for (int i = 0; i < 2; ++i) {
            const Chain<plane> drawn = chain(track, *loci[i]);
            lines[i] = drawn.line;
            ends[i] = drawn.end;
            reasons[i] = drawn.reason;
            if constexpr (!is_velocity<plane>) {
                ends[i] = board_.carry(drawn.end, normal_of(step.body, loci[i]->holds(), step.node));
                lines[i] = board_.through(ends[i], loci[i]->direction);
            }
        }
        const auto met = board_.meet(lines[0], lines[1]);
        KG_ASSERT(met && !board_.is_at_infinity(*met), "the loci of an auxiliary point are not parallel");
        for (int i = 0; i < 2; ++i) draw_line(track, lines[i], reasons[i], {ends[i].element, met->element});
        said(statement).message.arguments = {Symbol{Symbol::Letter::point, node(step.node).label, {}}, body(step.body),
                                             reasons[0], reasons[1]};
        set_tip(track, step.node, *met, true);
    }

    /// Two parallel loci (S at infinity): the velocities' difference along the loci's normal n is ω (z ∧ XY)·n.
    template <Plane plane>
    void spin_from_parallels(Track<plane>& track, const Step& step) {
        if (!ready(track, step.first) || !ready(track, step.second)) return;
        if (!is_velocity<plane> && !motion_.velocity.turns(step.body)) return;
        begin<plane>(either<plane>(Sentence::omega_from_parallels, Sentence::alpha_from_parallels),
                     {spin_of<plane>(step.body), segment(step.first.holds(), step.second.holds()), body(step.body)}, "Rivals");
        const Chain<plane> first = chain(track, step.first);
        const Chain<plane> second = chain(track, step.second);
        draw_line(track, first.line, first.reason, {first.end.element});
        draw_line(track, second.line, second.reason, {second.end.element});
        // From a place of the first locus, the line ⟂ to the join (the direction of the difference sought) meets the second.
        const auto join = board_.vector(node(step.first.holds()).place, node(step.second.holds()).place);
        PointOn<plane> from = first.end;
        if constexpr (!is_velocity<plane>)
            from = board_.carry(from, normal_of(step.body, step.first.holds(), step.second.holds()));
        const auto turned = board_.turn(join);
        const auto met = board_.meet(board_.through(from, board_.direction(turned)), second.line);
        KG_ASSERT(met && !board_.is_at_infinity(*met), "perpendiculars that coincide are no two loci");
        track.spins[at(step.body)] = board_.ratio(board_.vector(from, *met), turned);
    }

    // --- trials ------------------------------------------------------------------------------------------------------------
    /// Where a trial's tip lies, seen from the place on its locus that the trial offers it.
    template <Plane plane>
    VectorOn<plane> miss(Track<plane>& track, const Locus& locus) {
        const Chain<plane> drawn = chain(track, locus);
        return board_.vector(drawn.end, track.tip(locus.node));
    }

    /// By how much two angular velocities that must agree do not.
    template <Plane plane>
    ScalarHandle mismatch_of_spins(const Track<plane>& track, const Closing& closing) {
        const ScalarHandle relative = board_.difference(track.spin(closing.body), track.spin(closing.other));
        if (closing.driver < 0) return relative;
        const auto& driver = std::get<SpinDriver>(mechanism_.drivers[at(closing.driver)]);
        return board_.difference(relative, driven<plane>(driver.omega, driver.alpha));
    }

    /// An unknown with its two trial values: the tip of a node on its line, or a body's ω (α).
    template <Plane plane>
    struct Assumed {
        std::optional<Chain<plane>> line;
        PointOn<plane> tips[2];
        ScalarHandle spins[2];
    };

    /// The last rule: one unknown is given two values, the polygon is drawn from each as far as a condition that closes it, and
    /// since all is linear the true value follows from how far the two drawings miss.
    template <Plane plane>
    void assume(Track<plane>& track, const Step& step) {
        if (step.node >= 0 && !ready(track, step.first)) return;
        if (!step.closing.found()) return set_assumed(track, step, assumed_of(track, step), &step == moved_ ? 1 : 0);
        begin<plane>(step.node >= 0 ? Sentence::trial_on_line : Sentence::trial_of_spin, assumption_arguments<plane>(step), "");
        const Assumed<plane> assumed = assumed_of(track, step);
        VectorOn<plane> missed[2];
        ScalarHandle mismatch[2];
        std::optional<PointOn<plane>> ends[2];
        const Hand hand = hand_;
        for (const int i : {0, 1}) {
            hand_ = hand != Hand::solution ? Hand::silent : i == 0 ? Hand::first_trial : Hand::second_trial;
            Track<plane> drawn = track;
            set_assumed(drawn, step, assumed, i);
            for (const Step& inner : step.trial) carry_out(drawn, inner);
            if (!can_close(drawn, step.closing)) {
                hand_ = hand;
                return;
            }
            if (step.closing.locus) {
                missed[i] = miss(drawn, *step.closing.locus);
                ends[i] = drawn.tip(step.closing.locus->node);
            } else {
                mismatch[i] = mismatch_of_spins(drawn, step.closing);
            }
        }
        hand_ = hand;
        begin<plane>(step.closing.locus ? Sentence::trial_closes_on_line : Sentence::trial_closes_by_spin,
                     closing_arguments<plane>(step), "");
        const ScalarHandle share = step.closing.locus ? share_by_line(missed, step.closing.locus->direction)
                                                      : board_.quotient(mismatch[0], board_.difference(mismatch[0], mismatch[1]));
        if (ends[0] && !board_.coincide(*ends[0], *ends[1])) {
            draw_line_of_ends(track, *ends[0], *ends[1]);
        }
        settle(track, step, assumed, share);
    }

    /// The line on which the tip moves from trial to trial, and on which the true one lies.
    template <Plane plane>
    void draw_line_of_ends(const Track<plane>& track, PointOn<plane> first, PointOn<plane> second) {
        if (hand_ != Hand::solution) return;
        hand_ = Hand::second_trial;
        draw_line(track, board_.join(first, second), LineReason{}, {first.element, second.element});
        hand_ = Hand::solution;
    }

    template <Plane plane>
    bool can_close(const Track<plane>& track, const Closing& closing) const {
        if (!closing.locus) return track.turns(closing.body) && track.turns(closing.other);
        if (!track.has(closing.locus->node) || !ready(track, *closing.locus)) return false;
        return closing.locus->kind != Locus::Kind::image || track.turns(closing.locus->body);
    }

    template <Plane plane>
    Assumed<plane> assumed_of(Track<plane>& track, const Step& step) {
        Assumed<plane> assumed;
        if (step.node < 0) {
            assumed.spins[0] = board_.given(0);
            assumed.spins[1] = board_.given(1);
            return assumed;
        }
        assumed.line = chain(track, step.first);
        assumed.tips[0] = assumed.line->end;
        assumed.tips[1] = board_.carry(
            assumed.line->end, board_.scale<plane>(board_.given(reach(track, step.first.direction)), step.first.direction));
        return assumed;
    }

    template <Plane plane>
    void set_assumed(Track<plane>& track, const Step& step, const Assumed<plane>& assumed, int which) {
        if (step.node < 0) {
            track.spins[at(step.body)] = assumed.spins[which];
            return;
        }
        set_on_line(track, step, *assumed.line, assumed.tips[which]);
    }

    /// The tip of the assumed node at a place of its line.
    template <Plane plane>
    void set_on_line(Track<plane>& track, const Step& step, const Chain<plane>& line, PointOn<plane> tip) {
        draw_chain(track, line, tip, colour_of(step.node));
        remember_tangential(track, step.first, line, tip);
        set_tip(track, step.node, tip, !line.absolute);
    }

    /// The true value: so many parts of the way from the first trial to the second.
    template <Plane plane>
    void settle(Track<plane>& track, const Step& step, const Assumed<plane>& assumed, ScalarHandle share) {
        if (step.node < 0) {
            track.spins[at(step.body)] = board_.product(share, assumed.spins[1]);
            return;
        }
        const auto way = board_.vector(assumed.tips[0], assumed.tips[1]);
        const PointOn<plane> tip = board_.carry(assumed.tips[0], board_.scale<plane>(share, way));
        draw_line(track, assumed.line->line, assumed.line->reason, {assumed.line->end.element, tip.element});
        set_on_line(track, step, *assumed.line, tip);
    }

    /// The two misses set off from one point: the line of their ends meets the line through it ∥ to the locus where nothing is
    /// missed.
    template <Plane plane>
    ScalarHandle share_by_line(const VectorOn<plane> (&missed)[2], DirectionHandle direction) {
        const PointOn<plane> pole = board_.pole<plane>();
        const PointOn<plane> first = board_.carry(pole, missed[0]), second = board_.carry(pole, missed[1]);
        const auto met = board_.meet(board_.join(first, second), board_.through(pole, direction));
        KG_ASSERT(met && !board_.is_at_infinity(*met), "the plan closes only with a condition that the assumption moves");
        return board_.ratio(board_.vector(first, *met), board_.vector(first, second));
    }

    /// How many times a direction the second trial is set off: free to choose, so about as long as the longest vector drawn yet,
    /// in one figure.
    template <Plane plane>
    Exact reach(const Track<plane>& track, DirectionHandle direction) const {
        if (hand_ == Hand::silent) return 1;
        Exact longest = 0;  // squared, as all lengths here
        for (const auto& tip : track.tips)
            if (tip) longest = std::max(longest, squared_length(board_.value(*tip).place()));
        const Vector way = board_.protocol().vector(direction.element);
        if (longest.is_zero() || squared_length(way).is_zero()) return 1;
        Exact power = 1;
        while (squared_length(Exact(10) * power * way) <= longest) power = power * Exact(10);
        while (longest < squared_length(power * way)) power = power / Exact(10);
        return power;
    }

    template <Plane plane>
    std::vector<Argument> assumption_arguments(const Step& step) {
        if (step.node < 0) return {spin_of<plane>(step.body)};
        return {image<plane>(step.node), reason_of(step.first)};
    }

    template <Plane plane>
    std::vector<Argument> closing_arguments(const Step& step) {
        const Symbol assumed = step.node >= 0 ? image<plane>(step.node) : spin_of<plane>(step.body);
        if (!step.closing.locus) return {spin_of<plane>(step.closing.body), spin_of<plane>(step.closing.other), assumed};
        return {image<plane>(step.closing.locus->node), reason_of(*step.closing.locus), assumed};
    }

    LineReason reason_of(const Locus& locus) const {
        switch (locus.kind) {
            case Locus::Kind::rotation:
            case Locus::Kind::link:
                return {LineReason::Kind::perpendicular_to_segment, node(locus.base).label, node(locus.node).label};
            case Locus::Kind::image:
                return {LineReason::Kind::parallel_to_segment, node(locus.base).label, node(locus.node).label};
            case Locus::Kind::component:
                return {LineReason::Kind::driver_component, node(locus.node).label, {}};
            case Locus::Kind::sleeve:
            case Locus::Kind::slot:
            case Locus::Kind::tangent:
            case Locus::Kind::mesh:
                return line_reason(locus);
            case Locus::Kind::driven_slide:
                return along_guide(mechanism_, locus.joint, true);
            case Locus::Kind::roll:
                return {LineReason::Kind::known, {}, {}};
        }
        return {};
    }

    // --- loci --------------------------------------------------------------------------------------------------------------
    template <Plane plane>
    bool ready(const Track<plane>& track, const Locus& locus) const {
        using Kind = Locus::Kind;
        if (locus.kind != Kind::component && !track.has(locus.base)) return false;
        for (const Carry& carry : locus.carries) {
            if (carry.kind == Carry::Kind::image && !track.turns(carry.body)) return false;
        }
        if constexpr (!is_velocity<plane>) {
            const auto& before = motion_.velocity;
            for (const Carry& carry : locus.carries) {
                if (carry.kind == Carry::Kind::image ? !before.turns(carry.body) : !rolls_known(carry.joint)) return false;
            }
            if (locus.kind == Kind::tangent || (locus.kind == Kind::roll && !rolls_known(locus.joint))) return false;
            if (locus.kind == Kind::rotation && !before.turns(locus.body)) return false;
            const bool slides = locus.kind == Kind::sleeve || locus.kind == Kind::slot || locus.kind == Kind::driven_slide;
            if (slides && !before.turns(locus.guide)) return false;
            if ((slides || locus.kind == Kind::link) && (!has_velocity(locus.node) || !has_velocity(locus.base))) return false;
        }
        return true;
    }

    template <Plane plane>
    Chain<plane> chain(Track<plane>& track, const Locus& locus) {
        Chain<plane> result;
        switch (locus.kind) {
            case Locus::Kind::rotation:
            case Locus::Kind::link:
                start_rotation(track, locus, result);
                break;
            case Locus::Kind::sleeve:
            case Locus::Kind::slot:
            case Locus::Kind::tangent:
            case Locus::Kind::mesh:
                start_slide(track, locus, result);
                break;
            case Locus::Kind::component:
                start_component(track, locus, result);
                break;
            case Locus::Kind::image:
                start_image(track, locus, result);
                break;
            case Locus::Kind::driven_slide:
                start_driven_slide(track, locus, result);
                break;
            case Locus::Kind::roll:
                start_roll(track, locus, result);
                break;
        }
        result.end = result.start;
        for (const Carry& carry : locus.carries) shift(track, carry, result);
        for (const Link<plane>& link : result.known) result.end = set_off(result, link, result.end);
        result.line = board_.through(result.end, locus.direction);
        return result;
    }

    static bool is_backwards(bool inverse, bool is_shift) { return inverse && !is_shift; }

    template <Plane plane>
    PointOn<plane> set_off(const Chain<plane>& drawn, const Link<plane>& link, PointOn<plane> from) {
        return board_.carry(from, is_backwards(drawn.inverse, link.shift) ? board_.negate(link.vector) : link.vector);
    }

    /// Known base, direction ⟂ to the join: v_BA ⟂ BA; a_BA = a_BA^n + a_BA^t. An equivalent link turns as a body would.
    template <Plane plane>
    void start_rotation(const Track<plane>& track, const Locus& locus, Chain<plane>& result) {
        result.base = locus.base;
        result.start = track.tip(locus.base);
        result.from_rest = at_rest(locus.base);
        result.absolute = is_velocity<plane> && result.from_rest;
        result.reason = {LineReason::Kind::perpendicular_to_segment, node(locus.base).label, node(locus.node).label};
        result.role = is_velocity<plane> ? DrawnVector::Role::relative : DrawnVector::Role::tangential;
        const auto symbol = [&](std::string term) {
            return result.from_rest ? absolute<plane>(locus.node, std::move(term))
                                    : relative<plane>(locus.node, locus.base, std::move(term));
        };
        if (result.absolute) result.role = DrawnVector::Role::absolute;
        result.seen = turning(locus.node, locus.base);
        if constexpr (!is_velocity<plane>) {
            Link<plane> normal;
            normal.vector = locus.kind == Locus::Kind::link ? centripetal_about(node(locus.base).place, locus.base, locus.node)
                                                            : normal_of(locus.body, locus.base, locus.node);
            normal.role = DrawnVector::Role::normal;
            normal.seen = result.seen;
            normal.term = {symbol("n"),
                           true,
                           true,
                           {LineReason::Kind::parallel_to_segment, node(locus.base).label, node(locus.node).label},
                           locus.body};
            if (!board_.is_zero(normal.vector)) result.known.push_back(normal);
        }
        result.sought = {symbol(is_velocity<plane> ? "" : "t"), false, true, result.reason, locus.body};
    }

    /// Known place of the other body, direction ∥ guide: v_X = v_X* + v_XX*; a_X = a_X* + a_XX*^cor + a_XX*^rel.
    template <Plane plane>
    void start_slide(const Track<plane>& track, const Locus& locus, Chain<plane>& result) {
        const Joint& joint = mechanism_.joints[at(locus.joint)];
        result.base = locus.base;
        result.start = track.tip(locus.base);
        result.from_rest = at_rest(locus.base);
        result.inverse = locus.inverse && !result.from_rest;
        const LineReason normal = normal_reason(locus);
        result.reason = line_reason(locus);
        result.role = DrawnVector::Role::sliding;
        const NodeIndex slider = locus.inverse ? locus.base : locus.node, guide = locus.inverse ? locus.node : locus.base;
        const BodyIndex colour = joint.bodies[0] == frame ? joint.bodies[1] : joint.bodies[0];
        const auto symbol = [&](std::string term) {
            return result.from_rest ? absolute<plane>(locus.node, std::move(term))
                                    : relative<plane>(slider, guide, std::move(term));
        };
        if constexpr (!is_velocity<plane>) {
            const auto add = [&](std::optional<Link<plane>> link, const LineReason& reason) {
                if (!link) return;
                // Seen from a guide's place whose slider rests, the terms change sides: they are the place's own.
                if (result.from_rest && locus.inverse) link->vector = board_.negate(link->vector);
                link->term = {symbol(link->term.symbol.term), true, true, reason, colour};
                result.known.push_back(*link);
            };
            if (locus.kind != Locus::Kind::mesh) add(coriolis_of(locus.guide, slider, guide), normal);
            if (joint.arc >= 0) add(centripetal_of(locus.joint, slider, guide), normal);
        }
        result.absolute = result.from_rest && result.known.empty();
        if (result.absolute) result.role = DrawnVector::Role::absolute;
        result.seen = result.absolute ? seen(locus.node) : sliding<plane>(locus.joint, slider, guide);
        const bool plain = is_velocity<plane> || result.absolute;
        const char* term = locus.kind == Locus::Kind::mesh ? "n" : "rel";
        result.sought = {symbol(plain ? "" : term), false, true, result.reason, colour};
    }

    LineReason line_reason(const Locus& locus) const {
        const Joint& joint = mechanism_.joints[at(locus.joint)];
        if (locus.kind == Locus::Kind::mesh) return {LineReason::Kind::parallel_to_normal, joint.name, {}};
        if (joint.kind == JointKind::contact) return {LineReason::Kind::parallel_to_tangent, joint.name, {}};
        return along_guide(mechanism_, locus.joint, false);
    }
    LineReason normal_reason(const Locus& locus) const {
        const Joint& joint = mechanism_.joints[at(locus.joint)];
        if (joint.kind == JointKind::contact) return {LineReason::Kind::parallel_to_normal, joint.name, {}};
        return along_guide(mechanism_, locus.joint, true);
    }

    /// A driver gives the component along X: from the pole set it off, then ⟂ to X.
    template <Plane plane>
    void start_component(const Track<plane>&, const Locus& locus, Chain<plane>& result) {
        const auto& driver = std::get<PointDriver>(mechanism_.drivers[at(locus.driver)]);
        result.start = board_.pole<plane>();
        result.from_rest = true;
        result.reason = {LineReason::Kind::driver_component, node(locus.node).label, {}};
        Link<plane> component;
        component.vector =
            board_.scale<plane>(driven<plane>(driver.speed, driver.acceleration), board_.driver_unit(locus.driver));
        component.term = {absolute<plane>(locus.node, "∥"), true, true, {LineReason::Kind::known, {}, {}}, locus.body};
        result.known.push_back(component);
        result.sought = {absolute<plane>(locus.node, "⟂"), false, true, result.reason, locus.body};
    }

    /// ω of the body known: the image of the node from the base, and the line along the join on which it lies.
    template <Plane plane>
    void start_image(const Track<plane>& track, const Locus& locus, Chain<plane>& result) {
        const auto join = board_.vector(node(locus.base).place, node(locus.node).place);
        result.base = locus.base;
        result.start = track.tip(locus.base);
        result.reason = {LineReason::Kind::parallel_to_segment, node(locus.base).label, node(locus.node).label};
        Link<plane> turned;
        turned.vector = board_.scale<plane>(track.spin(locus.body), board_.turn(join));
        result.known.push_back(turned);
        if constexpr (!is_velocity<plane>) {
            Link<plane> normal;
            normal.vector = normal_of(locus.body, locus.base, locus.node);
            result.known.push_back(normal);
        }
    }

    /// A driven slide: its component along the guide is given.
    template <Plane plane>
    void start_driven_slide(const Track<plane>& track, const Locus& locus, Chain<plane>& result) {
        const auto& driver = std::get<SlideDriver>(mechanism_.drivers[at(locus.driver)]);
        result.base = locus.base;
        result.start = track.tip(locus.base);
        result.reason = along_guide(mechanism_, locus.joint, true);
        Link<plane> slide;
        slide.vector = board_.scale<plane>(driven<plane>(driver.speed, driver.acceleration), board_.guide_unit(locus.joint));
        result.known.push_back(slide);
        if constexpr (!is_velocity<plane>) {
            if (const auto coriolis = coriolis_of(locus.guide, locus.node, locus.base)) result.known.push_back(*coriolis);
        }
    }

    /// In contact with the base in rolling: from its tip by the difference of accelerations.
    template <Plane plane>
    void start_roll(const Track<plane>& track, const Locus& locus, Chain<plane>& result) {
        result.base = locus.base;
        result.start = track.tip(locus.base);
        if constexpr (!is_velocity<plane>) {
            Link<plane> offset;
            offset.vector = rolling_offset(locus.joint, locus.body);
            result.known.push_back(offset);
        }
    }

    /// The locus of another node carried to the one sought: by ω ∧ YX (and −ω² YX) on a body whose spin is known; over a rolling
    /// contact by nothing (and the difference of its accelerations).
    template <Plane plane>
    void shift(const Track<plane>& track, const Carry& carry, Chain<plane>& result) {
        const auto add = [&](VectorOn<plane> vector, const std::string& term, LineReason reason, DrawnVector::Role role) {
            Link<plane> link;
            link.vector = vector;
            link.role = role;
            link.shift = true;
            link.term = {relative<plane>(carry.to, carry.from, term), true, true, std::move(reason), carry.body};
            link.seen = carry.kind == Carry::Kind::roll ? Seen{carried(carry.to), carried(carry.from), -1}
                                                        : turning(carry.to, carry.from);
            if (!board_.is_zero(vector)) result.known.push_back(link);
        };
        result.absolute = false;
        result.from_rest = false;
        if (carry.kind == Carry::Kind::roll) {
            if constexpr (!is_velocity<plane>) {
                add(rolling_offset(carry.joint, carry.body), "n",
                    {LineReason::Kind::parallel_to_normal, mechanism_.joints[at(carry.joint)].name, {}},
                    DrawnVector::Role::normal);
            }
            return;
        }
        const auto join = board_.vector(node(carry.from).place, node(carry.to).place);
        const LineReason across{LineReason::Kind::perpendicular_to_segment, node(carry.from).label, node(carry.to).label};
        const LineReason along{LineReason::Kind::parallel_to_segment, node(carry.from).label, node(carry.to).label};
        if constexpr (!is_velocity<plane>)
            add(normal_of(carry.body, carry.from, carry.to), "n", along, DrawnVector::Role::normal);
        add(board_.scale<plane>(track.spin(carry.body), board_.turn(join)), is_velocity<plane> ? "" : "t", across,
            DrawnVector::Role::tangential);
    }

    /// −ω² · (from → to).
    VectorOn<Plane::acceleration> normal_of(BodyIndex turning, NodeIndex from, NodeIndex to) {
        auto [entry, fresh] = squares_.try_emplace(turning);
        if (fresh) {
            const ScalarHandle omega = motion_.velocity.spin(turning);
            entry->second = board_.product(omega, omega);
        }
        return board_.scale<Plane::acceleration>(entry->second, board_.vector(node(to).place, node(from).place));
    }

    /// The tip of a node that was not drawn for its own sake, from the image of a body that carries it.
    PointOn<Plane::velocity> velocity_tip(NodeIndex index) {
        Track<Plane::velocity>& track = motion_.velocity;
        if (track.has(index)) return track.tip(index);
        for (const BodyIndex carrier : node(index).bodies) {
            if (!track.turns(carrier)) continue;
            for (const NodeIndex base : structure_.nodes_of(carrier)) {
                if (!track.has(base)) continue;
                const auto join = board_.vector(node(base).place, node(index).place);
                const auto tip =
                    board_.carry(track.tip(base), board_.scale<Plane::velocity>(track.spin(carrier), board_.turn(join)));
                track.tips[at(index)] = tip;
                return tip;
            }
        }
        KG_ASSERT(false, "asked for the velocity of a body that is not known");
    }

    bool has_velocity(NodeIndex index) const {
        const Track<Plane::velocity>& track = motion_.velocity;
        if (track.has(index)) return true;
        return std::any_of(node(index).bodies.begin(), node(index).bodies.end(), [&](BodyIndex carrier) {
            const auto& nodes = structure_.nodes_of(carrier);
            return track.turns(carrier) &&
                   std::any_of(nodes.begin(), nodes.end(), [&](NodeIndex base) { return track.has(base); });
        });
    }

    /// v_rel of the slider seen from the guide.
    VectorOn<Plane::velocity> sliding_velocity(NodeIndex slider, NodeIndex guide) {
        const auto from = velocity_tip(guide);
        return board_.vector(from, velocity_tip(slider));
    }

    /// 2 ω_j ∧ v_rel, nothing where it vanishes.
    std::optional<Link<Plane::acceleration>> coriolis_of(BodyIndex guide_body, NodeIndex slider, NodeIndex guide) {
        const ScalarHandle omega = motion_.velocity.spin(guide_body);
        if (guide_body == frame || board_.is_zero(omega)) return std::nullopt;
        Link<Plane::acceleration> link;
        link.vector = board_.scale<Plane::acceleration>(board_.product(board_.given(2), omega),
                                                        board_.turn(sliding_velocity(slider, guide)));
        if (board_.is_zero(link.vector)) return std::nullopt;
        link.term.symbol = relative<Plane::acceleration>(slider, guide, "cor");
        link.role = DrawnVector::Role::coriolis;
        link.seen = {carried(slider), carried(guide), -1};
        return link;
    }

    /// A slot curved about C: the pin turns about C as seen from the slot, −ω_r² · CP.
    std::optional<Link<Plane::acceleration>> centripetal_of(JointIndex joint, NodeIndex slider, NodeIndex guide) {
        Link<Plane::acceleration> link;
        link.vector = centripetal_about(board_.place(mechanism_.joints[at(joint)].arc), guide, slider);
        if (board_.is_zero(link.vector)) return std::nullopt;
        link.term.symbol = relative<Plane::acceleration>(slider, guide, "n");
        link.role = DrawnVector::Role::normal;
        link.seen = sliding<Plane::acceleration>(joint, slider, guide);
        return link;
    }

    /// −ω_r² · CX where X, seen from the base, turns about a centre C at the place of which `base` moves as the base does.
    VectorOn<Plane::acceleration> centripetal_about(PointOn<Plane::drawing> centre, NodeIndex base, NodeIndex index) {
        const auto radius = board_.vector(centre, node(index).place);
        const ScalarHandle turning = board_.ratio(sliding_velocity(index, base), board_.turn(radius));
        return board_.negate(board_.scale<Plane::acceleration>(board_.product(turning, turning), radius));
    }

    template <Plane plane>
    void remember_tangential(Track<plane>& track, const Locus& locus, const Chain<plane>& drawn, PointOn<plane> met) {
        if (locus.kind == Locus::Kind::rotation && locus.carries.empty())
            track.tangential[{locus.base, locus.node}] = board_.vector(drawn.end, met);
    }

    template <Plane plane>
    void draw_chain(const Track<plane>& track, const Chain<plane>& drawn, PointOn<plane> met, BodyIndex colour) {
        PointOn<plane> here = drawn.start;
        for (const Link<plane>& link : drawn.known) {
            const PointOn<plane> next = set_off(drawn, link, here);
            const bool backwards = is_backwards(drawn.inverse, link.shift);
            draw_vector(track, link.term.symbol, link.seen, backwards ? next : here, backwards ? here : next,
                        link.term.body < 0 ? colour : link.term.body, link.role);
            here = next;
        }
        const BodyIndex sought_colour = drawn.sought.body < 0 ? colour : drawn.sought.body;
        if (drawn.inverse) {
            draw_vector(track, drawn.sought.symbol, drawn.seen, met, drawn.end, sought_colour, drawn.role);
        } else {
            draw_vector(track, drawn.sought.symbol, drawn.seen, drawn.end, met, sought_colour, drawn.role);
        }
    }

    /// The equation that the two chains close, written without minus signs: terms of an inverse chain change sides.
    template <Plane plane>
    Equation equation(NodeIndex sought, const Chain<plane>& first, const Chain<plane>& second) const {
        if (second.from_rest && !first.from_rest) return equation(sought, second, first);
        std::vector<Term> left, right;
        const auto write = [&](const Chain<plane>& drawn, std::vector<Term>& own, std::vector<Term>& other) {
            if (drawn.base >= 0 && !at_rest(drawn.base)) {
                own.push_back(
                    {absolute<plane>(drawn.base), true, true, {LineReason::Kind::known, {}, {}}, colour_of(drawn.base)});
            }
            for (const Link<plane>& link : drawn.known)
                (is_backwards(drawn.inverse, link.shift) ? other : own).push_back(link.term);
            (drawn.inverse ? other : own).push_back(drawn.sought);
        };
        write(first, left, right);
        write(second, right, left);
        Equation result;
        if (!first.from_rest && !second.from_rest && !first.inverse && !second.inverse) {
            Term whole;
            whole.symbol = absolute<plane>(sought);
            whole.direction_known = false;
            whole.body = colour_of(sought);
            result.sides.push_back({whole});
        }
        if (second.inverse) std::swap(left, right);
        result.sides.push_back(std::move(left));
        result.sides.push_back(std::move(right));
        return result;
    }

    Structure& structure_;
    Board& board_;
    const Plan& plan_;
    const Mechanism& mechanism_;
    Motion motion_;
    std::map<BodyIndex, ScalarHandle> squares_;
    Hand hand_ = Hand::solution;
    bool drivers_rest_ = false;
    const Step* moved_ = nullptr;
    Statement unsaid_;
    std::set<JointIndex> introduced_;  ///< higher pairs whose sentence was said
};

}  // namespace

std::string relative_name(const std::string& of, const std::string& to) {
    return is_short(of) && is_short(to) ? of + to : of + "," + to;
}

LineReason along_guide(const Mechanism& mechanism, JointIndex index, bool perpendicular) {
    const Joint& joint = mechanism.joints[at(index)];
    if (joint.along) {
        if (const auto* between = std::get_if<Bearing::Between>(&joint.along->form)) {
            const auto& name = [&](PointIndex point) { return mechanism.points[at(point)].name; };
            return {perpendicular ? LineReason::Kind::perpendicular_to_segment : LineReason::Kind::parallel_to_segment,
                    name(between->from), name(between->to)};
        }
    }
    return {perpendicular ? LineReason::Kind::perpendicular_to_guide : LineReason::Kind::parallel_to_guide, joint.name, {}};
}

Motion draw_motion(Structure& structure, Board& board, const Plan& plan, bool with_accelerations) {
    return Recipes(structure, board, plan).run(with_accelerations);
}

Track<Plane::velocity> draw_response(Structure& structure, Board& board, const Plan& plan, std::size_t assumed) {
    return Recipes(structure, board, plan).response(assumed);
}

bool is_broken(Structure& structure, Board& board, const Track<Plane::velocity>& response, const Closing& condition) {
    return Recipes(structure, board, {}).is_broken(response, condition);
}

}  // namespace kinegraph
