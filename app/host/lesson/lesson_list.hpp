#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/host/lesson/catalogue.hpp"

namespace jw::host {

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
