#include "constructions/statics/free_bodies/superposing.hpp"

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
    for (std::size_t b = 0; b < model_.joint_bonds(); ++b) sum_parts(b, run, found);
    return found;
}

std::optional<Superposition::Part> Superposing::cut_part(const PartRun& part) {
    const UnderLoads under{&part.loads, model_.member_name(part.loaded), part.first, part.end};
    if (!Verdict(model_, board_, mechanism_, mobility_, under).out_of_equilibrium(part.run).empty())
        return std::nullopt;
    ForceResults results;
    ForcePolygons polygons(model_, board_);
    Way way(model_, board_, mechanism_, meets_, under);
    CutBodies alone(model_, board_, polygons, way, under, true, results);
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

}  // namespace kinegraph::statics
