#include "app/web/page.hpp"

#include <algorithm>
#include <array>
#include <iostream>
#include <limits>
#include <utility>

#include <imgui.h>

#include "app/host/lesson/address.hpp"
#include "app/session/output/json.hpp"
#include "app/session/wording/messages.hpp"
#include "app/web/browser.hpp"
#include "lessons/files/catalogue.hpp"
#include "lessons/read/reader.hpp"

namespace jw::web {

namespace {

namespace fs = std::filesystem;

const fs::path kDownloads = "/downloads";  // files here are offered as downloads
const fs::path kKept = "/kept";            // files that outlive a visit: page.js keeps this folder

host::HostSetup host_setup(const PageSetup& setup) {
    set_language(setup.language);
    fs::create_directories(kDownloads);
    fs::create_directories(kKept);
    host::HostSetup wanted;
    wanted.catalogue = catalogue_folder();
    wanted.recent_file = kKept / "recent";
    wanted.unsaved = kKept / "unsaved";
    wanted.pictures = kDownloads;
    wanted.progress = kKept / "progress.json";
    wanted.programs = kDownloads;
    wanted.has_disk = false;
    // the browser uses their keys itself
    wanted.not_offered = {host::Command::next_tab, host::Command::reload, host::Command::quit};
    wanted.dark = setup.dark;
    wanted.text_scale = setup.text_scale;
    wanted.width = setup.width;
    wanted.height = setup.height;
    wanted.density = setup.density;
    return wanted;
}

std::string clipboard;

void use_clipboard() {
    ImGuiIO& io = ImGui::GetIO();
    io.SetClipboardTextFn = [](void*, const char* text) {
        clipboard = text;
        copy(clipboard);
    };
    io.GetClipboardTextFn = [](void*) { return clipboard.c_str(); };
}

/// Pixel of the canvas where the letter that is typed next will appear.
std::array<int, 2> next_letter{};

constexpr std::array kWords{
    tr_later("Lessons"),
    tr_later("Step back"),
    tr_later("Next step"),
    tr_later("Play"),
    tr_later("Fit"),
    tr_later("Undo"),
    tr_later("Redo"),
    tr_later("Edit the text"),
    tr_later("Copy link"),
    tr_later("Text of the step"),
    tr_later("Full screen"),
    tr_later("Keys"),
    tr_later("Stop"),
    tr_later("Open …"),
    tr_later("Save"),
    tr_later("Close"),
    tr_later("A link to what you see was copied."),
    tr_later("The browser does not let this page write to the clipboard."),
    tr_later("Reload the page to see the letters of this language."),
    tr_later("The graphics card is not available at the moment; waiting for it."),
    tr_later(
        "The browser cannot store more: its storage is full or not allowed. Save what you need as a file."),
    tr_later("The list of lessons is shown. Arrows choose, Enter opens."),
};

}  // namespace

Page::Page(const PageSetup& setup) : canvas_(setup.canvas), host_(host_setup(setup)) {
    use_clipboard();
    ImGui::GetIO().ImeSetInputScreenPosFn = [](int x, int y) { next_letter = {x, y}; };
    if (!canvas_.empty()) { restore_context(); }
}

Page::~Page() = default;

double Page::frame(double seconds) {
    const bool is_lost = !screen_ && !canvas_.empty();
    if (is_lost) { return std::numeric_limits<double>::infinity(); }
    host_.look_at_file();
    // with background work, turns come more often than pictures
    since_frame_ += seconds;
    if (since_frame_ >= host_.seconds_to_change()) {
        host_.frame(std::exchange(since_frame_, 0.0));
        if (screen_ && screen_->draw()) { screen_->show(); }
        give_downloads();
    }
    return std::max(0.0, host_.seconds_to_change() - since_frame_);
}

void Page::lose_context() { screen_.reset(); }

void Page::restore_context() {
    context_ = make_webgl_context(canvas_.c_str());
    screen_ = std::make_unique<host::GuardedScreen>(context_->gl(), host_, std::cerr);
    host_.rouse();
}

void Page::give_downloads() const {
    for (const fs::directory_entry& entry : fs::directory_iterator(kDownloads)) {
        download(entry.path());
        fs::remove(entry.path());
    }
}

std::string Page::address() const { return host::fragment_of(host_.address()); }

void Page::go_to(const std::string& address) { host_.go_to(host::read_address(address)); }

std::string Page::lesson_source() const {
    if (host_.session() == nullptr) { return {}; }
    if (host_.session()->is_changed()) { return host::text_to_save(*host_.session()); }
    return read_lesson_file(host_.lesson_path()).source;
}

void Page::follow(const fs::path& file) {
    // an open file is checked before every picture
    if (file == host_.lesson_path() && host_.shows_lesson()) { return host_.rouse(); }
    const std::string at =
        host_.shows_lesson() ? std::to_string(host_.session()->index() + 1) : std::string();
    host_.open(file, at);
}

std::string Page::state() const { return host::state_text(host_); }

void Page::set_clipboard(const std::string& text) { clipboard = text; }

std::string Page::typing_place() const {
    if (!ImGui::GetIO().WantTextInput) { return {}; }
    return std::to_string(next_letter[0]) + ' ' + std::to_string(next_letter[1]);
}

std::string mistakes_of(const std::string& text, const std::string& file_name) {
    Json list = Json::array();
    for (const Diagnostic& mistake : read_lesson(text, file_name).diagnostics) {
        list.push_back(
            {{"line", std::max(1, static_cast<int>(mistake.span.line))},
             {"column", std::max(1, static_cast<int>(mistake.span.column))},
             {"severity", mistake.severity == Severity::error ? "error" : "warning"},
             {"message", mistake.message + (mistake.hint.empty() ? "" : "\n" + mistake.hint)}});
    }
    return json_document(list);
}

std::string words_of_page() {
    Json words = Json::object();
    for (const char* english : kWords) { words[english] = tr(english); }
    return json_document(words, -1);
}

}  // namespace jw::web
