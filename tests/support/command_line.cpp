#include "tests/support/command_line.hpp"

#include <regex>

namespace kinegraph::tests {

void CommandLine::SetUp() {
    std::string name = (fs::temp_directory_path() / "kinegraph-cli-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder_ = name;
    streams_ = folder_.string() + "-streams";
    fs::create_directory(streams_);
    for (const char* example : {"four_bar", "parallel_crank", "slider_driven_dead_point", "scara"})
        fs::copy(fs::path(KINEGRAPH_EXAMPLES_DIR) / (example + std::string(".json")), folder_);
    four_bar_ = contents(folder_ / "four_bar.json");
}
void CommandLine::TearDown() {
    fs::remove_all(folder_);
    fs::remove_all(streams_);
}

void CommandLine::write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
}
std::string CommandLine::spoilt(const std::string& piece, const std::string& by) const {
    std::string text = four_bar_;
    const std::size_t at = text.find(piece);
    EXPECT_NE(at, std::string::npos) << piece;
    if (at != std::string::npos) text.replace(at, piece.size(), by);
    return text;
}
Outcome CommandLine::run(const std::string& arguments, const std::string& before) const {
    const std::string out = (streams_ / "out").string();
    const std::string err = (streams_ / "err").string();
    const std::string redirected = arguments.find('>') == std::string::npos ? " >'" + out + "'" : "";
    fs::remove(out);
    const std::string command = "cd '" + folder_.string() + "' && { " + before + " '" + program_ + "' " + arguments +
                                redirected + "; } 2>'" + err + "'";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(out), contents(err)};
}
CommandLine::Snapshot CommandLine::snapshot() const {
    Snapshot all;
    for (const auto& entry : fs::directory_iterator(folder_))
        all[entry.path().filename().string()] = entry.is_regular_file() ? contents(entry.path()) : "no plain file";
    return all;
}
std::string CommandLine::changed_since(const Snapshot& before) const {
    const Snapshot after = snapshot();
    std::string names;
    for (const auto& [name, text] : before)
        if (!after.contains(name) || after.at(name) != text) names += name + ' ';
    for (const auto& [name, text] : after)
        if (!before.contains(name)) names += name + ' ';
    return names;
}

::testing::AssertionResult lines_are(const std::string& text, const std::string& pattern) {
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
