#include <array>

#include "app/commands/program/command_line.hpp"
#include "app/commands/program/program.hpp"
#include "app/window.hpp"

namespace {

/// The part of `jointwise doctor` for the window.
jw::SurfaceReport examine_window() {
    jw::SurfaceReport report;
    report.name = "window";
    if (!jw::has_display()) {
        report.problem = "no display here";
        report.remedy = "pictures and text need none; for a window without a screen use xvfb-run";
        return report;
    }
    // checked before anything loads them
    constexpr std::array libraries{
        jw::Library{"libGLX.so.0", "libglx0"}, jw::Library{"libGL.so.1", "libgl1"},
        jw::Library{"libGLX_mesa.so.0", "libglx-mesa0"}};
    jw::SurfaceReport blamed = report;
    const bool library_is_bad = jw::blame_library(blamed, libraries);
    // a damaged library would end the program; in place of a missing one, another may work
    if (library_is_bad && blamed.state == jw::SurfaceReport::State::damaged) { return blamed; }
    try {
        jw::with_hidden_window([&](const jw::render::GlFunctions& gl) { jw::examine(gl, report); });
    } catch (const std::exception& error) {
        report.state = jw::SurfaceReport::State::missing;
        report.problem = error.what();
        if (library_is_bad) { return blamed; }
    }
    return report;
}

}  // namespace

int main(int argc, char** argv) {
    return jw::run_process(argc, argv, [](const auto& arguments, const jw::Streams& streams) {
        return jw::run_program(arguments, streams, examine_window);
    });
}
