#include "app/host/lesson/lesson_file.hpp"

#include <system_error>
#include <utility>

namespace jw::host {

LessonFile::LessonFile(std::filesystem::path path) : path_(std::move(path)) {}

ReadResult LessonFile::read() {
    std::error_code error;
    // taken before reading: a change during the reading is then noticed the next time
    written_ = std::filesystem::last_write_time(path_, error);
    return read_lesson_file(path_);
}

bool LessonFile::is_saved_anew() const {
    std::error_code error;
    if (path_.empty()) { return false; }
    const auto written = std::filesystem::last_write_time(path_, error);
    return !error && written != written_;
}

}  // namespace jw::host
