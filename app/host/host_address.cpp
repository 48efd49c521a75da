#include <stdexcept>

#include <imgui.h>

#include "app/host/host.hpp"
#include "app/host/lesson/destination.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/shown_lesson.hpp"
#include "lessons/diagnostics/diagnostics.hpp"

namespace jw::host {

Tab tab_of(const Address& address) {
    if (address.tab.empty()) { return Tab::step; }
    if (const std::optional<Tab> tab = value_of(kTabs, address.tab)) { return *tab; }
    throw std::runtime_error(
        "no tab " + in_quotes(address.tab) + "; expected one of " + comma_list(words_of(kTabs)));
}

Address Host::address() const {
    if (!shows_lesson()) { return {}; }
    Address address;
    address.lesson = name_;
    if (state_.tab != Tab::step) { address.tab = word_of(kTabs, state_.tab); }
    // an exercise has its own numbers, and is not a step of the story
    if (state_.tab == Tab::exercises && desk_.practice().exercise() != nullptr) {
        address.exercise = desk_.practice().exercise()->name;
        address.tab.clear();
    }
    if (!address.exercise.empty() || desk_.has_aside()) { return address; }
    address.experiments = session_->tried();
    if (session_->index() > 0) { address.at = std::to_string(session_->index() + 1); }
    const int joint = session_->story().chosen_joint();
    if (joint >= 0) {
        address.joint = session_->lesson().mechanism.joints[static_cast<std::size_t>(joint)].name;
    }
    if (!shows_figure() && !hand_.is_own() && can_be_told(hand_.goal())) { address.camera = hand_.goal(); }
    return address;
}

bool Host::go_to(const Address& address) {
    ImGui::SetCurrentContext(context_);
    rouse();
    give_up_waiting();
    const auto leads_somewhere = std::make_shared<bool>(true);
    attempt([this, address, leads_somewhere] {
        try {
            arrive_at(address);
            notice_.blame("");
        } catch (const std::exception& error) {
            notice_.blame_address(error.what());
            *leads_somewhere = false;
        }
    });
    return *leads_somewhere;
}

void Host::arrive_at(const Address& address) {
    if (!address.lesson.empty()) { return arrive_in_lesson(address); }
    if (!state_.browser) { show_or_leave_browser(); }
}

/// Goes to an address in a lesson. Steps that can fail come first, so that a failure changes nothing.
void Host::arrive_in_lesson(const Address& address) {
    const Tab tab = address.exercise.empty() ? tab_of(address) : Tab::exercises;
    const std::filesystem::path path = shelf_.lesson_called(address.lesson);
    const Exercise* const begun = desk_.practice().exercise();
    if (begun != nullptr && begun->name == address.exercise && shelf_.name_of(path) == name_) {
        state_.tab = tab;
        state_.browser = false;
        return;
    }
    std::error_code error;
    const bool same =
        session_ && !desk_.has_aside() && std::filesystem::equivalent(path, file_.path(), error);
    Destination place;
    if (!same) {
        LessonFile file(path);
        const ReadResult read = file.read();
        if (!read.lesson) { throw std::runtime_error(read.report()); }
        place = destination_of(shown_lesson(*read.lesson), address, storyteller());
        take(std::move(file), std::move(place.session));
    } else if (session_->tried() != address.experiments) {
        place = destination_of(session_->as_written(), address, storyteller());
        session_->become(std::move(*place.session), tr("another address"));
    } else {
        place.step = step_of(address, session_->story());
        place.joint = joint_of(address, session_->lesson());
    }
    session_->apply(GoTo{place.step});
    if (session_->story().chosen_joint() != place.joint) { session_->show_joint(place.joint); }
    state_.tab = tab;
    if (tab == Tab::exercises) { desk_.practice().leave(); }
    desk_.want(address.exercise);
    state_.browser = false;
    state_.playback.stop();
    state_.forget_pointed();
    fit_camera(true);
    if (address.camera) { hand_.look_through(*address.camera); }
}

}  // namespace jw::host
