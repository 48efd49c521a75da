#include "app/session/try/session.hpp"

#include <catch2/catch.hpp>

#include "app/session/output/describe.hpp"
#include "lessons/lesson/things.hpp"
#include "lessons/write/writer.hpp"
#include "tests/app/session/catalogue_lessons.hpp"

namespace jw::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Edits that every lesson allows, and those for what only some lessons have.
std::vector<Experiment> edits_of(const Lesson& lesson) {
    std::vector<Experiment> all{SetCoordinates{CoordinateChoice::omega_global}};
    const Mechanism& m = lesson.mechanism;
    for (int j = 0; j < static_cast<int>(m.joints.size()); ++j) {
        const Joint& joint = m.joints[static_cast<std::size_t>(j)];
        if (std::ranges::any_of(joint.type->roles, is_parallel)) {
            all.push_back(SetParallelForm{j, ParallelForm::all_three});
        }
        if (joint.type->uses(Role::screw_angle)) {
            all.push_back(SetScrewAngleForm{j, ScrewAngleForm::sine});
        }
        all.push_back(SetEquationPresent{j, {joint.type->roles.front(), 0}, false});
        JointGeometry moved = joint.geometry;
        moved.P_i_local.x() += 1e-3;
        all.push_back(SetGeometry{j, moved});
    }
    for (int d = 0; d < static_cast<int>(m.drivers.size()); ++d) {
        TimeFunction function = m.drivers[static_cast<std::size_t>(d)].function;
        function.polynomial.resize(2);
        function.polynomial[1] += 0.01;
        all.push_back(SetDriver{d, function});
        all.push_back(SetPresent{{Addition::Kind::driver, d}, false});
    }
    if (!m.joints.empty()) {
        all.push_back(SetPresent{{Addition::Kind::joint, static_cast<int>(m.joints.size()) - 1}, false});
    }
    return all;
}

/// Values of a session that a person would notice.
struct Seen {
    explicit Seen(const Session& session)
        : lesson(lesson_text(session.lesson())),
          view(shown(session)),
          undo(session.undo_text()),
          redo(session.redo_text()),
          index(session.index()) {}
    bool operator==(const Seen&) const = default;

    std::string lesson;
    std::string view;
    std::string undo;
    std::string redo;
    int index;
};

}  // namespace

TEST_CASE("every edit of every lesson is undone and done again exactly", "[app][session]") {
    for (const auto& file : all_lesson_files()) {
        Session session(without_motion(shipped(file)));
        session.apply(GoTo{session.story().last_assembled()});
        const std::string written = lesson_text(session.lesson());
        for (const Experiment& experiment : edits_of(session.as_written())) {
            const Seen before(session);
            const std::string said = session.apply(experiment);
            INFO(file << ": " << said);
            const Seen after(session);
            CHECK(after.undo == said);
            session.apply(Undo{});
            CHECK(session.redo_text() == said);
            CHECK(Seen(session).lesson == before.lesson);
            CHECK(Seen(session).view == before.view);
            CHECK(session.index() == before.index);
            session.apply(Redo{});
            CHECK(Seen(session) == after);
            session.apply(Undo{});
        }
        CHECK_FALSE(session.is_changed());
        CHECK(lesson_text(session.lesson()) == written);
    }
}

TEST_CASE("a history of many edits leads back through every lesson it went through", "[app][session]") {
    for (const std::string& name : few_lessons()) {
        Session session(without_motion(lesson_named(name)));
        std::vector<std::string> stories{told(session.story())};
        std::vector<std::string> lessons{lesson_text(session.lesson())};
        for (const Experiment& experiment : edits_of(session.as_written())) {
            const std::uint64_t before = session.told();
            session.apply(experiment);
            if (session.told() == before) { continue; }  // its object has been taken out before
            stories.push_back(told(session.story()));
            lessons.push_back(lesson_text(session.lesson()));
        }
        INFO(name);
        REQUIRE(lessons.size() > 2);
        for (std::size_t k = lessons.size() - 1; k > 0; --k) {
            session.apply(Undo{});
            CHECK(lesson_text(session.lesson()) == lessons[k - 1]);
            CHECK(told(session.story()) == stories[k - 1]);
        }
        CHECK(session.apply(Undo{}) == "There is nothing to undo.");
        for (std::size_t k = 1; k < lessons.size(); ++k) {
            session.apply(Redo{});
            CHECK(lesson_text(session.lesson()) == lessons[k]);
        }
        CHECK(session.apply(Redo{}) == "There is nothing to redo.");
        CHECK(session.apply(StartOver{}) == "All changes are undone.");
        CHECK(lesson_text(session.lesson()) == lessons[0]);
        session.apply(Undo{});
        CHECK(lesson_text(session.lesson()) == lessons.back());
    }
}

TEST_CASE("another telling is looked at in the same place", "[app][session]") {
    for (const auto& file : all_lesson_files()) {
        Session session(without_motion(shipped(file)));
        for (int k = 0; k <= session.story().last_assembled(); ++k) {
            session.apply(GoTo{k});
            const Step::Kind kind = session.step().kind;
            const int additions = session.step().additions;
            session.apply(SetCoordinates{CoordinateChoice::omega_global});
            INFO(file << " step " << k);
            // other coordinates may need fewer iterations: then the step where the joint is closed is shown
            CHECK((session.step().kind == kind || kind == Step::Kind::iteration));
            CHECK(session.step().additions == additions);
            session.apply(Undo{});
            CHECK(session.index() == k);
        }
    }
}

TEST_CASE("a moment of the motion is found again in another telling", "[app][session]") {
    Session session(lesson_named("loops/four-bar"));
    session.apply(GoTo{session.index_of_time(1.5)});
    const double t = session.step().t;
    session.apply(SetParallelForm{0, ParallelForm::all_three});
    CHECK(session.step().kind == Step::Kind::motion);
    CHECK(session.step().t == t);
    // if nothing can move any more, an earlier step is shown
    session.apply(SetPresent{{Addition::Kind::joint, 3}, false});
    CHECK(session.index() < static_cast<int>(session.story().steps().size()));
}

TEST_CASE("a joint that is taken out leaves the place at a step that exists", "[app][session]") {
    for (const auto& file : all_lesson_files()) {
        Session session(without_motion(shipped(file)));
        const auto joints = static_cast<int>(session.lesson().mechanism.joints.size());
        for (int j = 0; j < joints; ++j) {
            for (int k = 0; k < static_cast<int>(session.story().steps().size()); k += 3) {
                session.apply(GoTo{k});
                session.apply(SetPresent{{Addition::Kind::joint, j}, false});
                INFO(file << " joint " << j << " step " << k);
                CHECK(session.index() < static_cast<int>(session.story().steps().size()));
                CHECK(session.view().step == session.index());
                session.apply(Undo{});
                CHECK(session.index() == k);
            }
        }
    }
}

TEST_CASE("a joint that has lost all its equations is told of and holds nothing", "[app][session]") {
    for (const auto& file : all_lesson_files()) {
        const Lesson written = without_motion(shipped(file));
        for (int j = 0; j < static_cast<int>(written.mechanism.joints.size()); ++j) {
            Session session(written);
            session.apply(SetCoordinates{CoordinateChoice::omega_local});
            const Joint& joint = written.mechanism.joints[static_cast<std::size_t>(j)];
            for (const LabelledEquation& one : equations_of(*joint.type, joint.parallel_form)) {
                session.apply(SetEquationPresent{j, one.equation, false});
            }
            for (int k = 0; k < static_cast<int>(session.story().steps().size()); ++k) {
                session.apply(GoTo{k});
                INFO(file << " joint " << joint.name << " step " << k);
                CHECK_FALSE(session.view().sentence.empty());
                CHECK_FALSE(session.picture().scene.shapes.empty());
                CHECK(describe(session.view()).find("nan") == std::string::npos);
                CHECK(session.rank().rows == session.step().system->rows());
            }
        }
    }
}

TEST_CASE("a slider that is dragged is one change, another slider another", "[app][session]") {
    Session session(without_motion(lesson_named("loops/four-bar")));
    const auto slide = [&](int joint, double x) {
        JointGeometry g = session.lesson().mechanism.joints[static_cast<std::size_t>(joint)].geometry;
        g.P_i_local.x() = x;
        session.apply(SetGeometry{joint, g});
    };
    const std::string written = lesson_text(session.lesson());
    for (const double x : {-0.5, -0.49, -0.48, -0.47}) { slide(0, x); }
    const std::string first = lesson_text(session.lesson());
    for (const double x : {0.41, 0.42, 0.43}) { slide(1, x); }
    session.apply(Undo{});
    CHECK(lesson_text(session.lesson()) == first);
    session.apply(Undo{});
    CHECK(lesson_text(session.lesson()) == written);
    CHECK(session.undo_text().empty());

    // going to another step ends a gesture
    slide(0, -0.45);
    session.apply(GoTo{3});
    slide(0, -0.44);
    session.apply(Undo{});
    session.apply(Undo{});
    CHECK(lesson_text(session.lesson()) == written);
}

TEST_CASE("what is refused changes nothing and says why", "[app][session]") {
    for (const std::string& name : few_lessons()) {
        Session session(without_motion(lesson_named(name)));
        session.apply(SetCoordinates{CoordinateChoice::omega_local});
        session.apply(GoTo{session.story().last_assembled()});
        const Lesson& lesson = session.lesson();
        const auto joints = static_cast<int>(lesson.mechanism.joints.size());
        const auto drivers = static_cast<int>(lesson.mechanism.drivers.size());
        const Joint& joint = lesson.mechanism.joints[0];
        JointGeometry no_axis = joint.geometry;
        no_axis.s_i_local.setZero();
        JointGeometry no_number = joint.geometry;
        no_number.P_j_local.y() = kNan;
        std::vector<Experiment> refused{
            SetParallelForm{-1, ParallelForm::rule},
            SetParallelForm{joints, ParallelForm::rule},
            SetScrewAngleForm{joints, ScrewAngleForm::sine},
            SetPresent{{Addition::Kind::joint, joints}, false},
            SetPresent{{Addition::Kind::joint, -1}, true},
            SetPresent{{Addition::Kind::driver, drivers}, false},
            SetPresent{{Addition::Kind::joint, 0}, true},
            SetEquationPresent{0, {joint.type->roles.front(), 0}, true},
            SetEquationPresent{joints, {Role::same_point, 0}, false},
            SetGeometry{0, no_axis},
            SetGeometry{0, no_number},
            SetGeometry{joints, joint.geometry},
            SetDriver{drivers, {}},
            SetDriver{-1, {}},
            Drag{-1, Vec3::Zero(), Vec3::Zero()},
            Drag{99, Vec3::Zero(), Vec3::Zero()},
            Drag{0, Vec3::Zero(), Vec3::Ones()},
            ShowFreedom{99, 0.5},
            ShowFreedom{-1, 0.5}};
        if (!joint.type->uses(Role::screw_angle)) {
            refused.push_back(SetScrewAngleForm{0, ScrewAngleForm::cosine});
            refused.push_back(SetEquationPresent{0, {Role::screw_angle, 0}, false});
        }
        if (drivers > 0) {
            refused.push_back(SetDriver{0, TimeFunction{.polynomial = {0.0, kNan}}});
            refused.push_back(SetDriver{0, TimeFunction{{}, {{1.0, kNan, 0.0}}, {}}});
        }
        const Seen before(session);
        const std::uint64_t times_told = session.told();
        for (const Experiment& experiment : refused) {
            const std::string said = session.apply(experiment);
            INFO(name << " experiment " << experiment.index() << ": " << said);
            CHECK_FALSE(said.empty());
            CHECK(Seen(session) == before);
            CHECK(session.told() == times_told);
            CHECK_FALSE(session.in_hand());
        }
    }
}

TEST_CASE("while nothing changes no numbers are computed", "[app][session]") {
    Session session(lesson_named("loops/four-bar"));
    session.apply(GoTo{session.story().last_assembled()});
    session.view();
    session.picture();
    const std::uint64_t computed = session.views_computed();
    const std::uint64_t version = session.version();
    for (int k = 0; k < 100; ++k) {
        session.view();
        session.picture();
        session.rank();
        session.apply(GoTo{session.index()});
        session.apply(LetGo{});
    }
    CHECK(session.views_computed() == computed);
    CHECK(session.version() == version);
}

TEST_CASE("a file saved anew is one more change that can be undone", "[app][session]") {
    Session session(without_motion(lesson_named("loops/four-bar")));
    session.apply(SetParallelForm{0, ParallelForm::all_three});
    const std::string tried = lesson_text(session.lesson());
    Lesson saved = without_motion(lesson_named("loops/four-bar"));
    saved.title = "Another title";
    session.replace(saved);
    CHECK(session.lesson().title == "Another title");
    CHECK_FALSE(session.is_changed());
    session.apply(Undo{});
    CHECK(lesson_text(session.lesson()) == tried);
}

}  // namespace jw::test
