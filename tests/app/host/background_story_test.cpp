#include <catch2/catch.hpp>

#include <algorithm>
#include <fstream>
#include <functional>

#include "app/session/output/describe.hpp"
#include "app/session/try/carry_out.hpp"
#include "app/session/wording/messages.hpp"
#include "lessons/files/catalogue.hpp"
#include "lessons/write/writer.hpp"
#include "tests/app/host/person.hpp"
#include "tests/app/session/picture_lessons.hpp"
#include "tests/support/grown_mechanisms.hpp"

namespace jw::test {
namespace {

using host::Command;
using host::Key;

// told soon, but not at once
constexpr int kLong = 170;
// so long that no test can wait for its end; a story that is given up costs nothing
constexpr int kEndless = 499;

/// A row of rods as a lesson file.
std::filesystem::path row_of(const Person& person, int rods, const std::string& title = "A row of rods") {
    Lesson lesson = lesson_of(hinge_chain(rods));
    lesson.title = title;
    Trial trial;
    trial.text = "Two experiments";
    trial.actions = {"form \"joint 3\" all three", "take out \"joint 4\"", "drag \"rod 5\" by 0 0 0.1"};
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

/// Session of the lesson without a window, told at once.
Session read_at_once(const std::filesystem::path& path) { return Session(*read_lesson_file(path).lesson); }

/// Calls `act`, which needs a story, and waits for it. @return number of stories told in the background
int stories_told(Person& person, const std::function<void()>& act) {
    const int before = person.host().stories_begun_in_background();
    act();
    person.host().wait_for_story();
    CHECK_FALSE(person.host().is_telling());
    return person.host().stories_begun_in_background() - before;
}

}  // namespace

TEST_CASE("A long lesson is told beside the pictures", "[long]") {
    Person person("loops/four-bar.toml");
    const auto path = row_of(person, kLong);
    REQUIRE(person.host().open(path, "7"));
    REQUIRE(person.host().is_telling());
    CHECK(person.session().lesson().title != "A row of rods");
    person.host().wait_for_story();
    CHECK_FALSE(person.host().is_telling());
    CHECK(person.host().told_part() == 1.0);
    CHECK(person.session().index() == 6);
    Session expected = read_at_once(path);
    expected.apply(GoTo{6});
    CHECK(shown_by(person.session()) == shown_by(expected));
}

TEST_CASE("A long lesson is given up by Escape, and the open lesson stays", "[long]") {
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
    // nothing else is carried out meanwhile
    person.press(Key::right);
    person.press(Key::z, true);
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
        CHECK(stories_told(person, [&] { person.ask(command); }) == 1);
        expected.apply(experiment);
        CHECK(shown_by(person.session()) == shown_by(expected));
    };
    const host::Address address = host::read_address("row-170.toml/9?try=take+out+%22joint+4%22");
    CHECK(stories_told(person, [&] { CHECK(person.host().go_to(address)); }) == 1);
    REQUIRE(carry_out(expected, "take out \"joint 4\"").done);
    expected.apply(GoTo{8});
    CHECK(person.session().tried() == expected.tried());
    both(Command::undo, Undo{});
    both(Command::redo, Redo{});
    both(Command::start_over, StartOver{});
}

TEST_CASE("A session whose story is not told stays as it was", "[long]") {
    bool refuses = false;
    Session session(one_joint("revolute"), false, [&](const auto& lesson, const StoryOptions& how) {
        if (refuses) { throw host::NotToldYet(); }
        return tell_at_once(lesson, how);
    });
    REQUIRE(carry_out(session, "form \"joint 0\" all three").done);
    session.apply(GoTo{1000});
    session.apply(Drag{1, Vec3::UnitX(), Vec3(1.0, 2.0, 3.0)});
    REQUIRE(session.in_hand());
    const std::string before = shown_by(session);
    const Lesson* const lesson = &session.lesson();
    refuses = true;
    Lesson other = one_joint("spherical");
    other.title = "Another one";
    CHECK_THROWS_AS(session.apply(Undo{}), host::NotToldYet);
    CHECK_THROWS_AS(session.apply(StartOver{}), host::NotToldYet);
    CHECK_THROWS_AS(session.apply(Release{}), host::NotToldYet);
    CHECK_THROWS_AS(session.replace(other), host::NotToldYet);
    CHECK_THROWS_AS(session.tell_again(), host::NotToldYet);
    CHECK_THROWS_AS(carry_out(session, "form \"joint 0\" drop x"), host::NotToldYet);
    CHECK(session.in_hand());
    CHECK(shown_by(session) == before);
    CHECK(&session.lesson() == lesson);
    // what led the hand is done again, too
    CHECK_THROWS_AS(carry_out(session, "drag body by 0 0.1 0"), host::NotToldYet);
    CHECK_FALSE(session.in_hand());
    refuses = false;
    CHECK(session.apply(Undo{}).starts_with("Undone"));
    CHECK_FALSE(session.is_changed());
}

TEST_CASE("A file of a long lesson that is saved anew is shown when it is told", "[long]") {
    Person person("");
    const auto path = row_of(person, kLong);
    CHECK(stories_told(person, [&] { CHECK(person.host().open(path, "4")); }) == 1);
    row_of(person, kLong, "Another row");
    CHECK(stories_told(person, [&] { person.ask(Command::reload); }) == 1);
    CHECK(person.session().lesson().title == "Another row");
    CHECK(person.session().index() == 3);
    CHECK_FALSE(person.host().look_at_file());
    // in another language it is told again
    for (const std::string_view tag : {"zh-Hant", "en"}) {
        CHECK(stories_told(person, [&] { person.ask(Command::language); }) == 1);
        CHECK(language() == tag);
        CHECK(person.session().index() == 3);
    }
    person.ask(Command::language);
    person.host().wait_for_story();
    const auto endless = row_of(person, kEndless);
    CHECK(stories_told(person, [&] { CHECK(person.host().open(endless)); }) == 1);
    person.ask(Command::language);
    REQUIRE(person.host().is_telling());
    person.press(Key::escape);
    CHECK(language() == "zh-Hant");
    set_language("en");
}

TEST_CASE("A slider on a long lesson goes where the pointer is, even if it is let go meanwhile", "[long]") {
    const auto opened = [](Person& person, int rods) {
        person.host().open(row_of(person, rods), "joint 3");
        person.host().wait_for_story();
        person.ask(Command::tab_experiments);
        person.ask(Command::panel_down);
    };
    const auto tried = [](Person& person) {
        const std::vector<std::string> all = person.session().tried();
        return all.empty() ? std::string() : all.front();
    };
    Person quick("");
    opened(quick, 8);
    const panels::Box column = quick.host().layout().column;
    const float x = column.x + 0.4F * column.width;
    float y = column.y;
    while (!tried(quick).starts_with("geometry") && y < column.bottom()) {
        y += 5.0F;
        quick.ask(Command::undo);
        quick.drag(x, y, x + 30.0F, y);
    }
    REQUIRE(tried(quick).starts_with("geometry"));
    // each value is normalised, so that the last one depends on those before: it is not that of a click
    const auto slow = [&](float way) {
        Person person("");
        opened(person, kLong);
        CHECK(stories_told(person, [&] { person.drag(x, y, x + way, y); }) >= 1);
        const std::string made = tried(person);
        person.ask(Command::undo);
        person.host().wait_for_story();
        CHECK(person.session().undo_text().empty());
        return made;
    };
    const std::string clicked = slow(0.0F);
    CHECK(clicked.starts_with("geometry"));
    CHECK(slow(30.0F) != clicked);
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
    REQUIRE(person.session().tried().size() >= 3);
    Session expected = read_at_once(path);
    for (const std::string& action : expected.lesson().trials.front().actions) {
        REQUIRE(carry_out(expected, action).done);
    }
    REQUIRE(person.host().open(path));
    person.host().wait_for_story();
    person.ask(Command::tab_experiments);
    CHECK(stories_told(person, [&] { person.click(x, y); }) == 3);
    CHECK(person.session().tried() == expected.tried());
    for (int k = 0; k < 3; ++k) {
        CHECK(stories_told(person, [&] { person.ask(Command::undo); }) == 1);
        expected.apply(Undo{});
        CHECK(person.session().tried() == expected.tried());
    }
    CHECK(person.session().tried().empty());
    CHECK(person.session().undo_text().empty());
}

TEST_CASE("A long lesson has a picture among the lessons", "[long]") {
    Person person("", Person::Pictures::drawn);
    const auto path = row_of(person, kLong);
    REQUIRE(person.host().open(path));
    while (person.host().is_telling()) { person.picture(); }
    person.ask(Command::lessons);
    CHECK_FALSE(person.screen().is_complete());
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
