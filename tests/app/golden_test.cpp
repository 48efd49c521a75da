#include <catch2/catch.hpp>

#include "app/host/frames/frame_painter.hpp"
#include "lessons/reader.hpp"
#include "tests/app/program.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/read_png.hpp"

namespace jw::test {
namespace {

struct Golden {
    std::string name;
    std::string lesson;
    Step::Kind kind;
    int occurrence;  ///< which step of that kind, from 0; -1: the last
};

const std::vector<Golden> kGoldens{
    {"four-bar-bodies", "loops/four-bar.toml", Step::Kind::bodies, 0},
    {"four-bar-redundant", "loops/four-bar.toml", Step::Kind::assembled, 3},
    {"four-bar-newton", "loops/four-bar.toml", Step::Kind::iteration, 1},
    {"which-two-motion", "parallel/which-two-of-three.toml", Step::Kind::motion, 40},
    {"screw-equations", "joints/screw.toml", Step::Kind::equations, 0},
    {"universal-equations", "joints/universal.toml", Step::Kind::equations, 0},
    {"bennett-motion", "loops/bennett.toml", Step::Kind::motion, 30},
};

int index_of(const Story& story, const Golden& golden) {
    std::vector<int> found;
    for (std::size_t k = 0; k < story.steps().size(); ++k) {
        if (story.steps()[k].kind == golden.kind) { found.push_back(static_cast<int>(k)); }
    }
    const auto wanted =
        golden.occurrence < 0 ? found.size() - 1 : static_cast<std::size_t>(golden.occurrence);
    REQUIRE(wanted < found.size());
    return found[wanted];
}

render::Image picture_of(const Golden& golden) {
    const ReadResult read = read_lesson_file(lesson_path(golden.lesson));
    INFO(read.report());
    REQUIRE(read.lesson.has_value());
    const Story story(*read.lesson);
    host::FramePainter painter(story, 1280, 720);
    return painter.paint(view_of(story, index_of(story, golden)));
}

/// The window as `open --picture` draws it; those in docs/ are the pictures of the README.
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

TEST_CASE("golden pictures look as they did when they were looked at", "[app][golden]") {
    for (const Golden& golden : kGoldens) {
        compare_with_golden("tests/golden/" + golden.name + ".png", picture_of(golden));
    }
}

TEST_CASE("golden windows look as they did when they were looked at", "[app][golden]") {
    for (const GoldenWindow& golden : kWindows) { compare_with_golden(golden.file, picture_of(golden)); }
}

TEST_CASE("a golden picture would notice a changed digit", "[app][golden]") {
    if (draws_goldens()) { return; }
    // two neighbouring moments of a motion differ in the pose and in numbers: farther than the tolerance
    Golden golden = kGoldens[3];
    const render::Image now = picture_of(golden);
    golden.occurrence += 4;
    CHECK_FALSE(difference_of(now, picture_of(golden)).is_of_rounding());
}

}  // namespace jw::test
