// What the command line says: exit statuses and lines on standard error. One message is one line, whatever a file's
// name holds.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/file/error.hpp"
#include "render/text/words.hpp"

namespace kinegraph::app {

/// Exit statuses, as docs/command_line.md fixes them.
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
using render::Language;
/// "SUBJECT: MESSAGE" on standard error; the subject is a file's name, or the program's.
void say(const Words& subject, const Words& message, Language language);
/// While it lives, what is said on its thread is kept here in place of going to standard error. One at a time on a
/// thread.
class Hearing {
public:
    Hearing();
    Hearing(const Hearing&) = delete;
    Hearing& operator=(const Hearing&) = delete;
    ~Hearing();
    /// The lines so far, without their line feeds; from then on it hears anew.
    std::vector<std::string> take();

private:
    friend void say(const Words& subject, const Words& message, Language language);
    std::vector<std::string> lines_;
};
/// The same for a command line that cannot be carried out.
Status refuse(const Words& message, Language language);
/// Every error of a file, one a line, and the status they lead to.
Status say(const Words& file, const Errors& errors, Language language);

}  // namespace kinegraph::app
