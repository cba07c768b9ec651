// The examples and what is in a file.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace kinegraph::tests {

/// The bytes of a file.
inline std::string contents(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

inline std::filesystem::path example_file(const std::string& name) {
    return std::filesystem::path(KINEGRAPH_EXAMPLES_DIR) / (name + ".json");
}

/// The names of all examples, in order.
inline std::vector<std::string> example_names() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(KINEGRAPH_EXAMPLES_DIR))
        if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace kinegraph::tests
