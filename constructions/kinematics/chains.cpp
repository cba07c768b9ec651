#include "constructions/kinematics/chains.hpp"

#include <algorithm>

#include "engine/number/assert.hpp"

namespace kinegraph {
namespace {}  // namespace

bool Chains::rolls_known(JointIndex index) const {
    const Joint& joint = mechanism_.joints[at_index(index)];
    const auto& before = motion_.velocity;
    return before.turns(joint.bodies[0]) && before.turns(joint.bodies[1]) && structure_.has_curvatures(index);
}

VectorOn<Plane::acceleration> Chains::rolling_offset(JointIndex index, BodyIndex body_of) {
    const Joint& joint = mechanism_.joints[at_index(index)];
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
        lever = board_.scale<Plane::drawing>(
            board_.ratio(board_.vector(contact, *others), board_.vector(*own, *others)), lever);
    const ScalarHandle turning = board_.difference(motion_.velocity.spin(body_of), motion_.velocity.spin(other));
    return board_.scale<Plane::acceleration>(board_.product(turning, turning), lever);
}

LineReason Chains::reason_of(const Locus& locus) const {
    switch (locus.kind) {
        case Locus::Kind::rotation:
        case Locus::Kind::link:
            return {LineReason::Kind::perpendicular_to_segment, node(locus.base).label, node(locus.node).label};
        case Locus::Kind::image:
            return {LineReason::Kind::parallel_to_segment, node(locus.base).label, node(locus.node).label};
        case Locus::Kind::component: return component_reason(locus);
        case Locus::Kind::sleeve:
        case Locus::Kind::slot:
        case Locus::Kind::tangent:
        case Locus::Kind::mesh: return line_reason(locus);
        case Locus::Kind::driven_slide: return along_guide(mechanism_, locus.joint, true);
        case Locus::Kind::roll: return {LineReason::Kind::known, {}, {}};
    }
    return {};
}

template <Plane plane>
bool Chains::ready(const Track<plane>& track, const Locus& locus) const {
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
        if ((slides || locus.kind == Kind::link) && (!has_velocity(locus.node) || !has_velocity(locus.base)))
            return false;
    }
    return true;
}

template <Plane plane>
Chain<plane> Chains::chain(Track<plane>& track, const Locus& locus) {
    Chain<plane> result;
    switch (locus.kind) {
        case Locus::Kind::rotation:
        case Locus::Kind::link: start_rotation(track, locus, result); break;
        case Locus::Kind::sleeve:
        case Locus::Kind::slot:
        case Locus::Kind::tangent:
        case Locus::Kind::mesh: start_slide(track, locus, result); break;
        case Locus::Kind::component: start_component(track, locus, result); break;
        case Locus::Kind::image: start_image(track, locus, result); break;
        case Locus::Kind::driven_slide: start_driven_slide(track, locus, result); break;
        case Locus::Kind::roll: start_roll(track, locus, result); break;
    }
    result.end = result.start;
    for (const Carry& carry : locus.carries) shift(track, carry, result);
    for (const Link<plane>& link : result.known) result.end = set_off(result, link, result.end);
    result.line = board_.through(result.end, diagram_.direction(locus));
    return result;
}

template <Plane plane>
void Chains::start_rotation(const Track<plane>& track, const Locus& locus, Chain<plane>& result) {
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
        normal.vector = locus.kind == Locus::Kind::link ? centripetal_about(place(locus.base), locus.base, locus.node)
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

template <Plane plane>
void Chains::start_slide(const Track<plane>& track, const Locus& locus, Chain<plane>& result) {
    const Joint& joint = mechanism_.joints[at_index(locus.joint)];
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
            // If the base is the slider, at rest, the terms change sides: they belong to the guide's place.
            if (result.from_rest && locus.inverse) link->vector = board_.negate(link->vector);
            link->term = {symbol(link->term.symbol.term), true, true, reason, colour};
            result.known.push_back(*link);
        };
        if (locus.kind != Locus::Kind::mesh) add(coriolis_of(locus.guide, slider, guide), normal);
        if (joint.arc != none) add(centripetal_of(locus.joint, slider, guide, locus.guide), normal);
    }
    result.absolute = result.from_rest && result.known.empty();
    if (result.absolute) result.role = DrawnVector::Role::absolute;
    result.seen = result.absolute ? seen(locus.node) : sliding<plane>(locus.joint, slider, guide, locus.guide);
    const bool plain = is_velocity<plane> || result.absolute;
    const char* term = locus.kind == Locus::Kind::mesh ? "n" : "rel";
    result.sought = {symbol(plain ? "" : term), false, true, result.reason, colour};
}

LineReason Chains::line_reason(const Locus& locus) const {
    const Joint& joint = mechanism_.joints[at_index(locus.joint)];
    const std::string& place = mechanism_.points[at_index(joint.point)].name;
    if (locus.kind == Locus::Kind::mesh) return {LineReason::Kind::parallel_to_normal, place, {}};
    if (joint.pair().touches()) return {LineReason::Kind::parallel_to_tangent, place, {}};
    return along_guide(mechanism_, locus.joint, false);
}

LineReason Chains::normal_reason(const Locus& locus) const {
    const Joint& joint = mechanism_.joints[at_index(locus.joint)];
    if (joint.pair().touches())
        return {LineReason::Kind::parallel_to_normal, mechanism_.points[at_index(joint.point)].name, {}};
    return along_guide(mechanism_, locus.joint, true);
}

LineReason Chains::component_reason(const Locus& locus) const {
    const auto& driver = std::get<PointDriver>(mechanism_.drivers[at_index(locus.driver)]);
    return {LineReason::Kind::driver_component, node(locus.node).label, number_of_drive(driver, mechanism_)};
}

template <Plane plane>
void Chains::start_component(const Track<plane>&, const Locus& locus, Chain<plane>& result) {
    result.start = board_.pole<plane>();
    result.from_rest = true;
    result.reason = component_reason(locus);
    const std::string which = result.reason.to;
    Link<plane> component;
    component.vector = board_.scale<plane>(driven<plane>(locus.driver), board_.driver_unit(locus.driver));
    component.term = {
        absolute<plane>(locus.node, "∥" + which), true, true, {LineReason::Kind::known, {}, {}}, locus.body};
    result.known.push_back(component);
    result.sought = {absolute<plane>(locus.node, "⟂" + which), false, true, result.reason, locus.body};
}

template <Plane plane>
void Chains::start_image(const Track<plane>& track, const Locus& locus, Chain<plane>& result) {
    const auto join = diagram_.join(locus.base, locus.node);
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

template <Plane plane>
void Chains::start_driven_slide(const Track<plane>& track, const Locus& locus, Chain<plane>& result) {
    result.base = locus.base;
    result.start = track.tip(locus.base);
    result.reason = along_guide(mechanism_, locus.joint, true);
    Link<plane> slide;
    slide.vector = board_.scale<plane>(driven<plane>(locus.driver), board_.guide_unit(locus.joint));
    result.known.push_back(slide);
    if constexpr (!is_velocity<plane>) {
        if (const auto coriolis = coriolis_of(locus.guide, locus.node, locus.base)) result.known.push_back(*coriolis);
    }
}

template <Plane plane>
void Chains::start_roll(const Track<plane>& track, const Locus& locus, Chain<plane>& result) {
    result.base = locus.base;
    result.start = track.tip(locus.base);
    if constexpr (!is_velocity<plane>) {
        Link<plane> offset;
        offset.vector = rolling_offset(locus.joint, locus.body);
        result.known.push_back(offset);
    }
}

template <Plane plane>
void Chains::shift(const Track<plane>& track, const Carry& carry, Chain<plane>& result) {
    const auto add = [&](VectorOn<plane> vector, const std::string& term, LineReason reason, DrawnVector::Role role) {
        Link<plane> link;
        link.vector = vector;
        link.role = role;
        link.shift = true;
        link.term = {relative<plane>(carry.to, carry.from, term), true, true, std::move(reason), carry.body};
        link.seen = carry.kind == Carry::Kind::roll ? Seen{carried(carry.to), carried(carry.from), none}
                                                    : turning(carry.to, carry.from);
        if (!board_.is_zero(vector)) result.known.push_back(link);
    };
    result.absolute = false;
    result.from_rest = false;
    if (carry.kind == Carry::Kind::roll) {
        if constexpr (!is_velocity<plane>) {
            add(rolling_offset(carry.joint, carry.body), "n",
                {LineReason::Kind::parallel_to_normal, mechanism_.joints[at_index(carry.joint)].name, {}},
                DrawnVector::Role::normal);
        }
        return;
    }
    const auto join = diagram_.join(carry.from, carry.to);
    const LineReason across{LineReason::Kind::perpendicular_to_segment, node(carry.from).label, node(carry.to).label};
    const LineReason along{LineReason::Kind::parallel_to_segment, node(carry.from).label, node(carry.to).label};
    if constexpr (!is_velocity<plane>)
        add(normal_of(carry.body, carry.from, carry.to), "n", along, DrawnVector::Role::normal);
    add(board_.scale<plane>(track.spin(carry.body), board_.turn(join)), is_velocity<plane> ? "" : "t", across,
        DrawnVector::Role::tangential);
}

VectorOn<Plane::acceleration> Chains::normal_of(BodyIndex turning, NodeIndex from, NodeIndex to) {
    auto [entry, fresh] = squares_.try_emplace(turning);
    if (fresh) {
        const ScalarHandle omega = motion_.velocity.spin(turning);
        entry->second = board_.product(omega, omega);
    }
    return board_.scale<Plane::acceleration>(entry->second, diagram_.join(to, from));
}

PointOn<Plane::velocity> Chains::velocity_tip(NodeIndex index) {
    Track<Plane::velocity>& track = motion_.velocity;
    if (track.has(index)) return track.tip(index);
    for (const BodyIndex carrier : node(index).bodies) {
        if (!track.turns(carrier)) continue;
        for (const NodeIndex base : structure_.nodes_of(carrier)) {
            if (!track.has(base)) continue;
            const auto join = diagram_.join(base, index);
            const auto tip =
                board_.carry(track.tip(base), board_.scale<Plane::velocity>(track.spin(carrier), board_.turn(join)));
            track.tips[at_index(index)] = tip;
            return tip;
        }
    }
    KG_ASSERT(false, "asked for the velocity of a body that is not known");
}

bool Chains::has_velocity(NodeIndex index) const {
    const Track<Plane::velocity>& track = motion_.velocity;
    if (track.has(index)) return true;
    return std::any_of(node(index).bodies.begin(), node(index).bodies.end(), [&](BodyIndex carrier) {
        const auto& nodes = structure_.nodes_of(carrier);
        return track.turns(carrier) &&
               std::any_of(nodes.begin(), nodes.end(), [&](NodeIndex base) { return track.has(base); });
    });
}

VectorOn<Plane::velocity> Chains::sliding_velocity(NodeIndex slider, NodeIndex guide) {
    const auto from = velocity_tip(guide);
    return board_.vector(from, velocity_tip(slider));
}

std::optional<Link<Plane::acceleration>> Chains::coriolis_of(BodyIndex guide_body, NodeIndex slider, NodeIndex guide) {
    const ScalarHandle omega = motion_.velocity.spin(guide_body);
    if (guide_body == frame || board_.is_zero(omega)) return std::nullopt;
    Link<Plane::acceleration> link;
    link.vector = board_.scale<Plane::acceleration>(board_.product(board_.number(2), omega),
                                                    board_.turn(sliding_velocity(slider, guide)));
    if (board_.is_zero(link.vector)) return std::nullopt;
    link.term.symbol = relative<Plane::acceleration>(slider, guide, "cor");
    link.role = DrawnVector::Role::coriolis;
    link.seen = {carried(slider), carried(guide, guide_body), none};
    return link;
}

std::optional<Link<Plane::acceleration>> Chains::centripetal_of(JointIndex joint, NodeIndex slider, NodeIndex guide,
                                                                BodyIndex guide_body) {
    Link<Plane::acceleration> link;
    link.vector = centripetal_about(board_.place(mechanism_.joints[at_index(joint)].arc), guide, slider);
    if (board_.is_zero(link.vector)) return std::nullopt;
    link.term.symbol = relative<Plane::acceleration>(slider, guide, "n");
    link.role = DrawnVector::Role::normal;
    link.seen = sliding<Plane::acceleration>(joint, slider, guide, guide_body);
    return link;
}

VectorOn<Plane::acceleration> Chains::centripetal_about(PointOn<Plane::drawing> centre, NodeIndex base,
                                                        NodeIndex index) {
    const auto radius = board_.vector(centre, place(index));
    const ScalarHandle turning = board_.ratio(sliding_velocity(index, base), board_.turn(radius));
    return board_.negate(board_.scale<Plane::acceleration>(board_.product(turning, turning), radius));
}

template <Plane plane>
Equation Chains::equation(NodeIndex sought, const Chain<plane>& first, const Chain<plane>& second) const {
    if (second.from_rest && !first.from_rest) return equation(sought, second, first);
    std::vector<Term> left, right;
    const auto write = [&](const Chain<plane>& drawn, std::vector<Term>& own, std::vector<Term>& other) {
        if (drawn.base != none && !at_rest(drawn.base)) {
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

template bool Chains::ready(const Track<Plane::velocity>& track, const Locus& locus) const;
template bool Chains::ready(const Track<Plane::acceleration>& track, const Locus& locus) const;
template Chain<Plane::velocity> Chains::chain(Track<Plane::velocity>& track, const Locus& locus);
template Chain<Plane::acceleration> Chains::chain(Track<Plane::acceleration>& track, const Locus& locus);
template Equation Chains::equation(NodeIndex sought, const Chain<Plane::velocity>& first,
                                   const Chain<Plane::velocity>& second) const;
template Equation Chains::equation(NodeIndex sought, const Chain<Plane::acceleration>& first,
                                   const Chain<Plane::acceleration>& second) const;

}  // namespace kinegraph
