#include "app/commands/options/format_option.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include "app/commands/program/commands.hpp"

namespace jw {

namespace {

/// "text, csv or json"
std::string or_list(const std::vector<std::string>& words) {
    std::string text = words.front();
    for (std::size_t k = 1; k < words.size(); ++k) {
        text += (k + 1 == words.size() ? " or " : ", ") + words[k];
    }
    return text;
}

}  // namespace

void add_format_option(
    CLI::App& command, std::string& format, const std::vector<std::string>& words, const std::string& help) {
    format = words.front();
    const auto add = [&](const char* name) {
        return add_value(command, name, format, "FORMAT", help.empty() ? or_list(words) : help)
            ->check(CLI::IsMember(words));
    };
    CLI::Option* const option = add("--format");
    // help does not show an empty group
    CLI::Option* const output = add("--output")->group("")->excludes(option);
    if (std::ranges::find(words, "json") == words.end()) { return; }
    command.add_flag_callback("--json", [&format] { format = "json"; })
        ->group("")
        ->excludes(option)
        ->excludes(output);
}

}  // namespace jw
