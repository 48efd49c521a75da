#include <csignal>
#include <filesystem>
#include <iostream>

#include <fcntl.h>
#include <unistd.h>

#include "app/commands/program/command_line.hpp"

namespace jw {

namespace {

/// Replaces closed streams: otherwise the next opened file gets the number of the stream, and messages go
/// into a picture. Writing to a replacement fails, as it should.
void open_closed_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(stream, F_GETFD) == -1) { static_cast<void>(::open("/dev/null", O_RDONLY)); }
    }
}

}  // namespace

int run_process(
    int argc, char** argv,
    const std::function<int(const std::vector<std::string>& arguments, const Streams& streams)>& run) {
    open_closed_streams();
    // a file that reaches its size limit must cause an error message, not end the program
    std::signal(SIGXFSZ, SIG_IGN);
    std::vector<std::string> command_line{argv, argv + argc};
    std::error_code error;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
    if (error || command_line.empty()) {
        command_line.clear();
    } else {
        command_line[0] = program.string();
    }
    const Streams streams{std::cout, std::cerr, ::isatty(STDERR_FILENO) != 0, is_own_output, command_line};
    const int status = run({argv + 1, argv + argc}, streams);
    std::cout.flush();
    if (!std::cout) {
        std::cerr << "jointwise: error: standard output could not be written (disk full, a limit of its "
                     "size, or a closed pipe)\n";
        return static_cast<int>(Exit::bad_input);
    }
    return status;
}

}  // namespace jw
