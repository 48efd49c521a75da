#include <algorithm>
#include <array>
#include <new>

#include <imgui.h>

#include "app/host/host.hpp"
#include "app/host/lesson/timeline.hpp"
#include "app/host/ui/widgets.hpp"
#include "lessons/reader.hpp"

namespace jw::host {

namespace {

// an open file is looked at this often
constexpr double kIdle = 0.5;
// between two looks at a measurement: fast enough to be watched, and it costs next to nothing
constexpr double kMeasuring = 0.25;
constexpr float kSmallestText = 0.75F;
constexpr float kLargestText = 1.5F;
constexpr float kTextStep = 0.125F;

bool needs_lesson(Command command) {
    constexpr std::array always{Command::dark,    Command::larger_text, Command::smaller_text,
                                Command::lessons, Command::help,        Command::quit};
    return std::ranges::find(always, command) == always.end();
}

Tab tab_after(Tab tab) {
    const auto* const now = std::ranges::find(kTabs, tab, &EnumWord<Tab>::value);
    return now + 1 == kTabs.end() ? kTabs.front().value : (now + 1)->value;
}

}  // namespace

void Host::carry_out(Requests requests) {
    if (requests.lit_rows != state_.lit_rows) {
        state_.lit_rows = std::move(requests.lit_rows);
        rouse();
    }
    for (const Experiment& experiment : requests.experiments) { apply(experiment); }
    for (const Command command : requests.commands) { carry_out(command); }
    if (requests.copy) { copy(*requests.copy, "Copied."); }
    if (requests.open) { open(*requests.open); }
}

void Host::apply(const Experiment& experiment) {
    if (!session_) { return; }
    const std::uint64_t told = session_->told();
    const std::uint64_t version = session_->version();
    try {
        say(session_->apply(experiment));
    } catch (const std::exception& error) {
        // the lesson is as it was before
        const bool memory = dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
        say(std::string("This could not be done: ") + (memory ? "out of memory" : error.what()));
    }
    if (session_->version() != version) { rouse(); }
    if (session_->told() != told) {
        state_.playback.leave_freedom();
        forget_what_is_pointed_at();
    }
}

/// What was pointed at need not be there in another lesson.
void Host::forget_what_is_pointed_at() {
    state_.pointed_at = {};
    state_.lit_rows.clear();
}

void Host::go_to(int step) {
    state_.playback.begin_step();
    apply(GoTo{step});
}

void Host::carry_out(Command command) {
    rouse();
    if (needs_lesson(command) && !shows_lesson()) { return; }
    switch (command) {
        case Command::next: state_.playback.pause(); return go_to(session_->index() + 1);
        case Command::back: state_.playback.pause(); return go_to(session_->index() - 1);
        case Command::play: return play_or_pause();
        case Command::next_joint: return go_to(step_of_next_joint(session_->story(), session_->index(), 1));
        case Command::previous_joint:
            return go_to(step_of_next_joint(session_->story(), session_->index(), -1));
        case Command::first: return go_to(0);
        case Command::last: return go_to(last_step(session_->story()));
        case Command::faster: return state_.playback.faster();
        case Command::slower: return state_.playback.slower();
        case Command::tab_step: state_.tab = Tab::step; return;
        case Command::tab_experiments: state_.tab = Tab::experiments; return;
        case Command::tab_plot: state_.tab = Tab::plot; return;
        case Command::tab_newton: state_.tab = Tab::newton; return;
        case Command::tab_price: state_.tab = Tab::price; return;
        case Command::next_tab: state_.tab = tab_after(state_.tab); return;
        case Command::panel_keys: return use_panel_keys(!state_.panel_keys);
        case Command::undo: return apply(Undo{});
        case Command::redo: return apply(Redo{});
        case Command::start_over: return apply(StartOver{});
        case Command::play_freedom: return next_freedom();
        case Command::let_go: return let_go();
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
        case Command::lessons: return show_or_leave_browser();
        case Command::reload:
            saved_ = {};
            look_at_file();
            return;
        case Command::save_picture: task_ = Task::save_picture; return;
        case Command::record: task_ = Task::record; return;
        case Command::save_lesson: return save_lesson();
        case Command::copy_equation:
        case Command::copy_matrix:
        case Command::copy_matrix_csv: return copy_view(command);
        case Command::save_csv: return save_csv();
        case Command::help: state_.help = !state_.help; return;
        case Command::quit: close_ = true; return;
    }
}

void Host::play_or_pause() {
    state_.playback.play_or_pause();
    if (state_.playback.plays() && session_->index() == last_step(session_->story())) { go_to(0); }
}

void Host::let_go() {
    task_ = Task::none;
    state_.playback.leave_freedom();
    file_errors_.clear();
    apply(LetGo{});
}

void Host::change_tone() {
    state_.dark = !state_.dark;
    set_style(ImGui::GetStyle(), fonts_.scale(), state_.dark);
    shown_.redraw();
}

void Host::change_text(float by) {
    state_.text_scale = std::clamp(state_.text_scale + by, kSmallestText, kLargestText);
    new_text_scale_ = true;
}

void Host::show_or_leave_browser() {
    if (state_.browser && !session_) { return; }
    state_.playback.pause();
    if (state_.browser) {
        state_.browser = false;
    } else {
        show_browser();
    }
}

void Host::use_panel_keys(bool on) {
    ImGuiIO& io = ImGui::GetIO();
    state_.panel_keys = on;
    if (on) {
        io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
        if (state_.tab == Tab::step) { state_.tab = Tab::experiments; }
        ImGui::SetWindowFocus(area_of(state_.tab));
        say("The arrows move in the panel, Space presses, Enter types a number; Escape returns.");
    } else {
        io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
        ImGui::SetWindowFocus(nullptr);
    }
}

void Host::next_freedom() {
    const auto count = static_cast<int>(session_->rank().free_motions.size());
    if (count == 0) { return say("Nothing is free here: there is no motion to follow."); }
    state_.playback.follow((state_.playback.freedom() + 1) % count);
    apply(LetGo{});
}

void Host::advance(double seconds) {
    if (hand_.advance(seconds)) { rouse(); }
    if (notice_.advance(seconds)) { rouse(); }
    if (!shows_lesson()) { return; }
    if (const auto step = state_.playback.step_after(seconds, *session_)) { apply(GoTo{*step}); }
    if (const auto pose = state_.playback.freedom_after(seconds)) {
        rouse();
        const std::string refused = session_->apply(*pose);
        if (!refused.empty()) { state_.playback.leave_freedom(); }
        say(refused);
    }
}

double Host::seconds_to_change() const {
    if (!events_.empty() || settle_ > 0 || task_ != Task::none) { return 0.0; }
    double due = notice_.seconds_left();
    if (!shows_lesson()) { return due; }
    if (tabs_.price.is_measuring()) { due = std::min(due, kMeasuring); }
    return std::min(due, state_.playback.seconds_to_change(*session_));
}

double Host::seconds_to_wait() const { return std::min(seconds_to_change(), kIdle); }

bool Host::is_due(double seconds_since) const { return seconds_since >= seconds_to_change(); }

bool Host::look_at_file() {
    std::error_code error;
    if (path_.empty()) { return false; }
    const auto written = std::filesystem::last_write_time(path_, error);
    if (error || written == saved_) { return false; }
    saved_ = written;
    ImGui::SetCurrentContext(context_);
    const ReadResult read = read_lesson_file(path_);
    rouse();
    if (!read.lesson) {
        file_errors_ = read.report();
        return true;
    }
    file_errors_.clear();
    session_->replace(*read.lesson);
    forget_what_is_pointed_at();
    state_.playback.leave_freedom();
    if (hand_.is_own()) { fit_camera(true); }
    say("The file was saved anew: this is the same step of it.");
    return true;
}

void Host::say(const std::string& message) {
    if (message.empty()) { return; }
    notice_.say(message);
    rouse();
}

void Host::done(const std::string& message) {
    task_ = Task::none;
    say(message);
}

}  // namespace jw::host
