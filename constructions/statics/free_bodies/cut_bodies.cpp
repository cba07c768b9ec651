#include "constructions/statics/free_bodies/cut_bodies.hpp"

#include <algorithm>
#include <optional>
#include <string>

namespace kinegraph::statics {

void CutBodies::draw_bodies(const Run& run, const std::set<MemberIndex>& unbalanced) {
    Group order;
    for (const Resolved& resolved : run.order) order.push_back(resolved.member);
    for (const MemberIndex member : model_.moving_members()) {
        if (!in(order, member)) order.push_back(member);
    }
    for (const MemberIndex member : order)
        if (unbalanced.count(member) == 0 && (is_whole(member, run) || in(run.redundant, member)))
            free_body(member, run);
}

bool CutBodies::is_whole(MemberIndex member, const Run& run) const {
    const auto& bonds = model_.bonds_of(member);
    return std::all_of(bonds.begin(), bonds.end(), [&](int b) { return run.reactions[at(b)].known; });
}

void CutBodies::cut_together(const Run& run) {
    for (const TakenTogether& taken : run.taken_together) {
        const std::vector<int> outer = model_.outer_bonds(taken.group);
        if (!std::all_of(outer.begin(), outer.end(), [&](int b) { return run.reactions[at(b)].known; })) continue;
        const Funicular* funicular = funicular_of(taken, run);
        // The plan of a truss contains the closed polygon, but not the rays or Culmann's diagonal.
        if (!one_by_one_ && funicular == nullptr && !has_diagonal(taken, run)) continue;
        std::vector<std::pair<MemberIndex, Side>> sides;
        for (const Load& load : *under_.loads)
            if (load.force && in(taken.group, load.member) && !ForceModel::is_inner(load, taken.group, *under_.loads))
                sides.push_back(
                    {load.member,
                     {load.symbol, *load.force, -1, true,
                      quantity_of(constructions_.empty_body(load.member), constructions_.applied_load(load))}});
        for (const bool sought : {false, true})
            for (const int b : outer) {
                const bool is_sought = std::find(taken.sought.begin(), taken.sought.end(), b) != taken.sought.end();
                const Reaction& reaction = run.reactions[at(b)];
                if (is_sought != sought || !reaction.force) continue;
                const Bond& bond = model_.bonds()[at(b)];
                const bool on_first = in(taken.group, bond.first);
                sides.push_back({on_first ? bond.first : bond.second,
                                 {marked(on_first ? bond.symbol : bond.reverse, under_.mark),
                                  on_first ? *reaction.force : board_.negate(*reaction.force),
                                  b,
                                  true,
                                  {}}});
            }
        if (sides.size() > 2) draw_together(taken, std::move(sides), funicular, run);
    }
}

void CutBodies::free_body(MemberIndex member, const Run& run) {
    CutBody cut{constructions_.empty_body(member), {}};
    FreeBody& body = cut.body;
    body.in_parts = run.in_parts;
    for (const Load& load : *under_.loads)
        if (load.member == member) apply(cut, constructions_.applied_load(load), load.force, -1);
    for (const int b : model_.bonds_of(member)) apply_reaction(cut, member, b, run.reactions[at(b)]);
    constructions_.list_meets(member, body);
    const std::vector<const Sum*> leading = constructions_.add_to(member, run, body);
    const bool whole = is_whole(member, run);
    if (!whole) body.statement = none;  // no single sentence closes it
    if (!cut.sides.empty() && whole) {
        constructions_.put_in_order(cut.sides, leading);
        if (body.funicular) constructions_.put_in_order(cut.sides, *body.funicular);
        body.polygon = polygons_.draw_polygon(member, cut.sides, under_.suffix());
        polygons_.keep(member, std::move(cut.sides));
    }
    if (!body.forces.empty()) results_.bodies.push_back(std::move(body));
}

void CutBodies::apply(CutBody& cut, AppliedForce applied, const std::optional<Force>& force, int bond) {
    if (force) {
        applied.elements.force = force->element;
        const bool external = bond < 0 || model_.bonds()[at(bond)].first == member_of(frame) ||
                              model_.bonds()[at(bond)].second == member_of(frame);
        cut.sides.push_back({applied.symbol, *force, bond, external, quantity_of(cut.body, applied)});
    }
    if (applied.elements.force != none || applied.elements.couple != none)
        cut.body.forces.push_back(std::move(applied));
}

void CutBodies::apply_reaction(CutBody& cut, MemberIndex member, int b, const Reaction& reaction) {
    const Bond& bond = model_.bonds()[at(b)];
    const bool reversed = bond.second == member;
    for (Symbol& symbol : ForceDeterminacy::open_symbols(bond, reaction, reversed))
        cut.body.open.push_back(std::move(symbol));
    if (!reaction.known && reaction.alike == Reaction::Alike::nothing && !reaction.couple_alike) return;
    AppliedForce applied = applied_reaction(bond, reaction, reversed);
    cut.body.statement = std::max(cut.body.statement, reaction.force_statement);
    std::optional<Force> force;
    if (reaction.force) force = reversed ? board_.negate(*reaction.force) : *reaction.force;
    if (reaction.couple) {
        const ScalarHandle couple = reversed ? board_.opposite(*reaction.couple) : *reaction.couple;
        // A force with a couple is equal to the force on an offset line, its real line. A component of a force has
        // none.
        if (force && reaction.known) {
            applied.elements.at = board_.carry(bond.place, board_.arm(couple, *force)).element;
        } else {
            applied.elements.couple = couple.element;
        }
    }
    apply(cut, std::move(applied), force, b);
}

AppliedForce CutBodies::applied_reaction(const Bond& bond, const Reaction& reaction, bool reversed) const {
    AppliedForce applied;
    applied.symbol = marked(reversed ? bond.reverse : bond.symbol, under_.mark);
    applied.is_component = !reaction.known;
    if (reaction.alike == Reaction::Alike::component && !reaction.known)
        applied.symbol.term += (applied.symbol.term.empty() ? "" : ",") + std::string(reaction.axis);
    applied.kind = bond.effort >= 0 ? Quantity::Kind::effort : Quantity::Kind::force;
    applied.joint = bond.joint;
    applied.given = bond.effort;
    if (bond.effort < 0) applied.line_statement = reaction.line_statement;
    applied.force_statement = reaction.force_statement;
    applied.from = model_.body_of(reversed ? bond.first : bond.second);
    applied.elements.at = bond.place.element;
    applied.line_by_construction = reaction.deduced;
    return applied;
}

bool CutBodies::has_diagonal(const TakenTogether& taken, const Run& run) {
    const auto is_sought = [&](int b) {
        return std::find(taken.sought.begin(), taken.sought.end(), b) != taken.sought.end();
    };
    return std::any_of(run.sums.begin(), run.sums.end(), [&](const Sum& sum) {
        return sum.group == taken.group && std::any_of(sum.bonds.begin(), sum.bonds.end(), is_sought);
    });
}

const Funicular* CutBodies::funicular_of(const TakenTogether& taken, const Run& run) {
    const auto found = std::find_if(run.funiculars.begin(), run.funiculars.end(), [&](const Funicular& funicular) {
        return funicular.group == taken.group && funicular.statement == taken.statement;
    });
    return found == run.funiculars.end() ? nullptr : &*found;
}

void CutBodies::draw_together(const TakenTogether& taken, std::vector<std::pair<MemberIndex, Side>> sides,
                              const Funicular* funicular, const Run& run) {
    kinegraph::TakenTogether together;
    together.statement = taken.statement;
    if (funicular != nullptr) {
        together.funicular = constructions_.funicular(*funicular);
        std::stable_sort(sides.begin(), sides.end(), [&](const auto& a, const auto& b) {
            return constructions_.rank_in(*together.funicular, a.second.symbol) <
                   constructions_.rank_in(*together.funicular, b.second.symbol);
        });
    }
    std::string id = one_by_one_ ? "forces" : "forces-truss";
    for (const MemberIndex member : taken.group)
        if (!model_.is_pin(member)) together.bodies.push_back(model_.body_of(member));
    // For one body and its pin it is not the body's own polygon.
    for (const MemberIndex member : taken.group)
        if (one_by_one_ && (!model_.is_pin(member) || together.bodies.size() < 2))
            id += "-" + model_.member_name(member);
    std::vector<const Sum*> leading;
    for (const Sum& sum : run.sums)
        if (sum.group == taken.group) {
            together.sums.push_back(constructions_.applied_sum(sum));
            leading.push_back(&sum);
        }
    if (funicular == nullptr)
        std::stable_sort(sides.begin(), sides.end(), [&](const auto& a, const auto& b) {
            return constructions_.rank_in(leading, a.second) < constructions_.rank_in(leading, b.second);
        });
    together.polygon = polygons_.add_force_polygon(Polygon::Kind::body_forces, id + under_.suffix());
    Face face;
    Corner here = board_.pole<Plane::force>();
    const Corner start = here;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const Corner next = i + 1 == sides.size() ? start : board_.carry(here, sides[i].second.force);
        polygons_.draw_side(together.polygon, sides[i].second, sides[i].first, here, next);
        face.corners.push_back(here.element);
        here = next;
    }
    board_.add_face(together.polygon, std::move(face));
    results_.together.push_back(std::move(together));
}

}  // namespace kinegraph::statics
