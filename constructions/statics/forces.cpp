#include "constructions/statics/forces.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "constructions/statics/forces/runs.hpp"
#include "constructions/statics/free_bodies.hpp"
#include "constructions/statics/truss.hpp"
#include "constructions/statics/unsupported_bodies.hpp"
#include "lang/keys/sentences.hpp"

namespace kinegraph {
namespace statics {
namespace {

/// Bars that connect a truss to the frame, alone at an unloaded hinge; and rollers, with two forces only.
Group hung_bars(const ForceModel& model, Board& board, const TrussStructure& truss) {
    Group hung;
    for (const TrussStructure::Pin& pin : truss.pins) {
        if (pin.hinges.empty() || pin.bars.size() != 1) continue;
        const ElementIndex here = board.place(pin.point).element;
        const bool loaded = std::any_of(model.loads().begin(), model.loads().end(),
                                        [&](const Load& load) { return load.place.element == here; });
        if (!loaded) hung.push_back(member_of(truss.bars[at(pin.bars.front())].body));
    }
    for (const Bond& bond : model.bonds())
        if (bond.kind == Bond::Kind::guide) hung.push_back(bond.first == member_of(frame) ? bond.second : bond.first);
    return hung;
}

/// The resultant of the given forces on a truss, and where the lines of the reactions meet it.
std::optional<Truss::Whole> whole_of(ForceModel& model, const NamedMeets& meets, const Run& run) {
    Group all;
    for (const MemberIndex member : model.moving_members()) all.push_back(member);
    Run loads_alone;
    loads_alone.reactions.resize(run.reactions.size());
    const Wrench given = model.known_on(all, model.loads(), loads_alone);
    Truss::Whole whole;
    for (const Reaction& reaction : run.reactions)
        if (reaction.known) whole.statement = std::max(whole.statement, reaction.force_statement);
    if (whole.statement == none || !given.force) return std::nullopt;
    whole.force = Recorded<Vector>::at(given.force->element);
    whole.through = Recorded<Vector>::at(given.place.element);
    for (const auto& [member, named] : meets)
        for (const NamedMeet& meet : named) {
            const bool listed = std::any_of(whole.meets.begin(), whole.meets.end(),
                                            [&](const auto& each) { return each.name == meet.name; });
            if (!listed) whole.meets.push_back({meet.name, Recorded<Vector>::at(meet.place.element), meet.statement});
        }
    return whole;
}

/// The truss of a mechanism, if each of its bars has a length as drawn: only then it has a line, along which it pulls.
std::optional<TrussStructure> drawn_truss(Board& board, const Mechanism& mechanism) {
    auto truss = truss_of(mechanism);
    if (!truss) return std::nullopt;
    const auto place = [&](int pin) { return board.place(truss->pins[at(pin)].point); };
    for (const TrussStructure::Bar& bar : truss->bars)
        if (board.coincide(place(bar.pins[0]), place(bar.pins[1]))) return std::nullopt;
    return truss;
}

Determinacy determinacy_of(const Mechanism& mechanism, const Mobility& mobility) {
    const int efforts = static_cast<int>(mechanism.efforts.size());
    if (mobility.repeated() > 0 || efforts > mobility.effective) return Determinacy::redundant;
    return efforts < mobility.effective ? Determinacy::unbalanced : Determinacy::determinate;
}

/// The truss as one free body first, then pin by pin; if this does not give all forces, body by body.
ForceResults draw_truss(ForceModel& model, Board& board, const Mechanism& mechanism, const Mobility& mobility,
                        const TrussStructure& truss) {
    const Board::Mark before = board.mark();
    Statement opening;
    opening.section = Topic::forces;
    opening.message = {lang::sentences::truss_whole,
                       {Count{static_cast<int>(truss.bars.size())}, Count{static_cast<int>(truss.pins.size())}}};
    board.state(std::move(opening));
    Runs runs(model, board, mechanism, {}, Determinacy::determinate);
    std::map<MemberIndex, std::string> names;
    for (const TrussStructure::Bar& bar : truss.bars) names.emplace(member_of(bar.body), bar.name);
    const Run whole = runs.whole(hung_bars(model, board, truss), std::move(names));
    TrussDrawing drawing(model, board, mechanism, truss, whole);
    if (drawing.resolve()) {
        const Run run = drawing.run(whole);
        ForceResults results = cut_free(model, board, mechanism, mobility, run, runs.meets(), {}, false);
        results.truss = drawing.finish();
        results.truss->whole = whole_of(model, runs.meets(), whole);
        for (const Unsolved& missing : drawing.unsolved()) results.unsolved.push_back(missing);
        if (!drawing.has_plan()) results.remarks.push_back(drawing.why_no_plan());
        return results;
    }
    board.rewind(before);
    Runs one_by_one(model, board, mechanism, {}, determinacy_of(mechanism, mobility));
    const Run run = one_by_one.run();
    ForceResults results = cut_free(model, board, mechanism, mobility, run, one_by_one.meets(), {});
    if (!run.complete || !results.unsolved.empty()) return results;
    TrussDrawing bars(model, board, mechanism, truss, run);
    bars.read_off(run);
    results.truss = bars.finish();
    results.remarks.push_back({lang::sentences::truss_without_order, {Count{static_cast<int>(truss.bars.size())}}});
    return results;
}

}  // namespace
}  // namespace statics

ForceResults draw_forces(Structure& structure, Board& board, const Motion& motion, const Mobility& mobility) {
    const Mechanism& mechanism = structure.mechanism();
    if (mechanism.points.empty()) return {};
    statics::ForceModel model(structure, board, motion);
    if (!model.missing().empty()) {
        ForceResults results;
        results.unsolved = model.missing();
        return results;
    }
    const std::vector<statics::Unsupported> loose = statics::unsupported_bodies(model, board, mechanism, mobility);
    std::set<statics::MemberIndex> adrift;
    for (const statics::Unsupported& each : loose)
        if (!each.balanced) adrift.insert(each.group.begin(), each.group.end());
    if (const auto truss = statics::drawn_truss(board, mechanism))
        return statics::draw_truss(model, board, mechanism, mobility, *truss);
    // The forces show on which flank teeth push. If a flank was wrong, the drawing is rewound and repeated.
    const Board::Mark before = board.mark();
    for (std::size_t round = 0;; ++round) {
        statics::Runs runs(model, board, mechanism, adrift, statics::determinacy_of(mechanism, mobility));
        const statics::Run run = runs.run();
        const std::vector<JointIndex> pulling = model.pulling_teeth(run);
        if (pulling.empty() || round == mechanism.joints.size())
            return statics::cut_free(model, board, mechanism, mobility, run, runs.meets(), loose);
        board.rewind(before);
        model.turn_flanks(pulling);
    }
}

}  // namespace kinegraph
