#include "constructions/statics/free_bodies/intermediate_constructions.hpp"

#include <algorithm>
#include <utility>

namespace kinegraph::statics {

std::vector<const Sum*> IntermediateConstructions::add_to(MemberIndex member, const Run& run, FreeBody& body) {
    const Group alone{member};
    // Under the loads of one body alone couples are added to resultants; no sentence there moves a single force.
    if (bears_load(member) && under_.first == none) {
        for (const Sum& moved : model_.moved())
            if (moved.group == alone) body.sums.push_back(applied_sum(moved));
        for (const Arm& shift : model_.shifts())
            if (shift.member == member) add_arm(shift, body);
    }
    std::vector<const Sum*> leading;
    for (const Sum& sum : run.sums)
        if (sum.group == alone) {
            body.sums.push_back(applied_sum(sum));
            leading.push_back(&sum);
        }
    for (const Arm& arm : run.arms)
        if (arm.member == member) add_arm(arm, body);
    for (const Funicular& drawn : run.funiculars)
        if (drawn.group == alone) body.funicular = funicular(drawn);
    return leading;
}

void IntermediateConstructions::list_meets(MemberIndex member, FreeBody& body) const {
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

FreeBody::Arm IntermediateConstructions::arm_about(PlaceOnDrawing about, Force force, PlaceOnDrawing place,
                                                   StatementIndex statement, bool is_sought) {
    FreeBody::Arm arm;
    const ScalarHandle moment = board_.moment(board_.vector(about, place), force);
    arm.name = point_at(about);
    arm.statement = statement;
    arm.is_sought = is_sought;
    arm.elements.about = about.element;
    arm.elements.foot = board_.carry(about, board_.arm(moment, force)).element;
    return arm;
}

std::string IntermediateConstructions::point_at(PlaceOnDrawing place) {
    for (const PointIndex point : indices_of(mechanism_.points))
        if (board_.coincide(board_.place(point), place)) return mechanism_.point(point).name;
    return "";
}

AppliedForce IntermediateConstructions::applied_sum(const Sum& sum) {
    AppliedForce applied;
    applied.symbol = sum.symbol;
    applied.kind = Quantity::Kind::resultant;
    applied.elements.force = sum.force.element;
    applied.elements.at = sum.place.element;
    applied.line_by_construction = true;
    applied.line_statement = applied.force_statement = sum.statement;
    return applied;
}

FreeBody::Funicular IntermediateConstructions::funicular(const Funicular& drawn) {
    FreeBody::Funicular found;
    found.statement = drawn.statement;
    found.first = drawn.first;
    found.second = drawn.second;
    found.known = drawn.known;
    for (const Corner& corner : drawn.corners) found.corners.push_back(Recorded<Vector>::at(corner.element));
    for (const PlaceOnDrawing& place : drawn.vertices) found.vertices.push_back(Recorded<Vector>::at(place.element));
    found.pole = Recorded<Vector>::at(drawn.pole.element);
    found.dividing = Recorded<Vector>::at(drawn.dividing.element);
    if (drawn.resultant) found.resultant = Recorded<Vector>::at(drawn.resultant->element);
    return found;
}

std::ptrdiff_t IntermediateConstructions::rank_in(const std::vector<const Sum*>& leading, const Side& side) {
    const auto has_it = [&](const Sum* sum) {
        return side.bond < 0 || std::find(sum->bonds.begin(), sum->bonds.end(), side.bond) != sum->bonds.end();
    };
    return std::find_if(leading.begin(), leading.end(), has_it) - leading.begin();
}

std::ptrdiff_t IntermediateConstructions::rank_in(const FreeBody::Funicular& funicular, const Symbol& symbol) {
    Symbols order = funicular.known;
    order.push_back(funicular.first);
    order.push_back(funicular.second);
    // The known forces were one resultant: they come first.
    const auto found = std::find(order.begin(), order.end(), symbol);
    return found == order.end() ? -1 : found - order.begin();
}

void IntermediateConstructions::put_in_order(std::vector<Side>& sides, const std::vector<const Sum*>& leading) {
    sort_round(sides);
    if (leading.empty()) return;
    std::stable_sort(sides.begin(), sides.end(),
                     [&](const Side& a, const Side& b) { return rank_in(leading, a) < rank_in(leading, b); });
}

void IntermediateConstructions::put_in_order(std::vector<Side>& sides, const FreeBody::Funicular& funicular) {
    std::stable_sort(sides.begin(), sides.end(), [&](const Side& a, const Side& b) {
        return rank_in(funicular, a.symbol) < rank_in(funicular, b.symbol);
    });
}

FreeBody IntermediateConstructions::empty_body(MemberIndex member) const {
    FreeBody body;
    if (model_.is_pin(member)) {
        body.pin = model_.pin_point(member);
    } else {
        body.body = model_.body_of(member);
    }
    return body;
}

AppliedForce IntermediateConstructions::applied_load(const Load& load) {
    AppliedForce applied;
    applied.symbol = load.symbol;
    applied.kind = load.kind;
    applied.given = load.given;
    applied.elements.at = load.place.element;
    if (load.couple) applied.elements.couple = load.couple->element;
    if (load.force) applied.elements.force = load.force->element;
    return applied;
}

bool IntermediateConstructions::bears_load(MemberIndex member) const {
    return std::any_of(under_.loads->begin(), under_.loads->end(),
                       [&](const Load& load) { return load.member == member; });
}

void IntermediateConstructions::add_arm(const Arm& arm, FreeBody& body) {
    if (board_.on_line(arm.about, board_.through(arm.place, board_.direction(arm.force)))) return;
    FreeBody::Arm drawn = arm_about(arm.about, arm.force, arm.place, arm.statement, false);
    drawn.is_shift = arm.is_shift;
    body.arms.push_back(std::move(drawn));
}

void IntermediateConstructions::sort_round(std::vector<Side>& sides) {
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
