#include <catch2/catch.hpp>

#include <sstream>

#include "tests/soak/runner.hpp"

using namespace jw;

namespace {

const test::Property& property(const std::string& name) {
    for (const test::Property& one : test::properties()) {
        if (one.name == name) { return one; }
    }
    FAIL("no property " << name);
    return test::properties().front();
}

/// Checks `count` mechanisms for each of the first seeds; ./dev soak checks hours of it.
void ask_of_first_seeds(const std::string& name, int count) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        test::Asked asked;
        asked.seed = seed;
        asked.count = count;
        CAPTURE(name, seed, count);
        const test::Answer answer = test::ask(property(name), asked);
        INFO((answer.wrong ? answer.wrong->why + '\n' + answer.wrong->recipe : std::string()));
        CHECK(!answer.wrong);
        // a property that was checked on no mechanism proves nothing
        CHECK(answer.held > 0);
    }
}

}  // namespace

TEST_CASE("A recipe survives writing and reading", "[soak]") {
    test::Recipe recipe;
    recipe.family = test::Family::planar;
    recipe.near = 3;
    recipe.length_decade = -2;
    recipe.afloat = recipe.at_rest = true;
    recipe.seed = 12;
    recipe.bodies = {{1, test::kFreeBody, 2, -3, true, 4}, {}};
    recipe.joints = {{1, 2, 3, 4, true, 5, 6}};
    recipe.drivers = {{1, 2, 3, 4, 5, 6}};
    recipe.loads = {{1, 2, 3, true, 5}};
    std::ostringstream written;
    written << recipe;
    std::istringstream among("other words\n" + written.str() + "\nothers\n");
    const auto read = test::recipe_in(among);
    REQUIRE(read);
    std::ostringstream again;
    again << *read;
    CHECK(again.str() == written.str());
    std::istringstream none("other words\n");
    CHECK_FALSE(test::recipe_in(none));
}

TEST_CASE("Generated mechanisms that once failed a property now have it", "[soak]") {
    int asked = 0;
    for (const auto& file : std::filesystem::directory_iterator(JW_ONCE_WRONG)) {
        CAPTURE(file.path().filename());
        const test::WrittenDown written = test::read_counterexample(file.path());
        const test::Verdict verdict = test::ask_of(property(written.property), written.recipe);
        CAPTURE(verdict.why);
        CHECK(verdict.kind == test::Verdict::Kind::holds);
        ++asked;
    }
    CHECK(asked > 5);
}

TEST_CASE("The rank of generated mechanisms is that of a QR in long double", "[soak]") {
    ask_of_first_seeds("rank", 1000);
}

TEST_CASE("Jacobians of generated mechanisms are differences of the reference in long double", "[soak]") {
    ask_of_first_seeds("jacobian", 200);
}

TEST_CASE("Singular values of generated mechanisms are those of a Jacobi method in long double", "[soak]") {
    ask_of_first_seeds("spectrum", 300);
}

TEST_CASE("Velocities and accelerations of driven mechanisms are those of the reference", "[soak]") {
    ask_of_first_seeds("kinematics", 1000);
}

TEST_CASE("Disturbed mechanisms assemble again", "[soak]") { ask_of_first_seeds("assembly", 1000); }

TEST_CASE("Accelerations are the same in all forms of the equations and in long double", "[soak]") {
    ask_of_first_seeds("accelerations", 1000);
}

TEST_CASE("Power of forces and drivers equals the change of energy", "[soak]") {
    ask_of_first_seeds("energy", 1000);
}

TEST_CASE("Nothing changes the momentum of generated mechanisms that float", "[soak]") {
    ask_of_first_seeds("momentum", 200);
}

TEST_CASE("Generated mechanisms turned, mirrored and in other units have the same answers", "[soak]") {
    ask_of_first_seeds("transformed", 1000);
}

TEST_CASE("Motions of generated mechanisms played backwards come back", "[soak]") {
    ask_of_first_seeds("reversed", 60);
}

TEST_CASE("Driven trees move as the product of their joints' motions in every method", "[soak]") {
    ask_of_first_seeds("driven", 300);
}

TEST_CASE("Every method converges to the motion of the reference", "[soak]") {
    ask_of_first_seeds("motions", 60);
}

TEST_CASE("Reactions and loads satisfy the equations of Newton and Euler", "[soak]") {
    ask_of_first_seeds("reactions", 1000);
}
