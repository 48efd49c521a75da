#include <catch2/catch.hpp>

#include "lessons/files/search.hpp"
#include "tests/lessons/support.hpp"

namespace jw::test {
namespace {

Searchable from(const std::string& source) { return {"a title", slides_in(source)}; }

const std::string kHinge = R"(format = 1
title = "Über das Gelenk"
chapter = "mine"
source = "slides 4-6, 8; book ch. 7"
text = "Two bodies."
[[body]]
name = "arm"
[[joint]]
name = "elbow"
type = "revolute"
bodies = ["ground", "arm"]
at = [0, 0, 0]
axis = [0, 0, 1]
[[step]]
at = "elbow"
text = "Watch the dropped row."
)";

}  // namespace

TEST_CASE("Slides are read from a source as people write them", "[lessons][search]") {
    using Ranges = std::vector<SlideRange>;
    CHECK(slides_in("slide 5") == Ranges{{5, 5}});
    CHECK(slides_in("slides 4-6, 8; book ch. 7") == Ranges{{4, 6}, {8, 8}});
    CHECK(slides_in("book ch. 7; Slides 18–19 and 23") == Ranges{{18, 19}, {23, 23}});
    CHECK(slides_in("(slides 4 - 6)") == Ranges{{4, 6}});
    CHECK(slides_in("slide 2; slide 3") == Ranges{{2, 2}, {3, 3}});
    CHECK(slides_in("Bennett 1903").empty());
    CHECK(slides_in("landslide 5").empty());
    CHECK(slides_in("slide 99999999999").empty());
    CHECK(slides_in("").empty());
}

TEST_CASE(
    "A slide is found by its number, in a range too, and never as a part of another", "[lessons][search]") {
    for (const char* const source : {"slide 5", "slides 4-6", "slides 3, 5", "slides 5, 8; book ch. 7"}) {
        CAPTURE(source);
        CHECK(fits(from(source), "slide 5"));
        CHECK(fits(from(source), "Slides 5"));
        CHECK(fits(from(source), "title slide 5"));
    }
    for (const char* const source : {"slide 15", "slides 25, 50", "slides 6-10", "book ch. 5", ""}) {
        CAPTURE(source);
        CHECK_FALSE(fits(from(source), "slide 5"));
    }
    CHECK(fits(from("slide 5"), "slides 4-6"));
    CHECK(fits(from("slides 6-10"), "slides 4–6"));
    CHECK(fits(from("slide 8"), "slides 4, 8"));
    CHECK(fits(from("slide 5"), "slides 6-4"));
    CHECK_FALSE(fits(from("slide 15"), "slides 4-6"));
    // while it is typed
    CHECK(fits(from("slide 4"), "slides 4-"));
}

TEST_CASE("All words must be there, in any text of the lesson and any case", "[lessons][search]") {
    const Searchable lesson = searchable_of(lesson_of(kHinge), "folder/bend.toml");
    for (const char* const search :
         {"", "  ", "gelenk", "GELENK über", "ÜBER", "mine", "two BODIES", "revolute", "elbow", "dropped row",
          "bend", "slide 5 revolute", "book", "slide"}) {
        CAPTURE(search);
        CHECK(fits(lesson, search));
    }
    for (const char* const search : {"spherical", "gelenk spherical", "folder", "slide 7", "gelenkmine"}) {
        CAPTURE(search);
        CHECK_FALSE(fits(lesson, search));
    }
    CHECK(fits(searchable_of("x/broken-one.toml"), "Broken"));
    CHECK_FALSE(fits(searchable_of("x/broken-one.toml"), "slide 1"));
}

}  // namespace jw::test
