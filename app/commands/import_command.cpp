// import LINK|FILE: the mechanism file that a drawing of another program makes.
#include <array>

#include "app/commands/commands.hpp"
#include "app/commands/outputs.hpp"
#include "app/files/files.hpp"
#include "lang/keys/command_line.hpp"

namespace kinegraph::app {

Status import_command(const ImportRequest& request) {
    const Language language = request.language;
    const bool is_link = request.source.find('?') != std::string::npos;
    const std::string file = is_link ? std::string() : request.source;
    constexpr std::array formats{Format::json};
    auto targets = targets_of(request.outputs, {}, file, formats);
    if (!targets) return refuse(targets.error(), language);
    if (targets->empty()) targets->push_back({"-", Format::json});
    const Words subject = is_link ? Words(lang::command_line::the_link) : spoken(file);
    const auto text = is_link ? tl::expected<std::string, Words>(request.source)
                              : read_whole(file, {lang::command_line::file_of_pmks});
    if (!text) {
        say(subject, text.error(), language);
        return Status::bad_input;
    }
    const auto imported = import_pmks(*text);
    if (!imported) return say(subject, imported.error(), language);
    std::vector<Output> outputs;
    for (const Target& target : *targets) outputs.push_back({target.path, imported->file});
    if (names_clash(outputs, file, language)) return Status::bad_input;
    if (const auto failure = write_all(outputs)) return fail_to_write(*failure, language);
    remark(subject, imported->remarks, language);
    return Status::done;
}

}  // namespace kinegraph::app
