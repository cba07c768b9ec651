// The built program as a user meets it: exit statuses, one line for each message, outputs whole or not at all.
#include "tests/support/command_line.hpp"

#include <gtest/gtest.h>

#include <kinegraph/mechanism.hpp>

#include <nlohmann/json.hpp>

namespace cli_test {
namespace {

using namespace kinegraph::tests;

TEST_F(CommandLine, HelpAndVersionAreEverywhere) {
    for (const char* arguments :
         {"--help", "-h", "solve --help", "solve four_bar.json --help", "check --help", "check -h", "diff --help"}) {
        const Outcome help = run(arguments);
        EXPECT_EQ(help.status, 0) << arguments;
        EXPECT_NE(help.out.find("Usage: kinegraph"), std::string::npos) << help.out;
        EXPECT_NE(help.out.find("Exit status"), std::string::npos);
        EXPECT_EQ(help.err, "");
    }
    for (const char* arguments : {"--version", "solve --version", "check --version"}) {
        const Outcome version = run(arguments);
        EXPECT_EQ(version.status, 0) << arguments;
        EXPECT_TRUE(lines_are(version.out, R"(kinegraph \d+\.\d+\.\d+)"));
        EXPECT_EQ(version.err, "");
    }
}

TEST_F(CommandLine, ThatIsWrongTouchesNothing) {
    const auto before = snapshot();
    const struct {
        const char* arguments;
        const char* said;
    } rows[] = {
        {"", "kinegraph: a command is missing; there are solve, sweep, variants, cam, check, import, diff, pairs.*"},
        {"slove four_bar.json",
         "kinegraph: no command is named \"slove\"; there are solve, sweep, variants, cam, check, import, diff, "
         "pairs.*"},
        {"--exact", "kinegraph: .*"},
        {"solve", "kinegraph: FILE is required.*"},
        {"check", "kinegraph: FILE is required.*"},
        {"solve four_bar.json scara.json", "kinegraph: .*scara.json.*"},
        {"solve four_bar.json --bogus", "kinegraph: .*--bogus.*"},
        {"check four_bar.json -o a.svg", "kinegraph: .*"},
        {"solve four_bar.json -o", "kinegraph: --output.*"},
        {"solve four_bar.json -o ''", "kinegraph: -o \"\" names no file"},
        {"solve four_bar.json -o ./", "kinegraph: -o \"./\" names no file"},
        {"solve four_bar.json -o a.bmp",
         "kinegraph: -o a.bmp: .*\\.svg, \\.png, \\.pdf, \\.tex, .*\\.json, \\.html, .* or \\.ggb.*"},
        {"solve four_bar.json -o a",
         "kinegraph: -o a: .*\\.svg, \\.png, \\.pdf, \\.tex, .*\\.json, \\.html, .* or \\.ggb.*"},
        {"solve four_bar.json -o a.svg -o b.bmp", "kinegraph: -o b.bmp: .*"},
        {"solve four_bar.json -o -", "kinegraph: -o - needs --format.*"},
        {"solve four_bar.json -o - -o - --format json", "kinegraph: standard output can carry one output only"},
        {"solve four_bar.json -o a.svg -o a.svg", "kinegraph: -o a.svg is given twice"},
        {"solve four_bar.json -o a.svg -o ./a.svg", "kinegraph: two outputs .*a.svg"},
        {"solve four_bar.json -o four_bar.json",
         "kinegraph: -o four_bar.json would overwrite the mechanism file itself"},
        {"solve four_bar.json -o ./four_bar.json", "kinegraph: .*would overwrite the mechanism file itself"},
        {"solve four_bar.json -o a.png --format bmp", "kinegraph: --format.*"},
        {"solve four_bar.json -o a.svg --lang nl", "kinegraph: --lang.*"},
        {"solve four_bar.json -o a.svg --paper A5", "kinegraph: --paper.*"},
        {"solve four_bar.json -o a.svg --orientation askew", "kinegraph: --orientation.*"},
        {"solve four_bar.json -o a.svg --figure forces",
         "four_bar.json: --figure forces: there is no such figure; there are mechanism, centres, velocity, "
         "acceleration, .*"},
        {"solve four_bar.json -o a.png --dpi 0", "kinegraph: --dpi.*20 to 1200.*"},
        {"solve four_bar.json -o a.png --dpi 1e9", "kinegraph: --dpi.*"},
        {"solve four_bar.json -o a.png --dpi nan", "kinegraph: --dpi.*"},
        {"solve four_bar.json -o a.png --dpi many", "kinegraph: --dpi.*"},
        {"solve absent.json -o a.svg", "absent.json: cannot be read: No such file or directory"},
        {"solve . -o a.svg", ".: is a directory, not a mechanism file"},
        {"solve /dev/zero -o a.svg", "/dev/zero: is larger than 64 MiB.*"},
        {"solve \"$(printf 'a\\nb\\033.json')\" -o a.svg", R"(a\\nb\\x1b.json: cannot be read: .*)"},
        {"check absent.json", "absent.json: cannot be read: No such file or directory"},
        {"pairs absent.json", "absent.json: cannot be read: No such file or directory"},
        {"pairs --lang nl", "kinegraph: --lang.*"},
        {"pairs --format csv", "kinegraph: --format.*"},
    };
    for (const auto& row : rows) {
        const Outcome outcome = run(row.arguments);
        EXPECT_EQ(outcome.status, 2) << row.arguments;
        EXPECT_TRUE(lines_are(outcome.err, row.said)) << row.arguments;
        EXPECT_EQ(outcome.out, "") << row.arguments;
        EXPECT_EQ(changed_since(before), "") << row.arguments;
    }
}

TEST_F(CommandLine, AFaultOfTheFileTouchesNothing) {
    write("a.svg", "as it was");
    const struct {
        std::string text;
        const char* said;
    } rows[] = {
        {"", "bad\\.json: .+"},
        {"not JSON at all", "bad\\.json: .+"},
        {"[]", "bad\\.json: .+"},
        {std::string(100000, '['), "bad\\.json: .+"},
        {spoilt(R"({"revolute": "B",  "bodies": [3, 4]})", R"({"revolute": "B", "bodies": [3, 5]})"),
         R"(bad\.json: /joints/2/bodies/1: .*"5".*)"},
        {spoilt("\"-120 rpm\"", "\"-120 rpn\""), "bad\\.json: /drivers/0/omega: .*rpn.*"},
        {spoilt("\"radius\": 80", "\"radius\": 10"), "bad\\.json: /points/B.*: .+"},
        {spoilt("\"distance\": 40", "\"distance\": 1e400"), "bad\\.json: /points/A/distance: .+"},
        {spoilt("\"distance\": 40", "\"distance\": 1e-400000000"), "bad\\.json: /points/A/distance: .+"},
        {spoilt("\"from\": \"O2\"", "\"from\": \"B\""), "bad\\.json: /points/.*"},
        {spoilt("\"O4\": [150, 0],", "\"O4\": [150, 0], \"O4\": [150, 0],"), "bad\\.json: /points/O4.*"},
        {spoilt("\"O4\": [150, 0],", "\"O4\": [150, 0], \"O,5\": [150, 0],"), "bad\\.json: .*O,5.*"},
    };
    for (const auto& row : rows) {
        write("bad.json", row.text);
        const auto before = snapshot();
        for (const char* arguments : {"solve bad.json -o a.svg -o b.json", "check bad.json"}) {
            const Outcome outcome = run(arguments);
            EXPECT_EQ(outcome.status, 2) << row.text.substr(0, 1000);
            EXPECT_TRUE(lines_are(outcome.err, row.said));
            EXPECT_EQ(outcome.out, "");
            EXPECT_EQ(changed_since(before), "");
        }
    }
}

TEST_F(CommandLine, CheckSaysThatAFileIsInOrder) {
    const Outcome outcome = run("check four_bar.json");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.out, "four_bar.json: in order (4 bodies, 4 joints, 1 driver)\n");
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(run("check - <four_bar.json").out, "standard input: in order (4 bodies, 4 joints, 1 driver)\n");
    const std::string cam = contents(example_file("cams/disc_cam"));
    write("cam.json", cam);
    EXPECT_EQ(run("check cam.json").out, "cam.json: in order (a cam)\n");
    EXPECT_EQ(run("check cam.json --lang it").out, "cam.json: in ordine (una camma)\n");
    std::string wrong = cam;
    wrong.replace(wrong.find("\"base radius\""), 13, "\"base ray\"");
    write("wrong.json", wrong);
    EXPECT_EQ(run("check wrong.json").status, 2);
    EXPECT_NE(run("check wrong.json").err.find("base radius"), std::string::npos);
}

TEST_F(CommandLine, AFileOfAnotherKindHasOneFaultThatSaysWhoseItIs) {
    write("cam.json", contents(example_file("cams/disc_cam")));
    write("ball.json", contents(example_file("contact/ball_on_plane")));
    const struct {
        const char* arguments;
        const char* said;
    } rows[] = {
        {"cam four_bar.json",
         "four_bar.json: /points: no cam stands in this file: \"points\" is of a mechanism or a problem; use "
         "\"kinegraph solve\"\n"},
        {"cam four_bar.json --lang it",
         "four_bar.json: /points: in questo file non c’è una camma: \"points\" è di un meccanismo o di un problema; "
         "usare "
         "\"kinegraph solve\"\n"},
        {"cam ball.json",
         "ball.json: /hertz: no cam stands in this file: \"hertz\" is of a mechanism or a problem; use \"kinegraph "
         "solve\"\n"},
        {"solve cam.json", "cam.json: /cam: no mechanism stands in this file but a cam; use \"kinegraph cam\"\n"},
        {"equations cam.json --lang it",
         "cam.json: /cam: in questo file non c’è un meccanismo ma una camma; usare \"kinegraph cam\"\n"},
    };
    for (const auto& row : rows) {
        const Outcome outcome = run(row.arguments);
        EXPECT_EQ(outcome.status, 2) << row.arguments;
        EXPECT_EQ(outcome.err, row.said);
        EXPECT_EQ(outcome.out, "");
    }
}

/// As wide as it is touched over the turn, and square to the way: its lower side lies where the cam touches.
TEST_F(CommandLine, AFlatFollowerIsDrawnWithItsPlate) {
    write("lever.json", contents(example_file("cams/flat_faced_lever")));
    write("roller.json", contents(example_file("cams/disc_cam")));
    ASSERT_EQ(run("cam lever.json --at 60° -o lever.svg").status, 0);
    EXPECT_NE(contents(folder_ / "lever.svg").find("data-name=\"plate\""), std::string::npos);
    ASSERT_EQ(run("cam roller.json -o roller.svg").status, 0);
    EXPECT_EQ(contents(folder_ / "roller.svg").find("data-name=\"plate\""), std::string::npos);
}

TEST_F(CommandLine, SpeaksOneLanguage) {
    const struct {
        const char* arguments;
        const char* said;
    } rows[] = {
        {"solve --lang it", "kinegraph: FILE è obbligatorio \\(kinegraph solve --help dice di più\\)"},
        {"solve missing.json --lang=it", "missing.json: non si può leggere: file o cartella inesistente"},
        {"check missing.json --lang it", "missing.json: non si può leggere: file o cartella inesistente"},
        {"check . --lang it", "\\.: è una cartella, non un file di meccanismo"},
        {"solve four_bar.json --lang it --paper A5", "kinegraph: --paper: .*A5.* non è fra .*"},
        {"solve four_bar.json --lang it --bogus", "kinegraph: argomento inatteso: --bogus.*"},
        {"solve four_bar.json --lang it -o a.bmp", "kinegraph: -o a.bmp: l’estensione .*"},
        {"solve four_bar.json --lang it -o a.svg --figure forces",
         "four_bar.json: --figure forces: non c’è questa figura; .*"},
        {"diff four_bar.json four_bar.json --lang it", "four_bar.json: non è né PNG né SVG"},
    };
    for (const auto& row : rows) {
        const Outcome outcome = run(row.arguments);
        EXPECT_EQ(outcome.status, 2) << row.arguments;
        EXPECT_TRUE(lines_are(outcome.err, row.said)) << row.arguments << '\n' << outcome.err;
    }
    EXPECT_EQ(run("check four_bar.json --lang it").out, "four_bar.json: in ordine (4 corpi, 4 coppie, 1 movente)\n");
}

TEST_F(CommandLine, SchemaPrintsTheSchemaOfTheLibrary) {
    const Outcome printed = run("schema --lang it");
    EXPECT_EQ(printed.status, 0);
    EXPECT_EQ(printed.out, kinegraph::mechanism_schema());
    EXPECT_EQ(printed.err, "");
}

TEST_F(CommandLine, PairsPrintsTheCatalogueOrAMechanismsPairs) {
    const Outcome catalogue = run("pairs --lang it");
    EXPECT_EQ(catalogue.status, 0);
    EXPECT_EQ(catalogue.err, "");
    EXPECT_NE(catalogue.out.find("coppia rotoidale"), std::string::npos) << catalogue.out;
    const Outcome four_bar = run("pairs four_bar.json");
    EXPECT_EQ(four_bar.status, 0);
    EXPECT_NE(four_bar.out.find("3·3 − 2·4 − 0 = 1"), std::string::npos) << four_bar.out;
    EXPECT_NE(four_bar.out.find("verdict: mechanism"), std::string::npos) << four_bar.out;
    EXPECT_EQ(run("pairs four_bar.json --format markdown").out.rfind("# ", 0), 0u);
}

TEST_F(CommandLine, SolveWithoutOutputsPrintsTheTable) {
    const auto before = snapshot();
    const Outcome english = run("solve four_bar.json");
    EXPECT_EQ(english.status, 0);
    EXPECT_EQ(english.err, "");
    EXPECT_NE(english.out, "");
    const Outcome italian = run("solve --lang it - <four_bar.json");
    EXPECT_EQ(italian.status, 0);
    EXPECT_NE(italian.out, english.out);
    EXPECT_EQ(changed_since(before), "");
}

TEST_F(CommandLine, SolveWritesWhatTheEndingsSay) {
    const Outcome outcome = run("solve -o a.svg four_bar.json -o b.PNG -o c.pdf -o d.json -o e --format json --dpi 40");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(contents(folder_ / "a.svg").find("<svg"), std::string::npos);
    EXPECT_EQ(contents(folder_ / "b.PNG").substr(0, 4), "\x89PNG");
    EXPECT_EQ(contents(folder_ / "c.pdf").substr(0, 5), "%PDF-");
    auto results = nlohmann::json::parse(contents(folder_ / "d.json"));
    EXPECT_EQ(results["mobility"]["effective"], 1);
    EXPECT_EQ(contents(folder_ / "e"), contents(folder_ / "d.json"));
    for (const auto& [name, text] : snapshot()) EXPECT_FALSE(name.starts_with('.')) << name << " was left behind";
}

TEST_F(CommandLine, TheSameInputGivesTheSameBytesWhereverItIs) {
    ASSERT_EQ(run("solve four_bar.json -o a.svg -o a.pdf -o a.png -o a.json --dpi 40").status, 0);
    fs::create_directory(folder_ / "away");
    fs::copy(folder_ / "four_bar.json", folder_ / "away");
    ASSERT_EQ(run("solve away/four_bar.json -o away/a.svg -o away/a.pdf -o away/a.png -o away/a.json --dpi 40",
                  "LC_ALL=it_IT.UTF-8 TZ=Asia/Tokyo")
                  .status,
              0);
    for (const char* name : {"a.svg", "a.pdf", "a.png", "a.json"})
        EXPECT_TRUE(contents(folder_ / name) == contents(folder_ / "away" / name)) << name;
}

TEST_F(CommandLine, StandardOutputCarriesOneOutput) {
    ASSERT_EQ(run("solve four_bar.json -o a.json -o a.pdf -o a.svg").status, 0);
    EXPECT_EQ(run("solve four_bar.json -o - --format json").out, contents(folder_ / "a.json"));
    EXPECT_EQ(run("solve four_bar.json --format json").out, contents(folder_ / "a.json"));
    EXPECT_EQ(run("solve four_bar.json -o - --format pdf").out, contents(folder_ / "a.pdf"));
    const Outcome svg = run("solve four_bar.json -o - --format svg");
    EXPECT_EQ(svg.status, 0);
    EXPECT_EQ(svg.out, contents(folder_ / "a.svg"));
    if (is_there("a-2.svg")) {
        EXPECT_TRUE(lines_are(svg.err, "four_bar.json: remark: .*"));
        EXPECT_NE(svg.err.find("pages and standard output carries the first only"), std::string::npos) << svg.err;
    }
}

TEST_F(CommandLine, PaperAndResolutionAreTaken) {
    ASSERT_EQ(run("solve four_bar.json -o a4.svg -o small.png --dpi 40").status, 0);
    ASSERT_EQ(run("solve four_bar.json --paper a3 -o a3.svg -o large.png --dpi 80").status, 0);
    ASSERT_EQ(run("solve four_bar.json --paper letter -o letter.svg").status, 0);
    EXPECT_NE(contents(folder_ / "a4.svg").find("297"), std::string::npos);
    EXPECT_NE(contents(folder_ / "a3.svg").find("420"), std::string::npos);
    EXPECT_NE(contents(folder_ / "letter.svg").find("279.4"), std::string::npos);
    const auto width = [this](const char* name) {
        const std::string png = contents(folder_ / name);
        int pixels = 0;
        for (std::size_t byte = 16; byte < 20; ++byte) pixels = pixels * 256 + static_cast<unsigned char>(png.at(byte));
        return pixels;
    };
    EXPECT_NEAR(width("small.png"), 297 / 25.4 * 40, 1);
    EXPECT_NEAR(width("large.png"), 420 / 25.4 * 80, 1);
    ASSERT_EQ(run("solve four_bar.json --orientation portrait -o upright.png --dpi 40").status, 0);
    EXPECT_NEAR(width("upright.png"), 210 / 25.4 * 40, 1);
}

TEST_F(CommandLine, StepsArePagesAndNumberedFiles) {
    ASSERT_EQ(run("solve four_bar.json --steps -o s.svg -o s.pdf").status, 0);
    EXPECT_TRUE(is_there("s.svg") && is_there("s-2.svg") && is_there("s-6.svg") && is_there("s.pdf"));
    EXPECT_EQ(run("solve four_bar.json --steps --figure velocity -o t.svg").status, 2);
}

TEST_F(CommandLine, AFigureMayStandAlone) {
    ASSERT_EQ(run("solve four_bar.json --figure velocity -o v.svg -o v.png -o v.pdf").status, 0);
    EXPECT_TRUE(is_there("v.png") && is_there("v.pdf") && !is_there("v-2.svg"));
    const std::string svg = contents(folder_ / "v.svg");
    EXPECT_NE(svg.find("id=\"velocity\""), std::string::npos);
    EXPECT_EQ(svg.find("id=\"acceleration\""), std::string::npos);
    EXPECT_TRUE(lines_are(run("solve four_bar.json --figure velocity").err, "four_bar.json: remark: --figure .*"));
}

TEST_F(CommandLine, ExactAddsFractions) {
    auto exact = nlohmann::json::parse(run("solve parallel_crank.json -o - --format json --exact").out);
    EXPECT_EQ(exact["bodies"]["3"]["exact"]["omega"], "0");
    EXPECT_EQ(exact["points"]["B"]["exact"]["at"], nlohmann::json::parse(R"(["3/20", "1/25"])"));
    auto left = nlohmann::json::parse(run("solve four_bar.json -o - --format json --exact").out);
    EXPECT_TRUE(left["points"]["B"].contains("leftover"));
    const Outcome plain = run("solve parallel_crank.json --exact");
    EXPECT_EQ(plain.status, 0);
    EXPECT_TRUE(lines_are(plain.err, "parallel_crank.json: remark: --exact .*"));
}

TEST_F(CommandLine, WithoutAUniqueAnswerWritesWhatIsKnown) {
    const Outcome outcome = run("solve slider_driven_dead_point.json -o a.json -o a.svg");
    EXPECT_EQ(outcome.status, 3);
    EXPECT_TRUE(lines_are(outcome.err, "slider_driven_dead_point.json: (unsolved: .+: .+|remark: .+)"));
    EXPECT_NE(outcome.err.find("unsolved"), std::string::npos);
    auto results = nlohmann::json::parse(contents(folder_ / "a.json"));
    EXPECT_FALSE(results["unsolved"].empty());
    EXPECT_TRUE(results["instant centres"].contains("1,2"));
    EXPECT_TRUE(is_there("a.svg"));
    EXPECT_EQ(run("solve slider_driven_dead_point.json").status, 3);
}

TEST_F(CommandLine, OutputsAreWrittenAllOrNone) {
    write("kept.svg", "as it was");
    fs::create_directory(folder_ / "folder.svg");
    const struct {
        const char* arguments;
        const char* said;
    } rows[] = {
        {"solve four_bar.json -o absent/a.svg -o kept.svg",
         "absent/a.svg: cannot be written: No such file or directory"},
        {"solve four_bar.json -o kept.svg -o absent/a.svg",
         "absent/a.svg: cannot be written: No such file or directory"},
        {"solve four_bar.json -o kept.svg -o new.json -o folder.svg", "folder.svg: cannot be written: Is a directory"},
        {"solve four_bar.json -o kept.svg -o /dev/full --format svg",
         "/dev/full: cannot be written: No space left on device"},
        {"solve four_bar.json -o kept.svg -o - --format json >/dev/full",
         "standard output: cannot be written: No space left on device"},
        {"solve four_bar.json -o kept.svg -o - --format json >&-",
         "standard output: cannot be written: Bad file descriptor"},
        {"solve four_bar.json >/dev/full", "standard output: cannot be written: No space left on device"},
        {"check four_bar.json >/dev/full", "standard output: cannot be written: No space left on device"},
        {"--version >/dev/full", "standard output: cannot be written: No space left on device"},
    };
    const auto before = snapshot();
    for (const auto& row : rows) {
        const Outcome outcome = run(row.arguments);
        EXPECT_EQ(outcome.status, 4) << row.arguments;
        EXPECT_TRUE(lines_are(outcome.err, row.said)) << row.arguments;
        EXPECT_EQ(changed_since(before), "") << row.arguments;
    }
    if (::geteuid() != 0) {  // root may write anything
        fs::permissions(folder_ / "kept.svg", fs::perms::owner_read);
        EXPECT_EQ(run("solve four_bar.json -o new.json -o kept.svg").status, 4);
        EXPECT_EQ(changed_since(before), "");
    }
    // A disk that fills up, or a limit, half way through a file.
    const Outcome limited = run("solve four_bar.json -o new.json -o kept.svg", "ulimit -f 1;");
    EXPECT_EQ(limited.status, 4);
    EXPECT_EQ(changed_since(before), "");
}

TEST_F(CommandLine, ModulesAreLoadedByTheRunsAloneThatNeedThem) {
    const fs::path built = KINEGRAPH_PROGRAM;
    fs::create_directory(folder_ / "alone");
    fs::copy(built, folder_ / "alone/kinegraph");
    fs::copy(KINEGRAPH_EXAMPLES_DIR "/motion/projectile.json", folder_);
    fs::copy(KINEGRAPH_EXAMPLES_DIR "/variants/four_bar.json", folder_ / "vary.json");
    program_ = "alone/kinegraph";
    EXPECT_EQ(run("solve four_bar.json -o a.json").status, 0);
    const auto refused = [&](const std::string& arguments, const std::string& said) {
        const auto before = snapshot();
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, 4) << arguments;
        EXPECT_TRUE(lines_are(outcome.err, said + " by a module of the program, which cannot be loaded: .*"))
            << arguments;
        EXPECT_EQ(changed_since(before), "") << arguments;
    };
    refused("solve projectile.json -o b.json", "projectile.json: /motion/x: derivatives in symbols are found");
    fs::copy(built.parent_path() / "kinegraph_ginac.so", folder_ / "alone");
    EXPECT_EQ(run("solve projectile.json -o c.json").status, 0);
    refused("solve four_bar.json -o b.svg", "kinegraph: Type is set");
    fs::copy(built.parent_path() / "kinegraph_type.so", folder_ / "alone");
    EXPECT_EQ(run("solve four_bar.json -o a.svg --text live").status, 0);
    refused("solve four_bar.json -o b.svg -o b.png", "kinegraph: PNG and PDF are drawn");
    refused("solve four_bar.json -o b.pdf", "kinegraph: PNG and PDF are drawn");
    fs::copy(built.parent_path() / "kinegraph_cairo.so", folder_ / "alone");
    EXPECT_EQ(run("solve four_bar.json -o a.png").status, 0);
    EXPECT_EQ(run("variants vary.json --count 2 -o class/ --for qti").status, 4);
    fs::copy(built.parent_path() / "kinegraph_zip.so", folder_ / "alone");
    EXPECT_EQ(run("variants vary.json --count 2 -o class/ --for qti").status, 0);
}

TEST_F(CommandLine, AnOutputKeepsItsModeAndItsLink) {
    write("target.svg", "old");
    fs::permissions(folder_ / "target.svg", static_cast<fs::perms>(0640));
    fs::create_symlink("target.svg", folder_ / "link.svg");
    ASSERT_EQ(run("solve four_bar.json -o link.svg").status, 0);
    EXPECT_TRUE(fs::is_symlink(folder_ / "link.svg"));
    EXPECT_NE(contents(folder_ / "target.svg"), "old");
    EXPECT_EQ(static_cast<int>(fs::status(folder_ / "target.svg").permissions()), 0640);
    ASSERT_EQ(run("solve four_bar.json -o new.svg", "umask 027;").status, 0);
    EXPECT_EQ(static_cast<int>(fs::status(folder_ / "new.svg").permissions()), 0640);
}

TEST_F(CommandLine, AReaderThatLeavesIsAFailureToWriteNotADeath) {
    // The reader is gone before the program starts; its status is left in a file.
    const std::string command = "cd '" + folder_.string() +
                                "' && { sleep 0.2; '" KINEGRAPH_PROGRAM
                                "' solve four_bar.json 2>said; echo $? >status; } | :";
    ASSERT_EQ(std::system(command.c_str()), 0);
    EXPECT_EQ(contents(folder_ / "status"), "4\n");
    EXPECT_EQ(contents(folder_ / "said"), "standard output: cannot be written: Broken pipe\n");
}

TEST_F(CommandLine, OddNamesAreOnlyNames) {
    const std::string odd = "a b'\"<&>;$(touch x)\xc3\xa8.json";
    fs::copy(folder_ / "four_bar.json", folder_ / odd);
    fs::path script = streams_ / "name";
    std::ofstream(script) << odd;
    const Outcome outcome =
        run("solve \"$(cat '" + script.string() + "')\" -o \"$(cat '" + script.string() + "').svg\"");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(is_there(odd + ".svg"));
    EXPECT_FALSE(is_there("x"));
    fs::copy(folder_ / "four_bar.json", folder_ / "-x.json");
    EXPECT_EQ(run("check -- -x.json").status, 0);
    EXPECT_EQ(run("check ./-x.json").status, 0);
}

}  // namespace
}  // namespace cli_test
