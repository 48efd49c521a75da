#include "app/host/host.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <imgui.h>

#include "app/host/parts/browser.hpp"
#include "app/host/ui/widgets.hpp"
#include "app/panels/parts/characters.hpp"
#include "app/session/output/describe.hpp"
#include "app/session/output/json.hpp"
#include "app/session/story/timeline.hpp"
#include "app/session/try/carry_out.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/shown_lesson.hpp"
#include "lessons/lesson/in_language.hpp"

namespace jw::host {

namespace {

// a window manager may ask for a smaller window: then the picture is cut off
constexpr int kSmallestWidth = 320;
constexpr int kSmallestHeight = 200;
// time between two checks of a measurement [s]: short enough to follow its progress, and cheap
constexpr double kMeasuring = 0.25;
// time between two frames while a story is computed [s]: without threads, drawing delays the computation
constexpr double kTelling = 0.2;
// time between two checks of an exercise in preparation, or of a search [s]: too short to be noticed
constexpr double kDrawingNumbers = 0.05;

/// Distance that a key scrolls the list of keys, in parts of its visible height; 0: none.
float way_of(Key key) {
    switch (key) {
        case Key::down: return 0.2F;
        case Key::up: return -0.2F;
        case Key::page_down: return 0.9F;
        case Key::page_up: return -0.9F;
        default: return 0.0F;
    }
}

// a screen reader reads line by line: lines must not be long
constexpr int kDescribedWidth = 100;

/// Words of the tab, and of the step unless the figure of an exercise is shown: the lesson must not give away
/// the answer.
std::string text_of(const Host& host) {
    std::string text;
    if (host.state().tab == Tab::exercises) { text = host.exercise_text() + '\n'; }
    return host.shows_figure() ? text : text + describe(host.session()->view(), kDescribedWidth);
}

}  // namespace

Host::Host(const HostSetup& setup)
    : context_(ImGui::CreateContext()),
      fonts_(setup.load_fonts),
      shelf_(setup.catalogue, setup.recent_file),
      unsaved_(setup.unsaved),
      pictures_(setup.pictures),
      desk_({setup.catalogue, setup.progress, setup.judge_program}, setup.programs) {
    // a new context does not become current if there already is a current one
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    map_keys(io);
    state_.tab = setup.tab;
    state_.dark = setup.dark;
    state_.text_scale = setup.text_scale;
    state_.has_disk = setup.has_disk;
    state_.not_offered = setup.not_offered;
    fonts_.need(panels::characters_of_messages());
    resize(setup.width, setup.height, setup.density);
}

Host::~Host() { ImGui::DestroyContext(context_); }

bool Host::open(
    const std::filesystem::path& path, const std::string& at, const std::vector<std::string>& experiments) {
    give_up_waiting();
    LessonFile file(path);
    const ReadResult read = file.read();
    notice_.blame(read.lesson ? "" : read.report());
    if (!read.lesson) { return false; }
    // listed as a recent lesson even if its story is cancelled
    shelf_.add_recent(path);
    attempt([this, file, lesson = shown_lesson(*read.lesson), at, experiments] {
        auto session = std::make_unique<Session>(lesson, true, storyteller());
        std::string said;
        for (const std::string& text : experiments) {
            const ExperimentResult result = jw::carry_out(*session, text);
            if (!result.said.empty()) { said = result.said; }
        }
        take(file, std::move(session));
        say(said);
        if (const std::optional<int> step = step_at(session_->story(), at)) { session_->apply(GoTo{*step}); }
        fit_camera(true);
    });
    return true;
}

/// Replaces the open lesson by another one.
void Host::take(LessonFile file, std::unique_ptr<Session> session) {
    keep_unsaved();
    unsaved_.begin_anew();
    session_ = std::move(session);
    file_ = std::move(file);
    const std::filesystem::path path = file_.path();
    name_ = shelf_.name_of(path);
    shelf_.add_recent(path);
    need_characters_of_lesson();
    state_.browser = false;
    state_.forget_lesson();
    shown_.forget_session();
    hand_.let_go();
    pulled_.reset();
    tabs_ = {.price = PriceTab(path)};  // the old ones keep state of the previous lesson
    desk_.open(path);
    rouse();
}

bool Host::look_at_file() {
    if (is_telling() || !file_.is_saved_anew()) { return false; }
    ImGui::SetCurrentContext(context_);
    const ReadResult read = file_.read();
    rouse();
    notice_.blame(read.lesson ? "" : read.report());
    if (!read.lesson) { return true; }
    attempt([this, lesson = shown_lesson(*read.lesson)] {
        session_->replace(lesson);
        need_characters_of_lesson();
        desk_.follow_file(file_, tabs_.exercises);
        state_.forget_pointed();
        state_.playback.leave_freedom();
        if (hand_.is_own()) { fit_camera(true); }
        say(tr("The file has changed: this is the same step of its new version."));
    });
    return true;
}

void Host::keep_unsaved() {
    // changes to the lesson of an exercise are kept with the exercise
    if (!session_ || desk_.has_aside()) { return; }
    const std::string problem = unsaved_.keep(*session_, file_.path().stem().string());
    if (!problem.empty()) { say(tr("Unsaved experiments will be lost when the program ends: {0}", problem)); }
}

void Host::need_characters_of_lesson() {
    fonts_.need(panels::characters_of(session_->lesson()));
    const std::set<char32_t>& needed = fonts_.needed();
    if (std::exchange(told_of_font_, told_of_font_ || !needed.empty())) { return; }
    // a web page brings its own fonts: advice to install some would be useless
    if (state_.has_disk) { say(panels::advice_for(std::u32string(needed.begin(), needed.end()))); }
}

/// Reads again which lessons there are.
void Host::refresh_shelf() {
    shelf_.refresh(unsaved_.others());
    for (const CatalogueEntry& entry : shelf_.entries()) {
        fonts_.need(
            panels::characters_in(entry.chapter + entry.heading + entry.title + entry.source + entry.text));
    }
}

void Host::need_characters_of_exercises() {
    const std::vector<PracticeExercise>& exercises = desk_.practice().exercises();
    const std::shared_ptr<const Exercise> first = exercises.empty() ? nullptr : exercises.front().exercise;
    if (first == std::exchange(known_exercise_, first)) { return; }
    for (const PracticeExercise& practice : exercises) {
        std::string texts;
        for_each_text(*practice.exercise, [&](const Text& text) { texts += text; });
        fonts_.need(panels::characters_in(texts));
    }
}

void Host::resize(int width, int height, float density) {
    width = std::max(kSmallestWidth, width);
    height = std::max(kSmallestHeight, height);
    const float scale = panels::scale_on_screen(width, height, {density, state_.text_scale});
    ImGui::SetCurrentContext(context_);
    // a screen whose density is known may be a phone
    const auto atlas = density > 0.0F ? render::AtlasSize::small : render::AtlasSize::usual;
    if (!fonts_.fit(scale)) { say(fonts_.load(scale, atlas)); }
    const panels::Box whole{0.0F, 0.0F, static_cast<float>(width), static_cast<float>(height)};
    layout_ = {
        panels::layout_in(whole, panels::FrameKind::window, fonts_.scale(), density), width, height, density,
        whole};
    set_style(ImGui::GetStyle(), fonts_.scale(), state_.dark, layout_.for_fingers);
    if (session_ && hand_.is_own()) { fit_camera(true); }
    rouse();
}

void Host::frame(double seconds) {
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(layout_.width), static_cast<float>(layout_.height)};
    io.DeltaTime = static_cast<float>(std::clamp(seconds, 1e-4, 0.25));
    if (!session_ && shelf_.entries().empty() && !state_.browser) { show_or_leave_browser(); }
    settle_ = events_.empty() ? std::max(0, settle_ - 1) : 2;
    if (is_telling() && telling_.is_done()) { go_on_waiting(); }
    for (const InputEvent& event : events_.take()) {
        feed(io, event);
        if (!is_telling()) {
            act_on(event);
        } else if (event.key == Key::escape && event.down) {
            stop_telling();
        }
    }
    need_characters_of_exercises();
    if (std::exchange(new_text_scale_, false) || fonts_.lack_characters()) {
        resize(layout_.width, layout_.height, layout_.density);
    }
    if (!is_telling()) { look_at_exercises(); }
    if (session_ && !has_tab(session_->lesson(), state_.tab)) { state_.tab = Tab::step; }
    ImGui::NewFrame();
    draw_interface();
    ImGui::Render();
    advance(seconds);
    // a picture that was drawn fast while it moved is drawn in full quality at rest
    if (was_moving_ && !is_moving()) { rouse(); }
    was_moving_ = is_moving();
}

void Host::act_on(const InputEvent& event) {
    const bool is_key = event.kind == InputEvent::Kind::key && event.down;
    if (!is_key && event.kind != InputEvent::Kind::text) { return; }
    if (state_.help) {
        if (const float way = way_of(event.key); is_key && way != 0.0F) {
            state_.sheet.wanted += way;
            return;
        }
        state_.help = false;
        return;
    }
    Requests requests;
    if (state_.browser && act_in_browser(event, shelf_, requests)) { return carry_out(std::move(requests)); }
    if (state_.panel_keys && act_in_panel(event, state_)) { return; }
    const ImGuiIO& io = ImGui::GetIO();
    // while the user types into a field, letters are not commands
    if (io.WantTextInput) { return; }
    if (act_in_exercises(event)) { return; }
    if (const CommandInfo* info = command_for(event, io.KeyCtrl)) { carry_out(info->command); }
}

void Host::advance(double seconds) {
    if (hand_.advance(seconds)) { rouse(); }
    if (notice_.advance(seconds)) { rouse(); }
    if (!shows_lesson() || is_telling()) { return; }
    if (const auto step = state_.playback.step_after(seconds, *session_)) { apply(GoTo{*step}); }
    if (const auto pose = state_.playback.freedom_after(seconds)) {
        rouse();
        const std::string refused = session_->apply(*pose);
        if (!refused.empty()) { state_.playback.leave_freedom(); }
        say(refused);
    }
    if (state_.tab == Tab::rest && tabs_.rest.advance(*session_, seconds * state_.playback.speed())) {
        rouse();
    }
}

double Host::seconds_to_change() const {
    if (!events_.empty() || settle_ > 0 || task_ != DrawingTask::none) { return 0.0; }
    double due = notice_.seconds_left();
    if (is_telling()) { return telling_.is_done() ? 0.0 : std::min(due, kTelling); }
    if (!shows_lesson()) { return due; }
    if (tabs_.price.is_measuring()) { due = std::min(due, kMeasuring); }
    if (state_.tab == Tab::newton && tabs_.newton.is_comparing()) { return 0.0; }
    if (state_.tab == Tab::exercises && tabs_.exercises.is_handing_over()) { return 0.0; }
    const bool searches = state_.tab == Tab::rest && tabs_.rest.is_searching();
    if (searches && tabs_.rest.has_news()) { return 0.0; }
    if (desk_.is_busy() || searches) { due = std::min(due, kDrawingNumbers); }
    if (swings()) { due = std::min(due, kMoving); }
    return std::min(due, state_.playback.seconds_to_change(*session_));
}

void Host::say(const std::string& message) {
    if (message.empty()) { return; }
    notice_.say(message);
    rouse();
}

std::filesystem::path Host::task_path() const {
    return free_name(pictures_, file_.path(), suffix_of(task_, session_->index()));
}

void Host::done(const std::string& message) {
    task_ = DrawingTask::none;
    say(message);
}

std::string state_text(const Host& host) {
    Json json;
    json["shows_lesson"] = host.shows_lesson();
    json["language"] = language();
    json["dark"] = host.state().dark;
    json["text_scale"] = host.state().text_scale;
    json["notice"] = host.is_telling() ? words_of_waiting() : host.notice().text();
    json["mistakes"] = host.notice().mistakes();
    if (host.is_telling()) { json["told_part"] = host.told_part(); }
    if (!host.shows_lesson()) { return json.dump(); }
    const Session& session = *host.session();
    json["title"] = session.lesson().title;
    json["file"] = session.lesson().file_name;
    json["changed"] = session.is_changed();
    json["in_hand"] = session.in_hand();
    json["tried"] = session.tried();
    json["step"] = session.index();
    json["tab"] = word_of(kTabs, host.state().tab);
    const render::Camera& camera = host.camera();
    json["camera"] = Json::array();
    for (const render::Vector3d& part : {camera.eye, camera.target, camera.up}) {
        for (int k = 0; k < 3; ++k) { json["camera"].push_back(part(k)); }
    }
    json["text"] = text_of(host);
    return json.dump();
}

}  // namespace jw::host
