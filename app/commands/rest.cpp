#include "app/session/rest/rest.hpp"
#include "app/commands/options/shared_options.hpp"
#include "app/commands/program/add_command.hpp"
#include "app/session/output/describe.hpp"
#include "app/session/output/json.hpp"

namespace jw {

namespace {

struct RestOptions {
    std::string file;
    std::vector<std::string> experiments;
    std::vector<std::string> held;
    bool nearest = false;
    std::string format;
};

Exit rest_command(const RestOptions& options, const Streams& streams) {
    const ChangedLesson changed = lesson_of(options.file, options.experiments, streams);
    RestView view;
    try {
        view =
            find_rest(changed.lesson, {options.nearest ? Seek::nearest : Seek::where_it_rests, options.held});
    } catch (const std::invalid_argument& error) {
        throw CommandError(Exit::bad_input, options.file + ": error: " + error.what());
    }
    if (options.format == "json") {
        streams.out << document_of(json_of(view, changed.lesson), changed.done);
    } else if (view.failure.empty()) {
        streams.out << done_text(changed.done) << describe(view);
    }
    if (view.failure.empty()) { return Exit::done; }
    streams.err << "jointwise: error: " << view.failure << '\n';
    return Exit::numerics;
}

}  // namespace

void add_rest(const CommandLine& line) {
    auto [command, options] = add_command<RestOptions>(
        line, "rest",
        "find the equilibrium under masses and forces, its reactions, and small motions about it",
        rest_command, "Example: jointwise rest lessons/catalogue/dynamics/simple-pendulum.toml");
    add_lesson_options(command, options.file, options.experiments, "lesson file with [dynamics]");
    add_value(
        command, "--hold", options.held, "JOINT",
        "joint whose angle or displacement stays as assembled; the torque or force that holds it is written "
        "as its effort");
    command.add_flag(
        "--nearest", options.nearest, "find the equilibrium nearest to the start, even an unstable one");
    add_format_option(command, options.format, {"text", "json"});
}

}  // namespace jw
