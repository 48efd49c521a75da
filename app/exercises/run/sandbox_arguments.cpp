#include "app/exercises/run/sandbox_arguments.hpp"

#include <algorithm>
#include <initializer_list>

#include <sys/resource.h>
#include <unistd.h>

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

}  // namespace jw::exercises
