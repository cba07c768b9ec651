#include "app/commands/batch_worker.hpp"

#include <algorithm>
#include <array>
#include <exception>
#include <string_view>
#include <vector>

#include "app/commands/cache_record.hpp"
#include "lang/keys/command_line.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/notation.hpp"

namespace kinegraph::app {
namespace {

struct Written {
    Format format;
    std::string_view ending;
};
/// In the order of Request::Format.
constexpr std::array<Written, 6> batch_formats{{{Format::svg, ".svg"},
                                                {Format::png, ".png"},
                                                {Format::pdf, ".pdf"},
                                                {Format::tex, ".tex"},
                                                {Format::dxf, ".dxf"},
                                                {Format::json, ".json"}}};

/// The output files: TO.json, TO.svg … For a line without "to": a name for each, under which nothing is written.
std::vector<Target> files_wanted(const Request& line) {
    // Without "to" a path below a file that is no folder: nothing can exist there.
    std::string stem = line.to.empty() ? "/dev/null/answer" : line.to;
    std::vector<Target> all;
    for (const Request::Format format : line.want) {
        const auto& [kind, ending] = batch_formats.at(static_cast<std::size_t>(format));
        all.push_back({std::string(ending), kind});
    }
    const auto written =
        std::find_if(all.begin(), all.end(), [&](const Target& each) { return line.to.ends_with(each.path); });
    if (written != all.end()) stem.resize(line.to.size() - written->path.size());
    for (Target& each : all) each.path.insert(0, stem);
    return all;
}

/// Of texts, where there are any.
void add(JsonLine& to, std::string_view key, const std::vector<std::string>& texts) {
    if (!texts.empty()) to.add(key, texts);
}

/// What `solve` would write on standard error.
JsonLine said_of(const Outcome& outcome, Language language) {
    std::vector<std::string> remarks, unsolved;
    for (const Text& each : outcome.remarks) remarks.push_back(each.in(language));
    for (const Outcome::Missing& each : outcome.unsolved)
        unsolved.push_back(each.what.in(language) + in(lang::notation::colon, language) + each.why.in(language));
    JsonLine said;
    add(said, "remarks", remarks);
    add(said, "unsolved", unsolved);
    return said;
}

}  // namespace

std::string BatchWorker::answer(const std::string& line) {
    Hearing hearing;
    SolveRequest read = request_.defaults;
    Answer answer;
    const auto fault = [&](const char* what) {
        answer = {Status::fault};
        const Words ours(lang::command_line::this_is_a_fault_of_ours, std::string(what));
        refuse(ours, request_.defaults.language());
    };
    try {
        if (line.size() <= largest_input)
            static_cast<Request&>(read) = Request::parse(line, request_.defaults);
        else
            read.faults = {{Diagnostic::Kind::bad_input, "", Words(lang::command_line::is_larger_than_64_mib)}};
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
    if (refused) {
        answer.members = {};
        add(answer.members, "errors", errors);
        if (read.id == "null") answer.members.add("line", Request::excerpt(line));
    }
    JsonLine whole;
    whole.add_json("id", read.id);
    if (!answer.has_status) whole.add("status", static_cast<int>(answer.status));
    return whole.add_members(answer.members).object() + '\n';
}

BatchWorker::Answer BatchWorker::carry_out(SolveRequest& line) {
    if (!line.faults.empty()) return {say({lang::command_line::the_line}, line.faults, line.language())};
    if (!line.text) {
        auto text = read_whole(line.file, {lang::common::mechanism_file});
        if (!text) {
            say(spoken(line.file), text.error(), line.language());
            return {Status::bad_input};
        }
        line.text = *std::move(text);
    }
    if (!set_look(line)) return {Status::bad_input};
    return line.to.empty() ? made(line) : written(line);
}

bool BatchWorker::set_look(SolveRequest& line) {
    if (!theme_ || theme_name_ != line.theme) {
        theme_.reset();
        if (line.theme == "-") {
            refuse({lang::command_line::a_theme_cannot_come_from_standard}, line.language());
            return false;
        }
        DrawingOptions theme;
        theme.language = line.language();
        if (set_theme(theme, line.theme, line.file)) return false;
        theme_name_ = line.theme;
        theme_.emplace(std::move(theme));
    }
    line.drawing.theme = theme_->theme;
    line.drawing.theme_file = theme_->theme_file;
    return true;
}

BatchWorker::Answer BatchWorker::made(const SolveRequest& line) {
    const auto outcome = outcome_of(line, files_wanted(line));
    if (!outcome) return {outcome.error()};
    std::vector<std::string> pages, results;
    for (const Output& output : outcome->outputs) {
        if (output.path.ends_with(".svg")) {
            pages.push_back(output.bytes);
            continue;
        }
        results.push_back(on_one_line(output.bytes));
    }
    JsonLine members = said_of(*outcome, line.language());
    if (results.size() == 1) members.add_json("result", results.front());
    if (results.size() > 1) members.add_json("results", json_list(results));
    add(members, "svg", pages);
    return {outcome->status(), std::move(members)};
}

BatchWorker::Answer BatchWorker::written(const SolveRequest& line) {
    const CacheRecord cache_record(line.to, hash_of(line, theme_key(line.theme, line.drawing)));
    if (request_.resume) {
        if (const auto before = cache_record.answer()) {
            ++tally_.resumed;
            return {Status::done, JsonLine().add_members(*before), true};
        }
    }
    auto outcome = outcome_of(line, files_wanted(line));
    if (!outcome) return {outcome.error()};
    std::vector<Output> outputs = std::move(outcome->outputs);
    std::vector<std::string> paths;
    for (const Output& output : outputs) paths.push_back(output.path);
    JsonLine told;
    add(told, "files", paths);
    told.add_members(said_of(*outcome, line.language()));
    JsonLine record;
    record.add("status", static_cast<int>(outcome->status())).add_members(told);
    outputs.push_back(cache_record.of(outputs, record.object()));
    auto failure = cache_record.make_room();
    if (!failure) failure = write_all(outputs);
    if (failure) return {fail_to_write(*failure, line.language())};
    return {outcome->status(), std::move(told)};
}

}  // namespace kinegraph::app
