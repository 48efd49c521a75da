#include <utility>

#include <imgui.h>

#include "app/host/host.hpp"
#include "app/host/parts/notice.hpp"
#include "app/panels/frame/frame.hpp"
#include "app/session/wording/messages.hpp"

namespace jw::host {

bool Host::shows_figure() const {
    return shows_lesson() && state_.tab == Tab::exercises && desk_.figure() != nullptr;
}

void Host::look_at_exercises() {
    // other tabs do not need the exercises
    if (shows_lesson() && state_.tab == Tab::exercises) { desk_.practice().begin_reading(); }
    const ExerciseDesk::News news = desk_.look(open_lesson(), tabs_.exercises);
    if (news.any || news.other_picture) { rouse(); }
    say(desk_.practice().take_notice());
    if (shows_lesson() && state_.tab == Tab::exercises && !desk_.practice().is_busy()) {
        if (const std::string name = desk_.take_wanted(); !name.empty()) {
            if (!desk_.choose(name)) { notice_.blame_address(tr("the lesson has no exercise '{0}'", name)); }
            rouse();
        }
    }
    if (news.other_picture) {
        shown_.forget_session();
        state_.forget_lesson();
        notice_.blame("");
        tabs_.newton = {};
        tabs_.plot = {};
    }
    if (session_) { desk_.follow_lesson(*session_, tabs_.exercises); }
    if (news.other_picture || shows_figure() != shown_figure_) { fit_camera(true); }
    shown_figure_ = shows_figure();
}

void Host::wait_for_exercises() {
    wait_for_story();
    look_at_exercises();
    while (desk_.is_busy()) {
        desk_.wait();
        frame(1.0 / 60.0);
    }
}

bool Host::begin_exercise(const std::string& name) {
    state_.tab = Tab::exercises;
    wait_for_exercises();
    if (!desk_.choose(name)) { return false; }
    wait_for_exercises();
    return true;
}

bool Host::act_in_exercises(const InputEvent& event) {
    if (state_.tab != Tab::exercises || !shows_lesson() || state_.panel_keys) { return false; }
    // Escape first lets go of a body that is led by hand
    if (event.key == Key::escape && session_->in_hand()) { return false; }
    Requests requests;
    if (!tabs_.exercises.act(event, desk_.practice(), requests)) { return false; }
    carry_out(std::move(requests));
    rouse();
    return true;
}

void Host::carry_out_exercises(const Requests& requests) {
    if (requests.exercise) {
        keep_unsaved();
        desk_.practice().choose(*requests.exercise);
        rouse();
    }
    if (requests.answer) {
        attempt([this, answer = *requests.answer] {
            say(desk_.check(open_lesson(), answer));
            rouse();
        });
    }
    if (requests.starter) { say(desk_.write_starter(*requests.starter)); }
}

void Host::carry_out_exercise(Command command) {
    Practice& practice = desk_.practice();
    state_.tab = Tab::exercises;
    if (practice.chosen() < 0) { return; }
    switch (command) {
        case Command::exercise_hint: return practice.give_hint();
        case Command::exercise_solution: return practice.show_solution();
        case Command::exercise_anew: return practice.draw_anew();
        default: return practice.leave();
    }
}

/// Draws title and caption of an exercise's figure, which is not a step of a story.
void Host::draw_figure(const Ui& ui) {
    View view;
    view.lesson_title = session_->lesson().title;
    view.title = desk_.practice().exercise()->title;
    view.source = desk_.practice().exercise()->source;
    view.sentence =
        tr("This is the scene of the exercise. You can turn it, but the answer cannot be read from it.");
    panels::draw_title(ui.canvas, layout_.title, view);
    panels::draw_caption(ui.canvas, layout_.caption, view);
}

}  // namespace jw::host
