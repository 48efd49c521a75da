#include "app/film/processes.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <thread>

namespace jw::film {

namespace {

namespace fs = std::filesystem;

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

constexpr int kMostParts = 9999;

fs::path log_of(const fs::path& folder, int part) {
    return folder / ("part-" + std::to_string(part + 1) + ".log");
}

/// The environment of this process, with the number of a part in it. Each part draws with one thread: the
/// parts together use all cores, and threads that share one picture wait for each other.
std::vector<std::string> environment_of(int part, int parts) {
    const std::array<std::string, 2> own{
        std::string(kPartVariable) + "=" + std::to_string(part + 1) + "/" + std::to_string(parts),
        "LP_NUM_THREADS=0"};
    std::vector<std::string> words(own.begin(), own.end());
    for (char** word = ::environ; *word != nullptr; ++word) {
        const std::string name = std::string(*word).substr(0, std::strcspn(*word, "=") + 1);
        if (std::ranges::none_of(own, [&](const std::string& o) { return o.starts_with(name); })) {
            words.emplace_back(*word);
        }
    }
    return words;
}

/// Processes that are ended when this is destroyed.
class Children {
public:
    Children() = default;
    ~Children() {
        for (const pid_t child : running_) {
            if (child == 0) { continue; }
            ::kill(child, SIGTERM);
            ::waitpid(child, nullptr, 0);
        }
    }
    Children(const Children&) = delete;
    Children& operator=(const Children&) = delete;

    void add(pid_t child) { running_.push_back(child); }

    /// @param failed  set to the index of a process that has failed, from 0
    /// @return false if all have ended
    bool are_running(int& failed) {
        bool any = false;
        for (std::size_t k = 0; k < running_.size(); ++k) {
            if (running_[k] == 0) { continue; }
            int status = 0;
            if (::waitpid(running_[k], &status, WNOHANG) == 0) {
                any = true;
                continue;
            }
            running_[k] = 0;
            if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) { failed = static_cast<int>(k); }
        }
        return any && failed < 0;
    }

private:
    std::vector<pid_t> running_;  ///< 0: has ended
};

bool read_number(const char*& at, const char* end, int& number) {
    const auto [stop, error] = std::from_chars(at, end, number);
    at = stop;
    return error == std::errc();
}

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

std::optional<std::string> part_of_environment() {
    const char* const part = std::getenv(kPartVariable);
    return part == nullptr ? std::nullopt : std::optional<std::string>(part);
}

bool read_part(const std::string& text, Part& part) {
    const char* at = text.data();
    const char* const end = at + text.size();
    Part read;
    if (!read_number(at, end, read.part) || at == end || *at++ != '/') { return false; }
    if (!read_number(at, end, read.parts) || at != end) { return false; }
    if (read.part < 1 || read.part > read.parts || read.parts > kMostParts) { return false; }
    part = {read.part - 1, read.parts};
    return true;
}

void run_parts(
    const std::vector<std::string>& command_line, int parts, const fs::path& folder,
    const std::function<void()>& waiting) {
    Children children;
    for (int part = 0; part < parts; ++part) {
        children.add(start({command_line, environment_of(part, parts), log_of(folder, part)}));
    }
    int failed = -1;
    while (children.are_running(failed)) {
        waiting();
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    if (failed >= 0) {
        const std::string said = last_line_of(log_of(folder, failed));
        constexpr std::string_view prefix = "jointwise: error: ";
        throw std::runtime_error(
            said.empty()               ? "a process that drew pictures ended without a message"
            : said.starts_with(prefix) ? said.substr(prefix.size())
                                       : said);
    }
    for (int part = 0; part < parts; ++part) { fs::remove(log_of(folder, part)); }
}

void end_with_parent() {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    // the parent may have ended before this call
    if (::getppid() == 1) { ::_exit(1); }
}

}  // namespace jw::film
