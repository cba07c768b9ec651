// The reference tables of the documents against the program's own: units, keys of a file, commands and their options,
// joints, exit statuses. A row that one side has and the other lacks is a failure.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "engine/file/units.hpp"
#include "engine/mechanism/pair.hpp"
#include "engine/reading/mechanism_schema.hpp"
#include "tests/support/command_line.hpp"

namespace kinegraph::documents_test {
namespace {

using Cells = std::vector<std::string>;

std::string document(const std::string& name) {
    std::ifstream file(KINEGRAPH_TESTS_DIR "/../docs/" + name);
    std::string text{std::istreambuf_iterator<char>(file), {}};
    EXPECT_FALSE(text.empty()) << name;
    return text;
}

/// The rows of the table whose first line is `| head …`, without its heading; cells without their outer blanks.
std::vector<Cells> table_in(const std::string& text, const std::string& head) {
    std::vector<Cells> rows;
    std::size_t at = text.find("\n| " + head);
    EXPECT_NE(at, std::string::npos) << head;
    if (at == std::string::npos) return rows;
    for (++at; text.compare(at, 1, "|") == 0; at = text.find('\n', at) + 1) {
        const std::string line = text.substr(at, text.find('\n', at) - at);
        Cells cells;
        for (std::size_t begin = 1; begin < line.size();) {
            const std::size_t end = line.find(" |", begin);
            const std::string cell = line.substr(begin, end - begin);
            cells.push_back(cell.substr(std::min(cell.find_first_not_of(' '), cell.size())));
            begin = end + 2;
        }
        rows.push_back(std::move(cells));
    }
    rows.erase(rows.begin(), rows.begin() + 2);
    EXPECT_FALSE(rows.empty()) << head;
    return rows;
}

/// What stands between backticks, in order.
std::vector<std::string> codes_in(const std::string& text) {
    std::vector<std::string> codes;
    for (std::size_t at = text.find('`'); at != std::string::npos;) {
        const std::size_t end = text.find('`', at + 1);
        codes.push_back(text.substr(at + 1, end - at - 1));
        at = text.find('`', end + 1);
    }
    return codes;
}

std::set<std::string> options_in(const std::string& text) {
    static const std::regex option("--[a-z][a-z-]*");
    std::set<std::string> all;
    for (std::sregex_iterator each(text.begin(), text.end(), option), end; each != end; ++each) all.insert(each->str());
    return all;
}

class Documents : public tests::CommandLine {
protected:
    std::vector<std::string> commands() const {
        std::istringstream help(run("--help").out);
        std::vector<std::string> names;
        bool listed = false;
        for (std::string line; std::getline(help, line);) {
            if (line == "Subcommands:") listed = true;
            if (listed && line.starts_with("  ") && line[2] != ' ')
                names.push_back(line.substr(2, line.find(' ', 2) - 2));
        }
        EXPECT_GE(names.size(), 10u);
        return names;
    }
};

TEST_F(Documents, ListTheUnitsThatAFileMayUse) {
    std::map<std::string, std::vector<std::string>> written;
    const std::string text = document("file.md");
    for (const char* head : {"key | units, the default first", "quantity | units"}) {
        for (const Cells& row : table_in(text, head)) {
            std::string kind = row.at(0).substr(0, row.at(0).find(" ("));
            std::erase(kind, '`');
            if (kind == "inertia") kind = "moment of inertia";  // the key is shorter than the name
            written[kind] = codes_in(row.at(1));
            std::erase(written[kind], "°");  // another spelling of deg
        }
    }
    std::map<std::string, std::vector<std::string>> known;
    for (const KnownUnit& each : known_units()) known[name_of(each.kind).in(Language::en)].emplace_back(each.symbol);
    EXPECT_EQ(written, known);
}

TEST_F(Documents, ListTheKeysOfAFile) {
    const auto schema = nlohmann::json::parse(mechanism_schema_text);
    std::set<std::string> known{"cam"};  // of a file for `kinegraph cam`, which is no mechanism
    for (const auto& each : schema.at("properties").items()) known.insert(each.key());
    std::set<std::string> written;
    for (const Cells& row : table_in(document("file.md"), "key | value | |"))
        for (const std::string& key : codes_in(row.at(0)))
            if (key.size() > 1) written.insert(key);
    // The row of point motion names the keys within "motion".
    for (const char* within : {"path"}) written.erase(within);
    EXPECT_EQ(written, known);
}

/// Every key of the schema, at any depth.
void collect_keys(const nlohmann::json& schema, std::set<std::string>& keys) {
    if (schema.is_array())
        for (const auto& each : schema) collect_keys(each, keys);
    if (!schema.is_object()) return;
    for (const auto& each : schema.items()) {
        if (each.key() == "properties" && each.value().is_object())
            for (const auto& key : each.value().items()) keys.insert(key.key());
        collect_keys(each.value(), keys);
    }
}
TEST_F(Documents, NameEveryKeyOfTheSchema) {
    std::set<std::string> keys;
    collect_keys(nlohmann::json::parse(mechanism_schema_text), keys);
    ASSERT_GT(keys.size(), 100u);
    std::string text;
    for (const char* name : {"file.md", "file_forces.md", "file_problems.md", "equations.md", "command_line.md"})
        text += document(name);
    for (const std::string& key : keys)
        EXPECT_TRUE(text.find('`' + key + '`') != std::string::npos || text.find('"' + key + '"') != std::string::npos)
            << key;
}

TEST_F(Documents, ListTheJoints) {
    std::set<std::string> written, known;
    for (const Cells& row : table_in(document("file.md"), "form | pair |")) {
        const std::string form = codes_in(row.at(0)).at(0);
        written.insert(form.substr(2, form.find('"', 2) - 2));
    }
    for (const PlanePair& each : plane_pairs) known.insert(std::string(each.key));
    EXPECT_EQ(written, known);
}

TEST_F(Documents, ListTheCommands) {
    std::set<std::string> written;
    for (const Cells& row : table_in(document("command_line.md"), "command | |")) {
        const std::string line = codes_in(row.at(0)).at(0);  // "kinegraph solve FILE [-o OUT]"
        const std::size_t begin = line.find(' ') + 1;
        written.insert(line.substr(begin, line.find(' ', begin) - begin));
    }
    const std::vector<std::string> known = commands();
    EXPECT_EQ(written, std::set(known.begin(), known.end()));
}

TEST_F(Documents, NameTheOptionsThatThereAre) {
    std::set<std::string> known;
    for (const std::string& command : commands())
        for (const std::string& each : options_in(run(command + " --help").out)) known.insert(each);
    std::string text;
    for (const char* name : {"command_line.md", "variants.md", "batch.md", "live_page.md", "equations.md", "themes.md"})
        text += document(name);
    for (const std::string& each : known) EXPECT_TRUE(options_in(text).contains(each)) << each << " is in no document";
    for (const std::string& each : options_in(text))
        EXPECT_TRUE(known.contains(each)) << each << " is in the documents and in no command";
}

TEST_F(Documents, ListTheExitStatusesOfTheHelp) {
    const std::string help = run("--help").out;
    for (const Cells& row : table_in(document("command_line.md"), "status | |"))
        EXPECT_NE(help.find(row.at(0) + ' '), std::string::npos) << row.at(0);
}

}  // namespace
}  // namespace kinegraph::documents_test
