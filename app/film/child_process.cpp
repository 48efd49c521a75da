#include "app/film/child_process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
#include <stdexcept>

namespace jw::film {

namespace {

/// Pointers to strings, with a null pointer at the end; the strings must outlive the pointers.
std::vector<char*> pointers_to(std::vector<std::string>& words) {
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (std::string& word : words) { pointers.push_back(word.data()); }
    pointers.push_back(nullptr);
    return pointers;
}

/// Standard input and output of a process that is to be started.
class Redirections {
public:
    explicit Redirections(const Command& command) {
        ::posix_spawn_file_actions_init(&actions_);
        ::posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        ::posix_spawn_file_actions_addopen(
            &actions_, STDOUT_FILENO, command.log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
        ::posix_spawn_file_actions_adddup2(&actions_, STDOUT_FILENO, STDERR_FILENO);
    }
    ~Redirections() { ::posix_spawn_file_actions_destroy(&actions_); }
    Redirections(const Redirections&) = delete;
    Redirections& operator=(const Redirections&) = delete;
    const posix_spawn_file_actions_t* actions() const { return &actions_; }

private:
    posix_spawn_file_actions_t actions_{};
};

}  // namespace

pid_t start(const Command& command) {
    const Redirections redirections(command);
    std::vector<std::string> words = command.words;
    std::vector<std::string> environment = command.environment;
    const std::vector<char*> arguments = pointers_to(words);
    const std::vector<char*> variables = pointers_to(environment);
    pid_t child = 0;
    const int error = ::posix_spawnp(
        &child, arguments[0], redirections.actions(), nullptr, arguments.data(),
        environment.empty() ? ::environ : variables.data());
    if (error != 0) {
        throw std::runtime_error("'" + words[0] + "' cannot be started: " + std::strerror(error));
    }
    return child;
}

std::string last_line_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::string last;
    for (std::string line; std::getline(in, line);) {
        if (!line.empty()) { last = line; }
    }
    return last;
}

}  // namespace jw::film
