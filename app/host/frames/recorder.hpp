#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "app/session/output/json.hpp"
#include "app/session/view/view.hpp"
#include "render/image.hpp"

/// Pictures of a lesson on their way to whoever asked for them.
namespace jw::host {

class Recorder {
public:
    virtual ~Recorder() = default;
    Recorder() = default;
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    /// @param number   of the picture; @param seconds  how long it is shown
    virtual void add(int number, const View& view, double seconds, render::Image image) = 0;
    /// After the last picture. @param head  what is said of the whole
    /// @return where the pictures are, to be read by people
    virtual std::string finish(Json head) = 0;
};

/// Recorder of this surface: into a folder with a manifest, or, in a page, into a film that is downloaded.
/// @param path        without extension
/// @param first,last  numbers of the pictures that may come
/// @throws std::runtime_error if nothing can be written there
std::unique_ptr<Recorder> make_recorder(const std::filesystem::path& path, int first, int last);

}  // namespace jw::host
