// Assertions that stay on in release: a fault of ours, never of the user's file. Caught only in main (exit 70).
#pragma once

#include <stdexcept>
#include <string>

namespace kinegraph {

/// Our own fault: a broken promise inside the program.
class Fault : public std::logic_error {
    using std::logic_error::logic_error;
};

[[noreturn]] inline void fault(const char* file, int line, const char* condition, const std::string& why) {
    throw Fault(std::string(file) + ":" + std::to_string(line) + ": " + why + " (" + condition + ")");
}

}  // namespace kinegraph

#define KG_ASSERT(condition, why)                                                  \
    do {                                                                           \
        if (!(condition)) ::kinegraph::fault(__FILE__, __LINE__, #condition, why); \
    } while (false)
