#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lessons/exercise/exercise_index.hpp"
#include "lessons/files/search.hpp"

/// The lessons that can be opened: those of the catalogue by chapter, and those opened last.
namespace jw::host {

struct CatalogueEntry {
    std::filesystem::path path;
    std::string chapter;
    std::string heading;  ///< title of the chapter; empty if no course names it
    std::string title;    ///< or the file's name if the file has mistakes
    std::string source;
    std::string text;  ///< the lesson's introduction
    Searchable searchable;
    std::vector<IndexedExercise> exercises;  ///< that belong to the lesson
    std::string error;                       ///< first mistake of the file, empty if there is none
    void* thumbnail = nullptr;  ///< small picture for ImGui (ImTextureID), nullptr until there is one
};

/// First the lessons in `unsaved` and in `recent`: the last few that still exist, each group under a chapter
/// of its own. Then courses with mistakes, and the lessons below `folder` in the order of their course.
std::vector<CatalogueEntry> catalogue_of(
    const std::filesystem::path& folder, const std::vector<std::filesystem::path>& recent,
    const std::vector<std::filesystem::path>& unsaved = {});

/// Name of a lesson below a folder: "loops/four-bar".
std::string name_below(const std::filesystem::path& lesson, const std::filesystem::path& folder);
/// Name of a lesson in addresses: "four-bar"; "loops/four-bar" if several lessons below `folder` have a file
/// of this name; "mine.toml" if the lesson is not below `folder`.
std::string name_in_addresses(const std::filesystem::path& lesson, const std::filesystem::path& folder);
/// The lesson of this name below `folder`, or among `others`.
/// @throws std::runtime_error if there is none, or more than one
std::filesystem::path lesson_at_address(
    const std::string& name, const std::filesystem::path& folder,
    const std::vector<std::filesystem::path>& others);

/// Entries that a search shows (lessons/files/search.hpp).
std::vector<int> found_in(const std::vector<CatalogueEntry>& entries, const std::string& search);

/// The lessons opened last, newest first, kept in a small text file.
class RecentLessons {
public:
    /// @param file  empty: nothing is kept
    explicit RecentLessons(std::filesystem::path file);
    /// $XDG_STATE_HOME/jointwise/recent, by default below ~/.local/state; empty if there is no home.
    static std::filesystem::path usual_file();

    const std::vector<std::filesystem::path>& paths() const { return paths_; }
    /// Puts `path` first. It is not an error if the list cannot be written.
    void add(const std::filesystem::path& path);

private:
    std::filesystem::path file_;
    std::vector<std::filesystem::path> paths_;
};

/// The lessons to choose from: all of them, those that a search shows, and the selected one.
class LessonList {
public:
    /// @param folder       of the lessons offered
    /// @param recent_file  see RecentLessons
    LessonList(std::filesystem::path folder, std::filesystem::path recent_file);

    /// Reads again which lessons there are, and clears the search.
    /// @param unsaved  files of unsaved experiments
    void refresh(const std::vector<std::filesystem::path>& unsaved);
    void add_recent(const std::filesystem::path& path) { recent_.add(path); }

    /// Name of a lesson in addresses.
    std::string name_of(const std::filesystem::path& lesson) const {
        return name_in_addresses(lesson, folder_);
    }
    /// The lesson with this name in addresses, among those offered or opened last.
    /// @throws std::runtime_error if there is none
    std::filesystem::path lesson_called(const std::string& name) const {
        return lesson_at_address(name, folder_, recent_.paths());
    }

    /// The entries. The code that draws adds the thumbnails, which `refresh` keeps.
    std::vector<CatalogueEntry>& entries() { return entries_; }
    const std::vector<CatalogueEntry>& entries() const { return entries_; }

    const std::string& search() const { return search_; }
    /// Searches for `text`, and clears the selection.
    void search_for(const std::string& text);
    void erase_letter();
    void clear_search() { search_.clear(); }
    /// Indices of the entries that the search shows.
    std::vector<int> found() const { return found_in(entries_, search_); }

    /// Index of the selected entry; -1: none.
    int chosen() const { return chosen_; }
    void choose(int index) { chosen_ = index; }
    /// Moves the selection by `by` among the entries that the search shows.
    void move_choice(int by);
    /// The selected lesson, or the first that the search shows if none is selected; nullptr if there is none.
    const CatalogueEntry* chosen_or_first();

private:
    std::filesystem::path folder_;
    RecentLessons recent_;
    std::vector<CatalogueEntry> entries_;
    std::string search_;
    int chosen_ = -1;
};

}  // namespace jw::host
