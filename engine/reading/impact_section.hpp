// "impact": two bodies that strike each other, with their masses and velocities, restitution and friction.
#pragma once

#include <optional>

#include "engine/mechanism/problem.hpp"
#include "engine/reading/form_reader.hpp"
#include "engine/reading/problem_bodies.hpp"

namespace kinegraph {

class ImpactSection {
public:
    ImpactSection(FormReader& file, Mechanism& mechanism)
        : file_(file), mechanism_(mechanism), bodies_(file, mechanism) {}

    std::optional<ImpactProblem> read(JsonValue section);

private:
    using Kind = FormReader::Kind;

    ImpactBody read_body(JsonValue member);

    FormReader& file_;
    Mechanism& mechanism_;
    ProblemBodies bodies_;
};

}  // namespace kinegraph
