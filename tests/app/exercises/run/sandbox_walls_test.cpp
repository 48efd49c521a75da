#include "tests/app/exercises/run/run_support.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>

namespace jw::exercises::test {
namespace {

/// A socket of this machine that waits for connections to 127.0.0.1.
struct Listener {
    int fd = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    int port = 0;

    Listener() {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        auto* const any = reinterpret_cast<sockaddr*>(&address);
        if (::bind(fd, any, size) == 0 && ::listen(fd, 5) == 0 && ::getsockname(fd, any, &size) == 0) {
            port = ntohs(address.sin_port);
        }
    }
    Listener(const Listener&) = delete;
    Listener& operator=(const Listener&) = delete;
    ~Listener() { ::close(fd); }

    bool was_reached() const {
        pollfd waiting{fd, POLLIN, 0};
        return ::poll(&waiting, 1, 0) > 0;
    }
};

/// Python program that tries each expression and prints those that succeed.
std::string tries(const std::vector<std::string>& expressions) {
    std::string source = "import os, socket, ctypes, shutil\nlibc = ctypes.CDLL(None)\n";
    for (const std::string& expression : expressions) {
        source += "try: print(" + expression + ", '''" + expression + "''')\nexcept Exception: pass\n";
    }
    return source + "print('end')\n";
}

}  // namespace

TEST_CASE("A program reads no file of this machine but those of the system", "[run]") {
    if (no_sandbox_here()) { return; }
    const Scratch folder;
    std::filesystem::create_directory(folder / "bob");
    const std::string other = folder.file("bob/task.py", "answer = 42");
    const std::string own = folder.file("task.py", "");
    std::vector<std::string> tried;
    for (const std::string& path :
         {std::string("/etc/shadow"), std::string("/etc/passwd"), other, own, "/proc/1/root" + other,
          "/proc/self/cwd/../.." + other}) {
        tried.push_back("open('" + path + "').read(1)");
    }
    for (const std::string top : {"root", "home", "var", "sys", "mnt", "opt", "run", "usr/local/bin"}) {
        tried.push_back("os.listdir('/" + top + "')" + (top == "usr/local/bin" ? "[0]" : ""));
    }
    const SandboxResult result = python(tries(tried));
    CHECK(result.succeeded());
    CHECK(result.out == "end\n");
}

TEST_CASE("A program changes no file outside of its temporary folders", "[run]") {
    if (no_sandbox_here()) { return; }
    std::vector<std::string> tried;
    for (const char* folder : {"", "/usr", "/usr/bin", "/usr/local", "/etc", "/dev", "/submission"}) {
        tried.push_back("open('" + std::string(folder) + "/new', 'w')");
        tried.push_back("os.mkdir('" + std::string(folder) + "/new')");
    }
    tried.insert(
        tried.end(), {"open('/submission/task.py', 'a')", "os.remove('/submission/task.py')",
                      "os.chmod('/submission/task.py', 0o777)", "os.remove('/usr/bin/python3')",
                      "os.rename('/submission', '/tmp/mine')", "open('/proc/sys/kernel/hostname', 'w')"});
    const SandboxResult result = python(tries(tried));
    CHECK(result.succeeded());
    CHECK(result.out == "end\n");
    const SandboxResult removed = python(R"(
import shutil
for folder in ('/submission', '/etc', '/usr/bin', '/dev'): shutil.rmtree(folder, ignore_errors=True)
print('end'))");
    CHECK(removed.out == "end\n");
    CHECK(::access("/usr/bin/python3", X_OK) == 0);
}

TEST_CASE("What a program leaves behind is not there in its next run", "[run]") {
    if (no_sandbox_here()) { return; }
    const std::string source =
        "import os; print(os.listdir('/tmp'), os.listdir('/dev/shm'))\n"
        "open('/tmp/a', 'w').write('x'); open('/dev/shm/a', 'w').write('x')";
    CHECK(python(source).out == "[] []\n");
    CHECK(python(source).out == "[] []\n");
}

TEST_CASE("A program reaches no network", "[run]") {
    if (no_sandbox_here()) { return; }
    const Listener listener;
    REQUIRE(listener.port > 0);
    const std::string port = std::to_string(listener.port);
    const SandboxResult result = python(tries(
        {"socket.create_connection(('127.0.0.1', " + port + "), 1)",
         "socket.create_connection(('192.0.2.1', 80), 1)", "socket.socket(socket.AF_INET, socket.SOCK_DGRAM)",
         "socket.socket(socket.AF_INET6)", "socket.socket(socket.AF_NETLINK, socket.SOCK_RAW)",
         "socket.socket(socket.AF_VSOCK)", "socket.socket(socket.AF_ALG)",
         "socket.getaddrinfo('debian.org', 80)"}));
    CHECK(result.succeeded());
    CHECK(result.out == "end\n");
    CHECK_FALSE(listener.was_reached());
}

TEST_CASE("A program sees nothing of our environment and of our open files", "[run]") {
    if (no_sandbox_here()) { return; }
    const Scratch folder;
    const std::string file = folder.file("secret", "kept to ourselves");
    ::setenv("JW_TEST_SECRET", "kept to ourselves", 1);
    const int open = ::open(file.c_str(), O_RDONLY);  // without O_CLOEXEC
    const SandboxResult result = python(R"(
import os
print(sorted(os.environ), open('/proc/1/environ').read(), open('/proc/1/cmdline').read())
for fd in range(3, 64):
    try: print(fd, os.pread(fd, 100, 0))
    except OSError: pass
for fd in os.listdir('/proc/1/fd'): print(fd, os.readlink('/proc/1/fd/' + fd))
print(open('/proc/self/mountinfo').read()))");
    ::close(open);
    ::unsetenv("JW_TEST_SECRET");
    CHECK(result.succeeded());
    CHECK(result.out.find("HOME") != std::string::npos);
    CHECK(result.out.find("kept") == std::string::npos);
    CHECK(result.out.find("SECRET") == std::string::npos);
    CHECK(result.out.find(folder.path()) == std::string::npos);
}

TEST_CASE("A program runs without privileges and cannot gain any", "[run]") {
    if (no_sandbox_here()) { return; }
    const SandboxResult result = python(tries(
        {"os.setuid(0)", "os.setgid(0)", "os.setgroups([0])", "os.chroot('/tmp')", "os.nice(-5)",
         "1 // (1 + libc.unshare(0x10000000))", "1 // (1 + libc.mount(b'x', b'/tmp', b'tmpfs', 0, None))",
         "1 // (1 + libc.ptrace(16, 1, 0, 0))", "1 // (1 + libc.memfd_create(b'x', 0))",
         "1 // (1 + libc.shmget(0, 4096, 0o1000))", "open('/dev/tty')",
         "1 // os.getuid() + 1 // os.getgid() + 1"}));
    CHECK(result.succeeded());
    CHECK(result.out.starts_with("1 1 // os.getuid()"));
    CHECK(result.out.ends_with("\nend\n"));
    CHECK(std::ranges::count(result.out, '\n') == 2);
}

TEST_CASE("Signals of a program reach nobody but its own processes", "[run]") {
    if (no_sandbox_here()) { return; }
    const SandboxResult group = python("import os; os.killpg(0, 9)");
    CHECK(group.signal == SIGKILL);
    CHECK_FALSE(group.timed_out);
    const std::string ours = std::to_string(::getpid());
    const SandboxResult others = python(tries({"os.kill(-1, 9)", "os.kill(" + ours + ", 9)"}));
    CHECK(others.out == "end\n");
    // the first process of the sandbox: if it ended, all others would end, too
    const SandboxResult first = python("import os\nfor s in (1, 9, 15, 19): os.kill(1, s)\nprint('end')");
    CHECK(first.out == "end\n");
    CHECK(first.succeeded());
}

TEST_CASE("A process in the background does not survive its program", "[run]") {
    if (no_sandbox_here()) { return; }
    const std::string mark = "left-behind-" + std::to_string(::getpid());
    const SandboxResult result = python(
        R"(
import os
if os.fork() == 0:
    os.setsid()
    if os.fork() == 0:
        for fd in range(3): os.close(fd)
        os.execv('/usr/bin/python3', ['python3', '-c', 'import time; time.sleep(1000)', ')" +
        mark + R"('])
    os._exit(0)
os.wait()
import time; time.sleep(0.2)
print('end'))");
    CHECK(result.succeeded());
    CHECK(result.out == "end\n");
    CHECK(result.wall_seconds < 5.0);
    CHECK(processes_with(mark) == 0);
}

TEST_CASE("A program dies with the process that runs it", "[run]") {
    if (no_sandbox_here()) { return; }
    const std::string mark = "orphan-" + std::to_string(::getpid());
    const pid_t worker = ::fork();
    if (worker == 0) {
        SandboxLimits limits;
        limits.wall_seconds = 60.0;
        python(
            "import os; os.execv('/usr/bin/python3', ['python3', '-c', 'import time; time.sleep(60)', '" +
                mark + "'])",
            {}, limits);
        ::_exit(0);
    }
    // the mark stands in the text of the program, too, but not in a command line
    const auto becomes = [&mark](bool running) {
        for (int k = 0; k < 200 && (processes_with(mark) > 0) != running; ++k) { ::usleep(50'000); }
        return (processes_with(mark) > 0) == running;
    };
    CHECK(becomes(true));
    ::kill(worker, SIGKILL);
    CHECK(::waitpid(worker, nullptr, 0) == worker);
    CHECK(becomes(false));
}

}  // namespace jw::exercises::test
