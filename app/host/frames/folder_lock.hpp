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

    /// Takes the lock of a folder in place of the one held. A folder that cannot be opened, or whose file
    /// system knows no locks, is not locked.
    /// @throws std::runtime_error "'FOLDER' HELD" if others hold it for two seconds
    void take(const std::filesystem::path& folder, Kind kind, const std::string& held);
    void let_go();

private:
    int folder_ = -1;  ///< open; -1: not locked
};

}  // namespace jw::host
