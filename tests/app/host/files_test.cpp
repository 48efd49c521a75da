#include <catch2/catch.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>

#include <imgui.h>

#include "app/session/output/export.hpp"
#include "lessons/files/catalogue.hpp"
#include "lessons/read/reader.hpp"
#include "tests/app/host/checks.hpp"
#include "tests/app/host/person.hpp"

namespace jw::test {
namespace {

using host::Command;

std::string text_of_file(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string four_bar() { return text_of_file(catalogue_folder() / "loops" / "four-bar.toml"); }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

/// Saves a file as an editor does, some time after the last one.
void save(const std::filesystem::path& file, const std::string& text) {
    static int seconds = 0;
    std::ofstream(file, std::ios::binary) << text;
    std::filesystem::last_write_time(
        file, std::filesystem::file_time_type::clock::now() + std::chrono::seconds(++seconds));
}

std::string copied() {
    const char* const text = ImGui::GetClipboardText();
    return text == nullptr ? std::string() : text;
}

}  // namespace

TEST_CASE("A file that is saved anew is shown at the same step with its new numbers") {
    const TemporaryFolder folder;
    const auto file = folder.write("mine.toml", four_bar());
    Person person(file.string());
    person.go_to(9);
    const std::string title = person.view().title;
    const Vec3 before = person.session().lesson().mechanism.bodies[1].r;
    CHECK_FALSE(person.host().look_at_file());

    save(file, replaced(four_bar(), "position = [-0.48,", "position = [-0.45,"));
    CHECK(person.host().look_at_file());
    person.settle();
    CHECK(person.session().index() == 9);
    CHECK(person.view().title == title);
    CHECK(person.session().lesson().mechanism.bodies[1].r.x() == -0.45);
    CHECK(person.session().lesson().mechanism.bodies[1].r != before);
    CHECK_FALSE(person.host().look_at_file());
    CHECK(person.host().notice().mistakes().empty());
    person.ask(Command::undo);
    CHECK(person.session().lesson().mechanism.bodies[1].r == before);
    CHECK_FALSE(person.session().is_changed());
}

TEST_CASE("Mistakes in a file that is saved anew are told with line and column, the last good lesson stays") {
    const TemporaryFolder folder;
    const auto file = folder.write("mine.toml", four_bar());
    Person person(file.string());
    person.go_to(9);
    const std::string before = text_of(person.view());
    save(file, replaced(four_bar(), "type = \"revolute\"", "type = \"revolut\""));
    CHECK(person.host().look_at_file());
    person.settle();
    const std::string errors = person.host().notice().mistakes();
    INFO(errors);
    const std::string text = four_bar();
    const auto place = text.begin() + static_cast<std::ptrdiff_t>(text.find("type = \"revolute\""));
    const std::string line = std::to_string(std::count(text.begin(), place, '\n') + 1);
    CHECK(errors.find("mine.toml:" + line + ":") != std::string::npos);
    CHECK(errors.find("revolut") != std::string::npos);
    CHECK(text_of(person.view()) == before);
    CHECK(fault_of(person.host()) == "");

    save(file, four_bar());
    CHECK(person.host().look_at_file());
    CHECK(person.host().notice().mistakes().empty());
    CHECK(person.session().index() == 9);
    CHECK(text_of(person.view()) == before);
}

TEST_CASE("A file that is gone, or empty for a moment, changes nothing") {
    const TemporaryFolder folder;
    const auto file = folder.write("mine.toml", four_bar());
    Person person(file.string());
    person.go_to(3);
    std::filesystem::remove(file);
    CHECK_FALSE(person.host().look_at_file());
    save(file, "");
    person.host().look_at_file();
    person.settle();
    CHECK(person.session().index() == 3);
    CHECK(person.session().lesson().mechanism.joints.size() == 4);
}

TEST_CASE("The open lesson may become another one with fewer bodies, whatever is pointed at or held") {
    const TemporaryFolder folder;
    const auto file = folder.write("mine.toml", four_bar());
    const std::string small = text_of_file(catalogue_folder() / "joints" / "revolute.toml");
    Person person(file.string());
    person.host().set_picker([](float, float) { return picture_id(Pointable::body(3)); });
    person.go_to(12);
    person.point(300.0F, 300.0F);
    REQUIRE(person.host().state().pointed_at == Pointable::body(3));
    person.host().push(host::InputEvent::button(0, true));
    person.settle();
    save(file, small);
    CHECK(person.host().look_at_file());
    person.host().set_picker({});
    person.point(340.0F, 330.0F);
    person.host().push(host::InputEvent::button(0, false));
    person.settle();
    CHECK(person.session().lesson().mechanism.bodies.size() < 4);
    CHECK(fault_of(person.host()) == "");
}

TEST_CASE("What is tried can be saved as a lesson, and read back the same") {
    Person person("loops/four-bar.toml");
    person.host().set_picker([](float, float) { return picture_id(Pointable::body(1)); });
    person.go_to(4);
    person.drag(300.0F, 300.0F, 360.0F, 330.0F);
    REQUIRE(person.session().is_changed());
    person.ask(Command::save_lesson);
    const ReadResult read = read_lesson_file(person.folder().path() / "four-bar-changed.toml");
    INFO(person.host().notice().text() << read.report());
    REQUIRE(read.lesson);
    const Session again(*read.lesson);
    const Story& story = person.session().story();
    REQUIRE(again.story().steps().size() == story.steps().size());
    for (int k = 0; k <= story.last_assembled(); ++k) {
        CHECK(text_of(view_of(again.story(), k)) == text_of(view_of(story, k)));
    }
    person.ask(Command::save_lesson);
    CHECK(std::filesystem::exists(person.folder().path() / "four-bar-changed-2.toml"));
}

TEST_CASE("Numbers of the plot are saved as a table, a line per moment") {
    Person person("loops/four-bar.toml");
    person.type("3");
    person.ask(Command::save_csv);
    const std::string text = text_of_file(person.folder().path() / "four-bar-quantities.csv");
    CHECK(std::ranges::count(text, '\n') == 202);  // 201 moments and their head
}

TEST_CASE("Equations and the matrix go to the clipboard") {
    Person person("loops/four-bar.toml");
    person.ask(Command::copy_equation);
    CHECK(person.host().notice().text() == "There is no equation at this step.");
    person.go_to(1);
    person.ask(Command::copy_equation);
    CHECK(copied().find(equation_latex(person.view().equations.front())) == 0);
    person.ask(Command::copy_matrix);
    CHECK(copied() == matrix_latex(person.view().matrix, MatrixStyle::labelled));
    person.ask(Command::copy_matrix_csv);
    CHECK(copied() == matrix_csv(person.view().matrix));
}

}  // namespace jw::test
