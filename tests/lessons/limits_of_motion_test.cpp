#include <cmath>
#include <numbers>

#include "tests/lessons/dynamics_paths.hpp"
#include "tests/lessons/support.hpp"

/// Motions that are impossible, that begin late, or that do not begin at all.
namespace jw {

using test::all_ways;
using test::lesson_of;
using test::Path;
using test::path_of;
using test::times_until;
using Cause = SimulationFailure::Cause;

namespace {

/// A pendulum of 0.5 m about y, at rest below its pin.
std::string pendulum(const std::string& rest) {
    return "format = 1\ntitle = \"Pendulum\"\n"
           "[[body]]\nname = \"bob\"\nposition = [0, 0, -0.5]\nmass = 1\ninertia = [0.01, 0.01, 0.01]\n"
           "[[joint]]\nname = \"pin\"\ntype = \"revolute\"\nbodies = [\"ground\", \"bob\"]\nat = [0, 0, 0]\n"
           "axis = [0, 1, 0]\n" +
           rest + "[dynamics]\ngravity = [0, 0, -9.81]\nduration = 2\n";
}

std::string driver(const std::string& name, const std::string& what) {
    return "[[driver]]\nname = \"" + name + "\"\n" + what;
}

/// Two links of 1 m along x; C, if there is one, pins them at their far end while they are stretched.
std::string two_links(const std::string& rest) {
    return "format = 1\ntitle = \"Two links\"\n"
           "[[body]]\nname = \"a\"\nposition = [0.5, 0, 0]\nmass = 1\ninertia = [0.01, 0.09, 0.09]\n"
           "[[body]]\nname = \"b\"\nposition = [1.5, 0, 0]\nmass = 1\ninertia = [0.01, 0.09, 0.09]\n"
           "[[joint]]\nname = \"A\"\ntype = \"revolute\"\nbodies = [\"ground\", \"a\"]\nat = [0, 0, 0]\n"
           "axis = [0, 1, 0]\n"
           "[[joint]]\nname = \"B\"\ntype = \"revolute\"\nbodies = [\"a\", \"b\"]\nat = [1, 0, 0]\n"
           "axis = [0, 1, 0]\n" +
           rest + "[dynamics]\ngravity = [0, 0, -9.81]\nduration = 1\n";
}

std::vector<SimulationSettings> fixed_steps() {
    std::vector<SimulationSettings> ways;
    for (const Method method : {Method::euler, Method::semi_implicit, Method::rk4}) {
        SimulationSettings& settings = ways.emplace_back();
        settings.method = method;
        settings.step = 1e-3;
    }
    return ways;
}

std::vector<SimulationSettings> all_methods() {
    std::vector<SimulationSettings> ways = all_ways(1e-6);
    const auto fixed = fixed_steps();
    ways.insert(ways.end(), fixed.begin(), fixed.end());
    return ways;
}

}  // namespace

TEST_CASE("A driver that leads out of reach ends every run there, and is not followed", "[dynamics]") {
    const Lesson lesson = lesson_of(pendulum(driver(
        "pull", "quantity = \"coordinate\"\nbody = \"bob\"\ncoordinate = \"x\"\npolynomial = [0, 1]\n")));
    for (const SimulationSettings& settings : all_methods()) {
        CAPTURE(entry_of(settings.method).name, settings.dense.has_value());
        const Path path = path_of(lesson, settings, times_until(1.0, 50));
        REQUIRE(path.failed);
        CHECK(path.failure.cause == Cause::out_of_reach);
        // x = 0.5 at 0.5 s; fixed steps end with the step that goes beyond
        CHECK(path.failure.t == Approx(0.5).margin(2e-3));
        CHECK((path.failure.equation_of == "pull" || path.failure.equation_of == "pin"));
        CHECK(path.violation < 1e-6);
    }
}

TEST_CASE("Drivers that lead apart are found at the start, or where they part", "[dynamics]") {
    const std::string turn = "joint = \"A\"\nquantity = \"angle\"\n";
    const std::string first = driver("d1", turn + "polynomial_deg = [0, 90]\n");
    const Lesson at_once = lesson_of(two_links(first + driver("d2", turn + "polynomial_deg = [0, 45]\n")));
    const Lesson later =
        lesson_of(two_links(first + driver("d2", turn + "polynomial_deg = [0, 90, 0, 30]\n")));
    for (const SimulationSettings& settings : all_methods()) {
        CAPTURE(entry_of(settings.method).name, settings.dense.has_value());
        const Path none = path_of(at_once, settings, {0.0, 1.0});
        REQUIRE(none.failed);
        CHECK(none.failure.cause == Cause::contradiction);
        CHECK(none.failure.t == 0.0);
        CHECK(none.states.empty());
        const Path path = path_of(later, settings, times_until(1.0, 100));
        REQUIRE(path.failed);
        CHECK(path.failure.cause == Cause::contradiction);
        CHECK(path.failure.equation_of.starts_with('d'));
        CHECK(path.failure.t < 0.5);
    }
}

TEST_CASE("What begins at a singular position is not torn apart on leaving it", "[dynamics]") {
    // two stretched links can move at first, to first order, and no further
    const Lesson lesson =
        lesson_of(two_links("[[joint]]\nname = \"C\"\ntype = \"revolute\"\nbodies = [\"b\", \"ground\"]\n"
                            "at = [2, 0, 0]\naxis = [0, 1, 0]\n"));
    for (const SimulationSettings& settings : all_ways(1e-6)) {
        CAPTURE(entry_of(settings.method).name, settings.dense.has_value());
        const Path path = path_of(lesson, settings, times_until(1.0, 50));
        // the constraints hold, or the run ends with a message before a gap can be seen
        CHECK(path.violation < 1e-4);
    }
}

TEST_CASE("Whatever begins late is not stepped over", "[dynamics]") {
    // at rest for 1.1 s, then 5 N for 0.6 s: the first step would be the whole time
    const Lesson kicked = lesson_of(pendulum(
        "[[force]]\nbody = \"bob\"\ndirection = [1, 0, 0]\n"
        "step = [{ to = 5, start_s = 1.1, end_s = 1.15 }, { to = -5, start_s = 1.7, end_s = 1.75 }]\n"));
    SimulationSettings exact = fixed_steps().back();
    exact.step = 1e-4;  // 2e4 steps of order 4
    const std::vector<double> times = times_until(2.0, 40);
    const Path reference = path_of(kicked, exact, times);
    REQUIRE(std::abs(reference.states.back()[0]) > 0.1);
    for (const SimulationSettings& settings : all_ways(1e-8)) {
        CAPTURE(entry_of(settings.method).name, settings.dense.has_value());
        const Path path = path_of(kicked, settings, times);
        REQUIRE_FALSE(path.failed);
        for (std::size_t k = 0; k < times.size(); ++k) {
            // a hundred steps, each within 1e-8 of 0.5 m
            CHECK(std::abs(path.states[k][0] - reference.states[k][0]) < 1e-6);
            if (times[k] < 1.1) { CHECK(std::abs(path.states[k][0]) < 1e-12); }
        }
    }
}

TEST_CASE("A harmonic that is faster than the motion is seen", "[dynamics]") {
    // 100 Hz on a free body: from rest x'' = sin(ω t) gives x = t / ω - sin(ω t) / ω²
    const Lesson shaken = lesson_of(
        "format = 1\ntitle = \"Shaken\"\n[[body]]\nname = \"puck\"\nmass = 1\ninertia = [0.1, 0.1, 0.1]\n"
        "[[force]]\nbody = \"puck\"\ndirection = [1, 0, 0]\n"
        "harmonics = { amplitude = 1, frequency_hz = 100 }\n[dynamics]\nduration = 1\n");
    const double omega = 200.0 * std::numbers::pi;
    for (const SimulationSettings& settings : all_ways(1e-6)) {
        CAPTURE(entry_of(settings.method).name, settings.dense.has_value());
        const Path path = path_of(shaken, settings, {0.0, 1.0});
        REQUIRE_FALSE(path.failed);
        CHECK(std::abs(path.states.back()[0] - 1.0 / omega) < 1e-5);
    }
}

TEST_CASE("A scene at rest starts, and one that cannot move stays", "[dynamics]") {
    const Lesson ramp = lesson_of(
        "format = 1\ntitle = \"Ramp\"\n[[body]]\nname = \"puck\"\nmass = 1\ninertia = [0.1, 0.1, 0.1]\n"
        "[[force]]\nbody = \"puck\"\ndirection = [1, 0, 0]\npolynomial = [0, 1]\n[dynamics]\nduration = 2\n");
    const Lesson fixed = lesson_of(
        "format = 1\ntitle = \"Fixed\"\n[[body]]\nname = \"a\"\nmass = 1\ninertia = [1, 1, 1]\n"
        "[[joint]]\nname = \"f\"\ntype = \"fixed\"\nbodies = [\"ground\", \"a\"]\nat = [0, 0, 0]\n"
        "axis = [0, 0, 1]\n[dynamics]\ngravity = [0, 0, -9.81]\nduration = 1\n");
    for (const SimulationSettings& settings : all_ways(1e-6)) {
        CAPTURE(entry_of(settings.method).name, settings.dense.has_value());
        const Path path = path_of(ramp, settings, {0.0, 2.0});
        REQUIRE_FALSE(path.failed);
        CHECK(std::abs(path.states.back()[0] - 4.0 / 3.0) < 1e-6);  // t³ / 6
        const Path still = path_of(fixed, settings, {0.0, 1.0});
        REQUIRE_FALSE(still.failed);
        CHECK(std::abs(still.states.back()[2]) < 1e-12);
    }
}

TEST_CASE(
    "Implicit methods go on where one pair of coordinates stops telling the freedoms apart", "[radau]") {
    // a body on a ball joint with one direction perpendicular to another: no joint has a coordinate
    const Lesson lesson = lesson_of(
        "format = 1\ntitle = \"Ball and n1\"\n[[body]]\nname = \"a\"\nmass = 1\n"
        "inertia = [0.02, 0.03, 0.04]\nomega_local_rad_per_s = [3, 1, -2]\n"
        "[[joint]]\nname = \"s\"\ntype = \"spherical\"\nbodies = [\"ground\", \"a\"]\nat = [0.3, 0, 0]\n"
        "[[joint]]\nname = \"n\"\ntype = \"n1\"\nbodies = [\"ground\", \"a\"]\naxis = [1, 0, 0]\n"
        "axis2 = [0, 1, 0]\n[dynamics]\ngravity = [0, -9.81, 0]\nduration = 3\n");
    SimulationSettings settings;
    settings.tolerance = 1e-12;
    const std::vector<double> exact = path_of(lesson, settings, {0.0, 3.0}).states.back();
    for (const Method method : {Method::implicit_5, Method::implicit_9}) {
        for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
            CAPTURE(entry_of(method).name, tolerance);
            settings.method = method;
            settings.tolerance = tolerance;
            const Path path = path_of(lesson, settings, {0.0, 3.0});
            REQUIRE_FALSE(path.failed);
            // errors of 15 to 1000 steps, spread by the motion; measured at most 60 times the tolerance
            CHECK((vec3(path.states.back().data()) - vec3(exact.data())).norm() < 300.0 * tolerance);
        }
    }
}

TEST_CASE(
    "A parallelogram that begins in line turns on, and its accelerations are those of a turn", "[dynamics]") {
    const auto link = [](const char* name, const char* x, const char* more) {
        return std::string("[[body]]\nname = \"") + name + "\"\nposition = [" + x + ", 0, 0]\nmass = 1\n" +
               "inertia = [0.001, 0.004, 0.004]\n" + more;
    };
    const auto pin = [](const char* name, const char* bodies, const char* x) {
        return std::string("[[joint]]\nname = \"") + name + "\"\ntype = \"revolute\"\nbodies = [" + bodies +
               "]\nat = [" + x + ", 0, 0]\naxis = [0, 0, 1]\n";
    };
    const char* turning = "omega_global_rad_per_s = [0, 0, 6]\nvelocity = [0, 0.6, 0]\n";
    const Lesson lesson = lesson_of(
        "format = 1\ntitle = \"In line\"\n" + link("a", "0.1", turning) +
        link("b", "0.7", "velocity = [0, 1.2, 0]\n") + link("c", "1.1", turning) +
        pin("A", "\"ground\", \"a\"", "0") + pin("B", "\"a\", \"b\"", "0.2") +
        pin("C", "\"b\", \"c\"", "1.2") + pin("D", "\"c\", \"ground\"", "1") +
        "[dynamics]\ngravity = [0, 0, 0]\nduration = 3\n");
    for (const Formulation formulation : {Formulation::joints, Formulation::bodies}) {
        CAPTURE(static_cast<int>(formulation));
        SimulationSettings settings;
        settings.formulation = formulation;
        settings.tolerance = 1e-8;
        Simulation simulation(lesson.mechanism, lesson.dynamics->loads, settings);
        const auto outcome =
            simulation.run(times_until(3.0, 12), [&](double t, const std::vector<double>& y) {
                // what the first step leaves open shows as a speed that is off by less than 1e-4 of 6 rad/s
                CHECK(vec3(y.data()).isApprox(
                    Vec3(0.1 * std::cos(6.0 * t), 0.1 * std::sin(6.0 * t), 0.0), 2e-3));
                const Motion a = simulation.acceleration(t, y);
                // of the start itself the lines of all bars say too little
                if (t > 0.0) { CHECK(a.omega_local[1].norm() < 1e-2); }
            });
        CHECK_FALSE(outcome.failure);
    }
}

TEST_CASE("A screw tells its turns, their rate and acceleration in a simulation", "[dynamics][screw]") {
    const Lesson lesson = lesson_of(
        "format = 1\ntitle = \"Nut\"\n[[body]]\nname = \"nut\"\nmass = 1\ninertia = [0.01, 0.01, 0.01]\n"
        "[[joint]]\nname = \"thread\"\ntype = \"screw\"\nbodies = [\"ground\", \"nut\"]\nat = [0, 0, 0]\n"
        "axis = [0, 0, 1]\npitch = 0.1\n[dynamics]\ngravity = [0, 0, -9.81]\nduration = 3\n");
    const double alpha = 0.1 / (2.0 * std::numbers::pi);
    // m g α = (m α² + J) θ̈
    const double theta_ddot = -9.81 * alpha / (alpha * alpha + 0.01);
    Simulation simulation(lesson.mechanism, lesson.dynamics->loads, {});
    const auto outcome = simulation.run({0.0, 1.0, 3.0}, [&](double t, const std::vector<double>& y) {
        const Snapshot now = simulation.snapshot(t, y);
        // ten turns in 3 s, to the tolerance of 1e-6
        CHECK(now.state.theta.front() == Approx(0.5 * theta_ddot * t * t).margin(1e-5));
        CHECK(now.velocity.theta_dot.front() == Approx(theta_ddot * t).margin(1e-5));
        CHECK(simulation.acceleration_as_given(t, y).theta_dot.front() == Approx(theta_ddot).margin(1e-9));
    });
    CHECK_FALSE(outcome.failure);
}

}  // namespace jw
