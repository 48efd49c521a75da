#include <iostream>

#include <unistd.h>

#include "app/commands/program.hpp"
#include "app/window.hpp"

namespace {

/// The window's part of `jointwise doctor`.
jw::SurfaceReport examine_window() {
    jw::SurfaceReport report;
    report.name = "window";
    if (!jw::has_display()) {
        report.problem = "no display here";
        report.remedy = "pictures and text need none; for a window without a screen use xvfb-run";
        return report;
    }
    try {
        jw::with_hidden_window([&](const jw::render::GlFunctions& gl) { jw::examine(gl, report); });
    } catch (const std::exception& error) {
        report.state = jw::SurfaceReport::State::missing;
        report.problem = error.what();
    }
    return report;
}

}  // namespace

int main(int argc, char** argv) {
    const jw::Streams streams{std::cout, std::cerr, ::isatty(STDERR_FILENO) != 0};
    const int status = jw::run_program({argv + 1, argv + argc}, streams, examine_window);
    std::cout.flush();
    if (!std::cout) {
        std::cerr << "jointwise: error: standard output could not be written (disk full, or a closed pipe)\n";
        return static_cast<int>(jw::Exit::bad_input);
    }
    return status;
}
