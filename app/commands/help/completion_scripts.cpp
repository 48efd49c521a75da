#include <algorithm>
#include <stdexcept>

#include "app/commands/help/command_help.hpp"
#include "app/session/wording/text_width.hpp"

namespace jw {

namespace {

std::string joined(const std::vector<std::string>& words, const std::string& between = " ") {
    std::string text;
    for (const std::string& word : words) { text += (text.empty() ? "" : between) + word; }
    return text;
}

/// The first line only: shells show one line.
std::string one_line(const std::string& description) { return description.substr(0, description.find('\n')); }

std::vector<std::string> all_names(const CommandHelp& command) {
    std::vector<std::string> names;
    for (const OptionHelp& option : command.options) {
        names.insert(names.end(), option.names.begin(), option.names.end());
    }
    return names;
}

/// True for "snapshot record", which is proposed only after "snapshot".
bool is_part(const CommandHelp& command) { return command.name.find(' ') != std::string::npos; }

/// Command that a subcommand belongs to: "snapshot" for "snapshot record"; empty for "render".
std::string whole_of(const CommandHelp& command) {
    const std::size_t space = command.name.rfind(' ');
    return space == std::string::npos ? "" : command.name.substr(0, space);
}

std::string last_word_of(const CommandHelp& command) {
    return command.name.substr(is_part(command) ? command.name.rfind(' ') + 1 : 0);
}

std::vector<std::string> command_names(const ProgramHelp& help) {
    std::vector<std::string> names;
    for (const CommandHelp& command : help.commands) {
        if (!is_part(command)) { names.push_back(command.name); }
    }
    return names;
}

/// Words that the positional arguments of a command can be; empty if these are files.
std::vector<std::string> words_of_positionals(const CommandHelp& command) {
    if (!command.parts.empty()) { return command.parts; }
    for (const OptionHelp& positional : command.positionals) {
        if (!positional.choices.empty()) { return positional.choices; }
    }
    return {};
}

// ---- bash

/// Cases "command option" for options that take a value; `command` is empty for those of the program.
std::string bash_values(const CommandHelp& command, const std::string& name) {
    std::string text;
    for (const OptionHelp& option : command.options) {
        if (option.value.empty()) { continue; }
        std::vector<std::string> patterns;
        for (const std::string& spelling : option.names) { patterns.push_back(name + spelling); }
        text += "        " + joined(patterns, " | ") + ")\n";
        if (!option.choices.empty()) {
            text += "            COMPREPLY=($(compgen -W '" + joined(option.choices) + "' -- \"$cur\"))\n";
        }
        text += "            return ;;\n";
    }
    return text;
}

std::string bash_words(const std::vector<std::string>& words) {
    return "COMPREPLY=($(compgen -W '" + joined(words) + "' -- \"$cur\"))";
}

std::string for_bash(const ProgramHelp& help) {
    const std::vector<std::string> commands = command_names(help);
    const std::vector<std::string> everywhere = all_names(help.program);
    std::string text =
        "# bash completion for jointwise, written by 'jointwise completion bash'\n"
        "_jointwise() {\n"
        "    local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD-1]} command='' k\n"
        "    for ((k = 1; k < COMP_CWORD; k++)); do\n"
        "        case $command:${COMP_WORDS[k]} in\n";
    for (const CommandHelp& command : help.commands) {
        text += "            '" + whole_of(command) + "':" + last_word_of(command) + ") command='" +
                command.name + "' ;;\n";
    }
    text +=
        "        esac\n"
        "    done\n"
        "    # where nothing is said, files are completed\n"
        "    COMPREPLY=()\n"
        "    case $command:$prev in\n";
    text += bash_values(help.program, "*:");
    for (const CommandHelp& command : help.commands) {
        text += bash_values(command, "'" + command.name + "':");
    }
    text += "    esac\n    case $command:$cur in\n";
    text += "        :-*) " + bash_words(everywhere) + " ;;\n";
    text += "        :*) " + bash_words(commands) + " ;;\n";
    for (const CommandHelp& command : help.commands) {
        std::vector<std::string> options = all_names(command);
        options.insert(options.end(), everywhere.begin(), everywhere.end());
        std::ranges::sort(options);
        const auto rest = std::ranges::unique(options);
        options.erase(rest.begin(), rest.end());
        text += "        '" + command.name + "':-*) " + bash_words(options) + " ;;\n";
        const std::vector<std::string> words = words_of_positionals(command);
        if (!words.empty()) { text += "        '" + command.name + "':*) " + bash_words(words) + " ;;\n"; }
    }
    return text + "    esac\n}\ncomplete -o default -F _jointwise jointwise\n";
}

// ---- zsh

/// Text for single quotes of zsh; _arguments itself reads [ ] : in it.
std::string zsh_text(const std::string& text) {
    std::string safe = replaced(one_line(text), "\\", "\\\\");
    for (const char* special : {"[", "]", ":"}) {
        safe = replaced(safe, special, std::string("\\") + special);
    }
    return replaced(safe, "'", "'\\''");
}

std::string zsh_action(const OptionHelp& option) {
    return option.choices.empty() ? "_files" : "(" + joined(option.choices) + ")";
}

std::string zsh_options(const CommandHelp& command) {
    std::string text;
    for (const OptionHelp& option : command.options) {
        for (const std::string& name : option.names) {
            const std::string value =
                option.value.empty() ? "" : ":" + zsh_text(option.value) + ":" + zsh_action(option);
            text += " \\\n                '" + std::string(option.many ? "*" : "") + name + "[" +
                    zsh_text(option.description) + "]" + value + "'";
        }
    }
    return text;
}

std::string zsh_positionals(const CommandHelp& command) {
    std::string text;
    for (const OptionHelp& positional : command.positionals) {
        text += " \\\n                '" + std::string(positional.many ? "*" : "") + ":" +
                zsh_text(positional.names.front()) + ":" + zsh_action(positional) + "'";
    }
    return text;
}

/// Proposals after a command, and after each of its parts.
std::string zsh_branch(const ProgramHelp& help, const CommandHelp& command) {
    std::string text = "            " + last_word_of(command) + ") _arguments";
    if (command.parts.empty()) { return text + zsh_options(command) + zsh_positionals(command) + " ;;\n"; }
    text += " -C" + zsh_options(command) + " \\\n                '1: :(" + joined(command.parts) +
            ")' '*:: :->parts'\n            if [ \"$state\" = parts ]; then case $line[1] in\n";
    for (const CommandHelp& part : help.commands) {
        if (whole_of(part) == command.name) { text += zsh_branch(help, part); }
    }
    return text + "            esac; fi ;;\n";
}

std::string for_zsh(const ProgramHelp& help) {
    std::string text =
        "#compdef jointwise\n"
        "# zsh completion for jointwise, written by 'jointwise completion zsh'\n"
        "_jointwise() {\n"
        "    local context state state_descr line\n"
        "    typeset -A opt_args\n"
        "    local -a commands\n"
        "    commands=(";
    for (const CommandHelp& command : help.commands) {
        if (is_part(command)) { continue; }
        text += "\n        '" + command.name + ":" + zsh_text(command.description) + "'";
    }
    text += ")\n    _arguments -C" + zsh_options(help.program) +
            " \\\n                '1: :->command' '*:: :->arguments'\n"
            "    case $state in\n"
            "        command) _describe command commands ;;\n"
            "        arguments)\n"
            "            case $line[1] in\n";
    for (const CommandHelp& command : help.commands) {
        if (!is_part(command)) { text += zsh_branch(help, command); }
    }
    return text +
           "            esac ;;\n    esac\n}\n"
           "if [ \"$funcstack[1]\" = _jointwise ]; then _jointwise \"$@\"; else compdef _jointwise "
           "jointwise; fi\n";
}

// ---- fish

std::string fish_text(const std::string& text) {
    return "'" + replaced(replaced(one_line(text), "\\", "\\\\"), "'", "\\'") + "'";
}

std::string fish_options(const CommandHelp& command, const std::string& condition) {
    std::string text;
    for (const OptionHelp& option : command.options) {
        text += "complete -c jointwise" + condition;
        for (const std::string& name : option.names) {
            text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
        }
        if (!option.choices.empty()) {
            text += " -x -a " + fish_text(joined(option.choices));
        } else if (!option.value.empty()) {
            text += " -r";
        }
        text += " -d " + fish_text(option.description) + "\n";
    }
    return text;
}

std::string for_fish(const ProgramHelp& help) {
    std::string text = "# fish completion for jointwise, written by 'jointwise completion fish'\n";
    text += fish_options(help.program, "");
    for (const CommandHelp& command : help.commands) {
        if (!is_part(command)) {
            text += "complete -c jointwise -n __fish_use_subcommand -f -a " + command.name + " -d " +
                    fish_text(command.description) + "\n";
        }
        const std::string seen = "__fish_seen_subcommand_from " +
                                 replaced(command.name, " ", "; and __fish_seen_subcommand_from ");
        text += fish_options(command, " -n '" + seen + "'");
        const std::vector<std::string> words = words_of_positionals(command);
        if (words.empty()) { continue; }
        const std::string no_part =
            command.parts.empty() ? "" : "; and not __fish_seen_subcommand_from " + joined(command.parts);
        text += "complete -c jointwise -n '" + seen + no_part + "' -f -a " + fish_text(joined(words)) + "\n";
    }
    return text;
}

}  // namespace

std::string completion_for(const ProgramHelp& help, const std::string& shell) {
    if (shell == "bash") { return for_bash(help); }
    if (shell == "zsh") { return for_zsh(help); }
    if (shell == "fish") { return for_fish(help); }
    throw std::invalid_argument("no completion for " + shell);
}

}  // namespace jw
