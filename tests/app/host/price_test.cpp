#include <catch2/catch.hpp>

#include <stdexcept>

#include "lessons/files/catalogue.hpp"
#include "tests/app/host/checks.hpp"
#include "tests/app/host/reach.hpp"

namespace jw::test {
namespace {

using host::Command;

constexpr const char* kPrice = "price";

void press_button(Person& person, const char* label) {
    const Widget widget = find(person, kPrice, {label});
    person.click(widget.x, widget.y);
}

bool offers(Person& person, const char* label) {
    try {
        find(person, kPrice, {label});
    } catch (const std::runtime_error&) { return false; }
    return true;
}

}  // namespace

TEST_CASE("A lesson of dynamics is measured while the window goes on, until somebody stops it") {
    Person person("dynamics/simple-pendulum.toml");
    person.ask(Command::tab_price);
    press_button(person, "Measure");
    CHECK(offers(person, "Stop"));
    // the window looks again without an event
    CHECK(person.host().seconds_to_change() < 0.3);
    person.press(host::Key::right);
    CHECK(fault_of(person.host()) == "");
    press_button(person, "Stop");
    CHECK(offers(person, "Measure"));
    person.rest();
    CHECK(person.host().seconds_to_change() >= 0.4);
}

TEST_CASE("A measurement ends where its lesson becomes another") {
    Person person("dynamics/simple-pendulum.toml");
    person.ask(Command::tab_price);
    press_button(person, "Measure");
    REQUIRE(person.host().open(catalogue_folder() / "dynamics" / "spinning-top.toml"));
    person.settle();
    CHECK(offers(person, "Measure"));
}

TEST_CASE("Without masses there is nothing to measure, and the panel says so") {
    Person person("loops/four-bar.toml");
    person.ask(Command::tab_price);
    CHECK_FALSE(offers(person, "Measure"));
    CHECK(fault_of(person.host()) == "");
}

}  // namespace jw::test
