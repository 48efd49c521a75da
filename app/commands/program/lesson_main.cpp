#include <array>

#include "app/commands/program/command_line.hpp"

/// Program with the commands that tell, compute and draw one lesson. ./dev run finds it here. It is built
/// without exercises, sites, snapshots, hard cases and the window.
int main(int argc, char** argv) {
    static const std::array<jw::AddCommand, 13> commands{
        jw::add_list,     jw::add_new,     jw::add_explain, jw::add_keys,   jw::add_schema,
        jw::add_step,     jw::add_inspect, jw::add_try,     jw::add_newton, jw::add_solve,
        jw::add_simulate, jw::add_plot,    jw::add_render};
    return jw::run_process(argc, argv, [](const auto& arguments, const jw::Streams& streams) {
        return jw::run_commands(commands, arguments, streams);
    });
}
