#include "app/commands/options/language_option.hpp"

#include <cstdlib>
#include <vector>

#include "app/commands/program/command.hpp"
#include "app/session/wording/messages.hpp"

namespace jw {

namespace {

constexpr const char* kVariable = "JOINTWISE_LANGUAGE";

std::vector<std::string> language_tags() {
    std::vector<std::string> tags;
    for (const Language& language : languages()) { tags.emplace_back(language.tag); }
    return tags;
}

}  // namespace

void add_language_option(CLI::App& app, std::string& tag) {
    app.fallthrough();
    app.add_option(
           "--language", tag,
           "Language of the program's own sentences: " + comma_list(language_tags()) +
               " (default: " + kVariable + ", else en)")
        ->type_name("TAG");
}

void choose_language(const std::string& tag) {
    const char* const variable = std::getenv(kVariable);
    const bool by_variable = tag.empty() && variable != nullptr && *variable != '\0';
    const std::string wanted = !tag.empty() ? tag : by_variable ? variable : "en";
    if (set_language(wanted)) { return; }
    const std::vector<std::string> tags = language_tags();
    const std::string hint = did_you_mean(wanted, tags);
    throw CommandError(
        Exit::bad_input, std::string("jointwise: error: ") + (by_variable ? kVariable : "--language") +
                             ": no language " + in_quotes(wanted) + "; expected one of " + comma_list(tags) +
                             (hint.empty() ? "" : "\nhint: " + hint));
}

}  // namespace jw
