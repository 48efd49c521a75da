#include <catch2/catch.hpp>

#include "app/film/captions.hpp"
#include "lessons/read/reader.hpp"
#include "tests/app/program.hpp"

namespace jw::film::test {

TEST_CASE("Captions leave no gap, and chapters are the joints, the drivers and the motion", "[film]") {
    const Lesson lesson = read_lesson_file(jw::test::lesson_path("loops/four-bar.toml")).lesson.value();
    const Story story(lesson);
    const auto pictures =
        pictures_of_film(story, 0, static_cast<int>(story.steps().size()) - 1, {30.0, true});
    const double length = seconds_of(pictures);
    const std::vector<Caption> captions = captions_of(story, pictures);
    CHECK(captions.front().from == 0.0);
    CHECK(captions.back().to == Approx(length));
    for (std::size_t k = 1; k < captions.size(); ++k) {
        CHECK(captions[k].from == captions[k - 1].to);
        CHECK(captions[k].text != captions[k - 1].text);
    }
    std::vector<std::string> titles;
    for (const Chapter& chapter : chapters_of(story, pictures)) { titles.push_back(chapter.title); }
    CHECK(titles == std::vector<std::string>{"bodies", "A", "B", "C", "D", "motor", "motion"});
    CHECK(chapters_of(story, pictures).back().to == Approx(length));
}

TEST_CASE("Captions can have any signs in them", "[film]") {
    const std::string text = webvtt({{0.0, 3661.5, "a --> b < c & d\nsecond line"}});
    CHECK(text == "WEBVTT\n\n00:00:00.000 --> 01:01:01.500\na --&gt; b &lt; c &amp; d\nsecond line\n");
    CHECK(
        ffmetadata("a = b; #1\\", {{0.0, 1.25, "x=y"}}) ==
        ";FFMETADATA1\ntitle=a \\= b\\; "
        "\\#1\\\\\n\n[CHAPTER]\nTIMEBASE=1/1000\nSTART=0\nEND=1250\ntitle=x\\=y\n");
}

}  // namespace jw::film::test
