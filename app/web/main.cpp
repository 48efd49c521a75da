#include <emscripten/emscripten.h>

#include <cstdlib>
#include <exception>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "app/session/background/worker.hpp"
#include "app/web/browser.hpp"
#include "app/web/page.hpp"

/// The functions that page.js calls. None of them throws: errors are returned as text.
namespace {

using jw::host::InputEvent;

// time for background work in each turn of the loop [s]
constexpr double kBeside = 0.016;

std::unique_ptr<jw::web::Page> page;
/// Result of the last function call; valid until the next one.
std::string answer;

const char* answered(std::string text) {
    answer = std::move(text);
    return answer.c_str();
}

/// @return why `act` could not be carried out; empty if it was
template <class Act>
const char* problem_of(const Act& act) {
    try {
        act();
        return answered({});
    } catch (const std::exception& error) { return answered(error.what()); }
}

std::vector<std::string> lines_of(const char* text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) { lines.push_back(line); }
    return lines;
}

}  // namespace

extern "C" {

/// @param density  pixels of the canvas per pixel of the page
/// @param lessons  folder of the course
/// @return why the page cannot begin; empty if it does
EMSCRIPTEN_KEEPALIVE const char* jw_begin(
    const char* canvas, int width, int height, double density, double text_scale, int dark,
    const char* language, const char* lessons) {
    return problem_of([&] {
        // folder of the program's catalogue (lessons/files/catalogue.hpp)
        ::setenv("JOINTWISE_LESSONS", lessons, 1);
        page = std::make_unique<jw::web::Page>(jw::web::PageSetup{
            canvas, width, height, static_cast<float>(density), static_cast<float>(text_scale), dark != 0,
            language});
    });
}

/// One turn of the page's loop: Page::frame, and background work.
EMSCRIPTEN_KEEPALIVE double jw_frame(double seconds) {
    try {
        const double due = page->frame(seconds);
        return jw::run_waiting_work(kBeside) ? 0.0 : due;
    } catch (const std::exception& error) {
        jw::web::log(error.what());
        return 1.0;
    }
}

EMSCRIPTEN_KEEPALIVE void jw_resize(int width, int height, double density) {
    page->host().resize(width, height, static_cast<float>(density));
}
EMSCRIPTEN_KEEPALIVE void jw_lose_context() { page->lose_context(); }
EMSCRIPTEN_KEEPALIVE const char* jw_restore_context() {
    return problem_of([] { page->restore_context(); });
}

EMSCRIPTEN_KEEPALIVE void jw_pointer(double x, double y) {
    page->host().push(InputEvent::pointer(static_cast<float>(x), static_cast<float>(y)));
}
EMSCRIPTEN_KEEPALIVE void jw_button(int number, int down) {
    page->host().push(InputEvent::button(number, down != 0));
}
EMSCRIPTEN_KEEPALIVE void jw_wheel(double notches) {
    page->host().push(InputEvent::wheel(static_cast<float>(notches)));
}
/// @return 1 if the program uses this key
EMSCRIPTEN_KEEPALIVE int jw_key(const char* name, int down) {
    const jw::host::Key key = jw::web::key_of(name);
    if (key != jw::host::Key::none) { page->host().push(InputEvent::pressed(key, down != 0)); }
    return key == jw::host::Key::none ? 0 : 1;
}
EMSCRIPTEN_KEEPALIVE void jw_text(unsigned character) { page->host().push(InputEvent::typed(character)); }
EMSCRIPTEN_KEEPALIVE void jw_set_clipboard(const char* text) { page->set_clipboard(text); }
EMSCRIPTEN_KEEPALIVE void jw_leave() { page->host().push(InputEvent::leave()); }

/// Opens a lesson file. @param experiments  one per line @return 0 if it has mistakes, which are shown
EMSCRIPTEN_KEEPALIVE int jw_open(const char* path, const char* at, const char* experiments) {
    try {
        return page->host().open(path, at, lines_of(experiments)) ? 1 : 0;
    } catch (const std::exception& error) {
        page->host().say(error.what());
        return 0;
    }
}

/// State of the page as JSON; "{}" after an error, which is written to the console of the browser.
EMSCRIPTEN_KEEPALIVE const char* jw_state() {
    try {
        return answered(page->state());
    } catch (const std::exception& error) {
        jw::web::log(error.what());
        return answered("{}");
    }
}
/// @return 1 if a pixel of the canvas belongs to the 3D picture, and not to a panel
EMSCRIPTEN_KEEPALIVE int jw_is_scene(double x, double y) {
    return page->host().layout().scene.contains(x, y) ? 1 : 0;
}
/// Pixel of the canvas where text is being typed, "120 300"; empty if no field has the keyboard.
EMSCRIPTEN_KEEPALIVE const char* jw_typing_place() { return answered(page->typing_place()); }
EMSCRIPTEN_KEEPALIVE const char* jw_words() { return answered(jw::web::words_of_page()); }
EMSCRIPTEN_KEEPALIVE const char* jw_address() { return answered(page->address()); }
/// @return what is wrong with the address; empty if it is shown
EMSCRIPTEN_KEEPALIVE const char* jw_go_to_address(const char* address) {
    return problem_of([address] { page->go_to(address); });
}
/// The open lesson as text, with the experiments; as its author wrote it if there are none.
EMSCRIPTEN_KEEPALIVE const char* jw_lesson_source() { return answered(page->lesson_source()); }
/// Mistakes of a text as JSON: a list of line, column, severity and message.
EMSCRIPTEN_KEEPALIVE const char* jw_check(const char* text, const char* name) {
    return answered(jw::web::mistakes_of(text, name));
}
/// Shows a lesson file that has just been written; at the same step, if it is open.
EMSCRIPTEN_KEEPALIVE void jw_follow(const char* path) { page->follow(path); }
EMSCRIPTEN_KEEPALIVE void jw_keep_unsaved() { page->host().keep_unsaved(); }

}  // extern "C"

int main() { return 0; }
