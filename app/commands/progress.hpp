// Progress on a terminal, shown if the run takes over a second.
#pragma once

#include <chrono>

namespace kinegraph::app {

class Progress {
public:
    Progress();
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    void at(long done, long all);

private:
    bool shows_, shown_ = false;
    std::chrono::steady_clock::time_point next_ = std::chrono::steady_clock::now() + std::chrono::seconds(1);
};

}  // namespace kinegraph::app
