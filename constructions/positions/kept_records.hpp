// Kept records: those of positions that were planned, in doubles, to be replayed in others.
#pragma once

#include <cstddef>
#include <functional>
#include <list>
#include <utility>
#include <vector>

#include "engine/board/replay.hpp"
#include "engine/sentences/column.hpp"

namespace kinegraph {

struct Solution;

class KeptRecords {
public:
    struct Record {
        struct Source {
            bool known = false;
            ElementIndex element;  ///< none: the value is zero
            ElementIndex from{};   ///< of a distance, as FoundValue::from
        };
        Replay replay;
        std::vector<std::pair<int, Given>> moving;  ///< givens that change, with their index in the program
        std::vector<Source> sources;                ///< by column
    };

    /// Whether the record of this position may be replayed in others. Not that of a position which the data do not
    /// distinguish from a special one (a body at rest): how far it is from it is not in the record, and elsewhere it
    /// would be wrong. The first position that is asked about counts as usual.
    bool is_usual(const Solution& solution);
    /// `settled`: all guards before this stroke count. `moves`: whether a given changes.
    void keep(const Solution& solution, const std::vector<Column>& columns, int settled,
              const std::function<bool(const Given&)>& moves);

    /// Replays records until the guards of one hold; the last one used is tried first. Null: none is valid here.
    /// `value` gives those that change.
    template <class Value>
    const Record* replayed(Value value) {
        for (auto record = kept_.begin(); record != kept_.end(); ++record) {
            for (const auto& [index, given] : record->moving) record->replay.give(index, value(given));
            if (record->replay.run()) continue;
            if (record != kept_.begin()) kept_.splice(kept_.begin(), kept_, record);
            return &kept_.front();
        }
        return nullptr;
    }

private:
    std::list<Record> kept_;
    std::ptrdiff_t usual_doubts_ = -1;  ///< questions that the data leave open in a usual position
};

}  // namespace kinegraph
