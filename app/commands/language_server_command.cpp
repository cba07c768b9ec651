// language-server: messages of an editor on standard input, answers on standard output. The faults of a document are
// looked for while no message waits, so that a key that is typed never waits for them.
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <exception>
#include <string>
#include <string_view>

#include "app/commands/commands.hpp"
#include "app/editor/framing.hpp"
#include "app/editor/language_server.hpp"
#include "lang/keys/command_line.hpp"

namespace kinegraph::app {
namespace {

bool tell(const std::string& message) {
    const std::string bytes = message.empty() ? std::string() : framed(message);
    for (std::string_view rest = bytes; !rest.empty();) {
        const ssize_t written = ::write(STDOUT_FILENO, rest.data(), rest.size());
        if (written < 0 && errno != EINTR) return false;
        if (written > 0) rest.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

bool message_waits() {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    return ::poll(&input, 1, 0) > 0;
}

/// False at the end of the input.
bool read_more(Framing& framing) {
    std::array<char, 65536> bytes;  // NOLINT(cppcoreguidelines-pro-type-member-init): it is read into
    const ssize_t count = ::read(STDIN_FILENO, bytes.data(), bytes.size());
    if (count > 0) framing.add({bytes.data(), static_cast<std::size_t>(count)});
    return count > 0 || (count < 0 && errno == EINTR);
}

/// The next faults; where they cannot be found, for our fault or for lack of memory, the editor is told so.
std::string news_of(LanguageServer& server) {
    try {
        return server.next_news();
    } catch (const std::exception& fault) {
        return LanguageServer::complaint(fault.what());
    }
}

}  // namespace

Status language_server_command(const LanguageServerRequest& request) {
    LanguageServer server(request.language);
    Framing framing;
    std::string message;
    while (!server.has_ended()) {
        bool is_told = true;
        if (const auto event = framing.next(message)) {
            if (*event == Framing::Event::lost)
                return refuse({lang::command_line::a_message_has_no_length}, request.language.value_or(Language::en));
            is_told = tell(*event == Framing::Event::refused ? LanguageServer::refusal() : server.answer(message));
        } else if (server.has_news() && !message_waits()) {
            is_told = tell(news_of(server));
        } else if (!read_more(framing)) {
            break;
        }
        if (!is_told) return Status::output;
    }
    return server.was_shut_down() ? Status::done : Status::not_shut_down;
}

}  // namespace kinegraph::app
