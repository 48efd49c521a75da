#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/host/host.hpp"
#include "app/host/screen.hpp"
#include "render/surface/headless_context.hpp"

/// The interface in a web page: the host, a canvas, and files in the memory of the page.
namespace jw::web {

struct PageSetup {
    std::string canvas =
        "#canvas";     ///< CSS selector; empty: nothing is drawn, and only the state is available
    int width = 1280;  ///< pixels of the canvas
    int height = 720;
    float density = 1.0F;  ///< see panels::Looking
    float text_scale = 1.0F;
    bool dark = false;
    std::string language = "en";
};

class Page {
public:
    /// @throws std::runtime_error if the browser has no WebGL 2, or if a font is missing
    explicit Page(const PageSetup& setup);
    ~Page();
    Page(const Page&) = delete;
    Page& operator=(const Page&) = delete;

    host::Host& host() { return host_; }

    /// Draws the next picture if one is due.
    /// @param seconds  since the last picture
    /// @return seconds until another one is due without an event; 0: at once, infinity: never
    double frame(double seconds);
    /// Gives up the graphics objects after the browser has taken away their context.
    void lose_context();
    /// Creates the graphics objects again in the context that the browser has restored.
    void restore_context();

    /// Address of the shown state, the part after '#' (app/host/lesson/address.hpp).
    std::string address() const;
    /// Shows the state that an address describes. If that fails, the reason is shown like mistakes of a file.
    /// @throws as read_address
    void go_to(const std::string& address);

    /// The open lesson as text, with the experiments; the text of its file if none; empty without a lesson.
    std::string lesson_source() const;
    /// Shows a file that has just been written, at the step that is shown.
    void follow(const std::filesystem::path& file);
    /// State of the interface (app/host/host.hpp).
    std::string state() const;
    /// Sets the text that Ctrl+V inserts. A page learns what other programs copy only when it is pasted.
    void set_clipboard(const std::string& text);
    /// Pixel of the canvas where text is being typed, "120 300"; empty if no field has the keyboard.
    std::string typing_place() const;

private:
    void give_downloads() const;

    std::string canvas_;
    std::unique_ptr<render::HeadlessContext> context_;
    host::Host host_;
    std::unique_ptr<host::GuardedScreen> screen_;
    double since_frame_ = 0.0;  ///< [s]
};

/// Key of a keyboard event of a page. @param name  its `key`, such as "ArrowLeft", "a" or "F5"
host::Key key_of(std::string_view name);

/// Mistakes and warnings of a lesson's text, as JSON: a list of line, column, severity and message.
std::string mistakes_of(const std::string& text, const std::string& file_name);

/// Words of the page around the picture, in the current language: JSON with the English words, which are in
/// the files of the page, as keys.
std::string words_of_page();

/// WebGL 2 context of the page's canvas, which shows the default framebuffer of the context.
/// @param canvas  its CSS selector
/// @throws std::runtime_error if the browser has no WebGL 2
std::unique_ptr<render::HeadlessContext> make_webgl_context(const char* canvas);

}  // namespace jw::web
