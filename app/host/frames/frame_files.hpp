#pragma once

#include <filesystem>
#include <future>
#include <string>

#include "app/host/frames/frame_folder.hpp"
#include "app/session/view/view.hpp"
#include "render/image.hpp"
#include "render/png.hpp"

/// Pictures of a lesson as files, and the manifest that maps each to its step.
namespace jw::host {

/// Writes PNG pictures into a folder, each encoded and written while the next one is drawn. Every file
/// appears whole or not at all.
class PictureWriter {
public:
    /// @param folder  must be there
    explicit PictureWriter(std::filesystem::path folder) : folder_(std::move(folder)) {}

    void add(int number, render::Image image);
    /// Waits for the last picture. @throws std::runtime_error if one could not be written
    void wait();

private:
    std::filesystem::path folder_;
    render::PngEncoder encoder_;  // of the one picture that is being written
    std::future<void> writing_;
};

/// Entry of the manifest for a picture, without what its file is.
Json entry_of(int number, const View& view, double seconds);

/// Writes the pictures of one run into a folder, with the manifest that names them.
class FrameFiles {
public:
    /// Makes `folder`, parents included. What is in it stays as it is until the run is finished.
    /// @param first,last  numbers of the pictures that may come
    /// @param lesson      its file, which must not be overwritten; empty if it has none
    /// @throws std::runtime_error as FrameFolder
    FrameFiles(
        const std::filesystem::path& folder, int first, int last, const std::filesystem::path& lesson = {});

    /// Folder of the pictures until the run is finished, for those who begin it otherwise than by the first
    /// picture.
    FrameDraft& draft() { return folder_.draft(); }

    void add(int number, const View& view, double seconds, render::Image image);
    /// Names a picture that somebody else has drawn.
    void add_drawn(int number, const View& view, double seconds);
    /// Waits for the last picture, puts all of them in their place and writes the manifest, which so names
    /// only pictures that are there.
    /// @param head what the manifest says of the whole
    void finish(Json head);

private:
    FrameFolder folder_;
    PictureWriter writer_;
    Json frames_ = Json::array();
};

}  // namespace jw::host
