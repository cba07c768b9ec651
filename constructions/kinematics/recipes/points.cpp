#include "constructions/kinematics/recipes/points.hpp"

#include <algorithm>
#include <utility>
#include <variant>
#include <vector>

#include "engine/number/assert.hpp"
#include "lang/keys/sentences.hpp"

namespace kinegraph::recipes {

template <Plane plane>
void PointRecipes<plane>::slide_by_driver(Track<plane>& track, const Step& step) {
    if (!track.has(step.base)) return;
    const BodyIndex guide_body = step.inverse ? step.body : step.other;
    if (!is_velocity<plane> && !chains_.motion().velocity.turns(guide_body)) return;
    pen_.begin<plane>(either<plane>(lang::sentences::driven_point_velocity, lang::sentences::driven_point_acceleration),
                      {chains_.absolute<plane>(step.node),
                       reader_name(chains_.mechanism(), chains_.mechanism().joints[at(step.joint)])},
                      is_velocity<plane> ? "" : "Coriolis");
    const NodeIndex slider = step.inverse ? step.base : step.node, guide = step.inverse ? step.node : step.base;
    PointOn<plane> tip = track.tip(step.base);
    std::vector<Link<plane>> links;
    if constexpr (!is_velocity<plane>) {
        if (const auto coriolis = chains_.coriolis_of(guide_body, slider, guide)) links.push_back(*coriolis);
    }
    Link<plane> slide;
    slide.vector = board_.scale<plane>(chains_.driven<plane>(step.driver), board_.guide_unit(step.joint));
    slide.term.symbol = chains_.relative<plane>(slider, guide, is_velocity<plane> ? "" : "rel");
    slide.role = DrawnVector::Role::sliding;
    slide.seen = chains_.sliding<plane>(step.joint, slider, guide, guide_body);
    links.push_back(slide);
    const bool show_parts = !chains_.at_rest(step.base);
    for (const Link<plane>& link : links) {
        const PointOn<plane> next = board_.carry(tip, step.inverse ? board_.negate(link.vector) : link.vector);
        if (show_parts) {
            if (step.inverse) {
                pen_.draw_vector(track, link.term.symbol, link.seen, next, tip, chains_.colour_of(slider), link.role);
            } else {
                pen_.draw_vector(track, link.term.symbol, link.seen, tip, next, chains_.colour_of(slider), link.role);
            }
        }
        tip = next;
    }
    pen_.set_tip(track, step.node, tip, true);
}

template <Plane plane>
bool PointRecipes<plane>::begins_image(const Track<plane>& track, const Step& step) const {
    const std::vector<NodeIndex>& own = chains_.structure().nodes_of(step.body);
    return std::none_of(own.begin(), own.end(), [&](NodeIndex each) { return each != step.base && track.has(each); });
}

template <Plane plane>
void PointRecipes<plane>::draw_image(Track<plane>& track, const Step& step) {
    if (!track.has(step.base) || !track.turns(step.body)) return;
    const bool rest = chains_.at_rest(step.base);
    const PointName base{chains_.node(step.base).label}, point{chains_.node(step.node).label};
    const Symbol omega = pen_.spin_of<Plane::velocity>(step.body);
    std::vector<Argument> arguments{pen_.body(step.body), base, point, chains_.absolute<plane>(step.node), omega};
    if (!rest) arguments = {point, pen_.body(step.body), chains_.absolute<plane>(step.node), base, omega};
    if (!is_velocity<plane>) arguments.emplace_back(pen_.spin_of<plane>(step.body));
    const StatementIndex statement =
        pen_.begin<plane>(rest ? either<plane>(lang::sentences::crank_velocity, lang::sentences::crank_acceleration)
                               : either<plane>(lang::sentences::image_velocity, lang::sentences::image_acceleration),
                          std::move(arguments), "Rivals");
    const auto join = chains_.diagram().join(step.base, step.node);
    PointOn<plane> tip = track.tip(step.base);
    if constexpr (is_velocity<plane>) {
        if (!rest && board_.is_zero(track.spin(step.body))) {
            pen_.said(statement).message = {
                lang::sentences::translating_velocity,
                {pen_.body(step.body), PointName{chains_.node(step.node).label}, chains_.absolute<plane>(step.node)}};
        } else {
            const auto turned = board_.scale<plane>(track.spin(step.body), board_.turn(join));
            const PointOn<plane> end = board_.carry(tip, turned);
            if (!rest && begins_image(track, step))
                pen_.draw_vector(track, chains_.relative<plane>(step.node, step.base),
                                 chains_.turning(step.node, step.base), tip, end, step.body,
                                 DrawnVector::Role::tangential);
            tip = end;
            track.tangential[{step.base, step.node}] = turned;
        }
    } else {
        const auto normal = chains_.normal_of(step.body, step.base, step.node);
        const auto tangential = board_.scale<plane>(track.spin(step.body), board_.turn(join));
        track.tangential[{step.base, step.node}] = tangential;
        const PointOn<plane> middle = board_.carry(tip, normal);
        const PointOn<plane> end = board_.carry(middle, tangential);
        if (rest) {  // a crank: its normal and tangential parts are the first vectors of the figure
            const Seen seen = chains_.turning(step.node, step.base);
            pen_.draw_vector(track, chains_.absolute<plane>(step.node, "n"), seen, tip, middle, step.body,
                             DrawnVector::Role::normal);
            if (!board_.is_zero(tangential))
                pen_.draw_vector(track, chains_.absolute<plane>(step.node, "t"), seen, middle, end, step.body,
                                 DrawnVector::Role::tangential);
        } else if (const bool is_pin = chains_.node(step.node).bodies.size() > 1;
                   (is_pin || begins_image(track, step)) && !pen_.drawn_between<plane>(step.node, step.base)) {
            // The parts are shown for a pin used by later steps, and for the body's first image.
            const Seen seen = chains_.turning(step.node, step.base);
            if (is_pin || !board_.is_zero(normal))
                pen_.draw_vector(track, chains_.relative<plane>(step.node, step.base, "n"), seen, tip, middle,
                                 step.body, DrawnVector::Role::normal);
            if (is_pin || !board_.is_zero(tangential))
                pen_.draw_vector(track, chains_.relative<plane>(step.node, step.base, "t"), seen, middle, end,
                                 step.body, DrawnVector::Role::tangential);
        }
        tip = end;
    }
    pen_.set_tip(track, step.node, tip, true);
}

template <Plane plane>
void PointRecipes<plane>::draw_rolling_point(Track<plane>& track, const Step& step) {
    if (!track.has(step.base)) return;
    const PointName contact{chains_.mechanism().points[at(chains_.mechanism().joints[at(step.joint)].point)].name};
    const bool rest = chains_.at_rest(step.base);
    if constexpr (is_velocity<plane>) {
        pen_.begin<plane>(rest ? lang::sentences::rolling_point_at_rest : lang::sentences::rolling_velocity,
                          {contact, pen_.body(step.body), pen_.body(step.other), chains_.absolute<plane>(step.node),
                           chains_.absolute<plane>(step.base)},
                          "");
        if (rest) pen_.remember_still(step.node);
        pen_.set_tip(track, step.node, track.tip(step.base), !rest);
    } else {
        if (!chains_.rolls_known(step.joint)) return;
        const Symbol normal =
            rest ? chains_.absolute<plane>(step.node) : chains_.relative<plane>(step.node, step.base, "n");
        pen_.begin<plane>(
            rest ? lang::sentences::rolling_point_on_rest_acceleration : lang::sentences::rolling_acceleration,
            {contact, pen_.body(step.body), pen_.body(step.other), chains_.absolute<plane>(step.node),
             chains_.absolute<plane>(step.base), normal, rolling_lever(chains_.mechanism().joints[at(step.joint)])},
            "Euler–Savary");
        const PointOn<plane> from = track.tip(step.base);
        const PointOn<plane> tip = board_.carry(from, chains_.rolling_offset(step.joint, step.body));
        if (!rest)
            pen_.draw_vector(track, normal, {chains_.carried(step.node), chains_.carried(step.base), none}, from, tip,
                             chains_.colour_of(step.node), DrawnVector::Role::normal);
        pen_.set_tip(track, step.node, tip, true);
    }
}

template <Plane plane>
void PointRecipes<plane>::draw_meet(Track<plane>& track, const Step& step) {
    if (!chains_.ready(track, step.first) || !chains_.ready(track, step.second)) return;
    say_observer(step);
    const StatementIndex statement = pen_.begin<plane>(
        either<plane>(lang::sentences::two_lines_velocity, lang::sentences::two_lines_acceleration), {}, "");
    const Chain<plane> first = chains_.chain(track, step.first);
    const Chain<plane> second = chains_.chain(track, step.second);
    const auto met = board_.meet(first.line, second.line);
    KG_ASSERT(met && !board_.is_at_infinity(*met), "the plan lets only lines meet that are not parallel");
    pen_.said(statement).message.arguments = {pen_.image<plane>(step.node), first.reason, second.reason};
    pen_.said(statement).equation = chains_.equation(step.node, first, second);
    const bool slides = step.first.kind != Locus::Kind::rotation || step.second.kind != Locus::Kind::rotation;
    pen_.said(statement).source = !is_velocity<plane> && slides ? "Coriolis" : "Rivals";
    bool absolute_drawn = false;
    for (const Chain<plane>* drawn : {&first, &second}) {
        pen_.draw_line(track, drawn->line, drawn->reason, {drawn->end.element, met->element});
        pen_.draw_chain(track, *drawn, *met, chains_.colour_of(step.node));
        absolute_drawn = absolute_drawn || drawn->absolute;
    }
    pen_.remember_tangential(track, step.first, first, *met);
    pen_.remember_tangential(track, step.second, second, *met);
    pen_.set_tip(track, step.node, *met, !absolute_drawn);
}

template <Plane plane>
void PointRecipes<plane>::draw_auxiliary(Track<plane>& track, const Step& step) {
    if (!chains_.ready(track, step.first) || !chains_.ready(track, step.second)) return;
    if (!is_velocity<plane> && !chains_.motion().velocity.turns(step.body)) return;
    const StatementIndex statement = pen_.begin<plane>(lang::sentences::auxiliary_point, {}, "Assur");
    LineOn<plane> lines[2];
    LineReason reasons[2];
    PointOn<plane> ends[2];
    const Locus* loci[2] = {&step.first, &step.second};
    for (int i = 0; i < 2; ++i) {
        const Chain<plane> drawn = chains_.chain(track, *loci[i]);
        lines[i] = drawn.line;
        ends[i] = drawn.end;
        reasons[i] = drawn.reason;
        if constexpr (!is_velocity<plane>) {
            ends[i] = board_.carry(drawn.end, chains_.normal_of(step.body, loci[i]->holds(), step.node));
            lines[i] = board_.through(ends[i], chains_.diagram().direction(*loci[i]));
        }
    }
    const auto met = board_.meet(lines[0], lines[1]);
    KG_ASSERT(met && !board_.is_at_infinity(*met), "the loci of an auxiliary point are not parallel");
    for (int i = 0; i < 2; ++i) pen_.draw_line(track, lines[i], reasons[i], {ends[i].element, met->element});
    pen_.said(statement).message.arguments = {Symbol{Symbol::Letter::point, chains_.node(step.node).label, {}},
                                              pen_.body(step.body), reasons[0], reasons[1]};
    pen_.set_tip(track, step.node, *met, true);
}

template <Plane plane>
RollingLever PointRecipes<plane>::rolling_lever(const Joint& joint) {
    std::vector<VectorOn<Plane::drawing>> radii;
    for (const BodyIndex each : joint.bodies)
        if (const auto* circle = std::get_if<CircleProfile>(&joint.profiles.at(each)))
            radii.push_back(board_.vector(board_.place(joint.point), board_.place(circle->centre)));
    if (radii.size() < 2) return RollingLever::on_straight;
    return board_.along_sign(board_.direction(radii[0]), radii[1]) < 0 ? RollingLever::outside : RollingLever::inside;
}

template <Plane plane>
void PointRecipes<plane>::say_observer(const Step& step) {
    if (pen_.hand() != RecipePen::Hand::solution) return;
    for (const RelativeMotionQuery& query : chains_.mechanism().find.relative_motion) {
        if (!query.solves) continue;
        for (const Locus* locus : {&step.first, &step.second}) {
            if (!is_seen_from(chains_.structure(), query.observer, query.point, *locus)) continue;
            const auto& carriers = chains_.node(locus->node).bodies;
            const bool is_place = std::find(carriers.begin(), carriers.end(), query.observer) != carriers.end();
            const NodeIndex point = is_place ? locus->base : locus->node, place = is_place ? locus->node : locus->base;
            std::vector<Argument> arguments{PointName{chains_.mechanism().point(query.point).name},
                                            pen_.body(query.observer), chains_.absolute<plane>(point),
                                            chains_.absolute<plane>(place),
                                            chains_.relative<plane>(point, place, is_velocity<plane> ? "" : "rel")};
            if constexpr (!is_velocity<plane>) {
                const ScalarHandle omega = chains_.motion().velocity.spin(query.observer);
                const auto seen =
                    board_.vector(chains_.motion().velocity.tip(place), chains_.motion().velocity.tip(point));
                if (!board_.is_zero(omega) && !board_.is_zero(seen))
                    arguments.emplace_back(chains_.relative<plane>(point, place, "cor"));
            }
            pen_.begin<plane>(either<plane>(lang::sentences::observer_velocity, lang::sentences::observer_acceleration),
                              std::move(arguments), is_velocity<plane> ? "" : "Coriolis");
            return;
        }
    }
}

template class PointRecipes<Plane::velocity>;
template class PointRecipes<Plane::acceleration>;

}  // namespace kinegraph::recipes
