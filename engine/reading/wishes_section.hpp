// "find": what is asked for, relative motions and cuts of a truss among it. Cuts are read last, when the whole file
// makes a truss.
#pragma once

#include <vector>

#include "engine/mechanism/mechanism.hpp"
#include "engine/reading/form_reader.hpp"
#include "engine/solution/truss.hpp"

namespace kinegraph {

class WishesSection {
public:
    WishesSection(FormReader& file, Mechanism& mechanism) : file_(file), mechanism_(mechanism) {}

    void read_wish(JsonValue value);
    /// Cuts name bars of a truss, which the whole file makes.
    void read_cuts();

private:
    using Kind = FormReader::Kind;

    /// Whether the motion is to be found through the observer; one that translates gives no direction of a relative
    /// velocity.
    void read_solve(JsonValue value, RelativeMotionQuery& query);
    static bool is_cut(JsonValue value);
    void read_cut(JsonValue value, const TrussStructure& truss);

    FormReader& file_;
    Mechanism& mechanism_;
    std::vector<JsonValue> cuts_;
};

}  // namespace kinegraph
