#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "app/host/frames/folder_lock.hpp"

namespace jw::site {

/// A folder with a site. The new site is written beside the old one, and replaces it only when it is
/// complete. If a run is killed during the replacement, the next run puts the old site back. The subfolders
/// of the site belong to it completely; a foreign file beside them prevents the writing. While this object
/// exists, the folder is locked against other runs that write a site.
class SiteFolder {
public:
    /// @throws std::runtime_error if the folder cannot be created, is in use, or has files that are not part
    ///         of a site
    explicit SiteFolder(std::filesystem::path folder);
    ~SiteFolder();
    SiteFolder(const SiteFolder&) = delete;
    SiteFolder& operator=(const SiteFolder&) = delete;

    /// Folder that the site is written into until it is complete.
    const std::filesystem::path& draft() const { return draft_; }
    /// Writes a file of the site, and creates its folders. @param path  below the top of the site
    /// @throws std::runtime_error if the file cannot be written
    void write(const std::string& path, std::string_view text) const;
    void write(const std::string& path, std::span<const std::uint8_t> bytes) const;
    /// Replaces the old site by the new one.
    void finish();

private:
    std::filesystem::path folder_;
    std::filesystem::path draft_;
    std::filesystem::path replaced_;  ///< the old site, during the replacement
    host::FolderLock lock_;
    bool is_new_ = false;  ///< the folder did not exist before
};

}  // namespace jw::site
