#include "app/files/line_reader.hpp"
#include "lang/keys/command_line.hpp"

#include <poll.h>
#include <pthread.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

namespace kinegraph::app {
namespace {

constexpr std::size_t read_at_once = std::size_t{1} << 16U;

/// Written by the signal handler, read by all threads.
std::atomic<int> stopped_by = 0;
static_assert(std::atomic<int>::is_always_lock_free);

void stop(int signal) { stopped_by = signal; }

sigset_t those_that_stop() {
    sigset_t set;
    ::sigemptyset(&set);
    ::sigaddset(&set, SIGINT);
    ::sigaddset(&set, SIGTERM);
    return set;
}

/// While it exists, the signals are blocked: none can arrive between the test of the flag and the wait for input.
class Held {
public:
    Held() {
        const sigset_t ours = those_that_stop();
        ::pthread_sigmask(SIG_BLOCK, &ours, &before_);
    }
    ~Held() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    Held(const Held&) = delete;
    Held& operator=(const Held&) = delete;
    const sigset_t& before() const { return before_; }

private:
    sigset_t before_{};
};

/// Waits for input, its end, or a signal. True: something can be read.
bool input_comes() {
    const Held held;
    if (stopped_by != 0) return false;
    pollfd input{STDIN_FILENO, POLLIN, 0};
    return ::ppoll(&input, 1, nullptr, &held.before()) > 0;
}

}  // namespace

LineReader::LineReader() {
    struct sigaction action {};
    action.sa_handler = stop;
    action.sa_flags = SA_RESTART;
    ::sigemptyset(&action.sa_mask);
    for (const int signal : {SIGINT, SIGTERM}) ::sigaction(signal, &action, nullptr);
    const sigset_t ours = those_that_stop();
    ::pthread_sigmask(SIG_UNBLOCK, &ours, nullptr);
}

LineReader::~LineReader() {
    for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_DFL);
}

int LineReader::signal() { return stopped_by; }

bool LineReader::fill() {
    buffer_.erase(0, std::exchange(at_, 0));
    while (true) {
        const bool ready = input_comes();
        if (stopped_by != 0) {
            last_ = Event::stopped;
            return false;
        }
        if (!ready) continue;
        const std::size_t size = buffer_.size();
        buffer_.resize(size + read_at_once);
        const ssize_t got = ::read(STDIN_FILENO, buffer_.data() + size, read_at_once);
        const int error = errno;
        buffer_.resize(size + (got > 0 ? static_cast<std::size_t>(got) : 0));
        if (got > 0) return true;
        if (got < 0 && error == EINTR) continue;
        if (got < 0) why_ = Words(lang::command_line::cannot_be_read, std::string(std::strerror(error)));
        last_ = got < 0 ? Event::failed : Event::end;
        return false;
    }
}

LineReader::Event LineReader::next(std::string& line) {
    // Lines still in the buffer are not started.
    if (stopped_by != 0) return Event::stopped;
    bool long_one = false;
    std::size_t searched = at_;
    while (!ended_) {
        const std::size_t end = buffer_.find('\n', searched);
        if (end != std::string::npos) {
            if (!long_one) line.assign(buffer_, at_, end - at_);
            at_ = end + 1;
            return Event::line;
        }
        if (buffer_.size() - at_ > largest_input) {
            if (!std::exchange(long_one, true)) line.assign(buffer_, at_, largest_input + 1);
            at_ = buffer_.size();
        }
        searched = buffer_.size() - at_;
        if (!fill()) ended_ = true;
    }
    // The last line may lack its line feed. A line cut off by a signal or an error is not returned.
    if (last_ == Event::end && (long_one || at_ < buffer_.size())) {
        if (!long_one) line.assign(buffer_, at_);
        at_ = buffer_.size();
        return Event::line;
    }
    return last_;
}

}  // namespace kinegraph::app
