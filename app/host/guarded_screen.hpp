#pragma once

#include <memory>
#include <ostream>
#include <set>
#include <stdexcept>

#include "app/host/screen.hpp"

namespace jw::host {

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
