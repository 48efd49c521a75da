#include "app/commands/help/usage.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <optional>
#include <regex>
#include <string_view>

#include "lessons/diagnostics/diagnostics.hpp"

namespace jw {

namespace {

/// A sentence of the parser, and the same in this program's words; $1 ... as in std::regex.
struct Wording {
    const char* theirs;
    const char* ours;
};

const std::array<Wording, 4> kWordings{{
    {"A subcommand is required", "no command is given"},
    {"(.*): At Most 1 required but received (\\d+)", "$1 is given $2 times; expected once"},
    {"(.*): \\d+ required (.*) missing", "$1 has no value; expected $2"},
    {"(.*) was given a disallowed flag override", "$1 takes no value"},
}};

bool is_whole_number(const std::string& text) {
    static const std::regex form("[+-]?[0-9]+");
    return std::regex_match(text, form);
}

/// True for a number such as 010, which the parser reads as 8.
bool is_octal(const std::string& text) {
    static const std::regex form("[+-]?0[0-9].*");
    return std::regex_match(text, form);
}

bool is_number(const std::string& text) {
    char* end = nullptr;
    std::strtod(text.c_str(), &end);
    return !text.empty() && *end == '\0';
}

/// Type N is a count, in all commands; types T, X and H are numbers of any kind.
bool counts(const CLI::Option& option) { return option.get_type_name() == "N"; }
bool measures(const CLI::Option& option) {
    constexpr std::array<std::string_view, 3> kinds{"T", "X", "H"};
    return std::ranges::find(kinds, option.get_type_name()) != kinds.end();
}

std::string no_number(const CLI::Option& option, const std::string& value) {
    const std::string head = option.get_name() + ' ' + in_quotes(value);
    if (option.get_items_expected_max() == 0) { return option.get_name() + " takes no value"; }
    if (!counts(option)) { return head + "; expected a number such as 0.5 or 1e-6"; }
    if (is_whole_number(value) && !is_octal(value)) {
        return head + " is out of range; expected at most " + std::to_string(std::numeric_limits<int>::max());
    }
    return head + "; expected a whole number, digits only" + (is_octal(value) ? ", no 0 before them" : "");
}

const CLI::Option* option_named(const CLI::App& command, const std::string& name) {
    const std::vector<const CLI::Option*> all = command.get_options();
    const auto found =
        std::ranges::find_if(all, [&](const CLI::Option* option) { return option->check_name(name); });
    return found == all.end() ? nullptr : *found;
}

std::vector<std::string> option_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        if (option->get_group().empty()) { continue; }  // hidden: not meant to be learned
        for (const std::string& name : option->get_lnames()) { names.push_back("--" + name); }
    }
    return names;
}

using Fault = std::optional<std::string>;

/// "--method: foo not in {euler,rk4}"
Fault choice_fault(const CLI::App& /*command*/, const std::smatch& match) {
    std::vector<std::string> words;
    std::istringstream list(match[3]);
    for (std::string word; std::getline(list, word, ',');) { words.push_back(word); }
    const std::string hint = did_you_mean(match[2].str(), words);
    return match[1].str() + ' ' + in_quotes(match[2].str()) + "; expected one of " + comma_list(words) +
           (hint.empty() ? "" : "; " + hint);
}

/// "Could not convert: --samples = 1e99"
Fault number_fault(const CLI::App& command, const std::smatch& match) {
    const CLI::Option* const option = option_named(command, match[1]);
    return option == nullptr ? Fault() : no_number(*option, match[2]);
}

/// 0.750000 becomes 0.75
std::string without_zeros(const std::string& text) {
    static const std::regex form("(\\d+\\.\\d*?)0+(?=\\D|$)");
    static const std::regex point("(\\d+)\\.(?=\\D|$)");
    return std::regex_replace(std::regex_replace(text, form, "$1"), point, "$1");
}

/// "--text: Value 1e9 not in range 0.750000 to 1.500000"
Fault range_fault(const CLI::App& command, const std::smatch& match) {
    const CLI::Option* const option = option_named(command, match[1]);
    if (option != nullptr && !is_number(match[2])) { return no_number(*option, match[2]); }
    return match[1].str() + ' ' + match[2].str() + " is out of range; expected " +
           without_zeros(match[3].str()) + " to " + without_zeros(match[4].str());
}

/// "The following arguments were not expected: a b"
Fault extra_fault(const CLI::App& command, const std::smatch& match) {
    // an unknown option also causes the errors in the words around it
    static const std::regex option("(?:^| )(--[^ =]+)");
    const std::string extra = match[1];
    std::smatch named;
    if (!std::regex_search(extra, named, option)) { return in_quotes(extra) + " was not expected"; }
    const std::string name = named[1];
    const std::string hint = did_you_mean(name, option_names(command));
    return "there is no option " + in_quotes(name) + (hint.empty() ? "" : "; " + hint);
}

/// "--format excludes ": the parser does not name hidden options
Fault excludes_fault(const CLI::App& command, const std::smatch& match) {
    std::vector<std::string> hidden;
    for (const CLI::Option* option : command.get_options()) {
        const bool given = option->count() > 0 && option->get_group().empty();
        if (given) { hidden.push_back("--" + option->get_lnames().front()); }
    }
    auto next = hidden.begin();
    const auto named = [&](const std::string& name) {
        return name.empty() && next != hidden.end() ? *next++ : name;
    };
    const std::string one = named(match[1]);
    return one + " excludes " + named(match[2]);
}

/// A form of the parser's sentences, and what is wrong in this program's words; nothing if it cannot be said.
struct FaultForm {
    const char* theirs;
    Fault (*ours)(const CLI::App& command, const std::smatch& match);
};

constexpr std::array kFaultForms{
    FaultForm{"(.*): (.*) not in \\{(.*)\\}", choice_fault},
    FaultForm{"Could not convert: (\\S*) = (.*)", number_fault},
    FaultForm{"(\\S*): Value (.*) not in range (.*) to (.*)", range_fault},
    FaultForm{"The following arguments? (?:was|were) not expected: ([^]*)", extra_fault},
    FaultForm{"(.*) excludes (.*)", excludes_fault}};

}  // namespace

std::string usage_fault(const CLI::App& command, const CLI::Error& error) {
    const std::string theirs = error.what();
    for (const FaultForm& form : kFaultForms) {
        std::smatch match;
        if (!std::regex_match(theirs, match, std::regex(form.theirs))) { continue; }
        if (const Fault fault = form.ours(command, match)) { return *fault; }
    }
    for (const Wording& wording : kWordings) {
        const std::regex form(wording.theirs);
        if (!std::regex_match(theirs, form)) { continue; }
        return std::regex_replace(theirs, form, wording.ours);
    }
    return theirs;
}

std::string fault_of_numbers(const CLI::App& command) {
    for (const CLI::Option* option : command.get_options()) {
        if (!counts(*option) && !measures(*option)) { continue; }
        for (const std::string& value : option->results()) {
            const bool digits = is_whole_number(value) && !is_octal(value);
            if (value.empty() || (counts(*option) && !digits)) { return no_number(*option, value); }
        }
    }
    return {};
}

}  // namespace jw
