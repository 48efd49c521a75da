#include <catch2/catch.hpp>

#include <cstdlib>

#include "app/commands/frame_painter.hpp"
#include "lessons/reader.hpp"
#include "render/png.hpp"
#include "tests/app/program.hpp"

/// Pictures that were looked at. `./dev golden` draws them anew; look at each before it is committed.
///
/// The same machine gives equal bytes (frames_test.cpp). Across machines the software rasteriser may round
/// differently at edges, by its vector width, so: on average less than half a grey level of 255, and at most
/// 0.5 % of the pixels more than 24 levels away. A moved label, a wrong digit or a missing line is far beyond
/// both.
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
    FramePainter painter(story, 1280, 720);
    return painter.paint(view_of(story, index_of(story, golden)));
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

}  // namespace

TEST_CASE("golden pictures look as they did when they were looked at", "[app][golden]") {
    const bool regenerate = std::getenv("JW_REGENERATE_GOLDEN") != nullptr;
    for (const Golden& golden : kGoldens) {
        const std::string path = source_path("tests/golden/" + golden.name + ".png");
        const render::Image now = picture_of(golden);
        if (regenerate) {
            render::write_file_atomically(path, render::encode_png(now));
            continue;
        }
        const render::Image then = render::read_png(path);
        REQUIRE(now.width == then.width);
        REQUIRE(now.height == then.height);
        const Difference difference = difference_of(now, then);
        INFO(
            golden.name << ": mean " << difference.mean << " levels, far " << 100.0 * difference.far << " %");
        CHECK(difference.mean < kMeanDifference);
        CHECK(difference.far < kFarPixels);
    }
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
