#include "constructions/positions/effort_rows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/solution/solution.hpp"

namespace kinegraph {

std::vector<ElementIndex> EffortRows::wanted(const VirtualWork& work) {
    std::vector<ElementIndex> elements;
    const auto add = [&](ElementIndex element) {
        if (element != none) elements.push_back(element);
    };
    for (const VirtualWork::Share& share : work.shares)
        if (!share.rests) add(share.power.element());
    for (const VirtualWork::Entry& entry : work.entries) add(entry.elements.power);
    add(work.total_element);
    return elements;
}

EffortRows::Record EffortRows::record_of(const Solution& moved) const {
    const VirtualWork& work = *moved.virtual_work;
    const Program& program = moved.protocol.program;
    Cut cut_out = cut(program, wanted(work), static_cast<int>(program.strokes.size()));
    const auto now = [&](ElementIndex element) {
        return element == none ? ElementIndex(none) : cut_out.element[at_index(element)];
    };
    Record record{
        Replay(cut_out.program, givens_of(cut_out.program, moved.mechanism, moved.pose), moved.pose.size.to_double()),
        {},
        {},
        {},
        {}};
    for (std::size_t i = 0; i < cut_out.program.givens.size(); ++i) {
        const Given& given = cut_out.program.givens[i];
        if (is_inertia(given) || givens_.hangs(given)) record.moving.emplace_back(static_cast<int>(i), given);
    }
    for (const VirtualWork::Share& share : work.shares)
        record.shares.push_back({share.effort, share.rests ? ElementIndex(none) : now(share.power.element())});
    for (const VirtualWork::Entry& entry : work.entries) record.entries.push_back(now(entry.elements.power));
    record.total = now(work.total_element);
    return record;
}

void EffortRows::keep(const Displacements& found) {
    constexpr std::size_t most = 24;  // as for the records of the motion; the oldest are dropped
    kept_.resize(std::max(kept_.size(), found.freedoms.size()));
    for (std::size_t i = 0; i < found.freedoms.size(); ++i) {
        if (kept_[i].size() == most) kept_[i].pop_back();
        kept_[i].push_front(record_of(*found.freedoms[i].moved));
    }
}

bool EffortRows::is_inertia(const Given& given) const {
    return (given.kind == Given::Kind::load_force || given.kind == Given::Kind::load_magnitude) &&
           at_index(given.index) >= mechanism_.loads.size();
}

/// After the loads of the file each mass has two givens: −m a_G, then −J α.
ValueOf<double> EffortRows::inertia(const Given& given, const std::vector<Acceleration>& masses) const {
    const std::size_t mass = (at_index(given.index) - mechanism_.loads.size()) / 2;
    const Mass& of = mechanism_.masses[mass];
    if (given.kind == Given::Kind::load_force) return -of.mass.to_double() * masses[mass].centre;
    return -of.inertia.to_double() * masses[mass].alpha;
}

const EffortRows::Record* EffortRows::replayed(std::list<Record>& kept, const Places& places,
                                               const Positions& positions,
                                               const std::vector<Acceleration>& masses) const {
    for (auto record = kept.begin(); record != kept.end(); ++record) {
        for (const auto& [index, given] : record->moving)
            record->replay.give(index,
                                is_inertia(given) ? inertia(given, masses) : givens_.value(given, places, positions));
        if (record->replay.run()) continue;
        kept.splice(kept.begin(), kept, record);
        return &kept.front();
    }
    return nullptr;
}

std::optional<EffortRows::Efforts> EffortRows::here(const Places& places, const Positions& positions,
                                                    const std::vector<Acceleration>& masses) {
    const std::size_t count = mechanism_.efforts.size();
    WorkEquations equations;
    for (std::list<Record>& kept : kept_) {
        const Record* record = replayed(kept, places, positions, masses);
        if (record == nullptr) return std::nullopt;
        const auto work = [&](ElementIndex element) { return element == none ? 0.0 : record->replay.scalar(element); };
        std::vector<Exact> row(count + 1);
        double largest = 0;
        for (const ElementIndex entry : record->entries) largest = std::max(largest, std::abs(work(entry)));
        for (const Share& share : record->shares) {
            if (!std::isfinite(work(share.power))) return std::nullopt;
            row[at_index(share.effort)] = Exact::from_double(work(share.power));
        }
        if (!std::isfinite(work(record->total))) return std::nullopt;
        row[count] = Exact::from_double(-work(record->total));
        equations.rows.push_back(std::move(row));
        equations.largest.push_back(largest);
    }
    if (equations.rows.empty()) return std::nullopt;
    const WorkEquations::Found found = std::move(equations).solved(count);
    Efforts efforts(count);
    for (std::size_t e = 0; e < count; ++e)
        if (found.balanced && found.efforts[e]) efforts[e] = found.efforts[e]->to_double();
    return efforts;
}

EffortRows::Efforts EffortRows::of(const Displacements& found) {
    Efforts efforts;
    for (const Displacements::Effort& each : found.efforts)
        efforts.push_back(each.value ? std::optional(each.value->to_double()) : std::nullopt);
    return efforts;
}

}  // namespace kinegraph
