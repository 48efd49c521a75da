#include "app/commands/options/program_options.hpp"

#include <CLI/CLI.hpp>

#include <cstdlib>
#include <vector>

#include "app/commands/program/commands.hpp"
#include "app/session/wording/messages.hpp"
#include "render/surface/headless_context.hpp"

namespace jw {

namespace {

constexpr const char* kLanguageVariable = "JOINTWISE_LANGUAGE";
constexpr const char* kSurfaceVariable = "JOINTWISE_SURFACE";

/// The value of an option, else that of a variable, and which of them it comes from.
struct Wanted {
    std::string value;
    std::string source;

    Wanted(const std::string& typed, const char* option, const char* variable)
        : value(typed), source(option) {
        const char* const set = std::getenv(variable);
        if (!typed.empty() || set == nullptr || *set == '\0') { return; }
        value = set;
        source = variable;
    }
};

std::vector<std::string> language_tags() {
    std::vector<std::string> tags;
    for (const Language& language : languages()) { tags.emplace_back(language.tag); }
    return tags;
}

}  // namespace

void add_program_options(CLI::App& app, std::string& language, std::string& surface) {
    app.fallthrough();
    add_value(
        app, "--language", language, "TAG",
        "Language of the program's own sentences: " + comma_list(language_tags()) +
            " (default: " + kLanguageVariable + ", else en)");
    add_value(
        app, "--surface", surface, "NAME",
        std::string("Library that draws pictures without a window: osmesa or egl (default: ") +
            kSurfaceVariable + ", else the one that is installed, osmesa first)");
}

void choose_language(const std::string& tag) {
    const Wanted wanted(tag, "--language", kLanguageVariable);
    if (set_language(wanted.value.empty() ? "en" : wanted.value)) { return; }
    const std::vector<std::string> tags = language_tags();
    throw bad_input(
        wanted.source + ": no language " + in_quotes(wanted.value) + "; expected one of " + comma_list(tags),
        did_you_mean(wanted.value, tags));
}

void choose_surface(const std::string& name) {
    const auto [wanted, source] = Wanted(name, "--surface", kSurfaceVariable);
    if (wanted.empty()) { return render::choose_headless_surface(render::HeadlessSurface::automatic); }
    if (wanted == "osmesa") { return render::choose_headless_surface(render::HeadlessSurface::osmesa); }
    if (wanted == "egl") { return render::choose_headless_surface(render::HeadlessSurface::egl); }
    throw bad_input(source + " '" + wanted + "'; expected osmesa or egl");
}

}  // namespace jw
