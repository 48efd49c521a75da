#include "app/commands/program/program.hpp"

#include <array>

#include "app/commands/program/command_line.hpp"

namespace jw {

int run_program(
    const std::vector<std::string>& arguments, const Streams& streams, const SurfaceDoctor& doctor_window) {
    const AddCommand add_doctor_of_window = [&](CLI::App& app, const Streams& to, Run& run) {
        add_doctor(app, to, run, doctor_window);
    };
    const std::array commands{AddCommand{add_open},     AddCommand{add_list},    AddCommand{add_new},
                              AddCommand{add_check},    AddCommand{add_explain}, AddCommand{add_keys},
                              AddCommand{add_schema},   AddCommand{add_step},    AddCommand{add_inspect},
                              AddCommand{add_try},      AddCommand{add_newton},  AddCommand{add_solve},
                              AddCommand{add_simulate}, AddCommand{add_rest},    AddCommand{add_bench},
                              AddCommand{add_plot},     AddCommand{add_render},  AddCommand{add_export},
                              AddCommand{add_snapshot}, AddCommand{add_site},    AddCommand{add_sheet},
                              AddCommand{add_grade},    add_doctor_of_window,    AddCommand{add_completion},
                              AddCommand{add_manual}};
    return run_commands(commands, arguments, streams);
}

}  // namespace jw
