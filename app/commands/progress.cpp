#include "app/commands/progress.hpp"

#include <unistd.h>

#include <cstdio>

namespace kinegraph::app {

Progress::Progress() : shows_(::isatty(STDERR_FILENO) != 0) {}
Progress::~Progress() {
    if (shown_) std::fputs("\r     \r", stderr);
}
void Progress::at(long done, long all) {
    constexpr long seldom = 16;  // a position may need a new plan, which takes milliseconds
    if (!shows_ || done % seldom != 0) return;
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return;
    next_ = now + std::chrono::milliseconds(200);
    shown_ = true;
    std::fprintf(stderr, "\r%3ld %%", 100 * done / all);
}

}  // namespace kinegraph::app
