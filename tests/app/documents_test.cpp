// The reference tables of the documents against the program's own: units, keys of a file, commands and their options,
// joints, exit statuses. A row that one side has and the other lacks is a failure.
#include <gtest/gtest.h>

#include <kinegraph/mechanism.hpp>

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
#include "engine/reading/forms.hpp"
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
    const auto schema = nlohmann::json::parse(mechanism_schema());
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
    collect_keys(nlohmann::json::parse(mechanism_schema()), keys);
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

/// The keys of `{"from": P, "meet": [curve, curve]}` with the letters of their values.
std::map<std::string, std::string> members_written(const std::string& form) {
    std::map<std::string, std::string> members;
    std::string text = form.substr(1, form.size() - 2);
    while (!text.empty()) {
        std::size_t end = 0;
        for (int depth = 0; end < text.size() && (depth > 0 || text[end] != ','); ++end)
            depth += text[end] == '[' || text[end] == '{' ? 1 : text[end] == ']' || text[end] == '}' ? -1 : 0;
        const std::string member = text.substr(0, end);
        const std::size_t quote = member.find("\": ");
        if (quote != std::string::npos) members[member.substr(1, quote - 1)] = member.substr(quote + 3);
        text.erase(0, end + 2);
    }
    return members;
}

/// An object as a table of the documents should write it.
struct ObjectOfForm {
    const Form* form;
    std::set<std::string> needed, one_of;  ///< keys: all, exactly one

    /// With the letter of the row's value, or one of its words.
    bool has(const std::string& key, const std::string& letter) const {
        const FormRow* row = form->row(key);
        if (row == nullptr) return false;
        return row->written == letter ||
               std::any_of(row->value.words.begin(), row->value.words.end(),
                           [&](std::string_view word) { return letter == '"' + std::string(word) + '"'; });
    }
    bool is_written_as(const std::string& code) const {
        const auto members = members_written(code);
        std::size_t alternatives = 0;
        for (const auto& [key, letter] : members) {
            if (!has(key, letter) || (!form->choices.empty() && !needed.contains(key))) return false;
            alternatives += one_of.count(key);
        }
        if (code.ends_with(", …}")) return true;
        return alternatives == (one_of.empty() ? 0 : 1) &&
               std::all_of(needed.begin(), needed.end(), [&](const auto& key) { return members.contains(key); });
    }
};

void collect_objects(const FormValue& value, std::vector<ObjectOfForm>& objects) {
    for (const FormValue& choice : value.choices) collect_objects(choice, objects);
    if (value.of != nullptr) collect_objects(*value.of, objects);
    if (value.form == nullptr) return;
    for (const Form::Choice& choice : value.form->choices) {
        objects.push_back({value.form, {choice.keys.begin(), choice.keys.end()}, {}});
        objects.back().needed.erase("");
    }
    if (!value.form->choices.empty()) return;
    objects.push_back({value.form, {}, {}});
    for (const FormRow& row : value.form->rows) {
        if (row.need == FormRow::Need::required) objects.back().needed.emplace(row.key);
        if (row.need == FormRow::Need::one_of) objects.back().one_of.emplace(row.key);
    }
}

/// Each row of the table writes an object of the values, or one further key of it, and each object has a row.
void expect_table_of(const std::vector<const FormValue*>& values, const char* name, const char* head) {
    std::vector<ObjectOfForm> objects;
    for (const FormValue* value : values) collect_objects(*value, objects);
    ASSERT_FALSE(objects.empty());
    std::set<const ObjectOfForm*> missing;
    for (const ObjectOfForm& each : objects) missing.insert(&each);
    for (const Cells& row : table_in(document(name), head)) {
        const std::string code = codes_in(row.at(0)).at(0);
        if (code.starts_with('[')) continue;  // coordinates
        bool is_one = false;
        for (const ObjectOfForm& each : objects) {
            if (code.starts_with('{')) {
                if (!each.is_written_as(code)) continue;
                missing.erase(&each);
            } else {
                const auto [key, letter] = *members_written("{" + code + "}").begin();
                if (!each.has(key, letter)) continue;
            }
            is_one = true;
        }
        EXPECT_TRUE(is_one) << code << " is no form that the reader knows";
    }
    for (const ObjectOfForm* each : missing)
        ADD_FAILURE() << name << " lacks a form with " << each->form->rows.front().key;
}
TEST_F(Documents, WriteTheFormsThatTheReaderKnows) {
    expect_table_of({&forms::point}, "file.md", "form | the point is |");
    expect_table_of({&forms::joint}, "file.md", "form | pair |");
    expect_table_of({&forms::driver}, "file.md", "form | gives |");
    expect_table_of({&forms::turn_law, &forms::slide_law}, "file.md", "piece | the driver |");
    expect_table_of({&forms::load}, "file_forces.md", "load | |");
    expect_table_of({&forms::effort}, "file_forces.md", "effort | |");
}

/// The catalogue of pairs writes each joint with its keys.
TEST_F(Documents, WriteTheFormsOfPairsWithTheKeysOfTheReader) {
    std::vector<ObjectOfForm> objects;
    collect_objects(forms::joint, objects);
    ASSERT_EQ(objects.size(), plane_pairs.size());
    for (const ObjectOfForm& each : objects) {
        const auto pair = std::find_if(plane_pairs.begin(), plane_pairs.end(), [&](const PlanePair& candidate) {
            return candidate.key == each.form->rows.front().key;
        });
        ASSERT_NE(pair, plane_pairs.end());
        const auto members = members_written(std::string(pair->form));
        for (const auto& member : members) EXPECT_NE(each.form->row(member.first), nullptr) << pair->form;
        for (const std::string& key : each.needed) EXPECT_TRUE(members.contains(key)) << pair->form;
    }
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
    for (const char* name : {"command_line.md", "variants.md", "batch.md", "live_page.md", "equations.md", "themes.md",
                             "slides.md", "exchange.md", "workbench.md"})
        text += document(name);
    for (const std::string& each : known) EXPECT_TRUE(options_in(text).contains(each)) << each << " is in no document";
    for (const std::string& each : options_in(text))
        EXPECT_TRUE(known.contains(each)) << each << " is in the documents and in no command";
}

TEST_F(Documents, NameFilesThatThereAre) {
    const std::filesystem::path top = KINEGRAPH_TESTS_DIR "/..";
    std::vector<std::filesystem::path> documents = {top / "README.md", top / "CONTRIBUTING.md"};
    for (const auto& each : std::filesystem::directory_iterator(top / "docs"))
        if (each.path().extension() == ".md") documents.push_back(each.path());
    // With a folder of the sources before it, and without letters that stand for a name.
    static const std::regex place("(app|constructions|engine|include|lang|problems|render|tests)/[a-z_./]*");
    int named = 0;
    for (const std::filesystem::path& path : documents) {
        std::ifstream file(path);
        for (const std::string& code : codes_in({std::istreambuf_iterator<char>(file), {}})) {
            if (!std::regex_match(code, place)) continue;
            ++named;
            EXPECT_TRUE(std::filesystem::exists(top / code)) << path << ": " << code;
        }
    }
    EXPECT_GE(named, 50);
}

TEST_F(Documents, ListTheExitStatusesOfTheHelp) {
    const std::string help = run("--help").out;
    for (const Cells& row : table_in(document("command_line.md"), "status | |"))
        EXPECT_NE(help.find(row.at(0) + ' '), std::string::npos) << row.at(0);
}

}  // namespace
}  // namespace kinegraph::documents_test
