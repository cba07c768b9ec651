// Exercise: what a file asks of those who solve it. Results go by the names that they have in the rows of a sweep
// (engine/result_names.hpp). Knows no values: those are constructions/named_results.hpp.
#pragma once

#include <string>
#include <vector>

#include "engine/mechanism.hpp"

namespace kinegraph {

/// One of the results that are asked for.
struct AskedResult {
    std::string name;   ///< "v B", "omega 3", "effort M"
    std::string where;  ///< JSON pointer
};

struct Exercise {
    std::vector<AskedResult> ask;  ///< none twice
};

/// What a mechanism asks for; nothing where its file says nothing of it.
inline const std::vector<AskedResult>& asked_of(const Mechanism& mechanism) {
    static const std::vector<AskedResult> nothing;
    return mechanism.exercise ? mechanism.exercise->ask : nothing;
}

}  // namespace kinegraph
