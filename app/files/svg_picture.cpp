// Runs rsvg-convert as a child process. Its input and output are files in memory, so neither process can block the
// other.
#include "app/files/svg_picture.hpp"
#include "lang/keys/command_line.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string_view>

namespace kinegraph::app {
namespace {

constexpr rlim_t longest = 60;                // CPU time, s
constexpr rlim_t largest = rlim_t{4} << 30;   // memory, bytes
constexpr rlim_t longest_answer = 512 << 20;  // size of the picture, bytes
constexpr int not_found = 127;                // exit status, as in a shell

/// An anonymous file in memory, freed when closed.
class MemoryFile {
public:
    MemoryFile() : file_(::memfd_create("kinegraph", MFD_CLOEXEC)) {}
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    ~MemoryFile() {
        if (file_ >= 0) ::close(file_);
    }
    int descriptor() const { return file_; }

    bool fill(std::string_view bytes) const {
        while (!bytes.empty()) {
            const ssize_t written = ::write(file_, bytes.data(), bytes.size());
            if (written < 0 && errno == EINTR) continue;
            if (written < 0) return false;
            bytes.remove_prefix(static_cast<std::size_t>(written));
        }
        return ::lseek(file_, 0, SEEK_SET) == 0;
    }
    std::string contents() const {
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

private:
    int file_;
};

/// Executed in the child; never returns.
[[noreturn]] void become_rsvg_convert(const MemoryFile& in, const MemoryFile& out, const MemoryFile& err,
                                      const std::string& dpi) {
    const auto limit = [](auto resource, rlim_t most) {
        const rlimit both{most, most};
        ::setrlimit(resource, &both);
    };
    limit(RLIMIT_CPU, longest);
    limit(RLIMIT_AS, largest);
    limit(RLIMIT_FSIZE, longest_answer);
    limit(RLIMIT_CORE, 0);
    if (::dup2(in.descriptor(), STDIN_FILENO) >= 0 && ::dup2(out.descriptor(), STDOUT_FILENO) >= 0 &&
        ::dup2(err.descriptor(), STDERR_FILENO) >= 0)
        ::execlp("rsvg-convert", "rsvg-convert", "--format", "png", "--accept-language", "en", "--dpi-x", dpi.c_str(),
                 "--dpi-y", dpi.c_str(), static_cast<char*>(nullptr));
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

tl::expected<std::string, NotDrawn> svg_to_png(const std::string& svg, double dpi) {
    const MemoryFile in, out, err;
    if (out.descriptor() < 0 || err.descriptor() < 0 || in.descriptor() < 0 || !in.fill(svg))
        return tl::unexpected(
            NotDrawn{Status::output, {lang::command_line::no_memory_for_drawing, std::string(std::strerror(errno))}});
    const std::string resolution = std::to_string(dpi);
    const pid_t child = ::fork();
    if (child < 0)
        return tl::unexpected(NotDrawn{
            Status::output, {lang::command_line::rsvg_convert_cannot_be_started, std::string(std::strerror(errno))}});
    if (child == 0) become_rsvg_convert(in, out, err, resolution);
    const auto status = wait_for(child);
    if (status == not_found)
        return tl::unexpected(NotDrawn{Status::output, {lang::command_line::an_svg_is_compared_by_means}});
    if (!status) return tl::unexpected(NotDrawn{Status::bad_input, {lang::command_line::is_no_svg}});
    if (*status != 0) {
        std::string why = err.contents();
        while (!why.empty() && why.back() == '\n') why.pop_back();
        return tl::unexpected(NotDrawn{Status::bad_input, {lang::command_line::is_no_svg_that_can_be_drawn, why}});
    }
    return out.contents();
}

}  // namespace kinegraph::app
