#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

#include "app/session/picture/picture_parts.hpp"
#include "app/session/story/timeline.hpp"
#include "tests/app/host/checks.hpp"
#include "tests/app/host/reach.hpp"

namespace jw::test {
namespace {

using host::Command;
using host::Key;

constexpr const char* kFourBar = "loops/four-bar.toml";
constexpr const char* kTry = "try";

int joint_of(const Person& person, const std::string& name) {
    const auto& joints = person.session().lesson().mechanism.joints;
    for (std::size_t k = 0; k < joints.size(); ++k) {
        if (joints[k].name == name) { return static_cast<int>(k); }
    }
    return -1;
}

/// Goes to the step at which a joint or driver is assembled.
void go_to_closed(Person& person, const std::string& name) {
    const auto step = step_at(person.session().story(), name);
    REQUIRE(step);
    person.go_to(*step);
    while (person.session().step().kind != Step::Kind::assembled) { person.press(Key::right); }
}

/// Clicks a widget of "Try it".
void use(Person& person, std::initializer_list<std::variant<std::string, int>> path) {
    if (person.host().state().tab != host::Tab::experiments) { person.ask(Command::tab_experiments); }
    const Widget widget = find(person, kTry, path);
    person.click(widget.x, widget.y);
}

void choose_form(Person& person, int joint, const char* form) {
    use(person, {"joint of try it", joint, form});
}

double residual(const Session& session) { return session.view().rank.residual; }

/// Place of a point of a body on the screen.
render::Projected on_screen(Person& person, const Vec3& point) {
    return render::project(person.host().camera(), person.host().layout().scene, point);
}

}  // namespace

TEST_CASE("All three equations of p1 add one row, and that one is redundant") {
    Person person(kFourBar);
    go_to_closed(person, "A");
    const RankView before = person.view().rank;
    REQUIRE(before.rows == before.rank);
    choose_form(person, 0, "all three");
    const RankView& now = person.view().rank;
    CHECK(person.session().lesson().mechanism.joints[0].parallel_form == ParallelForm::all_three);
    CHECK(now.rows == before.rows + 1);
    CHECK(now.rank == before.rank);
    CHECK(now.redundant_rows.size() == 1);
    CHECK(now.dof == before.dof);
}

TEST_CASE("A pair forced where the axis has no component loses rank, the rule's own pair does not") {
    Person person(kFourBar);
    go_to_closed(person, "A");
    const RankView before = person.view().rank;
    // the axis is y: without x or z at most one equation of the pair is independent
    choose_form(person, 0, "without x");
    const bool lost = !person.view().failure.empty() || person.view().rank.rank < before.rank;
    CHECK(lost);
    CHECK(fault_of(person.host()) == "");
    choose_form(person, 0, "without y");
    CHECK(person.view().failure.empty());
    CHECK(person.view().rank.rank == before.rank);
}

TEST_CASE("Undo and redo bring back exactly what was there") {
    Person person(kFourBar);
    go_to_closed(person, "D");
    const std::string written = text_of(person.view());
    choose_form(person, joint_of(person, "D"), "all three");
    const std::string tried = text_of(person.view());
    REQUIRE(tried != written);
    person.ask(Command::undo);
    CHECK(text_of(person.view()) == written);
    CHECK_FALSE(person.session().is_changed());
    person.ask(Command::redo);
    CHECK(text_of(person.view()) == tried);
    person.ask(Command::start_over);
    CHECK(text_of(person.view()) == written);
    person.ask(Command::undo);
    CHECK(text_of(person.view()) == tried);
}

TEST_CASE("A joint that is taken out and put back leaves the story as it was") {
    Person person(kFourBar);
    const auto all = [&] {
        std::string text;
        const Story& story = person.session().story();
        for (int k = 0; k <= story.last_assembled(); ++k) { text += text_of(view_of(story, k)); }
        return text;
    };
    go_to_closed(person, "D");
    const std::string before = all();
    const int joint = joint_of(person, "C");
    use(person, {"joint", joint, "##present"});
    CHECK(person.session().lesson().order.size() == 4);
    CHECK(fault_of(person.host()) == "");
    use(person, {"joint", joint, "##present"});
    CHECK(person.session().lesson().order == person.session().as_written().order);
    CHECK(all() == before);
}

TEST_CASE("A motor goes with its joint, and is refused before it") {
    Person person(kFourBar);
    go_to_closed(person, "D");
    use(person, {"joint", 0, "##present"});
    CHECK(person.session().lesson().order.size() == 3);
    use(person, {"driver", 0, "##present"});
    CHECK(person.session().lesson().order.size() == 3);
    CHECK(person.host().notice().text().find("put A back first") != std::string::npos);
}

TEST_CASE(
    "Without one repeated equation after the other the four-bar has full row rank, a needed one frees it") {
    Person person(kFourBar);
    go_to_closed(person, "D");
    person.ask(Command::tab_experiments);
    REQUIRE(person.session().rank().redundant() == 3);
    for (int left = 3; left > 0; --left) {
        const std::vector<int> rows = removable_rows(person.session().rank());
        REQUIRE_FALSE(rows.empty());
        const int dof = person.view().rank.dof;
        use(person, {rows.front(), "take out"});
        CHECK(person.session().rank().redundant() == left - 1);
        CHECK(person.view().rank.dof == dof);
    }
    CHECK(person.view().rank.rank == person.view().rank.rows);
    CHECK(removable_rows(person.session().rank()).empty());
    const int dof = person.view().rank.dof;
    const int joint = joint_of(person, "B");
    // x of the spherical part of B: without it the links come apart in the plane
    use(person, {"joint", joint, "B   revolute"});
    use(person, {"joint of try it", joint, static_cast<int>(Role::same_point), "x"});
    CHECK(person.view().rank.dof == dof + 1);
}

TEST_CASE("A body pulled after assembly keeps all equations and goes towards the pointer") {
    Person person(kFourBar);
    go_to_closed(person, "D");
    person.host().set_picker([](float, float) { return picture_id(Pointable::body(1)); });
    const Vec3 tip_local(0.4, 0.0, 0.0);
    const auto tip = [&] { return picture::frame_of(person.session().step().state, 1).point(tip_local); };
    const render::Projected from = on_screen(person, tip());
    const auto x = static_cast<float>(from.x);
    const auto y = static_cast<float>(from.y);
    const Vec3 before = tip();
    person.point(x, y);
    person.host().push(host::InputEvent::button(0, true));
    person.settle();
    for (int k = 1; k <= 20; ++k) {
        person.point(x + 3.0F * static_cast<float>(k), y);
        REQUIRE(person.session().in_hand());
        REQUIRE(residual(person.session()) < 1e-10);
    }
    CHECK((tip() - before).norm() > 0.02);
    CHECK(on_screen(person, tip()).x > from.x + 5.0);
    person.host().push(host::InputEvent::button(0, false));
    person.settle();
    CHECK_FALSE(person.session().in_hand());
    CHECK(person.session().is_changed());
}

TEST_CASE("A free body pulled before assembly changes the start estimate, and the joints close from there") {
    Person person(kFourBar);
    person.host().set_picker([](float, float) { return picture_id(Pointable::body(2)); });
    const Vec3 before = person.session().lesson().mechanism.bodies[2].r;
    person.drag(300.0F, 300.0F, 330.0F, 280.0F);
    CHECK((person.session().lesson().mechanism.bodies[2].r - before).norm() > 0.005);
    CHECK(
        person.session().lesson().mechanism.bodies[1].r ==
        person.session().as_written().mechanism.bodies[1].r);
    go_to_closed(person, "D");
    CHECK(residual(person.session()) < 1e-10);
}

TEST_CASE("A driven mechanism that is pulled goes through time") {
    Person person(kFourBar);
    person.host().set_picker([](float, float) { return picture_id(Pointable::body(1)); });
    person.press(Key::end);
    for (int k = 0; k < 100; ++k) { person.press(Key::left); }
    const double t = person.view().t;
    const Vec3 tip = picture::frame_of(person.session().step().state, 1).point({0.4, 0.0, 0.0});
    const Vec3 ahead =
        picture::frame_of(
            person.session().story().steps()[static_cast<std::size_t>(person.session().index()) + 12].state,
            1)
            .point({0.4, 0.0, 0.0});
    const auto from = on_screen(person, tip);
    const auto to = on_screen(person, ahead);
    person.drag(
        static_cast<float>(from.x), static_cast<float>(from.y), static_cast<float>(to.x),
        static_cast<float>(to.y));
    CHECK_FALSE(person.session().is_changed());
    CHECK_FALSE(person.session().in_hand());
    // twelve moments of 0.02 s; the pointer is a pixel wide
    CHECK(person.view().t - t == Approx(0.24).margin(0.05));
}

TEST_CASE("What cannot be closed keeps the last good pose and says why") {
    Person person("hard/cannot-close.toml");
    const Step* const failure = person.session().story().failure();
    REQUIRE(failure != nullptr);
    person.press(Key::end);
    CHECK_FALSE(person.view().failure.empty());
    CHECK(person.view().kind == Step::Kind::failed);
    const auto& steps = person.session().story().steps();
    const auto good =
        static_cast<std::size_t>(closed_step(person.session().story(), person.session().index()));
    for (std::size_t b = 0; b < failure->state.r.size(); ++b) {
        CHECK((failure->state.r[b] - steps[good].state.r[b]).norm() == Approx(0.0).margin(1e-12));
    }
}

TEST_CASE("An edit that cannot be closed is told, and undone again") {
    Person person(kFourBar);
    go_to_closed(person, "D");
    person.ask(Command::tab_experiments);
    const std::string before = text_of(person.view());
    const int joint = joint_of(person, "D");
    const Widget slider =
        find(person, kTry, {"joint of try it", joint, "\\mathbf{s}'_i^P", 0, "##component"});
    person.drag(slider.x + 20.0F, slider.y, slider.x + 110.0F, slider.y);
    CHECK_FALSE(person.session().story().failure() == nullptr);
    CHECK_FALSE(person.view().failure.empty());
    CHECK(fault_of(person.host()) == "");
    person.ask(Command::undo);
    CHECK(text_of(person.view()) == before);
}

TEST_CASE("A free motion of a hinge goes on") {
    Person person(kFourBar);
    go_to_closed(person, "D");
    const Vec3 before = person.session().step().state.r[2];
    person.ask(Command::play_freedom);
    person.wait(0.5);
    CHECK(person.session().in_hand());
    CHECK((person.session().step().state.r[2] - before).norm() > 1e-3);
    CHECK(residual(person.session()) < 1e-9);
    REQUIRE(person.session().shown_freedom() != nullptr);
    CHECK(person.session().shown_freedom()->is_finite());
    person.ask(Command::let_go);
    CHECK_FALSE(person.session().in_hand());
    CHECK(person.session().step().state.r[2] == before);
}

TEST_CASE("The nut follows the screw through half a turn with the rotation row, and not with the cos row") {
    Person person("joints/screw.toml");
    const auto largest = [&] {
        double theta = 0.0;
        for (const Step& step : person.session().story().steps()) {
            for (const double t : step.state.theta) { theta = std::max(theta, std::abs(t)); }
        }
        return theta;
    };
    const int joint = [&] {
        const auto& joints = person.session().lesson().mechanism.joints;
        for (std::size_t k = 0; k < joints.size(); ++k) {
            if (joints[k].type->uses(Role::screw_angle)) { return static_cast<int>(k); }
        }
        return -1;
    }();
    REQUIRE(joint >= 0);
    person.press(Key::end);
    const double sound = largest();
    CHECK(sound > std::numbers::pi);
    choose_form(person, joint, "cos row");
    CHECK(
        person.session()
            .lesson()
            .mechanism.joints[static_cast<std::size_t>(joint)]
            .geometry.screw_angle_form == ScrewAngleForm::cosine);
    CHECK(fault_of(person.host()) == "");
    CHECK(std::abs(largest() - sound) > 0.1);
}

}  // namespace jw::test
