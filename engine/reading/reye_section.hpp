// "reye": wear of a pad, a block, a disc, a collar or the shoe of a drum brake.
#pragma once

#include <optional>

#include "engine/mechanism/problem.hpp"
#include "engine/reading/form_reader.hpp"

namespace kinegraph {

class ReyeSection {
public:
    explicit ReyeSection(FormReader& file) : file_(file) {}

    std::optional<ReyeProblem> read(JsonValue section);

private:
    using Kind = FormReader::Kind;

    std::optional<ReyeProblem::Kind> read_kind(JsonValue section);
    void read_pad(const Members& form, ReyeProblem& problem);
    void read_disc(const Members& form, ReyeProblem& problem);
    void read_shoe(const Members& form, ReyeProblem& problem);

    FormReader& file_;
};

}  // namespace kinegraph
