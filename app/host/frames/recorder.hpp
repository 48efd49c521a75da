#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "app/session/output/json.hpp"
#include "app/session/view/view.hpp"
#include "render/files/image.hpp"

/// Output of the pictures of a lesson.
namespace jw::host {

class Recorder {
public:
    virtual ~Recorder() = default;
    Recorder() = default;
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    /// @param number   of the picture; @param seconds  how long it is shown
    virtual void add(int number, const View& view, double seconds, render::Image image) = 0;
    /// Call after the last picture. @param head  entries about the whole recording
    /// @return message that says where the pictures are
    virtual std::string finish(Json head) = 0;
};

/// Recorder of this platform: writes a folder with a manifest or, in a web page, a film to download.
/// @param path        of the result, without extension
/// @param first,last  range of the numbers of pictures
/// @throws std::runtime_error if nothing can be written there
std::unique_ptr<Recorder> make_recorder(const std::filesystem::path& path, int first, int last);

}  // namespace jw::host
