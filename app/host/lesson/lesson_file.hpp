#pragma once

#include <filesystem>

#include "lessons/read/reader.hpp"

namespace jw::host {

/// The file of a lesson, and when it was written.
class LessonFile {
public:
    /// No file.
    LessonFile() = default;
    explicit LessonFile(std::filesystem::path path);

    const std::filesystem::path& path() const { return path_; }
    ReadResult read();
    /// True if the file was written since it was read; false while it does not exist.
    bool is_saved_anew() const;
    /// Makes the file count as saved again, whenever it was written.
    void distrust() { written_ = {}; }

private:
    std::filesystem::path path_;
    std::filesystem::file_time_type written_{};
};

}  // namespace jw::host
