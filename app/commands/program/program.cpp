#include "app/commands/program/program.hpp"

#include <array>

#include "app/commands/program/command_line.hpp"

namespace jw {

int run_program(
    const std::vector<std::string>& arguments, const Streams& streams, const SurfaceDoctor& doctor_window) {
    const AddCommand add_doctor_of_window = [&](const CommandLine& line) { add_doctor(line, doctor_window); };
    const std::array<AddCommand, 25> commands{
        add_open,     add_list, add_new,     add_check, add_explain,          add_keys,
        add_schema,   add_step, add_inspect, add_try,   add_newton,           add_solve,
        add_simulate, add_rest, add_bench,   add_plot,  add_render,           add_export,
        add_snapshot, add_site, add_sheet,   add_grade, add_doctor_of_window, add_completion,
        add_manual};
    return run_commands(commands, arguments, streams);
}

}  // namespace jw
