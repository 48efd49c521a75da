#include <array>

#include "app/commands/program/command_line.hpp"

/// Program with the commands that tell, compute and draw one lesson. ./dev run finds it here. It is built
/// without exercises, sites, snapshots, hard cases and the window.
int main(int argc, char** argv) {
    using jw::AddCommand;
    static const std::array commands{
        AddCommand{jw::add_list},    AddCommand{jw::add_new},      AddCommand{jw::add_explain},
        AddCommand{jw::add_keys},    AddCommand{jw::add_schema},   AddCommand{jw::add_step},
        AddCommand{jw::add_inspect}, AddCommand{jw::add_try},      AddCommand{jw::add_newton},
        AddCommand{jw::add_solve},   AddCommand{jw::add_simulate}, AddCommand{jw::add_plot},
        AddCommand{jw::add_render}};
    return jw::run_process(argc, argv, [](const auto& arguments, const jw::Streams& streams) {
        return jw::run_commands(commands, arguments, streams);
    });
}
