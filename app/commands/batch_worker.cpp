#include "app/commands/batch_worker.hpp"

#include <exception>
#include <string_view>
#include <vector>

#include "app/commands/cache_record.hpp"
#include "app/files/json_text.hpp"
#include "engine/file/units.hpp"

namespace kinegraph::app {
namespace {

constexpr std::size_t shown_of_a_line = 80;

Error too_long() { return {ErrorCode::bad_input, "", {"is larger than 64 MiB", "supera 64 MiB"}}; }

/// ", \"key\": value" of texts; empty if there are none.
std::string member(std::string_view key, const std::vector<std::string>& texts) {
    if (texts.empty()) return {};
    return ", \"" + std::string(key) + "\": " + json_quoted(texts);
}

/// What `solve` would write on standard error.
std::string said_of(const Solved& found) {
    std::vector<std::string> unsolved;
    for (const Solved::Missing& missing : found.unsolved) unsolved.push_back(missing.line);
    return member("remarks", found.remarks) + member("unsolved", unsolved);
}

}  // namespace

std::string BatchWorker::answer(const std::string& line) {
    Hearing hearing;
    BatchLine read;
    Answer answer;
    const auto fault = [&](const char* what) {
        answer = {Status::fault};
        const Words ours("this is a fault of ours: {0}", "questo è un errore nostro: {0}", std::string(what));
        refuse(ours, request_.defaults.language);
    };
    try {
        if (line.size() <= largest_input)
            read = read_batch_line(line, request_.defaults);
        else
            read.errors = {too_long()};
        answer = carry_out(read);
    } catch (const std::exception& what) {
        fault(what.what());
    } catch (...) {
        fault("unknown");
    }
    const std::vector<std::string> errors = hearing.take();
    const bool refused = answer.status != Status::done && answer.status != Status::unsolved;
    ++tally_.answered;
    if (refused) ++tally_.refused;
    if (refused) answer.members = member("errors", errors);
    if (refused && read.id == "null") answer.members += ", \"line\": " + json_quoted(shown(line, shown_of_a_line));
    std::string text = R"({"id": )" + read.id;
    if (!answer.members.starts_with(", \"status\""))
        text += ", \"status\": " + std::to_string(static_cast<int>(answer.status));
    return text + answer.members + "}\n";
}

BatchWorker::Answer BatchWorker::carry_out(BatchLine& line) {
    SolveRequest& request = line.request;
    if (!line.errors.empty()) return {say({"the line", "la riga"}, line.errors, request.language)};
    if (!request.text) {
        auto text = read_whole(request.file, {"mechanism file", "file di meccanismo"});
        if (!text) {
            say(spoken(request.file), text.error(), request.language);
            return {Status::bad_input};
        }
        request.text = *std::move(text);
    }
    return line.to.empty() ? made(line) : written(line);
}

const render::Theme* BatchWorker::look(const SolveRequest& request) {
    if (theme_ && theme_name_ == request.theme) return &*theme_;
    theme_.reset();
    if (request.theme == "-") {
        refuse({"a theme cannot come from standard input, which carries the lines",
                "un tema non può venire dall’ingresso standard, che porta le righe"},
               request.language);
        return nullptr;
    }
    auto theme = theme_of(request.theme, request.file, request.language);
    if (!theme) return nullptr;
    theme_text_ = request.theme;
    if (!render::built_in_theme(request.theme))
        if (const auto text = read_whole(request.theme, {"theme file", "file di tema"})) theme_text_ += '\n' + *text;
    theme_name_ = request.theme;
    theme_.emplace(*std::move(theme));
    return &*theme_;
}

BatchWorker::Answer BatchWorker::made(const BatchLine& line) {
    const render::Theme* const theme = look(line.request);
    if (theme == nullptr) return {Status::bad_input};
    const auto found = solved(line.request, line.targets(), *theme, press_);
    if (!found) return {found.error()};
    std::vector<std::string> pages;
    std::string results;
    int count = 0;
    for (const Output& output : found->outputs) {
        if (output.path.ends_with(".svg")) {
            pages.push_back(output.bytes);
            continue;
        }
        results += (count++ == 0 ? "" : ", ") + on_one_line(output.bytes);
    }
    if (count == 1) results = ", \"result\": " + results;
    if (count > 1) results = ", \"results\": [" + results + "]";
    return {found->status(), said_of(*found) + results + member("svg", pages)};
}

BatchWorker::Answer BatchWorker::written(const BatchLine& line) {
    const Language language = line.request.language;
    const render::Theme* const theme = look(line.request);
    if (theme == nullptr) return {Status::bad_input};
    const CacheRecord cache_record(line.to, hash_of(line, theme_text_));
    if (request_.resume) {
        if (const auto before = cache_record.answer()) {
            ++tally_.resumed;
            return {Status::done, ", " + before->substr(1, before->size() - 2)};  // the record contains its status
        }
    }
    auto found = solved(line.request, line.targets(), *theme, press_);
    if (!found) return {found.error()};
    std::vector<std::string> paths;
    for (const Output& output : found->outputs) paths.push_back(output.path);
    const std::string told = member("files", paths) + said_of(*found);
    Output cache_record_of_all = cache_record.of(
        found->outputs, "{\"status\": " + std::to_string(static_cast<int>(found->status())) + told + "}");
    std::vector<Output> outputs = std::move(found->outputs);
    outputs.push_back(std::move(cache_record_of_all));
    auto failure = cache_record.make_room();
    if (!failure) failure = write_all(outputs);
    if (failure) return {fail_to_write(*failure, language)};
    return {found->status(), told};
}

}  // namespace kinegraph::app
