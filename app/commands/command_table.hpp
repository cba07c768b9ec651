// The command line as a table: what completion in a shell and the manual pages are made from.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/files/messages.hpp"

namespace kinegraph::app {

/// An option or an argument of a command.
struct OptionForm {
    std::vector<std::string> names;  ///< "-o", "--output"; of an argument "FILE"
    std::string type;                ///< what its value is called: "OUT"; empty: a flag
    std::string help;
    std::string fallback;            ///< value without the option; empty: none
    std::vector<std::string> words;  ///< the values it can have, besides paths; empty: any
    bool is_path = false;            ///< its value may be a file or a folder
    bool is_argument = false;
    bool is_required = false;
};

struct CommandForm {
    std::string name;
    std::string purpose;
    std::vector<OptionForm> options;  ///< arguments first
};

struct CommandTable {
    std::string purpose;  ///< of the program
    std::string version;
    std::string statuses;  ///< the exit statuses, in words
    std::vector<CommandForm> commands;
};

/// A script that completes the commands, options and values in a shell: "bash", "zsh" or "fish".
std::string completion_script(const CommandTable& table, std::string_view shell);
/// A manual page in the macros of man(7): of a command, or, if its name is empty, of the program.
std::string manual_page(const CommandTable& table, std::string_view command);

/// Writes all pages into a folder: kinegraph.1, kinegraph-solve.1 …
Status write_manual(const CommandTable& table, const std::string& folder, Language language);

}  // namespace kinegraph::app
