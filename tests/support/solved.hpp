// Solves examples and mechanism files given as text. If a text cannot be read or solved, throws with the position of
// the fault, which fails the test.
#pragma once

#include <map>
#include <memory>
#include <stdexcept>
#include <string>

#include "constructions/solving/solve.hpp"
#include "tests/support/files.hpp"

namespace kinegraph::tests {

/// The solution of a mechanism file's text.
inline Solution solved(const std::string& text, const std::string& name = "test.json") {
    const auto fails = [&](const Errors& errors) {
        return std::runtime_error(name + ": " + errors.front().where + ": " + errors.front().message.in(Language::en) +
                                  "\n" + text);
    };
    auto mechanism = read_mechanism(text, name);
    if (!mechanism) throw fails(mechanism.error());
    auto solution = solve(*std::move(mechanism));
    if (!solution) throw fails(solution.error());
    return *std::move(solution);
}

/// The solution of an example, computed once in a process and shared by all tests. A test that changes it must copy it.
inline const Solution& example(const std::string& name) {
    static std::map<std::string, std::unique_ptr<const Solution>> known;
    std::unique_ptr<const Solution>& solution = known[name];
    if (!solution) solution = std::make_unique<const Solution>(solved(contents(example_file(name)), name + ".json"));
    return *solution;
}

}  // namespace kinegraph::tests
