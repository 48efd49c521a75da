#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/commands/program/command.hpp"
#include "app/commands/program/surface.hpp"

namespace CLI {
class App;
}

/// The commands of the program, one per file. Each adds its options to `app`, and sets `run` to its action if
/// the command line names it.
namespace jw {

using Run = std::function<Exit()>;

/// Adds an option with a value, or an argument. @param type  what the help shows for the value
template <class Command, class Value>
auto* add_value(
    Command& command, const std::string& name, Value& value, const std::string& type,
    const std::string& help) {
    return command.add_option(name, value, help)->type_name(type);
}

/// Makes a command carry out `what` with its options.
template <class Command, class Options>
void sets_run(
    Command& command, Run& run, const Streams& streams, const std::shared_ptr<Options>& options,
    Exit (*what)(const Options&, const Streams&)) {
    command.callback([=, &run, &streams] { run = [=, &streams] { return what(*options, streams); }; });
}

void add_open(CLI::App& app, const Streams& streams, Run& run);
void add_list(CLI::App& app, const Streams& streams, Run& run);
void add_new(CLI::App& app, const Streams& streams, Run& run);
void add_check(CLI::App& app, const Streams& streams, Run& run);
void add_explain(CLI::App& app, const Streams& streams, Run& run);
void add_sheet(CLI::App& app, const Streams& streams, Run& run);
void add_grade(CLI::App& app, const Streams& streams, Run& run);
void add_keys(CLI::App& app, const Streams& streams, Run& run);
void add_schema(CLI::App& app, const Streams& streams, Run& run);
void add_step(CLI::App& app, const Streams& streams, Run& run);
void add_inspect(CLI::App& app, const Streams& streams, Run& run);
void add_bench(CLI::App& app, const Streams& streams, Run& run);
void add_simulate(CLI::App& app, const Streams& streams, Run& run);
void add_rest(CLI::App& app, const Streams& streams, Run& run);
void add_solve(CLI::App& app, const Streams& streams, Run& run);
void add_try(CLI::App& app, const Streams& streams, Run& run);
void add_newton(CLI::App& app, const Streams& streams, Run& run);
void add_plot(CLI::App& app, const Streams& streams, Run& run);
void add_render(CLI::App& app, const Streams& streams, Run& run);
void add_export(CLI::App& app, const Streams& streams, Run& run);
void add_site(CLI::App& app, const Streams& streams, Run& run);
void add_snapshot(CLI::App& app, const Streams& streams, Run& run);
void add_doctor(CLI::App& app, const Streams& streams, Run& run, const SurfaceDoctor& doctor_window);
void add_completion(CLI::App& app, const Streams& streams, Run& run);
void add_manual(CLI::App& app, const Streams& streams, Run& run);

}  // namespace jw
