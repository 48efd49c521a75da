#include <catch2/catch.hpp>

#include "app/session/try/carry_out.hpp"
#include "lessons/write/writer.hpp"
#include "tests/app/session/catalogue_lessons.hpp"

namespace jw::test {
namespace {

/// Lesson as the program saves and reads it, without the claims, which were made about the lesson as written.
Lesson saved_and_read(Lesson lesson) {
    lesson.claims.clear();
    const ReadResult read = read_lesson(lesson_text(lesson), lesson.file_name);
    INFO(read.report());
    REQUIRE(read.lesson.has_value());
    return *read.lesson;
}

bool same(const Vec3& a, const Vec3& b) { return a == b; }

}  // namespace

TEST_CASE("a driver measures along the joint as it has been moved", "[app][session]") {
    int drivers = 0;
    for (const auto& file : all_lesson_files()) {
        Session session(without_motion(shipped(file)));
        for (std::size_t d = 0; d < session.lesson().mechanism.drivers.size(); ++d) {
            const int index = session.lesson().mechanism.drivers[d].joint;
            if (index < 0) { continue; }
            ++drivers;
            const auto j = static_cast<std::size_t>(index);
            const JointGeometry& before = session.lesson().mechanism.joints[j].geometry;
            JointGeometry moved = with_axis(before, false, before.s_i_local + Vec3(0.02, -0.03, 0.05));
            moved.P_j_local += Vec3(0.001, 0.002, -0.001);
            session.apply(SetGeometry{index, moved});
            const Joint& joint = session.lesson().mechanism.joints[j];
            const Measure& measure = session.lesson().mechanism.drivers[d].measure;
            INFO(file << " joint " << joint.name);
            if (const auto* angle = std::get_if<AngleMeasure>(&measure)) {
                CHECK(same(angle->s_i_local, angle_of(joint).s_i_local));
                CHECK(same(angle->u_i_local, angle_of(joint).u_i_local));
                CHECK(std::abs(angle->u_i_local.dot(angle->s_i_local)) < 1e-12);
            }
            if (const auto* way = std::get_if<DisplacementMeasure>(&measure)) {
                CHECK(same(way->s_i_local, moved.s_i_local.normalized()));
                CHECK(same(way->B_j_local, moved.P_j_local));
            }
            session.apply(Undo{});
        }
    }
    CHECK(drivers > 10);
}

TEST_CASE("an axis is turned with all that is perpendicular to it", "[app][session]") {
    for (const auto& file : all_lesson_files()) {
        for (const Joint& joint : shipped(file).mechanism.joints) {
            for (const Vec3& direction : {Vec3(0.3, -0.5, 2.0), Vec3(-joint.geometry.s_i_local)}) {
                const JointGeometry g = with_axis(joint.geometry, false, direction);
                INFO(file << " " << joint.name);
                CHECK(g.s_i_local.normalized().dot(direction.normalized()) == Approx(1.0));
                CHECK(g.s_i_local.norm() == Approx(joint.geometry.s_i_local.norm()));
                // rounding of a rotation
                CHECK(
                    std::abs(
                        g.s_i_local.dot(g.u_i_local) -
                        joint.geometry.s_i_local.dot(joint.geometry.u_i_local)) < 1e-12 * g.s_i_local.norm());
                CHECK(same(g.s_j_local, joint.geometry.s_j_local));
            }
        }
    }
}

TEST_CASE("a changed lesson that is saved and read tells the same story", "[app][session]") {
    struct Change {
        std::string lesson;
        std::vector<std::string> experiments;
    };
    const std::vector<Change> changes{
        {"loops/four-bar",
         {"form D all three", "take out B s y", "coordinates omega-local", "driver motor rate 30 deg/s"}},
        {"loops/four-bar", {"form A pair", "take out A n1 pair a", "drag crank by 0.02 0 0.05"}},
        {"loops/four-bar",
         {"take out C", "axis D i 0.1 -1 0", "go to D", "drag rocker at 0.8 0 0 by 0.1 0 0.2"}},
        {"loops/rssr", {"take out motor", "follow 1 0.5"}},
        {"joints/screw", {"screw thread cosine"}},
        {"joints/prismatic", {"take out p1", "undo"}},
    };
    for (const Change& change : changes) {
        Session session(without_motion(lesson_named(change.lesson)));
        for (const std::string& text : change.experiments) {
            const ExperimentResult result = carry_out(session, text);
            INFO(change.lesson << ": " << text << ": " << result.said);
            CHECK((result.done || text == "take out p1" || text == "undo" || text.starts_with("screw")));
        }
        const Lesson again = saved_and_read(session.lesson());
        INFO(change.lesson);
        CHECK(told(Story(again)) == told(session.story()));
    }
}

TEST_CASE("every lesson with anything taken out can be saved and read", "[app][session]") {
    for (const auto& file : all_lesson_files()) {
        Session session(without_motion(shipped(file)));
        for (const Addition& part : session.as_written().order) {
            session.apply(SetPresent{part, false});
            const Lesson again = saved_and_read(session.lesson());
            INFO(file);
            CHECK(told(Story(again)) == told(session.story()));
            session.apply(Undo{});
        }
    }
}

}  // namespace jw::test
