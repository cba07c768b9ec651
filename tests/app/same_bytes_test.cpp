// The same file gives the same bytes, whatever the machine is set to: run, folder, locale, time zone, fonts.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/command_line.hpp"

namespace same_bytes_test {
namespace {

using namespace kinegraph::tests;
namespace fs = std::filesystem;

class SameBytes : public CommandLine {
protected:
    /// What a run in the folder writes, in all forms, with what it says.
    std::string bytes(const std::string& before = "", const std::string& file = "four_bar.json") const {
        const Outcome outcome =
            run("solve '" + file +
                    "' --lang it -o a.svg -o a.png -o a.pdf -o a.json && '" KINEGRAPH_PROGRAM "' solve '" + file + "'",
                before);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        std::string all = outcome.out + '\0' + outcome.err;
        for (const auto& [name, text] : snapshot())
            if (name.starts_with("a.") || name.starts_with("a-")) all += '\0' + name + '\0' + text;
        for (const char* name : {"a.svg", "a.png", "a.pdf", "a.json"}) fs::remove(folder_ / name);
        return all;
    }
    fs::path folder(const std::string& name) const {
        fs::create_directory(streams_ / name);
        return streams_ / name;
    }
};

TEST_F(SameBytes, InEveryRun) {
    const std::string once = bytes();
    EXPECT_GT(once.size(), 100000U);
    EXPECT_TRUE(once == bytes());
}

TEST_F(SameBytes, FromEveryFolder) {
    const std::string here = bytes();
    const fs::path elsewhere = folder("a place with a longer name");
    fs::copy(folder_ / "four_bar.json", elsewhere);
    EXPECT_TRUE(here == bytes("", (elsewhere / "four_bar.json").string()));
}

TEST_F(SameBytes, InEveryTimeZone) {
    const std::string here = bytes();
    for (const char* zone : {"UTC", "Pacific/Kiritimati", "<+12:34>-12:34"})
        EXPECT_TRUE(here == bytes("export TZ='" + std::string(zone) + "';")) << zone;
}

TEST_F(SameBytes, InEveryLocale) {
    const std::string here = bytes("unset LANG LC_ALL LC_NUMERIC;");
    for (const char* locale : {"C", "C.UTF-8", "it_IT.UTF-8", "tr_TR.UTF-8"})
        EXPECT_TRUE(here == bytes("export LC_ALL=" + std::string(locale) + ";")) << locale;
    // Not every machine has an Italian locale: one is made.
    const fs::path made = folder("locales");
    ASSERT_EQ(
        std::system(("localedef -i it_IT -f UTF-8 '" + (made / "it_IT.UTF-8").string() + "' >/dev/null 2>&1").c_str()),
        0)
        << "no sources to make an Italian locale of: install the Debian package locales";
    EXPECT_TRUE(here == bytes("export LOCPATH='" + made.string() + "' LC_ALL=it_IT.UTF-8 LANG=it_IT.UTF-8;"));
}

TEST_F(SameBytes, WithOtherFontsInstalled) {
    const std::string here = bytes();
    // A home with fonts of its own, among them one that goes by the name of ours and is another.
    const fs::path stix = "/usr/share/fonts/opentype/stix";
    const fs::path home = folder("home");
    fs::create_directories(home / ".fonts");
    fs::copy_file(stix / "STIXGeneral-Bold.otf", home / ".fonts" / "STIXGeneral-Regular.otf");
    std::ofstream(home / "fonts.conf")
        << "<?xml version=\"1.0\"?><!DOCTYPE fontconfig SYSTEM \"fonts.dtd\"><fontconfig><dir>" +
               (home / ".fonts").string() + "</dir></fontconfig>";
    const std::string set = "export HOME='" + home.string() + "' XDG_DATA_HOME='" + home.string() +
                            "' FONTCONFIG_FILE='" + (home / "fonts.conf").string() + "';";
    EXPECT_TRUE(here == bytes(set));
    EXPECT_TRUE(here == bytes("export FONTCONFIG_FILE=/nowhere FONTCONFIG_PATH=/nowhere HOME=/nowhere;"));
    // Fonts are opened by path: the same files elsewhere are the same font, others beside them are not looked at.
    const fs::path moved = folder("moved");
    for (const auto& file : fs::directory_iterator(stix)) fs::copy(file.path(), moved / file.path().filename());
    fs::copy_file(stix / "STIXGeneral-Bold.otf", moved / "Another.otf");
    EXPECT_TRUE(here == bytes("export KINEGRAPH_FONT_DIR='" + moved.string() + "';"));
    // And that it matters which font it is.
    fs::copy_file(stix / "STIXGeneral-Bold.otf", moved / "STIXGeneral-Regular.otf",
                  fs::copy_options::overwrite_existing);
    EXPECT_FALSE(here == bytes("export KINEGRAPH_FONT_DIR='" + moved.string() + "';"));
}

TEST_F(SameBytes, AMissingFontIsFourAndNamesThePackage) {
    const auto before = snapshot();
    const fs::path some = folder("some");
    fs::copy("/usr/share/fonts/opentype/stix/STIXGeneral-Regular.otf", some);
    for (const std::string& place : {std::string("/nowhere"), some.string()}) {
        const Outcome outcome =
            run("solve four_bar.json -o a.svg -o a.json", "export KINEGRAPH_FONT_DIR='" + place + "';");
        EXPECT_EQ(outcome.status, 4);
        EXPECT_TRUE(lines_are(outcome.err, "kinegraph: .*\\.otf.*fonts-stix.*"));
        EXPECT_EQ(changed_since(before), "");
    }
    EXPECT_EQ(run("solve four_bar.json -o a.json", "export KINEGRAPH_FONT_DIR=/nowhere;").status, 0)
        << "numbers need no font";
}

}  // namespace
}  // namespace same_bytes_test
