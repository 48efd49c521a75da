#include "app/exercises/run/sandbox.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "app/exercises/run/handles.hpp"
#include "app/exercises/run/safe_text.hpp"
#include "app/exercises/run/sandbox_parts.hpp"

namespace jw::exercises {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kLookEvery = 0.025;  // s: a program touches about 100 MB in this time
constexpr double kBlindSeconds = 1.0;
constexpr double kDieSeconds = 5.0;

double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Output of one stream so far, up to a limit.
struct Stream {
    Pipe pipe;
    std::string text;
    std::size_t limit = 0;

    /// Takes the available output, without waiting. @return false if there is more than the limit
    bool take() {
        std::array<char, 1U << 16U> buffer;
        while (pipe.read) {
            const ssize_t count = ::read(pipe.read.fd(), buffer.data(), buffer.size());
            if (count < 0 && errno == EINTR) { continue; }
            if (count < 0 && errno == EAGAIN) { return true; }
            if (count <= 0) {
                pipe.read.close();
                return true;
            }
            const std::size_t room = limit - text.size();
            text.append(buffer.data(), std::min(room, static_cast<std::size_t>(count)));
            if (static_cast<std::size_t>(count) > room) { return false; }
        }
        return true;
    }
};

/// One run from its start to its end.
class SandboxRun {
public:
    explicit SandboxRun(const SandboxJob& job) : job_(job) {
        out_.limit = job.limits.out_bytes;
        err_.limit = job.limits.err_bytes;
        started_.limit = 1;
        info_.limit = 4096;
    }

    SandboxResult carry_out() {
        if (!start()) { return std::move(result_); }
        while (!stop_ && !has_ended()) {
            wait_for_something();
            take_output();
            check_limits();
        }
        finish();
        return std::move(result_);
    }

private:
    bool start();
    bool has_ended() const;
    void wait_for_something();
    void take_output();
    void on_start();
    void check_limits();
    void measure();
    void finish();
    void wait_for_end_of(const Handle& process) const;
    void kill_unfinished();
    void reap();
    void judge(int status);
    void cannot(std::string reason) {
        if (result_.could_not_run.empty()) { result_.could_not_run = std::move(reason); }
        stop_ = true;
    }

    const SandboxJob& job_;
    SandboxResult result_;
    Stream out_, err_, started_, info_;
    int child_ = -1;         // bwrap
    Handle bwrap_;           // becomes readable when bwrap ends
    Handle first_;           // the first process in the sandbox: all others die with it
    int first_process_ = 0;  // its number on this machine
    UsageMeter meter_;
    bool runs_ = false;  // the program itself runs
    bool stop_ = false;
    Clock::time_point begin_ = Clock::now();
    Clock::time_point looked_ = begin_;
};

bool SandboxRun::start() {
    const std::string filter = system_call_filter();
    if (filter.empty()) { return cannot("the sandbox is not written for this kind of processor"), false; }
    std::vector<Handle> contents;
    contents.push_back(memory_file(job_.input));
    contents.push_back(memory_file(filter));
    for (const SandboxFile& file : job_.files) { contents.push_back(memory_file(file.content)); }
    bool complete =
        std::ranges::all_of(contents, [](const Handle& handle) { return static_cast<bool>(handle); });
    for (Stream* stream : {&out_, &err_, &started_, &info_}) {
        stream->pipe = open_pipe();
        complete = complete && stream->pipe.write;
    }
    if (!complete) { return cannot("the system has no more files or memory to give"), false; }

    std::vector<int> fds{contents[0].fd(),         out_.pipe.write.fd(),  err_.pipe.write.fd(),
                         started_.pipe.write.fd(), info_.pipe.write.fd(), contents[1].fd()};
    for (std::size_t k = 2; k < contents.size(); ++k) { fds.push_back(contents[k].fd()); }
    child_ = start_child(bwrap_arguments(job_), fds, job_.limits);
    if (child_ < 0) {
        return cannot(std::string("no process can be started: ") + std::strerror(errno)), false;
    }
    for (Stream* stream : {&out_, &err_, &started_, &info_}) { stream->pipe.write.close(); }
    bwrap_ = process_handle(child_);
    if (!bwrap_) { cannot("process handles need Linux 5.3 or later"); }
    return true;
}

bool SandboxRun::has_ended() const {
    pollfd ended{bwrap_.fd(), POLLIN, 0};
    return ::poll(&ended, 1, 0) > 0;
}

void SandboxRun::wait_for_something() {
    std::array<pollfd, 4> sources{
        {{bwrap_.fd(), POLLIN, 0},
         {out_.pipe.read.fd(), POLLIN, 0},  // a closed one is -1, which poll ignores
         {err_.pipe.read.fd(), POLLIN, 0},
         {started_.pipe.read.fd(), POLLIN, 0}}};
    ::poll(sources.data(), sources.size(), static_cast<int>(1000.0 * kLookEvery));
}

void SandboxRun::take_output() {
    started_.take();
    if (!runs_ && !started_.text.empty()) { on_start(); }
    if (!out_.take() || !err_.take()) {
        result_.too_much_output = true;
        stop_ = true;
    }
}

void SandboxRun::on_start() {
    runs_ = true;
    begin_ = Clock::now();
    info_.take();
    constexpr std::string_view key = "\"child-pid\":";
    const std::size_t at = info_.text.find(key);
    first_process_ = at == std::string::npos ? 0 : std::atoi(info_.text.c_str() + at + key.size());
    if (first_process_ > 0) { first_ = process_handle(first_process_); }
    meter_.open(first_process_);
}

void SandboxRun::check_limits() {
    if (job_.stop.stop_requested()) { return cannot("it was given up"); }
    if (!runs_) {
        if (since(begin_) > kLongestSetUp) { cannot("the sandbox was not set up within 20 s"); }
        return;
    }
    if (since(begin_) > job_.limits.wall_seconds) { result_.timed_out = stop_ = true; }
    if (since(looked_) > kLookEvery) { measure(); }
}

void SandboxRun::measure() {
    looked_ = Clock::now();
    // a program that has just ended cannot be inspected, either, and bwrap will end in a moment
    if (!meter_.is_open() && !meter_.open(first_process_)) {
        if (since(begin_) > kBlindSeconds) { cannot("the sandbox cannot be inspected"); }
        return;
    }
    const SandboxUsage usage = meter_.measure();
    result_.cpu_seconds = std::max(result_.cpu_seconds, usage.cpu_seconds);
    if (usage.cpu_seconds > job_.limits.cpu_seconds) { result_.timed_out = stop_ = true; }
    if (usage.memory_bytes > job_.limits.memory_bytes) { result_.out_of_memory = stop_ = true; }
    if (usage.files > job_.limits.tmp_files) { result_.too_many_files = stop_ = true; }
}

void SandboxRun::finish() {
    if (runs_) { result_.wall_seconds = since(begin_); }
    if (stop_ && first_) {
        // the first process, not bwrap: bwrap reports the time of all processes, and ends when none is left
        kill_process(first_);
        wait_for_end_of(bwrap_);
    } else if (stop_) {
        kill_unfinished();
    }
    // then its child dies, too; until bwrap is reaped, no other process can have its number
    if (stop_) { ::kill(child_, SIGKILL); }
    reap();
    result_.out = std::move(out_.text);
    result_.err = std::move(err_.text);
}

void SandboxRun::wait_for_end_of(const Handle& process) const {
    pollfd ended{process.fd(), POLLIN, 0};
    const Clock::time_point begin = Clock::now();
    while (::poll(&ended, 1, 100) <= 0 && since(begin) < kDieSeconds) {}
}

/// Ends a sandbox that is not set up yet. If bwrap is killed before its first process has asked the kernel to
/// die with it, that process survives. A halted bwrap starts no process, and its children keep their numbers.
void SandboxRun::kill_unfinished() {
    if (::kill(child_, SIGSTOP) != 0) { return; }
    siginfo_t halted{};
    while (::waitid(P_PID, static_cast<id_t>(child_), &halted, WSTOPPED | WEXITED | WNOWAIT) < 0 &&
           errno == EINTR) {}
    for (const int process : children_of(child_)) {
        const Handle handle = process_handle(process);
        kill_process(handle);
        if (handle) { wait_for_end_of(handle); }
    }
}

void SandboxRun::reap() {
    int status = 0;
    rusage usage{};
    int reaped = -1;
    do { reaped = ::wait4(child_, &status, 0, &usage); } while (reaped < 0 && errno == EINTR);
    // what was written before the end; now nobody can write more
    if (!stop_) { take_output(); }
    if (!runs_) {
        const std::string words = first_lines(printable(err_.text), 1, 300);
        return cannot(words.empty() ? "bwrap ended without starting the program" : words);
    }
    if (reaped != child_) { return cannot("another process took the exit status of the program"); }
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    result_.cpu_seconds = std::max(result_.cpu_seconds, seconds(usage.ru_utime) + seconds(usage.ru_stime));
    judge(status);
}

void SandboxRun::judge(int status) {
    result_.exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    if (stop_) { result_.exit_status = 128 + SIGKILL; }
    if (result_.exit_status > 128 && result_.exit_status < 128 + NSIG) {
        result_.signal = result_.exit_status - 128;
    }
    if (stop_ || result_.exit_status == 0) { return; }
    // the kernel itself stops a single process that uses up its time
    const bool used_up = result_.cpu_seconds >= job_.limits.cpu_seconds;
    result_.timed_out = result_.signal == SIGXCPU || (used_up && result_.signal == SIGKILL);
    for (const char* words : {"MemoryError", "bad_alloc", "out of memory", "heap out of memory"}) {
        if (err_.text.find(words) != std::string::npos) { result_.out_of_memory = true; }
    }
}

}  // namespace

bool SandboxResult::succeeded() const {
    return could_not_run.empty() && exit_status == 0 && !timed_out && !too_much_output && !too_many_files &&
           !out_of_memory;
}

SandboxResult run_in_sandbox(const SandboxJob& job) { return SandboxRun(job).carry_out(); }

SandboxAvailability try_sandbox(const std::string& bwrap) {
    if (::access(bwrap.c_str(), X_OK) != 0) {
        return {false, "programs are not run: there is no " + bwrap + " (Debian package bubblewrap)"};
    }
    SandboxJob job;
    job.command = {"/usr/bin/true"};
    job.bwrap = bwrap;
    const SandboxResult result = run_in_sandbox(job);
    if (result.succeeded()) { return {true, {}}; }
    const std::string why =
        result.could_not_run.empty() ? "even one that does nothing fails" : result.could_not_run;
    return {false, "programs are not run: no sandbox can be made here: " + why};
}

const SandboxAvailability& sandbox_availability() {
    static const SandboxAvailability tried = try_sandbox(kBwrap);
    return tried;
}

}  // namespace jw::exercises
