// An editor that talks to `kinegraph language-server` through pipes, as editors do.
#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace kinegraph::tests {

using Json = nlohmann::ordered_json;

class Editor {
public:
    /// Starts the server.
    explicit Editor(const std::string& language = "");
    Editor(const Editor&) = delete;
    Editor& operator=(const Editor&) = delete;
    ~Editor();

    void send_bytes(std::string_view bytes);
    void send(const Json& message);
    void tell(const std::string& method, Json parameters);
    /// The answer; what the server says of itself in between is kept for told().
    Json ask(const std::string& method, Json parameters);
    /// The next message that answers nothing; null at the end of the output, or after a minute.
    Json told();

    void open(const std::string& uri, const std::string& text, int version = 1);
    /// The diagnostics of the version.
    Json faults_of(const std::string& uri, int version);
    /// completion or hover at a byte of the text.
    Json at(const std::string& uri, const std::string& text, std::size_t offset, const std::string& what);

    /// The exit status, when the server has ended; closes its input.
    int end();

private:
    Json next();
    pid_t server_ = -1;
    int to_ = -1, from_ = -1, asked_ = 0;
    std::string waiting_;
    std::vector<Json> told_;
};

/// The bytes of a message.
std::string frame(std::string_view message);
/// {"line", "character"} of a byte, counted anew: the server's own counting is under test.
Json position(std::string_view text, std::size_t offset);
/// The byte of a position.
std::size_t offset(std::string_view text, const Json& position);

}  // namespace kinegraph::tests
