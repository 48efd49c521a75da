#pragma once

#include <memory>
#include <string>

#include "app/host/host.hpp"
#include "render/files/image.hpp"
#include "render/gl/gl_functions.hpp"

/// Draws a host through a table of GL functions, in a window or in memory.
namespace jw::host {

class Screen {
public:
    /// The GL context must be current here, in every call and at destruction. `gl`, `host` must outlive this.
    Screen(const render::GlFunctions& gl, Host& host);
    ~Screen();
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;

    /// Draws the result of the last Host::frame, and carries out the host's task.
    /// @throws std::runtime_error if the driver cannot make the framebuffers
    void draw();
    /// GL errors of the last `draw`, in words; empty if there were none.
    const std::string& complaint() const { return complaint_; }
    /// Number of the object drawn at a pixel of the frame, 0 for nothing. @throws as `draw`
    int pick(float x, float y);
    /// True if the browser shows the pictures of all lessons.
    bool is_complete() const;
    /// The picture as it was drawn.
    render::Image read();
    /// Copies the picture to the lower left corner of the window's framebuffer.
    void show() const;

private:
    struct Surface;
    struct Recording;

    void fit_to_host();
    void draw_scene();
    void draw_one_thumbnail();
    /// Draws the thumbnail of the lesson at `path`.
    void draw_thumbnail(const std::filesystem::path& path, const ToldLesson& told);
    void carry_out_task();
    void record_one();
    void finish_recording();

    const render::GlFunctions& gl_;
    Host* host_;
    std::unique_ptr<Surface> surface_;
    std::string complaint_;
};

}  // namespace jw::host
