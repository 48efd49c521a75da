#include "lessons/catalogue.hpp"

#include <algorithm>
#include <cstdlib>

namespace jw {

std::filesystem::path catalogue_folder() {
    const char* chosen = std::getenv("JOINTWISE_LESSONS");
    return chosen != nullptr && *chosen != '\0' ? chosen : JW_CATALOGUE_FOLDER;
}

std::vector<std::filesystem::path> lessons_below(const std::filesystem::path& folder) {
    namespace fs = std::filesystem;
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

}  // namespace jw
