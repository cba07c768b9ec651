// Runs the built program like a user: a separate folder for each test, and the output and files of a run.
#pragma once

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "tests/support/files.hpp"

namespace kinegraph::tests {

namespace fs = std::filesystem;

struct Outcome {
    int status = -1;
    std::string out, err;
};

/// A separate folder for each test, with some of the examples and some invalid files.
class CommandLine : public ::testing::Test {
protected:
    void SetUp() override;
    void TearDown() override;

    void write(const std::string& name, const std::string& text) const;
    /// Writes four_bar.json with one piece of text replaced.
    std::string spoilt(const std::string& piece, const std::string& by) const;
    /// Runs the program in the folder; `arguments` is shell text.
    Outcome run(const std::string& arguments, const std::string& before = "") const;
    /// The content of every file in the folder, by name.
    using Snapshot = std::map<std::string, std::string>;
    Snapshot snapshot() const;
    /// The names of files that were added, removed or changed.
    std::string changed_since(const Snapshot& before) const;
    bool is_there(const std::string& name) const { return fs::exists(folder_ / name); }

    fs::path folder_, streams_;
    std::string four_bar_;
    std::string program_ = KINEGRAPH_PROGRAM;
};

/// All lines match `pattern`, and there is at least one.
::testing::AssertionResult lines_are(const std::string& text, const std::string& pattern);

}  // namespace kinegraph::tests
