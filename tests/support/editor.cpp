#include "tests/support/editor.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <utility>

namespace kinegraph::tests {

Editor::Editor(const std::string& language) {
    std::array<int, 2> to{}, from{};
    if (::pipe2(to.data(), O_CLOEXEC) != 0 || ::pipe2(from.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    std::signal(SIGPIPE, SIG_IGN);
    const std::string lang = "--lang=" + language;
    server_ = ::fork();
    if (server_ == 0) {
        ::dup2(to[0], STDIN_FILENO);
        ::dup2(from[1], STDOUT_FILENO);
        ::execl(KINEGRAPH_PROGRAM, "kinegraph", "language-server", language.empty() ? nullptr : lang.c_str(), nullptr);
        ::_exit(127);
    }
    ::close(to[0]);
    ::close(from[1]);
    to_ = to[1];
    from_ = from[0];
}

Editor::~Editor() {
    if (server_ > 0) end();
}

int Editor::end() {
    ::close(std::exchange(to_, -1));
    ::close(std::exchange(from_, -1));
    int status = 0;
    ::waitpid(std::exchange(server_, -1), &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

void Editor::send_bytes(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(to_, bytes.data(), bytes.size());
        if (count <= 0) return;
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
}

std::string frame(std::string_view message) {
    return "Content-Length: " + std::to_string(message.size()) + "\r\n\r\n" + std::string(message);
}

void Editor::send(const Json& message) { send_bytes(frame(message.dump())); }

void Editor::tell(const std::string& method, Json parameters) {
    send({{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(parameters)}});
}

Json Editor::next() {
    while (true) {
        const std::size_t head = waiting_.find("\r\n\r\n");
        if (head != std::string::npos) {
            const std::string name = "Content-Length: ";
            EXPECT_TRUE(waiting_.starts_with(name)) << waiting_.substr(0, 80);
            const std::size_t size = std::stoul(waiting_.substr(name.size()));
            if (waiting_.size() >= head + 4 + size) {
                Json message = Json::parse(waiting_.substr(head + 4, size));
                waiting_.erase(0, head + 4 + size);
                EXPECT_EQ(message["jsonrpc"], "2.0");
                return message;
            }
        }
        pollfd output{from_, POLLIN, 0};
        std::array<char, 65536> bytes{};
        if (::poll(&output, 1, 60000) <= 0) return nullptr;
        const ssize_t count = ::read(from_, bytes.data(), bytes.size());
        if (count <= 0) return nullptr;
        waiting_.append(bytes.data(), static_cast<std::size_t>(count));
    }
}

Json Editor::ask(const std::string& method, Json parameters) {
    send({{"jsonrpc", "2.0"}, {"id", ++asked_}, {"method", method}, {"params", std::move(parameters)}});
    while (true) {
        Json message = next();
        if (message.is_null() || (message.contains("id") && message["id"] == asked_)) return message;
        told_.push_back(std::move(message));
    }
}

Json Editor::told() {
    if (told_.empty()) return next();
    Json first = std::move(told_.front());
    told_.erase(told_.begin());
    return first;
}

void Editor::open(const std::string& uri, const std::string& text, int version) {
    tell("textDocument/didOpen",
         {{"textDocument", {{"uri", uri}, {"languageId", "json"}, {"version", version}, {"text", text}}}});
}

Json Editor::faults_of(const std::string& uri, int version) {
    while (true) {
        const Json message = told();
        if (message.is_null()) return nullptr;
        if (message.value("method", "") != "textDocument/publishDiagnostics") continue;
        const Json& parameters = message["params"];
        if (parameters["uri"] == uri && parameters.value("version", 0) == version) return parameters["diagnostics"];
    }
}

Json Editor::at(const std::string& uri, const std::string& text, std::size_t offset, const std::string& what) {
    const Json answer =
        ask("textDocument/" + what, {{"textDocument", {{"uri", uri}}}, {"position", position(text, offset)}});
    EXPECT_TRUE(answer.is_object() && answer.contains("result")) << answer;
    return answer.is_object() && answer.contains("result") ? answer["result"] : Json();
}

Json position(std::string_view text, std::size_t offset) {
    std::size_t line = 0, units = 0;
    for (std::size_t i = 0; i < offset; ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        if (text[i] == '\n') {
            ++line;
            units = 0;
        } else if (byte >= 0xF0) {
            units += 2;
        } else if (byte < 0x80 || byte >= 0xC0) {
            units += 1;
        }
    }
    return {{"line", line}, {"character", units}};
}

std::size_t offset(std::string_view text, const Json& wanted) {
    for (std::size_t i = 0; i < text.size(); ++i)
        if ((static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U && position(text, i) == wanted) return i;
    return text.size();
}

}  // namespace kinegraph::tests
