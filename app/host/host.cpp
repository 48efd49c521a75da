#include "app/host/host.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <imgui.h>

#include "app/host/lesson/timeline.hpp"
#include "app/host/parts/browser.hpp"
#include "app/host/ui/widgets.hpp"
#include "app/session/picture/picture_camera.hpp"
#include "app/session/try/carry_out.hpp"
#include "lessons/reader.hpp"

namespace jw::host {

namespace {

// a window manager may ask for less than the window offers: there the picture is cut
constexpr int kSmallestWidth = 320;
constexpr int kSmallestHeight = 200;

}  // namespace

Host::Host(HostSetup setup)
    : setup_(std::move(setup)),
      context_(ImGui::CreateContext()),
      recent_(setup_.recent_file),
      unsaved_(setup_.unsaved) {
    // creating does not make it the current one if there is another
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    map_keys(io);
    state_.dark = setup_.dark;
    state_.text_scale = setup_.text_scale;
    resize(setup_.width, setup_.height);
}

Host::~Host() { ImGui::DestroyContext(context_); }

bool Host::open(
    const std::filesystem::path& path, const std::string& at, const std::vector<std::string>& experiments) {
    const ReadResult read = read_lesson_file(path);
    if (!read.lesson) {
        file_errors_ = read.report();
        return false;
    }
    file_errors_.clear();
    std::error_code error;
    saved_ = std::filesystem::last_write_time(path, error);
    auto session = std::make_unique<Session>(*read.lesson);
    keep_unsaved();
    unsaved_.begin_anew();
    session_ = std::move(session);
    path_ = path;
    recent_.add(path);
    state_.browser = false;
    state_.playback.stop();
    state_.pointed_at = {};
    state_.experiment_joint = -1;
    state_.experiment_driver = 0;
    shown_.forget_session();
    tabs_ = {.price = PriceTab(path)};  // what they remember is of the lesson before
    for (const std::string& text : experiments) { say(jw::carry_out(*session_, text).said); }
    if (const std::optional<int> step = step_at(session_->story(), at)) { session_->apply(GoTo{*step}); }
    fit_camera(true);
    rouse();
    return true;
}

void Host::show_browser() {
    state_.browser = true;
    state_.search.clear();
    entries_ = refreshed_catalogue();
    rouse();
}

void Host::resize(int width, int height) {
    width = std::max(kSmallestWidth, width);
    height = std::max(kSmallestHeight, height);
    load_fonts(panels::scale_of(width, height) * state_.text_scale);
    layout_ = window_layout(width, height, fonts_.scale());
    if (session_ && hand_.is_own()) { fit_camera(true); }
    rouse();
}

void Host::load_fonts(float scale) {
    if (fonts_.fit(scale)) { return; }
    ImGui::SetCurrentContext(context_);
    say(fonts_.load(scale));
    set_style(ImGui::GetStyle(), fonts_.scale(), state_.dark);
}

void Host::fit_camera(bool at_once) {
    hand_.show(camera_of(session_->story(), session_->style(), layout_.scene, layout_.scene_safe), at_once);
}

void Host::frame(double seconds) {
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(layout_.width), static_cast<float>(layout_.height)};
    if (!session_ && entries_.empty() && !state_.browser) { show_browser(); }
    io.DeltaTime = static_cast<float>(std::clamp(seconds, 1e-4, 0.25));
    settle_ = events_.empty() ? std::max(0, settle_ - 1) : 2;
    take_events();
    if (std::exchange(new_text_scale_, false)) { resize(layout_.width, layout_.height); }
    ImGui::NewFrame();
    draw_interface();
    ImGui::Render();
    advance(seconds);
    // what was drawn in a hurry is drawn well when it rests
    if (was_moving_ && !is_moving()) { rouse(); }
    was_moving_ = is_moving();
}

bool Host::is_moving() const { return shows_lesson() && (hand_.is_busy() || state_.playback.is_moving()); }

void Host::take_events() {
    ImGuiIO& io = ImGui::GetIO();
    for (const InputEvent& event : events_.take()) {
        feed(io, event);
        act_on(event);
    }
}

void Host::act_on(const InputEvent& event) {
    const bool is_key = event.kind == InputEvent::Kind::key && event.down;
    if (!is_key && event.kind != InputEvent::Kind::text) { return; }
    if (state_.help) {
        state_.help = false;
        return;
    }
    if (state_.browser && act_in_browser(event)) { return; }
    if (state_.panel_keys && act_in_panel(event)) { return; }
    // while somebody types, letters are letters
    if (ImGui::GetIO().WantTextInput) { return; }
    Modifiers modifiers;
    modifiers.ctrl = ImGui::GetIO().KeyCtrl;
    modifiers.shift = ImGui::GetIO().KeyShift;
    if (const CommandInfo* info = command_for(event, modifiers)) { carry_out(info->command); }
}

bool Host::act_in_panel(const InputEvent& event) {
    if (event.kind != InputEvent::Kind::key) { return false; }
    if (event.key == Key::escape) {
        if (!ImGui::GetIO().WantTextInput) { use_panel_keys(false); }
        return true;
    }
    // ImGui moves among its widgets
    constexpr std::array moving{Key::left, Key::right, Key::up, Key::down, Key::space, Key::enter, Key::tab};
    return std::ranges::find(moving, event.key) != moving.end();
}

bool Host::act_in_browser(const InputEvent& event) {
    if (event.kind == InputEvent::Kind::text) {
        // letters search, wherever the keyboard is; the field takes its own
        const bool letter = event.character > ' ' && event.character < 127 && event.character != '?';
        if (!letter || ImGui::GetIO().WantTextInput) { return ImGui::GetIO().WantTextInput; }
        state_.search += static_cast<char>(event.character);
        state_.chosen_lesson = -1;
        return true;
    }
    const Key key = event.key;
    if (key == Key::left || key == Key::up) {
        move_choice(state_, entries_, -1);
    } else if (key == Key::right || key == Key::down) {
        move_choice(state_, entries_, 1);
    } else if (key == Key::backspace) {
        if (!ImGui::GetIO().WantTextInput && !state_.search.empty()) { state_.search.pop_back(); }
    } else if (key == Key::escape) {
        leave_search_or_browser();
    } else if (key == Key::enter) {
        open_chosen_lesson();
    } else {
        return false;
    }
    return true;
}

void Host::leave_search_or_browser() {
    if (!state_.search.empty()) {
        state_.search.clear();
    } else if (session_) {
        state_.browser = false;
    }
}

void Host::open_chosen_lesson() {
    if (state_.chosen_lesson < 0) { move_choice(state_, entries_, 1); }
    if (state_.chosen_lesson >= 0) { open(entries_[static_cast<std::size_t>(state_.chosen_lesson)].path); }
}

}  // namespace jw::host
