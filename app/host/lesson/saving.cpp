#include "app/host/lesson/saving.hpp"

#include <system_error>

#include "app/host/lesson/unsaved.hpp"
#include "app/session/wording/messages.hpp"
#include "lessons/read/reader.hpp"
#include "lessons/write/writer.hpp"

namespace jw::host {

std::string suffix_of(DrawingTask task, int step) {
    return task == DrawingTask::record ? "-frames" : "-step-" + std::to_string(step + 1) + ".png";
}

std::filesystem::path free_name(
    const std::filesystem::path& folder, const std::filesystem::path& lesson, const std::string& suffix) {
    const std::string stem = lesson.stem().string();
    std::filesystem::path path = folder / (stem + suffix);
    const std::filesystem::path tail(suffix);
    std::error_code error;
    for (int k = 2; std::filesystem::exists(path, error); ++k) {
        path = folder / (stem + tail.stem().string() + "-" + std::to_string(k) + tail.extension().string());
    }
    return path;
}

Saved save_text(const std::filesystem::path& path, const std::string& text) {
    std::string error;
    if (!write_lesson_file(path, text, error)) { return {false, tr("Not saved: {0}", error)}; }
    return {true, tr("Saved {0}", path.string())};
}

Saved save_lesson(const std::filesystem::path& path, const Session& session) {
    const std::string text = text_to_save(session);
    // check now that the file can be read back: the next lecture would be too late
    const ReadResult read = read_lesson(text, path.filename().string());
    return read.lesson ? save_text(path, text) : Saved{false, tr("Not saved: {0}", read.report())};
}

}  // namespace jw::host
