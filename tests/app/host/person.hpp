#pragma once

#include <memory>
#include <string_view>

#include "app/host/screen.hpp"
#include "render/surface/offscreen.hpp"
#include "tests/support/temporary_folder.hpp"

/// A person at the window, without a window: moves the pointer, clicks, types, and looks at the picture.
namespace jw::test {

class Person {
public:
    enum class Pictures { none, drawn };

    /// @param lesson  path below the catalogue, "loops/four-bar.toml", or any other; empty: the browser
    explicit Person(
        const std::string& lesson, Pictures pictures = Pictures::none, int width = 1280, int height = 720,
        bool dark = false, float text_scale = 1.0F);
    ~Person();
    Person(const Person&) = delete;
    Person& operator=(const Person&) = delete;

    host::Host& host() { return *host_; }
    /// Only where pictures are drawn.
    host::Screen& screen() { return *screen_; }
    /// Folder for pictures, lessons and the list of lessons opened last.
    const TemporaryFolder& folder() const { return folder_; }
    const Session& session() const { return *host_->session(); }
    const View& view() const { return session().view(); }

    /// Frames of a sixtieth of a second: one; until nothing but a task waits; or for a time [s].
    void frame();
    void settle();
    void wait(double seconds);
    /// Waits like a person at a window at rest: one long frame. Then messages are gone and cameras still.
    void rest();

    void press(host::Key key, bool ctrl = false);
    /// Types ASCII text, a character at a time.
    void type(std::string_view text);
    /// Asks for a command of the catalogue as somebody at the keyboard does.
    void ask(host::Command command);
    void point(float x, float y);
    void click(float x, float y);
    void drag(float x, float y, float to_x, float to_y, int button = 0);
    void wheel(float notches);
    void go_to(int step);

    /// Picture of the window as it is now.
    render::Image picture();

private:
    TemporaryFolder folder_;
    std::unique_ptr<render::Offscreen> context_;
    std::unique_ptr<host::Host> host_;
    std::unique_ptr<host::Screen> screen_;
};

}  // namespace jw::test
