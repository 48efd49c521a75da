#include <iostream>

#include <unistd.h>

#include "app/commands/program.hpp"

int main(int argc, char** argv) {
    const jw::Streams streams{std::cout, std::cerr, ::isatty(STDERR_FILENO) != 0};
    const int status = jw::run_program({argv + 1, argv + argc}, streams);
    std::cout.flush();
    if (!std::cout) {
        std::cerr << "jointwise: error: standard output could not be written (disk full, or a closed pipe)\n";
        return static_cast<int>(jw::Exit::bad_input);
    }
    return status;
}
