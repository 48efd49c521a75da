#include <CLI/CLI.hpp>

#include <memory>

#include "app/commands/help/command_help.hpp"
#include "app/commands/program/commands.hpp"

namespace jw {

void add_completion(CLI::App& app, const Streams& streams, Run& run) {
    CLI::App* command =
        app.add_subcommand("completion", "write the script that completes command lines in a shell");
    auto shell = std::make_shared<std::string>();
    add_value(*command, "SHELL", *shell, "", "bash, zsh or fish")
        ->required()
        ->check(CLI::IsMember({"bash", "zsh", "fish"}));
    command->footer(
        "Example: jointwise completion bash > ~/.local/share/bash-completion/completions/jointwise");
    command->callback([&app, shell, &streams, &run] {
        run = [&app, shell, &streams] {
            streams.out << completion_for(help_of(app), *shell);
            return Exit::done;
        };
    });
}

void add_manual(CLI::App& app, const Streams& streams, Run& run) {
    CLI::App* command = app.add_subcommand("manual", "write the manual page, for man");
    command->footer("Example: jointwise manual > jointwise.1 && man ./jointwise.1");
    command->callback([&app, &streams, &run] {
        run = [&app, &streams] {
            streams.out << manual_page(help_of(app), JW_VERSION);
            return Exit::done;
        };
    });
}

}  // namespace jw
