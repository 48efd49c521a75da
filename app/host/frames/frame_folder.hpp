#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace jw::host {

/// A folder of pictures and the manifest that names them. Both belong together at every moment: as long as
/// not all pictures are there, there is no manifest, but a list of what is being written ('unfinished.json'),
/// so that the next run knows what to take away after one that was interrupted.
class FrameFolder {
public:
    /// Makes `folder`, parents included.
    /// @param names    of the pictures to be written
    /// @param keep     a file that must not be overwritten, the lesson; may be empty
    /// @throws std::runtime_error if that is not possible, if the folder has a manifest.json of somebody
    /// else, or
    ///         if one of the pictures would overwrite `keep`
    FrameFolder(std::filesystem::path folder, std::set<std::string> names, const std::filesystem::path& keep);

    /// Before the first picture: takes away the old manifest, then the pictures that it names and that will
    /// not be written anew. @throws std::runtime_error if that fails
    void begin();
    /// After the last picture. @throws std::runtime_error if the manifest cannot be written
    void finish(const std::string& manifest);

    const std::filesystem::path& path() const { return folder_; }

private:
    void protect(const std::filesystem::path& keep) const;
    void remove(const std::string& name) const;

    std::filesystem::path folder_;
    std::set<std::string> names_;
    std::set<std::string> stale_;  ///< of earlier runs
};

}  // namespace jw::host
