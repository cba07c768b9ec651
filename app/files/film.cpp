#include "app/files/film.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <numeric>

#include "app/files/child.hpp"
#include "lang/keys/command_line.hpp"

namespace kinegraph::app {
namespace {

/// How ffmpeg writes a film of drawings: sharp lines, and colours that every player knows. `last`: how long the last
/// picture stands, in hundredths of a second.
std::vector<std::string> encoding(FilmKind kind, long last) {
    switch (kind) {
        case FilmKind::mp4:
            return {"-c:v", "libx264",  "-preset", "medium",    "-tune",      "animation", "-crf",
                    "18",   "-pix_fmt", "yuv420p", "-movflags", "+faststart", "-f",        "mp4"};
        case FilmKind::webm:
            return {"-c:v", "libvpx-vp9", "-crf", "24",       "-b:v",    "0",  "-cpu-used",
                    "4",    "-row-mt",    "1",    "-pix_fmt", "yuv420p", "-f", "webm"};
        case FilmKind::gif: break;
    }
    // A picture that stands is written once (as one of each frame it took forty times the bytes). A palette for each
    // picture, so that no more than one is in memory.
    const std::string pictures =
        "[0:v]mpdecimate=max=0:hi=1:lo=1:frac=0,split[a][b];[a]palettegen=stats_mode=single[p];"
        "[b][p]paletteuse=new=1:dither=none:diff_mode=rectangle";
    return {"-filter_complex",    pictures, "-fps_mode", "vfr", "-loop", "0", "-final_delay",
            std::to_string(last), "-f",     "gif"};
}

/// "00:01:02.400"
std::string time_text(long frames, int rate) {
    const long all = frames * 1000 / rate;
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), "%02ld:%02ld:%02ld.%03ld", all / 3'600'000, all / 60'000 % 60,
                  all / 1000 % 60, all % 1000);
    return text.data();
}

/// Text of a WebVTT cue, in which "&" and "<" begin something else, and an empty line ends it.
std::string cue_text(std::string_view words) {
    std::string text;
    for (const char c : words) {
        if (c == '&')
            text += "&amp;";
        else if (c == '<')
            text += "&lt;";
        else if (c == '>')
            text += "&gt;";
        else if (c != '\n' || (!text.empty() && text.back() != '\n'))
            text += c;
    }
    while (text.ends_with('\n')) text.pop_back();
    return text;
}

}  // namespace

int rate_of_stills(FilmKind kind) { return kind == FilmKind::gif ? 5 : 10; }
int rate_of_motion(FilmKind kind) { return kind == FilmKind::gif ? 20 : 25; }

int reading_frames(std::string_view words, int rate) {
    constexpr double first_look = 1.5, letters_a_second = 15, least = 2, most = 15;
    const auto letters = std::count_if(words.begin(), words.end(), [](char c) { return (c & 0xC0) != 0x80; });
    const double seconds = std::clamp(first_look + static_cast<double>(letters) / letters_a_second, least, most);
    return static_cast<int>(std::lround(seconds * rate));
}

tl::expected<std::string, Words> film_of(const std::vector<Shot>& shots, int rate, FilmKind kind) {
    const long frames =
        std::accumulate(shots.begin(), shots.end(), 0L, [](long sum, const Shot& shot) { return sum + shot.frames; });
    if (const long most = 3600L * rate; frames > most)
        return tl::unexpected(Words(lang::command_line::the_film_would_be_longer));
    std::vector<std::string> words{"ffmpeg", "-hide_banner", "-nostdin",   "-loglevel",  "error",
                                   "-y",     "-f",           "image2pipe", "-framerate", std::to_string(rate),
                                   "-c:v",   "png",          "-i",         "pipe:0",     "-map_metadata",
                                   "-1",     "-fflags",      "+bitexact",  "-flags",     "+bitexact"};
    const long last = shots.empty() ? 0 : 100L * shots.back().frames / rate;
    for (std::string& word : encoding(kind, last)) words.push_back(std::move(word));
    // By this name and not as a pipe, because the head of an mp4 is written last.
    words.emplace_back("file:/proc/self/fd/1");
    std::size_t shot = 0;
    int shown = 0;
    const auto next = [&]() -> const std::string* {
        while (shot < shots.size() && shown == shots[shot].frames) {
            ++shot;
            shown = 0;
        }
        if (shot == shots.size()) return nullptr;
        ++shown;
        return &shots[shot].png;
    };
    constexpr ChildLimits limits{3600, std::uint64_t{8} << 30, std::uint64_t{1} << 30};
    auto answer = run_child(words, limits, next);
    if (!answer)
        return tl::unexpected(
            Words(lang::command_line::ffmpeg_cannot_be_started, std::string(std::strerror(answer.error()))));
    if (answer->is_missing()) return tl::unexpected(Words(lang::command_line::a_film_is_made_by_ffmpeg));
    if (answer->status == 0 && !answer->output.empty()) return std::move(answer->output);
    std::string why = answer->messages.substr(0, answer->messages.find('\n'));
    if (why.empty()) return tl::unexpected(Words(lang::command_line::ffmpeg_needed_too_much));
    return tl::unexpected(Words(lang::command_line::ffmpeg_made_no_film, why));
}

std::string captions_of(const std::vector<Shot>& shots, int rate) {
    std::string text = "WEBVTT\n";
    long at = 0;
    int number = 0;
    for (const Shot& shot : shots) {
        const long end = at + shot.frames;
        if (!shot.caption.empty())
            text += "\n" + std::to_string(++number) + "\n" + time_text(at - shot.lead, rate) + " --> " +
                    time_text(end, rate) + "\n" + cue_text(shot.caption) + "\n";
        at = end;
    }
    return text;
}

}  // namespace kinegraph::app
