#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/host/frames/environment.hpp"
#include "tests/app/program.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/read_png.hpp"

namespace jw::test {
namespace {

/// Lessons with golden snapshots, as ./dev golden names them.
constexpr std::array kLessons{
    "loops/four-bar.toml", "loops/bennett.toml", "parallel/which-two-of-three.toml", "joints/screw.toml",
    "joints/universal.toml"};

/// The window as `open --picture` draws it; those in docs/ are pictures of its pages.
struct GoldenWindow {
    std::string file;
    std::string lesson;  ///< empty: the browser
    std::vector<std::string> options;
};

const std::vector<GoldenWindow> kWindows{
    {"docs/window.png", "loops/four-bar.toml", {"--at", "D", "--tab", "try"}},
    {"docs/lessons.png", "", {}},
    {"tests/golden/window-plots.png", "loops/bricard.toml", {"--at", "t=1.2", "--tab", "plots"}},
    {"tests/golden/window-newton-dark.png",
     "hard/cannot-close.toml",
     {"--at", "D", "--tab", "newton", "--dark"}},
    {"tests/golden/window-small.png",
     "screws/screw-jack.toml",
     {"--at", "thread", "--tab", "step", "--size", "960x640"}},
    {"tests/golden/window-upright.png", "loops/four-bar.toml", {"--at", "D", "--size", "585x1150"}},
};

render::Image picture_of(const GoldenWindow& golden) {
    const Folder folder;
    const std::string picture = folder.path("window.png");
    std::vector<std::string> arguments{"open"};
    if (!golden.lesson.empty()) { arguments.push_back(lesson_path(golden.lesson)); }
    arguments.insert(arguments.end(), golden.options.begin(), golden.options.end());
    arguments.insert(arguments.end(), {"--picture", picture});
    const Ran ran = run(arguments);
    INFO(ran.err);
    REQUIRE(ran.status == 0);
    return read_png(picture);
}

}  // namespace

TEST_CASE("lessons show what they did when their golden snapshots were looked at", "[app][golden]") {
    // `./dev golden REASON` blesses them
    if (draws_goldens()) { return; }
    std::vector<std::string> arguments{"snapshot", "compare"};
    for (const char* const lesson : kLessons) { arguments.push_back(lesson_path(lesson)); }
    arguments.insert(arguments.end(), {"--golden", source_path("tests/golden/lessons")});
    const Ran ran = run(arguments);
    INFO(ran.out << ran.err);
    CHECK(ran.status == 0);
}

TEST_CASE("golden snapshots have the look of now, so that their colours count", "[app][golden]") {
    // `./dev golden REASON` blesses them; fonts and renderer depend on the machine
    const host::Environment now = host::environment("", {});
    int records = 0;
    for (const char* const folder : {"tests/golden/lessons", "docs/snapshots/template/golden"}) {
        for (const auto& entry : std::filesystem::recursive_directory_iterator(source_path(folder))) {
            if (entry.path().extension() != ".json" || entry.path().stem() == "snapshots") { continue; }
            const auto record = nlohmann::json::parse(bytes_of(entry.path()));
            INFO(entry.path());
            const auto with = record["drawn_with"].get<host::Environment>();
            CHECK(with.at("look of pictures") == now.at("look of pictures"));
            ++records;
        }
    }
    // at least as many as when this was written: 7 of the project, 6 of the template
    CHECK(records >= 13);
}

TEST_CASE("golden windows look as they did when they were looked at", "[app][golden]") {
    for (const GoldenWindow& golden : kWindows) { compare_with_golden(golden.file, picture_of(golden)); }
}

TEST_CASE("a golden window notices a shift by one pixel and another digit", "[app][golden]") {
    const render::Image golden = read_png(source_path("tests/golden/window-small.png"));
    CHECK(broken_rule_of(golden, golden).empty());
    render::Image shifted = golden;
    std::rotate(shifted.rgb.begin(), shifted.rgb.begin() + 3, shifted.rgb.end());
    CHECK_FALSE(broken_rule_of(golden, shifted).empty());
    // as many pixels as a digit covers
    render::Image other = golden;
    for (std::size_t row = 100; row < 108; ++row) {
        const std::size_t pixel = row * static_cast<std::size_t>(golden.width) + 100;
        std::fill_n(other.rgb.begin() + static_cast<std::ptrdiff_t>(3 * pixel), 6, std::uint8_t{90});
    }
    CHECK_FALSE(broken_rule_of(golden, other).empty());
}

}  // namespace jw::test
