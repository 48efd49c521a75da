#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "app/host/frames/folder_lock.hpp"

namespace jw::site {

/// A folder with a site, which appears whole or not at all: it is written beside what is there and takes its
/// place when it is complete. What is killed while places are taken is put back by the next run. Folders of
/// the site are its own; a file beside them that is none of the site's keeps it from being written. Nobody
/// else writes a site into the folder meanwhile.
class SiteFolder {
public:
    /// @throws std::runtime_error if the folder cannot be made, or if it has files of somebody else and no
    /// site
    explicit SiteFolder(std::filesystem::path folder);
    ~SiteFolder();
    SiteFolder(const SiteFolder&) = delete;
    SiteFolder& operator=(const SiteFolder&) = delete;

    /// Folder that the site is written into until it is complete.
    const std::filesystem::path& draft() const { return draft_; }
    /// Writes a file of the site, its folders included. @param path  below the top of the site
    /// @throws std::runtime_error if that cannot be done
    void write(const std::string& path, std::string_view text) const;
    void write(const std::string& path, std::span<const std::uint8_t> bytes) const;
    /// Takes the place of the site that was there before.
    void finish();

private:
    std::filesystem::path folder_;
    std::filesystem::path draft_;
    std::filesystem::path replaced_;  ///< what was there before, while places are taken
    host::FolderLock lock_;
    bool is_new_ = false;  ///< the folder was not there before
};

}  // namespace jw::site
