#include "lessons/catalogue.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace jw {

namespace fs = std::filesystem;

namespace {

// in which a course meets them
constexpr std::array<std::string_view, 8> kChapters{"vectors", "parallel", "joints", "links",
                                                    "loops",   "screws",   "hard",   "dynamics"};

}  // namespace

fs::path catalogue_folder() {
    const char* chosen = std::getenv("JOINTWISE_LESSONS");
    return chosen != nullptr && *chosen != '\0' ? chosen : JW_CATALOGUE_FOLDER;
}

std::vector<fs::path> lessons_below(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code error;
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
        std::error_code unreadable;
        if (entry->is_regular_file(unreadable) && entry->path().extension() == ".toml") {
            files.push_back(entry->path());
        }
    }
    std::ranges::sort(files);
    return files;
}

std::size_t chapter_place(const fs::path& file) {
    const std::string folder = file.parent_path().filename().string();
    return static_cast<std::size_t>(std::ranges::find(kChapters, folder) - kChapters.begin());
}

std::vector<fs::path> named_lessons(
    const std::vector<std::string>& names, const std::vector<fs::path>& shipped) {
    std::vector<fs::path> files;
    for (const std::string& name : names) {
        const auto found =
            std::ranges::find(shipped, name, [](const fs::path& file) { return file.stem().string(); });
        files.push_back(found != shipped.end() ? *found : fs::path(name));
    }
    return files;
}

}  // namespace jw
