#include "constructions/motion.hpp"

#include <algorithm>
#include <cctype>
#include <set>

#include "constructions/chains.hpp"
#include "constructions/polygon_pen.hpp"
#include "constructions/trial_size.hpp"
#include "engine/assert.hpp"

namespace kinegraph {
namespace {

std::size_t at(auto index) { return at_index(index); }

/// A name that is one letter with digits reads well beside another such: BA, O2A.
bool is_short(const std::string& name) {
    const auto digit = [](char c) { return c == '*' || std::isdigit(static_cast<unsigned char>(c)) != 0; };
    return !name.empty() && std::isalpha(static_cast<unsigned char>(name[0])) != 0 &&
           std::all_of(name.begin() + 1, name.end(), digit);
}

class Recipes : private Chains {
public:
    Recipes(Structure& structure, Board& board, const Plan& plan) : Chains(structure, board), plan_(plan) {}

    Motion run(bool with_accelerations) {
        draw(motion_.velocity, "velocity");
        motion_.velocities_settled = board_.strokes();
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
        return !board_.is_zero(missed) && !board_.parallel(board_.direction(missed), diagram_.direction(*condition.locus));
    }

private:
    /// Who draws: the solution itself, one of the two trials of an assumption, or a trial within a trial, which leaves no mark.
    enum class Hand { solution, first_trial, second_trial, silent };

    BodyName body(BodyIndex index) const { return {structure_.body_name(index)}; }

    template <Plane plane>
    Symbol spin_of(BodyIndex index) const {
        return spin_symbol<plane>(structure_.body_name(index));
    }
    template <Plane plane>
    Symbol image(NodeIndex index) const {
        return image_symbol<plane>(node(index).label);
    }

    template <Plane plane>
    StatementIndex begin(Sentence sentence, std::vector<Argument> arguments, std::string source) {
        if (hand_ != Hand::solution) return none;
        return state<plane>(board_, sentence, std::move(arguments), std::move(source));
    }
    /// A sentence that ends with the ω or α of a body.
    template <Plane plane>
    void begin_spin(BodyIndex found, Sentence sentence, std::vector<Argument> arguments, std::string source) {
        const StatementIndex statement = begin<plane>(sentence, std::move(arguments), std::move(source));
        if (found != none) said(statement).finds = {spin_quantity<plane>(found)};
    }
    /// The sentence begun, to complete it; in a trial nothing is said, and what is written here is forgotten.
    Statement& said(StatementIndex statement) { return statement == none ? unsaid_ : board_.statement(statement); }
    int trial() const { return hand_ == Hand::first_trial ? 1 : hand_ == Hand::second_trial ? 2 : 0; }

    // --- drawing -----------------------------------------------------------------------------------------------------------
    template <Plane plane>
    PolygonPen<plane> pen(const Track<plane>& track) {
        return {board_, track.polygon, trial()};
    }
    template <Plane plane>
    void draw_vector(const Track<plane>& track, Symbol symbol, const Seen& seen, PointOn<plane> tail, PointOn<plane> tip,
                     BodyIndex body_of, DrawnVector::Role role) {
        if (!is_velocity<plane> && hand_ == Hand::solution) relative_.insert({seen.of.place, seen.to.place});
        if (hand_ != Hand::silent) pen(track).vector(std::move(symbol), seen, tail, tip, body_of, role);
    }

    /// Whether the acceleration of one place relative to the other is drawn.
    bool drawn_between(NodeIndex one, NodeIndex other) {
        const ElementIndex a = place(one).element, b = place(other).element;
        return relative_.contains({a, b}) || relative_.contains({b, a});
    }

    template <Plane plane>
    void draw_line(const Track<plane>& track, LineOn<plane> line, LineReason reason, std::vector<ElementIndex> points) {
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
        track.spins[at(frame)] = board_.number(0);
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

    /// Where a joint is, for readers: its point stands in the drawing, its own name does not.
    PointName place_of(const Joint& joint) const {
        return {joint.point != none ? mechanism_.points[at(joint.point)].name : joint.name};
    }

    /// A sleeve or a weld lets no relative rotation: ω_i = ω_j, always, so α_i = α_j too.
    template <Plane plane>
    void spin_by_joint(Track<plane>& track, const Step& step) {
        if (!track.turns(step.other)) return;
        const Joint& joint = mechanism_.joints[at(step.joint)];
        if (joint.pair().is_sleeve() && joint.bodies[1] == frame)
            begin_spin<plane>(step.body, either<plane>(Sentence::omega_by_fixed_guide, Sentence::alpha_by_fixed_guide),
                              {spin_of<plane>(step.body), body(step.body), place_of(joint)}, "");
        else
            begin_spin<plane>(step.body,
                              joint.pair().is_sleeve() ? either<plane>(Sentence::omega_by_sleeve, Sentence::alpha_by_sleeve)
                                                       : either<plane>(Sentence::omega_by_joint, Sentence::alpha_by_joint),
                              {spin_of<plane>(step.body), spin_of<plane>(step.other), place_of(joint)}, "");
        track.spins[at(step.body)] = track.spin(step.other);
    }

    template <Plane plane>
    void spin_by_driver(Track<plane>& track, const Step& step) {
        if (!track.turns(step.other)) return;
        if (step.other != frame) {
            begin_spin<plane>(step.body, either<plane>(Sentence::omega_by_driver, Sentence::alpha_by_driver),
                              {spin_of<plane>(step.body), spin_of<plane>(step.other)}, "");
        }
        const ScalarHandle given = driven<plane>(step.driver);
        ScalarHandle& spin = track.spins[at(step.body)].emplace(given);
        if (step.other != frame)
            spin = step.inverse ? board_.difference(track.spin(step.other), given) : board_.sum(track.spin(step.other), given);
        if (step.other == frame && step.inverse) spin = board_.opposite(given);
    }

    /// v_X = v_X* + ṡ u;  a_X = a_X* + 2 ω_j ∧ v_rel + s̈ u (Coriolis), the slide being driven.
    template <Plane plane>
    void slide_by_driver(Track<plane>& track, const Step& step) {
        if (!track.has(step.base)) return;
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
        slide.vector = board_.scale<plane>(driven<plane>(step.driver), board_.guide_unit(step.joint));
        slide.term.symbol = relative<plane>(slider, guide, is_velocity<plane> ? "" : "rel");
        slide.role = DrawnVector::Role::sliding;
        slide.seen = sliding<plane>(step.joint, slider, guide, guide_body);
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
        const PointName base{node(step.base).label}, point{node(step.node).label};
        const Symbol omega = spin_of<Plane::velocity>(step.body);
        std::vector<Argument> arguments{body(step.body), base, point, absolute<plane>(step.node), omega};
        if (!rest) arguments = {point, body(step.body), absolute<plane>(step.node), base, omega};
        if (!is_velocity<plane>) arguments.emplace_back(spin_of<plane>(step.body));
        const StatementIndex statement =
            begin<plane>(rest ? either<plane>(Sentence::crank_velocity, Sentence::crank_acceleration)
                              : either<plane>(Sentence::image_velocity, Sentence::image_acceleration),
                         std::move(arguments), "Rivals");
        const auto join = diagram_.join(step.base, step.node);
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
            } else if (node(step.node).bodies.size() > 1 && !drawn_between(step.node, step.base)) {
                // A pin from which others go on: its parts are worth a reading.
                const Seen seen = turning(step.node, step.base);
                draw_vector(track, relative<plane>(step.node, step.base, "n"), seen, tip, middle, step.body,
                            DrawnVector::Role::normal);
                draw_vector(track, relative<plane>(step.node, step.base, "t"), seen, middle, end, step.body,
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
                            (locus.kind == Locus::Kind::slot && mechanism_.joints[at(locus.joint)].pair().touches());
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
                draw_vector(track, normal, {carried(step.node), carried(step.base), none}, from, tip, colour_of(step.node),
                            DrawnVector::Role::normal);
            set_tip(track, step.node, tip, true);
        }
    }

    /// Two circles curve apart where their centres are on different sides of the contact.
    RollingLever rolling_lever(const Joint& joint) {
        std::vector<VectorOn<Plane::drawing>> radii;
        for (const BodyIndex each : joint.bodies)
            if (const auto* circle = std::get_if<CircleProfile>(&joint.profiles.at(each)))
                radii.push_back(board_.vector(board_.place(joint.point), board_.place(circle->centre)));
        if (radii.size() < 2) return RollingLever::on_straight;
        return board_.along_sign(board_.direction(radii[0]), radii[1]) < 0 ? RollingLever::outside : RollingLever::inside;
    }

    /// Where the file asks that the motion be found through an observer, what the meet that follows is for him.
    template <Plane plane>
    void say_observer(const Step& step) {
        if (hand_ != Hand::solution) return;
        for (const RelativeMotionQuery& query : mechanism_.find.relative_motion) {
            if (!query.solves) continue;
            for (const Locus* locus : {&step.first, &step.second}) {
                if (!is_seen_from(structure_, query.observer, query.point, *locus)) continue;
                const auto& carriers = node(locus->node).bodies;
                const bool is_place = std::find(carriers.begin(), carriers.end(), query.observer) != carriers.end();
                const NodeIndex point = is_place ? locus->base : locus->node, place = is_place ? locus->node : locus->base;
                std::vector<Argument> arguments{PointName{mechanism_.point(query.point).name}, body(query.observer),
                                                absolute<plane>(point), absolute<plane>(place),
                                                relative<plane>(point, place, is_velocity<plane> ? "" : "rel")};
                if constexpr (!is_velocity<plane>) {
                    const ScalarHandle omega = motion_.velocity.spin(query.observer);
                    const auto seen = board_.vector(motion_.velocity.tip(place), motion_.velocity.tip(point));
                    if (!board_.is_zero(omega) && !board_.is_zero(seen))
                        arguments.emplace_back(relative<plane>(point, place, "cor"));
                }
                begin<plane>(either<plane>(Sentence::observer_velocity, Sentence::observer_acceleration), std::move(arguments),
                             is_velocity<plane> ? "" : "Coriolis");
                return;
            }
        }
    }

    /// Two loci meet in the tip sought: the dyad's vector equation, closed.
    template <Plane plane>
    void draw_meet(Track<plane>& track, const Step& step) {
        if (!ready(track, step.first) || !ready(track, step.second)) return;
        say_observer<plane>(step);
        const StatementIndex statement =
            begin<plane>(either<plane>(Sentence::two_lines_velocity, Sentence::two_lines_acceleration), {}, "");
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
        const char* const term = is_velocity<plane> ? "" : "t";
        // The vector is called as it was drawn, be it from the other end.
        const bool from_node = track.tangential.contains({step.node, step.base});
        Symbol relative_symbol = at_rest(step.base)   ? absolute<plane>(step.node, term)
                                 : at_rest(step.node) ? absolute<plane>(step.base, term)
                                 : from_node          ? relative<plane>(step.base, step.node, term)
                                                      : relative<plane>(step.node, step.base, term);
        begin_spin<plane>(step.body, either<plane>(Sentence::omega_from_pair, Sentence::alpha_from_pair),
                          {spin_of<plane>(step.body), relative_symbol, segment(step.base, step.node), body(step.body)}, "Rivals");
        const auto turned = board_.turn(diagram_.join(step.base, step.node));
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
        const StatementIndex statement = begin<plane>(Sentence::auxiliary_point, {}, "Assur");
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
                lines[i] = board_.through(ends[i], diagram_.direction(*loci[i]));
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
        begin_spin<plane>(step.body, either<plane>(Sentence::omega_from_parallels, Sentence::alpha_from_parallels),
                          {spin_of<plane>(step.body), segment(step.first.holds(), step.second.holds()), body(step.body)},
                          "Rivals");
        const Chain<plane> first = chain(track, step.first);
        const Chain<plane> second = chain(track, step.second);
        draw_line(track, first.line, first.reason, {first.end.element});
        draw_line(track, second.line, second.reason, {second.end.element});
        // From a place of the first locus, the line ⟂ to the join (the direction of the difference sought) meets the second.
        const auto join = diagram_.join(step.first.holds(), step.second.holds());
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
        return board_.difference(relative, driven<plane>(closing.driver));
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
        if (step.node != none && !ready(track, step.first)) return;
        if (!step.closing.found()) return set_assumed(track, step, assumed_of(track, step), &step == moved_ ? 1 : 0);
        begin<plane>(step.node != none ? Sentence::trial_on_line : Sentence::trial_of_spin, assumption_arguments<plane>(step),
                     "");
        const Assumed<plane> assumed = assumed_of(track, step);
        VectorOn<plane> missed[2];
        ScalarHandle mismatch[2];
        std::optional<PointOn<plane>> ends[2];
        std::optional<Chain<plane>> loci[2];
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
                loci[i] = chain(drawn, *step.closing.locus);
            } else {
                mismatch[i] = mismatch_of_spins(drawn, step.closing);
            }
        }
        hand_ = hand;
        begin_spin<plane>(step.node != none ? none : step.body,
                          step.closing.locus ? Sentence::trial_closes_on_line : Sentence::trial_closes_by_spin,
                          closing_arguments<plane>(step), "");
        const ScalarHandle share = step.closing.locus ? share_by_line(missed, diagram_.direction(*step.closing.locus))
                                                      : board_.quotient(mismatch[0], board_.difference(mismatch[0], mismatch[1]));
        if (ends[0] && !board_.coincide(*ends[0], *ends[1])) {
            draw_line_of_ends(track, *ends[0], *ends[1]);
        }
        if (hand_ == Hand::solution && step.closing.locus)
            for (const int i : {0, 1})
                PolygonPen<plane>(board_, track.polygon, i + 1).miss(loci[i]->end, loci[i]->line, *ends[i]);
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
        if (step.node == none) {
            assumed.spins[0] = board_.number(0);
            assumed.spins[1] = board_.number(1);
            return assumed;
        }
        assumed.line = chain(track, step.first);
        assumed.tips[0] = assumed.line->end;
        assumed.tips[1] = board_.carry(assumed.line->end, reach(track, diagram_.direction(step.first)));
        return assumed;
    }

    template <Plane plane>
    void set_assumed(Track<plane>& track, const Step& step, const Assumed<plane>& assumed, int which) {
        if (step.node == none) {
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
        if (step.node == none) {
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

    /// How far along a direction the second trial is set off: free to choose, so about as long as the longest vector drawn yet,
    /// in one figure.
    template <Plane plane>
    VectorOn<plane> reach(const Track<plane>& track, DirectionHandle direction) {
        const auto times = [&](const Exact& power) { return board_.scale<plane>(board_.number(power), direction); };
        std::optional<VectorOn<plane>> longest;
        for (const auto& tip : track.tips) {
            if (!tip) continue;
            const auto vector = board_.vector(board_.pole<plane>(), *tip);
            if (!longest || board_.choose_longer(vector, *longest)) longest = vector;
        }
        if (!longest || board_.is_zero(*longest)) return times(1);
        return times(power_of_ten_reaching(board_, *longest, times));
    }

    template <Plane plane>
    std::vector<Argument> assumption_arguments(const Step& step) {
        if (step.node == none) return {spin_of<plane>(step.body)};
        return {image<plane>(step.node), reason_of(step.first)};
    }

    template <Plane plane>
    std::vector<Argument> closing_arguments(const Step& step) {
        const Symbol assumed = step.node != none ? image<plane>(step.node) : spin_of<plane>(step.body);
        if (!step.closing.locus) return {spin_of<plane>(step.closing.body), spin_of<plane>(step.closing.other), assumed};
        return {image<plane>(step.closing.locus->node), reason_of(*step.closing.locus), assumed, closing_error(1),
                closing_error(2)};
    }

    // --- loci --------------------------------------------------------------------------------------------------------------

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
                        link.term.body == none ? colour : link.term.body, link.role);
            here = next;
        }
        const BodyIndex sought_colour = drawn.sought.body == none ? colour : drawn.sought.body;
        if (drawn.inverse) {
            draw_vector(track, drawn.sought.symbol, drawn.seen, met, drawn.end, sought_colour, drawn.role);
        } else {
            draw_vector(track, drawn.sought.symbol, drawn.seen, drawn.end, met, sought_colour, drawn.role);
        }
    }

    const Plan& plan_;
    Hand hand_ = Hand::solution;
    const Step* moved_ = nullptr;
    Statement unsaid_;
    std::set<std::pair<ElementIndex, ElementIndex>> relative_;  ///< places between which accelerations are drawn
    std::set<JointIndex> introduced_;                           ///< higher pairs whose sentence was said
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
    const JointName guide = reader_name(mechanism, joint);
    return {perpendicular ? LineReason::Kind::perpendicular_to_guide : LineReason::Kind::parallel_to_guide,
            guide.name,
            {},
            guide.own};
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
