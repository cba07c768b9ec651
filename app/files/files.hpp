// Files: reads one whole file; writes several files, all or none. "-" is standard input or output. Knows no mechanics.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "app/files/messages.hpp"

namespace kinegraph::app {

/// The size limit of an input file, bytes.
constexpr std::size_t largest_input = std::size_t{64} << 20;

/// The length of the first UTF-8 character, bytes; 0: invalid UTF-8.
std::size_t character_length(std::string_view text);
bool is_utf8(std::string_view text);

/// Reads a whole file; `kind` ("mechanism file") is for messages. Error: why it cannot be read, in a few words.
tl::expected<std::string, Words> read_whole(const std::string& path, const Words& kind);

/// True where both paths exist and are the same file.
bool same_file(const std::string& one, const std::string& other);

/// Bytes to write to a path, or to standard output ("-").
struct Output {
    std::string path;
    std::string bytes;
    std::string written = {};  ///< a temporary file that already contains the bytes; "-" if they were streamed
};
struct NotWritten {
    Words path;
    Words why;
};
/// An output of unlimited length, written piece by piece: to a temporary file beside its target, or directly to a
/// target that is not a regular file (a device, a pipe, standard output). Removed unless finish() passes it on.
class Growing {
public:
    static tl::expected<Growing, NotWritten> open(const std::string& path);
    Growing(Growing&& other) noexcept;
    Growing& operator=(Growing&&) = delete;
    ~Growing();
    /// Appends bytes. Returns the write error, if there was one.
    std::optional<NotWritten> add(std::string_view bytes);
    /// The output, to pass to write_all with the other outputs of the run.
    Output finish() &&;

private:
    Growing() = default;
    std::string path_, temporary_;
    int file_ = -1;
};
/// Writes all outputs or none: first to temporary files beside the targets, then by renaming. If anything fails, every
/// target is as before. A target that is not a regular file (a device, a pipe, standard output) is written before the
/// renaming, when all other files are on disk.
std::optional<NotWritten> write_all(const std::vector<Output>& outputs);
/// Creates a folder and its parents if necessary. Returns what cannot be written, if anything.
std::optional<NotWritten> make_folder(const std::string& path);
/// Removes a file if it exists. Returns what cannot be removed, if anything.
std::optional<NotWritten> take_away(const std::string& path);
/// Writes a text to standard output and returns the exit status; reports a failure.
Status print(const std::string& text, Language language);
/// Reports a write error.
Status fail_to_write(const NotWritten& failure, Language language);

}  // namespace kinegraph::app
