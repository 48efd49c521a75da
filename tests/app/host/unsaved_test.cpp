#include <catch2/catch.hpp>

#include <algorithm>

#include "lessons/files/catalogue.hpp"
#include "lessons/read/reader.hpp"
#include "tests/app/host/checks.hpp"
#include "tests/app/host/person.hpp"

namespace jw::test {
namespace {

using host::Command;

std::filesystem::path four_bar() { return catalogue_folder() / "loops" / "four-bar.toml"; }

/// Opens the four-bar with an experiment.
void open_changed(Person& person, const std::string& experiment = "take out motor") {
    REQUIRE(person.host().open(four_bar(), "", {experiment}));
    REQUIRE(person.session().is_changed());
}

std::vector<std::string> chapters_of(Person& person) {
    std::vector<std::string> chapters;
    for (const host::CatalogueEntry& entry : person.host().shelf().entries()) {
        if (chapters.empty() || chapters.back() != entry.chapter) { chapters.push_back(entry.chapter); }
    }
    return chapters;
}

}  // namespace

TEST_CASE("What is tried is in a file while it is not saved, and tells the same story") {
    Person person("");
    open_changed(person);
    person.host().keep_unsaved();
    const ReadResult read = read_lesson_file(person.host().unsaved_copy());
    INFO(person.host().unsaved_copy() << read.report());
    REQUIRE(read.lesson);
    const Story again(*read.lesson);
    const Story& story = person.session().story();
    REQUIRE(again.steps().size() == story.steps().size());
    for (int k = 0; k <= story.last_assembled(); ++k) {
        CHECK(text_of(view_of(again, k)) == text_of(view_of(story, k)));
    }
}

TEST_CASE("The file goes when nothing is changed any more, or when the person has saved it") {
    Person person("");
    open_changed(person);
    person.host().keep_unsaved();
    const std::filesystem::path copy = person.host().unsaved_copy();
    REQUIRE(std::filesystem::exists(copy));
    SECTION("undone") { person.ask(Command::undo); }
    SECTION("started over") { person.ask(Command::start_over); }
    SECTION("saved") { person.ask(Command::save_lesson); }
    person.host().keep_unsaved();
    CHECK_FALSE(std::filesystem::exists(copy));
    CHECK(person.host().unsaved_copy().empty());
}

TEST_CASE("A lesson that is only looked at leaves no file") {
    Person person("loops/four-bar.toml");
    person.go_to(5);
    person.host().keep_unsaved();
    CHECK(person.host().unsaved_copy().empty());
    CHECK_FALSE(std::filesystem::exists(person.folder().path() / "state" / "unsaved"));
}

TEST_CASE("What was tried before another lesson was opened stays, and is offered in the list of lessons") {
    Person person("");
    open_changed(person);
    REQUIRE(person.host().open(catalogue_folder() / "joints" / "revolute.toml"));
    CHECK(person.host().unsaved_copy().empty());
    open_changed(person, "take out A");
    person.host().keep_unsaved();
    const auto unsaved = person.folder().path() / "state" / "unsaved";
    CHECK(std::filesystem::exists(unsaved / "four-bar.toml"));
    CHECK(person.host().unsaved_copy() == unsaved / "four-bar-2.toml");
    person.ask(Command::lessons);
    const std::vector<std::string> chapters = chapters_of(person);
    REQUIRE(chapters.size() > 2);
    CHECK(chapters[0] == "Not saved");
    CHECK(chapters[1] == "Recent");
    // changes that are being tried now are not offered again
    CHECK(
        std::ranges::count(person.host().shelf().entries(), "Not saved", &host::CatalogueEntry::chapter) ==
        1);
}

TEST_CASE("Only the newest of many files are kept") {
    const TemporaryFolder folder;
    for (int k = 0; k < 25; ++k) {
        const auto file = folder.write(std::to_string(k) + ".toml", "format = 1");
        std::filesystem::last_write_time(
            file, std::filesystem::file_time_type::clock::now() + std::chrono::seconds(k));
    }
    const auto copies = host::unsaved_copies(folder.path());
    REQUIRE(copies.size() == host::kMostCopies);
    CHECK(copies.front().filename() == "24.toml");
    CHECK(copies.back().filename() == "5.toml");
    CHECK(folder.files() == host::kMostCopies);
}

TEST_CASE("That the file cannot be written is told once") {
    Person person("");
    std::filesystem::create_directories(person.folder().path() / "state");
    std::ofstream(person.folder().path() / "state" / "unsaved") << "in the way";
    open_changed(person);
    person.host().keep_unsaved();
    CHECK_THAT(
        person.host().notice().text(),
        Catch::StartsWith("Unsaved experiments will be lost when the program ends: "));
    person.rest();
    person.host().keep_unsaved();
    CHECK(person.host().notice().text().empty());
}

}  // namespace jw::test
