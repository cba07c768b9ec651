#include "constructions/statics/free_bodies/intermediate_constructions.hpp"

#include <algorithm>
#include <utility>

namespace kinegraph::statics {

std::vector<const Added*> Way::add_way(MemberIndex member, const Run& run, FreeBody& body) {
    const Group alone{member};
    if (bears_load(member)) {
        for (const Added& moved : model_.moved())
            if (moved.group == alone) body.sums.push_back(applied_sum(moved));
        for (const Lever& shift : model_.shifts())
            if (shift.member == member) add_lever(shift, body);
    }
    std::vector<const Added*> leading;
    for (const Added& added : run.added)
        if (added.group == alone) {
            body.sums.push_back(applied_sum(added));
            leading.push_back(&added);
        }
    for (const Lever& lever : run.levers)
        if (lever.member == member) add_lever(lever, body);
    for (const Strings& strings : run.strings)
        if (strings.group == alone) body.funicular = funicular(strings);
    return leading;
}

void Way::list_meets(MemberIndex member, FreeBody& body) const {
    const auto meets = meets_.find(member);
    if (meets == meets_.end()) return;
    for (const NamedMeet& meet : meets->second) {
        const bool listed =
            std::any_of(body.meets.begin(), body.meets.end(), [&](const auto& m) { return m.name == meet.name; });
        const bool alone = under_.first != none;  // selects these loads by the sentences about them
        if (listed || (alone && (meet.used < under_.first || !(meet.used < under_.end)))) continue;
        body.meets.push_back({meet.name, {}, alone ? meet.used : meet.statement, meet.place.element});
    }
}

FreeBody::Arm Way::arm_about(PlaceOnDrawing about, Force force, PlaceOnDrawing place, StatementIndex statement,
                             bool is_sought) {
    FreeBody::Arm arm;
    const ScalarHandle moment = board_.moment(board_.vector(about, place), force);
    arm.name = point_at(about);
    arm.statement = statement;
    arm.is_sought = is_sought;
    arm.elements.about = about.element;
    arm.elements.foot = board_.carry(about, board_.arm(moment, force)).element;
    return arm;
}

std::string Way::point_at(PlaceOnDrawing place) {
    for (const PointIndex point : indices_of(mechanism_.points))
        if (board_.coincide(board_.place(point), place)) return mechanism_.point(point).name;
    return "";
}

AppliedForce Way::applied_sum(const Added& added) {
    AppliedForce applied;
    applied.symbol = added.symbol;
    applied.kind = Quantity::Kind::resultant;
    applied.elements.force = added.force.element;
    applied.elements.at = added.place.element;
    applied.line_by_construction = true;
    applied.line_statement = applied.force_statement = added.statement;
    return applied;
}

FreeBody::Funicular Way::funicular(const Strings& strings) {
    FreeBody::Funicular found;
    found.statement = strings.statement;
    found.first = strings.first;
    found.second = strings.second;
    found.known = strings.known;
    for (const Corner& corner : strings.corners) found.corners.push_back(Recorded<Vector>::at(corner.element));
    for (const PlaceOnDrawing& place : strings.vertices) found.vertices.push_back(Recorded<Vector>::at(place.element));
    found.pole = Recorded<Vector>::at(strings.pole.element);
    found.dividing = Recorded<Vector>::at(strings.dividing.element);
    if (strings.resultant) found.resultant = Recorded<Vector>::at(strings.resultant->element);
    return found;
}

std::ptrdiff_t Way::rank_in(const std::vector<const Added*>& leading, const Side& side) {
    const auto has_it = [&](const Added* added) {
        return side.bond < 0 || std::find(added->bonds.begin(), added->bonds.end(), side.bond) != added->bonds.end();
    };
    return std::find_if(leading.begin(), leading.end(), has_it) - leading.begin();
}

std::ptrdiff_t Way::rank_in(const FreeBody::Funicular& funicular, const Symbol& symbol) {
    Symbols order = funicular.known;
    order.push_back(funicular.first);
    order.push_back(funicular.second);
    // The known forces were one resultant: they come first.
    const auto found = std::find(order.begin(), order.end(), symbol);
    return found == order.end() ? -1 : found - order.begin();
}

void Way::put_in_order(std::vector<Side>& sides, const std::vector<const Added*>& leading) {
    sort_round(sides);
    if (leading.empty()) return;
    std::stable_sort(sides.begin(), sides.end(),
                     [&](const Side& a, const Side& b) { return rank_in(leading, a) < rank_in(leading, b); });
}

void Way::put_in_order(std::vector<Side>& sides, const FreeBody::Funicular& funicular) {
    std::stable_sort(sides.begin(), sides.end(), [&](const Side& a, const Side& b) {
        return rank_in(funicular, a.symbol) < rank_in(funicular, b.symbol);
    });
}

FreeBody Way::empty_body(MemberIndex member) const {
    FreeBody body;
    if (model_.is_pin(member)) {
        body.pin = model_.pin_point(member);
    } else {
        body.body = model_.body_of(member);
    }
    return body;
}

AppliedForce Way::applied_load(const Load& load) {
    AppliedForce applied;
    applied.symbol = load.symbol;
    applied.kind = load.kind;
    applied.given = load.given;
    applied.elements.at = load.place.element;
    if (load.couple) applied.elements.couple = load.couple->element;
    if (load.force) applied.elements.force = load.force->element;
    return applied;
}

bool Way::bears_load(MemberIndex member) const {
    return std::any_of(under_.loads->begin(), under_.loads->end(),
                       [&](const Load& load) { return load.member == member; });
}

void Way::add_lever(const Lever& lever, FreeBody& body) {
    if (board_.on_line(lever.about, board_.through(lever.place, board_.direction(lever.force)))) return;
    FreeBody::Arm arm = arm_about(lever.about, lever.force, lever.place, lever.statement, false);
    arm.is_shift = lever.is_shift;
    body.arms.push_back(std::move(arm));
}

void Way::sort_round(std::vector<Side>& sides) {
    const Force first = sides.front().force;
    const auto half = [&](Force v) {
        const int turned = board_.choose_turn(first, v);
        return turned > 0 || (turned == 0 && board_.choose_along(first, v) > 0) ? 0 : 1;
    };
    std::stable_sort(sides.begin(), sides.end(), [&](const Side& a, const Side& b) {
        if (half(a.force) != half(b.force)) return half(a.force) < half(b.force);
        return board_.choose_turn(a.force, b.force) > 0;
    });
}

}  // namespace kinegraph::statics
