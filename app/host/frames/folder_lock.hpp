#pragma once

#include <filesystem>
#include <string>

namespace jw::host {

/// Lock on a folder that several processes write into, let go when this is destroyed or the process ends.
class FolderLock {
public:
    enum class Kind {
        alone,   ///< nobody else holds one
        shared,  ///< others may hold shared ones
    };

    FolderLock() = default;
    ~FolderLock() { let_go(); }
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    /// Takes the lock of a folder in place of the one held; the folder is made where it is not there, or is
    /// taken away by who held the lock. A folder that cannot be opened, or whose file system knows no locks,
    /// is not locked.
    /// @return true if the folder was made
    /// @throws std::runtime_error "'FOLDER' HELD" if others hold it for two seconds; if it cannot be made
    bool take(const std::filesystem::path& folder, Kind kind, const std::string& held);
    void let_go();

private:
    /// Waits for the lock of the open folder. @return false if others hold it for two seconds
    bool wait(Kind kind) const;

    int folder_ = -1;  ///< open; -1: not locked
};

}  // namespace jw::host
