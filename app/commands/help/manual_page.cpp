#include "app/commands/help/command_help.hpp"

#include <algorithm>

namespace jw {

namespace {

/// Escapes text for roff, so that no character has a special meaning.
std::string roff(const std::string& text) {
    std::string safe;
    for (std::size_t k = 0; k < text.size(); ++k) {
        const bool at_line = k == 0 || text[k - 1] == '\n';
        if (at_line && (text[k] == '.' || text[k] == '\'')) { safe += "\\&"; }
        switch (text[k]) {
            case '\\': safe += "\\e"; break;
            case '-': safe += "\\-"; break;
            case '\'': safe += "\\(aq"; break;
            case '^': safe += "\\(ha"; break;
            case '~': safe += "\\(ti"; break;
            case '`': safe += "\\(ga"; break;
            default: safe += text[k];
        }
    }
    return safe;
}

/// Keeps lines: each line feed of a text starts a new line.
std::string lines(const std::string& text) {
    std::string all;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        if (end > at) { all += (all.empty() ? "" : ".br\n") + roff(text.substr(at, end - at)) + "\n"; }
        at = end + 1;
    }
    return all;
}

std::string option_entry(const OptionHelp& option) {
    std::string names;
    for (const std::string& name : option.names) {
        names += (names.empty() ? "" : ", ") + std::string("\\fB") + roff(name) + "\\fR";
    }
    if (!option.value.empty()) { names += " \\fI" + roff(option.value) + "\\fR"; }
    if (option.many) { names += " ..."; }
    std::string text = ".TP\n" + names + "\n" + roff(option.description) + "\n";
    if (option.choices.empty()) { return text; }
    std::string words;
    for (const std::string& word : option.choices) {
        words += (words.empty() ? "" : ", ") + std::string("\\fB") + roff(word) + "\\fR";
    }
    return text + ".br\nOne of " + words + ".\n";
}

std::string synopsis_of(const CommandHelp& command) {
    std::string text = "\\fBjointwise " + roff(command.name) + "\\fR";
    for (const OptionHelp& option : command.options) {
        if (!option.required) { continue; }
        text += " \\fB" + roff(option.names.back()) + "\\fR \\fI" + roff(option.value) + "\\fR";
    }
    text += " [\\fIoptions\\fR]";
    for (const OptionHelp& positional : command.positionals) {
        const std::string name =
            "\\fI" + roff(positional.names.front()) + "\\fR" + (positional.many ? " ..." : "");
        text += positional.required ? " " + name : " [" + name + "]";
    }
    return text;
}

std::string section_of(const CommandHelp& command) {
    std::string text = ".SS " + roff(command.name) + "\n" + synopsis_of(command) + "\n.PP\n";
    text += lines(command.description);
    for (const OptionHelp& positional : command.positionals) { text += option_entry(positional); }
    for (const OptionHelp& option : command.options) { text += option_entry(option); }
    return text + (command.footer.empty() ? "" : ".PP\n" + lines(command.footer));
}

constexpr const char* kEnvironment = R"(.SH ENVIRONMENT
.TP
.B JOINTWISE_LESSONS
folder of the lessons that are offered instead of those that come with the program
.TP
.B JOINTWISE_LANGUAGE
language of the program, as for \fB\-\-language\fR
)";

}  // namespace

std::string manual_page(const ProgramHelp& help, const std::string& version) {
    std::string text = ".TH JOINTWISE 1 \"\" \"jointwise " + version + "\" \"User Commands\"\n";
    text += ".SH NAME\njointwise \\- spatial kinematics and dynamics of constrained rigid bodies\n";
    text += ".SH SYNOPSIS\n.B jointwise\n[\\fIcommand\\fR [\\fIarguments\\fR]]\n";
    text += ".SH DESCRIPTION\n" + lines(help.program.description);
    text += ".SH OPTIONS\n";
    for (const OptionHelp& option : help.program.options) { text += option_entry(option); }
    text += ".SH COMMANDS\n";
    for (const CommandHelp& command : help.commands) { text += section_of(command); }
    return text + kEnvironment + ".SH EXIT STATUS\n" + lines(help.program.footer);
}

}  // namespace jw
