#include <catch2/catch.hpp>

#include "app/session/view/series.hpp"
#include "render/files/png.hpp"
#include "tests/app/program.hpp"
#include "tests/app/session/catalogue_lessons.hpp"
#include "tests/support/read_png.hpp"

namespace jw::test {
namespace {

const std::vector<std::string> kTopics{"quantities", "residuals", "singular-values", "conditions"};

/// Number of pixels that differ from the first one, which is paper.
int marked(const render::Image& image) {
    int count = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            count += std::equal(image.at(x, y), image.at(x, y) + 3, image.at(0, 0)) ? 0 : 1;
        }
    }
    return count;
}

}  // namespace

TEST_CASE("a plot's table has the numbers of the session", "[app][commands]") {
    const Folder folder;
    const std::string file = lesson_path("joints/screw.toml");
    const std::string out = folder.path("table.csv");
    const Lesson lesson = lesson_named("joints/screw");
    const Story story(lesson);
    const std::vector<SeriesSet> sets{
        motion_series(story), newton_series(story), singular_value_series(story), condition_series(story, 0)};
    for (std::size_t k = 0; k < kTopics.size(); ++k) {
        const Ran ran = run({"plot", file, "--of", kTopics[k], "--joint", "thread", "--out", out});
        INFO(kTopics[k] << ran.err);
        REQUIRE(ran.status == 0);
        CHECK(bytes_of(out) == csv_of(sets[k]));
    }
    REQUIRE(run({"plot", file, "--curves", "nut.r.z,nut.omega.z", "--out", out}).status == 0);
    const std::string csv = bytes_of(out);
    CHECK(std::ranges::count(csv.substr(0, csv.find('\n')), ',') == 2);
}

TEST_CASE(
    "a plot's picture has the size asked for, curves, and the same bytes each time", "[app][commands]") {
    const Folder folder;
    for (const std::string& topic : kTopics) {
        const std::string out = folder.path(topic + ".png");
        const std::vector<std::string> arguments{
            "plot", lesson_path("joints/screw.toml"), "--of", topic, "--size", "640x400", "--out", out};
        INFO(topic);
        REQUIRE(run(arguments).status == 0);
        const std::string bytes = bytes_of(out);
        const render::Image image = read_png(out);
        CHECK(image.width == 640);
        CHECK(image.height == 400);
        CHECK(marked(image) > 640);
        REQUIRE(run(arguments).status == 0);
        CHECK(bytes_of(out) == bytes);
    }
}

TEST_CASE("a plot that cannot be made says what was expected", "[app][commands]") {
    const Folder folder;
    const std::string screw = lesson_path("joints/screw.toml");
    struct Case {
        std::vector<std::string> more;
        std::string says;
    };
    const std::vector<Case> cases{
        {{"--out", folder.path("a.jpg")}, "expected a name that ends in .png or .csv"},
        {{"--out", folder.path("a.png"), "--size", "9x9"},
         "expected WIDTHxHEIGHT in pixels from 320x320 to 3840x3840"},
        {{"--out", folder.path("a.png"), "--curves", "thread.angel"}, "hint: did you mean 'thread.angle'?"},
        {{"--out", folder.path("a.png"), "--of", "conditions", "--joint", "thred"},
         "hint: did you mean 'thread'?"},
        {{"--out", folder.path("none/a.png")}, "none"},
    };
    for (const Case& c : cases) {
        std::vector<std::string> arguments{"plot", screw};
        arguments.insert(arguments.end(), c.more.begin(), c.more.end());
        const Ran ran = run(arguments);
        INFO(ran.err);
        CHECK(ran.status == 2);
        CHECK(ran.err.find(c.says) != std::string::npos);
    }
}

}  // namespace jw::test
