// Files: reading one whole, writing several whole or not at all. "-" is standard input or output. Knows no mechanics.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "app/files/messages.hpp"

namespace kinegraph::app {

/// The largest file that is read, bytes.
constexpr std::size_t largest_input = std::size_t{64} << 20;

/// The whole of a file, which should be a `kind` ("mechanism file"). Error: why it cannot be read, in a few words.
tl::expected<std::string, Words> read_whole(const std::string& path, const Words& kind);

/// True where both paths exist and are the same file.
bool same_file(const std::string& one, const std::string& other);

/// Bytes that are to stand under a path, or on standard output ("-").
struct Output {
    std::string path;
    std::string bytes;
    std::string written = {};  ///< a temporary file that holds them already; of what was streamed "-"
};
struct NotWritten {
    Words path;
    Words why;
};
/// An output that grows, of any length: in a temporary file beside its target, or straight to what is no plain file (a
/// device, a pipe, standard output). What is not handed on by finish() is removed.
class Growing {
public:
    static tl::expected<Growing, NotWritten> open(const std::string& path);
    Growing(Growing&& other) noexcept;
    Growing& operator=(Growing&&) = delete;
    ~Growing();
    /// What cannot be written, if it cannot.
    std::optional<NotWritten> add(std::string_view bytes);
    /// To be given to write_all with the rest of the run.
    Output finish() &&;

private:
    Growing() = default;
    std::string path_, temporary_;
    int file_ = -1;
};
/// Writes all or none: first into temporary files beside the targets, then renamed; whatever fails, every target is as
/// it was. What is no plain file (a device, a pipe, standard output) is written before the renaming, when all the rest
/// is safe on disk.
std::optional<NotWritten> write_all(const std::vector<Output>& outputs);
/// A folder with those it lies in, unless it is there. What cannot be written, if it cannot.
std::optional<NotWritten> make_folder(const std::string& path);
/// Takes a file away, if it is there.
std::optional<NotWritten> take_away(const std::string& path);
/// A text on standard output, and how that ended; a failure is told.
Status print(const std::string& text, Language language);
/// Says what could not be written.
Status fail_to_write(const NotWritten& failure, Language language);

}  // namespace kinegraph::app
