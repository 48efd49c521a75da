#include "app/host/frames/folder_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>
#include <utility>

namespace jw::host {

namespace {

// two seconds: on a busy machine, a killed process needs less than one to disappear
constexpr int kLockTries = 100;
constexpr std::chrono::milliseconds kLockPause{20};

/// True if the path still leads to the open folder, which may have been removed and created again.
bool leads_to(const std::filesystem::path& path, int folder) {
    struct stat named {};
    struct stat open {};
    return ::stat(path.c_str(), &named) == 0 && ::fstat(folder, &open) == 0 && named.st_dev == open.st_dev &&
           named.st_ino == open.st_ino;
}

/// True if a folder could not be created because it existed, or did so until another run removed it.
bool was_there(const std::filesystem::path& folder, const std::error_code& error) {
    std::error_code ignored;
    const auto now = std::filesystem::symlink_status(folder, ignored).type();
    return error == std::errc::file_exists &&
           (now == std::filesystem::file_type::not_found || now == std::filesystem::file_type::directory);
}

}  // namespace

bool FolderLock::wait(Kind kind) const {
    // processes of a killed run keep their lock until the system has removed them
    for (int tries = 0; tries < kLockTries; ++tries) {
        // if the file system does not support locks, other runs are not kept out
        const int how = (kind == Kind::alone ? LOCK_EX : LOCK_SH) | LOCK_NB;
        if (::flock(folder_, how) == 0 || errno != EWOULDBLOCK) { return true; }
        std::this_thread::sleep_for(kLockPause);
    }
    return false;
}

bool FolderLock::take(const std::filesystem::path& folder, Kind kind, const std::string& held) {
    for (;;) {
        let_go();
        std::error_code error;
        const bool is_new = std::filesystem::create_directory(folder, error);
        if (was_there(folder, error)) { continue; }
        if (error) { refuse(folder, "cannot be made a folder: " + error.message()); }
        folder_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        // another run may have removed the folder in between
        if (folder_ < 0 && errno == ENOENT) { continue; }
        if (folder_ < 0) { return is_new; }
        if (!wait(kind)) {
            let_go();
            refuse(folder, held);
        }
        if (leads_to(folder, folder_)) { return is_new; }
    }
}

void FolderLock::let_go() {
    if (folder_ >= 0) { ::close(std::exchange(folder_, -1)); }
}

}  // namespace jw::host
