#include "app/host/frames/folder_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <thread>
#include <utility>

#include "app/host/frames/refuse.hpp"

namespace jw::host {

namespace {

// two seconds: on a busy machine a killed process needs part of one
constexpr int kLockTries = 100;
constexpr std::chrono::milliseconds kLockPause{20};

}  // namespace

void FolderLock::take(const std::filesystem::path& folder, Kind kind, const std::string& held) {
    let_go();
    folder_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder_ < 0) { return; }
    // processes of a run that was killed keep their lock until the system has taken them apart
    for (int tries = 0; tries < kLockTries; ++tries) {
        // where the file system knows no locks, nobody is kept out
        const int how = (kind == Kind::alone ? LOCK_EX : LOCK_SH) | LOCK_NB;
        if (::flock(folder_, how) == 0 || errno != EWOULDBLOCK) { return; }
        std::this_thread::sleep_for(kLockPause);
    }
    let_go();
    refuse(folder, held);
}

void FolderLock::let_go() {
    if (folder_ >= 0) { ::close(std::exchange(folder_, -1)); }
}

}  // namespace jw::host
