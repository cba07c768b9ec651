// `kinegraph batch`: a filter that answers line by line as `solve` would, whatever the number of workers, and knows its
// work again.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <tuple>

#include "tests/support/command_line.hpp"
#include "tests/support/random_mechanism.hpp"

namespace batch_test {
namespace {

using namespace kinegraph::tests;
using kinegraph::unless_sanitized;
using nlohmann::json;

class Batch : public CommandLine {
protected:
    void SetUp() override {
        CommandLine::SetUp();
        write("crank.json", with_parameters(four_bar_));
    }
    /// The four-bar with its crank as a parameter.
    static std::string with_parameters(std::string text) {
        json file = json::parse(text);
        file["parameters"] = {{"r", "40 mm"}, {"phi", "60°"}};
        file["points"]["A"] = {{"from", "O2"}, {"distance", "= r"}, {"angle", "= phi"}};
        return file.dump();
    }
    Outcome batch(const std::string& lines, const std::string& arguments = "", const std::string& before = "") const {
        write("lines", lines);
        return run("batch " + arguments + " <lines", before);
    }
    static std::vector<json> answers(const std::string& out) {
        std::vector<json> all;
        std::istringstream stream(out);
        for (std::string line; std::getline(stream, line);) all.push_back(json::parse(line));
        return all;
    }
    /// So many cranks, their files in `folder`.
    static std::string cranks(int count, const std::string& want, const std::string& folder) {
        std::string lines;
        for (int i = 0; i < count; ++i)
            lines += json{{"id", i},
                          {"file", "crank.json"},
                          {"set", {{"r", std::to_string(30 + i % 40) + " mm"}, {"phi", 20 + i}}},
                          {"want", json::parse(want)},
                          {"to", folder + '/' + std::to_string(i)}}
                         .dump() +
                     '\n';
        return lines;
    }
    /// What lies in a folder, names with bytes, cache records and what is not yet in place left out.
    Snapshot files(const std::string& name) const {
        Snapshot all;
        if (!fs::exists(folder_ / name)) return all;
        for (const auto& entry : fs::directory_iterator(folder_ / name))
            if (!entry.path().filename().string().starts_with("."))
                all[entry.path().filename().string()] = contents(entry.path());
        return all;
    }
};

TEST_F(Batch, AnswersAsSolveDoes) {
    const std::string lines = R"({"id": 1, "file": "crank.json", "set": {"r": "45 mm", "phi": "50°"}}
{"id": "all", "file": "crank.json", "set": {"r": "45 mm", "phi": "50°"}, "want": ["json", "svg", "png", "pdf"],)"
                              R"( "to": "new/a"}
{"id": 3, "mechanism": )" + json::parse(with_parameters(four_bar_)).dump() +
                              R"(, "set": {"r": "= 9/2 * 10 mm", "phi": "50°"}, "want": ["svg", "json"]})" + "\n";
    const Outcome outcome = batch(lines);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const Outcome solved = run("solve crank.json --set 'r=45 mm' --set 'phi=50°' -o s.json -o s.svg -o s.png -o s.pdf");
    ASSERT_EQ(solved.status, 0) << solved.err;
    const auto all = answers(outcome.out);
    ASSERT_EQ(all.size(), 3U);
    const json results = json::parse(contents(folder_ / "s.json"));
    EXPECT_EQ(all[0], (json{{"id", 1}, {"status", 0}, {"result", results}}));
    const json names{"new/a.json", "new/a.svg", "new/a.png", "new/a.pdf"};
    EXPECT_EQ(all[1], (json{{"id", "all"}, {"status", 0}, {"files", names}}));
    for (const std::string name : {".json", ".svg", ".png", ".pdf"})
        EXPECT_TRUE(contents(folder_ / ("new/a" + name)) == contents(folder_ / ("s" + name))) << name;
    EXPECT_EQ(all[2]["result"], results);
    ASSERT_EQ(all[2]["svg"].size(), 1U);
    // A mechanism in the line goes by the name "mechanism".
    fs::copy(folder_ / "crank.json", folder_ / "mechanism");
    EXPECT_EQ(run("solve mechanism --set 'r=45 mm' --set 'phi=50°' -o s.svg").status, 0);
    EXPECT_TRUE(all[2]["svg"][0] == contents(folder_ / "s.svg"));
}

TEST_F(Batch, TakesTheOptionsOfSolve) {
    const Outcome outcome =
        batch(R"({"file": "crank.json", "want": ["svg"], "lang": "it", "paper": "A3", "sheet": "question", "grid": true}
{"file": "crank.json", "want": ["svg"], "to": "one.svg", "figure": "velocity", "theme": "print"}
{"file": "crank.json", "at": ["30°", "60°"], "exact": true}
{"file": "crank.json", "want": ["svg"], "detail": "brief", "orientation": "portrait", "lang": "en"}
)",
              "--lang it --author Rossi");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto all = answers(outcome.out);
    ASSERT_EQ(all.size(), 4U);
    const auto as_solve = [&](const std::string& arguments) {
        EXPECT_EQ(run("solve crank.json --author Rossi " + arguments).status, 0) << arguments;
        return contents(folder_ / "s.svg");
    };
    EXPECT_TRUE(all[0]["svg"][0] == as_solve("--lang it --paper A3 --sheet question --grid -o s.svg"));
    EXPECT_EQ(all[1]["files"], json{"one.svg"});
    EXPECT_TRUE(contents(folder_ / "one.svg") == as_solve("--lang it --figure velocity --theme print -o s.svg"));
    ASSERT_EQ(all[2]["results"].size(), 2U);
    EXPECT_EQ(run("solve crank.json --at 30° --at 60° --exact -o p.json").status, 0);
    EXPECT_EQ(all[2]["results"][1], json::parse(contents(folder_ / "p-2.json")));
    EXPECT_TRUE(all[3]["svg"][0] == as_solve("--detail brief --orientation portrait -o s.svg"));
    const auto turned = answers(batch(R"({"file": "crank.json"})", "--at 60°").out);
    ASSERT_EQ(turned.size(), 1U);
    EXPECT_EQ(run("solve crank.json --at 60° -o p.json").status, 0);
    EXPECT_EQ(turned[0]["result"], json::parse(contents(folder_ / "p.json")));
}

TEST_F(Batch, SuperposesLoadsAsSolveDoes) {
    fs::copy(example_file("four_bar_weights"), folder_);
    const Outcome outcome = batch(R"({"file": "four_bar_weights.json", "want": ["svg"]}
{"file": "four_bar_weights.json", "want": ["svg"], "superposition": "each"}
)",
                                  "");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto all = answers(outcome.out);
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(run("solve four_bar_weights.json --superposition joined -o joined.svg").status, 0);
    EXPECT_EQ(run("solve four_bar_weights.json --superposition each -o each.svg").status, 0);
    EXPECT_TRUE(all[0]["svg"][0] == contents(folder_ / "joined.svg"));
    EXPECT_TRUE(all[1]["svg"][0] == contents(folder_ / "each.svg"));
    EXPECT_FALSE(all[0]["svg"] == all[1]["svg"]);
    for (const char* other : {"--detail brief", "--sheet question", "--sheet answers"}) {
        const Outcome refused = run(std::string("solve four_bar_weights.json --superposition each -o r.svg ") + other);
        EXPECT_EQ(refused.status, 2) << other;
        EXPECT_NE(refused.err.find("--superposition each"), std::string::npos) << refused.err;
    }
}

TEST_F(Batch, WrongLinesSayWhyAndStopNothing) {
    const struct {
        const char* line;
        const char* said;
    } rows[] = {
        {"not JSON", "this is not JSON"},
        {"[1, 2]", "an object is wanted here"},
        {"{\"file\": \"crank.json\"", "this is not JSON"},
        {"\xff\xfe", "this is not JSON"},
        {R"({"id": 4})", "\"file\" or \"mechanism\" is missing"},
        {R"({"file": "crank.json", "mechanism": {}})", "exclude each other"},
        {R"({"file": "none.json"})", "none.json: cannot be read"},
        {R"({"file": "."})", "is a directory"},
        {R"({"file": "-"})", "standard input carries the lines"},
        {R"({"fil": "crank.json"})", "no key \"fil\" (did you mean \"file\"?)"},
        {R"({"file": "crank.json", "id": 1, "id": 2})", "given twice"},
        {R"({"file": "crank.json", "id": [1]})", "/id: a text or a number"},
        {R"({"file": "crank.json", "set": {"q": 1}})", "no parameter named \"q\""},
        {R"({"file": "crank.json", "set": {"r": "400 mm"}})", "meet"},
        {R"({"file": "crank.json", "set": {"r": [1]}})", "/set/r: a number"},
        {R"({"file": "crank.json", "want": ["gif"]})", "/want/0: one of \"json\", \"svg\""},
        {R"({"file": "crank.json", "want": []})", "/want: an array"},
        {R"({"file": "crank.json", "want": ["pdf"]})", "say with \"to\" where they go"},
        {R"({"file": "crank.json", "to": "a/"})", "/to: names no file"},
        {R"({"file": "crank.json", "to": "crank"})", "would overwrite the mechanism file"},
        {R"({"file": "crank.json", "lang": "nl"})", "/lang: one of \"en\", \"it\", \"fr\", \"de\" and \"es\""},
        {R"({"file": "crank.json", "dpi": 5, "want": ["png"], "to": "a"})", "/dpi: a number from 20 to 1200"},
        {R"({"file": "crank.json", "theme": "none"})", "none: cannot be read"},
        {R"({"file": "crank.json", "figure": "nose", "want": ["svg"]})", "there is no such figure"},
        {R"({"file": "crank.json", "grid": true})", "--grid is for the question"},
        {R"({"file": "crank.json", "steps": true, "figure": "velocity", "want": ["svg"]})", "exclude each other"},
        {R"({"file": "crank.json", "steps": true, "slides": true, "paper": "A3"})", "--slides and --paper exclude"},
        {R"({"mechanism": {"kinegraph": 1, "points": {"A": 3}}})", "mechanism: /points/A: "},
    };
    std::string lines = "\n";  // an empty line is none
    for (const auto& row : rows)
        lines += std::string(row.line) + "\n" + R"({"id": "good", "file": "crank.json"})" + "\r\n";
    const Outcome outcome = batch(lines, "--jobs 3");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_TRUE(lines_are(outcome.err, "kinegraph: lines that could not be carried out: 28 of 56 .*")) << outcome.err;
    const auto all = answers(outcome.out);
    ASSERT_EQ(all.size(), 2 * std::size(rows));
    for (std::size_t i = 0; i < std::size(rows); ++i) {
        EXPECT_EQ(all[2 * i]["status"], 2) << rows[i].line;
        std::string said;
        for (const json& error : all[2 * i]["errors"]) said += error.get<std::string>() + '\n';
        EXPECT_NE(said.find(rows[i].said), std::string::npos) << rows[i].line << " is said to be: " << said;
        EXPECT_EQ(all[2 * i + 1]["status"], 0);
        EXPECT_EQ(all[2 * i + 1]["id"], "good");
    }
    EXPECT_EQ(all[0]["line"], "not JSON");
}

TEST_F(Batch, SaysInItalianWhatIsWrong) {
    const auto all = answers(batch(R"({"fil": 1})", "--lang it").out);
    ASSERT_EQ(all.size(), 1U);
    EXPECT_NE(all[0]["errors"][0].get<std::string>().find("una riga non ha la chiave"), std::string::npos) << all[0];
}

TEST_F(Batch, TellsWhatCouldNotBeFound) {
    const auto all = answers(batch(R"({"id": 1, "file": "slider_driven_dead_point.json"})").out);
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0]["status"], 3);
    EXPECT_FALSE(all[0]["unsolved"].empty());
    EXPECT_TRUE(all[0].contains("result"));
}

TEST_F(Batch, GivesTheSameBytesWithAnyNumberOfWorkers) {
    for (const char* name : {"exam_2001", "gas_force", "oldham_coupling", "sluice_gate"})
        fs::copy(example_file(name), folder_);
    const auto lines = [](const std::string& folder) {
        std::string all;
        for (int i = 0; i < unless_sanitized(18, 6); ++i) {
            const char* const files[] = {"crank", "exam_2001", "scara", "gas_force", "oldham_coupling", "sluice_gate"};
            const std::string file = files[i % 6];
            json line{{"id", i}, {"file", file + ".json"}, {"to", folder + '/' + std::to_string(i)}};
            line["want"] = i % 4 == 3 ? json{"png", "json"} : json{"svg", "pdf", "json"};
            if (file == "crank") line["set"] = {{"r", std::to_string(30 + i) + " mm"}};
            if (i % 3 == 1) line["lang"] = "it";
            if (i % 5 == 4) line["date"] = "丙午";  // which the font has not: a remark of this line alone
            all += line.dump() + '\n';
        }
        return all;
    };
    const Outcome one = batch(lines("one"), "--jobs 1");
    EXPECT_NE(one.out.find("U+4E19"), std::string::npos);
    const Snapshot by_one = files("one");
    for (const std::string jobs : {"2", "5"}) {
        const Outcome more = batch(lines("n" + jobs), "--jobs " + jobs);
        EXPECT_TRUE(std::regex_replace(more.out, std::regex("\"n" + jobs + "/"), "\"one/") == one.out) << jobs;
        EXPECT_TRUE(files("n" + jobs) == by_one) << jobs;
    }
}

TEST_F(Batch, ResumeDoesWhatIsMissingAndNothingElse) {
    const std::string lines = cranks(6, R"(["svg", "json"])", "out");
    const Outcome whole = batch(lines);
    ASSERT_EQ(whole.err, "");
    const Snapshot made = files("out");
    ASSERT_GE(made.size(), 6U * 2U);
    std::map<std::string, ino_t> numbers;
    const auto number = [&](const std::string& name) {
        struct stat status {};
        ::stat((folder_ / "out" / name).c_str(), &status);
        return status.st_ino;
    };
    for (const auto& [name, text] : made) numbers[name] = number(name);
    fs::remove(folder_ / "out/1.svg");                               // lost
    std::ofstream(folder_ / "out/2.json", std::ios::app) << "more";  // spoilt
    std::string changed = lines;
    changed.replace(changed.find("33 mm"), 5, "35 mm");  // asked otherwise, of as many pages
    const Outcome again = batch(changed, "--resume --jobs 2");
    EXPECT_TRUE(again.out == whole.out) << again.out;
    EXPECT_TRUE(lines_are(again.err, "kinegraph: lines done before: 3 of 6"));
    for (const std::string name : {"0.svg", "0.json", "4.svg", "5.json"})
        EXPECT_EQ(number(name), numbers[name]) << name;
    for (const std::string name : {"1.json", "2.svg", "3.svg"}) EXPECT_NE(number(name), numbers[name]) << name;
    Snapshot after = files("out");
    EXPECT_FALSE(after["3.json"] == made.at("3.json"));
    // The mechanism file itself is part of what was asked.
    write("crank.json", contents(folder_ / "crank.json") + "\n");
    EXPECT_EQ(batch(changed, "--resume").err, "");
}

TEST_F(Batch, KilledItLeavesWholeFilesAndIsResumed) {
    const int count = unless_sanitized(40, 20);
    const std::string lines = cranks(count, R"(["svg", "json"])", "out");
    const Outcome whole = batch(lines);
    const Snapshot made = files("out");
    fs::remove_all(folder_ / "out");
    write("lines", lines);
    write("kill.sh", "'" + program_ + "' batch --jobs 2 <lines >/dev/null &\nuntil [ -e out/" +
                         std::to_string(count / 2) +
                         ".json ]; do sleep 0.002; done\nkill -9 $!\nwait $!\n[ $? = 137 ]\n");
    ASSERT_EQ(std::system(("cd '" + folder_.string() + "' && bash kill.sh 2>/dev/null").c_str()), 0);
    const Snapshot left = files("out");
    EXPECT_LT(left.size(), made.size());
    for (const auto& [name, text] : left) EXPECT_TRUE(made.at(name) == text) << name;
    const Outcome resumed = batch(lines, "--resume --jobs 2");
    EXPECT_TRUE(resumed.out == whole.out);
    EXPECT_NE(resumed.err.find("lines done before: "), std::string::npos) << resumed.err;
    EXPECT_TRUE(files("out") == made);
}

TEST_F(Batch, StopsInOrderOnASignal) {
    write("lines", cranks(3, R"(["json"])", "out"));
    write("stop.sh", "mkfifo pipe\n'" + program_ +
                         "' batch <pipe >answers 2>said &\nexec 3>pipe\ncat lines >&3\nuntil [ -e out/2.json ]; do "
                         "sleep 0.01; done\n" +
                         "kill -TERM $!\nwait $!\n[ $? = 143 ]\n");
    ASSERT_EQ(std::system(("cd '" + folder_.string() + "' && bash stop.sh 2>/dev/null").c_str()), 0);
    EXPECT_EQ(answers(contents(folder_ / "answers")).size(), 3U);
    EXPECT_TRUE(lines_are(contents(folder_ / "said"), "kinegraph: stopped, lines answered: 3; --resume does the rest"));
}

TEST_F(Batch, StopsOnASignalWhereItsInputIsAlwaysReady) {
    const int count = unless_sanitized(150, 60);
    const std::string lines = cranks(count, R"(["svg", "json"])", "out");
    const Outcome whole = batch(lines, "--jobs 2");
    const Snapshot made = files("out");
    for (const auto& [signal, status, jobs] : {std::tuple("INT", "130", "1"), std::tuple("TERM", "143", "2")}) {
        SCOPED_TRACE(signal);
        fs::remove_all(folder_ / "out");
        write("stop.sh", "'" + program_ + "' batch --jobs " + jobs +
                             " <lines >answers 2>said &\nuntil [ -e out/3.json ]; do sleep 0.002; done\nkill -" +
                             signal + " $!\nwait $!\n[ $? = " + status + " ]\n");
        ASSERT_EQ(std::system(("cd '" + folder_.string() + "' && bash stop.sh 2>/dev/null").c_str()), 0);
        const std::string answered = contents(folder_ / "answers");
        const std::size_t number = answers(answered).size();
        EXPECT_LT(number, static_cast<std::size_t>(count));
        EXPECT_TRUE(whole.out.starts_with(answered));
        Snapshot of_answered;  // files are named by the numbers of their lines
        for (const auto& [name, text] : made)
            if (std::stoul(name) < number) of_answered.emplace(name, text);
        EXPECT_TRUE(files("out") == of_answered) << "a line was begun and not answered";
        EXPECT_TRUE(lines_are(contents(folder_ / "said"), "kinegraph: stopped, lines answered: " +
                                                              std::to_string(number) + "; --resume does the rest"));
        EXPECT_TRUE(batch(lines, "--resume --jobs 2").out == whole.out);
        EXPECT_TRUE(files("out") == made);
    }
}

TEST_F(Batch, WhatCannotBeWrittenIsSaid) {
    write("plain", "");
    const auto all = answers(batch(R"({"id": 1, "file": "crank.json", "to": "plain/a"}
{"id": 2, "file": "crank.json", "to": "a"}
)")
                                 .out);
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all[0]["status"], 4);
    EXPECT_NE(all[0]["errors"][0].get<std::string>().find("cannot be written"), std::string::npos) << all[0];
    EXPECT_EQ(all[1]["status"], 0);
    write("lines", R"({"file": "crank.json"})");
    const Outcome full = run("batch <lines >/dev/full");
    EXPECT_EQ(full.status, 4);
    EXPECT_TRUE(lines_are(full.err, "standard output: cannot be written: .*"));
}

TEST_F(Batch, InputThatIsClosedCannotBeRead) {
    const Outcome closed = run("batch <&-");
    EXPECT_EQ(closed.status, 2);
    EXPECT_TRUE(lines_are(closed.err, "standard input: cannot be read: .*")) << closed.err;
    EXPECT_EQ(run("batch </dev/null").status, 0) << "input without a line";
    EXPECT_EQ(run("check - <&-").status, 2);
}

/// Of one page, or of several: the file that would be lost is named, and no page that it is not.
TEST_F(Batch, AResultNeverTakesTheMechanismsPlace) {
    const std::string before = contents(folder_ / "crank.json");
    const auto all = answers(batch(R"({"file": "crank.json", "to": "crank"}
{"file": "crank.json", "to": "./crank.json"}
)")
                                 .out);
    ASSERT_EQ(all.size(), 2U);
    for (const json& each : all) {
        EXPECT_EQ(each["status"], 2);
        const auto said = each["errors"][0].get<std::string>();
        EXPECT_NE(said.find("crank.json would overwrite the mechanism file itself; give the output another name"),
                  std::string::npos)
            << said;
    }
    EXPECT_EQ(contents(folder_ / "crank.json"), before);
}

/// Left out under sanitizers (suite_groups.cmake), which hold on to what is freed, to see whether it is used again.
class BatchMemory : public Batch {
protected:
    /// Whether so many lines are answered within so much memory for data, bytes. (The largest memory that the system
    /// tells of a process counts that of the test itself, before the program took its place.)
    bool is_enough(rlim_t memory, int count) const {
        std::string lines;
        for (int i = 0; i < count; ++i)
            lines += R"({"file": "crank.json", "set": {"r": ")" + std::to_string(30 + i % 40) + "." +
                     std::to_string(i) + " mm\"}}\n";
        write("lines", lines);
        const pid_t child = ::fork();
        if (child == 0) {
            const rlimit limit{memory, memory};
            if (::chdir(folder_.c_str()) != 0 || std::freopen("lines", "r", stdin) == nullptr ||
                std::freopen("/dev/null", "w", stdout) == nullptr ||
                std::freopen("/dev/null", "w", stderr) == nullptr || ::setrlimit(RLIMIT_DATA, &limit) != 0)
                ::_exit(9);
            ::execl(program_.c_str(), program_.c_str(), "batch", "--jobs", "2", nullptr);
            ::_exit(9);
        }
        int status = 0;
        EXPECT_EQ(::waitpid(child, &status, 0), child);
        return WIFEXITED(status) && WEXITSTATUS(status) == 0;
    }
};

TEST_F(BatchMemory, DoesNotGrowWithTheLines) {
    constexpr rlim_t mebibyte = 1 << 20;
    rlim_t too_little = 0, enough = 1024 * mebibyte;
    ASSERT_TRUE(is_enough(enough, 100));
    while (enough - too_little > mebibyte) {
        const rlim_t middle = (too_little + enough) / 2;
        (is_enough(middle, 100) ? enough : too_little) = middle;
    }
    EXPECT_TRUE(is_enough(enough + 3 * mebibyte, 1500));
}

}  // namespace
}  // namespace batch_test
