// Other programs, run as child processes without a shell. Output is a file in memory, input a file in memory or pieces
// that are handed over one after another, so that neither process can block the other for ever.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace kinegraph::app {

/// An anonymous file in memory, freed when closed.
class MemoryFile {
public:
    MemoryFile();
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    ~MemoryFile();
    bool is_open() const { return file_ >= 0; }
    int descriptor() const { return file_; }
    bool fill(std::string_view bytes) const;
    std::string contents() const;

private:
    int file_;
};

struct ChildLimits {
    std::uint64_t seconds = 60;  ///< of CPU time
    std::uint64_t memory = std::uint64_t{4} << 30;
    std::uint64_t file = std::uint64_t{512} << 20;  ///< size of what it writes, bytes
};

struct ChildAnswer {
    std::optional<int> status;  ///< exit status; none: a signal ended it, such as that of a limit
    std::string output, messages;
    bool is_missing() const { return status == 127; }  ///< the program was not found
};

/// Gives the next piece of input; null at the end. It stays valid until the next call.
using NextPiece = std::function<const std::string*()>;

/// Runs the program that is called so on the search path. Its standard output is a file that it may also open by the
/// name /proc/self/fd/1. Error: the system's number (errno) why it could not be started.
tl::expected<ChildAnswer, int> run_child(const std::vector<std::string>& words, const ChildLimits& limits,
                                         const NextPiece& input);

}  // namespace kinegraph::app
