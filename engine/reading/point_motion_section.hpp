// The "motion" of a point: its laws as expressions in t, along axes, by radius and angle, or along a path.
#pragma once

#include <optional>
#include <string>

#include "engine/mechanism/problem.hpp"
#include "engine/reading/form_reader.hpp"
#include "engine/reading/law_constants.hpp"

namespace kinegraph {

class PointMotionSection {
public:
    explicit PointMotionSection(FormReader& file) : file_(file), constants_(file) {}

    /// Whether a "motion" is that of a point, and not of a body.
    static bool is_stated_by(JsonValue motion);
    std::optional<PointProblem> read(JsonValue section);

private:
    using Kind = FormReader::Kind;

    void read_laws(const Members& form, PointProblem& problem);
    StatedLaw read_law(JsonValue value, const std::string& symbol, QuantityKind of, QuantityKind is,
                       NamedConstants& constants);
    void read_path(JsonValue value, PointProblem& problem);
    /// An angle or a vector: these problems have no points that a direction could lie between.
    Vector own_direction(JsonValue value);
    void read_times(const Members& form, PointProblem& problem);

    FormReader& file_;
    LawConstants constants_;
};

}  // namespace kinegraph
