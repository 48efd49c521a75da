#include "tests/app/host/person.hpp"

#include <cstdlib>

#include "app/session/wording/messages.hpp"
#include "lessons/files/catalogue.hpp"
#include "tests/app/host/kept_fonts.hpp"

namespace jw::test {

namespace {

constexpr double kFrame = 1.0 / 60.0;
constexpr int kMostFrames = 600;
// a free motion goes there and back in three seconds and never rests: these frames cover both ways, and end
// off its pose
constexpr double kFreeFrame = 0.1;
constexpr int kFreeFrames = 25;

}  // namespace

Person::Person(
    const std::string& lesson, Pictures pictures, int width, int height, bool dark, float text_scale) {
    set_language("en");  // an earlier test may have chosen another one
    host::HostSetup setup;
    setup.catalogue = catalogue_folder();
    setup.pictures = folder_.path();
    setup.recent_file = folder_.path() / "state" / "recent";
    setup.unsaved = folder_.path() / "state" / "unsaved";
    setup.progress = folder_.path() / "state" / "progress.toml";
    setup.dark = dark;
    setup.text_scale = text_scale;
    setup.width = width;
    setup.height = height;
    setup.load_fonts = kept_fonts;
    if (pictures == Pictures::drawn) { context_ = std::make_unique<render::Offscreen>(16, 16); }
    host_ = std::make_unique<host::Host>(setup);
    if (!lesson.empty()) { host_->open(setup.catalogue / lesson); }
    if (context_) {
        context_->begin_3d();
        screen_ = std::make_unique<host::Screen>(context_->gl(), *host_);
    }
    settle();
}

Person::~Person() {
    screen_.reset();
    host_.reset();
}

void Person::frame() { host_->frame(kFrame); }

void Person::settle() {
    const auto waits = [&] {
        return host_->seconds_to_change() <= 0.0 && host_->task() == host::DrawingTask::none;
    };
    const auto is_free = [&] { return host_->state().playback.freedom() >= 0; };
    for (int k = 0; k < 3 || (waits() && k < (is_free() ? kFreeFrames : kMostFrames)); ++k) {
        host_->frame(is_free() ? kFreeFrame : kFrame);
    }
}

void Person::wait(double seconds) {
    for (double t = 0.0; t < seconds; t += kFrame) { frame(); }
}

void Person::rest() {
    constexpr double kLong = 10.0;
    settle();
    host_->frame(kLong);
    settle();
}

void Person::press(host::Key key, bool ctrl) {
    if (ctrl) { host_->push(host::InputEvent::pressed(host::Key::ctrl)); }
    host_->push(host::InputEvent::pressed(key));
    host_->push(host::InputEvent::pressed(key, false));
    if (ctrl) { host_->push(host::InputEvent::pressed(host::Key::ctrl, false)); }
    settle();
}

void Person::type(std::string_view text) {
    for (const char c : text) {
        host_->push(host::InputEvent::typed(static_cast<unsigned char>(c)));
        settle();
    }
}

void Person::ask(host::Command command) {
    const host::CommandInfo& info = host::info_of(command);
    if (info.key != host::Key::none) { return press(info.key); }
    if (info.character != 0) { return type(std::string_view(&info.character, 1)); }
    press(info.ctrl, true);
}

void Person::point(float x, float y) {
    host_->push(host::InputEvent::pointer(x, y));
    settle();
}

void Person::click(float x, float y) {
    point(x, y);
    host_->push(host::InputEvent::button(0, true));
    host_->push(host::InputEvent::button(0, false));
    settle();
}

void Person::drag(float x, float y, float to_x, float to_y, int button) {
    constexpr int kMoves = 8;
    point(x, y);
    host_->push(host::InputEvent::button(button, true));
    settle();
    for (int k = 1; k <= kMoves; ++k) {
        const float part = static_cast<float>(k) / kMoves;
        point(x + part * (to_x - x), y + part * (to_y - y));
    }
    host_->push(host::InputEvent::button(button, false));
    settle();
}

void Person::wheel(float notches) {
    host_->push(host::InputEvent::wheel(notches));
    settle();
}

void Person::go_to(int step) {
    // letters are read all at once, and keys one in a frame
    const int by = step - session().index();
    for (int k = 0; k < std::abs(by); ++k) { host_->push(host::InputEvent::typed(by > 0 ? 'n' : 'b')); }
    settle();
    while (session().index() < step) { press(host::Key::right); }
    while (session().index() > step) { press(host::Key::left); }
}

render::Image Person::picture() {
    screen_->draw();
    frame();
    screen_->draw();
    return screen_->read();
}

}  // namespace jw::test
