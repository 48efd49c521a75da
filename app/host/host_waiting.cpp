#include <new>
#include <utility>

#include <imgui.h>

#include "app/host/host.hpp"
#include "app/session/wording/messages.hpp"

/// Actions that need stories. If the stories are short, an action is done at once; else it is started again
/// when they have been computed.
namespace jw::host {

Storyteller Host::storyteller() {
    return [this](const std::shared_ptr<const Lesson>& lesson, const StoryOptions& how) {
        return telling_.tell(lesson, how);
    };
}

/// Carries out `act`, which may need stories, after all actions that already wait. If `act` throws
/// NotToldYet, it is called again later: it must have changed nothing, or remember how far it came.
void Host::attempt(std::function<void()> act) {
    waiting_.push_back(std::move(act));
    if (waiting_.size() == 1) { go_on_waiting(); }
}

void Host::go_on_waiting() {
    while (!waiting_.empty()) {
        telling_.begin();
        try {
            waiting_.front()();
        } catch (const NotToldYet&) {
            hand_.let_go();
            notice_.hush();
            return rouse();
        } catch (const std::exception& error) {
            // the lesson is unchanged
            const bool memory = dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
            say(tr("This could not be done: {0}", memory ? tr("out of memory") : error.what()));
        }
        waiting_.pop_front();
        telling_.forget();
    }
    if (pulled_) { apply(*std::exchange(pulled_, std::nullopt)); }
}

void Host::give_up_waiting() {
    if (!is_telling()) { return; }
    waiting_.clear();
    pulled_.reset();
    telling_.forget();
    rouse();
}

void Host::stop_telling() {
    give_up_waiting();
    say(tr("Stopped."));
}

void Host::wait_for_story() {
    ImGui::SetCurrentContext(context_);
    while (is_telling()) {
        telling_.wait();
        go_on_waiting();
    }
}

}  // namespace jw::host
