#include <catch2/catch.hpp>

#include "lessons/files/catalogue.hpp"
#include "tests/app/host/checks.hpp"
#include "tests/app/host/person.hpp"

namespace jw::test {
namespace {

using host::Address;
using host::Command;
using host::fragment_of;
using host::read_address;

std::string address_of(Person& person) { return fragment_of(person.host().address()); }

bool go_to(Person& person, const std::string& address) {
    const bool arrived = person.host().go_to(read_address(address));
    person.settle();
    return arrived;
}

}  // namespace

TEST_CASE("What is done in the window stands in its address", "[address]") {
    Person person("loops/four-bar.toml");
    CHECK(address_of(person) == "four-bar");
    person.go_to(4);
    CHECK(address_of(person) == "four-bar/5");
    person.ask(Command::tab_plot);
    CHECK(address_of(person) == "four-bar/5?tab=plots");
    person.ask(Command::tab_step);
    person.ask(Command::view_top);
    // the address has the view that the camera turns to, from the beginning
    const std::string turned = address_of(person);
    CHECK(turned.starts_with("four-bar/5?camera="));
    person.rest();
    CHECK(address_of(person) == turned);
    person.ask(Command::fit);
    person.rest();
    CHECK(address_of(person) == "four-bar/5");
    person.ask(Command::lessons);
    CHECK(address_of(person).empty());
}

TEST_CASE("An address in the open lesson is one change, and undo leads back", "[address]") {
    Person person("loops/four-bar.toml");
    person.go_to(4);
    REQUIRE(go_to(person, "#four-bar/D?try=form+D+drop+x&try=take+out+motor&tab=plots"));
    CHECK(person.session().lesson().mechanism.joints[3].parallel_form == ParallelForm::drop_x);
    CHECK(person.host().state().tab == host::Tab::plot);
    const int there = person.session().index();
    person.ask(Command::undo);
    CHECK(address_of(person) == "four-bar/5?tab=plots");
    CHECK_FALSE(person.session().is_changed());
    person.ask(Command::redo);
    CHECK(person.session().index() == there);
    // going elsewhere in the same lesson is not a change
    const std::uint64_t told = person.session().told();
    REQUIRE(go_to(person, "#four-bar?try=form+D+drop+x&try=take+out+motor"));
    CHECK(person.session().told() == told);
    CHECK(person.session().index() == 0);
    CHECK(fault_of(person.host()) == "");
}

TEST_CASE("An address of another lesson opens it, and one without a lesson shows them all", "[address]") {
    Person person("loops/four-bar.toml");
    REQUIRE(go_to(person, "#screw-jack/2?try=coordinates+omega-local"));
    CHECK(person.session().lesson().mechanism.joints[0].name != "A");
    CHECK(address_of(person) == "screw-jack/2?try=coordinates+omega-local");
    person.ask(Command::undo);
    CHECK(address_of(person) == "screw-jack");
    REQUIRE(go_to(person, "https://example.org/jointwise/"));
    CHECK_FALSE(person.host().shows_lesson());
    REQUIRE(go_to(person, "#screw-jack"));
    CHECK(person.host().shows_lesson());
}

TEST_CASE("An address that leads nowhere says why and changes nothing", "[address]") {
    Person person("loops/four-bar.toml");
    REQUIRE(go_to(person, "#four-bar/5?try=form+D+drop+x&joint=A&tab=plots&camera=3+-4+2.5+to+0+0+0"));
    const std::string before = address_of(person);
    const std::uint64_t version = person.session().version();
    struct Case {
        std::string address;
        std::string says;
    };
    for (const Case& c : std::vector<Case>{
             {"#four-bor", "no lesson 'four-bor'\nhint: did you mean 'four-bar'?"},
             {"#four-bar/E", "no place 'E' in the lesson; expected a step from 1 to "},
             {"#four-bar/E?try=form+D+drop+x", "no place 'E'"},
             {"#four-bar?tab=plot", "no tab 'plot'; expected one of step, try, plots"},
             {"#four-bar?joint=motor", "no joint 'motor'; expected one of A, B, C, D"},
             {"#four-bar?try=form+D+drop+x&try=form+E+rule",
              "'form E rule': no joint 'E'; expected one of A"},
             {"#four-bar?try=take+out+D&try=take+out+D", "'take out D': D is already taken out"},
             {"#screw-jack?try=form+D+rule", "'form D rule': no joint 'D'"},
         }) {
        INFO(c.address);
        CHECK_FALSE(go_to(person, c.address));
        const std::string& said = person.host().notice().mistakes();
        INFO(said);
        CHECK(said.starts_with("This address cannot be opened: "));
        CHECK(said.find(c.says) != std::string::npos);
        CHECK(address_of(person) == before);
        CHECK(person.session().version() == version);
    }
    REQUIRE(go_to(person, "#four-bar"));
    CHECK(person.host().notice().mistakes().empty());
}

TEST_CASE("Lessons are named by their files, with the folder where two have the same name", "[address]") {
    const TemporaryFolder folder;
    for (const char* name : {"a/one.toml", "a/two.toml", "b/two.toml", "two.toml"}) {
        folder.write(name, "");
    }
    const std::filesystem::path mine = "elsewhere/mine.toml";
    const auto name_of = [&](const std::string& file) {
        return host::name_in_addresses(folder.path() / file, folder.path());
    };
    CHECK(name_of("a/one.toml") == "one");
    CHECK(name_of("a/two.toml") == "a/two");
    CHECK(name_of("two.toml") == "two");
    CHECK(host::name_in_addresses(mine, folder.path()) == "mine.toml");
    const auto at = [&](const std::string& name) {
        return host::lesson_at_address(name, folder.path(), {mine});
    };
    for (const char* name : {"a/one.toml", "a/two.toml", "b/two.toml", "two.toml"}) {
        CHECK(at(name_of(name)) == folder.path() / name);
    }
    CHECK(at("one.toml") == folder.path() / "a/one.toml");
    CHECK(at("a/one") == folder.path() / "a/one.toml");
    CHECK(at("mine.toml") == mine);
    CHECK_THROWS_AS(at("mine"), std::runtime_error);
    std::filesystem::remove(folder.path() / "two.toml");
    CHECK_THROWS_WITH(at("two"), "several lessons are called 'two'; expected one of a/two, b/two");
}

TEST_CASE("An exercise stands in the address, which begins it in another window", "[address][exercises]") {
    Person person("loops/four-bar.toml");
    const auto exercise = [](Person& of) {
        const Exercise* const begun = of.host().exercises().practice().exercise();
        return begun == nullptr ? std::string() : begun->name;
    };
    person.ask(Command::tab_exercises);
    person.host().wait_for_exercises();
    REQUIRE(person.host().exercises().practice().exercises().size() > 1);
    const std::string name = person.host().exercises().practice().exercises()[1].exercise->name;
    REQUIRE(person.host().begin_exercise(name));
    const std::string address = address_of(person);
    CHECK(address == "four-bar?exercise=" + name);
    // the numbers stay if the address is that of what is already shown
    const int made = person.host().exercises().practice().tasks_made();
    REQUIRE(go_to(person, address));
    CHECK(person.host().exercises().practice().tasks_made() == made);

    Person other("joints/revolute.toml");
    REQUIRE(go_to(other, address));
    other.host().wait_for_exercises();
    other.settle();
    CHECK(exercise(other) == name);
    CHECK(other.host().exercises().practice().task() != nullptr);
    CHECK(address_of(other) == address);
    CHECK(fault_of(other.host()) == "");
    // the list of the tab, and the step
    REQUIRE(go_to(other, "#four-bar?tab=exercises"));
    CHECK(exercise(other).empty());
    CHECK(address_of(other) == "four-bar?tab=exercises");

    REQUIRE(go_to(other, "#four-bar?exercise=nonsense"));
    other.host().wait_for_exercises();
    other.settle();
    CHECK(exercise(other).empty());
    CHECK(other.host().notice().mistakes().find("has no exercise 'nonsense'") != std::string::npos);
}

}  // namespace jw::test
