#include <catch2/catch.hpp>

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

/// Of so many mechanisms each of the first seeds; hours of it are ./dev soak.
void ask_of_first_seeds(const std::string& name, int count) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        test::Asked asked;
        asked.seed = seed;
        asked.count = count;
        CAPTURE(name, seed, count);
        const test::Answer answer = test::ask(property(name), asked);
        INFO((answer.wrong ? answer.wrong->why + '\n' + answer.wrong->recipe : std::string()));
        CHECK(!answer.wrong);
        // a property that is asked of nothing says nothing
        CHECK(answer.held > 0);
    }
}

}  // namespace

TEST_CASE("The rank of generated mechanisms is that of a QR in long double", "[soak]") {
    ask_of_first_seeds("rank", 1000);
}

TEST_CASE("Velocities and accelerations of driven mechanisms are those of the reference", "[soak]") {
    ask_of_first_seeds("kinematics", 1000);
}

TEST_CASE("Generated mechanisms that are pushed off come back onto the constraints", "[soak]") {
    ask_of_first_seeds("assembly", 1000);
}

TEST_CASE("Accelerations are the same in all forms of the equations and in long double", "[soak]") {
    ask_of_first_seeds("accelerations", 60);
}

TEST_CASE("Power and energy of generated mechanisms are what forces and drivers put in", "[soak]") {
    ask_of_first_seeds("energy", 100);
}

TEST_CASE("Nothing changes the momentum of generated mechanisms that float", "[soak]") {
    ask_of_first_seeds("momentum", 40);
}

TEST_CASE("Generated mechanisms turned, mirrored and in other units have the same answers", "[soak]") {
    ask_of_first_seeds("transformed", 100);
}

TEST_CASE("Motions of generated mechanisms played backwards come back", "[soak]") {
    ask_of_first_seeds("reversed", 15);
}

TEST_CASE("Driven trees move as the product of their joints' motions in every method", "[soak]") {
    ask_of_first_seeds("driven", 15);
}

TEST_CASE("Every method converges to the motion of the reference", "[soak]") {
    ask_of_first_seeds("motions", 20);
}

TEST_CASE("Reactions and loads move every body as Newton and Euler say", "[soak]") {
    ask_of_first_seeds("reactions", 40);
}
