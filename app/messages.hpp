// What the command line says: exit statuses and lines on standard error. One message is one line, whatever a file's name holds.
#pragma once

#include <string>
#include <string_view>

#include "engine/error.hpp"

namespace kinegraph::app {

/// Exit statuses, as docs/format.md fixes them.
enum class Status {
    done = 0,
    difference = 1,  ///< of two pictures
    bad_input = 2,   ///< the command line or the file is wrong: nothing is written
    unsolved = 3,    ///< no unique answer here: what could be found is written
    output = 4,      ///< the output can't be written, or the font is missing
    fault = 70,      ///< our own
};

/// Control characters as \n, \t or \x1b, so that a line stays one.
std::string one_line(std::string_view text);
/// "SUBJECT: MESSAGE" on standard error.
void say(std::string_view subject, std::string_view message);
/// Every error of a file, one a line, and the status they lead to.
Status say(std::string_view file, const Errors& errors);

}  // namespace kinegraph::app
