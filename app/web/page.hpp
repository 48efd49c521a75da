#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/host/guarded_screen.hpp"
#include "app/host/host.hpp"
#include "render/headless_context.hpp"

/// The interface in a page: the host, a canvas, and files that live in the memory of the page.
namespace jw::web {

struct PageSetup {
    std::string canvas =
        "#canvas";     ///< CSS selector; empty: nothing is drawn, and the state tells what there is
    int width = 1280;  ///< pixels of the canvas
    int height = 720;
    float density = 1.0F;  ///< see panels::Looking
    float text_scale = 1.0F;
    bool dark = false;
    std::string language = "en";
};

class Page {
public:
    /// @throws std::runtime_error if the browser shows no WebGL 2, or a font is missing
    explicit Page(const PageSetup& setup);
    ~Page();
    Page(const Page&) = delete;
    Page& operator=(const Page&) = delete;

    host::Host& host() { return host_; }

    /// Draws the next picture if one is due.
    /// @param seconds  since the last picture
    /// @return seconds until another one is due without an event; 0: at once, infinity: never
    double frame(double seconds);
    /// The browser took everything on the graphics card away, or gives it back.
    void lose_context();
    void restore_context();

    /// Address of what is shown, the part behind '#' (app/host/lesson/address.hpp).
    std::string address() const;
    /// Shows what an address says; one that leads nowhere is told as mistakes are. @throws as read_address
    void go_to(const std::string& address);

    /// Text of the open lesson as it stands, with what was tried; its file where nothing was; empty without a
    /// lesson.
    std::string lesson_source() const;
    /// Shows a file that was written a moment ago, at the step that is shown.
    void follow(const std::filesystem::path& file);
    /// State of the interface (app/host/host_state.hpp).
    std::string state() const;
    /// Text that Ctrl+V puts in from now on: of what other programs copy, pages hear only when it is pasted.
    void set_clipboard(const std::string& text);
    /// Pixel of the canvas where somebody types, "120 300"; empty if nobody does.
    std::string typing_place() const;

private:
    void give_downloads() const;

    std::string canvas_;
    std::unique_ptr<render::HeadlessContext> context_;
    host::Host host_;
    std::unique_ptr<host::GuardedScreen> screen_;
    double since_frame_ = 0.0;  ///< [s]
};

/// Mistakes and warnings of a lesson's text, as JSON: a list of line, column, severity and message.
std::string mistakes_of(const std::string& text, const std::string& file_name);

}  // namespace jw::web
