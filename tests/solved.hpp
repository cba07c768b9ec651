// Examples and mechanism files in text, solved. What cannot be read or solved is thrown, with its place, and so fails the test.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "constructions/solve.hpp"

namespace kinegraph::tests {

/// The bytes of a file.
inline std::string contents(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// The solution of a mechanism file's text.
inline Solution solved(const std::string& text, const std::string& name = "test.json") {
    const auto fails = [&](const Errors& errors) {
        return std::runtime_error(name + ": " + errors.front().where + ": " + errors.front().message + "\n" + text);
    };
    auto mechanism = read_mechanism(text, name);
    if (!mechanism) throw fails(mechanism.error());
    auto solution = solve(*std::move(mechanism));
    if (!solution) throw fails(solution.error());
    return *std::move(solution);
}

inline std::filesystem::path example_file(const std::string& name) {
    return std::filesystem::path(KINEGRAPH_EXAMPLES_DIR) / (name + ".json");
}
inline Solution example(const std::string& name) { return solved(contents(example_file(name)), name + ".json"); }

/// The names of all examples, in order.
inline std::vector<std::string> example_names() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(KINEGRAPH_EXAMPLES_DIR))
        if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace kinegraph::tests
