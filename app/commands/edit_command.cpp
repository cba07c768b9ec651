// edit FILE: serves the workbench (web/src), answers its requests, and saves the file. The page, its parts and the
// examples are in the program; no other file of the machine can be read, and only FILE can be written.
#include <sys/stat.h>

#include <cerrno>
#include <cstdlib>
#include <memory>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/commands/commands.hpp"
#include "app/files/files.hpp"
#include "app/server/local_server.hpp"
#include "app/server/session.hpp"
#include "app/workbench/answer.hpp"
#include "app/workbench/web_files.hpp"
#include "lang/keys/command_line.hpp"
#include "lang/keys/common.hpp"

namespace kinegraph::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr int between_turns = 1000;  // ms; the server wakes whenever there is something to do
/// The largest request, bytes: the text of a file twice, when it is saved, as JSON.
constexpr std::size_t largest_request = std::size_t{16} << 20;

std::shared_ptr<const std::string> shared_text(std::string text) {
    return std::make_shared<const std::string>(std::move(text));
}
std::string as_text(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

/// The one file that is edited.
class EditedFile {
public:
    EditedFile(std::string path, Language language) : path_(std::move(path)), language_(language) {}

    bool exists() const {
        struct stat status {};
        return ::stat(path_.c_str(), &status) == 0 || errno != ENOENT;
    }
    /// {"name": "four_bar.json", "text": "…"}; a text of null: there is no file yet.
    Json as_json() const {
        Json json{{"name", bare_name(path_)}, {"text", nullptr}};
        if (!exists()) return json;
        if (const auto text = content())
            json["text"] = *text;
        else
            json["fault"] = text.error().in(language_);
        return json;
    }
    /// Saves "text" if the file still has the content "base" (null: does not exist).
    HttpAnswer save(const std::string& request_json) const {
        const Json request = Json::parse(request_json, nullptr, false);
        if (!request.is_object() || !request.contains("text") || !request["text"].is_string() ||
            !request.contains("base"))
            return answer_of(400, {{"fault", "text and base are wanted"}});
        const Json now = as_json();
        if (now.contains("fault")) return answer_of(500, {{"fault", now["fault"]}});
        if (now["text"] != request["base"]) return answer_of(409, now);
        const auto failure = write_all({{path_, request["text"].get<std::string>()}});
        if (!failure) return answer_of(200, {{"saved", true}});
        const Words why(lang::command_line::cannot_be_written, failure->why);
        return answer_of(500, {{"fault", failure->path.in(language_) + ": " + why.in(language_)}});
    }
    static HttpAnswer answer_of(int status, const Json& body) {
        HttpAnswer answer;
        answer.status = status;
        answer.type = "application/json; charset=utf-8";
        answer.body = shared_text(as_text(body));
        return answer;
    }

private:
    /// Of a plain file alone, since reading a pipe would wait for who writes it.
    tl::expected<std::string, Words> content() const {
        struct stat status {};
        if (::stat(path_.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode))
            return tl::unexpected(Words(lang::command_line::is_no_plain_file_which_could));
        auto text = read_whole(path_, {lang::common::mechanism_file});
        // Elsewhere each such byte would become U+FFFD, and be saved so.
        if (text && !is_utf8(*text)) return tl::unexpected(Words(lang::command_line::this_is_no_utf_8_save));
        return text;
    }

    std::string path_;
    Language language_;
};

/// What is served, by path.
class Workbench {
public:
    Workbench(EditedFile file, Language language)
        : path_("/" + secret_name() + "/"),
          file_(std::move(file)),
          page_(shared_text(workbench_page(code_of(language)))),
          examples_(shared_text(examples_json())) {}

    const std::string& path() const { return path_; }
    std::size_t accepts(const HttpHead& head) const {
        const bool is_request = head.target == path_ + "answer" || head.target == path_ + "save";
        return head.method == "POST" && is_request ? largest_request : 0;
    }
    HttpAnswer answer(const HttpHead& head, const std::string& body, AnswerQueue& queue) const {
        HttpAnswer answer;
        if (!head.target.starts_with(path_)) return status_alone(404);
        const std::string_view target = std::string_view(head.target).substr(path_.size());
        const bool is_request = target == "answer" || target == "save";
        if (is_request && head.method != "POST") return not_allowed("POST");
        if (target == "save") return file_.save(body);
        if (target == "answer") {
            answer.type = "application/json; charset=utf-8";
            answer.later = queue.ask(body);
            return answer;
        }
        answer.body = content(target, answer.type);
        if (!answer.body) return status_alone(404);
        if (head.method != "GET" && head.method != "HEAD") return not_allowed("GET, HEAD");
        answer.more = "Content-Security-Policy: frame-ancestors 'none'\r\n";
        return answer;
    }

private:
    static HttpAnswer status_alone(int status) {
        HttpAnswer answer;
        answer.status = status;
        return answer;
    }
    static HttpAnswer not_allowed(const std::string& allowed) {
        HttpAnswer answer = status_alone(405);
        answer.more = "Allow: " + allowed + "\r\n";
        return answer;
    }
    std::shared_ptr<const std::string> content(std::string_view target, std::string& type) const {
        type = media_type_of(target.empty() ? "index.html" : target);
        if (target.empty()) return page_;
        if (target == "examples.json") return examples_;
        if (target == "file.json") return shared_text(as_text(file_.as_json()));
        const WebFile* const file = target == "index.html" ? nullptr : web_file(target);
        return file == nullptr ? nullptr : shared_text(std::string(file->text));
    }

    std::string path_;
    EditedFile file_;
    std::shared_ptr<const std::string> page_, examples_;
};

Words why_not_edited(const std::string& file) {
    if (file == "-") return {lang::command_line::edit_needs_a_file};
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0) return errno == ENOENT ? Words() : read_whole(file, {}).error();
    if (!S_ISREG(status.st_mode)) return {lang::command_line::is_no_plain_file_which_could};
    const auto text = read_whole(file, {lang::common::mechanism_file});
    return text ? Words() : text.error();
}

}  // namespace

Status edit_command(const EditRequest& request) {
    const Language language = request.language;
    if (request.file.empty()) return refuse({lang::command_line::edit_needs_a_file}, language);
    if (const Words why = why_not_edited(request.file); !why.empty()) {
        say(spoken(request.file), why, language);
        return Status::bad_input;
    }
    const Workbench bench(EditedFile(request.file, language), language);
    auto server = LocalServer::open(request.port, [&](const HttpHead& head) { return bench.accepts(head); });
    if (!server) {
        refuse({lang::command_line::port_of_127_0_0_1, std::to_string(request.port), server.error()}, language);
        return Status::output;
    }
    const Interruption interruption;
    const std::string address = "http://127.0.0.1:" + std::to_string(server->port()) + bench.path() + "\n";
    if (const Status printed = print(address, language); printed != Status::done) return printed;
    AnswerQueue queue([](const std::string& json) { return workbench_answer(json); }, [&] { server->wake(); });
    const Answering answer = [&](const HttpHead& head, const std::string& body) {
        return bench.answer(head, body, queue);
    };
    while (!interruption.has_come()) server->serve(between_turns, interruption.descriptor(), answer);
    // Does not wait for a long solution: its result would be discarded.
    if (queue.is_busy()) std::_Exit(static_cast<int>(Status::done));
    return Status::done;
}

}  // namespace kinegraph::app
