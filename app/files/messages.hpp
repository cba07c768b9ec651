// Exit statuses and messages on standard error. One message is one line, even if a file name contains control
// characters.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lang/words.hpp"

namespace kinegraph::app {

/// Exit statuses, as defined in docs/command_line.md.
enum class Status {
    done = 0,
    difference = 1,     ///< two pictures differ
    not_shut_down = 1,  ///< an editor ended the language server, or itself, without notice
    bad_input = 2,      ///< wrong command line or file: nothing is written
    unsolved = 3,       ///< some results have no unique value: the others are written
    output = 4,         ///< an output cannot be written, or the font is missing
    fault = 70,         ///< an internal error
};

/// Control characters as \n, \t or \x1b, so that a message stays one line.
std::string one_line(std::string_view text);
/// The name of a file in messages: its path as given, or "standard input".
Words spoken(const std::string& file);
/// Writes "SUBJECT: MESSAGE" to standard error; the subject is the name of a file or of the program.
void say(const Words& subject, const Words& message, Language language);
/// Writes "SUBJECT: remark: MESSAGE" for each remark.
void remark(const Words& subject, const std::vector<Text>& remarks, Language language);
/// Writes "SUBJECT: unsolved: WHAT: WHY".
void say_unsolved(const Words& subject, const Text& what, const Text& why, Language language);
/// While it exists, the messages of its thread are collected instead of going to standard error. At most one for each
/// thread.
class Hearing {
public:
    Hearing();
    Hearing(const Hearing&) = delete;
    Hearing& operator=(const Hearing&) = delete;
    ~Hearing();
    /// Returns the collected lines, without their line feeds, and clears them.
    std::vector<std::string> take();

private:
    friend void say(const Words& subject, const Words& message, Language language);
    std::vector<std::string> lines_;
};
/// Reports a command line that cannot be executed.
Status refuse(const Words& message, Language language);
/// Reports every fault of a file, one on each line, and returns the exit status.
Status say(const Words& file, const Diagnostics& faults, Language language);

}  // namespace kinegraph::app
