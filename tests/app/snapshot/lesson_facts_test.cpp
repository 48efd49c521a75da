#include <catch2/catch.hpp>

#include "app/snapshot/fact_changes.hpp"
#include "lessons/reader.hpp"
#include "tests/app/program.hpp"

namespace jw::snapshot {
namespace {

/// Changes of the facts about a lesson with springs where a piece of its text is another.
std::vector<FactChange> changed_facts(const std::string& from, const std::string& to) {
    const std::string before = test::bytes_of(test::lesson_path("dynamics/governor.toml"));
    std::string now = before;
    const std::size_t at = now.find(from);
    REQUIRE(at != std::string::npos);
    now.replace(at, from.size(), to);
    const ReadResult a = read_lesson(before, "before.toml");
    const ReadResult b = read_lesson(now, "now.toml");
    INFO(b.report());
    REQUIRE(b.lesson);
    return changes_of(facts_of(*a.lesson), facts_of(*b.lesson));
}

FactChange only_change(const std::string& from, const std::string& to) {
    const std::vector<FactChange> found = changed_facts(from, to);
    REQUIRE(found.size() == 1);
    return found.front();
}

}  // namespace

TEST_CASE("title, masses, gravity and springs of a lesson are facts", "[snapshot]") {
    CHECK(
        only_change("A stiff flyball governor", "A governor") ==
        FactChange{Weight::text, "title of the lesson", "A stiff flyball governor", "A governor"});
    CHECK(
        only_change("mass = 0.3 ", "mass = 0.31 ") ==
        FactChange{Weight::pose, "shaft · mass", "0.3 kg", "0.31 kg"});
    CHECK(only_change("0.9716981132075473", "0.97").name == "right rod · centre of mass · x");
    CHECK(only_change("-9.81]", "-1.62]").name == "gravity · z");
    CHECK(only_change("stiffness = 800000", "stiffness = 800001").name == "spring 1 · stiffness");
    CHECK(only_change("damping = 40000", "damping = 0").name == "spring 1 · damping");
    CHECK(only_change("free_length = 0.5", "free_length = 0.51").name == "spring 1 · free length");
    CHECK(only_change("[0.05, 0, 0]\npoint_j", "[0.06, 0, 0]\npoint_j").name == "spring 1 · from · x");
}

TEST_CASE("a small moment of inertia beside large ones is compared", "[snapshot]") {
    CHECK(
        only_change("inertia = [0.0250025, 0.0250025, 5e-6]", "inertia = [0.0250025, 0.0250025, 6e-6]")
            .name == "shaft · J′ · zz");
}

TEST_CASE("a lesson without dynamics tells its title only", "[snapshot]") {
    const ReadResult read = read_lesson(test::kCrank, "crank.toml");
    REQUIRE(read.lesson);
    const std::vector<Fact> facts = facts_of(*read.lesson);
    REQUIRE(facts.size() == 1);
    CHECK(facts[0].text == "A crank");
}

}  // namespace jw::snapshot
