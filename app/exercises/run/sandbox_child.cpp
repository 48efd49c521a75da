#include "app/exercises/run/sandbox_parts.hpp"

#include <fcntl.h>
#include <grp.h>
#include <linux/close_range.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <initializer_list>

namespace jw::exercises {

namespace {

/// The first process of the sandbox. All others die with it. The limit on processes is set here: outside, it
/// would count all other processes of the user. Messages of the shell ("Killed") do not belong to the
/// program.
constexpr const char* kFirstProcess = R"(ulimit -p "$1" || exit 125
shift
printf s >&3
exec 3>&- 4>&2 2>/dev/null
(exec "$@" 2>&4 4>&-)
exit $?)";

class ArgumentList {
public:
    explicit ArgumentList(std::string program) : all_{std::move(program)} {}
    void add(std::initializer_list<std::string> words) { all_.insert(all_.end(), words); }
    void add(const std::vector<std::string>& words) { all_.insert(all_.end(), words.begin(), words.end()); }
    std::vector<std::string> take() { return std::move(all_); }

private:
    std::vector<std::string> all_;
};

void isolate(ArgumentList& list) {
    list.add({"--unshare-all", "--unshare-user", "--disable-userns", "--die-with-parent", "--new-session"});
    list.add(
        {"--as-pid-1", "--cap-drop", "ALL", "--uid", "65534", "--gid", "65534", "--hostname", "sandbox"});
    list.add({"--clearenv"});
    const std::vector<std::vector<std::string>> environment{
        {"PATH", "/usr/bin:/bin"},
        {"HOME", "/tmp"},
        {"TMPDIR", "/tmp"},
        {"LANG", "C.UTF-8"},
        // one thread each: more threads are not faster if several programs run at once, and each takes
        // address space
        {"OMP_NUM_THREADS", "1"},
        {"OPENBLAS_NUM_THREADS", "1"}};
    for (const auto& variable : environment) { list.add({"--setenv", variable[0], variable[1]}); }
    list.add({"--seccomp", std::to_string(kFilterFd), "--info-fd", std::to_string(kInfoFd)});
}

void show_system(ArgumentList& list) {
    list.add({"--ro-bind", "/usr", "/usr"});
    // what was installed by hand differs between machines, and is not for students
    if (::access("/usr/local", F_OK) == 0) {
        list.add({"--tmpfs", "/usr/local", "--remount-ro", "/usr/local"});
    }
    for (const char* folder : {"bin", "sbin", "lib", "lib32", "lib64"}) {
        const std::string name = folder;
        if (::access(("/usr/" + name).c_str(), F_OK) == 0) {
            list.add({"--symlink", "usr/" + name, "/" + name});
        }
    }
    for (const char* path : {"/etc/alternatives", "/etc/ld.so.cache"}) {
        list.add({"--ro-bind-try", path, path});
    }
    list.add({"--proc", "/proc", "--dev", "/dev"});
}

void show_files(ArgumentList& list, const SandboxJob& job) {
    list.add({"--perms", "0755", "--dir", kSandboxFolder});
    int fd = kFirstFileFd;
    for (const SandboxFile& file : job.files) {
        list.add({"--perms", file.executable ? "0555" : "0444", "--file", std::to_string(fd++)});
        list.add({std::string(kSandboxFolder) + '/' + file.name});
    }
    // every writable file system takes memory: so there are only two, of known size
    const std::string size = std::to_string(job.limits.tmp_bytes);
    list.add({"--size", size, "--perms", "1777", "--tmpfs", "/tmp"});
    list.add({"--size", size, "--perms", "1777", "--tmpfs", "/dev/shm"});
    list.add({"--remount-ro", "/dev", "--remount-ro", "/", "--chdir", "/tmp"});
}

/// The limit that the shell may set: not more than this process is allowed.
std::string allowed_processes(int wanted) {
    rlimit now{};
    ::getrlimit(RLIMIT_NPROC, &now);
    return std::to_string(std::min<rlim_t>(now.rlim_max, static_cast<rlim_t>(wanted) + 1));  // 1: the shell
}

struct ResourceLimit {
    __rlimit_resource which;
    rlimit value;
};

/// A limit, but not above what this process is allowed.
ResourceLimit at_most(__rlimit_resource which, std::uint64_t soft, std::uint64_t hard) {
    rlimit now{};
    ::getrlimit(which, &now);
    return {which, {std::min<rlim_t>(soft, now.rlim_max), std::min<rlim_t>(hard, now.rlim_max)}};
}

std::vector<ResourceLimit> resource_limits(const SandboxLimits& limits) {
    const auto same = [](__rlimit_resource which, std::uint64_t value) {
        return at_most(which, value, value);
    };
    const auto cpu = static_cast<std::uint64_t>(std::ceil(std::max(limits.cpu_seconds, 1.0)));
    return {
        at_most(RLIMIT_CPU, cpu, cpu + 1), same(RLIMIT_DATA, limits.memory_bytes),
        same(RLIMIT_AS, limits.address_bytes), same(RLIMIT_STACK, 8U << 20U),
        same(RLIMIT_FSIZE, limits.file_bytes),
        same(RLIMIT_NOFILE, static_cast<std::uint64_t>(limits.open_files)),
        // with 0, a program that collects core dumps would still be called; with 1 it is not
        same(RLIMIT_CORE, 1), same(RLIMIT_MEMLOCK, 64U << 10U), same(RLIMIT_MSGQUEUE, 0),
        same(RLIMIT_SIGPENDING, 256), same(RLIMIT_RTPRIO, 0), same(RLIMIT_NICE, 0)};
}

// The functions from here on run in the child. It shares locks with threads that do not exist there: no
// memory is allocated, and system calls are made directly where the library would call other threads.

[[noreturn]] void give_up(const char* words) {
    static_cast<void>(!::write(STDERR_FILENO, words, std::strlen(words)));
    ::_exit(125);
}

/// Moves descriptors to 0, 1, 2 ... and closes all others: files that this process has open are not for
/// students.
void arrange(int* fds, int count) {
    // out of the way of their new numbers
    for (int k = 0; k < count; ++k) { fds[k] = ::fcntl(fds[k], F_DUPFD, count); }
    for (int k = 0; k < count; ++k) { ::dup2(fds[k], k); }
    if (::syscall(SYS_close_range, static_cast<unsigned>(count), ~0U, 0U) != 0) {
        give_up("open files cannot be closed\n");
    }
}

void default_signals() {
    struct sigaction standard {};
    standard.sa_handler = SIG_DFL;
    for (int signal = 1; signal < NSIG; ++signal) { ::sigaction(signal, &standard, nullptr); }
    sigset_t none;
    ::sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

bool become(unsigned user) {
    return ::syscall(SYS_setresgid, user, user, user) == 0 && ::syscall(SYS_setresuid, user, user, user) == 0;
}

/// The kernel does not limit root's processes, and the program could use root's files. Every run gets its own
/// user, so that runs do not count each other's processes; some containers have only the user nobody.
void leave_root() {
    if (::geteuid() != 0) { return; }
    constexpr unsigned kUnusedUsers = 0x70000000;  // above those that systemd and containers assign
    constexpr unsigned kNobody = 65534;
    const bool is_alone = ::syscall(SYS_setgroups, 0, nullptr) == 0;
    if (!is_alone || (!become(kUnusedUsers + static_cast<unsigned>(::getpid())) && !become(kNobody))) {
        give_up(
            "root cannot become another user here, as in a container without CAP_SETUID and CAP_SETGID\n");
    }
}

[[noreturn]] void become_sandbox(
    char* const* arguments, int* fds, int count, const std::vector<ResourceLimit>& limits, int parent) {
    arrange(fds, count);
    default_signals();
    ::setsid();  // keys that end the caller must not reach its child, which dies with it anyway
    for (const ResourceLimit& limit : limits) {
        if (::setrlimit(limit.which, &limit.value) != 0) { give_up("limits cannot be set\n"); }
    }
    leave_root();
    // after the change of user, which would reset it
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) { ::_exit(125); }
    std::array<char*, 1> environment{nullptr};
    ::execve(arguments[0], arguments, environment.data());
    give_up("bwrap is missing or cannot be executed\n");
}

}  // namespace

std::vector<std::string> bwrap_arguments(const SandboxJob& job) {
    ArgumentList list(job.bwrap);
    isolate(list);
    show_system(list);
    show_files(list, job);
    list.add({"--", "/bin/sh", "-c", kFirstProcess, "sh", allowed_processes(job.limits.processes)});
    list.add(job.command);
    return list.take();
}

int start_child(
    const std::vector<std::string>& arguments, const std::vector<int>& fds, const SandboxLimits& limits) {
    std::vector<char*> pointers;
    pointers.reserve(arguments.size() + 1);
    for (const std::string& argument : arguments) { pointers.push_back(const_cast<char*>(argument.c_str())); }
    pointers.push_back(nullptr);
    std::vector<int> own_fds = fds;
    const std::vector<ResourceLimit> own_limits = resource_limits(limits);
    const int parent = ::getpid();

    // signal handlers of this program must not run in the child
    sigset_t all;
    sigset_t before;
    ::sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before);
    const int child = ::fork();
    if (child == 0) {
        become_sandbox(pointers.data(), own_fds.data(), static_cast<int>(own_fds.size()), own_limits, parent);
    }
    const int error = errno;
    ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
    errno = error;
    return child;
}

}  // namespace jw::exercises
