// Paths of the examples and contents of files.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
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

/// The JSON files of a folder, sorted. An empty folder is an error: a loop over it would test nothing.
inline std::vector<std::filesystem::path> json_files(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    if (files.empty()) throw std::runtime_error("no JSON file in " + folder.string());
    std::sort(files.begin(), files.end());
    return files;
}

/// The names of the examples in a folder, without extension, sorted.
inline std::vector<std::string> example_names(const std::string& folder = "") {
    std::vector<std::string> names;
    for (const auto& file : json_files(std::filesystem::path(KINEGRAPH_EXAMPLES_DIR) / folder))
        names.push_back(file.stem().string());
    return names;
}

}  // namespace kinegraph::tests
