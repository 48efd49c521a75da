#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

#include "app/session/rest/small_motion.hpp"
#include "core/equations/assembler.hpp"
#include "core/jets/euler_parameters.hpp"
#include "lessons/files/catalogue.hpp"
#include "lessons/read/reader.hpp"
#include "tests/app/host/checks.hpp"
#include "tests/app/host/reach.hpp"

namespace jw::test {
namespace {

using host::Key;
using host::Tab;

constexpr const char* kLamp = "statics/lamp.toml";
const Vec3 kLampAtRest{0.2 * std::cos(std::numbers::pi / 6.0), 0.0, 0.1};

void open_tab(Person& person) {
    person.type("7");
    person.host().wait_for_rest();
    person.settle();
}

void press_radio(Person& person, const char* label) {
    const Widget widget = find(person, "rest", {label});
    person.click(widget.x, widget.y);
    person.host().wait_for_rest();
    person.settle();
}

/// Place of the last body in the picture.
Vec3 place_in_picture(Person& person) {
    const auto& triads = person.host().picture().scene.triads;
    REQUIRE(!triads.empty());
    return triads.back().pose.r;
}

double largest_phi(const RestView& view, const State& pose) {
    Assembler<OmegaLocal> assembler(*view.instant.system);
    assembler.assemble_phi_and_jacobian(pose, 0.0);
    return assembler.phi().size() == 0 ? 0.0 : assembler.phi().lpNorm<Eigen::Infinity>();
}

}  // namespace

TEST_CASE("The tab At rest shows the equilibrium of the whole lesson at any step, until it is left") {
    Person person(kLamp);
    const Vec3 at_start = place_in_picture(person);
    CHECK((at_start - Vec3(0.2, 0.0, 0.0)).norm() < 1e-12);
    open_tab(person);
    REQUIRE(person.host().state().tab == Tab::rest);
    CHECK((place_in_picture(person) - kLampAtRest).norm() < 1e-9);
    // the pose is not that of the step: nothing can be pulled
    for (const render::Shape& shape : person.host().picture().scene.shapes) { CHECK(shape.id == 0); }
    CHECK_FALSE(person.session().in_hand());
    person.type("1");
    CHECK((place_in_picture(person) - at_start).norm() < 1e-9);
    person.type("7");
    CHECK((place_in_picture(person) - kLampAtRest).norm() < 1e-9);
    person.press(Key::right);
    CHECK((place_in_picture(person) - at_start).norm() < 1e-9);
    press_radio(person, "the equilibrium");
    CHECK((place_in_picture(person) - kLampAtRest).norm() < 1e-9);
    person.press(Key::escape);
    CHECK((place_in_picture(person) - at_start).norm() < 1e-9);
    CHECK_FALSE(person.session().is_changed());
    CHECK(fault_of(person.host()) == "");
}

TEST_CASE("The tab At rest computes nothing while the equilibrium is shown") {
    Person person(kLamp);
    open_tab(person);
    person.rest();
    const std::uint64_t picture = person.host().shown().version();
    for (int k = 0; k < 20; ++k) { person.host().frame(0.1); }
    CHECK(person.host().shown().version() == picture);
    CHECK(person.host().seconds_to_change() > 0.1);
}

TEST_CASE(
    "A small motion of the lamp has the frequency of its closed form, and swings about the equilibrium") {
    Person person(kLamp);
    open_tab(person);
    const RestView& view = person.host().rest().found();
    REQUIRE(view.outcome.motions.modes.size() == 1);
    const Mode& mode = view.outcome.motions.modes[0];
    // V = m g c sin θ + k (l - 0.2 m)² / 2 with l² = 0.32 - 0.32 sin θ has V'' = 2.943 N m at 30 deg; the
    // inertia about the hinge is 0.12 kg m², the damping 0.15 N m s
    CHECK(mode.s.real() == Approx(-0.15 / 0.24).epsilon(1e-9));
    CHECK(mode.s.imag() == Approx(std::sqrt(2.943 / 0.12 - std::pow(0.15 / 0.24, 2))).epsilon(1e-9));

    constexpr double amplitude = 0.2;
    const auto angle_at = [&](double seconds) {
        const auto pose = pose_in_mode(view, 0, amplitude * host::place_in_motion(mode.s, seconds));
        REQUIRE(pose);
        CHECK(largest_phi(view, *pose) < 1e-10);
        CHECK(pose->r[1].norm() == Approx(0.2).epsilon(1e-9));
        return std::atan2(pose->r[1].z(), pose->r[1].x());
    };
    const double at_rest = std::numbers::pi / 6.0;
    CHECK(angle_at(0.0) == Approx(at_rest).epsilon(1e-9));
    // the axis of the hinge is -y; the tangent predicts the turn up to second order
    const double turn = -amplitude * mode.shape.omega_local[1].y();
    REQUIRE(std::abs(turn) > 0.5 * amplitude);
    CHECK(angle_at(0.75) - at_rest == Approx(turn).epsilon(0.1));
    CHECK(angle_at(2.25) - at_rest == Approx(-turn).epsilon(0.1));

    press_radio(person, "small motion 1");
    CHECK(person.host().is_moving());
    CHECK(person.host().seconds_to_change() < 0.02);
    const Vec3 before = place_in_picture(person);
    person.wait(0.2);
    const Vec3 after = place_in_picture(person);
    CHECK((after - before).norm() > 0.005);
    CHECK(after.norm() == Approx(0.2).epsilon(1e-9));
    // to and fro: the whole swing stays within its amplitude
    for (int k = 0; k < 30; ++k) {
        person.wait(0.1);
        CHECK((place_in_picture(person) - kLampAtRest).norm() < 0.35 * 0.2);
    }
    person.type("1");
    CHECK_FALSE(person.host().is_moving());
}

TEST_CASE("A motion that grows moves away in the picture, and begins again after each period") {
    const auto size = [](std::complex<double> s, double seconds) {
        return std::abs(host::place_in_motion(s, seconds));
    };
    for (double t = 0.0; t < 2.8; t += 0.1) {
        CHECK(size(2.0, t) < size(2.0, t + 0.1));
        CHECK(size(-2.0, t) > size(-2.0, t + 0.1));
        CHECK(size(2.0, t) <= 1.0);
        CHECK(size(-2.0, t) <= 1.0);
    }
    CHECK(size(2.0, 3.1) == Approx(size(2.0, 0.1)));

    Person person("statics/leaning-rod.toml");
    open_tab(person);
    CHECK(person.host().rest().found().outcome.motions.stability == Stability::stable);
    press_radio(person, "the nearest, stable or not");
    const RestView& upright = person.host().rest().found();
    CHECK(upright.outcome.motions.stability == Stability::unstable);
    CHECK((place_in_picture(person) - Vec3::UnitZ()).norm() < 1e-7);
    press_radio(person, "small motion 1");
    person.wait(2.0);
    CHECK(person.host().rest().pose());
    CHECK(fault_of(person.host()) == "");
}

TEST_CASE("Lessons without [dynamics] have no tab At rest") {
    Person person("loops/four-bar.toml");
    person.type("7");
    CHECK(person.host().state().tab == Tab::step);
    CHECK_THAT(person.host().notice().text(), Catch::Contains("[dynamics]"));
    person.type("6");
    person.press(Key::tab);
    CHECK(person.host().state().tab == Tab::step);
    // it is left with its lesson
    REQUIRE(person.host().open(catalogue_folder() / kLamp));
    person.settle();
    open_tab(person);
    REQUIRE(person.host().open(catalogue_folder() / "loops/four-bar.toml"));
    person.settle();
    CHECK(person.host().state().tab == Tab::step);
    CHECK(fault_of(person.host()) == "");
}

TEST_CASE("Where no equilibrium is found, the tab At rest shows the step") {
    Person person("dynamics/sled-with-brake.toml");
    const Vec3 before = place_in_picture(person);
    open_tab(person);
    CHECK_THAT(person.host().rest().found().failure, Catch::Contains("No equilibrium was found"));
    CHECK((place_in_picture(person) - before).norm() < 1e-9);
}

TEST_CASE("The first small motion of every lesson satisfies all equations, and leaves the lesson sound") {
    int shown = 0;
    for (const auto& lesson : lessons_below(catalogue_folder())) {
        if (!read_lesson_file(lesson).lesson->dynamics) { continue; }
        CAPTURE(lesson.filename());
        Person person(lesson.string());
        open_tab(person);
        const RestView& view = person.host().rest().found();
        if (view.outcome.motions.modes.empty()) { continue; }
        press_radio(person, "small motion 1");
        person.wait(0.5);
        const std::optional<State>& pose = person.host().rest().pose();
        REQUIRE(pose);
        CHECK(largest_phi(view, *pose) < 1e-9);
        CHECK(fault_of(person.host()) == "");
        ++shown;
    }
    CHECK(shown > 15);
}

}  // namespace jw::test
