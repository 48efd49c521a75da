#include <catch2/catch.hpp>

#include "jointwise/film.hpp"
#include "tests/support/crank.hpp"
#include "tests/support/temporary_folder.hpp"

namespace jointwise::test {
namespace {

using jw::test::kCrank;

FilmOptions small() {
    FilmOptions options;
    options.panels = false;
    options.width = 320;
    options.height = 180;
    options.fps = 2.0;
    return options;
}

}  // namespace

TEST_CASE("A film that is given up leaves no file", "[api]") {
    const jw::test::TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "crank.apng";
    const Film film(read_lesson_text(kCrank), small());
    REQUIRE(film.pictures() > 0);
    CHECK_THROWS_AS(film.save(file, [] { return false; }), NotReached);
    CHECK(std::filesystem::is_empty(folder.path()));
    film.save(file);
    CHECK(std::filesystem::file_size(file) > 1000);
}

TEST_CASE("Options of a film that make no sense are refused", "[api]") {
    const Lesson lesson = read_lesson_text(kCrank);
    FilmOptions options = small();
    options.from = "nowhere";
    CHECK_THROWS_AS(Film(lesson, options), std::invalid_argument);
    options = small();
    options.width = 100;
    CHECK_THROWS_AS(Film(lesson, options), std::invalid_argument);
    CHECK_THROWS_AS(Film(lesson, small()).save("crank.avi"), std::invalid_argument);
}

}  // namespace jointwise::test
