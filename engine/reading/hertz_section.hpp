// "hertz": two bodies that press each other, by their radii and materials. Curvatures that leave no contact are told
// here, since the problem needs no drawing.
#pragma once

#include <cstddef>
#include <optional>

#include "engine/mechanism/problem.hpp"
#include "engine/reading/form_reader.hpp"
#include "engine/reading/materials.hpp"
#include "engine/reading/problem_bodies.hpp"

namespace kinegraph {

class HertzSection {
public:
    HertzSection(FormReader& file, Mechanism& mechanism)
        : file_(file), mechanism_(mechanism), bodies_(file, mechanism), materials_(file) {}

    std::optional<HertzProblem> read(JsonValue section);

private:
    using Kind = FormReader::Kind;

    HertzBody read_body(JsonValue member, bool line);
    void read_shape(const Members& form, bool line, HertzBody& body);
    void read_radius(JsonValue value, std::size_t plane, HertzBody& body);
    void check_curvatures(const HertzProblem& problem, JsonValue bodies);

    FormReader& file_;
    Mechanism& mechanism_;
    ProblemBodies bodies_;
    Materials materials_;
};

}  // namespace kinegraph
