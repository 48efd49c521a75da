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

using panels::Box;

constexpr float kBarHeight = 56.0F;
constexpr float kTabsHeight = 36.0F;
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
    picture_of_ = 0;
    tabs_ = {.price = PriceTab(path)};  // what they remember is of the lesson before
    for (const std::string& text : experiments) { say(jw::carry_out(*session_, text).said); }
    if (const std::optional<int> step = step_at(session_->story(), at)) { session_->apply(GoTo{*step}); }
    fit_camera(true);
    settle_ = 2;
    return true;
}

void Host::show_browser() {
    state_.browser = true;
    state_.search.clear();
    entries_ = refreshed_catalogue();
    settle_ = 2;
}

void Host::resize(int width, int height) {
    width_ = std::max(kSmallestWidth, width);
    height_ = std::max(kSmallestHeight, height);
    load_fonts();
    set_layout();
    if (session_ && hand_.is_own()) { fit_camera(true); }
    settle_ = 2;
}

void Host::load_fonts() {
    // eighths: a window that is being resized does not build fonts for every pixel
    const float wanted = std::clamp(panels::scale_of(width_, height_) * state_.text_scale, 0.5F, 3.0F);
    const float scale = std::max(0.5F, std::floor(wanted * 8.0F + 0.01F) / 8.0F);
    if (scale == scale_) { return; }
    ImGui::SetCurrentContext(context_);
    try {
        fonts_ = render::load_fonts(scale);
    } catch (const std::runtime_error& error) {
        if (fonts_version_ == 0) { throw; }
        // the letters that are there stay
        return say(std::string("The text stays as large as it is: ") + error.what());
    }
    scale_ = scale;
    ++fonts_version_;
    set_style(ImGui::GetStyle(), scale, state_.dark);
}

void Host::set_layout() {
    Box window{0.0F, 0.0F, static_cast<float>(width_), static_cast<float>(height_)};
    const float bar = std::round(kBarHeight * scale_);
    bar_ = {0.0F, window.height - bar, window.width, bar};
    window.height -= bar;
    layout_ = panels::layout_in(window, scale_, std::round(kTabsHeight * scale_));
}

double Host::scene_size() const { return std::max(1e-9, session_->style().bounds.diagonal()); }

void Host::fit_camera(bool at_once) {
    fitted_ = session_->told();
    hand_.show(camera_of(session_->story(), session_->style(), layout_.scene, layout_.scene_safe), at_once);
}

void Host::frame(double seconds) {
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(width_), static_cast<float>(height_)};
    if (!session_ && entries_.empty() && !state_.browser) { show_browser(); }
    io.DeltaTime = static_cast<float>(std::clamp(seconds, 1e-4, 0.25));
    settle_ = events_.empty() ? std::max(0, settle_ - 1) : 2;
    take_events();
    if (std::exchange(new_text_scale_, false)) { resize(width_, height_); }
    ImGui::NewFrame();
    draw_interface();
    ImGui::Render();
    advance(seconds);
    // what was drawn in a hurry is drawn well when it rests
    if (was_moving_ && !is_moving()) { settle_ = 2; }
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
