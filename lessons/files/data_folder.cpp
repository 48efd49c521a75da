#include "lessons/files/data_folder.hpp"

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

}  // namespace jw
