#include "tests/architecture/include_rules.hpp"

#include <algorithm>
#include <array>
#include <regex>
#include <span>

namespace jw::architecture {
namespace {

using Names = std::span<const std::string_view>;

/// Headers that a folder may include besides the standard library. A name that ends in '/' stands for all
/// below it.
struct FolderRule {
    std::string_view folder;
    Names allowed;
};

constexpr std::array<std::string_view, 3> kCore{"core/", "Eigen/", "sys/platform/x86.h"};
constexpr std::array<std::string_view, 8> kLessons{"core/",   "lessons/", "Eigen/",   "toml++/",
                                                   "fcntl.h", "poll.h",   "unistd.h", "sys/auxv.h"};
constexpr std::array<std::string_view, 15> kRender{
    "EGL/",        "cairo",      "render/",      "Eigen/",    "GL/glcorearb.h",
    "GL/osmesa.h", "ft2build.h", "libdeflate.h", "gif_lib.h", "stb_image",
    "imgui.h",     "fcntl.h",    "unistd.h",     "dlfcn.h",   "sys/mman.h"};
// from render/ only plain values: the scene, the camera, framing and colours
constexpr std::array<std::string_view, 11> kSession{
    "app/session/",
    "app/languages/",
    "fmt/",
    "core/",
    "lessons/",
    "Eigen/",
    "render/scene/scene.hpp",
    "render/scene/camera.hpp",
    "render/scene/framing.hpp",
    "render/scene/palette.hpp",
    "nlohmann/"};
// from render/ only fonts and colours, to set text, and the camera, to find a point in the picture
constexpr std::array<std::string_view, 10> kPanels{
    "app/panels/",
    "app/session/",
    "core/",
    "lessons/",
    "Eigen/",
    "render/scene/camera.hpp",
    "render/fonts/fonts.hpp",
    "render/fonts/math_alphabets.hpp",
    "imgui.h",
    "render/scene/palette.hpp"};

// the interface includes neither the window nor commands; it includes the exercises, which do not include it
constexpr std::array<std::string_view, 14> kHost{
    "app/host/", "app/panels/", "app/session/", "app/exercises/", "core/",      "lessons/",   "render/",
    "Eigen/",    "imgui.h",     "sha256.h",     "fcntl.h",        "sys/file.h", "sys/stat.h", "unistd.h"};

// runs programs of students: headers of the system alone
constexpr std::array<std::string_view, 14> kRun{
    "app/exercises/run/", "dirent.h", "fcntl.h",  "linux/",  "poll.h", "pwd.h", "sched.h",
    "signal.h",           "sys/",     "unistd.h", "spawn.h", "time.h", "grp.h", "elf.h"};
constexpr std::array<std::string_view, 10> kExercises{"app/exercises/", "app/session/", "core/",   "lessons/",
                                                      "Eigen/",         "nlohmann/",    "fcntl.h", "poll.h",
                                                      "sys/",           "unistd.h"};
// scenes for other programs: from render/ the shapes
constexpr std::array<std::string_view, 6> kExport{"app/export/", "app/session/", "core/",
                                                  "lessons/",    "render/",      "Eigen/"};
// frames are drawn by app/host/frames/; nothing else of the interface is included
constexpr std::array<std::string_view, 7> kSnapshot{
    "app/snapshot/", "app/host/frames/", "app/session/", "core/", "lessons/", "render/", "Eigen/"};
// the same, and headers of the system to start programs
constexpr std::array<std::string_view, 11> kFilm{
    "app/film/", "app/host/frames/", "app/session/", "core/", "lessons/", "render/",
    "Eigen/",    "fcntl.h",          "spawn.h",      "sys/",  "unistd.h"};
// pages around the lessons: app/host/frames/ draws the pictures, app/host/lesson/ has the addresses
constexpr std::array<std::string_view, 8> kSite{
    "app/site/", "app/host/frames/", "app/host/lesson/", "app/session/",
    "core/",     "lessons/",         "render/",          "Eigen/"};
// the page: the interface, and the browser around it
constexpr std::array<std::string_view, 7> kWeb{"app/web/", "app/host/", "app/session/", "lessons/",
                                               "render/",  "imgui.h",   "emscripten/"};

// headers that other programs include show nothing of the implementation
constexpr std::array<std::string_view, 2> kHeadersOfLibrary{"jointwise/", "Eigen/"};
constexpr std::array<std::string_view, 9> kLibrary{"library/",  "jointwise/",       "core/",
                                                   "lessons/",  "render/",          "app/session/",
                                                   "app/film/", "app/host/frames/", "Eigen/"};

// the Python module is thin: of the project it includes only the headers for other programs
constexpr std::array<std::string_view, 3> kPython{"app/python/", "jointwise/", "pybind11/"};

// the first folder that a path begins with counts
constexpr std::array kFolders{
    FolderRule{"core/", kCore},
    FolderRule{"lessons/", kLessons},
    FolderRule{"render/", kRender},
    FolderRule{"library/jointwise/", kHeadersOfLibrary},
    FolderRule{"library/", kLibrary},
    FolderRule{"app/session/", kSession},
    FolderRule{"app/panels/", kPanels},
    FolderRule{"app/host/", kHost},
    FolderRule{"app/export/", kExport},
    FolderRule{"app/snapshot/", kSnapshot},
    FolderRule{"app/film/", kFilm},
    FolderRule{"app/site/", kSite},
    FolderRule{"app/web/", kWeb},
    FolderRule{"app/python/", kPython},
    FolderRule{"app/exercises/run/", kRun},
    FolderRule{"app/exercises/", kExercises}};

/// Rooms from the bottom up: each may include files of itself and of those before it.
constexpr std::array kRooms = std::to_array<std::string_view>({
    "core/elementary/",
    "core/eigen/",
    "core/numerics/",
    "core/jets/",
    "core/model/",
    "core/equations/",
    "core/poses/",
    "core/poses/typed/",
    "core/motion/",
    "core/motion/block/",
    "core/motion/tree/",
    "core/motion/dense/",
    "core/kinematics/",
    "core/statics/",
    "core/integrate/",
    "core/quantity/",
    "lessons/text/",
    "lessons/diagnostics/",
    "lessons/math/",
    "lessons/typed/",
    "lessons/formula/",
    "lessons/lesson/",
    "lessons/format/",
    "lessons/fields/",
    "lessons/files/",
    "lessons/read/",
    "lessons/precision/",
    "lessons/write/",
    "lessons/exercise/",
    "lessons/explanations/",
    "render/scene/",
    "render/fonts/",
    "render/files/",
    "render/animation/",
    "render/gl/",
    "render/passes/",
    "render/surface/",
    "app/session/background/",
    "app/session/encoding/",
    "app/session/wording/",
    "app/session/story/",
    "app/session/answers/",
    "app/session/view/",
    "app/session/picture/",
    "app/session/rest/",
    "app/session/claims/",
    "app/session/output/",
    "app/session/try/",
    "app/session/benchmark/",
    "app/panels/parts/",
    "app/panels/plot/",
    "app/panels/column/",
    "app/panels/frame/",
    "app/host/lesson/",
    "app/host/frames/",
    "app/host/ui/",
    "app/host/tabs/",
    "app/host/parts/",
    "app/host/",
});

/// Folders that consist of rooms alone.
constexpr std::array<std::string_view, 6> kFoldersOfRooms{"core/",        "lessons/",    "render/",
                                                          "app/session/", "app/panels/", "app/host/"};

/// Place of the innermost room that a path lies in, or nothing.
std::optional<std::size_t> room_of(std::string_view path) {
    std::optional<std::size_t> found;
    for (std::size_t k = 0; k < kRooms.size(); ++k) {
        if (!path.starts_with(kRooms[k])) { continue; }
        if (!found || kRooms[k].size() > kRooms[*found].size()) { found = k; }
    }
    return found;
}

/// A library that only a few files may include, so that it can be replaced there.
struct LibraryRule {
    std::string_view library;
    std::string_view known_to;  ///< regular expression over paths
};

constexpr std::array kLibraries{
    LibraryRule{"GL/osmesa.h", "render/surface/osmesa_context\\.cpp"},
    LibraryRule{"EGL/", "render/surface/egl_context\\.cpp"},
    LibraryRule{"GL/glcorearb.h", "render/gl/gl_functions\\.hpp"},
    LibraryRule{"GLFW/", "app/window\\.[ch]pp"},
    LibraryRule{"ft2build.h", "render/fonts/font_face\\.cpp"},
    LibraryRule{"imgui.h", "render/(fonts/fonts|passes/imgui_backend)\\.[ch]pp|app/.*|tests/(render|app)/.*"},
    LibraryRule{"cairo", "render/files/vector_picture\\.cpp"},
    LibraryRule{"libdeflate.h", "render/files/png(_chunks)?\\.cpp"},
    LibraryRule{"gif_lib.h", "render/animation/gif\\.cpp"},
    LibraryRule{"sha256.h", "app/host/frames/frame_draft\\.cpp"},
    LibraryRule{"toml++/", "lessons/.*"},
    // singular values are those of core/numerics/svd: Eigen's BDCSVD is wrong on some Jacobians
    LibraryRule{"Eigen/SVD", "tests/.*"},
    LibraryRule{"Eigen/Dense", "tests/.*"},
    LibraryRule{"fmt/", "app/session/wording/messages\\.[ch]pp"},
    LibraryRule{"pybind11/", "app/python/.*"},
    LibraryRule{"emscripten/", "app/web/.*|tests/bench/peers/race\\.cpp"},
    LibraryRule{"lapacke.h", "tests/support/lapack_svd\\.hpp"},
};

bool covers(std::string_view rule, std::string_view name) {
    return rule.ends_with(".h") || rule.ends_with(".hpp") ? name == rule : name.starts_with(rule);
}

bool is_standard(std::string_view name) { return name.find_first_of("./") == std::string_view::npos; }

}  // namespace

std::optional<std::string> included_by(const std::string& line) {
    static const std::regex include(R"re(^\s*#\s*include\s*[<"]([^>"]+)[>"].*)re");
    std::smatch match;
    if (!std::regex_match(line, match, include)) { return std::nullopt; }
    return match[1].str();
}

std::optional<std::string> objection(std::string_view path, std::string_view name) {
    if (is_standard(name)) { return std::nullopt; }

    // a library may be included only by the files of its rule
    for (const LibraryRule& rule : kLibraries) {
        const std::regex known_to{std::string(rule.known_to)};
        if (covers(rule.library, name) && !std::regex_match(path.begin(), path.end(), known_to)) {
            return std::string(name) + " is known only to " + std::string(rule.known_to);
        }
    }

    const auto room = room_of(path);
    const auto other = room_of(name);
    if (room && other && *other > *room) {
        return std::string(kRooms[*room]) + " does not know " + std::string(kRooms[*other]);
    }
    const bool in_rooms = std::ranges::any_of(
        kFoldersOfRooms, [path](std::string_view folder) { return path.starts_with(folder); });
    if (in_rooms && !room) { return "every file of this folder belongs to one of its rooms"; }

    // a file may include only the headers that the rule of its folder allows
    const auto folder =
        std::ranges::find_if(kFolders, [&](const FolderRule& rule) { return path.starts_with(rule.folder); });
    if (folder == kFolders.end()) { return std::nullopt; }
    if (std::ranges::any_of(folder->allowed, [&](std::string_view rule) { return covers(rule, name); })) {
        return std::nullopt;
    }
    return std::string(folder->folder) + " does not know " + std::string(name);
}

}  // namespace jw::architecture
