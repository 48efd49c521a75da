#include "app/host/lesson/saving.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

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

namespace fs = std::filesystem;

std::string text_to_save(const Session& session) {
    Lesson lesson = session.lesson();
    lesson.claims.clear();
    return lesson_text(lesson);
}

UnsavedCopy::UnsavedCopy(fs::path folder) : folder_(std::move(folder)) {}

std::string UnsavedCopy::keep(const Session& session, const std::string& name) {
    if (folder_.empty() || told_ == session.told()) { return {}; }
    if (!session.is_changed()) {
        take_away();
        told_ = session.told();
        return {};
    }
    std::error_code ignored;
    fs::create_directories(folder_, ignored);
    fs::path path = path_;
    for (int k = 1; path.empty() || (path_.empty() && fs::exists(path, ignored)); ++k) {
        path = folder_ / (name + (k == 1 ? "" : "-" + std::to_string(k)) + ".toml");
    }
    std::string error;
    told_ = session.told();
    if (write_lesson_file(path, text_to_save(session), error)) {
        path_ = path;
        return {};
    }
    return std::exchange(complained_, true) ? std::string() : error;
}

void UnsavedCopy::saved(const Session& session) {
    take_away();
    told_ = session.told();
}

void UnsavedCopy::begin_anew() {
    path_.clear();
    told_ = 0;
    complained_ = false;
}

std::vector<fs::path> UnsavedCopy::others() const {
    if (folder_.empty()) { return {}; }
    std::vector<fs::path> copies = unsaved_copies(folder_);
    std::erase(copies, path_);
    return copies;
}

void UnsavedCopy::take_away() {
    std::error_code ignored;
    if (!path_.empty()) { fs::remove(path_, ignored); }
    path_.clear();
}

std::vector<fs::path> unsaved_copies(const fs::path& folder) {
    std::vector<std::pair<fs::file_time_type, fs::path>> found;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error)) {
        std::error_code unreadable;
        if (!entry->is_regular_file(unreadable) || entry->path().extension() != ".toml") { continue; }
        found.emplace_back(entry->last_write_time(unreadable), entry->path());
    }
    std::ranges::sort(found, std::greater<>());
    std::vector<fs::path> copies;
    for (std::size_t k = 0; k < found.size(); ++k) {
        std::error_code ignored;
        if (k < kMostCopies) {
            copies.push_back(found[k].second);
        } else {
            fs::remove(found[k].second, ignored);
        }
    }
    return copies;
}

}  // namespace jw::host
