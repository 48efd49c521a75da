#include <catch2/catch.hpp>

#include <algorithm>

#include "app/host/parts/browser.hpp"
#include "lessons/files/catalogue.hpp"
#include "lessons/files/course.hpp"
#include "lessons/read/reader.hpp"
#include "tests/app/host/checks.hpp"
#include "tests/app/host/reach.hpp"
#include "tests/app/messages/in_language.hpp"

namespace jw::test {

using host::Key;

TEST_CASE("All words of a search must be found, in any case") {
    const auto entries = host::catalogue_of(catalogue_folder(), {});
    CHECK(entries.size() == lessons_below(catalogue_folder()).size());
    CHECK(host::found_in(entries, "").size() == entries.size());
    CHECK(host::found_in(entries, "  ").size() == entries.size());
    CHECK(host::found_in(entries, "nothing-of-the-kind").empty());
    const std::vector<int> found = host::found_in(entries, "FOUR revolutes");
    REQUIRE_FALSE(found.empty());
    CHECK(found.size() < entries.size());
    const std::vector<int> bennett = host::found_in(entries, "bennett's linkage");
    REQUIRE_FALSE(bennett.empty());
    CHECK(entries[static_cast<std::size_t>(bennett.front())].path.stem() == "bennett");
}

TEST_CASE("The window searches and orders lessons as the command line does") {
    const auto entries = host::catalogue_of(catalogue_folder(), {});
    const CourseLessons course = course_lessons(catalogue_folder());
    REQUIRE(entries.size() == course.lessons.size());
    for (const char* const search : {"", "slide 5", "slides 8-9 spherical"}) {
        CAPTURE(search);
        std::vector<int> expected;
        for (std::size_t k = 0; k < entries.size(); ++k) {
            CHECK(entries[k].path == course.lessons[k].file);
            const ReadResult read = read_lesson_file(course.lessons[k].file);
            if (fits(searchable_of(*read.lesson, read.lesson->file_name), search)) {
                expected.push_back(static_cast<int>(k));
            }
        }
        CHECK_FALSE(expected.empty());
        CHECK(host::found_in(entries, search) == expected);
    }
}

TEST_CASE("Chapters have their titles as headings, in the language of the reader") {
    CHECK(host::catalogue_of(catalogue_folder(), {}).front().heading == "Vectors of two bodies");
    const InLanguage chinese("zh-Hant");
    for (const host::CatalogueEntry& entry : host::catalogue_of(catalogue_folder(), {})) {
        CAPTURE(entry.path.string(), entry.heading);
        CHECK(entry.heading.find_first_of("abcdefghijklmnopqrstuvwxyz") == std::string::npos);
        CHECK_FALSE(entry.heading.empty());
    }
}

TEST_CASE("A course with mistakes is shown as a card that says where") {
    const TemporaryFolder folder;
    folder.write("a.toml", "format = 1\n");
    folder.write("course.toml", "format = 1\n");
    const auto entries = host::catalogue_of(folder.path(), {});
    REQUIRE(entries.size() == 2);
    CHECK(entries[0].title == "course.toml");
    CHECK_THAT(entries[0].error, Catch::Contains("the course has no 'chapter'"));
}

TEST_CASE("A lesson that is gone when the lessons are looked at again is not chosen any more") {
    const TemporaryFolder folder;
    folder.write("a.toml", "format = 1");
    const auto last = folder.write("b.toml", "format = 1");
    host::LessonList shelf(folder.path(), {});
    shelf.refresh({});
    shelf.move_choice(2);
    REQUIRE(shelf.chosen() == 1);
    std::filesystem::remove(last);
    shelf.refresh({});
    CHECK(shelf.chosen() == -1);
    REQUIRE(shelf.chosen_or_first() != nullptr);
    CHECK(shelf.chosen_or_first()->path.filename() == "a.toml");
}

TEST_CASE("A lesson is searched for, chosen and opened with the keyboard alone") {
    Person person("");
    REQUIRE(person.host().state().browser);
    const Widget field = find(person, "lessons head", {"##search"});
    person.click(field.x, field.y);
    person.type("bennett");
    person.press(Key::enter);
    person.settle();
    REQUIRE(person.host().shows_lesson());
    CHECK(person.session().lesson().file_name.find("bennett") != std::string::npos);
    person.type("g");
    CHECK(person.host().state().browser);
    person.press(Key::escape);
    CHECK(person.host().shows_lesson());
}

TEST_CASE("A card that is clicked is opened, and is the newest of the lessons opened before") {
    Person person("");
    const auto width = static_cast<float>(person.host().layout().width);
    const auto height = static_cast<float>(person.host().layout().height);
    const std::vector<Widget> cards = widgets_in(person, {20.0F, 100.0F, width - 60.0F, 60.0F});
    REQUIRE(cards.size() >= 3);
    person.click(cards[1].x, std::min(cards[1].y + 40.0F, height));
    REQUIRE(person.host().shows_lesson());
    CHECK(fault_of(person.host()) == "");
    const host::RecentLessons recent(person.folder().path() / "state" / "recent");
    REQUIRE(recent.paths().size() == 1);
    CHECK(
        recent.paths().front().filename() ==
        std::filesystem::path(person.session().lesson().file_name).filename());
}

TEST_CASE("Lessons opened before are kept, newest first, each once, twelve of them") {
    const TemporaryFolder folder;
    const auto file = folder.path() / "recent";
    {
        host::RecentLessons recent(file);
        for (int k = 0; k < 20; ++k) { recent.add(folder.path() / (std::to_string(k) + ".toml")); }
        recent.add(folder.path() / "15.toml");
    }
    const host::RecentLessons recent(file);
    REQUIRE(recent.paths().size() == 12);
    CHECK(recent.paths()[0].filename() == "15.toml");
    CHECK(recent.paths()[1].filename() == "19.toml");
    CHECK(std::ranges::count(recent.paths(), recent.paths()[0]) == 1);
}

TEST_CASE("A lesson of one's own stands first among those opened last, and one with mistakes says so") {
    const TemporaryFolder folder;
    const auto good = folder.path() / "mine.toml";
    std::filesystem::copy_file(catalogue_folder() / "joints" / "revolute.toml", good);
    const auto bad = folder.write("bad.toml", "title = 3\n");
    const auto entries = host::catalogue_of(catalogue_folder(), {bad, good, folder.path() / "gone.toml"});
    const std::size_t shipped = lessons_below(catalogue_folder()).size();
    REQUIRE(entries.size() == shipped + 2);
    CHECK_FALSE(entries[0].error.empty());
    CHECK(entries[1].error.empty());
    CHECK(entries[1].chapter == "Recent");
}

TEST_CASE("Another lesson brings its own numbers to all tabs") {
    // both are told once, and looked at in the same step
    for (const char* const tab : {"3", "4"}) {
        Person fresh("loops/bennett.toml");
        fresh.go_to(4);
        fresh.type(tab);
        fresh.rest();
        fresh.ask(host::Command::save_csv);
        const auto size = std::filesystem::file_size(fresh.folder().path() / "bennett-quantities.csv");
        const std::size_t shapes = fresh.host().picture().scene.shapes.size();

        Person person("loops/four-bar.toml");
        person.go_to(4);
        person.type(tab);
        person.rest();
        person.host().open(catalogue_folder() / "loops" / "bennett.toml");
        person.go_to(4);
        person.rest();
        person.ask(host::Command::save_csv);
        INFO("tab " << tab);
        CHECK(std::filesystem::file_size(person.folder().path() / "bennett-quantities.csv") == size);
        CHECK(person.host().picture().scene.shapes.size() == shapes);
    }
}

}  // namespace jw::test
