#pragma once

#include <filesystem>
#include <future>
#include <string>
#include <vector>

#include "app/session/json.hpp"
#include "render/image.hpp"

/// Pictures of a lesson as files, and the manifest that maps each to its step.
namespace jw::host {

/// "frame_00042.png"
std::string frame_name(int number);

/// Encodes and writes one picture while the next is drawn. Every file appears whole or not at all.
class FrameFiles {
public:
    /// Makes `folder`, parents included.
    /// @throws std::runtime_error if that is not possible
    explicit FrameFiles(std::filesystem::path folder);

    void add(int number, const View& view, double seconds, render::Image image);
    /// Waits for the last picture and writes the manifest, which so names only pictures that are there.
    /// @param head what the manifest says of the whole
    void finish(Json head);

private:
    void wait();

    std::filesystem::path folder_;
    std::future<void> writing_;
    Json frames_ = Json::array();
};

}  // namespace jw::host
