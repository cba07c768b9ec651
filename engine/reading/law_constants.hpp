// The "constants" of the laws of a point's motion, by name: numbers, quantities of any dimension, formulas of those
// before them.
#pragma once

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/file/expression.hpp"
#include "engine/reading/form_reader.hpp"

namespace kinegraph {

class LawConstants {
public:
    explicit LawConstants(FormReader& file) : file_(file) {}

    void read(JsonValue constants);
    /// A constant or a parameter of the file; an error without words has been told before. `variable`: what else an
    /// expression may name, for the remedy.
    tl::expected<Measured, Words> look_up(std::string_view name, std::string_view variable);

private:
    using Kind = FormReader::Kind;

    std::optional<Measured> read_one(JsonValue member);

    FormReader& file_;
    std::vector<std::pair<std::string_view, std::optional<Measured>>> constants_;  ///< none: faulty
};

}  // namespace kinegraph
