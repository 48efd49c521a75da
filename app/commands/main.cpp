#include <array>
#include <csignal>
#include <iostream>

#include <fcntl.h>
#include <unistd.h>

#include "app/commands/outputs.hpp"
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
    // before anything loads them
    constexpr std::array libraries{
        jw::Library{"libGLX.so.0", "libglx0"}, jw::Library{"libGL.so.1", "libgl1"},
        jw::Library{"libGLX_mesa.so.0", "libglx-mesa0"}};
    jw::SurfaceReport blamed = report;
    const bool library_is_bad = jw::blame_library(blamed, libraries);
    // one that is damaged would end the program; without one that is missing another may do
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

/// A stream that is closed would lend its number to the next file that is opened, and what is said would go
/// into a picture. What is written into one of these fails as it should.
void open_closed_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(stream, F_GETFD) == -1) { static_cast<void>(::open("/dev/null", O_RDONLY)); }
    }
}

}  // namespace

int main(int argc, char** argv) {
    open_closed_streams();
    // a file that grows beyond its limit is an error that is told, and not the end
    std::signal(SIGXFSZ, SIG_IGN);
    std::vector<std::string> command_line{argv, argv + argc};
    std::error_code error;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
    if (error || command_line.empty()) {
        command_line.clear();
    } else {
        command_line[0] = program.string();
    }
    const jw::Streams streams{
        std::cout, std::cerr, ::isatty(STDERR_FILENO) != 0, jw::is_own_output, command_line};
    const int status = jw::run_program({argv + 1, argv + argc}, streams, examine_window);
    std::cout.flush();
    if (!std::cout) {
        std::cerr << "jointwise: error: standard output could not be written (disk full, a limit of its "
                     "size, or a closed pipe)\n";
        return static_cast<int>(jw::Exit::bad_input);
    }
    return status;
}
