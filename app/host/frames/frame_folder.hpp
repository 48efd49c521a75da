#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace jw::host {

/// A folder of pictures and the manifest that names them. Both belong together at every moment: a run draws
/// into a folder of its own beside the old pictures ('unfinished-frames') and takes their place when it is
/// complete, so that a run that fails loses nothing. While places are taken there is no manifest, but a list
/// of what is there ('unfinished.json'), so that the next run knows what to take away after one that was
/// interrupted.
class FrameFolder {
public:
    /// Makes `folder`, parents included.
    /// @param names    of the pictures to be written
    /// @param keep     a file that must not be overwritten, the lesson; may be empty
    /// @throws std::runtime_error if that is not possible, if the folder has a manifest.json or a picture
    ///         frame_NNNNN.png of somebody else, or if one of the pictures would overwrite `keep`
    FrameFolder(std::filesystem::path folder, std::set<std::string> names, const std::filesystem::path& keep);
    FrameFolder(const FrameFolder&) = delete;
    FrameFolder& operator=(const FrameFolder&) = delete;
    /// Takes away what a run has drawn that was not finished.
    ~FrameFolder();

    /// Before the first picture. @throws std::runtime_error if there is no room for it
    void begin();
    /// After the last picture: the new pictures take the place of all that earlier runs have left.
    /// @throws std::runtime_error if the manifest cannot be written
    void finish(const std::string& manifest);

    /// Folder that pictures are written into until then.
    const std::filesystem::path& drawn() const { return drawn_; }

private:
    void refuse_strangers() const;
    void protect(const std::filesystem::path& keep) const;
    void remove(const std::string& name) const;
    void clear_drawn() const;

    std::filesystem::path folder_;
    std::filesystem::path drawn_;
    std::set<std::string> names_;
    std::set<std::string> before_;  ///< pictures of earlier runs
    bool is_open_ = false;
};

}  // namespace jw::host
