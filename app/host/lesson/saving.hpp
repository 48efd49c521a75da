#pragma once

#include <filesystem>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "app/session/try/session.hpp"
#include "lessons/read/reader.hpp"

/// Files made from the open lesson, and the messages about them.
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

/// Task for the code that draws, kept until it is done.
enum class DrawingTask { none, save_picture, record };

/// End of the name of the file or folder that a task makes at a step: "-step-12.png", "-frames".
std::string suffix_of(DrawingTask task, int step);

/// "four-bar-2.png": a name in `folder` that is not taken.
/// @param lesson  its file
/// @param suffix  ".png", "-changed.toml"
std::filesystem::path free_name(
    const std::filesystem::path& folder, const std::filesystem::path& lesson, const std::string& suffix);

struct Saved {
    bool done = false;
    std::string said;  ///< message: saved, or why not
};
Saved save_text(const std::filesystem::path& path, const std::string& text);
/// Saves the lesson in its present state, if the file can be read back.
Saved save_lesson(const std::filesystem::path& path, const Session& session);

/// The text of the lesson in its present state, without the claims: they are about the lesson as written.
std::string text_to_save(const Session& session);

/// Unsaved experiments of a lesson, kept in a file, which remains however the program ends.
class UnsavedCopy {
public:
    /// @param folder  of the copies, created when it is needed; empty: nothing is kept
    explicit UnsavedCopy(std::filesystem::path folder);

    /// Writes the lesson if it was changed since the last call; removes the copy if nothing is changed.
    /// @param name  of the copy without extension: that of the lesson's file
    /// @return why it cannot be written, once for each session; empty if it was written or need not be
    std::string keep(const Session& session, const std::string& name);

    /// Call when the user has saved the lesson in its present state: the copy is removed.
    void saved(const Session& session);
    /// Call when another session begins. The copy of the previous session stays.
    void begin_anew();

    /// Path of the copy; empty if there is none.
    const std::filesystem::path& path() const { return path_; }
    /// Copies of previous sessions, newest first.
    std::vector<std::filesystem::path> others() const;

private:
    void take_away();

    std::filesystem::path folder_;
    std::filesystem::path path_;
    std::uint64_t told_ = 0;  ///< telling that the copy was made of, or that needs no copy
    bool complained_ = false;
};

/// Copies in `folder`, newest first; all but the newest `kMostCopies` are removed.
std::vector<std::filesystem::path> unsaved_copies(const std::filesystem::path& folder);
inline constexpr std::size_t kMostCopies = 20;

}  // namespace jw::host
