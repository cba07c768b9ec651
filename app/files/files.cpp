// Reads whole files and writes all files or none, by plain POSIX calls. Every call is checked.
#include "app/files/files.hpp"
#include "lang/keys/command_line.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string_view>
#include <system_error>
#include <utility>

namespace kinegraph::app {
namespace {

/// The system's error message; the most frequent ones in the language of the reader.
Words reason() {
    switch (errno) {
        case ENOENT: return lang::command_line::no_such_file;
        case EACCES: return lang::command_line::permission_denied;
        case EPERM: return lang::command_line::not_permitted;
        case EISDIR: return lang::command_line::is_a_directory;
        case ENOTDIR: return lang::command_line::not_a_directory;
        case ENOSPC: return lang::command_line::no_space_left;
        case EROFS: return lang::command_line::read_only;
        case EFBIG: return lang::command_line::file_too_large;
        case EPIPE: return lang::command_line::broken_pipe;
        default: return std::string(std::strerror(errno));
    }
}

std::string folder_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    if (slash == std::string::npos) return ".";
    return slash == 0 ? "/" : path.substr(0, slash);
}

bool write_to(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        // A pipe or terminal that was set non-blocking by whoever shares it: it is full for now.
        if (written < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
            pollfd output{file, POLLOUT, 0};
            if (::poll(&output, 1, -1) < 0 && errno != EINTR) return false;
            continue;
        }
        if (written < 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

/// Resolves symbolic links to the file that will be replaced, so that a link remains a link.
std::string followed(std::string path) {
    for (int links = 0; links < 40; ++links) {
        char target[PATH_MAX];
        const ssize_t length = ::readlink(path.c_str(), target, sizeof target);
        if (length < 0 || static_cast<std::size_t>(length) == sizeof target) break;
        const std::string to(target, static_cast<std::size_t>(length));
        path = to.starts_with('/') ? to : folder_of(path).append(1, '/').append(to);
    }
    return path;
}

/// The names of temporary files, so that a signal that ends the process removes them. Nodes are reused and never freed:
/// the handler may run at any time.
class TemporaryNames {
public:
    static constexpr int signals[] = {SIGINT, SIGTERM, SIGHUP};
    static void add(const std::string& name) {
        static const bool handled = handle_signals();
        (void)handled;
        Node* free = first();
        while (free != nullptr && free->in_use) free = free->next;
        if (free == nullptr) {
            free = new Node{};
            free->next = first();
            first() = free;
        }
        free->name = name;
        free->in_use = true;
    }
    static void remove(const std::string& name) {
        for (Node* each = first(); each != nullptr; each = each->next)
            if (each->in_use && each->name == name) each->in_use = false;
    }

private:
    struct Node {
        std::string name;
        std::atomic<bool> in_use = false;
        Node* next = nullptr;
    };
    static std::atomic<Node*>& first() {
        static std::atomic<Node*> head = nullptr;
        return head;
    }
    static void remove_all(int signal) {
        for (const Node* each = first(); each != nullptr; each = each->next)
            if (each->in_use) ::unlink(each->name.c_str());
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
    /// Signals that the command handles itself, or that are ignored, stay as they are.
    static bool handle_signals() {
        first();
        for (const int signal : signals) {
            struct sigaction before {};
            if (::sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_DFL)
                std::signal(signal, remove_all);
        }
        return true;
    }
};

class SignalsHeld {
public:
    SignalsHeld() {
        sigset_t set;
        ::sigemptyset(&set);
        for (const int signal : TemporaryNames::signals) ::sigaddset(&set, signal);
        ::pthread_sigmask(SIG_BLOCK, &set, &before_);
    }
    SignalsHeld(const SignalsHeld&) = delete;
    SignalsHeld& operator=(const SignalsHeld&) = delete;
    ~SignalsHeld() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

private:
    sigset_t before_;
};

void remove_temporary(std::string& name) {
    if (name.empty()) return;
    ::unlink(name.c_str());
    TemporaryNames::remove(name);
    name.clear();
}

std::string temporary_beside(const std::string& target, int number) {
    return folder_of(target) + "/.kinegraph-" + std::to_string(::getpid()) + '-' + std::to_string(number);
}
/// Creates a temporary file beside the target; < 0 on failure.
int create_beside(const std::string& target, std::string& name) {
    for (int number = 0; number < 10000; ++number) {
        const std::string candidate = temporary_beside(target, number);
        TemporaryNames::add(candidate);
        const int file = ::open(candidate.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file >= 0) {
            name = candidate;
            return file;
        }
        const int why = errno;
        TemporaryNames::remove(candidate);
        errno = why;
        if (why != EEXIST) return file;
    }
    return -1;
}

/// One output in progress; the destructor removes its temporary files.
class Pending {
public:
    explicit Pending(const Output& output) : output_(output) {}
    Pending(const Pending&) = delete;
    Pending& operator=(const Pending&) = delete;
    ~Pending() {
        if (renamed_ && !kept_) undo();
        remove_temporary(temporary_);
        remove_temporary(backup_);
    }

    /// Writes the temporary file beside the target and flushes it to disk; the target is unchanged.
    bool prepare() {
        if (output_.path == "-" || output_.written == "-") {
            to_stream_ = true;
            return true;
        }
        struct stat status {};
        existed_ = ::stat(output_.path.c_str(), &status) == 0;
        if (existed_ && S_ISDIR(status.st_mode)) return fails_with(EISDIR);
        if (existed_ && !S_ISREG(status.st_mode)) {
            to_stream_ = true;
            return true;
        }
        if (existed_ && ::access(output_.path.c_str(), W_OK) != 0) return false;
        ours_ = existed_ && (::geteuid() == 0 || ::geteuid() == status.st_uid);
        target_ = followed(output_.path);
        if (!output_.written.empty()) {
            temporary_ = output_.written;
            return !existed_ || ::chmod(temporary_.c_str(), status.st_mode & 07777) == 0;
        }
        const int file = create_beside(target_, temporary_);
        if (file < 0) return false;
        const bool written =
            write_to(file, output_.bytes) && (!existed_ || ::fchmod(file, status.st_mode & 07777) == 0);
        const int why = errno;
        if (::close(file) != 0 && written) return false;
        return written || fails_with(why);
    }
    /// Writes directly to a target that is not a regular file.
    bool stream() const {
        if (!to_stream_ || output_.written == "-") return true;
        if (output_.path == "-") return write_to(STDOUT_FILENO, output_.bytes);
        const int file = ::open(output_.path.c_str(), O_WRONLY | O_CLOEXEC);
        if (file < 0) return false;
        const bool written = write_to(file, output_.bytes);
        const int why = errno;
        if (::close(file) != 0 && written) return false;
        return written || fails_with(why);
    }
    bool rename(bool last) {
        if (to_stream_) return true;
        // A hard link to the old target allows to restore it if a later output of the run cannot be written. It is
        // omitted if the file system has no hard links, or if another user owns the file: then the link could not be
        // removed again.
        if (existed_ && ours_ && !last) back_up();
        if (::rename(temporary_.c_str(), target_.c_str()) != 0) return false;
        TemporaryNames::remove(temporary_);
        temporary_.clear();
        renamed_ = true;
        return true;
    }
    void keep() { kept_ = true; }
    const std::string& path() const { return output_.path; }

private:
    static bool fails_with(int why) {
        errno = why;
        return false;
    }
    std::string beside(int number) const { return temporary_beside(target_, number); }
    void back_up() {
        for (int number = 0; number < 10000; ++number) {
            const std::string candidate = beside(number);
            if (::link(target_.c_str(), candidate.c_str()) == 0) {
                backup_ = candidate;
                return;
            }
            if (errno != EEXIST) return;
        }
    }
    void undo() {
        if (!existed_)
            ::unlink(target_.c_str());
        else if (!backup_.empty() && ::rename(backup_.c_str(), target_.c_str()) == 0)
            backup_.clear();
    }

    const Output& output_;
    std::string target_, temporary_, backup_;
    bool existed_ = false, ours_ = false, to_stream_ = false, renamed_ = false, kept_ = false;
};

/// The error of the last system call.
NotWritten not_written(const std::string& path) {
    const Words why = reason();
    return {path == "-" ? Words(lang::command_line::standard_output) : Words(path), why};
}

}  // namespace

std::size_t character_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const std::size_t length = byte(0) < 0x80   ? 1
                               : byte(0) < 0xC2 ? 0
                               : byte(0) < 0xE0 ? 2
                               : byte(0) < 0xF0 ? 3
                               : byte(0) < 0xF5 ? 4
                                                : 0;
    if (length == 0 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xC0U) != 0x80U) return 0;
    return length;
}

bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        const std::size_t length = character_length(text);
        if (length == 0) return false;
        text.remove_prefix(length);
    }
    return true;
}

tl::expected<std::string, Words> read_whole(const std::string& path, const Words& kind) {
    const bool standard = path == "-";
    const int file = standard ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return tl::unexpected(Words(lang::command_line::cannot_be_read, reason()));
    struct stat status {};
    const bool known = ::fstat(file, &status) == 0;
    std::string text;
    Words why;
    if (known && S_ISDIR(status.st_mode)) {
        why = {lang::command_line::is_a_directory_not, kind};
    } else {
        const std::size_t expected = known && S_ISREG(status.st_mode)
                                         ? std::min(static_cast<std::size_t>(status.st_size), largest_input)
                                         : 65536;
        std::size_t size = 0;
        text.resize(expected + 1);  // one more, so that the end of file is seen without another resize
        while (why.empty()) {
            const ssize_t got = ::read(file, text.data() + size, text.size() - size);
            if (got == 0) break;
            if (got > 0) size += static_cast<std::size_t>(got);
            if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
                pollfd input{file, POLLIN, 0};
                ::poll(&input, 1, -1);
                continue;
            }
            if (got < 0 && errno != EINTR) why = {lang::command_line::cannot_be_read, reason()};
            if (size > largest_input) why = {lang::command_line::is_larger_than_64_mib_more, kind};
            if (size == text.size()) text.resize(2 * size);
        }
        text.resize(size);
    }
    if (!standard) ::close(file);
    if (!why.empty()) return tl::unexpected(why);
    return text;
}

bool same_file(const std::string& one, const std::string& other) {
    struct stat a {};
    struct stat b {};
    return ::stat(one.c_str(), &a) == 0 && ::stat(other.c_str(), &b) == 0 && a.st_dev == b.st_dev &&
           a.st_ino == b.st_ino;
}

std::optional<NotWritten> write_all(const std::vector<Output>& outputs) {
    std::vector<std::unique_ptr<Pending>> all;
    all.reserve(outputs.size());
    for (const Output& output : outputs) all.push_back(std::make_unique<Pending>(output));
    for (const auto& pending : all)
        if (!pending->prepare()) return not_written(pending->path());
    for (const auto& pending : all)
        if (!pending->stream()) return not_written(pending->path());
    // A signal that ends the process waits until all targets are new, or as before.
    const SignalsHeld held;
    std::optional<NotWritten> failure;
    for (const auto& pending : all) {
        if (failure || pending->rename(pending == all.back())) continue;
        failure = not_written(pending->path());
    }
    if (!failure)
        for (const auto& pending : all) pending->keep();
    all.clear();
    return failure;
}

tl::expected<Growing, NotWritten> Growing::open(const std::string& path) {
    Growing made;
    made.path_ = path;
    struct stat status {};
    const bool exists = ::stat(path.c_str(), &status) == 0;
    if (path == "-") {
        made.file_ = ::dup(STDOUT_FILENO);
    } else if (exists && S_ISDIR(status.st_mode)) {
        errno = EISDIR;
    } else if (exists && !S_ISREG(status.st_mode)) {
        made.file_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    } else {
        made.file_ = create_beside(followed(path), made.temporary_);
    }
    if (made.file_ < 0) return tl::unexpected(not_written(path));
    return made;
}
Growing::Growing(Growing&& other) noexcept
    : path_(std::move(other.path_)),
      temporary_(std::exchange(other.temporary_, {})),
      file_(std::exchange(other.file_, -1)) {}
Growing::~Growing() {
    if (file_ >= 0) ::close(file_);
    remove_temporary(temporary_);
}
std::optional<NotWritten> Growing::add(std::string_view bytes) {
    if (write_to(file_, bytes)) return std::nullopt;
    return not_written(path_);
}
Output Growing::finish() && {
    ::close(std::exchange(file_, -1));
    Output output{path_, {}, temporary_.empty() ? "-" : temporary_};
    temporary_.clear();
    return output;
}

std::optional<NotWritten> make_folder(const std::string& path) {
    std::error_code refused;
    std::filesystem::create_directories(path, refused);
    if (!refused) return std::nullopt;
    errno = refused.value();
    return not_written(path);
}

std::optional<NotWritten> take_away(const std::string& path) {
    if (::unlink(path.c_str()) == 0 || errno == ENOENT) return std::nullopt;
    return not_written(path);
}

Status print(const std::string& text, Language language) {
    if (const auto failure = write_all({{"-", text}})) return fail_to_write(*failure, language);
    return Status::done;
}

Status fail_to_write(const NotWritten& failure, Language language) {
    say(failure.path, {lang::command_line::cannot_be_written, failure.why}, language);
    return Status::output;
}

}  // namespace kinegraph::app
