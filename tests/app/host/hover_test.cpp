#include <catch2/catch.hpp>

#include <algorithm>
#include <set>

#include "tests/app/host/checks.hpp"
#include "tests/app/host/looking.hpp"
#include "tests/app/host/person.hpp"

namespace jw::test {
namespace {

using host::Key;

/// The four-bar where joint A shows its equations, drawn.
std::unique_ptr<Person> at_equations() {
    auto person = std::make_unique<Person>("loops/four-bar.toml", Person::Pictures::drawn);
    person->go_to(1);
    person->picture();
    return person;
}

Emphasis emphasis(Person& person) {
    return {*person.session().step().system, 4, person.host().state().pointed_at};
}

}  // namespace

TEST_CASE("Pointing at a row of equations or matrix outlines its joint and its vectors in the picture") {
    const auto person = at_equations();
    REQUIRE_FALSE(
        lit_in(person->host().picture()).contains(picture_id(Pointable::vector(0, Pointable::kVectorI))));
    const panels::Box column = person->host().layout().column;
    REQUIRE(look_for(
        *person, column, 7.0F, [](const Pointable& link) { return link.kind == Pointable::Kind::row; }));
    const std::set<int> lit = lit_in(person->host().picture());
    CHECK(lit.contains(picture_id(Pointable::vector(0, Pointable::kVectorI))));
    CHECK(lit.contains(picture_id(Pointable::vector(0, Pointable::kVectorJ))));
}

TEST_CASE("Pointing at a symbol of a formula outlines that vector alone") {
    const auto person = at_equations();
    const panels::Box column = person->host().layout().column;
    const Pointable wanted = Pointable::vector(0, Pointable::kVectorJ);
    REQUIRE(look_for(*person, column, 5.0F, [&](const Pointable& link) { return link == wanted; }));
    const std::set<int> lit = lit_in(person->host().picture());
    CHECK(lit.contains(picture_id(wanted)));
    CHECK_FALSE(lit.contains(picture_id(Pointable::vector(0, Pointable::kVectorI))));
}

TEST_CASE("Pointing at a vector in the picture lights up the rows that it is in") {
    const auto person = at_equations();
    const panels::Box scene = panels::box_of(person->host().layout().scene);
    const std::set<int> at_rest = lit_in(person->host().picture());
    REQUIRE(look_for(*person, scene, 6.0F, [](const Pointable& l) {
        return l.kind == Pointable::Kind::vector && l.index == 0;
    }));
    const Emphasis lit = emphasis(*person);
    int rows = 0;
    for (int row = 0; row < person->session().step().system->rows(); ++row) {
        rows += lit.contains(Pointable::row(row)) ? 1 : 0;
    }
    CHECK(rows > 0);
    CHECK(lit_in(person->host().picture()) != at_rest);
    const std::uint64_t version = person->host().shown().version();
    person->point(scene.x + 2.0F, scene.y + 2.0F);
    CHECK(person->host().shown().version() > version);
    CHECK(lit_in(person->host().picture()) == at_rest);
}

TEST_CASE("Pointing at a body in the picture lights up its columns, and it can be pulled there") {
    const auto person = at_equations();
    const panels::Box scene = panels::box_of(person->host().layout().scene);
    REQUIRE(look_for(*person, scene, 8.0F, [](const Pointable& link) { return link == Pointable::body(2); }));
    const Emphasis lit = emphasis(*person);
    const int first = person->session().step().system->body_column(2, 4);
    for (int k = 0; k < 7; ++k) { CHECK(lit.contains(Pointable::column(first + k))); }
    CHECK(lit_in(person->host().picture()).contains(picture_id(Pointable::body(2))));

    host::Host& host = person->host();
    host.push(host::InputEvent::button(0, true));
    person->settle();
    host.push(host::InputEvent::pointer(400.0F, 200.0F));
    person->settle();
    host.push(host::InputEvent::button(0, false));
    person->settle();
    const auto r = [](const Lesson& lesson) { return lesson.mechanism.bodies[2].r; };
    CHECK((r(person->session().lesson()) - r(person->session().as_written())).norm() > 1e-3);
}

TEST_CASE("A click on a joint chooses whose vectors and equations are seen while everything moves") {
    Person person("loops/four-bar.toml");
    const int moment = person.session().index_of_time(0.5);
    person.go_to(moment);
    REQUIRE(person.view().equations.empty());
    person.host().set_picker([](float, float) { return picture_id(Pointable::joint(2)); });
    const render::Rect& scene = person.host().layout().scene;
    const auto x = static_cast<float>(scene.x + scene.width / 2);
    const auto y = static_cast<float>(scene.y + scene.height / 2);
    person.click(x, y);
    CHECK(person.session().index() == moment);
    REQUIRE_FALSE(person.view().equations.empty());
    CHECK(person.view().equations.front().joint == 2);
    person.click(x, y);
    CHECK(person.view().equations.empty());
    // a drag is not a click
    person.drag(x, y, x + 1.0F, y + 40.0F);
    CHECK(person.view().equations.empty());
}

TEST_CASE("A saved picture is what is on the screen, and p writes it into the folder for pictures") {
    const auto person = at_equations();
    person->type("p");
    const render::Image image = person->picture();
    const auto file = person->folder().path() / "four-bar-step-2.png";
    REQUIRE(std::filesystem::exists(file));
    // more than one colour
    CHECK(std::ranges::adjacent_find(image.rgb, std::not_equal_to<>()) != image.rgb.end());
    CHECK(person->host().notice().text().find("four-bar-step-2.png") != std::string::npos);
    CHECK(person->host().task() == host::DrawingTask::none);
}

TEST_CASE("Windows of any size show the lesson, light and dark, with large text and small") {
    Person person("loops/four-bar.toml");
    person.go_to(6);
    for (const auto& [width, height] : {std::pair(640, 400), std::pair(1000, 1300), std::pair(2560, 1440)}) {
        person.host().resize(width, height);
        for (const char* const change : {"d", "+", "+", "-", "-", "-", "d"}) {
            person.type(change);
            for (const char* const tab : {"1", "2", "3", "4"}) {
                person.type(tab);
                INFO(width << " x " << height << ", tab " << tab);
                CHECK(fault_of(person.host()) == "");
            }
        }
    }
}

}  // namespace jw::test
