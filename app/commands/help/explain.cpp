#include <CLI/CLI.hpp>

#include <algorithm>

#include "app/commands/help/explanation_pages.hpp"
#include "app/commands/options/format_option.hpp"
#include "app/commands/program/commands.hpp"
#include "lessons/diagnostics/diagnostics.hpp"

namespace jw {

namespace {

struct ExplainOptions {
    std::string code;  ///< as typed; empty: all
    std::string format;
};

CommandError no_code(const std::string& typed) {
    std::vector<std::string> codes;
    for (const Explanation& page : explanations()) { codes.emplace_back(entry_of(page.code).printed); }
    std::string meant = typed;
    std::ranges::transform(meant, meant.begin(), [](char c) { return c == 'j' ? 'J' : c == 'w' ? 'W' : c; });
    if (!meant.starts_with("JW")) { meant = "JW" + meant; }
    const std::string hint = did_you_mean(meant, codes);
    return CommandError(
        Exit::bad_input, "jointwise: error: no code " + in_quotes(typed) + "; expected one as JW301\nhint: " +
                             (hint.empty() ? "'jointwise explain' lists them" : hint));
}

std::vector<Explanation> wanted(const std::string& typed) {
    if (typed.empty()) { return explanations(); }
    const auto code = read_code(typed);
    const Explanation* page = code ? explanation_of(*code) : nullptr;
    if (page == nullptr && code) {
        const CodeEntry& entry = entry_of(*code);
        throw CommandError(
            Exit::bad_input, "jointwise: error: there is no page about " + std::string(entry.printed) + " (" +
                                 std::string(entry.title) + ") yet");
    }
    if (page == nullptr) { throw no_code(typed); }
    return {*page};
}

Exit explain(const ExplainOptions& options, const Streams& streams) {
    const std::vector<Explanation> pages = wanted(options.code);
    if (options.format == "json") {
        write_json(pages, streams.out);
    } else if (options.format == "markdown") {
        write_markdown(pages, streams.out);
    } else if (options.code.empty()) {
        write_list(streams.out);
    } else {
        write_page(pages.front(), streams.out);
    }
    return Exit::done;
}

}  // namespace

void add_explain(CLI::App& app, const Streams& streams, Run& run) {
    CLI::App* command = app.add_subcommand("explain", "show cause and cure of a diagnostic, by its code");
    auto options = std::make_shared<ExplainOptions>();
    command->add_option("CODE", options->code, "code as JW301, jw301 or 301; without it, all are listed")
        ->type_name("");
    add_format_option(*command, options->format, {"text", "markdown", "json"});
    command->footer("Example: jointwise explain JW301");
    command->callback(
        [options, &streams, &run] { run = [options, &streams] { return explain(*options, streams); }; });
}

}  // namespace jw
