#include "constructions/statics/free_bodies/unsupported_resultants.hpp"

#include <string>
#include <utility>

#include "engine/number/assert.hpp"
#include "lang/keys/sentences.hpp"

namespace kinegraph::statics {

void UnsupportedResultants::resultant(const Unsupported& loose) {
    const Group& group = loose.group;
    std::vector<const Load*> loads;
    for (const Load& load : model_.loads())
        if (in(group, load.member)) loads.push_back(&load);
    if (loads.empty()) return;
    const auto origin = board_.pole<drawing>();
    std::optional<Force> sum;
    std::optional<ScalarHandle> turn;
    const auto turn_by = [&](ScalarHandle moment) { turn = turn ? board_.sum(*turn, moment) : moment; };
    for (const Load* load : loads) {
        if (load->force) {
            sum = sum ? board_.add(*sum, *load->force) : *load->force;
            turn_by(board_.moment(board_.vector(origin, load->place), *load->force));
        }
        if (load->couple) turn_by(*load->couple);
    }
    const std::optional<Force> force = unless_zero(sum);
    const std::optional<ScalarHandle> couple = unless_zero(turn);
    Resultant result;
    for (const MemberIndex member : group)
        if (!model_.is_pin(member)) result.bodies.push_back(model_.body_of(member));
    result.force = recorded(force);
    result.couple = recorded(couple);
    result.vanishes = !force && !couple;
    if (force) {
        const PlaceOnDrawing foot = couple ? board_.carry(origin, board_.arm(*couple, *force)) : origin;
        result.through = Recorded<Vector>::at(foot.element);
    }
    // The freedom of a body on the frame is unbalanced, whatever the sum.
    const bool is_free = !loose.balanced && (loose.centre || loose.along);
    if (force && is_free) find_residual(loose, *force, loads, result);
    say_resultant(result, force, couple);
    if (!loose.balanced) {
        unbalanced_.insert(group.begin(), group.end());
        cut_unbalanced(group, loads, result, force, couple);
        if (force && loose.centre && group.size() == 1) turn_by_resultant(result, *loose.centre, *force);
    }
    results_.resultants.push_back(std::move(result));
}

void UnsupportedResultants::find_residual(const Unsupported& loose, Force force, const std::vector<const Load*>& loads,
                                          Resultant& result) {
    if (loose.centre) {
        std::optional<ScalarHandle> turn;
        const auto turn_by = [&](ScalarHandle moment) { turn = turn ? board_.sum(*turn, moment) : moment; };
        for (const Load* load : loads) {
            if (load->force) turn_by(board_.moment(board_.vector(*loose.centre, load->place), *load->force));
            if (load->couple) turn_by(*load->couple);
        }
        result.about = Recorded<Vector>::at(loose.centre->element);
        result.residual_couple = recorded(turn);
        return;
    }
    const Force unit = board_.scale<Plane::force>(board_.number(1), *loose.along);
    const auto start = board_.pole<Plane::force>();
    const auto foot =
        board_.meet(board_.through(start, *loose.along),
                    board_.through(board_.carry(start, force), board_.perpendicular(board_.direction(unit))));
    KG_ASSERT(foot, "a line meets one across it");
    result.residual_force = recorded(std::optional<Force>(board_.vector(start, *foot)));
}

void UnsupportedResultants::turn_by_resultant(const Resultant& result, PlaceOnDrawing centre, Force force) {
    FreeBody& body = results_.bodies.back();
    const AppliedForce& applied = body.forces.back();
    const PlaceOnDrawing place{applied.elements.at};
    if (board_.on_line(centre, board_.through(place, board_.direction(force)))) return;
    body.arms.push_back(constructions_.arm_about(centre, force, place, result.statement, true));
}

Symbol UnsupportedResultants::resultant_symbol(bool is_force) {
    return {is_force ? Symbol::Letter::F : Symbol::Letter::M, is_force ? "F_R" : "M_R", {}};
}

void UnsupportedResultants::say_resultant(Resultant& result, const std::optional<Force>& force,
                                          const std::optional<ScalarHandle>& couple) {
    std::string names;
    for (const BodyIndex body : result.bodies) names += (names.empty() ? "" : " + ") + mechanism_.body(body).name;
    const BodyName about{names, result.bodies.size() > 1 ? BodyName::As::bodies : BodyName::As::body};
    Statement statement;
    statement.section = Topic::forces;
    statement.bodies = result.bodies;
    statement.message = {lang::sentences::in_equilibrium, {about}};
    const Symbol resultant = resultant_symbol(true);
    if (result.residual_couple) {
        const std::string centre = constructions_.point_at({result.about.element()});
        statement.message = {lang::sentences::residual_couple,
                             {about, resultant, PointName{centre}, Symbol{Symbol::Letter::M, centre, {}}}};
        statement.finds.push_back({.kind = Quantity::Kind::resultant, .body = result.bodies.front()});
    } else if (result.residual_force) {
        Symbol along = resultant;
        along.term = "t";
        statement.message = {lang::sentences::residual_force, {about, resultant, along}};
        statement.finds.push_back({.kind = Quantity::Kind::resultant, .body = result.bodies.front()});
    } else if (force || couple) {
        statement.message.sentence = force ? lang::sentences::resultant_force : lang::sentences::resultant_couple;
        statement.message.arguments.emplace_back(resultant_symbol(force.has_value()));
        statement.finds.push_back({.kind = Quantity::Kind::resultant, .body = result.bodies.front()});
    }
    result.statement = board_.state(std::move(statement));
}

void UnsupportedResultants::cut_unbalanced(const Group& group, const std::vector<const Load*>& loads, Resultant& result,
                                           const std::optional<Force>& force,
                                           const std::optional<ScalarHandle>& couple) {
    const bool alone = group.size() == 1;
    std::vector<Side> sides;
    for (const MemberIndex member : group) {
        FreeBody body = constructions_.empty_body(member);
        body.statement = result.statement;
        for (const Load* load : loads) {
            if (load->member != member) continue;
            AppliedForce applied = constructions_.applied_load(*load);
            if (load->force) sides.push_back({applied.symbol, *load->force, -1, true, quantity_of(body, applied)});
            body.forces.push_back(std::move(applied));
        }
        if (alone) body.forces.push_back(applied_resultant(*loads.front(), result.statement, force, couple));
        if (!body.forces.empty()) results_.bodies.push_back(std::move(body));
    }
    if (sides.empty()) return;
    const std::string id = (alone ? "forces-" : "resultant-") + model_.member_name(group.front());
    result.polygon = polygons_.add_force_polygon(alone ? Polygon::Kind::body_forces : Polygon::Kind::joined_forces, id);
    draw_open_polygon(result.polygon, group, sides, force);
    if (alone) results_.bodies.back().polygon = result.polygon;
}

AppliedForce UnsupportedResultants::applied_resultant(const Load& first, StatementIndex statement,
                                                      const std::optional<Force>& force,
                                                      const std::optional<ScalarHandle>& couple) {
    AppliedForce applied;
    applied.kind = Quantity::Kind::resultant;
    applied.symbol = resultant_symbol(force.has_value());
    applied.line_statement = applied.force_statement = statement;
    applied.line_by_construction = force.has_value();
    applied.elements.at = first.place.element;
    if (!force) {
        applied.elements.couple = couple->element;
        return applied;
    }
    applied.elements.force = force->element;
    const ScalarHandle there = board_.moment(board_.vector(first.place, board_.pole<drawing>()), *force);
    const ScalarHandle about = couple ? board_.sum(*couple, there) : there;
    if (!board_.is_zero(about)) applied.elements.at = board_.carry(first.place, board_.arm(about, *force)).element;
    return applied;
}

void UnsupportedResultants::draw_open_polygon(int polygon, const Group& group, const std::vector<Side>& sides,
                                              const std::optional<Force>& force) {
    const Corner start = board_.pole<Plane::force>();
    Face face;
    face.body = model_.body_of(group.front());
    const Corner here = polygons_.set_off(polygon, group.front(), sides, start, face);
    if (force) {
        const Quantity quantity{.kind = Quantity::Kind::resultant, .body = face.body};
        polygons_.draw_side(polygon, {resultant_symbol(true), *force, -1, true, quantity}, group.front(), start,
                            board_.carry(start, *force));
        face.corners.push_back(here.element);
    }
    // A separate face for each body would suggest that each polygon closes.
    if (group.size() > 1) face.corners = {start.element, here.element};
    board_.add_face(polygon, face);
    if (group.size() > 1) board_.add_face(polygon, std::move(face));
}

}  // namespace kinegraph::statics
