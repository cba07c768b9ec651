// Messages on standard error.
#include "app/files/messages.hpp"
#include "lang/keys/command_line.hpp"
#include "lang/keys/notation.hpp"

#include <cstdio>
#include <stdexcept>
#include <utility>

namespace kinegraph::app {
namespace {

/// The object that collects the messages of this thread; null: they go to standard error.
thread_local Hearing* hearing = nullptr;

}  // namespace

Hearing::Hearing() {
    if (hearing != nullptr) throw std::logic_error("the messages of a thread are collected once at a time");
    hearing = this;
}
Hearing::~Hearing() { hearing = nullptr; }
std::vector<std::string> Hearing::take() { return std::exchange(lines_, {}); }

std::string one_line(std::string_view text) {
    std::string line;
    for (const char letter : text) {
        const auto code = static_cast<unsigned char>(letter);
        if (letter == '\n') {
            line += "\\n";
        } else if (letter == '\t') {
            line += "\\t";
        } else if (code < 0x20 || code == 0x7f) {
            constexpr const char* digits = "0123456789abcdef";
            line += "\\x";
            line += digits[code >> 4];
            line += digits[code & 15];
        } else {
            line += letter;
        }
    }
    return line;
}

Words spoken(const std::string& file) { return file == "-" ? Words(lang::command_line::standard_input) : Words(file); }

void say(const Words& subject, const Words& message, Language language) {
    std::string line =
        one_line(in(subject, language)) + in(lang::notation::colon, language) + one_line(in(message, language));
    if (hearing != nullptr) {
        hearing->lines_.push_back(std::move(line));
        return;
    }
    // One write for each line, so that the lines of two programs on one terminal do not mix.
    line += '\n';
    std::fwrite(line.data(), 1, line.size(), stderr);
}

Status refuse(const Words& message, Language language) {
    say(std::string_view("kinegraph"), message, language);
    return Status::bad_input;
}

Status say(const Words& file, const Diagnostics& faults, Language language) {
    Status status = Status::bad_input;
    for (const Diagnostic& fault : faults) {
        say(file, fault.place.empty() ? Words(fault.text) : Words(fault.place) + lang::notation::colon + fault.text,
            language);
        if (fault.kind == Diagnostic::Kind::output) status = Status::output;
        if (fault.kind == Diagnostic::Kind::no_unique_answer) status = Status::unsolved;
    }
    return status;
}

void remark(const Words& subject, const std::vector<Text>& remarks, Language language) {
    for (const Text& each : remarks) say(subject, Words(lang::command_line::remark, each), language);
}

void say_unsolved(const Words& subject, const Text& what, const Text& why, Language language) {
    say(subject, Words(lang::command_line::unsolved, what, why), language);
}

}  // namespace kinegraph::app
