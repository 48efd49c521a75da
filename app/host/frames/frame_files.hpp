#pragma once

#include <filesystem>
#include <future>
#include <string>

#include "app/host/frames/frame_folder.hpp"
#include "app/session/output/json.hpp"
#include "app/session/view/view.hpp"
#include "render/image.hpp"

/// Pictures of a lesson as files, and the manifest that maps each to its step.
namespace jw::host {

/// "frame_00042.png"
std::string frame_name(int number);

/// Encodes and writes one picture while the next is drawn. Every file appears whole or not at all.
class FrameFiles {
public:
    /// Makes `folder`, parents included. What is in it stays as it is until the run is finished.
    /// @param first,last  numbers of the pictures that may come
    /// @param lesson      its file, which must not be overwritten; empty if it has none
    /// @throws std::runtime_error as FrameFolder
    FrameFiles(
        const std::filesystem::path& folder, int first, int last, const std::filesystem::path& lesson = {});

    void add(int number, const View& view, double seconds, render::Image image);
    /// Waits for the last picture, puts all of them in their place and writes the manifest, which so names
    /// only pictures that are there.
    /// @param head what the manifest says of the whole
    void finish(Json head);

private:
    void wait();

    FrameFolder folder_;
    std::future<void> writing_;
    Json frames_ = Json::array();
};

}  // namespace jw::host
