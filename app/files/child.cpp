#include "app/files/child.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>

namespace kinegraph::app {
namespace {

constexpr int not_found = 127;  // exit status, as in a shell

bool write_all_of(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

/// Executed in the child; never returns.
[[noreturn]] void become(char* const* words, const ChildLimits& limits, int in, int out, int err) {
    const auto limit = [](auto resource, std::uint64_t most) {
        const rlimit both{most, most};
        ::setrlimit(resource, &both);
    };
    limit(RLIMIT_CPU, limits.seconds);
    limit(RLIMIT_AS, limits.memory);
    limit(RLIMIT_FSIZE, limits.file);
    limit(RLIMIT_CORE, 0);
    if (::dup2(in, STDIN_FILENO) >= 0 && ::dup2(out, STDOUT_FILENO) >= 0 && ::dup2(err, STDERR_FILENO) >= 0)
        ::execvp(words[0], words);
    ::_exit(not_found);
}

/// The exit status; empty if a signal ended the child.
std::optional<int> wait_for(pid_t child) {
    int status = 0;
    while (::waitpid(child, &status, 0) < 0)
        if (errno != EINTR) return std::nullopt;
    return WIFEXITED(status) ? std::optional(WEXITSTATUS(status)) : std::nullopt;
}

}  // namespace

MemoryFile::MemoryFile() : file_(::memfd_create("kinegraph", MFD_CLOEXEC)) {}
MemoryFile::~MemoryFile() {
    if (file_ >= 0) ::close(file_);
}
bool MemoryFile::fill(std::string_view bytes) const {
    return write_all_of(file_, bytes) && ::lseek(file_, 0, SEEK_SET) == 0;
}
std::string MemoryFile::contents() const {
    std::string bytes;
    std::array<char, 65536> piece{};
    ::lseek(file_, 0, SEEK_SET);
    for (;;) {
        const ssize_t got = ::read(file_, piece.data(), piece.size());
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return bytes;
        bytes.append(piece.data(), static_cast<std::size_t>(got));
    }
}

tl::expected<ChildAnswer, int> run_child(const std::vector<std::string>& words, const ChildLimits& limits,
                                         const NextPiece& input) {
    const MemoryFile out, err;
    std::array<int, 2> pipe{};
    if (!out.is_open() || !err.is_open() || ::pipe2(pipe.data(), O_CLOEXEC) != 0) return tl::unexpected(errno);
    std::vector<std::string> own = words;
    std::vector<char*> arguments;
    for (std::string& word : own) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const pid_t child = ::fork();
    if (child == 0) become(arguments.data(), limits, pipe[0], out.descriptor(), err.descriptor());
    const int why = errno;
    ::close(pipe[0]);
    // A child that has gone, or wants no more, breaks the pipe; its status says why.
    while (child > 0) {
        const std::string* const piece = input();
        if (piece == nullptr || !write_all_of(pipe[1], *piece)) break;
    }
    ::close(pipe[1]);
    if (child < 0) return tl::unexpected(why);
    const auto status = wait_for(child);
    return ChildAnswer{status, out.contents(), err.contents()};
}

}  // namespace kinegraph::app
