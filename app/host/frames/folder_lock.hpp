#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace jw::host {

/// @throws std::runtime_error "'PATH' WHY"
[[noreturn]] inline void refuse(const std::filesystem::path& path, const std::string& why) {
    throw std::runtime_error("'" + path.string() + "' " + why);
}

/// Lock on a folder that several processes write into, released when this is destroyed or the process ends.
class FolderLock {
public:
    enum class Kind {
        alone,   ///< no other process holds a lock
        shared,  ///< others may hold shared locks
    };

    FolderLock() = default;
    ~FolderLock() { let_go(); }
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    /// Takes the lock of a folder, in place of the lock held before. Creates the folder if it does not exist,
    /// or if the previous holder of the lock has removed it. A folder that cannot be opened, or whose file
    /// system does not support locks, is not locked.
    /// @return true if the folder was created
    /// @throws std::runtime_error "'FOLDER' HELD" if others hold the lock for two seconds; also if the folder
    ///         cannot be created
    bool take(const std::filesystem::path& folder, Kind kind, const std::string& held);
    void let_go();

private:
    /// Waits for the lock of the open folder. @return false if others hold it for two seconds
    bool wait(Kind kind) const;

    int folder_ = -1;  ///< descriptor of the open folder; -1: not locked
};

}  // namespace jw::host
