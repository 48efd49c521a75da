#include <catch2/catch.hpp>

#include <algorithm>
#include <fstream>

#include "app/session/output/describe.hpp"
#include "app/session/try/carry_out.hpp"
#include "lessons/catalogue.hpp"
#include "lessons/writer.hpp"
#include "tests/app/host/person.hpp"
#include "tests/app/session/picture_lessons.hpp"
#include "tests/support/grown_mechanisms.hpp"

namespace jw::test {
namespace {

using host::Command;
using host::Key;

// told in a blink, but not at once
constexpr int kLong = 170;
// so long that it is not told before anybody has lost patience; what is given up costs nothing
constexpr int kEndless = 499;

/// A row of rods as a lesson file.
std::filesystem::path row_of(const Person& person, int rods, const std::string& title = "A row of rods") {
    Lesson lesson = lesson_of(hinge_chain(rods));
    lesson.title = title;
    Trial trial;
    trial.text = "Two experiments";
    trial.actions = {"form \"joint 3\" all three", "take out \"joint 4\""};
    lesson.trials = {trial};
    std::filesystem::path path = person.folder().path() / ("row-" + std::to_string(rods) + ".toml");
    std::ofstream(path) << lesson_text(lesson);
    return path;
}

/// What a session shows, in words, with what was tried.
std::string shown_by(const Session& session) {
    std::string text = describe(session.view(), 100);
    for (const std::string& sentence : session.tried()) { text += "\n" + sentence; }
    return text;
}

/// The same without a window, told at once.
Session read_at_once(const std::filesystem::path& path) { return Session(*read_lesson_file(path).lesson); }

}  // namespace

TEST_CASE("A long lesson is told beside the pictures", "[long]") {
    Person person("loops/four-bar.toml");
    const auto path = row_of(person, kLong);
    REQUIRE(person.host().open(path, "7"));
    REQUIRE(person.host().is_telling());
    // what was open is shown meanwhile, and nothing is carried out
    CHECK(person.session().lesson().title != "A row of rods");
    person.host().push(host::InputEvent::pressed(Key::right));
    person.frame();
    person.host().wait_for_story();
    CHECK_FALSE(person.host().is_telling());
    CHECK(person.host().told_part() == 1.0);
    CHECK(person.session().index() == 6);
    Session expected = read_at_once(path);
    expected.apply(GoTo{6});
    CHECK(shown_by(person.session()) == shown_by(expected));
}

TEST_CASE("A long lesson is given up by Escape, and what was open stays", "[long]") {
    Person person("loops/four-bar.toml");
    const std::string before = shown_by(person.session());
    const auto path = row_of(person, kEndless);
    SECTION("opened") { REQUIRE(person.host().open(path)); }
    SECTION("by its address") {
        REQUIRE(person.host().open(path));
        REQUIRE(person.host().go_to(host::read_address("four-bar/3")));
        CHECK_FALSE(person.host().is_telling());
        person.go_to(0);
        REQUIRE(person.host().open(path));
    }
    REQUIRE(person.host().is_telling());
    person.press(Key::escape);
    CHECK_FALSE(person.host().is_telling());
    CHECK(person.host().notice().text() == "Stopped.");
    CHECK(shown_by(person.session()) == before);
    person.ask(Command::next);
    CHECK(person.session().index() == 1);
}

TEST_CASE("Experiments on a long lesson are those of a short one", "[long]") {
    Person person("");
    const auto path = row_of(person, kLong);
    REQUIRE(person.host().open(path));
    person.host().wait_for_story();
    Session expected = read_at_once(path);
    const auto both = [&](Command command, const Experiment& experiment) {
        person.ask(command);
        person.host().wait_for_story();
        expected.apply(experiment);
        CHECK(shown_by(person.session()) == shown_by(expected));
    };
    REQUIRE(person.host().go_to(host::read_address("row-170.toml/9?try=take+out+%22joint+4%22")));
    person.host().wait_for_story();
    REQUIRE(carry_out(expected, "take out \"joint 4\"").done);
    expected.apply(GoTo{8});
    CHECK(person.session().tried() == expected.tried());
    both(Command::undo, Undo{});
    both(Command::redo, Redo{});
    both(Command::start_over, StartOver{});
}

TEST_CASE("What a lesson proposes is done once, however often it waits", "[long]") {
    Person person("");
    const auto path = row_of(person, kLong);
    // the same button in a lesson that does not wait
    REQUIRE(person.host().open(row_of(person, 8)));
    person.ask(Command::tab_experiments);
    const panels::Box column = person.host().layout().column;
    const float x = column.x + 30.0F;
    float y = column.y;
    while (person.session().tried().empty() && y < column.bottom()) { person.click(x, y += 4.0F); }
    const std::vector<std::string> done = person.session().tried();
    REQUIRE(done.size() == 2);
    REQUIRE(person.host().open(path));
    person.host().wait_for_story();
    person.ask(Command::tab_experiments);
    person.click(x, y);
    person.host().wait_for_story();
    CHECK(person.session().tried() == done);
    for (const std::size_t left : {1U, 0U}) {
        person.ask(Command::undo);
        person.host().wait_for_story();
        CHECK(person.session().tried().size() == left);
    }
    CHECK(person.session().undo_text().empty());
}

TEST_CASE("A long lesson has a picture among the lessons", "[long]") {
    Person person("", Person::Pictures::drawn);
    const auto path = row_of(person, kLong);
    REQUIRE(person.host().open(path));
    while (person.host().is_telling()) { person.picture(); }
    person.ask(Command::lessons);
    for (int k = 0; k < 5000 && !person.screen().is_complete(); ++k) {
        person.frame();
        person.screen().draw();
    }
    const auto& entries = person.host().shelf().entries();
    const auto entry = std::ranges::find(entries, path, &host::CatalogueEntry::path);
    REQUIRE(entry != entries.end());
    CHECK(entry->thumbnail != nullptr);
}

}  // namespace jw::test
