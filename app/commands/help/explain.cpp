#include <algorithm>
#include <sstream>

#include "app/commands/options/shared_options.hpp"
#include "app/commands/program/add_command.hpp"
#include "app/session/output/json.hpp"
#include "lessons/diagnostics/diagnostics.hpp"
#include "lessons/explanations/explanations.hpp"

namespace jw {

namespace {

using Setting = Explanation::Setting;

constexpr const char* kIntroduction =
    "# Diagnostics\n\n"
    "Written by `./dev golden` from `jointwise explain --format markdown`; do not edit. The texts are in\n"
    "`lessons/explanations`.\n\n"
    "Every message about a lesson ends with a code that names its cause. `jointwise explain JW301` shows "
    "the\n"
    "page about a code, `jointwise explain` all codes. A test reads every example below.\n";

const char* words_for(Setting setting) {
    switch (setting) {
        case Setting::whole: return "the whole file";
        case Setting::head: return "at the beginning of the lesson about a crank and a slider";
        case Setting::behind: return "after the lesson about a crank and a slider";
        case Setting::masses: return "after the lesson about a crank and a slider that have masses";
        case Setting::course: return "a course.toml";
        case Setting::path: break;
    }
    return "FILE";
}

/// The messages for the wrong example; empty if they depend on the files of a machine.
std::vector<std::string> messages_of(const Explanation& page) {
    std::vector<std::string> messages;
    if (page.setting == Setting::path) { return messages; }
    for (const Diagnostic& diagnostic : read_example(page.setting, page.wrong)) {
        if (diagnostic.code != page.code) { continue; }
        messages.push_back(
            (diagnostic.severity == Severity::error ? "error: " : "warning: ") + diagnostic.message + " [" +
            to_string(page.code) + "]");
        if (!diagnostic.hint.empty()) { messages.push_back("hint: " + diagnostic.hint); }
    }
    return messages;
}

std::string example_or_nothing(const std::string& example) {
    return example.empty() ? "(nothing)\n" : example;
}

std::string indented(const std::string& text) {
    std::istringstream lines(text);
    std::string out;
    for (std::string line; std::getline(lines, line);) { out += "  " + line + '\n'; }
    return out;
}

std::string fenced(const std::string& text, const char* language) {
    return std::string("```") + language + '\n' + text + "```\n";
}

void write_markdown_page(const Explanation& page, std::ostream& out) {
    std::string says;
    for (const std::string& line : messages_of(page)) { says += line + '\n'; }
    const char* const language = page.setting == Setting::path ? "" : "toml";
    out << "\n### " << to_string(page.code) << ": " << title_of(page.code) << "\n\n"
        << "**Cause.** " << page.cause << "\n**Cure.** " << page.cure << "\nWrong ("
        << words_for(page.setting) << "):\n\n"
        << fenced(example_or_nothing(page.wrong), page.wrong.empty() ? "" : language);
    if (!says.empty()) { out << '\n' << fenced(says, ""); }
    out << "\nCorrected:\n\n" << fenced(page.right, language);
}

Json json_of_page(const Explanation& page) {
    return {
        {"code", to_string(page.code)},
        {"title", title_of(page.code)},
        {"group", std::string(group_of(page.code))},
        {"cause", page.cause},
        {"cure", page.cure},
        {"setting", words_for(page.setting)},
        {"wrong", page.wrong},
        {"says", messages_of(page)},
        {"mended", page.right}};
}

/// All codes with their titles.
void write_list(std::ostream& out) {
    std::string_view group;
    for (const Explanation& page : explanations()) {
        if (group_of(page.code) != group) {
            out << (group.empty() ? "" : "\n") << group_of(page.code) << '\n';
        }
        group = group_of(page.code);
        out << "  " << to_string(page.code) << "  " << title_of(page.code) << '\n';
    }
}

/// The page about a code, for a terminal.
void write_page(const Explanation& page, std::ostream& out) {
    out << to_string(page.code) << ": " << title_of(page.code) << "\n\n"
        << "Cause:\n"
        << indented(page.cause) << "\nCure:\n"
        << indented(page.cure) << "\nWrong (" << words_for(page.setting) << "):\n"
        << indented(example_or_nothing(page.wrong));
    for (const std::string& line : messages_of(page)) { out << line << '\n'; }
    out << "\nCorrected:\n" << indented(page.right);
}

/// Pages as Markdown; all of them are docs/diagnostics.md.
void write_markdown(const std::vector<Explanation>& pages, std::ostream& out) {
    out << kIntroduction << "\nMost examples continue this lesson about a crank and a slider:\n\n"
        << fenced(text_of_example(Setting::behind, ""), "toml")
        << "\nThose of dynamics continue the same lesson with masses:\n\n"
        << fenced(text_of_example(Setting::masses, ""), "toml");
    std::string_view group;
    for (const Explanation& page : pages) {
        if (group_of(page.code) != group) { out << "\n## " << group_of(page.code) << '\n'; }
        group = group_of(page.code);
        write_markdown_page(page, out);
    }
}

/// The keys are described in docs/command-line.md.
void write_json(const std::vector<Explanation>& pages, std::ostream& out) {
    Json list = Json::array();
    for (const Explanation& page : pages) { list.push_back(json_of_page(page)); }
    const Json json{{"format", "jointwise explain"}, {"version", kJsonVersion}, {"codes", list}};
    out << json_document(json);
}

struct ExplainOptions {
    std::string code;  ///< as typed; empty: all
    std::string format;
};

CommandError no_code(const std::string& typed) {
    std::vector<std::string> codes;
    for (const Explanation& page : explanations()) { codes.push_back(to_string(page.code)); }
    std::string meant = typed;
    std::ranges::transform(meant, meant.begin(), [](char c) { return c == 'j' ? 'J' : c == 'w' ? 'W' : c; });
    if (!meant.starts_with("JW")) { meant = "JW" + meant; }
    const std::string hint = did_you_mean(meant, codes);
    return bad_input(
        "no code " + in_quotes(typed) + "; expected one such as JW301",
        hint.empty() ? "'jointwise explain' lists them" : hint);
}

std::vector<Explanation> wanted(const std::string& typed) {
    if (typed.empty()) { return explanations(); }
    const auto code = read_code(typed);
    const Explanation* page = code ? explanation_of(*code) : nullptr;
    if (page == nullptr && code) {
        throw bad_input("there is no page about " + to_string(*code) + " (" + title_of(*code) + ") yet");
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

void add_explain(const CommandLine& line) {
    auto [command, options] = add_command<ExplainOptions>(
        line, "explain", "show cause and cure of a diagnostic, by its code", explain,
        "Example: jointwise explain JW301");
    add_value(
        command, "CODE", options.code, "", "code such as JW301, jw301 or 301; without it, all are listed");
    add_format_option(command, options.format, {"text", "markdown", "json"});
}

}  // namespace jw
