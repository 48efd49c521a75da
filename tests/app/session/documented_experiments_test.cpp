#include <catch2/catch.hpp>

#include "app/session/try/carry_out.hpp"
#include "app/session/try/possible_experiments.hpp"
#include "tests/app/session/catalogue_lessons.hpp"

namespace jw::test {
namespace {

struct Documented {
    std::string lesson;
    std::vector<std::string> experiments;
    int rows;
    int rank;
    int dof;
    double condition;  ///< as written, three digits; 0: not written
};

/// docs/experiments.md
const std::vector<Documented>& documented() {
    static const std::vector<Documented> all{
        {"parallel/which-two-of-three", {}, 12, 12, 0, 5.08},
        {"parallel/which-two-of-three", {"form sleeve all three"}, 14, 12, 0, 5.08},
        {"parallel/which-two-of-three", {"form sleeve pair"}, 12, 12, 0, 5.08},
        {"hard/the-wrong-two", {}, 30, 29, 1, 57.3},
        {"hard/the-wrong-two", {"form \"at 90\" rule"}, 30, 30, 0, 57.3},
        {"loops/four-bar", {"take out motor"}, 20, 17, 1, 0},
        {"loops/four-bar", {"take out motor", "take out D p1 x"}, 19, 17, 1, 0},
        {"loops/four-bar", {"take out motor", "take out D s x"}, 19, 16, 2, 0},
        {"loops/four-bar", {"take out motor", "take out D"}, 15, 15, 3, 0},
        {"loops/four-bar", {"take out D p1 x", "take out D p1 z", "take out D s y"}, 18, 18, 0, 0},
        {"loops/rssr", {}, 17, 17, 1, 0},
        {"hard/two-ways-on", {}, 21, 17, 1, 0},
        {"hard/two-ways-on", {"take out motor"}, 20, 16, 2, 0},
        {"hard/cannot-close", {"point D i 0.3 0 0.2"}, 20, 17, 1, 0},
    };
    return all;
}

void carry_out_all(Session& session, const std::vector<std::string>& experiments) {
    for (const std::string& text : experiments) {
        const ExperimentResult result = carry_out(session, text);
        INFO(text << ": " << result.said);
        REQUIRE(result.done);
    }
    session.apply(GoTo{session.story().last_assembled()});
}

}  // namespace

TEST_CASE("the experiments of the documentation do what it says", "[app][session]") {
    for (const Documented& one : documented()) {
        Session session(without_motion(lesson_named(one.lesson)));
        carry_out_all(session, one.experiments);
        const Effect effect = possible_experiments_of(session).present;
        INFO(one.lesson << (one.experiments.empty() ? "" : ": " + one.experiments.back()));
        CHECK(effect.rows == one.rows);
        CHECK(effect.rank == one.rank);
        CHECK(effect.dof == one.dof);
        if (one.condition > 0.0) { CHECK(effect.condition == Approx(one.condition).epsilon(1e-3)); }
    }
}

TEST_CASE("the free motions of the documentation are finite or not as it says", "[app][session]") {
    using enum FreedomVerdict;
    const auto motions_of = [](const std::string& lesson, const std::vector<std::string>& experiments) {
        Session session(without_motion(lesson_named(lesson)));
        carry_out_all(session, experiments);
        return possible_experiments_of(session).free_motions;
    };
    const auto verdicts = [&](const std::string& lesson) {
        std::vector<FreedomVerdict> list;
        for (const FreeMotionVerdict& v : motions_of(lesson, {})) { list.push_back(v.verdict); }
        return list;
    };
    CHECK(verdicts("loops/rssr") == std::vector{finite});
    CHECK(verdicts("hard/two-ways-on") == std::vector{first_order});
    CHECK(verdicts("hard/cosine-row") == std::vector{first_order, first_order, finite, finite});
    const std::vector<FreeMotionVerdict> two_ways = motions_of("hard/two-ways-on", {"take out motor"});
    REQUIRE(two_ways.size() == 2);
    for (const FreeMotionVerdict& v : two_ways) {
        CHECK(v.verdict == first_order);
        CHECK(v.has_motion_beside);
    }
}

TEST_CASE("beyond half a turn the cosine row turns the nut backwards", "[app][session]") {
    const auto turning = [](const std::string& row, const std::string& start) {
        Lesson lesson = lesson_named("joints/screw");
        lesson.motion->steps = 2;
        Session session(lesson);
        carry_out_all(session, {"screw thread " + row, "driver turn start " + start + " deg rate 90 deg/s"});
        session.apply(GoTo{session.index_of_time(0.0)});
        REQUIRE(session.step().kind == Step::Kind::motion);
        // advances all the same: 0.12 m a turn, a quarter of a turn a second
        CHECK(session.step().velocity.r_dot[1].z() == Approx(0.03));
        return session.step().velocity.omega_local[1].z();
    };
    const double quarter = 1.5707963267948966;
    CHECK(turning("cosine", "190") == Approx(-quarter));
    CHECK(turning("cosine", "170") == Approx(quarter));
    CHECK(turning("sine", "170") == Approx(-quarter));
    CHECK(turning("rotation", "190") == Approx(quarter));
}

}  // namespace jw::test
