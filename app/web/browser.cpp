#include "app/web/browser.hpp"

#include <emscripten/em_js.h>

// `Module.page` has the functions that page.js provides when it loads the program

// clang-format off
EM_JS(void, jw_download, (const char* path), { Module.page.download(UTF8ToString(path)); })
EM_JS(void, jw_copy, (const char* text), { Module.page.copy(UTF8ToString(text)); })
EM_JS(void, jw_log, (const char* text), { console.error(UTF8ToString(text)); })
EM_JS(void, jw_begin_measuring, (int number, const char* lesson, const char* treatment), {
    Module.page.beginMeasuring(number, UTF8ToString(lesson), UTF8ToString(treatment));
})
EM_JS(void, jw_end_measuring, (int number), { Module.page.endMeasuring(number); })
EM_JS(void, jw_tell_measured, (const char* news), { Module.page.tellMeasured(UTF8ToString(news)); })
// clang-format on

namespace jw::web {

void download(const std::filesystem::path& file) { jw_download(file.c_str()); }
void copy(const std::string& text) { jw_copy(text.c_str()); }
void begin_measuring(int number, const std::string& lesson, const std::string& treatment) {
    jw_begin_measuring(number, lesson.c_str(), treatment.c_str());
}
void end_measuring(int number) { jw_end_measuring(number); }
void tell_measured(const std::string& news) { jw_tell_measured(news.c_str()); }
void log(const std::string& text) { jw_log(text.c_str()); }

}  // namespace jw::web
