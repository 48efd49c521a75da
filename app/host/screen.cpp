#include "app/host/screen.hpp"

#include <algorithm>
#include <new>
#include <string_view>
#include <utility>

#include <imgui.h>

#include "app/host/frames/frame_painter.hpp"
#include "app/host/frames/recorder.hpp"
#include "app/host/lesson/background_story.hpp"
#include "app/session/output/json.hpp"
#include "app/session/output/pace.hpp"
#include "app/session/picture/picture.hpp"
#include "app/session/story/timeline.hpp"
#include "app/session/wording/messages.hpp"
#include "lessons/read/reader.hpp"
#include "render/files/atomic_file.hpp"
#include "render/files/png.hpp"
#include "render/gl/gl_functions.hpp"
#include "render/gl/render_targets.hpp"
#include "render/passes/id_buffer.hpp"
#include "render/passes/imgui_backend.hpp"
#include "render/passes/scene_renderer.hpp"

namespace jw::host {

namespace {

// size of the cards in the browser, large enough for a projector
constexpr int kThumbnailWidth = 464;
constexpr int kThumbnailHeight = 264;
constexpr double kPickRadius = 4.0;  // pixels at 720

bool is_software(const render::GlFunctions& gl) {
    const auto* const name = reinterpret_cast<const char*>(gl.GetString(GL_RENDERER));
    const std::string_view renderer = name == nullptr ? "" : name;
    return renderer.find("llvmpipe") != std::string_view::npos ||
           renderer.find("softpipe") != std::string_view::npos;
}

/// Inputs that the bodies were drawn from. While they are the same, only the panels are drawn again.
struct Drawn {
    std::uint64_t version = 0;
    render::Camera camera;
    render::Rect viewport;
    render::Tone tone = render::Tone::light;

    bool operator==(const Drawn&) const = default;
};

// if GL errors remain after all objects were created again this many times, the picture is shown as it is
constexpr int kMostComplaints = 2;
// largest number of messages in the log, one line each
constexpr std::size_t kMostTold = 50;

std::string words_of(const std::exception& error) {
    return dynamic_cast<const std::bad_alloc*>(&error) != nullptr ? "out of memory" : error.what();
}

}  // namespace

/// Records the present story, one picture per frame of the window, so that the window keeps responding.
struct Screen::Recording {
    static constexpr int kWidth = 1280;
    static constexpr int kHeight = 720;

    Recording(const Host& host, const render::GlFunctions& gl)
        : told(host.session()->as_told()),
          first(host.session()->index()),
          next(first),
          files(make_recorder(host.task_path(), first, last_step(told.story))),
          painter(told.story, kWidth, kHeight, gl) {}

    ToldLesson told;
    int first;
    int next;
    std::unique_ptr<Recorder> files;
    FramePainter painter;
};

struct Screen::Surface {
    Surface(const render::GlFunctions& gl, Host& host)
        : scene(gl),
          ids(gl, scene.meshes()),
          panels(gl),
          fonts_version(host.fonts().version()),
          software(is_software(gl)) {}

    render::SceneRenderer scene;
    render::IdBuffer ids;
    render::ImguiBackend panels;
    int fonts_version;
    bool software;                                  ///< drawn by the CPU: edges are smoothed only at rest
    std::unique_ptr<render::RenderTargets> still;   ///< multisampled
    std::unique_ptr<render::RenderTargets> moving;  ///< one sample per pixel; only where drawing is slow
    render::RenderTargets* targets = nullptr;       ///< the one of this frame
    std::unique_ptr<render::RenderTargets> small;   ///< for thumbnails
    std::vector<std::unique_ptr<render::PictureTexture>> thumbnails;
    BackgroundStories telling;  ///< of the lesson whose thumbnail comes next
    std::optional<Drawn> drawn;
    std::unique_ptr<Recording> recording;
};

Screen::Screen(const render::GlFunctions& gl, Host& host)
    : gl_(gl), host_(&host), surface_(std::make_unique<Surface>(gl, host)) {
    fit_to_host();
    host.set_picker([this](float x, float y) { return pick(x, y); });
}

Screen::~Screen() {
    host_->set_picker({});
    // the textures are destroyed with this screen
    for (CatalogueEntry& entry : host_->shelf().entries()) { entry.thumbnail = nullptr; }
    if (!surface_->recording) { return; }
    try {
        finish_recording();
    } catch (const std::exception& error) { host_->done(tr("Not recorded: {0}", error.what())); }
}

void Screen::fit_to_host() {
    Surface& s = *surface_;
    if (s.fonts_version != host_->fonts().version()) {
        s.panels.reload_fonts();
        s.fonts_version = host_->fonts().version();
    }
    const auto fits = [&](const std::unique_ptr<render::RenderTargets>& t) {
        return t && t->size().width == host_->layout().width && t->size().height == host_->layout().height;
    };
    const bool quick = s.software && host_->is_moving();
    std::unique_ptr<render::RenderTargets>& wanted = quick ? s.moving : s.still;
    if (!fits(wanted)) {
        s.still.reset();
        s.moving.reset();
        s.targets = nullptr;
        wanted = std::make_unique<render::RenderTargets>(
            gl_, host_->layout().width, host_->layout().height, quick ? 1 : 4);
    }
    if (s.targets != wanted.get()) { s.drawn.reset(); }
    s.targets = wanted.get();
}

void Screen::draw() {
    Surface& s = *surface_;
    fit_to_host();
    draw_scene();
    s.targets->begin_2d();
    if (const ImDrawData* data = ImGui::GetDrawData()) { s.panels.draw(*data, s.targets->size()); }
    carry_out_task();
    if (host_->shows_lesson() || host_->is_telling()) {
        s.telling.forget();
    } else {
        draw_one_thumbnail();
    }
    complaint_ = render::take_gl_errors(gl_);
}

void Screen::draw_scene() {
    Surface& s = *surface_;
    if (!host_->shows_lesson()) {
        // the browser overwrites the bodies in the framebuffer
        s.drawn.reset();
        s.targets->begin_3d(render::toned(render::palette::kPaper, host_->state().tone()));
        return;
    }
    const Picture& picture = host_->picture();
    const Drawn now{host_->shown().version(), host_->camera(), host_->layout().scene, host_->state().tone()};
    if (s.drawn == now) { return; }
    s.targets->begin_3d(render::toned(render::palette::kPaper, now.tone));
    s.scene.draw(picture.scene, now.camera, now.viewport, *s.targets, now.tone);
    s.drawn = now;
}

bool Screen::is_complete() const {
    const auto missing = [](const CatalogueEntry& e) { return e.thumbnail == nullptr && e.error.empty(); };
    return host_->shows_lesson() || std::ranges::none_of(host_->shelf().entries(), missing);
}

int Screen::pick(float x, float y) {
    if (!host_->shows_lesson()) { return 0; }
    Surface& s = *surface_;
    fit_to_host();
    s.ids.update(
        host_->picture().scene, host_->camera(), host_->layout().scene, s.targets->size(),
        host_->shown().pose_version());
    const double scale = static_cast<double>(host_->layout().height) / 720.0;
    return s.ids.nearest_id(static_cast<double>(x), static_cast<double>(y), kPickRadius * scale);
}

void Screen::draw_one_thumbnail() {
    BackgroundStories& telling = surface_->telling;
    const bool waits = telling.is_busy() && !telling.is_done();
    for (CatalogueEntry& entry : host_->shelf().entries()) {
        if (entry.thumbnail != nullptr || !entry.error.empty()) { continue; }
        host_->rouse();
        if (waits) { return; }
        const ReadResult read = read_lesson_file(entry.path);
        if (!read.lesson) {
            entry.error = tr("cannot be read");
            continue;
        }
        telling.begin();
        try {
            draw_thumbnail(
                entry.path, telling.tell(std::make_shared<const Lesson>(*read.lesson), poses_only()));
        } catch (const NotToldYet&) { return; }
        return telling.forget();
    }
}

void Screen::draw_thumbnail(const std::filesystem::path& path, const ToldLesson& told) {
    Surface& s = *surface_;
    if (!s.small) {
        s.small = std::make_unique<render::RenderTargets>(gl_, kThumbnailWidth, kThumbnailHeight);
    }
    const PictureStyle style = picture_style(told.story);
    const render::Rect whole{0.0, 0.0, kThumbnailWidth, kThumbnailHeight};
    const render::Camera camera = camera_of(told.story, style, whole, render::shrunk(whole, 16.0));
    const Picture picture = picture_of(told.story, style, told.story.last_assembled());
    s.small->begin_3d();
    s.scene.draw(picture.scene, camera, whole, *s.small);
    s.small->begin_2d();
    s.thumbnails.push_back(std::make_unique<render::PictureTexture>(gl_, s.small->read()));
    for (CatalogueEntry& entry : host_->shelf().entries()) {
        std::error_code error;
        if (std::filesystem::equivalent(entry.path, path, error)) {
            entry.thumbnail = s.thumbnails.back()->id();
        }
    }
}

void Screen::carry_out_task() {
    // stopped by the user: the pictures recorded so far are finished
    if (surface_->recording && host_->task() != DrawingTask::record) { finish_recording(); }
    if (host_->task() == DrawingTask::none) { return; }
    try {
        if (host_->task() == DrawingTask::save_picture) {
            const std::filesystem::path path = host_->task_path();
            render::write_file_atomically(path, render::encode_png(read()));
            host_->done(tr("Saved {0}", path.string()));
            return;
        }
        record_one();
    } catch (const std::exception& error) {
        surface_->recording.reset();
        host_->done(tr("Not saved: {0}", error.what()));
    }
}

void Screen::record_one() {
    std::unique_ptr<Recording>& recording = surface_->recording;
    if (!recording) { recording = std::make_unique<Recording>(*host_, gl_); }
    Recording& r = *recording;
    const Story& story = r.told.story;
    const auto count = static_cast<int>(story.steps().size());
    const View view = view_of(story, r.next);
    r.files->add(r.next, view, seconds_of_step(story, view), r.painter.paint(view));
    ++r.next;
    if (r.next < count) {
        host_->say(tr("Recording: {0} of {1}   ·   Escape stops", r.next - r.first, count - r.first));
    } else {
        finish_recording();
    }
}

void Screen::finish_recording() {
    const std::unique_ptr<Recording> r = std::move(surface_->recording);
    host_->done(r->files->finish(
        {{"format", "jointwise render"},
         {"version", kJsonVersion},
         {"lesson", {{"file", r->told.lesson->file_name}, {"title", r->told.lesson->title}}},
         {"size", {Recording::kWidth, Recording::kHeight}},
         {"frames_in_all", static_cast<int>(r->told.story.steps().size())}}));
}

render::Image Screen::read() { return surface_->targets->read(); }

void Screen::show() const { surface_->targets->blit_to_window(); }

GuardedScreen::GuardedScreen(const render::GlFunctions& gl, Host& host, std::ostream& log)
    : gl_(gl), host_(&host), log_(&log) {
    make_screen();
}

GuardedScreen::~GuardedScreen() { host_->set_picker({}); }

void GuardedScreen::make_screen() {
    screen_ = std::make_unique<Screen>(gl_, *host_);
    host_->set_picker([this](float x, float y) { return pick(x, y); });
}

/// Screen::pick without exceptions, which would leave the host's layout of the frame half done.
int GuardedScreen::pick(float x, float y) {
    if (!screen_ || !pick_failure_.empty()) { return 0; }
    try {
        return screen_->pick(x, y);
    } catch (const std::exception& error) {
        pick_failure_ = words_of(error);
        return 0;
    }
}

bool GuardedScreen::draw() {
    try {
        if (const std::string why = std::exchange(pick_failure_, {}); !why.empty()) {
            fail(why);
            return false;
        }
        if (!screen_) { make_screen(); }
        screen_->draw();
    } catch (const GraphicsLost&) { throw; } catch (const std::exception& error) {
        fail(words_of(error));
        return false;
    }
    if (const std::string why = screen_->complaint(); !why.empty() && failures_ < kMostComplaints) {
        fail("drawing failed with " + why);
        return false;
    }
    if (screen_->complaint().empty()) { failures_ = 0; }
    return true;
}

void GuardedScreen::show() {
    screen_->show();
    if (const std::string why = render::take_gl_errors(gl_); !why.empty()) {
        tell("showing the picture failed with " + why);
    }
}

void GuardedScreen::fail(const std::string& why) {
    tell(why);
    screen_.reset();
    render::take_gl_errors(gl_);
    host_->say(
        tr("The picture had to be started again: {0}. The lesson and all changes to it are kept.", why));
    host_->rouse();
    if (++failures_ >= kMostFailures) {
        throw GraphicsLost("the graphics driver fails again and again: " + why);
    }
}

void GuardedScreen::tell(const std::string& why) {
    if (told_.size() == kMostTold || !told_.insert(why).second) { return; }
    *log_ << "jointwise: warning: " << why << "; the picture is drawn again\n" << std::flush;
}

}  // namespace jw::host
