#pragma once

#include <filesystem>

#include "lessons/reader.hpp"

namespace jw::host {

/// The file of a lesson, and when it was written.
class LessonFile {
public:
    /// No file.
    LessonFile() = default;
    explicit LessonFile(std::filesystem::path path);

    const std::filesystem::path& path() const { return path_; }
    ReadResult read();
    /// Whether it was written since it was read; not while it is gone.
    bool is_saved_anew() const;
    /// It counts as saved anew, whenever it was written.
    void distrust() { written_ = {}; }

private:
    std::filesystem::path path_;
    std::filesystem::file_time_type written_{};
};

}  // namespace jw::host
