#include <catch2/catch.hpp>

#include "app/snapshot/facts/fact_changes.hpp"
#include "lessons/read/reader.hpp"
#include "tests/app/program.hpp"

namespace jw::snapshot {
namespace {

std::string governor() { return test::bytes_of(test::lesson_path("dynamics/governor.toml")); }

/// The governor with loads of every kind.
std::string with_loads() {
    return governor() + R"(
[[force]]
body = 'shaft'
point = [0, 0, 0.25]
force = [0, 0, 5]
[[force]]
body = 'left rod'
direction = [0, 1, 0]
frame = 'local'
polynomial = [9e8, 2]
[[torque]]
body = 'left rod' # of the torque
direction = [1, 0, 0]
harmonics = [{ amplitude = 0.5, frequency_hz = 2 }]
step = [{ to = 4, end_s = 0.5 }]
[[torque]]
body = 'right rod'
against = 'shaft'
torque = [0, 0, 1]
table = { times_s = [0, 1000], values = [1, 2] }
)";
}

/// Changes of the facts about a lesson when `from` in its text is replaced by `to`.
std::vector<FactChange> changed_facts(
    const std::string& before, const std::string& from, const std::string& to) {
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

FactChange only_change_of(const std::string& before, const std::string& from, const std::string& to) {
    const std::vector<FactChange> found = changed_facts(before, from, to);
    REQUIRE(found.size() == 1);
    return found.front();
}

FactChange only_change(const std::string& from, const std::string& to) {
    return only_change_of(governor(), from, to);
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

TEST_CASE("forces and torques of a lesson are facts, each of its own scale", "[snapshot]") {
    // beside a force of 9e8 N, which would hide the others
    const auto change = [](const std::string& from, const std::string& to) {
        return only_change_of(with_loads(), from, to);
    };
    CHECK(
        change("force = [0, 0, 5]", "force = [0, 0, 6]") ==
        FactChange{Weight::pose, "force 1 · z", "5 N", "6 N"});
    CHECK(change("point = [0, 0, 0.25]", "point = [0, 0, 0.2]").name == "force 1 · at · z");
    CHECK(change("frame = 'local'", "frame = 'global'").name == "force 2 · frame");
    CHECK(
        change("polynomial = [9e8, 2]", "polynomial = [9e8, 3]") ==
        FactChange{Weight::pose, "force 2 · c1", "2 N/s", "3 N/s"});
    CHECK(change("amplitude = 0.5", "amplitude = 0.6").name == "torque 1 · harmonic 1 · amplitude");
    CHECK(change("frequency_hz = 2", "frequency_hz = 3").name == "torque 1 · harmonic 1 · ω");
    CHECK(change("to = 4", "to = 5").name == "torque 1 · step 1 · to");
    CHECK(change("end_s = 0.5", "end_s = 0.6").name == "torque 1 · step 1 · end");
    CHECK(
        change("values = [1, 2]", "values = [1, 3]") ==
        FactChange{Weight::pose, "torque 2 · value 2", "2 N m", "3 N m"});
    CHECK(change("times_s = [0, 1000]", "times_s = [0, 1001]").name == "torque 2 · value 2 · time");
    CHECK(
        change("values = [1, 2]", "values = [1, 2], interpolation = 'monotone'").name ==
        "torque 2 · between values");
    CHECK(change("against = 'shaft'", "against = 'left rod'").name == "torque 2 · against");
    CHECK(
        change("body = 'left rod' # of the torque", "body = 'right rod'") ==
        FactChange{Weight::count, "torque 1", "on left rod", "on right rod"});
}

TEST_CASE("a load that is written otherwise is the same load", "[snapshot]") {
    CHECK(
        changed_facts(with_loads(), "force = [0, 0, 5]", "direction = [0, 0, 2]\npolynomial = [5]").empty());
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
