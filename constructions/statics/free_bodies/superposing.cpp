#include "constructions/statics/free_bodies/superposing.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace kinegraph::statics {

std::optional<Superposition> Superposing::superpose(const Run& run) {
    Superposition found;
    found.statement = run.summed;
    for (const PartRun& part : run.parts) {
        auto cut = cut_part(part);
        if (!cut) return std::nullopt;
        found.parts.push_back(*std::move(cut));
    }
    for (std::size_t b = 0; b < model_.bonds().size(); ++b) sum_parts(b, run, found);
    for (const MemberIndex member : model_.moving_members()) join_parts(member, run, found);
    return found;
}

std::optional<Superposition::Part> Superposing::cut_part(const PartRun& part) {
    const UnderLoads under{&part.loads, model_.member_name(part.loaded), part.first, part.end};
    if (!ForceDeterminacy(model_, board_, mechanism_, mobility_, under).out_of_equilibrium(part.run).empty())
        return std::nullopt;
    ForceResults results;
    ForcePolygons polygons(model_, board_);
    IntermediateConstructions constructions(model_, board_, mechanism_, meets_, under);
    CutBodies alone(model_, board_, polygons, constructions, under, true, results);
    alone.draw_bodies(part.run, {});
    alone.cut_together(part.run);
    Superposition::Part cut;
    cut.body = model_.body_of(part.loaded);
    if (model_.is_pin(part.loaded)) cut.pin = model_.pin_point(part.loaded);
    cut.first = part.first;
    cut.end = part.end;
    cut.bodies = std::move(results.bodies);
    cut.together = std::move(results.together);
    return cut;
}

void Superposing::sum_parts(std::size_t b, const Run& run, Superposition& found) {
    const Bond& bond = model_.bonds()[b];
    const bool reversed = bond.first == member_of(frame);
    const MemberIndex on = reversed ? bond.second : bond.first;
    const Symbol symbol = reversed ? bond.reverse : bond.symbol;
    const auto turned = [&](Force force) { return reversed ? board_.negate(force) : force; };
    const auto turned_couple = [&](ScalarHandle couple) { return reversed ? board_.opposite(couple) : couple; };
    std::vector<Side> sides;
    Superposition::CoupleSum couples{symbol, {}, {}};
    couples.symbol.letter = Symbol::Letter::M;
    for (const PartRun& part : run.parts) {
        const Reaction& reaction = part.run.reactions[b];
        if (reaction.force)
            sides.push_back({marked(symbol, model_.member_name(part.loaded)), turned(*reaction.force),
                             static_cast<int>(b), true, model_.quantity_at(b, !reversed)});
        if (reaction.couple) couples.parts.push_back(recorded(turned_couple(*reaction.couple)));
    }
    const Reaction& total = run.reactions[b];
    if (couples.parts.size() > 1) {
        couples.total = total.couple ? recorded(turned_couple(*total.couple)) : Recorded<Exact>::zero();
        found.couples.push_back(std::move(couples));
    }
    if (sides.size() < 2) return;
    const int polygon = polygons_.add_force_polygon(Polygon::Kind::body_forces, "sum-" + name_of(symbol));
    const Corner start = board_.pole<Plane::force>();
    Face face;
    const Corner here = polygons_.set_off(polygon, on, sides, start, face);
    if (total.force)
        polygons_.draw_side(polygon,
                            {symbol, turned(*total.force), static_cast<int>(b), true, model_.quantity_at(b, !reversed)},
                            on, start, here);
    face.corners.push_back(here.element);
    board_.add_face(polygon, std::move(face));
    found.sums.push_back({symbol, model_.body_of(on), polygon});
}

std::vector<Side> Superposing::parts_on(MemberIndex member, int b, const Run& run) {
    const Bond& bond = model_.bonds()[at(b)];
    const bool reversed = bond.second == member;
    const Symbol& symbol = reversed ? bond.reverse : bond.symbol;
    std::vector<Side> sides;
    for (const bool own : {true, false})
        for (const PartRun& part : run.parts) {
            const Reaction& reaction = part.run.reactions[at(b)];
            if (!reaction.force || (part.loaded == member) != own) continue;
            sides.push_back({marked(symbol, model_.member_name(part.loaded)),
                             reversed ? board_.negate(*reaction.force) : *reaction.force, b, true,
                             model_.quantity_at(at(b), !reversed)});
        }
    return sides;
}

/// The parts that the other loads cause stand inside, next to the corner between two reactions: in the last reaction
/// they come first. So the polygon of the own loads is seen by itself, and what the others add is seen at its corner.
void Superposing::join_parts(MemberIndex member, const Run& run, Superposition& found) {
    FreeBody on;
    on.body = model_.body_of(member);
    if (model_.is_pin(member)) on.pin = model_.pin_point(member);
    std::vector<Side> loads;
    for (const Load& load : model_.loads())
        if (load.member == member && load.force)
            loads.push_back(
                {load.symbol, *load.force, -1, true, quantity_of(on, IntermediateConstructions::applied_load(load))});
    std::vector<std::pair<int, std::vector<Side>>> reactions;
    for (const int b : model_.bonds_of(member))
        if (std::vector<Side> parts = parts_on(member, b, run); !parts.empty())
            reactions.emplace_back(b, std::move(parts));
    constexpr std::size_t fewest = 3;  // two equal and opposite forces have no polygon
    if (reactions.empty() || loads.size() + reactions.size() < fewest) return;
    std::reverse(reactions.back().second.begin(), reactions.back().second.end());
    const int polygon = polygons_.add_force_polygon(Polygon::Kind::body_forces, "parts-" + model_.member_name(member));
    Face outline;
    outline.body = on.body;
    Corner here = polygons_.set_off(polygon, member, loads, board_.pole<Plane::force>(), outline);
    for (const auto& [b, parts] : reactions) {
        const Corner start = here;
        Face between;  // its corners are not those of the whole polygon
        here = polygons_.set_off(polygon, member, parts, start, between);
        const Bond& bond = model_.bonds()[at(b)];
        const bool reversed = bond.second == member;
        if (const auto& total = run.reactions[at(b)].force)
            polygons_.draw_side(polygon,
                                {reversed ? bond.reverse : bond.symbol, reversed ? board_.negate(*total) : *total, b,
                                 true, model_.quantity_at(at(b), !reversed)},
                                member, start, here);
        outline.corners.push_back(start.element);
    }
    board_.add_face(polygon, std::move(outline));
    found.joined.push_back({on.body, on.pin, polygon});
}

}  // namespace kinegraph::statics
