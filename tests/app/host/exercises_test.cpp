#include <catch2/catch.hpp>

#include <algorithm>
#include <fstream>

#include <imgui_internal.h>

#include "app/exercises/kinds.hpp"
#include "app/host/tabs/exercise_tab.hpp"
#include "app/session/output/json.hpp"
#include "lessons/files/catalogue.hpp"
#include "lessons/math/text_parts.hpp"
#include "tests/app/host/checks.hpp"
#include "tests/app/host/exercise_lesson.hpp"
#include "tests/app/host/overprint.hpp"
#include "tests/app/host/reach.hpp"

namespace jw::test {
namespace {

using host::Command;
using host::Key;
using host::Tab;

/// A person who has opened a lesson with exercises of every kind.
struct Student {
    explicit Student(int width = 1280, int height = 720, float text = 1.0F)
        : file(folder.write("mine/all-kinds.toml", lesson_with_exercises())),
          person(file.string(), Person::Pictures::none, width, height, false, text) {
        person.ask(Command::tab_exercises);
        wait();
    }

    void wait() {
        person.host().wait_for_exercises();
        person.settle();
    }
    const Practice& practice() { return person.host().exercises().practice(); }
    /// Opens an exercise with the keyboard alone.
    void begin(const std::string& name) {
        const auto& all = practice().exercises();
        const auto found = std::ranges::find(all, name, [](const auto& e) { return e.exercise->name; });
        REQUIRE(found != all.end());
        person.ask(Command::exercise_list);
        for (std::size_t k = 0; k < all.size(); ++k) { person.press(Key::up); }
        for (auto k = all.begin(); k != found; ++k) { person.press(Key::down); }
        person.press(Key::enter);
        wait();
        REQUIRE(practice().exercise() != nullptr);
        REQUIRE(practice().exercise()->name == name);
        REQUIRE(practice().task() != nullptr);
    }
    void answer(const std::string& text) {
        person.press(Key::enter);
        person.type(text);
        person.press(Key::enter);
        wait();
    }
    std::string right() { return kind_of(practice().exercise()->kind).right(*practice().task()).text; }

    TemporaryFolder folder;
    std::filesystem::path file;
    Person person;
};

/// Beginning of a text, so short that no line breaks within it.
std::string first_words(const std::string& text) { return text.substr(0, 20); }

}  // namespace

TEST_CASE(
    "With the keyboard alone a number, a vector, a matrix, a choice and an order are solved", "[exercises]") {
    Student student;
    for (const char* const name : {"number", "vector", "matrix", "choose", "order", "pose"}) {
        CAPTURE(name);
        student.begin(name);
        student.answer(student.right());
        REQUIRE(student.practice().verdict() != nullptr);
        CHECK(student.practice().is_solved());
        CHECK(student.practice().record().solved == 1);
        student.person.ask(Command::exercise_anew);
        student.wait();
        CHECK_FALSE(student.practice().is_solved());
    }
}

TEST_CASE("What numbers begin with begins the answer, and the number of a choice chooses it", "[exercises]") {
    Student student;
    for (const char* const name : {"number", "vector", "matrix", "choose", "order", "pose"}) {
        CAPTURE(name);
        student.begin(name);
        const std::string right = student.right();
        // a wrong answer first, which the right one replaces
        if (std::string_view(name) != "choose") { student.answer("[99, 99]"); }
        student.person.type(right);
        if (std::string_view(name) != "choose") { student.person.press(Key::enter); }
        student.wait();
        REQUIRE(student.practice().verdict() != nullptr);
        CAPTURE(right, student.practice().verdict()->judged.feedback);
        CHECK(student.practice().is_solved());
        CHECK(student.person.host().state().tab == Tab::exercises);
        CHECK(student.person.host().state().text_scale == 1.0F);
        student.person.press(Key::escape);
    }
    // an unfinished answer can be continued
    for (const char* const name : {"vector", "pose"}) {
        CAPTURE(name);
        student.begin(name);
        const std::string right = student.right();
        const std::size_t half = right.find('.') + 1;
        student.person.type(right.substr(0, half));
        student.person.press(Key::escape);
        student.person.type(right.substr(half));
        student.person.press(Key::enter);
        student.wait();
        CHECK(student.practice().is_solved());
        student.person.press(Key::escape);
    }
    // what was typed over by mistake comes back
    student.begin("vector");
    student.answer("[1, 2, 3]");
    student.person.type("5");
    CHECK(student.person.host().exercise_text().find("In the field: 5\n") != std::string::npos);
    student.person.press(Key::z, true);
    student.person.press(Key::z, true);
    CHECK(student.person.host().exercise_text().find("In the field: [1, 2, 3]\n") != std::string::npos);
    student.person.press(Key::escape);
    // where no numbers are asked for, digits are commands, as everywhere
    for (const char* const name : {"repair", "experiment"}) {
        CAPTURE(name);
        student.begin(name);
        student.person.type("2");
        CHECK(student.person.host().state().tab == Tab::experiments);
    }
}

TEST_CASE(
    "Somebody who sees nothing is told the list, the question, the answer and what is said of it",
    "[exercises]") {
    Student student;
    const auto tells = [&](const std::string& words) {
        return Json::parse(state_text(student.person.host()))["text"].get<std::string>().find(words) !=
               std::string::npos;
    };
    const auto& all = student.practice().exercises();
    for (std::size_t k = 0; k < all.size(); ++k) {
        const std::string number = std::to_string(k + 1) + ". " + std::string(all[k].exercise->title);
        CAPTURE(number);
        CHECK(tells(number));
        CHECK(tells("Chosen: " + number) == (k == 0));
    }
    student.person.press(Key::down);
    CHECK(tells("Chosen: 2. "));
    for (const std::string& name : kKindsOfExercises) {
        CAPTURE(name);
        student.begin(name);
        const Task& task = *student.practice().task();
        CHECK(tells(task.exercise().title));
        CHECK(tells("Your answer"));
        CHECK(tells(first_words(host::how_to_answer(task))));
        for (const std::string& choice : task.shown) { CHECK(tells(first_words(math::plain_words(choice)))); }
        // the answer to a question about a figure must not be visible in the lesson beside it
        CHECK(tells(student.person.view().title) != (student.person.host().exercises().figure() != nullptr));
        student.person.ask(Command::exercise_hint);
        CHECK(tells("Hint 1") == !task.exercise().hints.empty());
    }
    student.begin("vector");
    const std::vector<HandedMistake> mistakes =
        kind_of(ExerciseKind::vector).mistakes(*student.practice().task());
    REQUIRE_FALSE(mistakes.empty());
    student.answer(mistakes.front().handed.text);
    CHECK(tells("In the field: " + mistakes.front().handed.text));
    CHECK(tells("Not correct: "));
    CHECK(tells("These entries are wrong: "));
    student.person.ask(Command::exercise_anew);
    student.wait();
    CHECK_FALSE(tells("Not correct"));
    student.answer(student.right());
    CHECK(tells("Right."));
    student.person.ask(Command::exercise_solution);
    CHECK(tells("Solution"));
}

TEST_CASE("Nonsense is refused, and what was typed stays, even when Escape leaves the field", "[exercises]") {
    Student student;
    student.begin("number");
    student.answer("nonsense");
    REQUIRE(student.practice().verdict() != nullptr);
    CHECK_FALSE(student.practice().verdict()->judged.understood);
    CHECK(student.practice().record().tried == 0);
    student.person.press(Key::enter);
    student.person.press(Key::end);
    student.person.type("7");
    student.person.press(Key::escape);
    CHECK(student.practice().exercise() != nullptr);
    student.person.press(Key::escape);
    CHECK(student.practice().exercise() == nullptr);
    student.begin("number");
    student.person.press(Key::enter);
    student.person.press(Key::enter);
    // "nonsense7": it was kept
    CHECK_FALSE(student.practice().verdict()->judged.understood);
    CHECK(student.practice().verdict()->judged.feedback.front().find("nonsense") != std::string::npos);
}

TEST_CASE("What is said of an answer comes into sight, however large the letters", "[exercises]") {
    Student student(1280, 720, 1.5F);
    for (const char* const name : {"number", "matrix", "pose"}) {
        CAPTURE(name);
        student.begin(name);
        student.answer(kind_of(student.practice().exercise()->kind)
                           .mistakes(*student.practice().task())
                           .front()
                           .handed.text);
        REQUIRE(student.practice().verdict() != nullptr);
        student.person.rest();
        const ImGuiWindow* const column = ImGui::FindWindowByName("exercises");
        REQUIRE(column != nullptr);
        CHECK(column->Scroll.y > 0.0F);
        // with other numbers the column is at its top again
        student.person.ask(Command::exercise_anew);
        student.wait();
        student.person.rest();
        CHECK(column->Scroll.y == 0.0F);
    }
}

TEST_CASE("Hints and the solution come by keys", "[exercises]") {
    Student student;
    student.begin("number");
    student.person.ask(Command::exercise_hint);
    CHECK(student.practice().hints_given() == 1);
    student.person.ask(Command::exercise_solution);
    CHECK(student.practice().shows_solution());
    student.answer(student.right());
    CHECK_FALSE(student.practice().is_solved());
}

TEST_CASE("A figure takes the place of the lesson's picture while its exercise is looked at", "[exercises]") {
    Student student;
    const std::size_t names = student.person.host().picture().annotations.size();
    student.begin("number");
    REQUIRE(student.person.host().exercises().figure() != nullptr);
    CHECK(&student.person.host().picture() == &student.person.host().shown().picture());
    CHECK(student.person.host().picture().annotations.size() > names);
    // a figure has no steps, and the lesson that nobody sees stays where it is
    const int step = student.person.session().index();
    for (const Key key : {Key::right, Key::end, Key::space}) { student.person.press(key); }
    CHECK(student.person.session().index() == step);
    // digits are for the answer
    student.person.ask(Command::next_tab);
    CHECK(student.person.host().state().tab == Tab::step);
    CHECK(student.person.host().picture().annotations.size() == names);
    student.person.press(Key::right);
    CHECK(student.person.session().index() == step + 1);
    CHECK(fault_of(student.person.host()) == "");
}

TEST_CASE(
    "A sick lesson takes the place of the open one, is mended in an editor, and gives it back",
    "[exercises]") {
    Student student;
    const std::string title = student.person.session().lesson().title;
    student.person.press(Key::right);
    const int step = student.person.session().index();
    student.begin("repair");
    REQUIRE(student.person.host().exercises().has_aside());
    const std::filesystem::path copy = student.person.host().exercises().work().file;
    REQUIRE(std::filesystem::exists(copy));
    std::ofstream(copy) << student.right();
    std::filesystem::last_write_time(copy, std::filesystem::last_write_time(copy) + std::chrono::seconds(2));
    CHECK(student.person.host().look_at_file());
    student.person.press(Key::enter);
    student.person.press(Key::enter, true);
    student.wait();
    REQUIRE(student.practice().verdict() != nullptr);
    CAPTURE(student.practice().verdict()->judged.feedback);
    CHECK(student.practice().is_solved());
    student.person.ask(Command::exercise_list);
    student.person.settle();
    CHECK_FALSE(student.person.host().exercises().has_aside());
    CHECK(student.person.session().lesson().title == title);
    CHECK(student.person.session().index() == step);
}

TEST_CASE("Experiments in the window are listed and judged, and undone ones are not", "[exercises]") {
    Student student;
    student.begin("experiment");
    REQUIRE(student.person.host().exercises().has_aside());
    const auto check = [&] {
        const Widget button = find(student.person, "exercises", {"Check"});
        student.person.click(button.x, button.y);
        student.wait();
    };
    check();
    CHECK(student.practice().verdict()->judged.mistake == "nothing-done");
    student.person.ask(Command::tab_experiments);
    const Widget form = find(student.person, "try", {"joint of try it", 0, "pair of n1 (n2)"});
    student.person.click(form.x, form.y);
    CHECK(
        student.person.host().exercises().work().experiments == std::vector<std::string>{"form hinge pair"});
    student.person.ask(Command::undo);
    CHECK(student.person.host().exercises().work().experiments.empty());
    student.person.ask(Command::redo);
    student.person.ask(Command::tab_exercises);
    check();
    CAPTURE(student.practice().verdict()->judged.feedback);
    CHECK(student.practice().is_solved());
}

TEST_CASE("Progress survives a new window", "[exercises]") {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.write("mine/all-kinds.toml", lesson_with_exercises());
    host::HostSetup setup;
    setup.catalogue = catalogue_folder();
    setup.progress = folder.path() / "progress.toml";
    for (const int solved : {0, 1}) {
        host::Host window(setup);
        REQUIRE(window.open(file));
        REQUIRE(window.begin_exercise("choose"));
        const Practice& practice = window.exercises().practice();
        CHECK(practice.record().solved == solved);
        window.push(host::InputEvent::pressed(Key::enter));
        window.push(host::InputEvent::pressed(Key::enter, false));
        for (int k = 0; k < 4; ++k) { window.frame(0.02); }
        const std::string right = kind_of(ExerciseKind::choose).right(*practice.task()).text;
        for (const char c : right) { window.push(host::InputEvent::typed(static_cast<unsigned char>(c))); }
        window.frame(0.02);
        window.push(host::InputEvent::pressed(Key::enter));
        window.push(host::InputEvent::pressed(Key::enter, false));
        for (int k = 0; k < 4; ++k) { window.frame(0.02); }
        CHECK(practice.is_solved());
    }
}

TEST_CASE(
    "Every letter of every kind of exercise can be read, at any size of text and of the window", "[text]") {
    for (const auto& [width, height] : {std::pair{900, 600}, std::pair{1280, 720}}) {
        for (const float text : {0.75F, 1.0F, 1.25F, 1.5F}) {
            Student student(width, height, text);
            student.person.ask(Command::tab_exercises);
            student.person.rest();
            CAPTURE(width, text);
            CHECK(unreadable_letters().empty());
            for (const std::string& name : kKindsOfExercises) {
                CAPTURE(name);
                student.begin(name);
                student.person.ask(Command::exercise_hint);
                student.person.rest();
                std::vector<std::string> faults = unreadable_letters();
                // long lines of a file, and formulas wider than the column, scroll sideways in their fields
                if (text > 1.0F) {
                    std::erase_if(faults, [](const std::string& fault) { return fault.ends_with("is cut"); });
                }
                CHECK((faults.empty() ? "" : faults.front()) == std::string());
            }
        }
    }
}

}  // namespace jw::test
