// Examples and mechanism files in text, solved. What cannot be read or solved is thrown, with its place, and so fails
// the test.
#pragma once

#include <stdexcept>
#include <string>

#include "constructions/solving/solve.hpp"
#include "tests/support/files.hpp"

namespace kinegraph::tests {

/// The solution of a mechanism file's text.
inline Solution solved(const std::string& text, const std::string& name = "test.json") {
    const auto fails = [&](const Errors& errors) {
        return std::runtime_error(name + ": " + errors.front().where + ": " + errors.front().message.en + "\n" + text);
    };
    auto mechanism = read_mechanism(text, name);
    if (!mechanism) throw fails(mechanism.error());
    auto solution = solve(*std::move(mechanism));
    if (!solution) throw fails(solution.error());
    return *std::move(solution);
}

inline Solution example(const std::string& name) { return solved(contents(example_file(name)), name + ".json"); }

}  // namespace kinegraph::tests
