#pragma once

#include <memory>
#include <ostream>
#include <set>
#include <stdexcept>
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

/// Thrown when nothing can be drawn any more.
class GraphicsLost : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A `Screen` in a window. A failure during drawing costs one frame. Its message is shown at the foot of the
/// picture, and written to a log, once for each text. Then all objects on the graphics card are created
/// again; the lesson and all experiments with it are kept.
class GuardedScreen {
public:
    /// Makes a screen as Screen does; `log` must outlive this object.
    GuardedScreen(const render::GlFunctions& gl, Host& host, std::ostream& log);
    ~GuardedScreen();
    GuardedScreen(const GuardedScreen&) = delete;
    GuardedScreen& operator=(const GuardedScreen&) = delete;

    /// Draws as Screen::draw does.
    /// @return whether there is a picture to `show`
    /// @throws GraphicsLost after kMostFailures failures without an error-free picture between them
    bool draw();
    /// Shows the picture as Screen::show does; call it only after a `draw` that returned true.
    void show();

    static constexpr int kMostFailures = 20;

private:
    void make_screen();
    int pick(float x, float y);
    void fail(const std::string& why);
    void tell(const std::string& why);

    const render::GlFunctions& gl_;
    Host* host_;
    std::ostream* log_;
    std::unique_ptr<Screen> screen_;
    std::string pick_failure_;  ///< message of a failure during the layout; `draw` reports it
    std::set<std::string> told_;
    int failures_ = 0;
};

}  // namespace jw::host
