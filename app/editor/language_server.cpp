#include "app/editor/language_server.hpp"

#include <algorithm>
#include <exception>
#include <utility>

#include <kinegraph/mechanism.hpp>
#include <kinegraph/version.hpp>

#include "app/editor/faults.hpp"
#include "app/editor/lines.hpp"
#include "app/editor/suggestions.hpp"

namespace kinegraph::app {
namespace {

using Json = nlohmann::ordered_json;

/// Numbers of the protocols, JSON-RPC and the editors'.
namespace code {
constexpr int not_json = -32700, no_request = -32600, no_such_method = -32601, wrong_parameters = -32602,
              fault_of_ours = -32603, not_initialized = -32002;
constexpr int whole_text = 1;                                      // how documents are sent
constexpr int is_error = 1, is_information = 3;                    // severities
constexpr int property = 10, unit = 11, value = 12, variable = 6;  // kinds of suggestions
}  // namespace code

/// What the editor says. It may be nested deeply: an ordered object copies its members where it grows, which recurses
/// and would overflow the stack; this one never copies.
using Message = LanguageServer::Message;

std::string as_text(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

Json message_of(const Json& id, const char* key, Json content) {
    Json message{{"jsonrpc", "2.0"}, {"id", id}};
    message[key] = std::move(content);
    return message;
}
Json error_of(const Json& id, int code, const char* why) {
    return message_of(id, "error", {{"code", code}, {"message", why}});
}

/// The member of an object; null where there is none.
const Message& in(const Message& object, const char* key) {
    static const Message nothing;
    const auto found = object.is_object() ? object.find(key) : object.end();
    return found == object.end() ? nothing : *found;
}
std::string text_in(const Message& object, const char* key) {
    const Message& text = in(object, key);
    return text.is_string() ? text.get<std::string>() : std::string();
}
std::optional<LinePlace> place_in(const Message& parameters) {
    const Message& position = in(parameters, "position");
    const Message &line = in(position, "line"), &character = in(position, "character");
    if (!line.is_number_unsigned() || !character.is_number_unsigned()) return std::nullopt;
    return LinePlace{line.get<std::size_t>(), character.get<std::size_t>()};
}

Json range_of(const Lines& lines, std::size_t begin, std::size_t end) {
    const auto place = [&](std::size_t offset) {
        const LinePlace at = lines.place(offset);
        return Json{{"line", at.line}, {"character", at.utf16}};
    };
    return {{"start", place(begin)}, {"end", place(end)}};
}

/// `number`: its place among those found; what an object needs comes first.
Json item_of(const Suggestion& suggestion, std::size_t number, const Lines& lines) {
    using Kind = Suggestion::Kind;
    const int kind = suggestion.kind == Kind::key    ? code::property
                     : suggestion.kind == Kind::unit ? code::unit
                     : suggestion.kind == Kind::name ? code::variable
                                                     : code::value;
    Json item{
        {"label", suggestion.label},
        {"kind", kind},
        {"filterText", suggestion.label},
        {"textEdit", {{"range", range_of(lines, suggestion.begin, suggestion.end)}, {"newText", suggestion.written}}}};
    item["sortText"] = (suggestion.is_needed ? "0" : "1") + std::to_string(10'000 + number);
    if (!suggestion.says.empty()) item["documentation"] = {{"kind", "plaintext"}, {"value", suggestion.says}};
    return item;
}

}  // namespace

LanguageServer::LanguageServer(std::optional<Language> language) : language_(language), schema_(mechanism_schema()) {}

std::string LanguageServer::refusal() {
    return as_text(error_of(nullptr, code::no_request, "the message is too large"));
}

std::string LanguageServer::complaint(const std::string& fault) {
    return as_text({{"jsonrpc", "2.0"},
                    {"method", "window/logMessage"},
                    {"params", {{"type", code::is_error}, {"message", "kinegraph: " + fault}}}});
}

std::string LanguageServer::answer(std::string_view text) {
    const Message message = Message::parse(text, nullptr, false);
    if (message.is_discarded()) return as_text(error_of(nullptr, code::not_json, "this is not JSON in UTF-8"));
    const Message &method = in(message, "method"), &id = in(message, "id");
    // What has no method answers a request of ours, and we have none; unless it is no message at all.
    const bool is_answer = message.is_object() && !message.contains("method") && id.is_primitive() && !id.is_null();
    if (is_answer) return {};
    const bool is_request = message.is_object() && message.contains("id");
    Json known;
    if (id.is_string()) known = id.get<std::string>();
    if (id.is_number_integer()) known = id.get<std::int64_t>();
    if (!method.is_string() || (is_request && known.is_null()))
        return as_text(error_of(known, code::no_request, "this is no request"));
    try {
        if (is_request) return as_text(answered(known, method.get<std::string>(), in(message, "params")));
        notice(method.get<std::string>(), in(message, "params"));
        return {};
    } catch (const std::exception& fault) {
        return is_request ? as_text(error_of(known, code::fault_of_ours, fault.what())) : complaint(fault.what());
    }
}

Json LanguageServer::answered(const Json& id, const std::string& method, const Message& parameters) {
    const bool begins = method == "initialize";
    if (stage_ == Stage::started && !begins) return error_of(id, code::not_initialized, "initialize comes first");
    if (stage_ != Stage::serving && !(stage_ == Stage::started && begins))
        return error_of(id, code::no_request, "nothing follows shutdown");
    if (begins && stage_ == Stage::serving) return error_of(id, code::no_request, "initialize comes once");
    if (begins) return message_of(id, "result", initialize(parameters));
    if (method == "shutdown") {
        stage_ = Stage::shut_down;
        was_shut_down_ = true;
        documents_.clear();
        changed_.clear();
        return message_of(id, "result", nullptr);
    }
    const bool completes = method == "textDocument/completion";
    if (!completes && method != "textDocument/hover")
        return error_of(id, code::no_such_method, "there is no such method");
    const auto place = place_in(parameters);
    if (!place) return error_of(id, code::wrong_parameters, "a position is wanted");
    const auto document = documents_.find(text_in(in(parameters, "textDocument"), "uri"));
    if (document == documents_.end()) return message_of(id, "result", nullptr);
    const std::string& text = document->second.text;
    return message_of(id, "result", completes ? complete(text, *place) : hover(text, *place));
}

Json LanguageServer::initialize(const Message& parameters) {
    stage_ = Stage::serving;
    // "it-IT" is "it".
    const std::string locale = text_in(parameters, "locale");
    if (!language_) language_ = language_named(locale.substr(0, locale.find_first_of("-_")));
    return {{"capabilities",
             {{"textDocumentSync", {{"openClose", true}, {"change", code::whole_text}}},
              {"completionProvider", {{"triggerCharacters", Json::array({"\""})}}},
              {"hoverProvider", true}}},
            {"serverInfo", {{"name", "kinegraph"}, {"version", version()}}}};
}

Json LanguageServer::complete(const std::string& text, LinePlace place) const {
    const Lines lines(text);
    Json items = Json::array();
    for (const Suggestion& each : suggestions_at(Outline(text), lines.offset(place), schema_))
        items.push_back(item_of(each, items.size(), lines));
    return items;
}

Json LanguageServer::hover(const std::string& text, LinePlace place) const {
    const Lines lines(text);
    const auto meaning = meaning_at(Outline(text), lines.offset(place), schema_);
    if (!meaning) return nullptr;
    return {{"contents", {{"kind", "plaintext"}, {"value", meaning->key + "\n\n" + meaning->says}}},
            {"range", range_of(lines, meaning->begin, meaning->end)}};
}

void LanguageServer::notice(const std::string& method, const Message& parameters) {
    if (method == "exit") stage_ = Stage::ended;
    if (stage_ != Stage::serving) return;
    const Message& document = in(parameters, "textDocument");
    if (method == "textDocument/didOpen") set(document, in(document, "text"));
    if (method == "textDocument/didClose") close(text_in(document, "uri"));
    const Message& changes = in(parameters, "contentChanges");
    if (method == "textDocument/didChange" && changes.is_array() && !changes.empty() &&
        documents_.contains(text_in(document, "uri")))
        set(document, in(changes.back(), "text"));
}

void LanguageServer::set(const Message& document, const Message& text) {
    const std::string uri = text_in(document, "uri");
    if (!text.is_string()) return;
    const Message& version = in(document, "version");
    Json number;
    if (version.is_number_integer()) number = version.get<std::int64_t>();
    documents_[uri] = {text.get<std::string>(), std::move(number)};
    if (std::find(changed_.begin(), changed_.end(), uri) == changed_.end()) changed_.push_back(uri);
}

/// What was said of it is taken back.
void LanguageServer::close(const std::string& uri) {
    if (documents_.erase(uri) > 0 && std::find(changed_.begin(), changed_.end(), uri) == changed_.end())
        changed_.push_back(uri);
}

std::string LanguageServer::next_news() {
    const std::string uri = changed_.front();
    changed_.pop_front();
    Json told{{"uri", uri}}, faults = Json::array();
    if (const auto found = documents_.find(uri); found != documents_.end()) {
        if (!found->second.version.is_null()) told["version"] = found->second.version;
        const Lines lines(found->second.text);
        for (const FaultInText& each : faults_in(found->second.text, uri, language_.value_or(Language::en)))
            faults.push_back({{"range", range_of(lines, each.begin, each.end)},
                              {"severity", each.is_remark ? code::is_information : code::is_error},
                              {"source", "kinegraph"},
                              {"message", each.text}});
    }
    told["diagnostics"] = std::move(faults);
    return as_text({{"jsonrpc", "2.0"}, {"method", "textDocument/publishDiagnostics"}, {"params", std::move(told)}});
}

}  // namespace kinegraph::app
