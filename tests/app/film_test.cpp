// Films: the pictures that ffmpeg is given, its captions, and what is said where it is missing or fails. A script
// stands in for ffmpeg: what it makes is the concern of tests/media.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/command_line.hpp"

namespace film_test {
namespace {

using kinegraph::tests::contents;
using kinegraph::tests::Outcome;

class FilmFiles : public kinegraph::tests::CommandLine {
protected:
    void SetUp() override {
        CommandLine::SetUp();
        ffmpeg("printf '%s\\n' \"$*\" >words; cat >frames; printf film");
    }
    void ffmpeg(const std::string& script) const {
        std::filesystem::create_directory(folder_ / "bin");
        write("bin/ffmpeg", "#!/bin/sh\n" + script + "\n");
        std::filesystem::permissions(folder_ / "bin/ffmpeg", std::filesystem::perms::owner_all);
    }
    Outcome film(const std::string& arguments) const { return run(arguments, "PATH=$PWD/bin:$PATH"); }
    /// How often a picture stands in the frames one after another, for each picture.
    std::vector<std::pair<std::string, int>> shots() const {
        const std::string all = contents(folder_ / "frames"), head = "\x89PNG\r\n";
        std::vector<std::pair<std::string, int>> found;
        for (std::size_t at = 0; at < all.size();) {
            const std::size_t next = std::min(all.find(head, at + 1), all.size());
            const std::string png = all.substr(at, next - at);
            if (found.empty() || found.back().first != png) found.emplace_back(png, 0);
            ++found.back().second;
            at = next;
        }
        return found;
    }
};

TEST_F(FilmFiles, HaveTheSlidesAsLongAsTheyAreRead) {
    ASSERT_EQ(run("solve four_bar.json --steps --slides --dpi 80 -o slide.png").status, 0);
    const Outcome done = film("solve four_bar.json -o a.mp4 --captions burnt --height 360");
    ASSERT_EQ(done.status, 0) << done.err;
    EXPECT_EQ(contents(folder_ / "a.mp4"), "film");
    EXPECT_FALSE(is_there("a.vtt"));
    std::vector<std::pair<std::string, int>> slides;
    int growing = 0;
    for (const auto& [png, frames] : shots()) {
        growing += frames == 1 ? 1 : 0;
        if (frames == 1) continue;
        slides.emplace_back(png, frames + std::exchange(growing, 0));
    }
    EXPECT_EQ(growing, 0) << "the last picture stands";
    ASSERT_GT(slides.size(), 5U);
    EXPECT_EQ(slides[0].first, contents(folder_ / "slide.png"));
    EXPECT_EQ(slides[1].first, contents(folder_ / "slide-2.png"));
    for (const auto& [png, frames] : slides) {
        EXPECT_GE(frames, 20) << "two seconds";
        EXPECT_LE(frames, 150) << "fifteen";
    }
    EXPECT_NE(contents(folder_ / "words").find("-framerate 10 "), std::string::npos);
}

// A line is not there at once: between two slides the pictures have more and more of what is new.
TEST_F(FilmFiles, HaveLinesThatGrow) {
    ASSERT_EQ(film("solve four_bar.json -o a.mp4 --captions none --height 360").status, 0);
    const auto pictures = shots();
    int in_a_row = 0, most = 0;
    for (const auto& [png, frames] : pictures) {
        in_a_row = frames == 1 ? in_a_row + 1 : 0;
        most = std::max(most, in_a_row);
    }
    EXPECT_GE(most, 5) << "some pictures may be alike";
    EXPECT_LE(most, 8);
}

TEST_F(FilmFiles, HaveCaptionsBesideThem) {
    ASSERT_EQ(film("solve four_bar.json -o a.mp4 -o a.webm --lang it --height 360").status, 0);
    const std::string captions = contents(folder_ / "a.vtt");
    EXPECT_TRUE(captions.starts_with("WEBVTT\n\n1\n00:00:00.000 --> 00:00:")) << captions;
    EXPECT_EQ(captions.find("\n\n\n"), std::string::npos);
    std::size_t cues = 0;
    for (std::size_t at = captions.find(" --> "); at != std::string::npos; at = captions.find(" --> ", at + 1)) ++cues;
    const auto pictures = shots();
    const auto slides =
        std::count_if(pictures.begin(), pictures.end(), [](const auto& picture) { return picture.second > 1; });
    EXPECT_EQ(cues, static_cast<std::size_t>(slides)) << "one for each slide";
    EXPECT_EQ(film("solve four_bar.json -o b.mp4 --captions none --height 360").status, 0);
    EXPECT_FALSE(is_there("b.vtt"));
}

TEST_F(FilmFiles, OfAMotionGoRoundOrToAndFro) {
    ASSERT_EQ(film("sweep four_bar.json -o a.webm --frames 6 --height 360 --steps 12").status, 0);
    EXPECT_EQ(shots().size(), 6U);
    for (const auto& [png, frames] : shots()) EXPECT_EQ(frames, 1);
    ASSERT_EQ(film("sweep four_bar.json -o a.webm --from 0° --to 60° --frames 6 --height 360 --steps 12").status, 0);
    const auto pictures = shots();
    ASSERT_EQ(pictures.size(), 10U);
    EXPECT_EQ(pictures[4].first, pictures[6].first);
    EXPECT_NE(pictures[0].first, pictures[5].first);
}

TEST_F(FilmFiles, LeaveNothingWhereFfmpegIsMissingOrFails) {
    const auto before = snapshot();
    Outcome done = run("solve four_bar.json -o a.mp4 -o a.svg", "PATH=/nowhere");
    EXPECT_EQ(done.status, 4);
    EXPECT_EQ(done.err, "kinegraph: a film is made by ffmpeg, which is missing: install the Debian package ffmpeg\n");
    ffmpeg("head -c 1000 >/dev/null; printf half; echo 'Unknown encoder' >&2; exit 1");
    done = film("solve four_bar.json -o a.mp4 -o a.svg");
    EXPECT_EQ(done.status, 4);
    EXPECT_EQ(done.err, "kinegraph: ffmpeg made no film: Unknown encoder\n");
    ffmpeg("kill -9 $$");
    done = film("sweep four_bar.json -o a.gif --frames 2 --steps 12");
    EXPECT_EQ(done.status, 4);
    EXPECT_NE(done.err.find("too much time, memory or space"), std::string::npos) << done.err;
    for (const char* name : {"a.mp4", "a.svg", "a.gif", "a.vtt"}) EXPECT_FALSE(is_there(name)) << name;
    EXPECT_EQ(run("sweep four_bar.json -o a.mp4 --frames 1").status, 2);
    EXPECT_NE(run("sweep sluice_gate.json --over a --from 1 --to 2 -o a.mp4").status, 0);
}

}  // namespace
}  // namespace film_test
