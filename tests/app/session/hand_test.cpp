#include "app/session/try/hand.hpp"

#include <catch2/catch.hpp>

#include "tests/app/session/catalogue_lessons.hpp"
#include "tests/support/random_mechanisms.hpp"

namespace jw::test {
namespace {

// Newton stops at 1e-13 in the scene's units; a factor of a thousand leaves room for the scaling of the rows
constexpr double kClosed = 1e-10;

double residual_of(const Step& step) { return rank_of(*step.system, step.state, step.t).residual; }

/// Steps whose `closed_step` differs from that of the step before.
std::vector<int> different_steps(const Story& story) {
    std::vector<int> steps;
    for (int k = 0; k < static_cast<int>(story.steps().size()); ++k) {
        if (steps.empty() || closed_step(story, k) != closed_step(story, steps.back())) {
            steps.push_back(k);
        }
    }
    return steps;
}

}  // namespace

TEST_CASE("a hand keeps what is assembled closed, at every step of every lesson", "[app][session]") {
    Random random(11);
    for (const auto& file : all_lesson_files()) {
        const Lesson lesson = without_motion(shipped(file));
        const Story story(lesson);
        const double reach = 0.2 * extent(lesson.mechanism);
        for (const int k : different_steps(story)) {
            Hand hand(story, k);
            const double before = residual_of(hand.step());
            for (int body = 0; body < static_cast<int>(lesson.mechanism.bodies.size()); ++body) {
                if (lesson.mechanism.bodies[static_cast<std::size_t>(body)].fixed) { continue; }
                const Vec3 target =
                    hand.step().state.r[static_cast<std::size_t>(body)] + random.vector(reach);
                const DragOutcome outcome = hand.pull(body, Vec3::Zero(), target);
                INFO(file << " step " << k << " body " << body);
                CHECK(std::isfinite(outcome.distance));
                CHECK(residual_of(hand.step()) < std::max(kClosed, 2.0 * before));
            }
        }
    }
}

TEST_CASE("free motions are followed on closed poses, and back to the start", "[app][session]") {
    for (const auto& file : all_lesson_files()) {
        const Lesson lesson = without_motion(shipped(file));
        const Story story(lesson);
        for (const int k : different_steps(story)) {
            Hand hand(story, k);
            const double before = residual_of(hand.step());
            const auto motions =
                static_cast<int>(rank_of(*hand.step().system, hand.step().state, 0.0).free_motions.size());
            const Step start = hand.step();
            for (int motion = 0; motion < motions; ++motion) {
                INFO(file << " step " << k << " motion " << motion);
                for (const double part : {1.0, 0.3, -0.6, -1.0}) {
                    REQUIRE(hand.follow(motion, part));
                    CHECK(residual_of(hand.step()) < std::max(kClosed, 2.0 * before));
                }
                if (hand.followed()->is_finite()) { CHECK(hand.followed()->states.size() > 1); }
                CHECK(hand.followed()->verdict != FreedomVerdict::cannot_tell);
                REQUIRE(hand.follow(motion, 0.0));
                CHECK(hand.step().state.r == start.state.r);
                CHECK(hand.step().state.p == start.state.p);
            }
            CHECK_FALSE(hand.follow(motions, 1.0));
        }
    }
}

TEST_CASE("what a hand has led to becomes the start, and the story closes from there", "[app][session]") {
    Session session(without_motion(lesson_named("loops/four-bar")));
    session.apply(GoTo{session.index_of_time(0.0)});
    int closed = 0;
    while (session.story().steps()[static_cast<std::size_t>(closed)].additions < 4 ||
           session.story().steps()[static_cast<std::size_t>(closed)].kind != Step::Kind::assembled) {
        ++closed;
    }
    session.apply(GoTo{closed});
    const Vec3 before = session.step().state.r[2];
    for (int k = 0; k < 10; ++k) { session.apply(Drag{2, Vec3::Zero(), before + Vec3(0.1, 0.0, -0.1)}); }
    CHECK(session.in_hand());
    const State led = session.step().state;
    CHECK((led.r[2] - before).norm() > 0.05);
    CHECK(session.apply(Release{}) == "The pose is the new start estimate.");
    CHECK_FALSE(session.in_hand());
    CHECK(session.lesson().mechanism.bodies[2].r == led.r[2]);
    // already closed: the pose stays what the hand left
    CHECK((session.step().state.r[2] - led.r[2]).norm() < 1e-12);
    session.apply(Undo{});
    CHECK(session.step().state.r[2] == before);
}

TEST_CASE("a driven mechanism is led along its motion and nowhere else", "[app][session]") {
    Session session(lesson_named("loops/four-bar"));
    session.apply(GoTo{session.index_of_time(0.5)});
    const int then = session.index_of_time(0.8);
    const Step& goal = session.story().steps()[static_cast<std::size_t>(then)];
    const Vec3 tip(0.4, 0.0, 0.0);
    const Vec3 target = goal.state.r[1] + rotation_matrix(goal.state.p[1]) * tip;
    const std::uint64_t times_told = session.told();
    session.apply(Drag{1, tip, target});
    CHECK_FALSE(session.in_hand());
    CHECK(session.index() == then);
    CHECK(session.told() == times_told);
}

}  // namespace jw::test
