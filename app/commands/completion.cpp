// Scripts by which bash, zsh and fish complete the command line.
#include <algorithm>

#include "app/commands/command_table.hpp"

namespace kinegraph::app {
namespace {

std::string quoted_for_shell(std::string_view text) {
    std::string quoted = "'";
    for (const char letter : text) quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
    return quoted + "'";
}

template <class Range, class Of>
std::string joined_words(const Range& all, std::string_view between, const Of& of) {
    std::string text;
    for (const auto& each : all) text += (text.empty() ? "" : std::string(between)) + of(each);
    return text;
}

/// In bash a word with a blank is one line of the list, and a blank within it is escaped.
std::string words_for_bash(const std::vector<std::string>& words) {
    return quoted_for_shell(joined_words(words, "\n", [](const std::string& word) { return word; }));
}

std::string bash_case(const OptionForm& option) {
    const std::string names = joined_words(option.names, "|", [](const std::string& name) { return name; });
    std::string line = "        " + names + ") ";
    if (!option.words.empty()) line += "words=" + words_for_bash(option.words);
    if (option.is_path) line += (option.words.empty() ? "" : "; ") + std::string("files=yes");
    if (option.words.empty() && !option.is_path) line += "none=yes";
    return line + " ;;\n";
}

std::string for_bash(const CommandTable& table) {
    std::string script =
        "# Completion of kinegraph for bash, made by `kinegraph completion bash`.\n"
        "_kinegraph() {\n"
        "    local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}\n"
        "    local command=${COMP_WORDS[1]} words= files= none= IFS=$'\\n'\n"
        "    COMPREPLY=()\n"
        "    if [ \"$COMP_CWORD\" = 1 ]; then\n        words=";
    script += words_for_bash([&] {
        std::vector<std::string> names;
        for (const CommandForm& each : table.commands) names.push_back(each.name);
        names.insert(names.end(), {"--help", "--version"});
        return names;
    }());
    script += "\n    else\n        case $command in\n";
    for (const CommandForm& command : table.commands) {
        std::vector<std::string> names;
        std::string cases;
        for (const OptionForm& option : command.options) {
            if (option.is_argument) continue;
            names.insert(names.end(), option.names.begin(), option.names.end());
            if (!option.type.empty()) cases += "    " + bash_case(option);
        }
        const auto argument = std::find_if(command.options.begin(), command.options.end(),
                                           [](const OptionForm& option) { return option.is_argument; });
        script += "        " + command.name + ")\n            case $before in\n" + cases + "            *)\n" +
                  "                if [ \"${current#-}\" != \"$current\" ]; then words=" + words_for_bash(names) + "\n";
        if (argument != command.options.end())
            script += argument->words.empty() ? "                else files=yes\n"
                                              : "                else words=" + words_for_bash(argument->words) + "\n";
        script += "                fi ;;\n            esac ;;\n";
    }
    script +=
        "        esac\n    fi\n"
        "    [ -n \"$none\" ] && return\n"
        "    [ -n \"$words\" ] && COMPREPLY=($(compgen -W \"${words//\\\\/\\\\\\\\}\" -- \"$current\"))\n"
        "    [ -n \"$files\" ] && COMPREPLY+=($(compgen -f -- \"$current\"))\n"
        "    compopt -o filenames 2>/dev/null\n"
        "}\n"
        "complete -F _kinegraph kinegraph\n";
    return script;
}

/// In the specifications of _arguments a colon and brackets have a meaning.
std::string escaped_for_zsh(std::string_view text) {
    std::string escaped;
    for (const char letter : text) {
        if (letter == ':' || letter == '[' || letter == ']' || letter == '\\') escaped += '\\';
        escaped += letter;
    }
    return escaped;
}

std::string zsh_value(const OptionForm& option) {
    const std::string words = joined_words(option.words, " ", [](const std::string& word) {
        std::string escaped;
        for (const char letter : word) escaped += (letter == ' ' ? "\\" : "") + std::string(1, letter);
        return escaped;
    });
    const std::string files = option.is_path ? "_files" : " ";
    return ":" + escaped_for_zsh(option.type) + ":" +
           (words.empty()    ? files
            : option.is_path ? "{compadd " + words + "; _files}"
                             : "(" + words + ")");
}

std::string for_zsh(const CommandTable& table) {
    std::string script =
        "#compdef kinegraph\n# Completion of kinegraph for zsh, made by `kinegraph completion zsh`.\n"
        "_kinegraph() {\n    local -a commands\n    commands=(\n";
    for (const CommandForm& command : table.commands)
        script += "        " + quoted_for_shell(command.name + ":" + escaped_for_zsh(command.purpose)) + "\n";
    script +=
        "    )\n    if (( CURRENT == 2 )); then\n        _describe command commands\n"
        "        _arguments '--help[Print help]' '--version[Print the version]'\n        return\n    fi\n"
        "    local command=$words[2]\n    shift words\n    (( CURRENT-- ))\n    case $command in\n";
    for (const CommandForm& command : table.commands) {
        script += "        " + command.name + ")\n            _arguments";
        for (const OptionForm& option : command.options) {
            if (option.is_argument) {
                script += " \\\n                " + quoted_for_shell(zsh_value(option));
                continue;
            }
            for (const std::string& name : option.names)
                script +=
                    " \\\n                " + quoted_for_shell("*" + name + "[" + escaped_for_zsh(option.help) + "]" +
                                                               (option.type.empty() ? "" : zsh_value(option)));
        }
        script += " ;;\n";
    }
    return script + "    esac\n}\n_kinegraph \"$@\"\n";
}

std::string for_fish(const CommandTable& table) {
    std::string script =
        "# Completion of kinegraph for fish, made by `kinegraph completion fish`.\n"
        "complete -c kinegraph -f\n"
        "complete -c kinegraph -n __fish_use_subcommand -l help -d 'Print help'\n"
        "complete -c kinegraph -n __fish_use_subcommand -l version -d 'Print the version'\n";
    for (const CommandForm& command : table.commands) {
        const std::string within = "complete -c kinegraph -n '__fish_seen_subcommand_from " + command.name + "'";
        script += "complete -c kinegraph -n __fish_use_subcommand -a " + command.name + " -d " +
                  quoted_for_shell(command.purpose) + "\n";
        for (const OptionForm& option : command.options) {
            const std::string words = joined_words(option.words, " ", [](const std::string& word) {
                return word.find(' ') == std::string::npos ? word : "\"" + word + "\"";
            });
            if (option.is_argument) {
                script += within + (words.empty() ? " -F" : " -a " + quoted_for_shell(words)) + "\n";
                continue;
            }
            std::string line = within;
            for (const std::string& name : option.names)
                line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
            if (!option.type.empty()) line += option.is_path ? " -r -F" : " -x";
            if (!words.empty()) line += " -a " + quoted_for_shell(words);
            script += line + " -d " + quoted_for_shell(option.help) + "\n";
        }
    }
    return script;
}

}  // namespace

std::string completion_script(const CommandTable& table, std::string_view shell) {
    if (shell == "bash") return for_bash(table);
    return shell == "zsh" ? for_zsh(table) : for_fish(table);
}

}  // namespace kinegraph::app
