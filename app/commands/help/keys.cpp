#include <CLI/CLI.hpp>

#include <algorithm>

#include "app/commands/help/key_pages.hpp"
#include "app/commands/options/format_option.hpp"
#include "app/commands/program/commands.hpp"
#include "lessons/diagnostics/diagnostics.hpp"

namespace jw {

namespace {

struct KeysOptions {
    std::string table;  ///< as typed; empty: all
    std::string format;
};

/// "joint" from "[[joint]]".
std::string without_brackets(std::string typed) {
    std::erase_if(typed, [](char c) { return c == '[' || c == ']'; });
    return typed;
}

KeyPage wanted_page(const std::vector<KeyPage>& all, const std::string& typed) {
    const std::string path = without_brackets(typed);
    if (const std::optional<KeyPage> page = key_page(path)) { return *page; }
    std::vector<std::string> paths;
    for (const KeyPage& page : all) { paths.push_back(page.path); }
    const std::string hint = did_you_mean(path, paths);
    throw CommandError(
        Exit::bad_input, "jointwise: error: no table " + in_quotes(typed) +
                             " in a lesson; expected a table such as 'joint' or 'body.shape'\nhint: " +
                             (hint.empty() ? "'jointwise keys' lists them" : hint));
}

Exit show_keys(const KeysOptions& options, const Streams& streams) {
    const std::vector<KeyPage> all = key_pages();
    const std::vector<KeyPage> wanted =
        options.table.empty() ? all : std::vector{wanted_page(all, options.table)};
    if (options.format == "json") {
        write_keys_json(all, wanted, streams.out);
    } else if (options.format == "markdown") {
        write_keys_markdown(all, wanted, streams.out);
    } else if (options.table.empty()) {
        write_key_list(all, streams.out);
    } else {
        write_key_page(all, wanted.front(), streams.out);
    }
    return Exit::done;
}

}  // namespace

void add_keys(CLI::App& app, const Streams& streams, Run& run) {
    CLI::App* command = app.add_subcommand("keys", "show the keys of a lesson's tables, with their values");
    auto options = std::make_shared<KeysOptions>();
    command->add_option("TABLE", options->table, "table as joint or body.shape; without it, all are listed")
        ->type_name("");
    add_format_option(*command, options->format, {"text", "markdown", "json"});
    command->footer("Example: jointwise keys joint");
    command->callback(
        [options, &streams, &run] { run = [options, &streams] { return show_keys(*options, streams); }; });
}

}  // namespace jw
