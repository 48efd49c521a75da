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
#include <cstdlib>
#include <new>
#include <vector>

namespace jw {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostResult = 4U << 20U;

struct Worker {
    int index = 0;
    pid_t process = -1;
    int pipe = -1;
    Clock::time_point end;
    std::string result;
};

void write_all(int handle, const std::string& text) {
    for (std::size_t at = 0; at < text.size();) {
        const ssize_t count = write(handle, text.data() + at, text.size() - at);
        if (count < 0 && errno == EINTR) { continue; }
        if (count <= 0) { return; }
        at += static_cast<std::size_t>(count);
    }
}

void limit(int what, rlim_t most) {
    const rlimit both{most, most};
    setrlimit(what, &both);
}

[[noreturn]] void work_and_leave(
    int handle, int index, const WorkerLimits& limits, const std::function<std::string(int)>& work) {
    // a group of its own, so that what it starts ends with it
    setpgid(0, 0);
    // who waits for this process tells how it ended
    for (const int signal_number : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGTERM, SIGINT, SIGXCPU}) {
        signal(signal_number, SIG_DFL);
    }
    limit(RLIMIT_CPU, static_cast<rlim_t>(limits.cpu_seconds));
    limit(RLIMIT_AS, static_cast<rlim_t>(limits.address_bytes));
    limit(RLIMIT_CORE, 0);
    try {
        write_all(handle, work(index));
        _exit(0);
    } catch (const std::bad_alloc&) { _exit(3); } catch (...) {
        _exit(2);
    }
}

Worker started(int index, const WorkerLimits& limits, const std::function<std::string(int)>& work) {
    Worker worker;
    worker.index = index;
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) { return worker; }
    worker.process = fork();
    if (worker.process == 0) {
        close(ends[0]);
        work_and_leave(ends[1], index, limits, work);
    }
    close(ends[1]);
    if (worker.process < 0) {
        close(ends[0]);
        return worker;
    }
    worker.pipe = ends[0];
    worker.end = Clock::now() + std::chrono::milliseconds(static_cast<int>(1000.0 * limits.wall_seconds));
    return worker;
}

std::string problem_of(int status) {
    if (WIFSIGNALED(status)) {
        const int signal = WTERMSIG(status);
        return signal == SIGXCPU || signal == SIGKILL
                   ? "Grading took too long and was stopped."
                   : "Grading ended with signal " + std::to_string(signal) + ".";
    }
    if (WEXITSTATUS(status) == 3) { return "Grading took too much memory and was stopped."; }
    return WEXITSTATUS(status) == 0 ? "" : "Grading failed.";
}

/// Waits for the process; the group ends with it.
WorkDone finished(Worker& worker) {
    close(worker.pipe);
    int status = 0;
    while (waitpid(worker.process, &status, 0) < 0 && errno == EINTR) {}
    kill(-worker.process, SIGKILL);
    WorkDone done{std::move(worker.result), {}};
    done.problem = problem_of(status);
    if (done.result.empty() && done.problem.empty()) { done.problem = "Grading gave no result."; }
    return done;
}

/// Reads what there is. @return false at the end
bool read_more(Worker& worker) {
    std::array<char, 65536> part{};
    const ssize_t count = read(worker.pipe, part.data(), part.size());
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) { return true; }
    if (count <= 0 || worker.result.size() > kMostResult) { return false; }
    worker.result.append(part.data(), static_cast<std::size_t>(count));
    return true;
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

}  // namespace

void do_in_processes(
    int count, int jobs, const WorkerLimits& limits, const std::function<std::string(int)>& work,
    const std::function<void(int, WorkDone)>& done) {
    std::vector<Worker> workers;
    int next = 0;
    while (next < count || !workers.empty()) {
        while (next < count && static_cast<int>(workers.size()) < std::max(1, jobs)) {
            Worker worker = started(next++, limits, work);
            if (worker.pipe < 0) {
                done(worker.index, {{}, "No process could be started."});
            } else {
                workers.push_back(std::move(worker));
            }
        }
        wait_for_some(workers);
        for (std::size_t k = 0; k < workers.size();) {
            Worker& worker = workers[k];
            const bool late = Clock::now() > worker.end;
            if (late) { kill(-worker.process, SIGKILL); }
            if (late || (has_something(worker) && !read_more(worker))) {
                const int index = worker.index;
                if (late) { worker.result.clear(); }
                WorkDone end = finished(worker);
                workers.erase(workers.begin() + static_cast<std::ptrdiff_t>(k));
                done(index, std::move(end));
            } else {
                ++k;
            }
        }
    }
}

}  // namespace jw
