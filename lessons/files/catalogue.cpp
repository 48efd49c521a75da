#include "lessons/files/catalogue.hpp"

#include <algorithm>
#include <cstdlib>

#include "lessons/files/course.hpp"

// not available on every machine
#if __has_include(<sys/auxv.h>)
#include <sys/auxv.h>
#endif

namespace jw {

namespace fs = std::filesystem;

namespace {

const fs::path kData = fs::path("share") / "jointwise";
/// Written by CMake at the top of every build tree.
constexpr const char* kTopOfBuildTree = "CMakeCache.txt";

/// The file of the running program, all links resolved; empty if it is not known.
fs::path running_program() {
    std::error_code error;
    fs::path program = fs::canonical("/proc/self/exe", error);
    if (!error) { return program; }
#ifdef AT_EXECFN
    // without /proc, as in a bare chroot: the path by which the program was started
    if (const auto* const started_by = reinterpret_cast<const char*>(::getauxval(AT_EXECFN))) {
        program = fs::canonical(started_by, error);
        if (!error) { return program; }
    }
#endif
    return {};
}

bool has_data(const fs::path& top) {
    std::error_code error;
    return fs::is_directory(top / kData / "lessons", error);
}

/// The top of the build tree around a folder; empty if there is none.
fs::path build_tree_around(fs::path folder) {
    std::error_code error;
    while (!fs::exists(folder / kTopOfBuildTree, error)) {
        if (folder == folder.parent_path()) { return {}; }
        folder = folder.parent_path();
    }
    return folder;
}

}  // namespace

fs::path data_folder_of(const fs::path& program) {
    const fs::path folder = program.parent_path();
    const fs::path installed = folder.parent_path();
    if (has_data(installed)) { return installed / kData; }
    const fs::path built = build_tree_around(folder);
    return (!built.empty() && has_data(built) ? built : installed) / kData;
}

const fs::path& data_folder() {
    static const fs::path folder = data_folder_of(running_program());
    return folder;
}

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
