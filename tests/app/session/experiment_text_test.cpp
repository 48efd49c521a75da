#include "app/session/try/experiment_text.hpp"

#include <catch2/catch.hpp>

#include <set>

#include "lessons/write/writer.hpp"
#include "tests/app/session/all_experiments.hpp"
#include "tests/app/session/catalogue_lessons.hpp"

namespace jw::test {
namespace {

/// Compares two experiments, every number bit by bit.
struct Same {
    bool operator()(const GoTo& a, const GoTo& b) const { return a.step == b.step; }
    bool operator()(const SetParallelForm& a, const SetParallelForm& b) const {
        return a.joint == b.joint && a.form == b.form;
    }
    bool operator()(const SetScrewAngleForm& a, const SetScrewAngleForm& b) const {
        return a.joint == b.joint && a.form == b.form;
    }
    bool operator()(const SetCoordinates& a, const SetCoordinates& b) const { return a.choice == b.choice; }
    bool operator()(const SetPresent& a, const SetPresent& b) const {
        return a.what == b.what && a.present == b.present;
    }
    bool operator()(const SetEquationPresent& a, const SetEquationPresent& b) const {
        return a.joint == b.joint && a.equation == b.equation && a.present == b.present;
    }
    bool operator()(const SetGeometry& a, const SetGeometry& b) const {
        return a.joint == b.joint && a.geometry == b.geometry;
    }
    bool operator()(const SetDriver& a, const SetDriver& b) const {
        return a.driver == b.driver && a.function == b.function;
    }
    bool operator()(const SetPose& a, const SetPose& b) const {
        return a.body == b.body && a.r == b.r && a.p == b.p;
    }
    bool operator()(const Drag& a, const Drag& b) const {
        return a.body == b.body && a.point_local == b.point_local && a.target == b.target;
    }
    bool operator()(const ShowFreedom& a, const ShowFreedom& b) const {
        return a.motion == b.motion && a.part == b.part;
    }
    template <class A, class B>
    bool operator()(const A& /*a*/, const B& /*b*/) const {
        return std::is_same_v<A, B>;
    }
};

void check_there_and_back(const Experiment& experiment, const Session& session) {
    const std::string text = text_of(experiment, session.lesson());
    std::string error;
    const std::optional<Experiment> read = read_experiment(text, session, error);
    INFO(text << ": " << error);
    REQUIRE(read.has_value());
    CHECK(std::visit(Same{}, experiment, *read));
}

Experiment read(const std::string& text, const Session& session) {
    std::string error;
    const std::optional<Experiment> experiment = read_experiment(text, session, error);
    INFO(text << ": " << error);
    REQUIRE(experiment.has_value());
    return *experiment;
}

std::string problem_of(const std::string& text, const Session& session) {
    std::string error;
    CHECK_FALSE(read_experiment(text, session, error).has_value());
    return error;
}

}  // namespace

TEST_CASE("Springs on the axis of a joint stay on it when it is given another", "[app][session]") {
    for (const char* name : {"dynamics/sled-and-spring", "dynamics/torsion-pendulum"}) {
        const Lesson lesson = lesson_named(name);
        JointGeometry geometry = with_axis(lesson.mechanism.joints[0].geometry, false, Vec3(0.6, 0.48, 0.64));
        geometry.P_i_local += Vec3(0.01, 0.02, 0.03);
        const Edit edit = edited(lesson, lesson, SetGeometry{0, geometry});
        CAPTURE(name, edit.what);
        REQUIRE(edit.lesson);
        const Joint& joint = edit.lesson->mechanism.joints[0];
        const Loads& loads = edit.lesson->dynamics->loads;
        for (const Spring& spring : loads.springs) { CHECK(acts_along(spring, joint)); }
        for (const RotationalSpring& spring : loads.rotational_springs) { CHECK(acts_about(spring, joint)); }
        CHECK(loads.springs.size() + loads.rotational_springs.size() == 1);
        CHECK(lesson_text(*edit.lesson).find("spring]]") != std::string::npos);
    }
}

TEST_CASE("every experiment is told in words that are read as the same experiment", "[app][session]") {
    Random random(7);
    std::set<std::size_t> kinds;
    for (const auto& file : all_lesson_files()) {
        const Session session(without_motion(shipped(file)));
        INFO(file);
        for (const Experiment& experiment : all_experiments(session.lesson(), random)) {
            check_there_and_back(experiment, session);
            kinds.insert(experiment.index());
        }
    }
    // a kind of experiment without an example would not be tested
    CHECK(kinds.size() == std::variant_size_v<Experiment>);
}

TEST_CASE("names with blanks, and names that begin others, are read as they are told", "[app][session]") {
    Lesson lesson = without_motion(lesson_named("loops/four-bar"));
    lesson.mechanism.joints[0].name = "D p1";
    lesson.mechanism.joints[1].name = "the long pin";
    lesson.mechanism.bodies[1].name = "crank by";
    const Session session(lesson);
    Random random(3);
    for (const Experiment& experiment : all_experiments(session.lesson(), random)) {
        check_there_and_back(experiment, session);
    }
    CHECK(std::get<SetParallelForm>(read("form the long pin drop z", session)).joint == 1);
    CHECK(std::get<SetParallelForm>(read("form \"the long pin\" rule", session)).joint == 1);
}

TEST_CASE(
    "a formula joint can be given another equation, which is told as it was written", "[app][session]") {
    const Session session(without_motion(lesson_named("loops/constant-velocity")));
    const std::string text =
        R"(geometry coupling formula "\mathbf{u}_i^T \tilde{\mathbf{s}}_j \mathbf{u}_j = 0")";
    const Experiment experiment = read(text, session);
    CHECK(std::get<SetGeometry>(experiment).geometry.formula.source.find("= 0") != std::string::npos);
    check_there_and_back(experiment, session);
    CHECK(problem_of("geometry kingpin formula \"d_x\"", session) == "a revolute joint has no formula");
    CHECK(problem_of("geometry coupling formula \"t\"", session).find("time") != std::string::npos);
}

TEST_CASE("sentences are read as a student means them", "[app][session]") {
    const Session session(without_motion(lesson_named("loops/four-bar")));
    const auto driver = [&](const std::string& text) {
        return std::get<SetDriver>(read("driver motor " + text, session)).function.polynomial;
    };
    const double quarter = 1.5707963267948966;
    CHECK(driver("start 90 deg rate 180 deg/s") == std::vector<double>{quarter, 2.0 * quarter});
    CHECK(driver("rate 180deg/s")[1] == 2.0 * quarter);
    CHECK(driver("start 90°")[0] == quarter);
    CHECK(driver("start 1.5 rad")[0] == 1.5);
    CHECK(driver("function polynomial 0 90 180 deg") == std::vector<double>{0.0, quarter, 2.0 * quarter});

    const auto taken = std::get<SetEquationPresent>(read("take out D p1 x", session));
    CHECK(taken.joint == 3);
    CHECK(taken.equation == EquationOut{Role::axes_parallel, 0});
    CHECK(std::get<SetPresent>(read("  take  out motor ", session)).what.kind == Addition::Kind::driver);
    CHECK(
        std::get<SetCoordinates>(read("coordinates rp-true", session)).choice ==
        CoordinateChoice::true_euler_parameters);

    // from its origin at the free bodies of the lesson, and from another point of it
    const Body& crank = session.lesson().mechanism.bodies[1];
    CHECK(std::get<Drag>(read("drag crank by 0 0 0.1", session)).target == crank.r + Vec3(0.0, 0.0, 0.1));
    const auto tip = std::get<Drag>(read("drag crank at 0.4 0 0 by 0 0 0.1 m", session));
    CHECK(tip.point_local == Vec3(0.4, 0.0, 0.0));
    const int closed = std::get<GoTo>(read("go to D", session)).step;
    const Step& step = session.story().steps()[static_cast<std::size_t>(closed)];
    CHECK(step.kind == Step::Kind::assembled);
    CHECK(step.additions == 4);
}

TEST_CASE("what cannot be read says what was expected and what may be meant", "[app][session]") {
    const Session session(without_motion(lesson_named("loops/four-bar")));
    struct Case {
        std::string text;
        std::string says;
    };
    const std::vector<Case> cases{
        {"", "nothing to try; expected one of form, screw,"},
        {"frm A rule", "no experiment 'frm'; expected one of form, screw,"},
        {"frm A rule", "hint: did you mean 'form'?"},
        {"take oot A", "hint: did you mean 'take out'?"},
        {"form E rule", "no joint 'E'; expected one of A, B, C, D"},
        {"form A", "the form is missing; expected one of rule, drop x, drop y, drop z, all three, pair"},
        {"form A drop w", "no form 'drop w'; expected one of rule,"},
        {"form A al three", "hint: did you mean 'all three'?"},
        {"take out moter",
         "no joint or driver 'moter'; expected one of A, B, C, D, motor\nhint: did you mean 'motor'?"},
        {"take out A p1 w", "no equation 'p1 w'; expected one of s x, s y, s z, p1 x, p1 y, p1 z"},
        {"take out motor p1 x", "'p1 x' is left over; nothing more was expected"},
        {"coordinates polar",
         "no choice 'polar'; expected one of rp, rp-modified, omega-local, omega-global"},
        {"axis A i 0 0 0", "the axis has length 0; expected a direction"},
        {"axis A k 0 0 1", "no side 'k'; expected one of i, j"},
        {"axis A i 0 0", "the end where a direction should be; expected a number"},
        {"axis A i 0 0 nan", "expected at most 1e9 in magnitude"},
        {"point A i 0 0 1e12", "expected at most 1e9 in magnitude"},
        {"length A 1", "a revolute joint has no length"},
        {"driver motor start 30", "the unit is missing; expected deg or rad"},
        {"driver motor start 30 deg rate 3 deg", "the unit is missing; expected deg/s or rad/s"},
        {"driver motor", "the part of a driver's function is missing; expected one of start, rate,"},
        {"driver motor step from 0 deg to 1 deg between 2 1 s", "the step ends before it begins"},
        {"drag crank 0 0 1", "expected 'by' or 'to' and three numbers [m], for example: by 0 0 0.1"},
        {"drag cronk by 0 0 1",
         "no body 'cronk'; expected one of ground, crank, coupler, rocker\nhint: did you mean 'crank'?"},
        {"place crank", "expected 'at' and three numbers [m] or 'turned' and four Euler parameters"},
        {"place crank at 0 0", "the end where a coordinate [m] should be; expected a number"},
        {"place crank turned 1 0 0", "the end where one of four Euler parameters should be"},
        {"place crank turned 1 0 0 0 0", "'0' is left over"},
        {"go to step 999", "no step 999; the lesson has steps 0 to "},
        {"go to step 1.5", "'1.5' is not a whole number"},
        {"follow one", "'one' where the number of a free motion, counted from 1 should be"},
        {"undo twice", "'twice' is left over"},
        {"form \"A rule", "a quote \" is not closed"},
    };
    for (const Case& c : cases) {
        INFO(c.text << " -> " << problem_of(c.text, session));
        CHECK(problem_of(c.text, session).find(c.says) != std::string::npos);
    }
}

}  // namespace jw::test
