// watch FILE: serves the live page of a file while it is edited. There are two paths, the page and its changes; any
// other is not found, so that no file of the machine can be read.
#include <sys/stat.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <utility>

#include "app/commands/commands.hpp"
#include "app/commands/outputs.hpp"
#include "app/files/files.hpp"
#include "app/files/json_text.hpp"
#include "app/server/local_server.hpp"
#include "app/server/session.hpp"
#include "app/server/watched_file.hpp"
#include "lang/keys/command_line.hpp"
#include "lang/keys/common.hpp"

namespace kinegraph::app {
namespace {

constexpr int between_looks = 100;  // ms

/// {"page": 2, "faults": [{"line": 3, "column": 5, "where": "/joints/2", "en": "…", "it": "…"}]}
std::string as_json(const Watched& watched) {
    std::vector<std::string> faults;
    for (const FileFault& each : watched.faults) {
        JsonLine fault;
        if (each.place) fault.add("line", each.place->line).add("column", each.place->column);
        fault.add("where", each.fault.place);
        for (const Language language : languages) fault.add(code_of(language), each.fault.text.in(language));
        faults.push_back(fault.object());
    }
    return JsonLine().add("page", watched.pages).add_json("faults", json_list(faults)).object() + "\n";
}

/// The content that is served, by path.
class Site {
public:
    Site(std::string name, std::string waiting)
        : path_("/" + std::move(name) + "/"), page_(std::make_shared<const std::string>(std::move(waiting))) {
        show({});
    }
    const std::string& path() const { return path_; }
    void show(const Watched& watched) {
        if (watched.page) page_ = watched.page;
        news_ = std::make_shared<const std::string>(as_json(watched));
    }
    HttpAnswer answer(const HttpHead& head) const {
        HttpAnswer answer;
        const bool is_page = head.target == path_;
        if (!is_page && head.target != path_ + "news") {
            answer.status = 404;
        } else if (head.method != "GET" && head.method != "HEAD") {
            answer.status = 405;
            answer.more = "Allow: GET, HEAD\r\n";
        } else {
            answer.type = is_page ? "text/html; charset=utf-8" : "application/json; charset=utf-8";
            answer.body = is_page ? page_ : news_;
            answer.more = "Content-Security-Policy: frame-ancestors 'none'\r\n";
        }
        return answer;
    }

private:
    std::string path_;
    std::shared_ptr<const std::string> page_, news_;
};

/// The live page of a file's text.
Expected<std::string> page_of(const std::string& text, const std::string& name, const DrawingOptions& options,
                              int version) {
    const auto file = MechanismFile::parse(text, name);
    if (!file) return tl::unexpected(file.error());
    const auto solved = file->solve();
    if (!solved) return tl::unexpected(solved.error());
    auto page = live_page(*solved, options, version);
    if (!page) return tl::unexpected(page.error());
    return std::move(page->html);
}

/// Reports faults on the terminal too, as other commands do.
void tell(const WatchRequest& request, const Watched& watched) {
    Diagnostics faults;
    for (const FileFault& fault : watched.faults) {
        Diagnostic& said = faults.emplace_back(fault.fault);
        if (fault.place)
            said.text = Words(lang::command_line::line_column, std::to_string(fault.place->line),
                              std::to_string(fault.place->column), fault.fault.text);
    }
    say(spoken(request.file), faults, request.language);
}

/// Serves until interrupted.
void serve(LocalServer& server, Site& site, WatchedFile& file, const Interruption& interruption,
           const WatchRequest& request) {
    const Answering answer = [&site](const HttpHead& head, const std::string&) { return site.answer(head); };
    while (!interruption.has_come()) {
        if (const auto news = file.look()) {
            site.show(*news);
            tell(request, *news);
        }
        server.serve(between_looks, interruption.descriptor(), answer);
    }
}

Words why_not_watched(const std::string& file) {
    if (file == "-") return {lang::command_line::watch_needs_a_file};
    struct stat status {};
    if (::stat(file.c_str(), &status) == 0 && !S_ISREG(status.st_mode))
        return {lang::command_line::is_no_plain_file_which_could};
    const auto text = read_whole(file, {lang::common::mechanism_file});
    return text ? Words() : text.error();
}

}  // namespace

Status watch_command(const WatchRequest& request) {
    const Language language = request.language;
    if (const Words why = why_not_watched(request.file); !why.empty()) {
        say(spoken(request.file), why, language);
        return Status::bad_input;
    }
    DrawingOptions options;
    options.language = language;
    if (const auto status = set_theme(options, request.theme, request.file)) return *status;
    const std::string name = bare_name(request.file);
    auto waiting = waiting_page(name, options);
    if (!waiting) return cannot_draw(spoken(request.file), waiting.error(), language);
    auto server = LocalServer::open(request.port);
    if (!server) {
        refuse({lang::command_line::port_of_127_0_0_1, std::to_string(request.port), server.error()}, language);
        return Status::output;
    }
    const Interruption interruption;
    Site site(secret_name(), *std::move(waiting));
    const std::string address = "http://127.0.0.1:" + std::to_string(server->port()) + site.path() + "\n";
    if (const Status printed = print(address, language); printed != Status::done) return printed;
    auto file = std::make_unique<WatchedFile>(
        request.file, [&](const std::string& text, int number) { return page_of(text, name, options, number); });
    serve(*server, site, *file, interruption, request);
    // Does not wait for a long solution: its result would be discarded.
    if (file->is_busy()) std::_Exit(static_cast<int>(Status::done));
    return Status::done;
}

}  // namespace kinegraph::app
