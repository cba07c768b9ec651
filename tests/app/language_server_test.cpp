// The language server, talked to as an editor does: what it tells, what it proposes, where; and that nothing an editor
// or a file says ends it before its time.
#include <gtest/gtest.h>

#include <kinegraph/mechanism.hpp>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "tests/support/editor.hpp"
#include "tests/support/files.hpp"

namespace kinegraph::language_server_test {
namespace {

using tests::contents;
using tests::Editor;
using tests::frame;
using tests::Json;
using tests::offset;
using tests::position;

const std::string uri = "file:///home/anyone/four%20bar.kinegraph.json";

/// The text with its cursor, "|", taken out.
struct Typed {
    explicit Typed(const std::string& with_cursor) : at(with_cursor.find('|')), text(with_cursor) { text.erase(at, 1); }
    std::size_t at;
    std::string text;
};

class LanguageServerCommand : public ::testing::Test {
protected:
    void begin(const Json& parameters = Json::object()) {
        const Json answer = editor_.ask("initialize", parameters);
        ASSERT_TRUE(answer.contains("result")) << answer;
        editor_.tell("initialized", Json::object());
    }
    std::vector<std::string> proposed(const std::string& with_cursor) {
        const Typed typed(with_cursor);
        editor_.open(uri, typed.text);
        std::vector<std::string> labels;
        for (const Json& each : editor_.at(uri, typed.text, typed.at, "completion")) labels.push_back(each["label"]);
        return labels;
    }
    /// The text after the proposal has been taken.
    std::string completed(const std::string& with_cursor, const std::string& label) {
        const Typed typed(with_cursor);
        editor_.open(uri, typed.text);
        for (const Json& each : editor_.at(uri, typed.text, typed.at, "completion")) {
            if (each["label"] != label) continue;
            const Json& range = each["textEdit"]["range"];
            const std::size_t from = offset(typed.text, range["start"]), to = offset(typed.text, range["end"]);
            std::string text = typed.text;
            return text.replace(from, to - from, each["textEdit"]["newText"].get<std::string>());
        }
        return "not proposed";
    }
    static int error_of(const Json& answer) {
        return answer.is_object() && answer.contains("error") ? answer["error"]["code"].get<int>() : 0;
    }

    Editor editor_;
};

using Names = std::vector<std::string>;
const std::string four_bar =
    R"({"kinegraph": 1, "frame": 1, "parameters": {"r": "40 mm", "k": 2}, "points": {"O": [0, 0], "A": [3, 4]}, )"
    R"("bodies": {"2": ["O", "A"], "rod": ["A"]}, )";

bool has(const Names& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

TEST_F(LanguageServerCommand, GreetsServesAndTakesLeave) {
    const Json answer = editor_.ask("initialize", {{"processId", nullptr}, {"rootUri", nullptr}});
    const Json& can = answer["result"]["capabilities"];
    EXPECT_EQ(can["textDocumentSync"]["change"], 1);
    EXPECT_TRUE(can["hoverProvider"]);
    EXPECT_TRUE(can.contains("completionProvider"));
    EXPECT_EQ(answer["result"]["serverInfo"]["name"], "kinegraph");
    EXPECT_EQ(error_of(editor_.ask("initialize", Json::object())), -32600);
    EXPECT_EQ(error_of(editor_.ask("textDocument/rename", Json::object())), -32601);
    EXPECT_TRUE(editor_.ask("shutdown", nullptr)["result"].is_null());
    EXPECT_EQ(error_of(editor_.ask("textDocument/hover", Json::object())), -32600);
    editor_.tell("exit", nullptr);
    EXPECT_EQ(editor_.end(), 0);
}

TEST_F(LanguageServerCommand, EndsWithOneWhereTheEditorLeavesWithoutAWord) {
    begin();
    EXPECT_EQ(editor_.end(), 1);
    Editor other;
    other.tell("exit", nullptr);
    EXPECT_EQ(other.end(), 1);
}

TEST_F(LanguageServerCommand, TellsFaultsWhereTheyAreAndTakesThemBack) {
    begin();
    const std::string text =
        "{\"kinegraph\": 1, \"title\": \"\xF0\x9D\x9C\x94 \xC3\xA9\", \"pionts\": {},\n \"bodies\": {}, \"joints\": "
        "[]}";
    editor_.open(uri, text, 3);
    const Json faults = editor_.faults_of(uri, 3);
    ASSERT_FALSE(faults.empty());
    const auto found = std::find_if(faults.begin(), faults.end(), [&](const Json& each) {
        return each["range"]["start"] == position(text, text.find("\"pionts\""));
    });
    ASSERT_NE(found, faults.end()) << faults;
    EXPECT_EQ((*found)["range"]["end"], position(text, text.find(",\n")));
    EXPECT_EQ((*found)["severity"], 1);
    EXPECT_NE((*found)["message"].get<std::string>().find("pionts"), std::string::npos);
    // Sound: nothing is said.
    editor_.tell("textDocument/didChange",
                 {{"textDocument", {{"uri", uri}, {"version", 4}}},
                  {"contentChanges", {{{"text", "{}"}}, {{"text", contents(tests::example_file("four_bar"))}}}}});
    EXPECT_EQ(editor_.faults_of(uri, 4), Json::array());
    editor_.open(uri, "{\"kinegraph\": 1,\n  \"points\": [}", 5);
    const Json syntax = editor_.faults_of(uri, 5);
    ASSERT_EQ(syntax.size(), 1U);
    EXPECT_EQ(syntax[0]["range"]["start"], (Json{{"line", 1}, {"character", 13}}));
    editor_.tell("textDocument/didClose", {{"textDocument", {{"uri", uri}}}});
    EXPECT_EQ(editor_.faults_of(uri, 0), Json::array());
}

TEST_F(LanguageServerCommand, SaysNothingOfOtherFiles) {
    begin();
    editor_.open("file:///package.json", R"({"name": "no mechanism"})", 1);
    EXPECT_EQ(editor_.faults_of("file:///package.json", 1), Json::array());
    editor_.open("file:///new.kinegraph.json", "", 1);
    EXPECT_EQ(editor_.faults_of("file:///new.kinegraph.json", 1).size(), 1U);
    editor_.open("file:///cam.json", contents(tests::example_file("cams/cycloidal_roller")), 1);
    EXPECT_EQ(editor_.faults_of("file:///cam.json", 1), Json::array());
}

TEST_F(LanguageServerCommand, SpeaksTheEditorsLanguageOrItsOwn) {
    begin({{"locale", "de-AT"}});
    editor_.open(uri, "[]", 1);
    Editor french("fr");
    french.ask("initialize", {{"locale", "de"}});
    french.open(uri, "[]", 1);
    const auto file = MechanismFile::parse("[]", "");
    ASSERT_FALSE(file.has_value());
    EXPECT_EQ(editor_.faults_of(uri, 1)[0]["message"], file.error()[0].text.in(Language::de));
    EXPECT_EQ(french.faults_of(uri, 1)[0]["message"], file.error()[0].text.in(Language::fr));
}

// Law: an editor shows the faults of the reader, each at the key that its pointer names.
TEST_F(LanguageServerCommand, TellsTheFaultsOfTheReader) {
    begin();
    int version = 0, at_keys = 0;
    for (const auto& path : tests::json_files(std::filesystem::path(KINEGRAPH_TESTS_DIR) / "broken")) {
        const std::string text = contents(path), name = "file:///broken.kinegraph.json";
        if (Json(text).dump(-1, ' ', false, Json::error_handler_t::ignore) !=
            Json(text).dump(-1, ' ', false, Json::error_handler_t::replace))
            continue;  // not UTF-8: no editor can send it
        const auto file = MechanismFile::parse(text, "");
        editor_.open(name, text, ++version);
        const Json told = editor_.faults_of(name, version);
        if (file || file.error().front().place == "/cam") continue;
        ASSERT_EQ(told.size(), file.error().size()) << path;
        for (std::size_t i = 0; i < told.size(); ++i) {
            EXPECT_EQ(told[i]["message"], file.error()[i].text.in(Language::en)) << path;
            const std::string& place = file.error()[i].place;
            const std::string key = '"' + place.substr(place.rfind('/') + 1) + '"';
            const std::size_t begin = offset(text, told[i]["range"]["start"]);
            EXPECT_LE(begin, offset(text, told[i]["range"]["end"])) << path;
            if (text.substr(begin).starts_with(key)) ++at_keys;
        }
    }
    EXPECT_GT(version, 40);
    EXPECT_GT(at_keys, 20);
}

TEST_F(LanguageServerCommand, ProposesKeysOfTheObject) {
    begin();
    const Names kinds = proposed(four_bar + R"("joints": [{|}]})");
    for (const char* key : {"revolute", "prismatic", "gear", "weld"}) EXPECT_TRUE(has(kinds, key)) << key;
    EXPECT_EQ(proposed(four_bar + R"("joints": [{"revolute": "A", "|"}]})"), (Names{"bodies", "name"}));
    EXPECT_EQ(proposed(four_bar + R"("joints": [{"revolute": "A", "bodies": [2, 1], "|": 1}]})"), Names{"name"});
    EXPECT_EQ(proposed(four_bar + R"("masses": {"2": {}, |}})"), (Names{"1", "rod"}));
    EXPECT_FALSE(has(proposed(four_bar + "|}"), "points")) << "it is there";
    EXPECT_EQ(proposed(four_bar + R"("joints": [] |)"), Names{}) << "a comma is missing";
}

TEST_F(LanguageServerCommand, ProposesValues) {
    begin();
    EXPECT_EQ(proposed(four_bar + R"("joints": [{"revolute": "|"}]})"), (Names{"O", "A"}));
    EXPECT_EQ(proposed(four_bar + R"("joints": [{"revolute": "A", "bodies": [2, |]}]})"), (Names{"1", "rod"}));
    EXPECT_EQ(proposed(four_bar +
                       R"("joints": [{"prismatic": "A"}, {"gear": "P", "name": "mesh"}], "drivers": [{"joint": "|)"),
              (Names{"A", "mesh"}));
    EXPECT_EQ(proposed(R"({"kinegraph": 1, "units": {"length": |)"), (Names{"m", "cm", "mm", "in", "ft"}));
    EXPECT_EQ(proposed(R"({"kinegraph": 1, "points": {"B": {"from": "A", "distance": "4.5e1 |"}}})"),
              (Names{"m", "cm", "mm", "in", "ft"}));
    EXPECT_EQ(proposed(four_bar + R"("drivers": [{"body": 2, "omega": "= 2*|"}]})"), (Names{"r", "k"}));
    EXPECT_EQ(proposed(R"({"kinegraph": 1, "inertia forces": |})"), (Names{"true", "false"}));
    EXPECT_TRUE(has(proposed(R"({"kinegraph": 1, "find": [|]})"), "virtual work"));
}

TEST_F(LanguageServerCommand, WritesWhatElseHasToStandThere) {
    begin();
    EXPECT_EQ(completed("{|}", "kinegraph"), R"({"kinegraph": })");
    EXPECT_EQ(completed("{kine|}", "kinegraph"), R"({"kinegraph": })");
    EXPECT_EQ(completed(R"({"kine|"})", "kinegraph"), R"({"kinegraph": })");
    EXPECT_EQ(completed(R"({"kine|": 1})", "kinegraph"), R"({"kinegraph": 1})");
    EXPECT_EQ(completed("{\"kine|\n", "kinegraph"), "{\"kinegraph\": \n");
    EXPECT_EQ(completed(R"({"kinegraph": 1, "points": {"B": {"distance": "40|"}}})", "mm"),
              R"({"kinegraph": 1, "points": {"B": {"distance": "40 mm"}}})");
    EXPECT_EQ(completed(R"({"kinegraph": 1, "points": {"B": {"distance": "40 m|"}}})", "mm"),
              R"({"kinegraph": 1, "points": {"B": {"distance": "40 mm"}}})");
    EXPECT_EQ(completed(four_bar + R"("drivers": [{"body": 2, "omega": "= 2*xy|/3"}]})", "k"),
              four_bar + R"("drivers": [{"body": 2, "omega": "= 2*k/3"}]})");
    EXPECT_EQ(completed(four_bar + R"("joints": [{"revolute": "A", "bodies": [r|]}]})", "rod"),
              four_bar + R"("joints": [{"revolute": "A", "bodies": ["rod"]}]})");
}

TEST_F(LanguageServerCommand, SaysWhatAKeyMeansAndWhereItStands) {
    begin();
    for (const char* ending : {"\n", "\r\n", "\r"}) {
        const std::string text =
            "{\"kinegraph\": 1," + std::string(ending) + " \"title\": \"\xF0\x9D\x9C\x94\", \"frame\": 1}";
        editor_.open(uri, text);
        const Json answer = editor_.ask(
            "textDocument/hover", {{"textDocument", {{"uri", uri}}}, {"position", {{"line", 1}, {"character", 18}}}});
        const Json& result = answer["result"];
        ASSERT_TRUE(result.is_object()) << answer;
        EXPECT_TRUE(result["contents"]["value"].get<std::string>().starts_with("frame\n\n"));
        EXPECT_EQ(result["range"],
                  (Json{{"start", {{"line", 1}, {"character", 16}}}, {"end", {{"line", 1}, {"character", 23}}}}));
    }
    const std::string text = four_bar + R"("joints": [{"revolute": "A", "bodies": [1, 2]}]})";
    editor_.open(uri, text);
    const Json hinge = editor_.at(uri, text, text.find("revolute"), "hover");
    EXPECT_NE(hinge["contents"]["value"].get<std::string>().find("A hinge."), std::string::npos);
    EXPECT_TRUE(editor_.at(uri, text, text.find("\"O\": [0") + 1, "hover").is_null()) << "a name of the file's own";
    EXPECT_TRUE(editor_.at(uri, text, text.find("[0, 0]"), "hover").is_null());
}

/// A text in quotes of a file: a key, or a value.
struct Quoted {
    std::size_t begin = 0, end = 0;  ///< with the quotes
    std::string word;
    std::string within;  ///< the key of the object in which a key stands, or under which a value does
    bool is_key = false;
};
std::vector<Quoted> quoted_in(const std::string& text) {
    std::vector<Quoted> all;
    std::vector<std::string> keys{""};
    std::string key;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '{' || text[i] == '[') keys.push_back(key);
        if (text[i] == '}' || text[i] == ']') {
            key = keys.back();
            keys.pop_back();
        }
        if (text[i] != '"') continue;
        std::size_t end = i + 1;
        while (text[end] != '"') end += text[end] == '\\' ? 2 : 1;
        const std::string word = text.substr(i + 1, end - i - 1);
        const bool is_key = text[text.find_first_not_of(" \n", end + 1)] == ':';
        all.push_back({i, end + 1, word, is_key ? keys.back() : key, is_key});
        if (is_key) key = word;
        i = end;
    }
    return all;
}

// Law: whatever key or name of an example is taken out, it is proposed in its place, and the key is explained. What the
// file itself calls so (a point, a force, a text in some language) is neither proposed nor explained.
TEST_F(LanguageServerCommand, ProposesWhatTheExamplesSay) {
    begin();
    const std::set<std::string> own_keys{"points", "bodies", "parameters", "constants", "vary", "positions", "planes"};
    const std::set<std::string> names_as_keys{"masses", "profiles", "materials", "velocities", "accelerations"};
    const std::set<std::string> own_texts{"couple", "force", "name", "title", "en", "it", "fr", "de", "es"};
    std::size_t keys = 0, names = 0, number = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(KINEGRAPH_EXAMPLES_DIR)) {
        if (entry.path().extension() != ".json") continue;
        const std::string text = contents(entry.path());
        const Json file = Json::parse(text, nullptr, false);
        if (!file.is_object() || !file.contains("kinegraph") || file.contains("cam")) continue;
        const auto is_in = [&](const char* section, const std::string& word) {
            return file.contains(section) && file[section].is_object() && file[section].contains(word);
        };
        for (const Quoted& each : quoted_in(text)) {
            const bool is_name = is_in("points", each.word) || is_in("bodies", each.word);
            if (++number % 8 != 0 || (each.is_key ? own_keys : own_texts).contains(each.within)) continue;
            if (!each.is_key && !is_name) continue;
            if (each.within == "masses" && file.contains("rotor")) continue;  // there they have names of their own
            const std::string without = text.substr(0, each.begin + 1) + text.substr(each.end - 1);
            editor_.open(uri, without);
            Names labels;
            for (const Json& item : editor_.at(uri, without, each.begin + 1, "completion"))
                labels.push_back(item["label"]);
            EXPECT_TRUE(has(labels, each.word)) << each.word << " in " << each.within << " of " << entry.path();
            ++(each.is_key ? keys : names);
            if (!each.is_key || names_as_keys.contains(each.within)) continue;
            editor_.open(uri, text);
            EXPECT_TRUE(editor_.at(uri, text, each.begin, "hover").is_object()) << each.word << entry.path();
        }
    }
    EXPECT_GT(keys, 400U);
    EXPECT_GT(names, 150U);
}

TEST_F(LanguageServerCommand, AnswersNothingBeforeItIsInitialized) {
    editor_.tell("textDocument/didOpen", {{"textDocument", {{"uri", uri}, {"text", "{"}}}});
    EXPECT_EQ(error_of(editor_.ask("textDocument/hover", Json::object())), -32002);
    EXPECT_EQ(error_of(editor_.ask("shutdown", nullptr)), -32002);
    begin();
    EXPECT_TRUE(editor_.at(uri, "{", 1, "completion").is_null()) << "what was opened before is not known";
}

TEST_F(LanguageServerCommand, RefusesWhatIsNoMessage) {
    begin();
    const std::string deep(200'000, '[');
    for (const std::string& bytes : {std::string("{"), std::string(), std::string("\xff\xfe"),
                                     std::string("{\"id\": 1, \"x\": \"\xc3\"}"), deep}) {
        editor_.send_bytes(frame(bytes));
        EXPECT_EQ(error_of(editor_.told()), -32700) << bytes.substr(0, 30);
    }
    const std::string closed = deep + std::string(200'000, ']');
    for (const std::string& bytes :
         {std::string("[]"), std::string("1"), std::string("{}"), R"({"id": 4})" + std::string(" "),
          std::string(R"({"id": {}, "method": "shutdown"})"), std::string(R"({"method": 5})"),
          R"({"id": )" + closed + R"(, "method": "shutdown"})", closed}) {
        editor_.send_bytes(frame(bytes));
        if (bytes.starts_with(R"({"id": 4})")) continue;  // an answer, to nothing
        EXPECT_EQ(error_of(editor_.told()), -32600) << bytes.substr(0, 30);
    }
    for (const char* bytes : {"null", "5", R"({"position": 1})", R"({"position": {"line": -1, "character": 0}})",
                              R"({"position": {"line": 1.5, "character": 0}})", R"({"position": {"line": "0"}})"})
        for (const char* method : {"textDocument/hover", "textDocument/completion"})
            EXPECT_EQ(error_of(editor_.ask(method, Json::parse(bytes))), -32602) << bytes;
    for (const char* method :
         {"textDocument/didOpen", "textDocument/didChange", "textDocument/didClose", "$/cancelRequest", "other"})
        for (const char* bytes :
             {"null", "[]", "{}", R"({"textDocument": 7})", R"({"textDocument": {"uri": 3, "text": 4}})",
              R"({"textDocument": {"uri": "a"}, "contentChanges": [4]})"})
            editor_.tell(method, Json::parse(bytes));
    editor_.open(uri, "{}");
    const Json beyond =
        editor_.ask("textDocument/completion",
                    {{"textDocument", {{"uri", uri}}},
                     {"position", {{"line", 18446744073709551615U}, {"character", 18446744073709551615U}}}});
    EXPECT_TRUE(beyond["result"].is_array());
}

TEST_F(LanguageServerCommand, LeavesOutWhatIsTooLargeAndGoesOn) {
    begin();
    editor_.send_bytes("content-LENGTH:   9000000\r\nContent-Type: text\r\n\r\n");
    const std::string piece(100'000, 'x');
    for (int i = 0; i < 90; ++i) editor_.send_bytes(piece);
    EXPECT_EQ(error_of(editor_.told()), -32600);
    EXPECT_TRUE(editor_.ask("shutdown", nullptr).contains("result"));
}

TEST_F(LanguageServerCommand, GivesUpWhereItCannotTellTheNextMessage) {
    for (const std::string& head :
         {std::string("\r\n\r\n"), std::string("Content-Length: x\r\n\r\n"), std::string("Content-Length: -1\r\n\r\n"),
          std::string("Content-Length: 99999999999999999999999\r\n\r\n"),
          std::string("Content-Length: 1\r\nContent-Length: 2\r\n\r\n"), std::string(5000, 'x'),
          "Content-Length: 2\r\n" + std::string(5000, 'x') + "\r\n\r\n{}"}) {
        Editor editor;
        editor.send_bytes(head);
        EXPECT_TRUE(editor.told().is_null()) << head.substr(0, 40);
        EXPECT_EQ(editor.end(), 2) << head.substr(0, 40);
    }
}

// Files that are being typed, that is, cut off anywhere or with a piece taken out.
TEST_F(LanguageServerCommand, EnduresEveryTextThatIsTyped) {
    begin();
    int version = 0;
    for (const char* name : {"four_bar", "truss_simple", "cam_roller_follower", "motion/spiral", "variants/four_bar"}) {
        const std::string whole = contents(tests::example_file(name));
        ASSERT_GT(whole.size(), 100U) << name;
        for (std::size_t cut = 0; cut < whole.size(); cut += 29) {
            for (const std::string& text : {whole.substr(0, cut), whole.substr(cut),
                                            whole.substr(0, cut) + whole.substr(std::min(cut + 9, whole.size()))}) {
                const std::string valid = Json(text).dump(-1, ' ', false, Json::error_handler_t::ignore);
                const std::string typed = Json::parse(valid).get<std::string>();
                editor_.open(uri, typed, ++version);
                const std::size_t at = std::min(cut, typed.size());
                EXPECT_TRUE(editor_.at(uri, typed, at, "completion").is_array());
                const Json meaning = editor_.at(uri, typed, at, "hover");
                EXPECT_TRUE(meaning.is_null() || meaning.is_object());
            }
        }
    }
    EXPECT_TRUE(editor_.faults_of(uri, version).is_array());
    const std::string deep(100'000, '['), objects = "{\"kinegraph\": 1, \"a\": " + deep;
    for (const std::string& text : {deep, objects, std::string("\"\\"), std::string("{\"a\":\"\\u12"),
                                    std::string(1, '\0'), std::string("]}]}")}) {
        editor_.open(uri, text, ++version);
        EXPECT_TRUE(editor_.at(uri, text, text.size(), "completion").is_array());
        EXPECT_TRUE(editor_.faults_of(uri, version).is_array());
    }
    EXPECT_TRUE(editor_.ask("shutdown", nullptr).contains("result"));
}

}  // namespace
}  // namespace kinegraph::language_server_test
