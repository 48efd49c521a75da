#include "app/exercises/run/sandbox_parts.hpp"

#include <array>
#include <cctype>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

#include <dirent.h>
#include <fcntl.h>
#include <sys/statvfs.h>
#include <unistd.h>

namespace jw::exercises {
namespace {

/// The beginning of a small file of /proc; empty if the process has gone.
std::string text_in(int folder, const std::string& path) {
    const Handle file(::openat(folder, path.c_str(), O_RDONLY | O_CLOEXEC));
    std::array<char, 4096> buffer{};
    const ssize_t count = file ? ::read(file.fd(), buffer.data(), buffer.size()) : 0;
    return {buffer.data(), count > 0 ? static_cast<std::size_t>(count) : 0};
}

/// The number after `name`, converted from kB to bytes; 0 if there is none.
std::uint64_t bytes_after(const std::string& text, std::string_view name) {
    const std::size_t at = text.find(name);
    return at == std::string::npos ? 0 : std::strtoull(text.c_str() + at + name.size(), nullptr, 10) << 10U;
}

std::uint64_t memory_of(const std::string& status) {
    return bytes_after(status, "\nRssAnon:") + bytes_after(status, "\nRssShmem:") +
           bytes_after(status, "\nVmPTE:");
}

/// /proc/PID/stat from one of its fields on, counted from 1 as in proc(5); null if the process has gone.
const char* field_of(const std::string& stat, int wanted) {
    // the second field, the name of the program, may contain spaces and brackets
    std::size_t at = stat.rfind(')');
    for (int field = 2; field < wanted && at != std::string::npos; ++field) { at = stat.find(' ', at + 1); }
    return at == std::string::npos ? nullptr : stat.c_str() + at;
}

/// Fields 14 to 17: user and kernel time of the process and of its children.
double cpu_of(const std::string& stat) {
    static const auto ticks = static_cast<double>(::sysconf(_SC_CLK_TCK));
    const char* text = field_of(stat, 14);
    if (text == nullptr) { return 0.0; }
    double sum = 0.0;
    for (int k = 0; k < 4; ++k) {
        char* end = nullptr;
        sum += static_cast<double>(std::strtoull(text, &end, 10));
        text = end;
    }
    return sum / ticks;
}

std::uint64_t files_in(const Handle& folder) {
    struct statvfs all {};
    if (!folder || ::fstatvfs(folder.fd(), &all) != 0) { return 0; }
    return all.f_files - all.f_ffree;
}

/// Calls `visit` with the folder name of each process in a /proc.
template <class Visit>
void for_each_process(const Handle& proc, Visit&& visit) {
    const int copy = ::openat(proc.fd(), ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const std::unique_ptr<DIR, int (*)(DIR*)> listing(copy < 0 ? nullptr : ::fdopendir(copy), &::closedir);
    if (!listing) { return; }
    while (const dirent* entry = ::readdir(listing.get())) {
        if (std::isdigit(static_cast<unsigned char>(entry->d_name[0])) != 0) {
            visit(std::string(entry->d_name));
        }
    }
}

Handle folder_of(int process, const char* path) {
    const std::string whole = "/proc/" + std::to_string(process) + '/' + path;
    return Handle(::open(whole.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
}

}  // namespace

bool UsageMeter::open(int first_process) {
    tmp_ = folder_of(first_process, "root/tmp");
    shared_memory_ = folder_of(first_process, "root/dev/shm");
    processes_ = folder_of(first_process, "root/proc");
    return is_open();
}

SandboxUsage UsageMeter::measure() const {
    SandboxUsage usage;
    usage.files = files_in(tmp_) + files_in(shared_memory_);
    for_each_process(processes_, [&](const std::string& process) {
        usage.memory_bytes += memory_of(text_in(processes_.fd(), process + "/status"));
        usage.cpu_seconds += cpu_of(text_in(processes_.fd(), process + "/stat"));
    });
    return usage;
}

std::vector<int> children_of(int process) {
    std::vector<int> found;
    const Handle proc(::open("/proc", O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    for_each_process(proc, [&](const std::string& other) {
        const std::string stat = text_in(proc.fd(), other + "/stat");
        const char* const parent = field_of(stat, 4);
        if (parent != nullptr && std::atoi(parent) == process) { found.push_back(std::atoi(other.c_str())); }
    });
    return found;
}

}  // namespace jw::exercises
