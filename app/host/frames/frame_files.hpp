#pragma once

#include <filesystem>
#include <future>
#include <set>
#include <string>
#include <vector>

#include "app/host/frames/frame_draft.hpp"
#include "app/session/view/view.hpp"
#include "render/files/image.hpp"
#include "render/files/png.hpp"

/// Pictures of a lesson as files, and the manifest that maps each to its step.
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

/// Writes PNG pictures into a folder. Each one is encoded and written while the next one is drawn. A file
/// appears only when it is complete.
class PictureWriter {
public:
    /// @param folder  must exist
    explicit PictureWriter(std::filesystem::path folder) : folder_(std::move(folder)) {}

    void add(int number, render::Image image);
    /// Waits for the last picture. @throws std::runtime_error if one could not be written
    void wait();

private:
    std::filesystem::path folder_;
    render::PngEncoder encoder_;  // of the one picture that is being written
    std::future<void> writing_;
};

/// Entry of the manifest for a picture, without the SHA-256 of its file.
Json entry_of(int number, const View& view, double seconds);

/// Writes the pictures of one run into a folder, with the manifest that names them.
class FrameFiles {
public:
    /// Creates `folder` and its parents. Its content does not change until the run is finished.
    /// @param first,last  range of the numbers of pictures
    /// @param lesson      file of the lesson, which must not be overwritten; empty if it has none
    /// @throws std::runtime_error as FrameFolder
    FrameFiles(
        const std::filesystem::path& folder, int first, int last, const std::filesystem::path& lesson = {});

    /// Folder of the pictures until the run is finished, for callers that begin it themselves; else the first
    /// picture begins it.
    FrameDraft& draft() { return folder_.draft(); }

    void add(int number, const View& view, double seconds, render::Image image);
    /// Adds to the manifest a picture that another process has drawn.
    void add_drawn(int number, const View& view, double seconds);
    /// Waits for the last picture, moves all pictures to their place, and then writes the manifest, so that
    /// it names only pictures that exist.
    /// @param head  entries of the manifest about the whole run
    void finish(Json head);

private:
    FrameFolder folder_;
    PictureWriter writer_;
    Json frames_ = Json::array();
};

}  // namespace jw::host
