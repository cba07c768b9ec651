// Manual pages in the macros of man(7).
#include <algorithm>
#include <utility>

#include "app/commands/command_table.hpp"
#include "app/commands/outputs.hpp"

namespace kinegraph::app {
namespace {

/// A line of text: a hyphen is that of the keyboard, and no line begins with a control character.
std::string for_troff(std::string_view text) {
    std::string escaped;
    for (const char letter : text) {
        if ((letter == '.' || letter == '\'') && (escaped.empty() || escaped.back() == '\n')) escaped += "\\&";
        if (letter == '\\')
            escaped += "\\e";
        else if (letter == '-')
            escaped += "\\-";
        else
            escaped += letter;
    }
    return escaped;
}

std::string capitals(std::string_view text) {
    std::string all(text);
    std::transform(all.begin(), all.end(), all.begin(), [](char letter) {
        return letter >= 'a' && letter <= 'z' ? static_cast<char>(letter - 'a' + 'A') : letter;
    });
    return all;
}

std::string head(const CommandTable& table, const std::string& name) {
    return ".TH " + capitals(name) + " 1 \"\" \"" + for_troff(table.version) + "\" \"User Commands\"\n";
}

std::string bold(std::string_view text) { return "\\fB" + for_troff(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + for_troff(text) + "\\fR"; }

std::string synopsis(const CommandForm& command) {
    std::string line = bold("kinegraph " + command.name);
    for (const OptionForm& option : command.options) {
        if (option.is_argument)
            line += option.is_required ? " " + italic(option.names.front()) : " [" + italic(option.names.front()) + "]";
        else if (option.is_required)
            line += " " + bold(option.names.front()) + " " + italic(option.type);
    }
    const bool has_options = std::any_of(command.options.begin(), command.options.end(),
                                         [](const OptionForm& option) { return !option.is_argument; });
    return line + (has_options ? " [" + italic("options") + "]" : "") + "\n";
}

std::string described(const OptionForm& option) {
    std::string names;
    for (const std::string& name : option.names)
        names += (names.empty() ? "" : ", ") + (option.is_argument ? italic(name) : bold(name));
    std::string text = ".TP\n" + names;
    if (!option.is_argument && !option.type.empty()) text += " " + italic(option.type);
    text += "\n" + for_troff(option.help) + ".";
    if (!option.fallback.empty()) text += " Default: " + bold(option.fallback) + ".";
    return text + "\n";
}

std::string statuses(const CommandTable& table) { return ".SH EXIT STATUS\n" + for_troff(table.statuses) + "\n"; }

std::string page_of_program(const CommandTable& table) {
    std::string page =
        head(table, "kinegraph") + ".SH NAME\nkinegraph \\- solve planar mechanisms exactly\n.SH SYNOPSIS\n";
    for (const CommandForm& command : table.commands) page += synopsis(command) + ".br\n";
    page += bold("kinegraph") + " [" + bold("--help") + "] [" + bold("--version") + "]\n.SH DESCRIPTION\n" +
            for_troff(table.purpose) + "\n.SH COMMANDS\n";
    for (const CommandForm& command : table.commands)
        page += ".TP\n" + bold(command.name) + "\n" + for_troff(command.purpose) + ".\nSee\n.BR kinegraph\\-" +
                for_troff(command.name) + " (1).\n";
    page += statuses(table);
    page +=
        ".SH DIAGNOSTICS\nMessages go to standard error, one a line: the file, the place as a JSON pointer, what is "
        "wrong, the remedy.\n.SH EXAMPLES\n.nf\n";
    for (const char* line : {"kinegraph solve four_bar.json -o four_bar.pdf",
                             "kinegraph solve four_bar.json --lang it --paper A3 -o quadrilatero.pdf",
                             "kinegraph sweep quick_return.json --steps 720 -o cycle.csv -o cycle.pdf",
                             "kinegraph variants exercise.json --count 30 -o exam/"})
        page += for_troff(line) + "\n";
    return page +
           ".fi\n.SH FILES\n.TP\n.I /usr/share/kinegraph/mechanism.schema.json\n"
           "The JSON Schema of the mechanism file.\n";
}

}  // namespace

std::string manual_page(const CommandTable& table, std::string_view name) {
    const auto command = std::find_if(table.commands.begin(), table.commands.end(),
                                      [&](const CommandForm& each) { return each.name == name; });
    if (command == table.commands.end()) return page_of_program(table);
    std::string page = head(table, "kinegraph-" + command->name) + ".SH NAME\nkinegraph\\-" + for_troff(command->name) +
                       " \\- " + for_troff(command->purpose) + "\n.SH SYNOPSIS\n" + synopsis(*command);
    const auto section = [&](bool arguments, const char* title) {
        bool first = true;
        for (const OptionForm& option : command->options) {
            if (option.is_argument != arguments) continue;
            if (std::exchange(first, false)) page += std::string(".SH ") + title + "\n";
            page += described(option);
        }
    };
    section(true, "ARGUMENTS");
    section(false, "OPTIONS");
    return page + statuses(table) + ".SH SEE ALSO\n.BR kinegraph (1)\n";
}

Status write_manual(const CommandTable& table, const std::string& folder, Language language) {
    const std::string within = folder + (folder.ends_with('/') ? "" : "/");
    std::vector<Output> pages{{within + "kinegraph.1", manual_page(table, "")}};
    for (const CommandForm& command : table.commands)
        pages.push_back({within + "kinegraph-" + command.name + ".1", manual_page(table, command.name)});
    const auto failure = write_all(pages);
    return failure ? fail_to_write(*failure, language) : Status::done;
}

}  // namespace kinegraph::app
