// The section of a file that states a problem in place of joints: "hertz", "reye", "impact", "positions", or the
// "motion" of a point. Owns which sections go together; each problem has a file of its own.
#pragma once

#include <memory>

#include "engine/mechanism/problem.hpp"
#include "engine/reading/form_reader.hpp"

namespace kinegraph {

class ProblemSection {
public:
    ProblemSection(FormReader& file, Mechanism& mechanism) : file_(file), mechanism_(mechanism) {}

    static bool is_in(const Members& file);
    /// Null where the file states none or one that cannot be read. Its bodies are added to the mechanism.
    std::shared_ptr<const Problem> read(const Members& file);

private:
    using Kind = FormReader::Kind;

    FormReader& file_;
    Mechanism& mechanism_;
};

}  // namespace kinegraph
