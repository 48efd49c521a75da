#include "tests/app/exercises/run/run_support.hpp"

namespace jw::exercises::test {
namespace {

// twice the limits and what a busy machine adds: far from "never"
constexpr double kSoon = 15.0;

/// Peak memory of this process so far, in MB.
double peak_memory() {
    std::ifstream in("/proc/self/status");
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with("VmHWM:")) { return std::atof(line.c_str() + 6) / 1024.0; }
    }
    return 0.0;
}

}  // namespace

TEST_CASE("A program that computes for ever is stopped", "[run]") {
    if (no_sandbox_here()) { return; }
    const SandboxResult result = python("while True: pass");
    CHECK(result.timed_out);
    CHECK_FALSE(result.succeeded());
    CHECK(result.wall_seconds < kSoon);
    CHECK(result.err.empty());  // no message of a shell
}

TEST_CASE("A program that sleeps or halts itself is stopped by the clock", "[run]") {
    if (no_sandbox_here()) { return; }
    SandboxLimits limits = short_limits();
    limits.wall_seconds = 0.5;
    for (const char* source : {"import time; time.sleep(1000)", "import os; os.kill(os.getpid(), 19)"}) {
        const SandboxResult result = python(source, {}, limits);
        CHECK(result.timed_out);
        CHECK(result.wall_seconds >= 0.5);
        CHECK(result.wall_seconds < kSoon);
    }
}

TEST_CASE("A program that ignores every signal is stopped", "[run]") {
    if (no_sandbox_here()) { return; }
    const SandboxResult result = python(R"(
import signal
for s in range(1, 65):
    try: signal.signal(s, signal.SIG_IGN)
    except (OSError, ValueError): pass
signal.pthread_sigmask(signal.SIG_BLOCK, range(1, 65))
while True: pass)");
    CHECK(result.timed_out);
    CHECK(result.wall_seconds < kSoon);
}

TEST_CASE("A fork bomb has few processes and is stopped with all of them", "[run]") {
    if (no_sandbox_here()) { return; }
    const std::string mark = "fork-bomb-" + std::to_string(::getpid());
    const SandboxResult result = python(
        R"(
import os
most = 0
while True:
    try:
        os.fork()
    except OSError:
        most = max(most, sum(name.isdigit() for name in os.listdir('/proc')))
        os.write(1, b'%d\n' % most) if most else None
        os.execv('/usr/bin/python3', ['python3', '-c', 'while True: pass', ')" +
        mark + "'])");
    CHECK(result.timed_out);
    CHECK(result.wall_seconds < kSoon);
    CHECK(std::atoi(result.out.c_str()) > 1);
    CHECK(std::atoi(result.out.c_str()) <= short_limits().processes + 1);  // 1: the shell is counted, too
    CHECK(processes_with(mark) == 0);
}

TEST_CASE("Processes that vanish at once count as time of the whole", "[run]") {
    if (no_sandbox_here()) { return; }
    SandboxLimits limits = short_limits();
    limits.wall_seconds = 60.0;
    const SandboxResult result = python(
        R"(
import os
while True:
    try:
        if os.fork() == 0:
            for k in range(100000): pass
            os._exit(0)
        os.wait()
    except OSError: pass)",
        {}, limits);
    CHECK(result.timed_out);
    CHECK(result.wall_seconds < 50.0);  // stopped by CPU time, not by the clock
}

TEST_CASE("A gigabyte of output is stopped at the limit and takes no memory", "[run]") {
    if (no_sandbox_here()) { return; }
    const double before = peak_memory();
    for (const char* stream : {"1", "2"}) {
        const SandboxResult result = python(
            "import os\nfor k in range(1024): os.write(" + std::string(stream) + ", b'x' * (1 << 20))");
        CHECK(result.too_much_output);
        CHECK(result.out.size() <= short_limits().out_bytes);
        CHECK(result.err.size() <= short_limits().err_bytes);
        CHECK(result.out.size() + result.err.size() > 0);
        CHECK(result.wall_seconds < kSoon);
    }
    CHECK(peak_memory() - before < 20.0);  // MB: the limit is 1 MB
}

TEST_CASE("Memory is limited, for one process and for all together, private or shared", "[run]") {
    if (no_sandbox_here()) { return; }
    const char* one = "x = bytearray(1 << 30)";
    const char* many = R"(
import os, time
for k in range(5):
    if os.fork() == 0: break
x = bytearray(50 << 20)
for k in range(0, len(x), 4096): x[k] = 1
time.sleep(60))";
    const char* shared = R"(
import mmap
x = mmap.mmap(-1, 2 << 30)
for k in range(0, len(x), 4096): x[k] = 1)";
    for (const char* source : {one, many, shared}) {
        CAPTURE(source);
        const SandboxResult result = python(source);
        CHECK(result.out_of_memory);
        CHECK_FALSE(result.succeeded());
        CHECK(result.wall_seconds < kSoon);
    }
}

TEST_CASE("Files are limited in size and in number", "[run]") {
    if (no_sandbox_here()) { return; }
    const SandboxResult large = python(R"(
import os
size = 0
for folder in ('/tmp', '/dev/shm'):
    for k in range(1000):
        try:
            with open(folder + '/%d' % k, 'wb') as f:
                for i in range(64): size += f.write(b'x' * (1 << 20))
        except OSError: pass
        if os.statvfs(folder).f_bfree == 0: break
print(size >> 20))");
    CHECK(large.succeeded());
    CHECK(std::atoi(large.out.c_str()) > 0);
    CHECK(std::atoi(large.out.c_str()) <= 2 * 64);  // MB: two folders of tmp_bytes

    const SandboxResult many = python("import os\nfor k in range(10**9): os.mkdir('/tmp/%d' % k)");
    CHECK((many.too_many_files || many.timed_out));
    CHECK(many.wall_seconds < kSoon);
}

TEST_CASE("Open files are limited", "[run]") {
    if (no_sandbox_here()) { return; }
    const SandboxResult result = python("f = [open('/dev/null') for k in range(1000)]");
    CHECK(result.exit_status == 1);
    CHECK(result.err.find("Too many open files") != std::string::npos);
}

TEST_CASE("A program cannot raise its limits", "[run]") {
    if (no_sandbox_here()) { return; }
    const SandboxResult result = python(R"(
import resource as r
for name in ('NPROC', 'AS', 'DATA', 'CPU', 'FSIZE', 'NOFILE', 'CORE'):
    kind = getattr(r, 'RLIMIT_' + name)
    hard = r.getrlimit(kind)[1]
    assert hard != r.RLIM_INFINITY, name
    try:
        r.setrlimit(kind, (hard + 1, hard + 1))
        print(name)
    except ValueError: pass)");
    CHECK(result.succeeded());
    CHECK(result.out.empty());
}

}  // namespace jw::exercises::test
