#include "app/commands/help/command_help.hpp"

#include <CLI/CLI.hpp>

#include "app/commands/program/add_command.hpp"

namespace jw {

namespace {

/// "NAME:{euler,rk4}" -> the words in braces.
std::vector<std::string> words_in_braces(const std::string& type) {
    const std::size_t open = type.find('{');
    const std::size_t close = type.find('}', open);
    if (open == std::string::npos || close == std::string::npos) { return {}; }
    return CLI::detail::split(type.substr(open + 1, close - open - 1), ',');
}

OptionHelp option_help(const CLI::Option& option) {
    OptionHelp help;
    for (const std::string& name : option.get_snames()) { help.names.push_back("-" + name); }
    for (const std::string& name : option.get_lnames()) { help.names.push_back("--" + name); }
    const bool positional = help.names.empty();
    if (positional) { help.names.push_back(option.get_name()); }
    const std::string type = option.get_type_name();
    help.choices = words_in_braces(type);
    const bool takes_value = option.get_expected_max() > 0 && option.get_type_size() > 0;
    if (!positional && takes_value) { help.value = type.substr(0, type.find(':')); }
    help.description = option.get_description();
    help.required = option.get_required();
    help.many = option.get_expected_max() > 1;
    return help;
}

CommandHelp help_of_command(const CLI::App& command) {
    CommandHelp help{command.get_name(), command.get_description(), command.get_footer(), {}, {}, {}};
    for (const CLI::Option* option : command.get_options()) {
        if (option->get_group().empty()) { continue; }  // hidden option
        const bool positional = option->get_snames().empty() && option->get_lnames().empty();
        (positional ? help.positionals : help.options).push_back(option_help(*option));
    }
    return help;
}

/// Adds the commands of a program, or the parts of a command.
void add_commands(const CLI::App& app, const std::string& before, std::vector<CommandHelp>& commands) {
    for (const CLI::App* command : app.get_subcommands({})) {
        if (command->get_group().empty()) { continue; }
        CommandHelp help = help_of_command(*command);
        help.name = before + help.name;
        for (const CLI::App* part : command->get_subcommands({})) { help.parts.push_back(part->get_name()); }
        commands.push_back(help);
        add_commands(*command, help.name + " ", commands);
    }
}

struct HelpOptions {
    const CLI::App* app = nullptr;  ///< the program
    std::string shell;
};

Exit write_completion(const HelpOptions& options, const Streams& streams) {
    streams.out << completion_for(help_of(*options.app), options.shell);
    return Exit::done;
}

Exit write_manual(const HelpOptions& options, const Streams& streams) {
    streams.out << manual_page(help_of(*options.app), JW_VERSION);
    return Exit::done;
}

}  // namespace

ProgramHelp help_of(const CLI::App& app) {
    ProgramHelp help{help_of_command(app), {}};
    add_commands(app, "", help.commands);
    return help;
}

void add_completion(const CommandLine& line) {
    auto [command, options] = add_command<HelpOptions>(
        line, "completion", "write the script that completes command lines in a shell", write_completion,
        "Example: jointwise completion bash > ~/.local/share/bash-completion/completions/jointwise");
    options.app = &line.app;
    add_value(command, "SHELL", options.shell, "", "bash, zsh or fish")
        ->required()
        ->check(CLI::IsMember({"bash", "zsh", "fish"}));
}

void add_manual(const CommandLine& line) {
    add_command<HelpOptions>(
        line, "manual", "write the manual page, for man", write_manual,
        "Example: jointwise manual > jointwise.1 && man ./jointwise.1")
        .options.app = &line.app;
}

}  // namespace jw
