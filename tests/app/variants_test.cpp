// variants, and sweep --over, as a user meets them.
#include <algorithm>
#include <cmath>
#include <csignal>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "tests/support/command_line.hpp"

namespace kinegraph::tests::variants_test {
namespace {

using Json = nlohmann::json;

class VariantsCommand : public CommandLine {
protected:
    void SetUp() override {
        CommandLine::SetUp();
        fs::copy(fs::path(KINEGRAPH_EXAMPLES_DIR) / "variants" / "planetary_train.json", folder_ / "train.json");
    }
    std::map<std::string, std::string> files_of(const std::string& folder) const {
        std::map<std::string, std::string> files;
        for (const auto& entry : fs::directory_iterator(folder_ / folder))
            if (entry.is_regular_file()) files[entry.path().filename().string()] = contents(entry.path());
        return files;
    }
};
class SweepOver : public CommandLine {};

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

TEST_F(VariantsCommand, WritesSheetsResultsFilesAndKeys) {
    write("students.csv", "name,surname\nAnna,Rossi\n\"Bruno\",\"De \"\"Santis\"\"\"\n");
    const Outcome made =
        run("variants train.json --seed 7 --roster students.csv -o out/ --format svg --date 2026-11-23");
    ASSERT_EQ(made.status, 0) << made.err;
    const auto files = files_of("out");
    for (const char* name : {"001.json", "001-question.svg", "001-solution.svg", "001-results.json", "002.json",
                             "002-question.svg", "002-solution.svg", "002-results.json", "key.csv", "key.pdf"})
        EXPECT_TRUE(files.contains(name)) << name;
    EXPECT_NE(files.at("001-question.svg").find("Anna Rossi"), std::string::npos) << "in the title block";
    EXPECT_EQ(files.at("001-question.svg").find("De \"Santis\""), std::string::npos);
    EXPECT_EQ(files.at("key.pdf").substr(0, 5), "%PDF-");
    const auto key = lines_of(files.at("key.csv"));
    ASSERT_EQ(key.size(), 3U);
    EXPECT_EQ(key[0], "variant,name,m,z2,z3,phi,w,omega 3 [rad/s],omega 4 [rad/s],v C [m/s]");
    EXPECT_TRUE(key[1].starts_with("001,Anna Rossi,2 mm,24,18,120°,12 rad/s,-8,")) << key[1];
    EXPECT_TRUE(key[2].starts_with("002,\"Bruno De \"\"Santis\"\"\",")) << key[2];
    // The results are those of the file that stands beside them.
    const Outcome solved = run("solve out/001.json -o again.json");
    EXPECT_EQ(solved.status, 0) << solved.err;
    EXPECT_EQ(contents(folder_ / "again.json"), files.at("001-results.json"));
    EXPECT_EQ(Json::parse(files.at("001-results.json"))["bodies"]["3"]["omega"], -8);
    EXPECT_TRUE(lines_are(
        made.err, R"(train\.json: (2 variants in out/; \d+ of 8316 combinations were looked at|\d+ rejected: .*))"))
        << made.err;
}

TEST_F(VariantsCommand, GivesTheSameBytesAndMerges) {
    ASSERT_EQ(run("variants train.json --count 1 --seed 3 -o one --merge").status, 0);
    ASSERT_EQ(run("variants train.json --count 2 --seed 3 -o two --merge").status, 0);
    ASSERT_EQ(run("variants train.json --count 2 --seed 3 -o again --merge").status, 0);
    EXPECT_EQ(files_of("two"), files_of("again"));
    const auto one = files_of("one"), two = files_of("two");
    EXPECT_EQ(one.at("001.json"), two.at("001.json"));
    EXPECT_TRUE(two.contains("questions.pdf") && two.contains("solutions.pdf"));
    EXPECT_FALSE(two.contains("001-question.pdf"));
}

/// The figures with a scale on a page, without details: "velocity 0.02".
std::vector<std::string> scales_on(const std::string& svg) {
    static const std::regex figure(
        R"rx(<g class="figure" id="([^"]*)" data-figure="(?!detail)[^"]*" data-scale="([^"]*)")rx");
    std::vector<std::string> scales;
    for (std::sregex_iterator at(svg.begin(), svg.end(), figure), end; at != end; ++at)
        scales.push_back((*at)[1].str() + " " + (*at)[2].str());
    return scales;
}

TEST_F(VariantsCommand, GivesAClassTheSameScalesAndWholeSheetsOfPaper) {
    fs::copy(fs::path(KINEGRAPH_EXAMPLES_DIR) / "variants" / "four_bar.json", folder_ / "class.json");
    constexpr int copies = 8;
    std::set<std::vector<std::string>> apart, together;
    for (const bool as_class : {false, true}) {
        const std::string folder = as_class ? "class" : "each";
        const Outcome made = run("variants class.json --count " + std::to_string(copies) + " -o " + folder +
                                 " --format svg" + (as_class ? " --class" : ""));
        ASSERT_EQ(made.status, 0) << made.err;
        std::map<std::string, std::size_t> pages;
        std::map<std::string, std::vector<std::string>> scales;
        for (const auto& [name, text] : files_of(folder)) {
            if (!name.ends_with(".svg")) continue;
            const std::string sheet = name.substr(0, std::string("001-question").size());
            ++pages[sheet];
            for (const std::string& scale : scales_on(text)) scales[sheet].push_back(scale);
        }
        ASSERT_EQ(pages.size(), 2U * copies);
        // A copy may have a figure on its second page.
        for (auto& [sheet, own] : scales) std::sort(own.begin(), own.end());
        for (const auto& [sheet, own] : scales)
            if (sheet.substr(4, 8) == "solution") (as_class ? together : apart).insert(own);
        for (const auto& [sheet, count] : pages) EXPECT_TRUE(!as_class || count % 2 == 0) << sheet;
    }
    EXPECT_GT(apart.size(), 1U) << "each by itself has its own";
    ASSERT_EQ(together.size(), 1U);
    EXPECT_GE(together.begin()->size(), 3U);
}

TEST_F(VariantsCommand, SaysWhatIsWrongInOneLine) {
    write("empty.csv", "\n\n");
    write("open.csv", "name\n\"Anna");
    write("latin.csv", "name\nJos\xE9\n");
    write("three.csv", "A\nB\nC\n");
    write("file", "");
    const auto before = snapshot();
    const auto wrong = [&](const std::string& arguments, const std::string& said, int status = 2) {
        const Outcome outcome = run("variants " + arguments);
        EXPECT_EQ(outcome.status, status) << arguments;
        EXPECT_EQ(outcome.err, said + "\n") << arguments;
    };
    wrong("train.json -o out", "kinegraph: how many variants? give --count, or --roster");
    wrong("train.json -o out --roster empty.csv", "empty.csv: there is no name in it");
    wrong("train.json -o out --roster open.csv", "open.csv: line 2: a quote is not closed");
    wrong("train.json -o out --roster latin.csv", "latin.csv: line 2: this is no UTF-8; save it as such");
    wrong("train.json -o out --roster none.csv", "none.csv: cannot be read: No such file or directory");
    wrong("train.json -o out --roster three.csv --count 2",
          "kinegraph: --count 2 is fewer than the 3 names of the roster");
    wrong("train.json -o out --count 2 --merge --format svg", "kinegraph: --merge makes PDF; take --format svg out");
    wrong("four_bar.json -o out --count 2",
          "four_bar.json: nothing varies; add \"vary\" with the values that a parameter takes");
    wrong("four_bar.json -o out --count 2 --lang it",
          "four_bar.json: non varia nulla; aggiungere \"vary\" con i valori che un parametro assume");
    write("twice.csv", "name,surname\nAnna,Rossi\nBruno,Neri\n\n\"Anna\",Rossi\n");
    write("more.csv", "name;surname\nAnna;Rossi\nBruno;De;Santis\n");
    write("fewer.csv", "name,surname\n\"Rossi, Anna\"\n");
    write("long.csv", "name\n" + std::string(201, 'a') + "\n");
    wrong("train.json -o out --roster twice.csv",
          "twice.csv: line 5: \"Anna Rossi\" stands in line 2 already; take one out, or tell them apart, by a number");
    wrong("train.json -o out --roster twice.csv --lang it",
          "twice.csv: riga 5: \"Anna Rossi\" compare già nella riga 2; toglierne uno, o distinguerli, con un numero");
    wrong("train.json -o out --roster more.csv",
          "more.csv: line 3: fields: 3, in the heading 2; one that holds a comma stands in quotes");
    wrong("train.json -o out --roster fewer.csv",
          "fewer.csv: line 2: fields: 1, in the heading 2; one that holds a comma stands in quotes");
    wrong("train.json -o out --roster long.csv", "long.csv: line 2: a name of 201 characters; 200 at most");
    for (const std::string name : {"twice.csv", "more.csv", "fewer.csv", "long.csv"}) fs::remove(folder_ / name);
    EXPECT_EQ(changed_since(before), "");
    wrong("train.json -o file --count 2", "file: cannot be written: Not a directory", 4);
    wrong("train.json -o /proc/none --count 2", "/proc/none: cannot be written: No such file or directory", 4);
}

TEST_F(VariantsCommand, TakesWholeNumbersThatCanBeCountedAlone) {
    const auto before = snapshot();
    const auto wrong = [&](const std::string& arguments, const std::string& said) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, 2) << arguments;
        EXPECT_EQ(outcome.err.substr(0, outcome.err.find(" (kinegraph")), "kinegraph: " + said) << arguments;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    };
    for (const std::string seed : {"18446744073709551616", "99999999999999999999999", "-1", "", "0x10", "1.5", "7 "})
        wrong("variants train.json -o out --count 1 --seed \"" + seed + "\"",
              "--seed: \"" + seed + "\" is not a whole number from 0 up to 18446744073709551615");
    wrong("variants train.json -o out --count 1 --seed -1 --lang it",
          "--seed: \"-1\" non è un numero intero da 0 fino a 18446744073709551615");
    for (const std::string number : {"18446744073709551617", "4294967297", "-5", "''", "1e3"}) {
        const std::string shown = number == "''" ? "" : number;
        wrong("variants train.json -o out --count " + number,
              "--count: \"" + shown + "\" is not a whole number from 1 up to 1000000");
        wrong("batch </dev/null --jobs " + number, "--jobs: \"" + shown + "\" is not a whole number from 1 up to 1024");
        wrong("sweep four_bar.json --steps " + number,
              "--steps: \"" + shown + "\" is not a whole number from 0 up to 10000000");
        wrong("sweep four_bar.json --poses " + number,
              "--poses: \"" + shown + "\" is not a whole number from 0 up to 360");
        wrong("sweep four_bar.json --branch " + number,
              "--branch: \"" + shown + "\" is not a whole number from 1 up to 1000");
    }
    EXPECT_EQ(changed_since(before), "");
    EXPECT_EQ(run("variants train.json -o out --count 1 --format svg --seed 18446744073709551615").status, 0);
}

/// A heading is known by its words, however they are put together; a student by having others.
TEST_F(VariantsCommand, KnowsTheHeadingOfARosterByItsWords) {
    for (const std::string heading :
         {"Cognome e nome", "Nome e cognome", "Student name", "Matr.;Cognome e Nome", "N. matricola\tStudente",
          "STUDENT ID,Last name,First name", "\"Name, surname\"", "E-mail;Note"}) {
        const auto separator =
            heading.find_first_of(";\t") == std::string::npos ? ',' : heading[heading.find_first_of(";\t")];
        const auto fields = heading.starts_with('"') ? 0 : std::count(heading.begin(), heading.end(), separator);
        write("list.csv", heading + "\nAnna Rossi" + std::string(static_cast<std::size_t>(fields), separator) + "\n");
        const Outcome made = run("variants train.json --roster list.csv -o out --format svg");
        EXPECT_EQ(made.status, 0) << made.err;
        EXPECT_NE(made.err.find("1 variant in out"), std::string::npos) << heading << ": " << made.err;
    }
    write("list.csv", "Anna Name\nE. Di Nome-Rossi\n");
    EXPECT_NE(run("variants train.json --roster list.csv -o out --format svg").err.find("2 variants in out"),
              std::string::npos);
}

/// What the key does not list is not there: variants of an earlier run beyond the last, sheets of another format. What
/// has been altered since stays.
TEST_F(VariantsCommand, LeavesNothingOfAnEarlierRunThatTheKeyDoesNotList) {
    ASSERT_EQ(run("variants train.json --count 5 --seed 1 --format svg -o st").status, 0);
    write("st/notes.txt", "mine");
    write("st/005-solution.svg", "altered by hand");
    const Outcome made = run("variants train.json --count 3 --seed 2 --format png --dpi 40 -o st");
    EXPECT_EQ(made.status, 0) << made.err;
    EXPECT_NE(
        made.err.find("train.json: 004 to 005 of an earlier run are taken away, for the key does not list them\n"),
        std::string::npos)
        << made.err;
    for (const std::string name :
         {"004.json", "004-question.svg", "004-results.json", "005.json", ".kinegraph/004", "001-question.svg"})
        EXPECT_FALSE(is_there("st/" + name)) << name;
    for (const std::string name :
         {"notes.txt", "005-solution.svg", "003.json", "003-question.png", "key.csv", ".kinegraph/003"})
        EXPECT_TRUE(is_there("st/" + name)) << name;
    // The same variants in another format are no others.
    ASSERT_EQ(run("variants train.json --count 3 --seed 2 --format svg -o st").status, 0);
    EXPECT_TRUE(is_there("st/001-question.png") && is_there("st/001-question.svg"));
    const Outcome italian =
        run("variants train.json --count 2 --seed 2 --format png --dpi 40 --resume --lang it -o st");
    EXPECT_NE(italian.err.find("tolta la 003 di un’esecuzione precedente, che la chiave non elenca\n"),
              std::string::npos)
        << italian.err;
}

TEST_F(VariantsCommand, LeavesNoQuestionsOfAnotherRunBesideItsKey) {
    ASSERT_EQ(run("variants train.json --count 3 --seed 1 --for moodle,csv --merge -o st").status, 0);
    write("st/answers.csv", "altered by hand");
    const Outcome made = run("variants train.json --count 2 --seed 2 --format svg -o st");
    EXPECT_EQ(made.status, 0) << made.err;
    for (const std::string name : {"moodle.xml", "questions.pdf", "solutions.pdf"}) {
        EXPECT_FALSE(is_there("st/" + name)) << name;
        EXPECT_NE(made.err.find("this one does not: " + name + "\n"), std::string::npos) << made.err;
    }
    EXPECT_TRUE(is_there("st/key.pdf") && is_there("st/answers.csv"));
}

TEST_F(VariantsCommand, RefusesAValueForWhatVaries) {
    const auto before = snapshot();
    const Outcome refused = run("variants train.json --count 2 -o out --set z2=30 --set r2=40mm");
    EXPECT_EQ(refused.status, 2);
    EXPECT_EQ(refused.err,
              "kinegraph: --set z2: z2 varies in this exercise, and a value set would be lost; set another parameter, "
              "or take z2 out "
              "of \"vary\"\n");
    EXPECT_EQ(changed_since(before), "");
}

TEST_F(VariantsCommand, NamesOfARosterAreNoFormulasInASpreadsheet) {
    write("students.csv", "name,surname\n=1+1,Rossi\n-Anna,Bianchi\n@SUM(A1),x\n+39,y\nEva,=z\n");
    const Outcome made = run("variants train.json --roster students.csv -o out --format svg --for csv");
    ASSERT_EQ(made.status, 0) << made.err;
    for (const char* file : {"out/key.csv", "out/answers.csv"}) {
        const auto rows = lines_of(contents(folder_ / file));
        ASSERT_EQ(rows.size(), 6U) << file;
        EXPECT_TRUE(rows[1].starts_with("001,'=1+1 Rossi,")) << rows[1];
        EXPECT_TRUE(rows[2].starts_with("002,'-Anna Bianchi,")) << rows[2];
        EXPECT_TRUE(rows[3].starts_with("003,'@SUM(A1) x,")) << rows[3];
        EXPECT_TRUE(rows[4].starts_with("004,'+39 y,")) << rows[4];
        EXPECT_TRUE(rows[5].starts_with("005,Eva =z,")) << rows[5];
    }
    EXPECT_NE(contents(folder_ / "out/key.csv").find(",-"), std::string::npos) << "numbers stay numbers";
    EXPECT_NE(contents(folder_ / "out/001-question.svg").find("=1+1 Rossi"), std::string::npos);
    EXPECT_EQ(contents(folder_ / "out/001-question.svg").find("'=1+1 Rossi"), std::string::npos);
}

TEST_F(VariantsCommand, LeavesOutWhatComesToAnotherVariantsMechanism) {
    Json file = Json::parse(contents(folder_ / "train.json"));
    file["require"] = Json::array();
    file["vary"] = {{"m", {{"choose", {"1 mm", "2 mm", "3 mm"}}}}};
    std::string text = file.dump();
    for (std::size_t at = 0; (at = text.find("m*", at)) != std::string::npos; at += 11)
        text.replace(at, 2, "max(m, 2 mm)*");
    write("same.json", text);
    const Outcome made = run("variants same.json --count 3 -o out --format svg");
    EXPECT_EQ(made.status, 3) << made.err;
    EXPECT_EQ(made.err,
              "same.json: 2 variants in out; 3 of 3 combinations were looked at\n"
              "same.json: 1 rejected: the same mechanism as another variant’s\n"
              "same.json: the conditions leave 2 of 3 combinations; 3 were asked for\n");
    EXPECT_EQ(run("variants same.json --count 1 -o one --format svg").err.substr(0, 35),
              "same.json: 1 variant in one; 1 of 3");
    const Outcome italian = run("variants same.json --count 1 -o one --format svg --lang it");
    EXPECT_NE(italian.err.find("1 variante in one; è stata esaminata 1 di 3 combinazioni"), std::string::npos)
        << italian.err;
}

TEST_F(VariantsCommand, WhatIsAskedForAndIsNotThereAllCommandsRefuse) {
    const Json whole = Json::parse(contents(folder_ / "train.json"));
    const auto all_say = [&](const char* key, const std::string& entry, const std::string& said) {
        Json file = whole;
        file[key] = Json::array({entry});
        write("wrong.json", file.dump());
        const auto before = snapshot();
        for (const std::string command :
             {"check wrong.json", "solve wrong.json -o wrong.svg", "variants wrong.json --count 1 -o out"}) {
            const Outcome outcome = run(command);
            EXPECT_EQ(outcome.status, 2) << command << ": " << outcome.err;
            EXPECT_EQ(outcome.err, "wrong.json: /" + std::string(key) + "/0: " + said + "\n") << command;
        }
        fs::remove_all(folder_ / "out");
        EXPECT_EQ(changed_since(before), "");
    };
    all_say("ask", "s guide", "no result is named \"s guide\"; names are those of the columns of \"sweep\"");
    all_say("ask", "alpha 3", "there is no result \"alpha 3\"; what is found goes by \"find\"");
    all_say("require", "force polygon readable",
            "no force polygon is drawn of this file, which has no forces; take the condition out, or add \"loads\"");
    all_say("require", "acceleration polygon readable",
            "no acceleration polygon is drawn of this file; take the condition out, or let it find accelerations");
}

TEST_F(VariantsCommand, WhatIsAskedForAndIsNotThereWatchSaysToo) {
    Json file = Json::parse(contents(folder_ / "train.json"));
    file["ask"] = Json::array({"alpha 3"});
    write("wrong.json", file.dump());
    write("watch.sh",
          "'" + program_ +
              "' watch wrong.json >said 2>&1 &\nfor i in {1..500}; do grep -q ask/0 said && break; "
              "sleep 0.02; done\nkill -TERM $!\nwait $!\ngrep -q '/ask/0: .*there is no result \"alpha 3\"' said\n");
    EXPECT_EQ(std::system(("cd '" + folder_.string() + "' && bash watch.sh 2>/dev/null").c_str()), 0)
        << contents(folder_ / "said");
}

TEST_F(VariantsCommand, CountsThoseThatTheConditionsLeave) {
    std::string text = contents(folder_ / "train.json");
    text.replace(text.find("\"from\": 20, \"to\": 40"), 20, "\"from\": 30, \"to\": 30");
    text.replace(text.find("\"require\": ["), 12,
                 "\"require\": [\"m = 2 mm\", \"w = 10 rad/s\", \"phi = 50°\", \"z3 < 20\", ");
    write("few.json", text);
    const Outcome made = run("variants few.json --count 5 -o out --format svg");
    EXPECT_EQ(made.status, 3) << made.err;
    EXPECT_NE(made.err.find("the conditions leave 2 of 756 combinations; 5 were asked for"), std::string::npos)
        << made.err;
    EXPECT_TRUE(fs::exists(folder_ / "out" / "002-solution.svg")) << "what there is is written";
    EXPECT_FALSE(fs::exists(folder_ / "out" / "003.json"));
}

TEST_F(VariantsCommand, StopsWithWholeFiles) {
    const std::string command = "cd '" + folder_.string() + "' && { '" + program_ +
                                "' variants train.json --count 100000 -o out --format svg 2>err & pid=$!; until [ -e "
                                "out/002.json ] || ! kill -0 $pid; do sleep 0.02; done; kill -INT $pid; wait $pid; }";
    EXPECT_NE(std::system(command.c_str()), 0);
    EXPECT_NE(contents(folder_ / "err").find("stopped: what is there is whole; --resume writes the rest"),
              std::string::npos);
    EXPECT_TRUE(is_there("out/key.csv"));
    for (const auto& [name, bytes] : files_of("out")) {
        EXPECT_TRUE(name.ends_with(".json") || name.ends_with(".svg") || name.starts_with("key."))
            << name << " was left behind";
        EXPECT_TRUE(!name.ends_with(".svg") || bytes.ends_with("</svg>\n")) << name;
        EXPECT_TRUE(!name.ends_with(".json") || bytes.ends_with("}\n")) << name;
    }
}

TEST_F(VariantsCommand, ResumesWhatWasInterrupted) {
    const std::string arguments = "variants train.json --seed 3 --format svg --for csv -o ";
    ASSERT_EQ(run(arguments + "whole --count 3").status, 0);
    // Something stands where a file of the second one goes.
    fs::create_directories(folder_ / "out" / "002-solution.svg");
    const Outcome hindered = run(arguments + "out --count 3");
    EXPECT_EQ(hindered.status, 4);
    EXPECT_EQ(
        hindered.err,
        "out/002-solution.svg: cannot be written: Is a directory\n"
        "train.json: 1 of 3 variants are in out, each of them whole; their key is missing, --resume writes the rest\n");
    EXPECT_TRUE(is_there("out/001-results.json") && !is_there("out/002.json") && !is_there("out/key.csv"));
    fs::remove(folder_ / "out" / "002-solution.svg");
    const auto before = fs::last_write_time(folder_ / "out" / "001-question.svg");
    const Outcome resumed = run(arguments + "out --count 3 --resume");
    EXPECT_EQ(resumed.status, 0) << resumed.err;
    EXPECT_NE(resumed.err.find("one of them was there, whole, and stayed"), std::string::npos) << resumed.err;
    EXPECT_EQ(fs::last_write_time(folder_ / "out" / "001-question.svg"), before);
    EXPECT_EQ(files_of("out"), files_of("whole"));
    // What is gone, or cut short, is done again; what is asked otherwise, too.
    fs::remove(folder_ / "out" / "001.json");
    std::ofstream(folder_ / "out" / "003-solution.svg") << "<svg";
    const Outcome mended = run(arguments + "out --count 3 --resume");
    EXPECT_NE(mended.err.find("one of them was there"), std::string::npos) << mended.err;
    EXPECT_EQ(files_of("out"), files_of("whole"));
    const Outcome italian = run(arguments + "out --count 1 --resume --lang it");
    EXPECT_EQ(italian.err.find("c’erano già"), std::string::npos) << italian.err;
}

TEST_F(VariantsCommand, SaysWhatADiskThatIsFullLeavesOut) {
    const Outcome full = run("variants train.json --count 2 -o out --format svg", "ulimit -f 8;");
    EXPECT_EQ(full.status, 4);
    EXPECT_TRUE(lines_are(
        full.err,
        "out/001-(question|solution)\\.svg: cannot be written: File too large|train\\.json: 0 of 2 variants are in "
        "out, .*--resume writes the rest"))
        << full.err;
    EXPECT_TRUE(files_of("out").empty()) << "nothing half written";
}

TEST_F(VariantsCommand, CheckSaysWhichConditionsTheFileItselfMisses) {
    std::string text = contents(folder_ / "train.json");
    text.replace(text.find("\"require\": ["), 12, "\"require\": [\"z2 = 31\", \"omega 4 > 100\", ");
    write("missed.json", text);
    const Outcome checked = run("check missed.json");
    EXPECT_EQ(checked.status, 0);
    EXPECT_EQ(checked.err,
              "missed.json: remark: \"z2 = 31\" does not hold with the file’s own values\n"
              "missed.json: remark: \"omega 4 > 100\" does not hold with the file’s own values\n");
}

TEST_F(SweepOver, SolvesTheFileForEachValue) {
    fs::copy(fs::path(KINEGRAPH_EXAMPLES_DIR) / "variants" / "four_bar.json", folder_ / "vary.json");
    const Outcome swept = run("sweep vary.json --over r --from \"35 mm\" --to \"60 mm\" --step \"5 mm\"");
    ASSERT_EQ(swept.status, 0) << swept.err;
    const auto lines = lines_of(swept.out);
    ASSERT_EQ(lines.size(), 7U);
    EXPECT_TRUE(lines[0].starts_with("r,angle 2,omega 2,alpha 2,angle 3,omega 3,")) << lines[0];
    EXPECT_TRUE(lines[1].starts_with("0.035,")) << lines[1];
    // A row is what solve finds with that value.
    ASSERT_EQ(run("solve vary.json --set r=45mm -o one.json").status, 0);
    const Json one = Json::parse(contents(folder_ / "one.json"));
    std::vector<double> row;
    std::istringstream cells(lines[3]);
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
    EXPECT_EQ(row[0], 0.045);
    EXPECT_EQ(row[5], one["bodies"]["3"]["omega"].get<double>());

    const Outcome json = run("sweep vary.json --over phi --from 0° --to 90° --steps 2 --format json");
    ASSERT_EQ(json.status, 0) << json.err;
    const Json rows = Json::parse(json.out);
    EXPECT_EQ(rows["parameter"], "phi");
    EXPECT_EQ(rows["rows"].size(), 3U);
    EXPECT_NEAR(rows["rows"][1][0].get<double>(), std::acos(-1.0) / 4, 1e-15);
}

TEST_F(SweepOver, IsDrawnAndHeldAgainstTheCheck) {
    fs::copy(fs::path(KINEGRAPH_EXAMPLES_DIR) / "variants" / "four_bar.json", folder_ / "vary.json");
    const Outcome drawn =
        run("sweep vary.json --over r --from \"35 mm\" --to \"60 mm\" --step \"1 mm\" --plot \"omega 3,omega 4\" -o "
            "r.svg -o r.json");
    ASSERT_EQ(drawn.status, 0) << drawn.err;
    const Json rows = Json::parse(contents(folder_ / "r.json"));
    ASSERT_TRUE(rows["largest difference"].is_object());
    EXPECT_LT(rows["largest difference"]["share"].get<double>(), 1e-9);
    EXPECT_GE(rows["largest difference"]["value"].get<double>(), 0.035);
    EXPECT_TRUE(lines_are(drawn.err, R"(vary\.json: largest difference from the numeric check: .* at r = \d+ mm\))"))
        << drawn.err;
    const std::string sheet = contents(folder_ / "r.svg");
    EXPECT_NE(sheet.find("data-figure=\"plot\""), std::string::npos);
    EXPECT_NE(sheet.find("data-name=\"omega 4\""), std::string::npos);
    EXPECT_NE(sheet.find("[mm]"), std::string::npos) << "the parameter in the unit it was given in";
    EXPECT_NE(sheet.find("The results over a parameter"), std::string::npos);
    const Outcome none =
        run("sweep vary.json --over r --from \"35 mm\" --to \"60 mm\" --steps 2 --plot \"omega 33\" -o none.svg");
    EXPECT_EQ(none.status, 2);
    EXPECT_NE(none.err.find("--plot: there is no quantity \"omega 33\""), std::string::npos) << none.err;
    EXPECT_FALSE(is_there("none.svg"));
}

TEST_F(SweepOver, LeavesOutWhatDoesNotCloseAndSaysWhatIsWrong) {
    fs::copy(fs::path(KINEGRAPH_EXAMPLES_DIR) / "variants" / "four_bar.json", folder_ / "vary.json");
    const Outcome open = run("sweep vary.json --over d --from \"150 mm\" --to \"450 mm\" --step \"150 mm\"");
    EXPECT_EQ(open.status, 3);
    EXPECT_TRUE(open.err.starts_with(
        "vary.json: 2 rows are left out, where the file gives no unique answer; the first is d = 300 mm, the last 450 "
        "mm\n"
        "vary.json: largest difference from the numeric check: "))
        << open.err;
    EXPECT_EQ(lines_of(open.out).size(), 2U);
    const auto wrong = [&](const std::string& arguments, const std::string& said) {
        const Outcome outcome = run("sweep vary.json " + arguments);
        EXPECT_EQ(outcome.status, 2) << arguments;
        EXPECT_EQ(outcome.err, "kinegraph: " + said + "\n") << arguments;
    };
    wrong("--over R --from 1 --to 2", "--over \"R\": the file has no parameter named \"R\" (did you mean \"r\"?)");
    wrong("--over r --from 1 --to 2", "--from is a bare number; the parameter r is a length");
    wrong("--over r --from \"1 mm\" --to \"3 mm\" --step \"1 mm\" --steps 2", "--step and --steps do not go together");
    wrong("--over r --from \"1 mm\"", "--over wants --from and --to");
    wrong("--over r --from \"1 mm\" --to \"2 s\"", "--from is a length, and --to or --step is a quantity in s");
    wrong("--over r --from \"1 mm\" --to \"2 mm\" --driver 2",
          "--over moves no driver: --driver, --branch, --trace, --centrodes and --poses do not go with it");
}

}  // namespace
}  // namespace kinegraph::tests::variants_test
