// The Language Server Protocol (3.17) for mechanism files: faults, completion, and what a key means. Messages in,
// messages out; it reads and writes no stream, and no file.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <kinegraph/error.hpp>
#include <nlohmann/json.hpp>

#include "app/editor/file_schema.hpp"
#include "app/editor/lines.hpp"

namespace kinegraph::app {

class LanguageServer {
public:
    using Message = nlohmann::json;

    /// Without a language that of the editor is used, where there is one.
    explicit LanguageServer(std::optional<Language> language);

    /// The answer to a message from the editor, JSON; empty where it wants none.
    std::string answer(std::string_view message);
    /// The answer to a message that was too large to be read.
    static std::string refusal();
    /// A line for the editor's log.
    static std::string complaint(const std::string& fault);
    /// Whether there is a document whose faults have not been told since it changed.
    bool has_news() const { return !changed_.empty(); }
    /// The faults of such a document, as a message to the editor.
    std::string next_news();

    bool has_ended() const { return stage_ == Stage::ended; }
    /// Whether the editor took its leave before it ended the server.
    bool was_shut_down() const { return was_shut_down_; }

private:
    using Json = nlohmann::ordered_json;
    enum class Stage { started, serving, shut_down, ended };
    struct Document {
        std::string text;
        Json version;
    };

    Json answered(const Json& id, const std::string& method, const Message& parameters);
    Json initialize(const Message& parameters);
    Json complete(const std::string& text, LinePlace place) const;
    Json hover(const std::string& text, LinePlace place) const;
    void notice(const std::string& method, const Message& parameters);
    void set(const Message& document, const Message& text);
    void close(const std::string& uri);

    std::optional<Language> language_;
    FileSchema schema_;
    Stage stage_ = Stage::started;
    bool was_shut_down_ = false;
    std::map<std::string, Document> documents_;
    std::deque<std::string> changed_;  ///< addresses of documents, each once
};

}  // namespace kinegraph::app
