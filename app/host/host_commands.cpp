#include <algorithm>
#include <array>
#include <span>

#include <imgui.h>

#include "app/host/host.hpp"
#include "app/host/ui/widgets.hpp"
#include "app/panels/parts/characters.hpp"
#include "app/session/output/export.hpp"
#include "app/session/picture/picture.hpp"
#include "app/session/story/timeline.hpp"
#include "app/session/try/carry_out.hpp"
#include "app/session/wording/messages.hpp"

namespace jw::host {

namespace {

constexpr float kSmallestText = 0.75F;
constexpr float kLargestText = 1.5F;
constexpr float kTextStep = 0.125F;
constexpr float kPage = 0.5F;  // part of the visible height, for one command

/// Commands of the timeline. A figure has no timeline, and the lesson that it hides stays at its step.
bool is_of_story(Command command) { return command <= Command::slower; }

bool needs_lesson(Command command) {
    constexpr std::array always{Command::dark,     Command::larger_text, Command::smaller_text,
                                Command::language, Command::lessons,     Command::help,
                                Command::quit};
    return std::ranges::find(always, command) == always.end();
}

Tab tab_after(Tab tab, const Lesson& lesson) {
    const auto* next = std::ranges::find(kTabs, tab, &EnumWord<Tab>::value);
    do { next = next + 1 == kTabs.end() ? kTabs.begin() : next + 1; } while (!has_tab(lesson, next->value));
    return next->value;
}

/// @return message for the user, usually empty
std::string scroll_by(Scroll& scroll, float part) {
    if (scroll.most <= 0.0F) { return tr("Everything is visible: there is nothing to scroll."); }
    scroll.wanted += part;
    return {};
}

/// Copies a text to the clipboard. @return `said`
std::string copied(const std::string& text, std::string said) {
    ImGui::SetClipboardText(text.c_str());
    return said;
}

std::string copied(Command command, const View& view) {
    if (command == Command::copy_matrix) {
        return copied(matrix_latex(view.matrix, MatrixStyle::labelled), tr("Φq copied as LaTeX."));
    }
    if (command == Command::copy_matrix_csv) {
        return copied(matrix_csv(view.matrix), tr("Φq copied as CSV."));
    }
    if (view.equations.empty()) { return tr("There is no equation at this step."); }
    return copied(equations_latex(view), tr("The equations copied as LaTeX."));
}

}  // namespace

void Host::carry_out(Requests requests) {
    if (requests.lit_rows != state_.lit_rows) {
        state_.lit_rows = std::move(requests.lit_rows);
        rouse();
    }
    for (const Experiment& experiment : requests.experiments) { apply(experiment); }
    for (const Command command : requests.commands) { carry_out(command); }
    if (requests.trial) { carry_out_trial(*requests.trial); }
    if (requests.show_joint && session_) { show_joint(*requests.show_joint); }
    carry_out_exercises(requests);
    if (requests.copy) { say(copied(*requests.copy, tr("Copied."))); }
    if (requests.open) { open(*requests.open); }
}

void Host::apply(const Experiment& experiment) {
    if (session_) {
        attempt([this, experiment] { try_out(experiment); });
    }
}

void Host::try_out(const Experiment& experiment) {
    const std::uint64_t told = session_->told();
    const std::uint64_t version = session_->version();
    say(session_->apply(experiment));
    if (session_->version() != version) { rouse(); }
    if (session_->told() != told) {
        state_.playback.leave_freedom();
        state_.forget_pointed();
    }
}

void Host::show_joint(int joint) {
    const std::vector<Joint>& joints = session_->lesson().mechanism.joints;
    // the lesson may have been read again since the click began
    if (joint < 0 || static_cast<std::size_t>(joint) >= joints.size()) { return; }
    const std::string name = joints[static_cast<std::size_t>(joint)].name;
    session_->show_joint(joint);
    rouse();
    const bool shown = session_->story().chosen_joint() == joint;
    say(shown ? tr("Vectors and equations of {0}. Click it again for those of the lesson.", name)
              : tr("Vectors and equations as the lesson shows them."));
}

void Host::go_to(int step) {
    state_.playback.begin_step();
    apply(GoTo{step});
}

void Host::carry_out(Command command) {
    rouse();
    if (needs_lesson(command) && !shows_lesson()) { return; }
    if (is_of_story(command) && shows_figure()) { return; }
    switch (command) {
        case Command::next: state_.playback.pause(); return go_to(session_->index() + 1);
        case Command::back: state_.playback.pause(); return go_to(session_->index() - 1);
        case Command::play: return play_or_pause();
        case Command::play_motion: return play_motion();
        case Command::next_joint: return go_to(next_joint(session_->story(), session_->index(), 1));
        case Command::previous_joint: return go_to(next_joint(session_->story(), session_->index(), -1));
        case Command::first: return go_to(0);
        case Command::last: return go_to(last_step(session_->story()));
        case Command::answer: return answer();
        case Command::faster: return state_.playback.faster();
        case Command::slower: return state_.playback.slower();
        case Command::tab_step: state_.tab = Tab::step; return;
        case Command::tab_experiments: state_.tab = Tab::experiments; return;
        case Command::tab_plot: state_.tab = Tab::plot; return;
        case Command::tab_newton: state_.tab = Tab::newton; return;
        case Command::tab_price: state_.tab = Tab::price; return;
        case Command::tab_exercises: state_.tab = Tab::exercises; return;
        case Command::tab_rest:
            if (has_tab(session_->lesson(), Tab::rest)) {
                state_.tab = Tab::rest;
                return;
            }
            return say(
                tr("Only lessons with masses and forces have an equilibrium: this one has no [dynamics]."));
        case Command::next_tab: state_.tab = tab_after(state_.tab, session_->lesson()); return;
        case Command::panel_keys: return say(use_panel_keys(state_, !state_.panel_keys));
        case Command::panel_down: return say(scroll_by(state_.column, kPage));
        case Command::panel_up: return say(scroll_by(state_.column, -kPage));
        case Command::next_symbol: return show_symbol(1);
        case Command::symbol_before: return show_symbol(-1);
        case Command::text_down: return say(scroll_by(state_.caption, kPage));
        case Command::text_up: return say(scroll_by(state_.caption, -kPage));
        case Command::undo: return apply(Undo{});
        case Command::redo: return apply(Redo{});
        case Command::start_over: return apply(StartOver{});
        case Command::play_freedom: return next_freedom();
        case Command::let_go: return let_go();
        case Command::exercise_hint:
        case Command::exercise_solution:
        case Command::exercise_anew:
        case Command::exercise_list: return carry_out_exercise(command);
        case Command::fit: return fit_camera(false);
        case Command::view_front:
        case Command::view_back:
        case Command::view_left:
        case Command::view_right:
        case Command::view_top:
        case Command::view_bottom:
        case Command::view_free:
        case Command::turn_left:
        case Command::turn_right:
        case Command::turn_up:
        case Command::turn_down:
        case Command::zoom_in:
        case Command::zoom_out: return hand_.carry_out(command, layout_.scene, *session_);
        case Command::dark: return change_tone();
        case Command::larger_text: return change_text(kTextStep);
        case Command::smaller_text: return change_text(-kTextStep);
        case Command::language: return use_next_language();
        case Command::lessons: return show_or_leave_browser();
        case Command::reload:
            file_.distrust();
            look_at_file();
            return;
        case Command::save_picture: task_ = DrawingTask::save_picture; return;
        case Command::record: task_ = DrawingTask::record; return;
        case Command::save_lesson: return save_lesson();
        case Command::copy_equation:
        case Command::copy_matrix:
        case Command::copy_matrix_csv: return say(copied(command, session_->view()));
        case Command::save_csv: return save_csv();
        case Command::help: state_.help = !state_.help; return;
        case Command::quit: close_ = true; return;
    }
}

void Host::play_or_pause() {
    state_.playback.play_or_pause();
    if (state_.playback.plays() && session_->index() == last_step(session_->story())) { go_to(0); }
}

void Host::carry_out_trial(int index) {
    rouse();
    // a copy, because the experiments change the lesson
    std::vector<std::string> actions = session_->lesson().trials[static_cast<std::size_t>(index)].actions;
    session_->apply(LetGo{});
    attempt([this, actions = std::move(actions), said = std::string()]() mutable {
        while (!actions.empty()) {
            const ExperimentResult result = jw::carry_out(*session_, actions.front());
            // an experiment that is done must not be repeated after a wait
            actions.erase(actions.begin(), result.done ? actions.begin() + 1 : actions.end());
            said += (said.empty() ? "" : "\n") + result.said;
            state_.playback.leave_freedom();
            state_.forget_pointed();
            say(said);
        }
    });
}

void Host::answer() {
    if (session_->step().kind != Step::Kind::question) { return say(tr("Nothing is asked at this step.")); }
    predictions_.focus();
}

void Host::show_symbol(int by) {
    const std::vector<SymbolView>& symbols = session_->view().symbols;
    const auto texts = std::ranges::count_if(symbols, [](const SymbolView& s) { return s.scope.empty(); });
    const int count = static_cast<int>(texts);
    if (count == 0) { return say(tr("No symbol of this text has a value here.")); }
    // symbols of texts come first; one place in the cycle means that no symbol is chosen
    const int places = count + 1;
    state_.symbol = (state_.symbol + 1 + by + places) % places - 1;
    state_.pointed_at = {};
    rouse();
}

void Host::play_motion() {
    const std::optional<int> first = first_moment(session_->story());
    if (!first) { return say(tr("This lesson has no motion: it ends when the mechanism is assembled.")); }
    go_to(*first);
    state_.playback.play();
}

void Host::let_go() {
    task_ = DrawingTask::none;
    state_.playback.leave_freedom();
    tabs_.rest.show_step();
    state_.symbol = -1;
    notice_.blame("");
    apply(LetGo{});
}

void Host::change_tone() {
    state_.dark = !state_.dark;
    set_style(ImGui::GetStyle(), fonts_.scale(), state_.dark, layout_.for_fingers);
    shown_.redraw();
}

void Host::change_text(float by) {
    state_.text_scale = std::clamp(state_.text_scale + by, kSmallestText, kLargestText);
    new_text_scale_ = true;
}

/// Shows the same step in the next language.
void Host::use_next_language() {
    const std::span<const Language> all = languages();
    const auto present = std::ranges::find(all, language(), &Language::tag);
    const Language& next = present + 1 == all.end() ? all.front() : *(present + 1);
    attempt([this, next = next] {
        const std::string before(language());
        set_language(next.tag);
        try {
            if (session_) { session_->tell_again(); }
        } catch (...) {
            // the language stays until the story has been computed, or for good if that failed
            set_language(before);
            throw;
        }
        fonts_.need(panels::characters_of_messages());
        if (session_) { need_characters_of_lesson(); }
        desk_.practice().tell_again();
        if (state_.browser) { refresh_shelf(); }
        say(tr("Language: {0}", next.name));
    });
}

void Host::show_or_leave_browser() {
    if (state_.browser && !session_) { return; }
    state_.playback.pause();
    state_.browser = !state_.browser;
    if (state_.browser) { refresh_shelf(); }
    rouse();
}

void Host::next_freedom() {
    const auto count = static_cast<int>(session_->rank().free_motions.size());
    if (count == 0) { return say(tr("No freedom is left here: there is no free motion to follow.")); }
    state_.playback.follow((state_.playback.freedom() + 1) % count);
    apply(LetGo{});
}

void Host::fit_camera(bool at_once) {
    if (shows_figure()) {
        return hand_.show(desk_.figure()->camera(layout_.scene, layout_.scene_safe), at_once);
    }
    hand_.show(camera_of(session_->story(), session_->style(), layout_.scene, layout_.scene_safe), at_once);
}

void Host::save_lesson() {
    const Saved saved = host::save_lesson(free_name(pictures_, file_.path(), "-changed.toml"), *session_);
    if (saved.done) { unsaved_.saved(*session_); }
    say(saved.said);
}

void Host::save_csv() {
    const std::string suffix = std::string("-") + tabs_.plot.name() + ".csv";
    say(save_text(free_name(pictures_, file_.path(), suffix), tabs_.plot.csv(*session_)).said);
}

}  // namespace jw::host
