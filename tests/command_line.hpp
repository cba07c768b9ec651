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
#include <regex>
#include <sstream>
#include <string>

#include "tests/files.hpp"

namespace kinegraph::tests {

namespace fs = std::filesystem;

struct Outcome {
    int status = -1;
    std::string out, err;
};

/// A folder of its own for each test, with some of the examples and some spoilt files in it.
class CommandLine : public ::testing::Test {
protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "kinegraph-cli-XXXXXX").string();
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        folder_ = name;
        streams_ = folder_.string() + "-streams";
        fs::create_directory(streams_);
        for (const char* example : {"four_bar", "parallel_crank", "slider_driven_dead_point", "scara"})
            fs::copy(fs::path(KINEGRAPH_EXAMPLES_DIR) / (example + std::string(".json")), folder_);
        four_bar_ = contents(folder_ / "four_bar.json");
    }
    void TearDown() override {
        fs::remove_all(folder_);
        fs::remove_all(streams_);
    }

    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name, std::ios::binary) << text;
    }
    /// four_bar.json with one piece of text replaced.
    std::string spoilt(const std::string& piece, const std::string& by) const {
        std::string text = four_bar_;
        const std::size_t at = text.find(piece);
        EXPECT_NE(at, std::string::npos) << piece;
        if (at != std::string::npos) text.replace(at, piece.size(), by);
        return text;
    }
    /// Runs the program in the folder; `arguments` is a shell's text.
    Outcome run(const std::string& arguments, const std::string& before = "") const {
        const std::string out = (streams_ / "out").string();
        const std::string err = (streams_ / "err").string();
        const std::string redirected = arguments.find('>') == std::string::npos ? " >'" + out + "'" : "";
        fs::remove(out);
        const std::string command = "cd '" + folder_.string() + "' && { " + before + " '" + program_ + "' " + arguments +
                                    redirected + "; } 2>'" + err + "'";
        const int status = std::system(command.c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(out), contents(err)};
    }
    /// Every name in the folder with what it holds.
    using Snapshot = std::map<std::string, std::string>;
    Snapshot snapshot() const {
        Snapshot all;
        for (const auto& entry : fs::directory_iterator(folder_))
            all[entry.path().filename().string()] = entry.is_regular_file() ? contents(entry.path()) : "no plain file";
        return all;
    }
    /// The names that came, went or hold something else.
    std::string changed_since(const Snapshot& before) const {
        const Snapshot after = snapshot();
        std::string names;
        for (const auto& [name, text] : before)
            if (!after.contains(name) || after.at(name) != text) names += name + ' ';
        for (const auto& [name, text] : after)
            if (!before.contains(name)) names += name + ' ';
        return names;
    }
    bool is_there(const std::string& name) const { return fs::exists(folder_ / name); }

    fs::path folder_, streams_;
    std::string four_bar_;
    std::string program_ = KINEGRAPH_PROGRAM;
};

/// All lines match `pattern`, and there is one at least.
inline ::testing::AssertionResult lines_are(const std::string& text, const std::string& pattern) {
    std::istringstream stream(text);
    std::string line;
    int count = 0;
    while (std::getline(stream, line)) {
        ++count;
        if (!std::regex_match(line, std::regex(pattern)))
            return ::testing::AssertionFailure() << "\"" << line << "\" is not like " << pattern;
    }
    if (count == 0) return ::testing::AssertionFailure() << "nothing was said, not even " << pattern;
    return ::testing::AssertionSuccess();
}

}  // namespace kinegraph::tests
