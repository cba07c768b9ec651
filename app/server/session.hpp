// What every command that serves pages needs: a secret path, and the signals that end it.
#pragma once

#include <string>

namespace kinegraph::app {

/// SIGINT and similar signals as a file descriptor that becomes readable. Threads that start later block these signals.
class Interruption {
public:
    Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;
    ~Interruption();

    int descriptor() const { return descriptor_; }
    bool has_come() const;

private:
    int descriptor_ = -1;
};

/// A secret path for the page: other users of this machine can reach its ports too.
std::string secret_name();

}  // namespace kinegraph::app
