#include "app/commands/program/surface.hpp"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <span>

#include <dlfcn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "render/gl/render_targets.hpp"
#include "render/passes/scene_renderer.hpp"
#include "render/surface/headless_context.hpp"
#include "render/surface/mesa_settings.hpp"
#include "render/surface/offscreen.hpp"

namespace jw {

namespace {

using render::Vector3d;

/// A ball of the test picture, and how its middle must look.
struct Ball {
    const char* where;
    const char* hue;
    Vector3d centre;
    double radius;
    render::Colour colour;
};

/// Four hues that change if channels, or sides of the picture, are exchanged. The last ball lies behind the
/// one before it but is drawn later: it is visible only if depth is not tested.
const std::array<Ball, 5>& balls() {
    using namespace render::palette;
    static const std::array<Ball, 5> all{{
        {"left", "red", {-1.0, 0.0, -0.6}, 0.3, kVermilion},
        {"right", "blue", {1.0, 0.0, -0.6}, 0.3, kBlue},
        {"top", "green", {0.0, 0.0, 0.8}, 0.3, kGreen},
        {"front", "purple", {0.0, -1.0, 0.0}, 0.2, kPurple},
        {"back", "yellow", {0.0, 1.0, 0.0}, 0.4, kYellow},
    }};
    return all;
}

constexpr std::size_t kSeen = 4;
// a library that takes longer is not damaged: something else is wrong [s]
constexpr unsigned kLoadingTime = 20;
constexpr Library kOffscreenLibrary{"libOSMesa.so.8", "libosmesa6"};
// the backdrop is paper: all channels are at least this
constexpr int kPale = 220;

render::Rect whole() { return {0.0, 0.0, kTestWidth, kTestHeight}; }

/// A view from straight ahead, so that places in the picture are known.
render::Camera test_camera() {
    render::Camera camera;
    camera.eye = {0.0, -6.0, 0.0};
    return camera;
}

/// Whether each channel is stronger than the next: the hue without the brightness.
template <class Channel>
std::array<bool, 2> hue_of(Channel r, Channel g, Channel b) {
    return {r > g, g > b};
}

std::string hex(const std::uint8_t* pixel) {
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x", pixel[0], pixel[1], pixel[2]);
    return text.data();
}

std::string text_of(const render::GlFunctions& gl, GLenum name) {
    const auto* const found = reinterpret_cast<const char*>(gl.GetString(name));
    return found == nullptr ? "unknown" : found;
}

/// Runs `work` in another process, for at most `kLoadingTime`.
/// @return the signal that ended it; 0 if it finished, took too long, or no process could be started
int signal_that_ends(const std::function<void()>& work) {
    const pid_t child = ::fork();
    if (child == 0) {
        ::alarm(kLoadingTime);
        ::signal(SIGALRM, SIG_DFL);
        work();
        ::_exit(0);
    }
    int status = 0;
    if (child < 0 || ::waitpid(child, &status, 0) != child || !WIFSIGNALED(status)) { return 0; }
    return WTERMSIG(status) == SIGALRM ? 0 : WTERMSIG(status);
}

/// Draws the test picture in memory; messages of the driver are ignored here.
void try_offscreen() {
    try {
        const render::Offscreen offscreen(kTestWidth, kTestHeight);
        render::RenderTargets targets(offscreen.gl(), kTestWidth, kTestHeight);
        draw_test_picture(offscreen.gl(), targets);
    } catch (const std::exception&) { return; }
}

/// Checks whether settings of the environment forbid drawing, or make it end the program.
/// @return true if they do; otherwise `report` stays as it is
bool blame_settings(SurfaceReport& report) {
    try {
        render::settle_mesa();
    } catch (const std::exception& error) {
        report.state = SurfaceReport::State::draws_wrong;
        report.problem = error.what();
        return true;
    }
    // if it is loaded, it has drawn here; a second process would wait for threads that it does not have
    if (::dlopen(kOffscreenLibrary.name, RTLD_NOW | RTLD_NOLOAD) != nullptr) { return false; }
    const int signal = signal_that_ends(try_offscreen);
    if (signal == 0) { return false; }
    report.state = SurfaceReport::State::draws_wrong;
    report.problem = "drawing the test picture ends the program (signal " + std::to_string(signal) + ")";
    report.remedy =
        "unset variables that begin with DRAW_, GALLIUM_, LP_ or MESA_; or another version of the graphics "
        "driver (Mesa) may work";
    return true;
}

}  // namespace

render::Image draw_test_picture(const render::GlFunctions& gl, render::RenderTargets& targets) {
    render::Scene scene;
    for (const Ball& ball : balls()) {
        scene.shapes.push_back({render::Sphere{ball.centre, ball.radius}, ball.colour});
    }
    const render::SceneRenderer renderer(gl);
    targets.begin_3d();
    renderer.draw(scene, test_camera(), whole(), targets);
    targets.begin_2d();
    return targets.read();
}

std::string fault_of(const render::Image& picture) {
    for (const int x : {1, kTestWidth - 2}) {
        for (const int y : {1, kTestHeight - 2}) {
            const std::uint8_t* const corner = picture.at(x, y);
            if (*std::min_element(corner, corner + 3) < kPale) {
                return "a corner of the test picture is " + hex(corner) + "; expected pale paper";
            }
        }
    }
    for (const Ball& ball : std::span(balls()).first(kSeen)) {
        const render::Projected at = project(test_camera(), whole(), ball.centre);
        const std::uint8_t* const pixel = picture.at(static_cast<int>(at.x), static_cast<int>(at.y));
        const bool blank = *std::min_element(pixel, pixel + 3) >= kPale;
        const render::Colour& c = ball.colour;
        if (blank || hue_of(pixel[0], pixel[1], pixel[2]) != hue_of(c.r, c.g, c.b)) {
            return "the ball at the " + std::string(ball.where) + " of the test picture is " + hex(pixel) +
                   "; expected " + ball.hue;
        }
    }
    return {};
}

void examine(const render::GlFunctions& gl, SurfaceReport& report) {
    report.renderer = text_of(gl, GL_RENDERER);
    report.gl_version = text_of(gl, GL_VERSION);
    try {
        render::RenderTargets targets(gl, kTestWidth, kTestHeight);
        report.samples = targets.samples();
        report.problem = fault_of(draw_test_picture(gl, targets));
    } catch (const std::exception& error) { report.problem = error.what(); }
    report.state = report.problem.empty() ? SurfaceReport::State::right : SurfaceReport::State::draws_wrong;
    if (!report.problem.empty()) { report.remedy = "another version of the graphics driver (Mesa) may work"; }
}

LibraryReport examine_library(const char* name) {
    LibraryReport report;
    int ends[2]{};
    if (::pipe(ends) != 0) { return report; }
    const pid_t child = ::fork();
    if (child == 0) {
        ::alarm(kLoadingTime);
        ::signal(SIGALRM, SIG_DFL);
        if (::dlopen(name, RTLD_NOW | RTLD_LOCAL) != nullptr) { ::_exit(0); }
        const char* const words = ::dlerror();
        const std::string why = words == nullptr ? "" : words;
        static_cast<void>(!::write(ends[1], why.data(), why.size()));
        ::_exit(1);
    }
    ::close(ends[1]);
    std::array<char, 1000> words{};
    const ssize_t count = child > 0 ? ::read(ends[0], words.data(), words.size()) : 0;
    ::close(ends[0]);
    int status = 0;
    if (child < 0 || ::waitpid(child, &status, 0) != child) { return report; }
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) { return report; }
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM) { return report; }
    report.words.assign(words.data(), static_cast<std::size_t>(std::max<ssize_t>(0, count)));
    // the system's loader writes this for a missing file; other messages are about an existing one
    const bool absent = report.words.find("No such file") != std::string::npos;
    report.state = absent ? SurfaceReport::State::missing : SurfaceReport::State::damaged;
    return report;
}

bool blame_library(SurfaceReport& report, std::span<const Library> libraries) {
    for (const auto& [name, package] : libraries) {
        const LibraryReport library = examine_library(name);
        if (library.state == SurfaceReport::State::right) { continue; }
        const std::string what = "the library '" + std::string(name) + "' is ";
        report.state = library.state;
        if (library.state == SurfaceReport::State::missing) {
            report.problem = what + "not there";
            report.packages = package;
        } else {
            report.problem = what + "damaged" + (library.words.empty() ? "" : ": " + library.words);
            report.remedy = "apt-get install --reinstall " + std::string(package);
        }
        return true;
    }
    return false;
}

SurfaceReport examine_offscreen() {
    SurfaceReport report;
    report.name = "offscreen";
    if (blame_library(report, std::array{kOffscreenLibrary}) || blame_settings(report)) { return report; }
    try {
        const std::unique_ptr<render::HeadlessContext> context = render::make_osmesa_context();
        examine(context->gl(), report);
    } catch (const std::exception& error) {
        report.state = SurfaceReport::State::missing;
        report.problem = error.what();
        report.remedy = "unset variables that begin with MESA_ or GALLIUM_, if there are any";
        report.packages = "libosmesa6";
    }
    return report;
}

SurfaceReport examine_egl() {
    SurfaceReport report;
    report.name = "egl";
    const LibraryReport library = examine_library("libEGL.so.1");
    if (library.state != SurfaceReport::State::right) {
        report.problem = "no EGL here; OSMesa draws the same pictures";
        return report;
    }
    try {
        const std::unique_ptr<render::HeadlessContext> context = render::make_egl_context();
        examine(context->gl(), report);
    } catch (const std::exception& error) { report.problem = error.what(); }
    return report;
}

}  // namespace jw
