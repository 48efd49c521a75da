#include "lessons/files/catalogue.hpp"

#include <algorithm>
#include <cstdlib>

#include "lessons/files/course.hpp"
#include "lessons/files/data_folder.hpp"

namespace jw {

namespace fs = std::filesystem;

fs::path catalogue_folder() {
    const char* chosen = std::getenv("JOINTWISE_LESSONS");
    if (chosen != nullptr && *chosen != '\0') { return chosen; }
    // in a build tree, `lessons` is a link to the sources; people know the path of the sources
    const fs::path lessons = data_folder() / "lessons";
    std::error_code error;
    const fs::path real = fs::canonical(lessons, error);
    return (error ? lessons : real) / "catalogue";
}

bool is_hidden(const fs::path& path) { return path.filename().string().starts_with('.'); }

std::vector<fs::path> lessons_below(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code error;
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
        std::error_code unreadable;
        const fs::path& path = entry->path();
        if (is_hidden(path)) {
            entry.disable_recursion_pending();
            continue;
        }
        const bool is_lesson = path.extension() == ".toml" && path.filename() != kCourseFile;
        if (is_lesson && entry->is_regular_file(unreadable)) { files.push_back(path); }
    }
    std::ranges::sort(files);
    return files;
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
