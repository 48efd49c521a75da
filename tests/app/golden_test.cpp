#include <catch2/catch.hpp>

#include <cstdlib>

#include "app/host/frames/frame_painter.hpp"
#include "lessons/reader.hpp"
#include "render/atomic_file.hpp"
#include "render/png.hpp"
#include "tests/app/program.hpp"
#include "tests/support/read_png.hpp"

/// Pictures that were looked at. `./dev golden` draws them anew; look at each before it is committed.
///
/// Golden images are equal byte for byte on one machine (frames_test.cpp). Across machines the software
/// rasteriser may round differently at edges, by its vector width, so: on average less than half a grey level
/// of 255, and at most 0.5 % of the pixels more than 24 levels away. A moved label, a wrong digit or a
/// missing line is far beyond that.
namespace jw::test {
namespace {

constexpr double kMeanDifference = 0.5;
constexpr int kFarLevels = 24;
constexpr double kFarPixels = 0.005;

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

struct Difference {
    double mean = 0.0;
    double far = 0.0;
};

Difference difference_of(const render::Image& a, const render::Image& b) {
    Difference difference;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            int largest = 0;
            for (std::size_t channel = 0; channel < 3; ++channel) {
                const int d = std::abs(int(a.at(x, y)[channel]) - int(b.at(x, y)[channel]));
                difference.mean += d / 3.0;
                largest = std::max(largest, d);
            }
            difference.far += largest > kFarLevels ? 1.0 : 0.0;
        }
    }
    const double pixels = static_cast<double>(a.width) * a.height;
    return {difference.mean / pixels, difference.far / pixels};
}

/// Draws the picture anew where that is asked for.
void compare(const std::string& file, const render::Image& now) {
    const std::string path = source_path(file);
    if (std::getenv("JW_REGENERATE_GOLDEN") != nullptr) {
        render::write_file_atomically(path, render::encode_png(now));
        return;
    }
    const render::Image then = read_png(path);
    REQUIRE(now.width == then.width);
    REQUIRE(now.height == then.height);
    const Difference difference = difference_of(now, then);
    INFO(file << ": mean " << difference.mean << " levels, far " << 100.0 * difference.far << " %");
    CHECK(difference.mean < kMeanDifference);
    CHECK(difference.far < kFarPixels);
}

}  // namespace

TEST_CASE("golden pictures look as they did when they were looked at", "[app][golden]") {
    for (const Golden& golden : kGoldens) {
        compare("tests/golden/" + golden.name + ".png", picture_of(golden));
    }
}

TEST_CASE("golden windows look as they did when they were looked at", "[app][golden]") {
    for (const GoldenWindow& golden : kWindows) { compare(golden.file, picture_of(golden)); }
}

TEST_CASE("a golden picture would notice a changed digit", "[app][golden]") {
    if (std::getenv("JW_REGENERATE_GOLDEN") != nullptr) { return; }
    // two neighbouring moments of a motion differ in the pose and in numbers: farther than the tolerance
    Golden golden = kGoldens[3];
    const render::Image now = picture_of(golden);
    golden.occurrence += 4;
    const Difference difference = difference_of(now, picture_of(golden));
    CHECK((difference.mean > kMeanDifference || difference.far > kFarPixels));
}

}  // namespace jw::test
