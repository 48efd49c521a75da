#include "app/exercises/run/sandbox_usage.hpp"

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

/// The number after `name`, in kB there and in bytes here; 0 if there is none.
std::uint64_t bytes_after(const std::string& text, std::string_view name) {
    const std::size_t at = text.find(name);
    return at == std::string::npos ? 0 : std::strtoull(text.c_str() + at + name.size(), nullptr, 10) << 10U;
}

std::uint64_t memory_of(const std::string& status) {
    return bytes_after(status, "\nRssAnon:") + bytes_after(status, "\nRssShmem:") +
           bytes_after(status, "\nVmPTE:");
}

/// Fields 14 to 17 of /proc/PID/stat: its time and that of its children, by itself and in the kernel.
double cpu_of(const std::string& stat) {
    static const auto ticks = static_cast<double>(::sysconf(_SC_CLK_TCK));
    // the name of the program may hold spaces and brackets
    std::size_t at = stat.rfind(')');
    for (int field = 2; field < 14 && at != std::string::npos; ++field) { at = stat.find(' ', at + 1); }
    if (at == std::string::npos) { return 0.0; }
    const char* text = stat.c_str() + at;
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
    const int copy = ::openat(processes_.fd(), ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const std::unique_ptr<DIR, int (*)(DIR*)> listing(copy < 0 ? nullptr : ::fdopendir(copy), &::closedir);
    if (!listing) { return usage; }
    while (const dirent* entry = ::readdir(listing.get())) {
        if (std::isdigit(static_cast<unsigned char>(entry->d_name[0])) == 0) { continue; }
        const std::string process = entry->d_name;
        usage.memory_bytes += memory_of(text_in(processes_.fd(), process + "/status"));
        usage.cpu_seconds += cpu_of(text_in(processes_.fd(), process + "/stat"));
    }
    return usage;
}

}  // namespace jw::exercises
