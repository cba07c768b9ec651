#include "constructions/positions/kept_records.hpp"

#include <algorithm>

#include "constructions/positions/named_results.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {

bool KeptRecords::is_usual(const Solution& solution) {
    const auto& guards = solution.protocol.program.guards;
    const auto doubts = std::count_if(guards.begin(), guards.end(), [](const Guard& guard) {
        return guard.how == Guard::How::by_precision && guard.verdict == (asks_for_zero(guard.question) ? 1 : 0);
    });
    if (usual_doubts_ < 0) usual_doubts_ = doubts;
    return doubts <= usual_doubts_;
}

void KeptRecords::keep(const Solution& solution, const std::vector<Column>& columns, int settled,
                       const std::function<bool(const Given&)>& moves) {
    const std::vector<FoundValue> entries = found_values(solution, true);
    std::vector<ElementIndex> wanted;
    for (const Column& column : columns)
        for (const FoundValue& entry : entries)
            if (entry.quantity == column.quantity)
                for (const ElementIndex each : {entry.element, entry.from})
                    if (each != none) wanted.push_back(each);
    const Cut cut_out = cut(solution.protocol.program, wanted, settled);
    Record record{Replay(cut_out.program, givens_of(cut_out.program, solution.mechanism, solution.pose),
                         solution.pose.size.to_double()),
                  {},
                  std::vector<Record::Source>(columns.size())};
    for (std::size_t i = 0; i < cut_out.program.givens.size(); ++i)
        if (moves(cut_out.program.givens[i]))
            record.moving.emplace_back(static_cast<int>(i), cut_out.program.givens[i]);
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const auto found = std::find_if(entries.begin(), entries.end(),
                                        [&](const FoundValue& entry) { return entry.quantity == columns[i].quantity; });
        if (found == entries.end()) continue;
        const auto kept = [&](ElementIndex element) {
            return element == none ? ElementIndex() : cut_out.element[at_index(element)];
        };
        record.sources[i] = {true, kept(found->element), kept(found->from)};
    }
    // Records of special positions (a right angle, a body at rest) are valid nowhere else; the oldest are dropped.
    constexpr std::size_t most = 24;
    if (kept_.size() == most) kept_.pop_back();
    kept_.push_front(std::move(record));
}

}  // namespace kinegraph
