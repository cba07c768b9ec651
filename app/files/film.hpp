// Films: pictures one after another, made into a film by ffmpeg, and captions beside it. The pictures are the same
// bytes everywhere; the film is ffmpeg's.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "lang/words.hpp"

namespace kinegraph::app {

/// A picture, and for how many frames it stands.
struct Shot {
    std::string png;
    int frames = 1;
    std::string caption{};  ///< empty: none
    int lead = 0;           ///< so many frames before it the caption already shows
};

enum class FilmKind { mp4, webm, gif };

/// Frames a second of a sequence of still pictures, and of a motion.
int rate_of_stills(FilmKind kind);
int rate_of_motion(FilmKind kind);

/// For how many frames a picture stands on which so much is read: two to fifteen seconds.
int reading_frames(std::string_view words, int rate);

/// The film. Error: ffmpeg is missing, cannot make such a film, or needs too much; or the film is longer than an hour.
tl::expected<std::string, Words> film_of(const std::vector<Shot>& shots, int rate, FilmKind kind);

/// The captions as WebVTT.
std::string captions_of(const std::vector<Shot>& shots, int rate);

}  // namespace kinegraph::app
