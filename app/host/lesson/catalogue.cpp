#include "app/host/lesson/catalogue.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "app/session/wording/messages.hpp"
#include "app/session/wording/shown_lesson.hpp"
#include "lessons/diagnostics/diagnostics.hpp"
#include "lessons/files/catalogue.hpp"
#include "lessons/files/course.hpp"
#include "lessons/read/reader.hpp"
#include "lessons/write/writer.hpp"

namespace jw::host {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostRecent = 12;
constexpr std::size_t kMostShown = 5;  // a row of cards

CatalogueEntry entry_of(const fs::path& path) {
    CatalogueEntry entry;
    entry.path = path;
    const ReadResult read = read_lesson_file(path);
    if (!read.lesson) {
        entry.searchable = searchable_of(path);
        entry.title = path.filename().string();
        entry.error = read.diagnostics.empty() ? tr("cannot be read") : read.diagnostics.front().message;
        return entry;
    }
    const Lesson lesson = shown_lesson(*read.lesson);
    entry.chapter = lesson.chapter;
    entry.title = lesson.title;
    entry.source = lesson.source;
    entry.text = lesson.text;
    entry.searchable = searchable_of(lesson, path);
    return entry;
}

}  // namespace

std::vector<CatalogueEntry> catalogue_of(
    const fs::path& folder, const std::vector<fs::path>& recent, const std::vector<fs::path>& unsaved) {
    std::vector<CatalogueEntry> entries;
    const auto add = [&](const std::vector<fs::path>& paths, const char* chapter) {
        std::size_t count = 0;
        for (const fs::path& path : paths) {
            std::error_code error;
            // do not wait for a file that has become a pipe in the meantime
            if (count == kMostShown || !fs::is_regular_file(path, error)) { continue; }
            entries.push_back(entry_of(path));
            entries.back().chapter = chapter;
            ++count;
        }
    };
    const std::vector<IndexedExercise> exercises = exercises_of_course(folder);
    add(unsaved, tr_later("Not saved"));
    add(recent, tr_later("Recent"));
    const CourseLessons course = course_lessons(folder);
    for (const fs::path& faulty : course.faulty) { entries.push_back(entry_of(faulty)); }
    for (const CourseLessons::Entry& lesson : course.lessons) {
        entries.push_back(entry_of(lesson.file));
        entries.back().heading = shown_text(lesson.chapter_title);
    }
    for (CatalogueEntry& entry : entries) {
        entry.exercises = exercises_of_lesson(exercises, lesson_name(entry.path));
    }
    return entries;
}

std::string name_below(const fs::path& file, const fs::path& folder) {
    return file.lexically_relative(folder).replace_extension().generic_string();
}

std::string name_in_addresses(const fs::path& lesson, const fs::path& folder) {
    const std::vector<fs::path> files = lessons_below(folder);
    std::error_code error;
    const auto found = std::ranges::find_if(
        files, [&](const fs::path& file) { return fs::equivalent(file, lesson, error); });
    if (found == files.end()) { return lesson.filename().string(); }
    const auto same = [&](const fs::path& file) { return file.stem() == found->stem(); };
    return std::ranges::count_if(files, same) == 1 ? found->stem().string() : name_below(*found, folder);
}

fs::path lesson_at_address(
    const std::string& name, const fs::path& folder, const std::vector<fs::path>& others) {
    const std::vector<fs::path> files = lessons_below(folder);
    std::vector<fs::path> found;
    std::vector<std::string> names;
    for (const fs::path& file : files) {
        if (name_below(file, folder) == name) { return file; }
        names.push_back(file.stem().string());
        if (names.back() == name) { found.push_back(file); }
    }
    if (found.size() == 1) { return found.front(); }
    if (found.size() > 1) {
        throw std::runtime_error(
            "several lessons are called " + in_quotes(name) + "; expected one of " +
            name_below(found[0], folder) + ", " + name_below(found[1], folder));
    }
    const auto other = std::ranges::find(others, fs::path(name), &fs::path::filename);
    if (other != others.end()) { return *other; }
    const std::string stem = fs::path(name).stem().string();
    if (name == stem + ".toml" && std::ranges::find(names, stem) != names.end()) {
        return lesson_at_address(stem, folder, {});
    }
    const std::string hint = did_you_mean(name, names);
    throw std::runtime_error("no lesson " + in_quotes(name) + (hint.empty() ? "" : "\nhint: " + hint));
}

std::vector<int> found_in(const std::vector<CatalogueEntry>& entries, const std::string& search) {
    std::vector<int> found;
    for (std::size_t k = 0; k < entries.size(); ++k) {
        if (fits(entries[k].searchable, search)) { found.push_back(static_cast<int>(k)); }
    }
    return found;
}

RecentLessons::RecentLessons(fs::path file) : file_(std::move(file)) {
    std::error_code error;
    if (!fs::is_regular_file(file_, error)) { return; }
    std::ifstream in(file_);
    for (std::string line; std::getline(in, line) && paths_.size() < kMostRecent;) {
        if (!line.empty()) { paths_.emplace_back(line); }
    }
}

fs::path RecentLessons::usual_file() {
    if (const char* state = std::getenv("XDG_STATE_HOME"); state != nullptr && *state != '\0') {
        return fs::path(state) / "jointwise" / "recent";
    }
    const char* const home = std::getenv("HOME");
    if (home == nullptr || *home == '\0') { return {}; }
    return fs::path(home) / ".local" / "state" / "jointwise" / "recent";
}

void RecentLessons::add(const fs::path& path) {
    std::error_code error;
    const fs::path whole = fs::absolute(path, error).lexically_normal();
    std::erase(paths_, whole);
    paths_.insert(paths_.begin(), whole);
    if (paths_.size() > kMostRecent) { paths_.resize(kMostRecent); }
    if (file_.empty()) { return; }
    fs::create_directories(file_.parent_path(), error);
    std::string text;
    for (const fs::path& p : paths_) { text += p.string() + '\n'; }
    std::string ignored;
    write_lesson_file(file_, text, ignored);
}

LessonList::LessonList(std::filesystem::path folder, std::filesystem::path recent_file)
    : folder_(std::move(folder)), recent_(std::move(recent_file)) {}

void LessonList::refresh(const std::vector<std::filesystem::path>& unsaved) {
    std::vector<CatalogueEntry> entries = catalogue_of(folder_, recent_.paths(), unsaved);
    for (CatalogueEntry& entry : entries) {
        for (const CatalogueEntry& before : entries_) {
            // keep the picture: it is drawn once per run
            std::error_code error;
            if (std::filesystem::equivalent(before.path, entry.path, error) && entry.error.empty()) {
                entry.thumbnail = before.thumbnail;
            }
        }
    }
    entries_ = std::move(entries);
    if (chosen_ >= static_cast<int>(entries_.size())) { chosen_ = -1; }
    clear_search();
}

void LessonList::search_for(const std::string& text) {
    search_ = text;
    chosen_ = -1;
}

void LessonList::erase_letter() {
    if (!search_.empty()) { search_.pop_back(); }
}

void LessonList::move_choice(int by) {
    const std::vector<int> shown = found();
    if (shown.empty()) { return; }
    const auto now = std::ranges::find(shown, chosen_);
    const int at = now == shown.end() ? (by > 0 ? -1 : 0) : static_cast<int>(now - shown.begin());
    const int next = std::clamp(at + by, 0, static_cast<int>(shown.size()) - 1);
    chosen_ = shown[static_cast<std::size_t>(next)];
}

const CatalogueEntry* LessonList::chosen_or_first() {
    if (chosen_ < 0) { move_choice(1); }
    return chosen_ < 0 ? nullptr : &entries_[static_cast<std::size_t>(chosen_)];
}

}  // namespace jw::host
