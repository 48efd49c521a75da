#include <catch2/catch.hpp>

#include "tests/soak/runner.hpp"

using namespace jw;

TEST_CASE("Every property holds for the mechanisms of the first seeds", "[soak]") {
    for (const test::Property& property : test::properties()) {
        for (const std::uint64_t seed : {1U, 2U, 3U}) {
            test::Asked asked;
            asked.seed = seed;
            CAPTURE(property.says, seed);
            const test::Answer answer = test::ask(property, asked);
            INFO((answer.wrong ? answer.wrong->why + '\n' + answer.wrong->recipe : std::string()));
            CHECK(!answer.wrong);
            // where most mechanisms are not asked, nothing is said
            CHECK(answer.held > asked.count / 2);
        }
    }
}
