#include "tests/app/exercises/run/run_support.hpp"

#include <chrono>
#include <thread>

#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>

namespace jw::exercises::test {

TEST_CASE("Input, output, errors and status of a program arrive as they are", "[run]") {
    if (no_sandbox_here()) { return; }
    const SandboxResult result = python(
        "import sys\nsys.stdout.write(sys.stdin.read()[::-1])\nsys.stderr.write('no')\nsys.exit(7)", "abc");
    CHECK(result.could_not_run.empty());
    CHECK(result.out == "cba");
    CHECK(result.err == "no");
    CHECK(result.exit_status == 7);
    CHECK(result.signal == 0);
    CHECK_FALSE(result.succeeded());
}

TEST_CASE("A program that is ended by a signal is told from one that ends", "[run]") {
    if (no_sandbox_here()) { return; }
    CHECK(python("import os; os.abort()").signal == SIGABRT);
    CHECK(python("import os; os.kill(os.getpid(), 11)").signal == SIGSEGV);
    CHECK(python("import os; os._exit(3)").signal == 0);
}

TEST_CASE("Output may be any bytes", "[run]") {
    if (no_sandbox_here()) { return; }
    std::string all;
    for (int k = 0; k < 256; ++k) { all += static_cast<char>(k); }
    CHECK(python("import os; os.write(1, bytes(range(256)))").out == all);
    CHECK(python("import sys; sys.stdout.buffer.write(sys.stdin.buffer.read())", all).out == all);
}

TEST_CASE("Nobody waits for a program that does not read, and it does not wait for us", "[run]") {
    if (no_sandbox_here()) { return; }
    const std::string ten_megabytes(10U << 20U, ' ');
    CHECK(python("print('end')", ten_megabytes).out == "end\n");
    CHECK(python("import os; os.close(0); print('end')", ten_megabytes).out == "end\n");
    CHECK(python("import sys; print(len(sys.stdin.read()))", ten_megabytes).out == "10485760\n");
    CHECK(python("import sys; print(len(sys.stdin.read()))").out == "0\n");
}

TEST_CASE("A program may close its output and goes on until it ends", "[run]") {
    if (no_sandbox_here()) { return; }
    const SandboxResult result =
        python("import os, time\nos.write(1, b'x')\nos.close(1); os.close(2); time.sleep(0.3); os._exit(5)");
    CHECK(result.out == "x");
    CHECK(result.exit_status == 5);
    CHECK(result.wall_seconds >= 0.3);
}

TEST_CASE("A program may open its output again, and cannot change its input", "[run]") {
    if (no_sandbox_here()) { return; }
    const SandboxResult result = python(
        R"(
with open('/dev/stdout', 'w') as f: f.write('again\n')
with open('/dev/stdin') as f: print(f.read())
import os
try: os.write(0, b'x'); print('written')
except OSError: pass)",
        "given");
    CHECK(result.out == "again\ngiven\n");
}

TEST_CASE("Output that nobody has read yet is not lost at the end", "[run]") {
    if (no_sandbox_here()) { return; }
    for (int k = 0; k < 10; ++k) {
        const SandboxResult result =
            python("import os; os.write(1, b'x' * 60000); os.write(2, b'y' * 60000)");
        CHECK(result.out.size() == 60000);
        CHECK(result.err.size() == 60000);
    }
}

TEST_CASE("Runs at the same time, in threads and in processes, do not disturb each other", "[run]") {
    if (no_sandbox_here()) { return; }
    const auto ask = [](const std::string& number) {
        // together they have more processes than one run may have
        SandboxLimits limits;
        limits.wall_seconds = 30.0;
        const SandboxResult result = silent_python(
            R"(
import os, sys, time
for k in range(20):
    if os.fork() == 0: time.sleep(0.3); os._exit(0)
for k in range(20): os.wait()
print(sys.stdin.read()))",
            number, limits);
        return result.succeeded() && result.out == number + "\n";
    };
    std::vector<pid_t> workers;
    for (int k = 0; k < 3; ++k) {
        workers.push_back(::fork());
        if (workers.back() == 0) { ::_exit(ask("worker " + std::to_string(k)) ? 0 : 1); }
    }
    std::array<bool, 3> right{};
    {
        std::vector<std::jthread> threads;
        for (std::size_t k = 0; k < right.size(); ++k) {
            threads.emplace_back([&right, &ask, k] { right[k] = ask("thread " + std::to_string(k)); });
        }
    }
    CHECK(right == std::array{true, true, true});
    for (const pid_t worker : workers) {
        int status = -1;
        CHECK(::waitpid(worker, &status, 0) == worker);
        CHECK(status == 0);
    }
}

TEST_CASE("Signals that interrupt a run do not end it", "[run]") {
    if (no_sandbox_here()) { return; }
    struct sigaction counting {};
    counting.sa_handler = [](int) {};
    struct sigaction before {};
    ::sigaction(SIGUSR1, &counting, &before);
    const pthread_t self = ::pthread_self();
    std::jthread disturbing([self](const std::stop_token& stop) {
        while (!stop.stop_requested()) {
            ::pthread_kill(self, SIGUSR1);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    });
    const SandboxResult result = python("import time; time.sleep(0.3); print('end')");
    disturbing.request_stop();
    disturbing.join();
    ::sigaction(SIGUSR1, &before, nullptr);
    CHECK(result.succeeded());
    CHECK(result.out == "end\n");
}

TEST_CASE("A run leaves no open file and no child behind", "[run]") {
    if (no_sandbox_here()) { return; }
    const auto open_files = [] {
        const std::filesystem::directory_iterator all("/proc/self/fd");
        return std::distance(begin(all), end(all));
    };
    python("pass");
    const auto before = open_files();
    for (const char* source : {"pass", "while True: pass", "while True: print('x' * 1000)"}) {
        python(source);
    }
    CHECK(open_files() == before);
    CHECK(::waitpid(-1, nullptr, WNOHANG) == -1);
}

TEST_CASE("Without a sandbox no program is run, and the reason is printed", "[run]") {
    const Scratch folder;
    const SandboxAvailability missing = try_sandbox(folder / "bwrap");
    CHECK_FALSE(missing.available);
    CHECK(missing.reason.find("bubblewrap") != std::string::npos);

    // what bubblewrap says in a container that forbids namespaces
    const std::string forbidden =
        folder.file("forbidden", "#!/bin/sh\necho 'bwrap: No permissions' >&2\nexit 1\n");
    ::chmod(forbidden.c_str(), 0755);
    ::chmod(folder.path().c_str(), 0755);  // root asks as another user
    const SandboxAvailability refused = try_sandbox(forbidden);
    CHECK_FALSE(refused.available);
    CHECK_FALSE(refused.reason.empty());

    if (no_sandbox_here()) { return; }  // and perhaps not even a user that could try it
    CHECK(refused.reason.find("bwrap: No permissions") != std::string::npos);
    SandboxJob job;
    job.command = {"/usr/bin/true"};
    job.bwrap = forbidden;
    CHECK(run_in_sandbox(job).could_not_run == "bwrap: No permissions");
    CHECK_FALSE(run_in_sandbox(job).succeeded());
}

}  // namespace jw::exercises::test
