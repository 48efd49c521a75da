#include <catch2/catch.hpp>

#include "app/site/page_frame.hpp"
#include "app/site/pictures.hpp"
#include "app/site/stations.hpp"
#include "lessons/files/catalogue.hpp"
#include "lessons/read/reader.hpp"

namespace jw::test {
namespace {

Lesson shipped(const char* name) {
    return read_lesson_file(catalogue_folder() / (std::string(name) + ".toml")).lesson.value();
}

}  // namespace

TEST_CASE("Stations are the bodies, each joint and driver once it is closed, and the motion", "[site]") {
    const Lesson lesson = shipped("loops/four-bar");
    const Story story(lesson);
    const std::vector<site::Station> stations = site::stations_of(story);
    REQUIRE(stations.size() == 1 + lesson.order.size() + 1);
    std::vector<Step::Kind> kinds;
    for (const site::Station& station : stations) {
        const Step& step = story.steps()[static_cast<std::size_t>(station.told)];
        kinds.push_back(step.kind);
        CHECK(station.pictured);
        CHECK((station.equations >= 0) == (step.kind == Step::Kind::assembled));
        if (station.equations >= 0) {
            const Step& equations = story.steps()[static_cast<std::size_t>(station.equations)];
            CHECK(equations.kind == Step::Kind::equations);
            CHECK(equations.additions == step.additions);
        }
    }
    std::vector<Step::Kind> expected(stations.size(), Step::Kind::assembled);
    expected.front() = Step::Kind::bodies;
    expected.back() = Step::Kind::motion;
    CHECK(kinds == expected);
}

TEST_CASE("Each moment of a motion that has words of its own is a station", "[site]") {
    Lesson lesson = shipped("loops/four-bar");
    lesson.step_texts.times = {{1.0, "One."}, {3.0, "Three."}};
    const Story story(lesson);
    std::vector<double> times;
    for (const site::Station& station : site::stations_of(story)) {
        if (station.moves) { times.push_back(story.steps()[static_cast<std::size_t>(station.told)].t); }
    }
    REQUIRE(times.size() == 3);
    // one moment before them, for the text about the whole motion
    CHECK(times[0] > 0.0);
    CHECK(times[0] < 1.0);
    CHECK(times[1] == Approx(1.0));
    CHECK(times[2] == Approx(3.0));
}

TEST_CASE("A story that ends early has its failure as the last station", "[site]") {
    const Lesson lesson = shipped("hard/cannot-close");
    const Story story(lesson);
    REQUIRE(story.failure() != nullptr);
    const std::vector<site::Station> stations = site::stations_of(story);
    CHECK(story.steps()[static_cast<std::size_t>(stations.back().told)].failed());
    CHECK(stations.back().pictured);
}

TEST_CASE("Lines of a text are one, and blank lines begin paragraphs", "[site]") {
    CHECK(site::paragraphs_html("") == "");
    CHECK(site::paragraphs_html("one\n  two\r\n\n \nthree\n") == "<p>one two</p>\n<p>three</p>\n");
    CHECK(site::words_html(" a <b>\n& $x_i$ ").starts_with("a &lt;b&gt; &amp; <math"));
    CHECK(site::words_plain("so $\\mathbf{s}_i$\nis") == "so sᵢ is");
}

TEST_CASE("Slides of a source are links, and numbers of books are not", "[site]") {
    CHECK(
        site::source_html("slides 3, 8; book ch. 7", "../") ==
        "slides <a href=\"../slides.html#slide-3\">3</a>, <a href=\"../slides.html#slide-8\">8</a>; book ch. "
        "7");
    CHECK(site::source_html("book p. 201", "") == "book p. 201");
    CHECK(site::source_html("slide 5", "") == "slide <a href=\"slides.html#slide-5\">5</a>");
    CHECK(site::source_html("slides 123456789012", "").find("href") == std::string::npos);
    CHECK(site::slide_numbers("slides 4-6, 8") == std::vector<int>{4, 5, 6, 8});
    CHECK(site::slide_numbers("slides 1-2000000000").size() == 1000);
}

TEST_CASE("A picture of half the size has the means of four pixels, by their opacity", "[site]") {
    render::Image image;
    image.width = 3;
    image.height = 2;
    image.rgb = {0, 10, 20, 4, 10, 20, 9, 9, 9, 8, 10, 20, 4, 14, 22, 9, 9, 9};
    render::Image half = site::halved(image);
    CHECK(half.width == 1);
    CHECK(half.height == 1);
    CHECK(half.rgb == std::vector<std::uint8_t>{4, 11, 21});
    CHECK(half.alpha.empty());
    image.alpha = {255, 0, 0, 0, 85, 0};
    half = site::halved(image);
    // (255 · 0 + 85 · 4) / 340, and the rest likewise
    CHECK(half.rgb == std::vector<std::uint8_t>{1, 11, 21});
    CHECK(half.alpha == std::vector<std::uint8_t>{85});
    image.alpha.assign(6, 0);
    CHECK(site::halved(image).alpha == std::vector<std::uint8_t>{0});
}

}  // namespace jw::test
