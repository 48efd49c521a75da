#include "app/commands/program/command_line.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <new>

#include "app/commands/help/usage.hpp"
#include "app/commands/program/add_command.hpp"
#include "app/session/view/inspection.hpp"
#include "app/session/wording/messages.hpp"
#include "lessons/diagnostics/diagnostics.hpp"
#include "render/surface/headless_context.hpp"

namespace jw {

namespace {

constexpr const char* kDescription =
    "Jointwise: spatial kinematics of constrained rigid bodies, joint by joint.\n"
    "The program reads a mechanism from a lesson file and shows its equations Phi, their Jacobian and its\n"
    "rank as text, JSON and pictures.";

constexpr const char* kFooter =
    "Example: jointwise step lessons/catalogue/loops/four-bar.toml\n"
    "Exit status: 0 done, 1 a check failed, 2 bad usage or input, 3 the numerical methods failed.\n"
    "'jointwise COMMAND --help' shows an example of each command.";

int status(Exit exit) { return static_cast<int>(exit); }

/// Error for an unknown command: CLI11 only says that a command is required.
std::string unknown_command(const CLI::App& app, const std::vector<std::string>& arguments) {
    if (arguments.empty() || arguments.front().starts_with('-')) { return {}; }
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) { names.push_back(command->get_name()); }
    if (std::ranges::find(names, arguments.front()) != names.end()) { return {}; }
    std::string hint = did_you_mean(arguments.front(), names);
    // all names, even if they are many
    std::string all;
    for (const std::string& name : names) { all += (all.empty() ? "" : ", ") + name; }
    return "jointwise: error: no command " + in_quotes(arguments.front()) + "; expected one of " + all +
           "\nhint: " + (hint.empty() ? "jointwise --help" : hint) + "\n";
}

/// Finds errors in arguments that the parser accepts.
void check_numbers(const CLI::App& app) {
    for (const CLI::App* command : app.get_subcommands()) {
        const std::string fault = fault_of_numbers(*command);
        if (!fault.empty()) { throw bad_option(command->get_name(), fault); }
    }
}

/// An error of the file system, without the name of the function that found it.
std::string words_of(const std::filesystem::filesystem_error& error) {
    const std::string where = error.path1().empty() ? "" : in_quotes(error.path1().string()) + ": ";
    return where + error.code().message();
}

/// Help without the list of excluded options if all of them are hidden.
class HelpFormatter : public CLI::Formatter {
public:
    std::string make_option_opts(const CLI::Option* option) const override {
        const std::string text = CLI::Formatter::make_option_opts(option);
        const std::size_t excludes = text.find(" Excludes:");
        if (excludes == std::string::npos) { return text; }
        const bool names_one = text.find("--", excludes) != std::string::npos;
        return names_one ? text : text.substr(0, excludes);
    }
};

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

/// Adds `--language TAG`, the language of the program's own sentences, and `--surface NAME`, the library that
/// draws pictures without a window. Commands that are added later take them, too.
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

/// Sets the language: from the option, else from JOINTWISE_LANGUAGE, else English.
/// @throws CommandError (bad_input) that names the available languages
void choose_language(const std::string& tag) {
    const Wanted wanted(tag, "--language", kLanguageVariable);
    if (set_language(wanted.value.empty() ? "en" : wanted.value)) { return; }
    const std::vector<std::string> tags = language_tags();
    throw bad_input(
        wanted.source + ": no language " + in_quotes(wanted.value) + "; expected one of " + comma_list(tags),
        did_you_mean(wanted.value, tags));
}

/// Sets the surface: from the option, else from JOINTWISE_SURFACE, else OSMesa, or EGL if there is no OSMesa.
/// @throws CommandError (bad_input) that names the available ones
void choose_surface(const std::string& name) {
    const auto [wanted, source] = Wanted(name, "--surface", kSurfaceVariable);
    if (wanted.empty()) { return render::choose_headless_surface(render::HeadlessSurface::automatic); }
    if (wanted == "osmesa") { return render::choose_headless_surface(render::HeadlessSurface::osmesa); }
    if (wanted == "egl") { return render::choose_headless_surface(render::HeadlessSurface::egl); }
    throw bad_input(source + " '" + wanted + "'; expected osmesa or egl");
}

}  // namespace

int run_commands(
    std::span<const AddCommand> commands, const std::vector<std::string>& arguments, const Streams& streams) {
    CLI::App app(kDescription, "jointwise");
    app.formatter(std::make_shared<HelpFormatter>());
    app.footer(kFooter);
    app.set_version_flag("--version", std::string("jointwise ") + JW_VERSION);
    app.require_subcommand(1);
    app.failure_message([](const CLI::App* self, const CLI::Error& error) {
        // the command that was meant, if the parser got that far
        const std::vector<CLI::App*> given = self->get_subcommands();
        const CLI::App& command = given.empty() ? *self : *given.front();
        return "jointwise: error: " + usage_fault(command, error) + "\nhint: jointwise " +
               (given.empty() ? "" : command.get_name() + " ") + "--help\n";
    });
    std::string language_tag;
    std::string surface_name;
    add_program_options(app, language_tag, surface_name);
    Run run;
    for (const AddCommand& add : commands) { add({app, streams, run}); }
    if (const std::string complaint = unknown_command(app, arguments); !complaint.empty()) {
        streams.err << complaint;
        return status(Exit::bad_input);
    }

    try {
        // CLI11 takes arguments from the end
        std::vector<std::string> last_first(arguments.rbegin(), arguments.rend());
        if (last_first.empty()) { last_first = {"open"}; }
        app.parse(last_first);
        check_numbers(app);
        choose_language(language_tag);
        choose_surface(surface_name);
        return status(run());
    } catch (const CLI::ParseError& error) {
        const bool asked = error.get_exit_code() == 0;  // --help, --version
        app.exit(error, streams.out, streams.err);
        return asked ? 0 : status(Exit::bad_input);
    } catch (const CommandError& error) {
        streams.err << error.what();
        if (const std::string text = error.what(); !text.ends_with('\n')) { streams.err << '\n'; }
        return status(error.exit());
    } catch (const PoseNotReached& error) {
        streams.err << error.what() << '\n';
        return status(Exit::numerics);
    } catch (const std::bad_alloc&) {
        streams.err << "jointwise: error: out of memory\n";
        return status(Exit::numerics);
    } catch (const std::filesystem::filesystem_error& error) {
        streams.err << "jointwise: error: " << words_of(error) << '\n';
        return status(Exit::bad_input);
    } catch (const std::exception& error) {
        // a missing font or OSMesa, or an error of the file system: whoever found it has described it
        streams.err << "jointwise: error: " << error.what() << '\n';
        return status(Exit::bad_input);
    }
}

}  // namespace jw
