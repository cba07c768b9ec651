// The built program as a user meets it: a folder of its own for each test, and what a run said and left there.
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

/// A folder of its own for each test, with some of the examples and some spoilt files in it.
class CommandLine : public ::testing::Test {
protected:
    void SetUp() override;
    void TearDown() override;

    void write(const std::string& name, const std::string& text) const;
    /// four_bar.json with one piece of text replaced.
    std::string spoilt(const std::string& piece, const std::string& by) const;
    /// Runs the program in the folder; `arguments` is a shell's text.
    Outcome run(const std::string& arguments, const std::string& before = "") const;
    /// Every name in the folder with what it holds.
    using Snapshot = std::map<std::string, std::string>;
    Snapshot snapshot() const;
    /// The names that came, went or hold something else.
    std::string changed_since(const Snapshot& before) const;
    bool is_there(const std::string& name) const { return fs::exists(folder_ / name); }

    fs::path folder_, streams_;
    std::string four_bar_;
    std::string program_ = KINEGRAPH_PROGRAM;
};

/// All lines match `pattern`, and there is one at least.
::testing::AssertionResult lines_are(const std::string& text, const std::string& pattern);

}  // namespace kinegraph::tests
