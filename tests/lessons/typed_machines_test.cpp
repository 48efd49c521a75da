#include <cmath>
#include <string>
#include <vector>

#include "core/poses/position.hpp"
#include "tests/lessons/support.hpp"
#include "tests/lessons/typed_lesson.hpp"

/// Overconstrained loops, typed with a few digits, as parts of larger machines.
namespace jw {

using test::HingeLoop;
using test::lesson_of;
using test::Random;
using test::Style;

namespace {

constexpr int kBodies = 22;  // beside those of the loop

/// Placement of a loop in its machine.
enum class In { chain, larger_loop };

Mechanism machine(const HingeLoop& loop, In in, unsigned seed, Style style) {
    Random random(seed);
    if (in == In::larger_loop) {
        return lesson_of(
                   test::lesson_text(loop, style) + test::chain_text("b1", "b2", kBodies, random, style))
            .mechanism;
    }
    style.head += test::chain_text("ground", "", kBodies, random, style);
    style.base = "c" + std::to_string(kBodies);
    return lesson_of(test::lesson_text(loop, style)).mechanism;
}

int rank_at_start(const Mechanism& mechanism) {
    State state = start_state(mechanism);
    REQUIRE(solve_position<OmegaLocal>(System(mechanism, joints_of(mechanism)), state, 0.0).ok());
    const RankReport report = test::rank_of_joints(mechanism, state);
    CHECK(report.decided);
    return report.rank;
}

}  // namespace

TEST_CASE("A loop that is typed in a large machine has the rank of the exact one", "[lessons][typed]") {
    const In in = GENERATE(In::chain, In::larger_loop);
    int found = 0;
    constexpr unsigned seed = 1;
    for (const test::MakeLoop make : test::kHingeLoops) {
        Random random(seed);
        const HingeLoop loop = make(random);
        CAPTURE(loop.name, static_cast<int>(in));
        // the reader takes all numbers as they are typed
        const std::string exact = "[precision]\nexact = true\n";
        const int expected = rank_at_start(machine(loop, in, seed, {.digits = 16, .head = exact}));
        for (const int digits : {6, 8}) {
            CAPTURE(digits);
            const Mechanism typed = machine(loop, in, seed, {.digits = digits});
            // some loops fit to rounding as they are typed
            const auto lone = lesson_of(test::lesson_text(loop, {.digits = digits})).mechanism.typed;
            REQUIRE(typed.typed.has_value() == lone.has_value());
            if (lone) {
                CHECK(typed.typed->is_told);
                CHECK(typed.typed->rank == expected);
                CHECK(typed.typed->rank_as_typed - expected == lone->rank_as_typed - lone->rank);
                found += typed.typed->rank_as_typed - expected;
            }
            CHECK(rank_at_start(typed) == expected);
        }
    }
    CHECK(found > 3);
}

TEST_CASE("What is found about a loop is the same alone and in a large machine", "[lessons][typed]") {
    for (unsigned seed = 1; seed <= 4; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const HingeLoop loop = test::bennett_loop(test::random_bennett(random), random);
        const Mechanism lone = lesson_of(test::lesson_text(loop, {})).mechanism;
        REQUIRE(lone.typed);
        for (const In in : {In::chain, In::larger_loop}) {
            const Mechanism whole = machine(loop, in, seed, {});
            REQUIRE(whole.typed);
            CHECK(whole.typed->is_told == lone.typed->is_told);
            CHECK(
                whole.typed->rank_as_typed - whole.typed->rank ==
                lone.typed->rank_as_typed - lone.typed->rank);
            // fitted at other poses of the same motion
            CHECK(whole.typed->share == Approx(lone.typed->share).epsilon(1e-3));
        }
    }
}

TEST_CASE("A loop that is locked by a rod stays locked, whatever its digits", "[lessons][typed]") {
    const int digits = GENERATE(5, 6, 9);
    for (unsigned seed = 1; seed <= 2; ++seed) {
        for (const test::MakeLoop make : test::kHingeLoops) {
            Random random(seed);
            const HingeLoop loop = make(random);
            CAPTURE(digits, seed, loop.name);
            const Style style{.digits = digits};
            const std::string rod =
                "[[joint]]\nname = \"rod\"\ntype = \"distance\"\nbodies = [\"ground\", \"b2\"]\n";
            const Mechanism locked =
                lesson_of(
                    test::lesson_text(loop, style) + rod + "at = " + style.vector(random.vector()) +
                    "\nto = " + style.vector(random.vector()) + '\n')
                    .mechanism;
            const int freedoms = 6 * locked.moving_bodies_count() - rank_at_start(locked);
            CHECK(freedoms == 0);
        }
    }
}

TEST_CASE("A loop of a large machine that no rounding explains keeps its rank", "[lessons][typed]") {
    const In in = GENERATE(In::chain, In::larger_loop);
    for (unsigned seed = 1; seed <= 4; ++seed) {
        CAPTURE(seed, static_cast<int>(in));
        Random random(seed);
        const HingeLoop loop = test::bennett_loop(test::random_bennett(random), random);
        CHECK_FALSE(machine(loop, in, seed, {.digits = 6, .off = 500e-6}).typed);
    }
}

TEST_CASE(
    "If the rank of one of two loops is not known, neither is that of the machine", "[lessons][typed]") {
    // a second loop whose numbers fit, and one that misses by some half units more than its digits allow
    const bool is_tied = GENERATE(false, true);
    int untold = 0;
    for (unsigned seed = 1; seed <= 6; ++seed) {
        CAPTURE(seed, is_tied);
        Random random(seed);
        const HingeLoop good = test::bennett_loop(test::random_bennett(random), random);
        const HingeLoop other = test::bennett_loop(test::random_bennett(random), random);
        const auto of = [](const std::string& text) { return lesson_of(text).mechanism; };
        const std::string odd = test::lesson_text(other, {.off = 3e-5});
        const auto alone = of(odd).typed;
        std::string both = test::lesson_text(good, {});
        std::string second = odd.substr(odd.find("[[body]]"), odd.find("[[driver]]") - odd.find("[[body]]"));
        for (const char* name : {"\"b", "\"h"}) {
            for (std::size_t k = 0; (k = second.find(name, k)) != std::string::npos; k += 3) {
                second.insert(k + 1, "o");
            }
        }
        // one closed part, and still two loops
        if (is_tied) { second += test::chain_text("b1", "ob1", 8, random, {}); }
        const auto verdict = of(both.substr(0, both.find("[[driver]]")) + second).typed;
        REQUIRE(verdict);
        untold += alone && !alone->is_told ? 1 : 0;
        CHECK(verdict->is_told == (!alone || alone->is_told));
        CHECK(verdict->rank == verdict->rank_as_typed - (alone ? 2 : 1));
        // share of the numbers of the good loop, which are used
        CHECK(verdict->share > 0.0);
    }
    CHECK(untold > 0);
}

}  // namespace jw
