// The "bodies" of a problem in place of joints: an object by name, where a body that the file has not is added.
#pragma once

#include <array>

#include "engine/reading/form_reader.hpp"

namespace kinegraph {

class ProblemBodies {
public:
    ProblemBodies(FormReader& file, Mechanism& mechanism) : file_(file), mechanism_(mechanism) {}

    /// The two members of "bodies", or "not there".
    std::array<JsonValue, 2> two(const Members& section);
    /// The body of a member's name, added where the file has none.
    BodyIndex body(JsonValue member);

private:
    using Kind = FormReader::Kind;

    FormReader& file_;
    Mechanism& mechanism_;
};

}  // namespace kinegraph
