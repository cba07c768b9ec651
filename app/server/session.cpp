#include "app/server/session.hpp"

#include <sys/random.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <stdexcept>

namespace kinegraph::app {

Interruption::Interruption() {
    sigset_t signals;
    ::sigemptyset(&signals);
    for (const int each : {SIGINT, SIGTERM, SIGHUP}) ::sigaddset(&signals, each);
    ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    descriptor_ = ::signalfd(-1, &signals, SFD_NONBLOCK | SFD_CLOEXEC);
    if (descriptor_ < 0) throw std::runtime_error("signals cannot be waited for");
}
Interruption::~Interruption() { ::close(descriptor_); }

bool Interruption::has_come() const {
    signalfd_siginfo signal{};
    return ::read(descriptor_, &signal, sizeof signal) > 0;
}

std::string secret_name() {
    std::array<unsigned char, 16> random{};
    if (::getrandom(random.data(), random.size(), 0) != static_cast<ssize_t>(random.size()))
        throw std::runtime_error("the system gives no random numbers");
    constexpr const char* digits = "0123456789abcdef";
    std::string name;
    for (const unsigned char byte : random) {
        name += digits[byte >> 4U];
        name += digits[byte & 15U];
    }
    return name;
}

}  // namespace kinegraph::app
