#include "app/host/lesson/lesson_list.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

namespace jw::host {

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
