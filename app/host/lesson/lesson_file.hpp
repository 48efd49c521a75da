#pragma once

#include <filesystem>
#include <system_error>
#include <utility>

#include "lessons/read/reader.hpp"

namespace jw::host {

/// The file of a lesson, and when it was written.
class LessonFile {
public:
    /// No file.
    LessonFile() = default;
    explicit LessonFile(std::filesystem::path path) : path_(std::move(path)) {}

    const std::filesystem::path& path() const { return path_; }
    ReadResult read() {
        std::error_code error;
        // taken before reading: a change during the reading is then noticed the next time
        written_ = std::filesystem::last_write_time(path_, error);
        return read_lesson_file(path_);
    }
    /// True if the file was written since it was read; false while it does not exist.
    bool is_saved_anew() const {
        std::error_code error;
        if (path_.empty()) { return false; }
        const auto written = std::filesystem::last_write_time(path_, error);
        return !error && written != written_;
    }
    /// Makes the file count as saved again, whenever it was written.
    void distrust() { written_ = {}; }

private:
    std::filesystem::path path_;
    std::filesystem::file_time_type written_{};
};

}  // namespace jw::host
