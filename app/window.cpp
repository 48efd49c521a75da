#include "app/window.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <stdexcept>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include "app/host/screen.hpp"
#include "render/gl/gl_functions.hpp"
#include "render/surface/mesa_settings.hpp"

namespace jw {

namespace {

using host::Host;
using host::InputEvent;
using host::Key;

constexpr const char* kWithoutWindow =
    "; pictures and text need no display: use 'jointwise render', 'jointwise step' or 'jointwise doctor'";

constexpr int kSmallestWidth = 640;
constexpr int kSmallestHeight = 400;
// time between two copies of unsaved experiments [s]
constexpr double kKeeping = 1.0;
// longest time between two checks of the open file [s]
constexpr double kLooking = 0.5;
// waiting time after a frame that could not be drawn [s]
constexpr double kAfterFailure = 0.25;

std::string last_glfw_error;

/// GLFW from initialisation to termination, and one window whose context is current.
class GlfwWindow {
public:
    GlfwWindow(int width, int height, bool visible) {
        render::settle_mesa();
        glfwSetErrorCallback([](int, const char* text) { last_glfw_error = text; });
        if (glfwInit() == GLFW_FALSE) { fail("no display can be opened"); }
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
        // the picture is multisampled before it is copied into the window
        glfwWindowHint(GLFW_SAMPLES, 0);
        glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
        glfwWindowHint(GLFW_VISIBLE, visible ? GLFW_TRUE : GLFW_FALSE);
        window_ = glfwCreateWindow(width, height, "Jointwise", nullptr, nullptr);
        if (window_ == nullptr) {
            glfwTerminate();
            fail("no window with OpenGL 3.3 can be opened");
        }
        glfwSetWindowSizeLimits(window_, kSmallestWidth, kSmallestHeight, GLFW_DONT_CARE, GLFW_DONT_CARE);
        glfwMakeContextCurrent(window_);
        glfwSwapInterval(1);
    }
    ~GlfwWindow() {
        glfwDestroyWindow(window_);
        glfwTerminate();
    }
    GlfwWindow(const GlfwWindow&) = delete;
    GlfwWindow& operator=(const GlfwWindow&) = delete;

    GLFWwindow* get() const { return window_; }

private:
    [[noreturn]] static void fail(const std::string& what) {
        throw std::runtime_error(
            what + (last_glfw_error.empty() ? "" : " (" + last_glfw_error + ")") + kWithoutWindow);
    }

    GLFWwindow* window_ = nullptr;
};

Key key_of(int glfw) {
    switch (glfw) {
        case GLFW_KEY_LEFT: return Key::left;
        case GLFW_KEY_RIGHT: return Key::right;
        case GLFW_KEY_UP: return Key::up;
        case GLFW_KEY_DOWN: return Key::down;
        case GLFW_KEY_HOME: return Key::home;
        case GLFW_KEY_END: return Key::end;
        case GLFW_KEY_PAGE_UP: return Key::page_up;
        case GLFW_KEY_PAGE_DOWN: return Key::page_down;
        case GLFW_KEY_SPACE: return Key::space;
        case GLFW_KEY_KP_ENTER:
        case GLFW_KEY_ENTER: return Key::enter;
        case GLFW_KEY_ESCAPE: return Key::escape;
        case GLFW_KEY_TAB: return Key::tab;
        case GLFW_KEY_BACKSPACE: return Key::backspace;
        case GLFW_KEY_DELETE: return Key::del;
        case GLFW_KEY_F1: return Key::f1;
        case GLFW_KEY_F5: return Key::f5;
        case GLFW_KEY_LEFT_CONTROL:
        case GLFW_KEY_RIGHT_CONTROL: return Key::ctrl;
        case GLFW_KEY_LEFT_SHIFT:
        case GLFW_KEY_RIGHT_SHIFT: return Key::shift;
        default: return Key::none;
    }
}

/// Key of a letter for commands with Ctrl, in any layout of the keyboard.
Key letter_of(int glfw, int scancode) {
    const char* const name = glfwGetKeyName(glfw, scancode);
    if (name == nullptr || name[1] != '\0') { return Key::none; }
    return host::key_of_letter(name[0]);
}

Host& host_of(GLFWwindow* window) { return *static_cast<Host*>(glfwGetWindowUserPointer(window)); }

/// Pixels of the framebuffer for one unit of the window's coordinates.
float pixel_ratio(GLFWwindow* window) {
    int pixels = 0;
    int units = 0;
    glfwGetFramebufferSize(window, &pixels, nullptr);
    glfwGetWindowSize(window, &units, nullptr);
    return units > 0 ? static_cast<float>(pixels) / static_cast<float>(units) : 1.0F;
}

void listen(GLFWwindow* window) {
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
        const float ratio = pixel_ratio(w);
        host_of(w).push(InputEvent::pointer(static_cast<float>(x) * ratio, static_cast<float>(y) * ratio));
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int) {
        host_of(w).push(InputEvent::button(button, action == GLFW_PRESS));
    });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double, double y) {
        host_of(w).push(InputEvent::wheel(static_cast<float>(y)));
    });
    glfwSetKeyCallback(window, [](GLFWwindow* w, int code, int scancode, int action, int mods) {
        Key key = key_of(code);
        if (key == Key::none && (mods & GLFW_MOD_CONTROL) != 0) { key = letter_of(code, scancode); }
        if (key != Key::none) { host_of(w).push(InputEvent::pressed(key, action != GLFW_RELEASE)); }
    });
    glfwSetCharCallback(
        window, [](GLFWwindow* w, unsigned character) { host_of(w).push(InputEvent::typed(character)); });
    glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
        if (entered == GLFW_FALSE) { host_of(w).push(InputEvent::leave()); }
    });
    glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int focused) {
        if (focused == GLFW_FALSE) { host_of(w).push(InputEvent::leave()); }
    });
    // a window that was hidden and is shown again has lost its picture
    glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { host_of(w).rouse(); });
}

void use_clipboard(GLFWwindow* window) {
    ImGuiIO& io = ImGui::GetIO();
    io.ClipboardUserData = window;
    io.SetClipboardTextFn = [](void* w, const char* text) {
        glfwSetClipboardString(static_cast<GLFWwindow*>(w), text);
    };
    io.GetClipboardTextFn = [](void* w) { return glfwGetClipboardString(static_cast<GLFWwindow*>(w)); };
}

void fit(GLFWwindow* window, Host& host) {
    int width = 0;
    int height = 0;
    glfwGetFramebufferSize(window, &width, &height);
    if (width > 0 && height > 0 && (width != host.layout().width || height != host.layout().height)) {
        host.resize(width, height);
    }
}

render::GlFunctions functions() {
    return render::load_gl_functions(
        [](const char* name) { return reinterpret_cast<void*>(glfwGetProcAddress(name)); });
}

std::string title_of(const Host& host) {
    if (!host.shows_lesson()) { return "Jointwise"; }
    return host.session()->lesson().title + (host.session()->is_changed() ? " (changed)" : "") +
           " – Jointwise";
}

/// Limits the size of the window: a screen may be larger than the largest picture of the driver.
void limit_size(GLFWwindow* window, const render::GlFunctions& gl) {
    GLint most = 0;
    gl.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
    if (most >= kSmallestWidth) {
        glfwSetWindowSizeLimits(window, kSmallestWidth, kSmallestHeight, most, most);
    }
}

/// Says where unsaved experiments are kept, as the end of a sentence; empty if there are none.
std::string kept(Host& host) {
    host.keep_unsaved();
    if (host.unsaved_copy().empty()) { return {}; }
    const std::string file = host.unsaved_copy().string();
    return "; what was tried and not saved is in '" + file + "', under 'Not saved' in the list of lessons";
}

void run(GLFWwindow* window, Host& host, host::GuardedScreen& screen) {
    using Clock = std::chrono::steady_clock;
    Clock::time_point before = Clock::now();
    Clock::time_point kept_at = before;
    bool drawn = true;
    std::string title;
    while (glfwWindowShouldClose(window) == GLFW_FALSE && !host.wants_to_close()) {
        // a driver that has just failed is given time
        const double wait = drawn ? std::min(host.seconds_to_change(), kLooking) : kAfterFailure;
        if (wait > 0.0) {
            glfwWaitEventsTimeout(wait);
        } else {
            glfwPollEvents();
        }
        fit(window, host);
        host.look_at_file();
        const Clock::time_point now = Clock::now();
        if (std::chrono::duration<double>(now - kept_at).count() >= kKeeping) {
            kept_at = now;
            host.keep_unsaved();
        }
        const double seconds = std::chrono::duration<double>(now - before).count();
        if (seconds < host.seconds_to_change()) { continue; }
        before = now;
        host.frame(seconds);
        drawn = screen.draw();
        if (!drawn) { continue; }
        screen.show();
        glfwSwapBuffers(window);
        if (std::string name = title_of(host); name != title) {
            title = std::move(name);
            glfwSetWindowTitle(window, title.c_str());
        }
    }
}

}  // namespace

void show_first(Host& host, const WindowSetup& setup) {
    if (setup.address) {
        host.go_to(*setup.address);
    } else if (setup.file) {
        host.open(*setup.file, setup.at, setup.experiments);
    }
}

void run_window(const WindowSetup& setup) {
    const GlfwWindow window(setup.host.width, setup.host.height, true);
    const render::GlFunctions gl = functions();
    limit_size(window.get(), gl);
    host::HostSetup wanted = setup.host;
    glfwGetFramebufferSize(window.get(), &wanted.width, &wanted.height);
    Host host(wanted);
    show_first(host, setup);
    if (!setup.exercise.empty() && !host.begin_exercise(setup.exercise)) {
        host.say("The lesson has no exercise '" + setup.exercise + "'.");
    }
    glfwSetWindowUserPointer(window.get(), &host);
    listen(window.get());
    use_clipboard(window.get());
    try {
        host::GuardedScreen screen(gl, host, *setup.log);
        run(window.get(), host, screen);
    } catch (const std::exception& error) { throw std::runtime_error(error.what() + kept(host)); }
    if (const std::string where = kept(host); !where.empty()) {
        *setup.log << "jointwise: note: closed" << where << '\n';
    }
}

void with_hidden_window(const std::function<void(const render::GlFunctions& gl)>& use) {
    const GlfwWindow window(64, 64, false);
    use(functions());
}

bool has_display() {
    const auto is_set = [](const char* name) {
        const char* const value = std::getenv(name);
        return value != nullptr && *value != '\0';
    };
    return is_set("DISPLAY") || is_set("WAYLAND_DISPLAY");
}

}  // namespace jw
