#pragma once

#include <functional>

#include "app/commands/program/command.hpp"
#include "app/commands/program/surface.hpp"

namespace CLI {
class App;
}

/// The commands of the program, one per file. Each adds itself with its options to a command line.
namespace jw {

using Run = std::function<Exit()>;

/// The command line that commands are added to.
struct CommandLine {
    CLI::App& app;
    const Streams& streams;
    Run& run;  ///< what the command that is named does
};

void add_open(const CommandLine& line);
void add_list(const CommandLine& line);
void add_new(const CommandLine& line);
void add_check(const CommandLine& line);
void add_explain(const CommandLine& line);
void add_sheet(const CommandLine& line);
void add_grade(const CommandLine& line);
void add_keys(const CommandLine& line);
void add_schema(const CommandLine& line);
void add_step(const CommandLine& line);
void add_inspect(const CommandLine& line);
void add_bench(const CommandLine& line);
void add_simulate(const CommandLine& line);
void add_rest(const CommandLine& line);
void add_solve(const CommandLine& line);
void add_try(const CommandLine& line);
void add_newton(const CommandLine& line);
void add_plot(const CommandLine& line);
void add_render(const CommandLine& line);
void add_export(const CommandLine& line);
void add_site(const CommandLine& line);
void add_snapshot(const CommandLine& line);
void add_doctor(const CommandLine& line, const SurfaceDoctor& doctor_window);
void add_completion(const CommandLine& line);
void add_manual(const CommandLine& line);

}  // namespace jw
