// Quizzes of learning platforms, read back: XML by a parser, cloze fields by Moodle's grammar, packages by the
// directory of the zip; every answer held against the results.
#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <regex>
#include <set>

#include "constructions/positions/variants.hpp"
#include "engine/sentences/result_catalogue.hpp"
#include "render/backends/quiz_files.hpp"
#include "render/sheet/handout.hpp"
#include "render/text/html.hpp"
#include "tests/support/command_line.hpp"
#include "tests/support/fonts.hpp"
#include "tests/support/pages.hpp"

namespace kinegraph::tests::quiz_test {
namespace {

using Json = nlohmann::json;

double number_in(const std::string& text) {
    double value = std::nan("");
    const auto end = std::from_chars(text.data(), text.data() + text.size(), value).ptr;
    EXPECT_EQ(end, text.data() + text.size()) << text << " is no number";
    return value;
}

pugi::xml_document read_xml(const std::string& text, const std::string& what) {
    pugi::xml_document document;
    const pugi::xml_parse_result read =
        document.load_buffer(text.data(), text.size(), pugi::parse_default | pugi::parse_ws_pcdata);
    EXPECT_TRUE(read) << what << ": " << read.description() << " at " << read.offset;
    return document;
}

// --- Moodle's cloze fields
// ----------------------------------------------------------------------------------------------------

/// {1:NUMERICAL:=12.5:0.3}, by the grammar of embedded answers: a weight, a type, alternatives parted by ~, each with a
/// share of the points, an answer with its tolerance after a colon, and feedback after #.
struct ClozeField {
    int weight = 0;
    std::string type;
    struct Alternative {
        std::string share, answer, tolerance, feedback;
    };
    std::vector<Alternative> alternatives;
};
class ClozeReader {
public:
    explicit ClozeReader(std::string text) : text_(std::move(text)) {}

    std::vector<ClozeField> fields() {
        static const std::regex start(R"(\{\s*(\d*)\s*:(NUMERICAL|NM|MULTICHOICE|MC|SHORTANSWER|SA|MW):)");
        std::vector<ClozeField> all;
        for (std::size_t at = 0; at < text_.size();) {
            std::smatch match;
            if (!std::regex_search(text_.cbegin() + static_cast<std::ptrdiff_t>(at), text_.cend(), match, start)) break;
            ClozeField field{match[1].length() == 0 ? 1 : std::stoi(match[1]), match[2], {}};
            at += static_cast<std::size_t>(match.position() + match.length());
            at = read_alternatives(at, field);
            all.push_back(std::move(field));
        }
        return all;
    }

private:
    /// Up to the brace that closes the field.
    std::size_t read_alternatives(std::size_t at, ClozeField& field) {
        for (;;) {
            ClozeField::Alternative& each = field.alternatives.emplace_back();
            static const std::regex share("=|%-?\\d+(?:[.,]\\d*)?%");
            std::smatch match;
            if (std::regex_search(text_.cbegin() + static_cast<std::ptrdiff_t>(at), text_.cend(), match, share,
                                  std::regex_constants::match_continuous)) {
                each.share = match.str();
                at += match.str().size();
            }
            at = read_to(at, "~#}", each.answer);
            if (at < text_.size() && text_[at] == '#') at = read_to(at + 1, "~}", each.feedback);
            const std::size_t colon = each.answer.find(':');
            if (colon != std::string::npos) {
                each.tolerance = each.answer.substr(colon + 1);
                each.answer.resize(colon);
            }
            if (at >= text_.size()) ADD_FAILURE() << "a field is not closed";
            if (at >= text_.size() || text_[at] == '}') return at + 1;
            ++at;
        }
    }
    std::size_t read_to(std::size_t at, std::string_view ends, std::string& into) const {
        for (; at < text_.size() && ends.find(text_[at]) == std::string_view::npos; ++at) {
            if (text_[at] == '\\' && at + 1 < text_.size()) ++at;
            into += text_[at];
        }
        return at;
    }

    std::string text_;
};

std::string from_base64(const std::string& text) {
    static const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned bits = 0, count = 0;
    for (const char c : text) {
        if (c == '=') break;
        const std::size_t digit = digits.find(c);
        if (digit == std::string::npos) ADD_FAILURE() << "no base64: " << c;
        bits = bits << 6U | static_cast<unsigned>(digit);
        if ((count += 6) >= 8) {
            count -= 8;
            bytes += static_cast<char>(bits >> count & 255U);
        }
    }
    return bytes;
}

TEST(Base64, IsThatOfTheStandard) {
    for (const auto& [bytes, text] : std::vector<std::pair<std::string, std::string>>{{"", ""},
                                                                                      {"f", "Zg=="},
                                                                                      {"fo", "Zm8="},
                                                                                      {"foo", "Zm9v"},
                                                                                      {"foobar", "Zm9vYmFy"},
                                                                                      {"\xFF\xFE\x00", "//4="}})
        EXPECT_EQ(render::base64(bytes), text);
    std::string all;
    for (int c = 0; c < 256; ++c) all += static_cast<char>(c);
    EXPECT_EQ(from_base64(render::base64(all)), all);
}

TEST(Html, IsWellFormedWhateverANameHolds) {
    const std::string nasty = "<b>&\"'{1:SA:=x}#~/\\]]> \x01 \xFF é";
    render::RichText text = render::one_piece(nasty, render::Face::bold_italic);
    text.back().sub = "<&>";
    text.back().sup = "{}";
    text.back().dots = 1;
    append(text, std::string("a\nb"));
    const std::string html = render::to_html(text);
    const auto document = read_xml("<p>" + html + "</p>", "html");
    EXPECT_EQ(document.child("p").child("b").child("i").text().get(),
              std::string("<b>&\"'{1:SA:=x}#~/\\]]> \uFFFD \uFFFD é\u0307"));
    EXPECT_EQ(document.child("p").child("sub").child("i").text().get(), std::string("<&>"));
    EXPECT_TRUE(document.child("p").child("br"));
    EXPECT_EQ(html.find_first_of("{}"), std::string::npos) << "nothing that a platform reads as a field";
}

// --- items
// --------------------------------------------------------------------------------------------------------------------

std::vector<render::RequestedResult> asked_of(const Variant& variant) {
    const Units& units = variant.solution.mechanism.units;
    std::vector<render::RequestedResult> asked;
    for (const NamedResult& each : variant.results) {
        const double size = each.unit.empty() ? unit_of(each.column.unit, units).si.to_double() : 1;
        asked.push_back({each.column, each.value, told(each, units).unit, size});
    }
    return asked;
}

class QuizOf : public testing::TestWithParam<const char*> {};

TEST_P(QuizOf, AsksForItsResultsAndTellsTheSolution) {
    const std::string text =
        contents(fs::path(KINEGRAPH_EXAMPLES_DIR) / "variants" / (GetParam() + std::string(".json")));
    auto variants = Variants::of(text, "test.json", {}, 7);
    ASSERT_TRUE(variants);
    const auto found = variants->next([](const Solution&, Condition::Polygon) { return true; });
    ASSERT_TRUE(found && *found);
    const Variant& variant = **found;
    for (const Language language : {Language::en, Language::it}) {
        render::SheetOptions options;
        options.kind = render::SheetKind::question;
        options.language = language;
        render::QuizItem item = render::quiz_item_of(variant.solution, asked_of(variant), options, tests::fonts());
        item.number = "001";
        ASSERT_EQ(item.blanks.size(), variant.results.size());
        for (std::size_t i = 0; i < item.blanks.size(); ++i) {
            const render::QuizBlank& blank = item.blanks[i];
            const ToldResult result = told(variant.results[i], variant.solution.mechanism.units);
            const double tolerance = number_in(blank.tolerance);
            EXPECT_EQ(blank.name, variant.results[i].column.name);
            EXPECT_EQ(blank.unit, result.unit);
            EXPECT_LE(std::abs(number_in(blank.value) - result.value), 0.01 * tolerance) << blank.name;
            EXPECT_TRUE(tolerance > 0 || result.value == 0) << blank.name;
            EXPECT_EQ(blank.tolerance.find('e'), std::string::npos) << blank.tolerance << ": as people write it";
            EXPECT_LE(tolerance, 0.25 * std::abs(result.value)) << blank.name << ": a reading that says nothing";
            EXPECT_FALSE(blank.words.empty() || blank.symbol.empty()) << blank.name;
            EXPECT_EQ(render::plain(blank.words).find("{"), std::string::npos) << render::plain(blank.words);
        }
        EXPECT_GT(item.solution.size(), 1U) << "by step";
        EXPECT_GT(item.figure.marks.size(), 10U);
        const auto moodle =
            read_xml(render::moodle_head("x") + render::moodle_question(item, "png") + render::moodle_tail(), "moodle");
        const pugi::xml_node cloze = moodle.child("quiz").find_child_by_attribute("question", "type", "cloze");
        const std::string body = cloze.child("questiontext").child_value("text");
        read_xml("<div>" + body + "</div>", "question text");
        read_xml("<div>" + std::string(cloze.child("generalfeedback").child_value("text")) + "</div>", "feedback");
        EXPECT_EQ(ClozeReader(body).fields().size(), item.blanks.size());
        read_xml(render::qti_item(item), "qti");
    }
}

INSTANTIATE_TEST_SUITE_P(Examples, QuizOf,
                         testing::Values("four_bar", "slider_crank", "quick_return", "six_bar", "planetary_train",
                                         "sluice_gate", "truss", "cam", "impact", "exam"),
                         [](const auto& each) { return std::string(each.param); });

TEST(Sought, IsWhatTheFileAsksFor) {
    const Solution solution = [] {
        const std::string text = contents(fs::path(KINEGRAPH_EXAMPLES_DIR) / "variants" / "sluice_gate.json");
        auto mechanism = read_mechanism(text, "test.json");
        return *solve(*std::move(mechanism));
    }();
    render::SheetOptions options;
    options.kind = render::SheetKind::question;
    const auto question = render::lay_out(solution, options, tests::fonts());
    EXPECT_TRUE(pages::says(question, "of body 0 on body 1 at A"));
    EXPECT_FALSE(pages::says(question, "the reactions at the joints"));
    options.language = Language::it;
    EXPECT_TRUE(pages::says(render::lay_out(solution, options, tests::fonts()), "del corpo 0 sul corpo 1 in A"));
}

// --- what the command writes
// --------------------------------------------------------------------------------------------------

/// The files of an archive whose entries are stored as they are, by its central directory.
std::map<std::string, std::string> unpacked(const std::string& zip, std::set<std::string>& dates) {
    const auto little = [&](std::size_t at, int bytes) {
        std::size_t value = 0;
        for (int i = bytes; i-- > 0;)
            value = value << 8U | static_cast<unsigned char>(zip.at(at + static_cast<std::size_t>(i)));
        return value;
    };
    std::map<std::string, std::string> files;
    const std::size_t end = zip.rfind("PK\x05\x06");
    if (end == std::string::npos) return files;
    std::size_t at = little(end + 16, 4);
    for (std::size_t count = little(end + 10, 2); count-- > 0;) {
        EXPECT_EQ(zip.substr(at, 4), "PK\x01\x02");
        EXPECT_EQ(little(at + 10, 2), 0U) << "stored";
        dates.insert(zip.substr(at + 12, 4));
        const std::size_t size = little(at + 24, 4), name = little(at + 28, 2), local = little(at + 42, 4);
        const std::size_t begin = local + 30 + little(local + 26, 2) + little(local + 28, 2);
        EXPECT_TRUE(files.emplace(zip.substr(at + 46, name), zip.substr(begin, size)).second);
        at += 46 + name + little(at + 30, 2) + little(at + 32, 2);
    }
    return files;
}

std::vector<std::vector<std::string>> cells_of(const std::string& csv) {
    std::vector<std::vector<std::string>> rows(1);
    bool quoted = false;
    rows.back().emplace_back();
    for (std::size_t i = 0; i < csv.size(); ++i) {
        if (csv[i] == '"' && quoted && i + 1 < csv.size() && csv[i + 1] == '"')
            rows.back().back() += csv[++i];
        else if (csv[i] == '"')
            quoted = !quoted;
        else if (csv[i] == ',' && !quoted)
            rows.back().emplace_back();
        else if (csv[i] == '\n' && !quoted)
            rows.emplace_back(1);
        else
            rows.back().back() += csv[i];
    }
    rows.pop_back();
    return rows;
}

class QuizFiles : public CommandLine {
protected:
    void SetUp() override {
        CommandLine::SetUp();
        std::string text = contents(fs::path(KINEGRAPH_EXAMPLES_DIR) / "variants" / "planetary_train.json");
        const std::string title = "\"en\": \"";
        text.insert(text.find(title) + title.size(), "A/B <&> {1:SA:=x} ~#\\\\ ");
        write("train.json", text);
        write("students.csv", "name\n\"O'Neil <&\"\"> {#1}\"\nAnna\n");
    }
    /// "omega 3 [rad/s]" → -8, by variant.
    std::vector<std::map<std::string, std::string>> key() const {
        const auto cells = cells_of(contents(folder_ / "out" / "key.csv"));
        std::vector<std::map<std::string, std::string>> rows;
        for (std::size_t r = 1; r < cells.size(); ++r) {
            rows.emplace_back();
            for (std::size_t c = 0; c < cells[r].size(); ++c) rows.back()[cells[0][c]] = cells[r][c];
        }
        return rows;
    }
    const std::vector<std::string> asked_{"omega 3 [rad/s]", "omega 4 [rad/s]", "v C [m/s]"};
};

TEST_F(QuizFiles, AreReadBackAndAnswerByTheKey) {
    const Outcome made =
        run("variants train.json --seed 7 --roster students.csv --format svg --for moodle,qti --for csv -o out");
    ASSERT_EQ(made.status, 0) << made.err;
    const auto key = this->key();
    ASSERT_EQ(key.size(), 2U);

    // Moodle.
    const auto moodle = read_xml(contents(folder_ / "out" / "moodle.xml"), "moodle.xml");
    const pugi::xml_node quiz = moodle.child("quiz");
    EXPECT_EQ(quiz.child("question").child("category").child_value("text"),
              "$course$/top/A//B <&> {1:SA:=x} ~#\\ Planetary gear train" + std::string());
    std::vector<pugi::xml_node> questions;
    for (const pugi::xml_node each : quiz.children("question"))
        if (each.attribute("type").value() == std::string("cloze")) questions.push_back(each);
    ASSERT_EQ(questions.size(), 2U);
    EXPECT_EQ(questions[0].child("name").child_value("text"),
              std::string("A/B <&> {1:SA:=x} ~#\\ Planetary gear train 001 · O'Neil <&\"> {#1}"));
    std::vector<std::vector<std::pair<double, double>>> by_moodle;
    for (std::size_t v = 0; v < questions.size(); ++v) {
        const pugi::xml_node text = questions[v].child("questiontext");
        const std::string body = text.child_value("text"), figure = text.child("file").attribute("name").value();
        EXPECT_EQ(from_base64(text.child_value("file")).substr(0, 8), "\x89PNG\r\n\x1A\n");
        EXPECT_NE(body.find("src=\"@@PLUGINFILE@@/" + figure + "\""), std::string::npos);
        const auto fields = ClozeReader(body).fields();
        ASSERT_EQ(fields.size(), asked_.size());
        auto& told = by_moodle.emplace_back();
        for (std::size_t i = 0; i < fields.size(); ++i) {
            EXPECT_EQ(fields[i].type, "NUMERICAL");
            ASSERT_EQ(fields[i].alternatives.size(), 1U);
            const ClozeField::Alternative& answer = fields[i].alternatives.front();
            EXPECT_EQ(answer.share, "=");
            told.emplace_back(number_in(answer.answer), number_in(answer.tolerance));
            EXPECT_LE(std::abs(told.back().first - number_in(key[v].at(asked_[i]))), 0.01 * told.back().second)
                << asked_[i];
        }
        EXPECT_NE(body.find("rad/s"), std::string::npos) << "the unit stands behind its field";
    }

    // QTI.
    std::set<std::string> dates;
    const auto package = unpacked(contents(folder_ / "out" / "qti.zip"), dates);
    EXPECT_EQ(dates.size(), 1U) << "no clock in it";
    ASSERT_TRUE(package.contains("imsmanifest.xml"));
    const auto manifest = read_xml(package.at("imsmanifest.xml"), "imsmanifest.xml");
    EXPECT_TRUE(manifest.child("manifest").attribute("identifier"));
    EXPECT_TRUE(manifest.child("manifest").child("organizations"));
    std::size_t v = 0, listed = 1;
    for (const pugi::xml_node resource : manifest.child("manifest").child("resources").children("resource")) {
        EXPECT_EQ(resource.attribute("type").value(), std::string("imsqti_item_xmlv2p1"));
        for (const pugi::xml_node file : resource.children("file")) {
            ++listed;
            EXPECT_TRUE(package.contains(file.attribute("href").value())) << file.attribute("href").value();
        }
        ASSERT_LT(v, key.size());
        const auto document = read_xml(package.at(resource.attribute("href").value()), "item");
        const pugi::xml_node item = document.child("assessmentItem");
        for (const char* required : {"identifier", "title", "adaptive", "timeDependent"})
            EXPECT_TRUE(item.attribute(required));
        EXPECT_EQ(item.attribute("identifier").value(), std::string(resource.attribute("identifier").value()));
        const pugi::xml_node body = item.child("itemBody");
        const auto figure = body.select_node(".//img").node();
        EXPECT_TRUE(package.contains(figure.attribute("src").value()) && figure.attribute("alt"));
        const auto entries = body.select_nodes(".//textEntryInteraction");
        const auto conditions = item.child("responseProcessing").children("responseCondition");
        ASSERT_EQ(entries.size(), asked_.size());
        auto condition = conditions.begin();
        std::size_t i = 0;
        for (const pugi::xml_node declared : item.children("responseDeclaration")) {
            ASSERT_LT(i, asked_.size());
            const std::string name = declared.attribute("identifier").value();
            EXPECT_EQ(declared.attribute("cardinality").value(), std::string("single"));
            EXPECT_EQ(declared.attribute("baseType").value(), std::string("float"));
            EXPECT_EQ(entries[i].node().attribute("responseIdentifier").value(), name);
            EXPECT_EQ(number_in(declared.child("correctResponse").child_value("value")), by_moodle[v][i].first);
            const pugi::xml_node equal = condition->child("responseIf").child("equal");
            EXPECT_EQ(equal.attribute("toleranceMode").value(), std::string("absolute"));
            const std::string off = equal.attribute("tolerance").value();
            EXPECT_EQ(number_in(off.substr(0, off.find(' '))), by_moodle[v][i].second);
            EXPECT_EQ(off.substr(0, off.find(' ')), off.substr(off.find(' ') + 1));
            EXPECT_EQ(equal.child("variable").attribute("identifier").value(), name);
            EXPECT_EQ(equal.child("correct").attribute("identifier").value(), name);
            EXPECT_EQ(condition->child("responseIf").child("setOutcomeValue").attribute("identifier").value(),
                      std::string("SCORE"));
            ++condition;
            ++i;
        }
        EXPECT_EQ(i, asked_.size());
        std::set<std::string> outcomes;
        for (const pugi::xml_node each : item.children("outcomeDeclaration"))
            outcomes.insert(each.attribute("identifier").value());
        EXPECT_EQ(outcomes, (std::set<std::string>{"SCORE", "MAXSCORE", "FEEDBACK"}));
        EXPECT_EQ(item.child("modalFeedback").attribute("outcomeIdentifier").value(), std::string("FEEDBACK"));
        EXPECT_TRUE(item.child("modalFeedback").child("ol"));
        ++v;
    }
    EXPECT_EQ(v, 2U);
    EXPECT_EQ(listed, package.size()) << "nothing that the manifest does not name";

    // CSV.
    const auto rows = cells_of(contents(folder_ / "out" / "answers.csv"));
    ASSERT_EQ(rows.size(), 3U);
    const std::vector<std::string> head{"variant",
                                        "name",
                                        "seed",
                                        "m",
                                        "z2",
                                        "z3",
                                        "phi",
                                        "w",
                                        "omega 3",
                                        "omega 3 unit",
                                        "omega 3 tolerance",
                                        "omega 4",
                                        "omega 4 unit",
                                        "omega 4 tolerance",
                                        "v C",
                                        "v C unit",
                                        "v C tolerance",
                                        "question",
                                        "solution",
                                        "results",
                                        "file"};
    EXPECT_EQ(rows[0], head);
    for (std::size_t r = 1; r < rows.size(); ++r) {
        ASSERT_EQ(rows[r].size(), head.size());
        EXPECT_EQ(rows[r][2], "7");
        for (std::size_t i = 0; i < asked_.size(); ++i) {
            EXPECT_EQ(number_in(rows[r][8 + 3 * i]), by_moodle[r - 1][i].first);
            EXPECT_EQ(number_in(rows[r][10 + 3 * i]), by_moodle[r - 1][i].second);
        }
        for (std::size_t c = 17; c < head.size(); ++c) EXPECT_TRUE(is_there("out/" + rows[r][c])) << rows[r][c];
    }
    EXPECT_EQ(rows[1][1], "O'Neil <&\"> {#1}");
}

TEST_F(QuizFiles, AreTheSameBytesEverywhere) {
    ASSERT_EQ(run("variants train.json --count 1 --format svg --for qti --for moodle -o out").status, 0);
    ASSERT_EQ(run("variants train.json --count 1 --format svg --for qti --for moodle -o there",
                  "export TZ=Asia/Tokyo LC_ALL=C;")
                  .status,
              0);
    for (const char* name : {"/qti.zip", "/moodle.xml"})
        EXPECT_EQ(contents(folder_ / ("out" + std::string(name))), contents(folder_ / ("there" + std::string(name))));
    const Outcome wrong = run("variants train.json --count 1 --for moodel -o other");
    EXPECT_EQ(wrong.status, 2);
    EXPECT_FALSE(is_there("other"));
}

}  // namespace
}  // namespace kinegraph::tests::quiz_test
