#include "app/host/guarded_screen.hpp"

#include <new>
#include <utility>

#include "app/session/wording/messages.hpp"
#include "render/gl/gl_errors.hpp"

namespace jw::host {

namespace {

// if GL errors remain after all objects were created again this many times, the picture is shown as it is
constexpr int kMostComplaints = 2;
// largest number of messages in the log, one line each
constexpr std::size_t kMostTold = 50;

std::string words_of(const std::exception& error) {
    return dynamic_cast<const std::bad_alloc*>(&error) != nullptr ? "out of memory" : error.what();
}

}  // namespace

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
