#include "app/exercises/grading/workers.hpp"

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <new>
#include <string_view>
#include <vector>

#include "app/session/wording/messages.hpp"
#include "lessons/text/text.hpp"

namespace jw {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostResult = 4U << 20U;
constexpr const char* kNoProcess = tr_later("No process could be started.");

/// A process that does the parts of a piece, starting at `done.size()`.
struct Worker {
    int piece = 0;
    pid_t process = -1;
    int pipe = -1;
    Clock::time_point end;  ///< of the part that it does
    std::string unread;     ///< received bytes; each result follows its length
    std::vector<WorkDone> done;
};

void write_all(int handle, std::string_view text) {
    for (std::size_t at = 0; at < text.size();) {
        const ssize_t count = write(handle, text.data() + at, text.size() - at);
        if (count < 0 && errno == EINTR) { continue; }
        if (count <= 0) { return; }
        at += static_cast<std::size_t>(count);
    }
}

void write_result(int handle, const std::string& result) {
    const std::uint64_t size = result.size();
    std::array<char, sizeof size> head{};
    std::memcpy(head.data(), &size, sizeof size);
    write_all(handle, {head.data(), head.size()});
    write_all(handle, result);
}

void limit(int what, rlim_t most) {
    const rlimit both{most, most};
    setrlimit(what, &both);
}

/// Limits the processor time of this process to `more_seconds` from now on. The hard limit stays, because it
/// could never be raised again.
void limit_cpu(int more_seconds) {
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    rlimit now{};
    getrlimit(RLIMIT_CPU, &now);
    const auto until = static_cast<rlim_t>(used.ru_utime.tv_sec + used.ru_stime.tv_sec + 1 + more_seconds);
    now.rlim_cur = std::min(until, now.rlim_max);
    setrlimit(RLIMIT_CPU, &now);
}

[[noreturn]] void work_and_leave(
    int handle, int piece, int first, const Work& work, const WorkerLimits& limits) {
    // its own group, so that everything that it starts ends with it
    setpgid(0, 0);
    // default actions: the parent process reports how this one ended
    for (const int signal_number : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGTERM, SIGINT, SIGXCPU}) {
        signal(signal_number, SIG_DFL);
    }
    limit(RLIMIT_AS, static_cast<rlim_t>(limits.address_bytes));
    limit(RLIMIT_CORE, 0);
    try {
        for (int part = first; part < work.parts; ++part) {
            limit_cpu(limits.cpu_seconds);
            write_result(handle, work.carry_out(piece, part));
        }
        _exit(0);
    } catch (const std::bad_alloc&) { _exit(3); } catch (...) {
        _exit(2);
    }
}

Clock::time_point end_of_part(const Work& work, const Worker& worker) {
    const int part = std::min(static_cast<int>(worker.done.size()), work.parts - 1);
    return Clock::now() + std::chrono::milliseconds(static_cast<int>(1000.0 * work.wall_seconds(part)));
}

/// Starts a process for the remaining parts of `worker`. @return false if no process can be started
bool start(Worker& worker, const Work& work, const WorkerLimits& limits) {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) { return false; }
    worker.process = fork();
    if (worker.process == 0) {
        close(ends[0]);
        work_and_leave(ends[1], worker.piece, static_cast<int>(worker.done.size()), work, limits);
    }
    close(ends[1]);
    worker.pipe = ends[0];
    if (worker.process < 0) { close(worker.pipe); }
    worker.unread.clear();
    worker.end = end_of_part(work, worker);
    return worker.process >= 0;
}

std::string problem_of(int status) {
    if (WIFSIGNALED(status)) {
        const int signal = WTERMSIG(status);
        return signal == SIGXCPU || signal == SIGKILL ? tr("Grading took too long and was stopped.")
                                                      : tr("Grading ended with signal {0}.", signal);
    }
    if (WEXITSTATUS(status) == 3) { return tr("Grading took too much memory and was stopped."); }
    return WEXITSTATUS(status) == 0 ? "" : tr("Grading failed.");
}

/// Takes the results that are complete. @return false if one is larger than allowed
bool take_results(Worker& worker, const Work& work) {
    for (;;) {
        std::uint64_t size = 0;
        if (worker.unread.size() < sizeof size) { return true; }
        std::memcpy(&size, worker.unread.data(), sizeof size);
        if (size > kMostResult) { return false; }
        if (worker.unread.size() < sizeof size + size) { return true; }
        worker.done.push_back({worker.unread.substr(sizeof size, size), {}});
        worker.unread.erase(0, sizeof size + size);
        worker.end = end_of_part(work, worker);
    }
}

/// Reads the available bytes. @return false at the end, or if a result is larger than allowed
bool read_more(Worker& worker, const Work& work) {
    std::array<char, 65536> part{};
    const ssize_t count = read(worker.pipe, part.data(), part.size());
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) { return true; }
    if (count <= 0) { return false; }
    worker.unread.append(part.data(), static_cast<std::size_t>(count));
    return take_results(worker, work);
}

/// Waits for the end of the process and ends its group. @return why it ended early, if it did
std::string finished(const Worker& worker) {
    close(worker.pipe);
    int status = 0;
    while (waitpid(worker.process, &status, 0) < 0 && errno == EINTR) {}
    kill(-worker.process, SIGKILL);
    return problem_of(status);
}

/// Ends the process and starts another one for the remaining parts. @return false if there are none
bool go_on(Worker& worker, const Work& work, const WorkerLimits& limits) {
    const auto parts = static_cast<std::size_t>(work.parts);
    // a process that wrote too much is still running
    if (worker.done.size() < parts) { kill(-worker.process, SIGKILL); }
    const std::string problem = finished(worker);
    if (worker.done.size() >= parts) { return false; }
    worker.done.push_back({{}, problem.empty() ? tr("Grading gave no result.") : problem});
    if (worker.done.size() == 1) { return false; }
    while (worker.done.size() < parts && !start(worker, work, limits)) {
        worker.done.push_back({{}, tr(kNoProcess)});
    }
    return worker.done.size() < parts;
}

void wait_for_some(const std::vector<Worker>& workers) {
    std::vector<pollfd> handles;
    for (const Worker& worker : workers) { handles.push_back({worker.pipe, POLLIN, 0}); }
    poll(handles.data(), handles.size(), 200);
}

bool has_something(const Worker& worker) {
    pollfd handle{worker.pipe, POLLIN, 0};
    return poll(&handle, 1, 0) > 0;
}

/// Handles one process. @return false if its piece has ended
bool attend(Worker& worker, const Work& work, const WorkerLimits& limits) {
    const bool late = Clock::now() > worker.end;
    if (late) { kill(-worker.process, SIGKILL); }
    if (!late && (!has_something(worker) || read_more(worker, work))) { return true; }
    return go_on(worker, work, limits);
}

}  // namespace

void do_in_processes(const Work& work, int jobs, const WorkerLimits& limits) {
    std::vector<Worker> workers;
    int next = 0;
    while (next < work.pieces || !workers.empty()) {
        while (next < work.pieces && static_cast<int>(workers.size()) < std::max(1, jobs)) {
            Worker worker;
            worker.piece = next++;
            if (start(worker, work, limits)) {
                workers.push_back(std::move(worker));
            } else {
                work.ended(worker.piece, {{{}, tr(kNoProcess)}});
            }
        }
        wait_for_some(workers);
        for (std::size_t k = 0; k < workers.size();) {
            if (attend(workers[k], work, limits)) {
                ++k;
                continue;
            }
            Worker ended = std::move(workers[k]);
            workers.erase(workers.begin() + static_cast<std::ptrdiff_t>(k));
            work.ended(ended.piece, std::move(ended.done));
        }
    }
}

}  // namespace jw
