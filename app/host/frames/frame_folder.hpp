#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "app/host/frames/frame_draft.hpp"

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

    /// Folder beside the finished pictures of `folder` that new ones are drawn into.
    static std::filesystem::path draft_folder(const std::filesystem::path& folder);

    /// Folder that pictures are drawn into; begin it before the first one.
    FrameDraft& draft() { return draft_; }
    /// After the last picture: the new pictures take the place of all that earlier runs have left.
    /// @throws std::runtime_error if the manifest cannot be written
    void finish(const std::string& manifest);

private:
    void refuse_strangers(const std::vector<std::string>& names) const;
    void protect(const std::filesystem::path& keep) const;
    void remove(const std::string& name) const;

    std::filesystem::path folder_;
    FrameDraft draft_;
    std::set<std::string> names_;
    std::set<std::string> before_;  ///< pictures of earlier runs
};

}  // namespace jw::host
