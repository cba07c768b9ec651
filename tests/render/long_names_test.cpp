// Names that are words: lists keep them apart, tables keep to their columns, and a sheet of them to its frame.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "render/sheet/sheet.hpp"
#include "render/tables/long_names.hpp"
#include "render/text/words.hpp"
#include "tests/support/fonts.hpp"
#include "tests/support/page_checker.hpp"
#include "tests/support/random_mechanism.hpp"
#include "tests/support/solved.hpp"

namespace kinegraph::render::long_names_test {
namespace {

using Json = nlohmann::ordered_json;
using tests::fonts;

/// A file with every point and body called by so many letters.
class Lengthened {
public:
    Lengthened(const std::string& text, std::size_t letters) : file_(Json::parse(text)), letters_(letters) {
        for (const auto& [name, place] : file_["points"].items()) names_.insert(name);
        for (const auto& [name, body] : file_["bodies"].items()) names_.insert(name);
        if (file_.contains("frame")) names_.insert(named(file_["frame"]));
        file_.erase("ask");
        file_.erase("exercise");
    }
    std::string text() const { return renamed(file_, false).dump(); }

private:
    static std::string named(const Json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }
    std::string longer(const std::string& name) const {
        const std::string words = name + " of the linkage that is drawn here and of no other";
        return names_.contains(name) ? words.substr(0, letters_) : name;
    }
    /// Numbers stand for bodies under some keys only.
    Json renamed(const Json& value, bool of_bodies) const {
        if (value.is_string() || (of_bodies && value.is_number_integer())) {
            const std::string longer_name = longer(named(value));
            return longer_name == named(value) ? value : Json(longer_name);
        }
        if (value.is_array()) {
            Json all = Json::array();
            for (const Json& each : value) all.push_back(renamed(each, of_bodies));
            return all;
        }
        if (!value.is_object()) return value;
        static const std::set<std::string> of_these{"frame", "body", "bodies", "relative to", "from", "on", "observer"};
        Json all = Json::object();
        for (const auto& [key, each] : value.items())
            all[key == "frame" ? key : longer(key)] = key == "title" ? each : renamed(each, of_these.contains(key));
        return all;
    }

    Json file_;
    std::size_t letters_;
    std::set<std::string> names_;
};

TEST(LongNames, StandApartWhereTheyNameALine) {
    const auto line = [](const std::string& from, const std::string& to) {
        return plain(typeset(LineReason{LineReason::Kind::perpendicular_to_segment, from, to}, Language::it));
    };
    EXPECT_EQ(line("A", "B"), "⟂\u00A0AB");
    EXPECT_EQ(line("O2", "A'"), "⟂\u00A0O_2A′");
    EXPECT_EQ(line("perno", "B"), "⟂\u00A0perno – B");
    EXPECT_EQ(line("A", "cerniera"), "⟂\u00A0A – cerniera");
}

TEST(LongNames, AreBrokenOrCutInACell) {
    constexpr double room = 30;
    const RichText words = one_piece("hinge between the coupler and the rocker"),
                   word = one_piece(std::string(60, 'm'));
    EXPECT_GT(lines_in_cell(words, 9, fonts(), room).size(), 1U);
    for (const RichText& each : {words, word})
        for (const ShapedLine& line : lines_in_cell(each, 9, fonts(), room)) EXPECT_LE(line.width, room);
    EXPECT_LE(line_in_cell(word, 9, fonts(), room).width, room);
    EXPECT_EQ(plain(line_in_cell(one_piece("A"), 9, fonts(), room).text), "A");
}

// In brief a polygon keeps the scale of the whole solution where it can: with a long name it may have to come coarser.
TEST(LongNames, HaveASheetInBriefToo) {
    const std::string short_name = "\"B\"";
    for (const std::size_t letters : {40U, 80U, 120U, 150U}) {
        std::string text = tests::contents(tests::example_file("four_bar"));
        const std::string long_name = "\"" + std::string(letters, 'x') + "\"";
        for (std::size_t at = 0; (at = text.find(short_name, at)) != std::string::npos; at += long_name.size())
            text.replace(at, short_name.size(), long_name);
        Json file = Json::parse(text);
        file.erase("ask");
        file.erase("exercise");
        const Solution solution = tests::solved(file.dump());
        for (const Paper paper : {Paper::a4, Paper::letter})
            for (const Orientation orientation : {Orientation::landscape, Orientation::portrait}) {
                SheetOptions options;
                options.detail = SolutionDetail::brief;
                options.paper = paper;
                options.orientation = orientation;
                EXPECT_FALSE(lay_out(solution, options, fonts()).empty()) << letters;
            }
    }
}

// Sentences, lists and tables; names in figures find places of their own.
TEST(LongNames, OfTextLeaveNoPageAndCoverNothing) {
    constexpr std::size_t letters = 30;
    std::map<Fault::Kind, int> counts;
    std::string first;
    int sheets = 0;
    std::size_t turn = 0;
    for (const std::string& name : tests::example_names()) {
        if (++turn % unless_sanitized(1, 3) != 0) continue;
        const std::string text = tests::contents(tests::example_file(name));
        if (!Json::parse(text).contains("bodies")) continue;
        auto mechanism = read_mechanism(Lengthened(text, letters).text(), name);
        if (!mechanism) continue;  // what stands in expressions and laws is not renamed
        const auto solution = solve(*std::move(mechanism));
        if (!solution) continue;
        SheetOptions options;
        options.language = turn % 2 == 0 ? Language::en : Language::it;
        options.orientation = static_cast<Orientation>(turn / 2 % 2);
        ++sheets;
        for (const Page& page : lay_out(*solution, options, fonts()))
            for (const Fault& fault : faults_of(page, fonts())) {
                if (fault.figure != "text") continue;
                ++counts[fault.kind];
                if (first.size() < 4000) first += name + ", " + said(fault) + "\n";
            }
    }
    EXPECT_GT(sheets, unless_sanitized(40, 13));
    EXPECT_EQ(counts, (std::map<Fault::Kind, int>{})) << first;
}

}  // namespace
}  // namespace kinegraph::render::long_names_test
