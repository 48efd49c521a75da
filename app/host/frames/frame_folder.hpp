#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "app/host/frames/frame_draft.hpp"

namespace jw::host {

/// A folder of pictures and the manifest that names them. The two always agree: a run draws into a folder of
/// its own ('unfinished-frames') beside the old pictures, and replaces them when it is complete, so that a
/// run that fails loses nothing. During the replacement there is no manifest, but a list of all pictures
/// ('unfinished.json'). If the replacement is interrupted, the list tells the next run which pictures to
/// remove.
class FrameFolder {
public:
    /// Creates `folder` and its parents.
    /// @param names    of the pictures to be written
    /// @param keep     file of the lesson, which must not be overwritten; may be empty
    /// @throws std::runtime_error if that is not possible, if the folder has a manifest.json or a picture
    ///         frame_NNNNN.png of other origin, or if one of the pictures would overwrite `keep`
    FrameFolder(std::filesystem::path folder, std::set<std::string> names, const std::filesystem::path& keep);

    /// Folder that new pictures are drawn into, beside the finished pictures of `folder`.
    static std::filesystem::path draft_folder(const std::filesystem::path& folder);

    /// Folder that pictures are drawn into; begin it before the first picture.
    FrameDraft& draft() { return draft_; }
    /// Call after the last picture: replaces the pictures of all earlier runs by the new ones.
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
