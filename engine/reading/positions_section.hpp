// "positions": two or three positions of a body, by the places of two of its points.
#pragma once

#include <optional>

#include "engine/mechanism/problem.hpp"
#include "engine/reading/form_reader.hpp"

namespace kinegraph {

class PositionsSection {
public:
    explicit PositionsSection(FormReader& file) : file_(file) {}

    std::optional<PositionsProblem> read(JsonValue section);

private:
    using Kind = FormReader::Kind;

    void read_position(JsonValue value, PositionsProblem& problem);
    /// What is rounded alone is moved along the join; more is a fault.
    void keep_distance(JsonValue at, const PositionsProblem& problem, PositionsProblem::Position& position);

    FormReader& file_;
};

}  // namespace kinegraph
