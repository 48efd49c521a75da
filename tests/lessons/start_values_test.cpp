#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>

#include <catch2/catch.hpp>

#include "core/jets/euler_parameters.hpp"
#include "core/model/placement.hpp"
#include "lessons/write/writer.hpp"
#include "tests/lessons/support.hpp"

using namespace jw;
using test::lesson_of;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
// Newton's method and the tracker end at rounding of positions, 1e-13; loops multiply it
constexpr double kClosed = 1e-9;

/// Lengths of a four-bar in the plane of x and y, its hinges A at the origin and D on the x axis, [m].
struct FourBar {
    double crank, coupler, rocker, ground;

    /// Angles of crank, coupler and rocker to the x axis where the crank stands at `alpha` [rad] and C lies
    /// to the left of the line from B to D.
    std::array<double, 3> angles(double alpha) const {
        const double to_d[2] = {ground - crank * std::cos(alpha), -crank * std::sin(alpha)};
        const double length = std::hypot(to_d[0], to_d[1]);
        const double at_b =
            std::acos((length * length + coupler * coupler - rocker * rocker) / (2.0 * length * coupler));
        const double beta = std::atan2(to_d[1], to_d[0]) + at_b;
        const double c[2] = {
            crank * std::cos(alpha) + coupler * std::cos(beta) - ground,
            crank * std::sin(alpha) + coupler * std::sin(beta)};
        return {alpha, beta, std::atan2(c[1], c[0])};
    }
};

constexpr FourBar kCrankRocker{0.4, 1.0, 0.8, 1.0};
constexpr FourBar kDoubleRocker{1.0, 0.9, 1.0, 1.2};

std::string body_text(const std::string& name, double x, double y, double angle) {
    std::ostringstream text;
    text.precision(3);
    text << "[[body]]\nname = \"" << name << "\"\nposition = [" << x << ", " << y
         << ", 0]\nrotation = { axis = [0, 0, 1], angle_deg = " << angle / kDegree << " }\n";
    return text.str();
}

std::string hinge_text(
    const std::string& name, const std::string& i, const std::string& j, double x_i, double x_j,
    const std::string& keys) {
    std::ostringstream text;
    text << "[[joint]]\nname = \"" << name << "\"\ntype = \"revolute\"\nbodies = [\"" << i << "\", \"" << j
         << "\"]\npoint_i = [" << x_i << ", 0, 0]\npoint_j = [" << x_j
         << ", 0, 0]\naxis_i = [0, 0, 1]\naxis_j = [0, 0, 1]\nside_i = [1, 0, 0]\nside_j = [1, 0, 0]\n"
         << keys << '\n';
    return text.str();
}

/// A four-bar whose bodies are placed with three digits where its crank stands at `alpha`, with further keys
/// of the hinges A and D.
std::string four_bar_text(
    const FourBar& bar, double alpha, const std::string& keys_of_a, const std::string& keys_of_d = {}) {
    const auto [a, b, d] = bar.angles(alpha);
    return "format = 1\ntitle = \"four-bar\"\n" + body_text("crank", 0.0, 0.0, a) +
           body_text("coupler", bar.crank * std::cos(a), bar.crank * std::sin(a), b) +
           body_text("rocker", bar.ground, 0.0, d) + hinge_text("A", "ground", "crank", 0.0, 0.0, keys_of_a) +
           hinge_text("B", "crank", "coupler", bar.crank, 0.0, "") +
           hinge_text("C", "coupler", "rocker", bar.coupler, bar.rocker, "") +
           hinge_text("D", "ground", "rocker", bar.ground, 0.0, keys_of_d);
}

std::string angle_key(double degrees) {
    std::ostringstream text;
    text.precision(12);
    text << "angle_deg = " << degrees;
    return text.str();
}

/// Largest difference of the start pose of a four-bar from the closed form.
double off_closed_form(const Lesson& lesson, const FourBar& bar, double alpha) {
    const State state = start_state(lesson.mechanism);
    const auto [a, b, d] = bar.angles(alpha);
    double most = (state.r[2] - Vec3(bar.crank * std::cos(a), bar.crank * std::sin(a), 0.0)).norm();
    const double angles[] = {a, b, d};
    for (std::size_t k = 0; k < 3; ++k) {
        const Mat3 A = rotation_matrix(state.p[k + 1]);
        most = std::max(most, (A.col(0) - Vec3(std::cos(angles[k]), std::sin(angles[k]), 0.0)).norm());
    }
    return most;
}

std::string slider_crank_text(const std::string& keys) {
    return "format = 1\ntitle = \"slider-crank\"\n" + body_text("crank", 0.0, 0.0, 60.0 * kDegree) +
           body_text("rod", 0.1, 0.173, -20.3 * kDegree) + body_text("slider", 0.57, 0.0, 0.0) +
           hinge_text("A", "ground", "crank", 0.0, 0.0, "") + hinge_text("B", "crank", "rod", 0.2, 0.0, "") +
           hinge_text("C", "rod", "slider", 0.5, 0.0, "") +
           "[[joint]]\nname = \"guide\"\ntype = \"prismatic\"\nbodies = [\"ground\", \"slider\"]\n"
           "point_i = [0, 0, 0]\npoint_j = [0, 0, 0]\naxis_i = [1, 0, 0]\naxis_j = [1, 0, 0]\n"
           "side_i = [0, 1, 0]\nside_j = [0, 0, 1]\n" +
           keys + '\n';
}

/// The only message of a lesson with one mistake.
std::string mistake_in(const std::string& text) {
    const ReadResult result = read_lesson(text, "test.toml");
    INFO(result.report());
    REQUIRE(result.diagnostics.size() == 1);
    CHECK(result.diagnostics.front().code == Code::start_value);
    CHECK_FALSE(result.lesson.has_value());
    return result.diagnostics.front().message;
}

/// The number after `words` in a message.
double number_after(const std::string& message, const std::string& words) {
    CAPTURE(message);
    const std::size_t place = message.find(words);
    REQUIRE(place != std::string::npos);
    return std::stod(message.substr(place + words.size()));
}

}  // namespace

TEST_CASE("A start angle places a four-bar on the branch of the poses in the file", "[lessons][start]") {
    const double start = GENERATE(60.0, -75.0) * kDegree;
    const double alpha = GENERATE(-170.0, -90.0, -10.0, 0.0, 30.0, 90.0, 150.0, 180.0);
    CAPTURE(start, alpha);
    const Lesson lesson = lesson_of(four_bar_text(kCrankRocker, start, angle_key(alpha)));
    CHECK(off_closed_form(lesson, kCrankRocker, alpha * kDegree) < kClosed);
    CHECK(
        std::abs(std::remainder(
            relative_angle(lesson.mechanism.joints[0], start_state(lesson.mechanism)) - alpha * kDegree,
            2.0 * std::numbers::pi)) < kClosed);
}

TEST_CASE("The angle of any hinge of a loop determines the others", "[lessons][start]") {
    const double alpha = 100.0 * kDegree;
    const double gamma = kCrankRocker.angles(alpha)[2] / kDegree;
    const Lesson lesson = lesson_of(four_bar_text(kCrankRocker, 60.0 * kDegree, "", angle_key(gamma)));
    CHECK(off_closed_form(lesson, kCrankRocker, alpha) < kClosed);
}

TEST_CASE("An angle goes the longer way round where the shorter one is blocked", "[lessons][start]") {
    // B cannot be further from D than coupler and rocker reach, which is at 119.2 deg
    const Lesson lesson = lesson_of(four_bar_text(kDoubleRocker, 100.0 * kDegree, angle_key(-100.0)));
    CHECK(off_closed_form(lesson, kDoubleRocker, -100.0 * kDegree) < kClosed);
}

TEST_CASE("A start displacement places a slider-crank", "[lessons][start]") {
    const double x = GENERATE(0.4, 0.65, 0.56904157598234297);
    const Lesson lesson = lesson_of(slider_crank_text("displacement = " + std::to_string(x)));
    const double typed = std::stod(std::to_string(x));
    const State state = start_state(lesson.mechanism);
    const double cosine = (typed * typed + 0.2 * 0.2 - 0.5 * 0.5) / (2.0 * 0.2 * typed);
    CHECK((state.r[3] - Vec3(typed, 0.0, 0.0)).norm() < kClosed);
    CHECK((state.r[2] - 0.2 * Vec3(cosine, std::sqrt(1.0 - cosine * cosine), 0.0)).norm() < kClosed);
}

TEST_CASE("The message tells how far a joint gets towards its start value", "[lessons][start]") {
    const std::string stretched = mistake_in(slider_crank_text("displacement = 0.9"));
    CHECK(
        stretched.starts_with("joint 'guide' cannot start at 0.9 m: the motion from the pose in the file "));
    // the tracker ends a few millionths before a turning point; there, the way goes with the square of the
    // turn
    CHECK(std::abs(number_after(stretched, "turns back at ") - 0.7) < 1e-4);

    const std::string blocked = mistake_in(four_bar_text(kDoubleRocker, 100.0 * kDegree, angle_key(170.0)));
    const double most = std::acos((1.0 + 1.44 - 1.9 * 1.9) / 2.4) / kDegree;
    CHECK(std::abs(number_after(blocked, "turns back at ") - most) < 0.01);
}

TEST_CASE("Start values that contradict each other are named, typed digits agree", "[lessons][start]") {
    const double gamma = kCrankRocker.angles(90.0 * kDegree)[2] / kDegree;
    const std::string start = angle_key(90.0);
    const std::string message =
        mistake_in(four_bar_text(kCrankRocker, 60.0 * kDegree, start, angle_key(gamma + 5.0)));
    CHECK(message.starts_with("joint 'D' cannot start at " + short_number(gamma + 5.0) + " deg: "));
    CHECK(std::abs(number_after(message, "place it at ") - gamma) < 1e-3);

    const Lesson lesson =
        lesson_of(four_bar_text(kCrankRocker, 60.0 * kDegree, start, angle_key(gamma + 0.004)));
    CHECK(off_closed_form(lesson, kCrankRocker, 90.0 * kDegree) < kClosed);
}

TEST_CASE("A driver from the start begins with the start value", "[lessons][start]") {
    const std::string motor =
        "[[driver]]\nname = \"motor\"\nquantity = \"A.angle\"\nfrom_start = true\npolynomial_deg = [0, "
        "360]\n";
    const Lesson lesson = lesson_of(four_bar_text(kCrankRocker, 60.0 * kDegree, angle_key(90.0)) + motor);
    CHECK(off_closed_form(lesson, kCrankRocker, 90.0 * kDegree) < kClosed);
    CHECK(std::abs(lesson.mechanism.drivers[0].function.at(0.0).f - 90.0 * kDegree) < kClosed);
}

TEST_CASE("The start angle of a screw counts turns", "[lessons][start]") {
    const Lesson lesson = lesson_of(
        "format = 1\ntitle = \"screw\"\n[[body]]\nname = \"nut\"\n[[joint]]\nname = \"thread\"\n"
        "type = \"screw\"\nbodies = [\"ground\", \"nut\"]\nat = [0, 0, 0]\naxis = [0, 0, 1]\npitch = 0.1\n"
        "angle_deg = 810\n");
    const State state = start_state(lesson.mechanism);
    CHECK(std::abs(state.theta[0] - 810.0 * kDegree) < kClosed);
    CHECK((state.r[1] - Vec3(0.0, 0.0, 0.225)).norm() < kClosed);
}

TEST_CASE("A global angular velocity stays where a start value turns the body", "[lessons][start]") {
    const Lesson lesson = lesson_of(
        "format = 1\ntitle = \"plate\"\n[[body]]\nname = \"plate\"\nmass = 1\ninertia = [1, 1, 1]\n"
        "omega_global_rad_per_s = [1, 2, 3]\n[[joint]]\nname = \"hinge\"\ntype = \"p1\"\n"
        "bodies = [\"ground\", \"plate\"]\naxis = [1, 0, 0]\nangle_deg = 70\n[dynamics]\nduration = 1\n");
    const Body& plate = lesson.mechanism.bodies[1];
    const Mat3 A = rotation_of(plate);
    CHECK((A.col(1) - Vec3(0.0, std::cos(70.0 * kDegree), std::sin(70.0 * kDegree))).norm() < kClosed);
    CHECK((A * plate.omega_local - Vec3(1.0, 2.0, 3.0)).norm() < kClosed);
}

TEST_CASE("A written lesson starts where the lesson with start values does", "[lessons][start]") {
    const Lesson lesson = lesson_of(four_bar_text(kCrankRocker, 60.0 * kDegree, angle_key(90.0)));
    const Lesson again = lesson_of(lesson_text(lesson));
    for (std::size_t b = 0; b < lesson.mechanism.bodies.size(); ++b) {
        CHECK(again.mechanism.bodies[b].r == lesson.mechanism.bodies[b].r);
        CHECK(again.mechanism.bodies[b].p == lesson.mechanism.bodies[b].p);
    }
}

TEST_CASE("A joint goes the longer way round if branches meet on the shorter one", "[lessons][start]") {
    // crank and ground together are as long as coupler and rocker: flat at 180 degrees
    const FourBar flat{0.3, 0.5, 0.8, 1.0};
    const Lesson lesson = lesson_of(four_bar_text(flat, 150.0 * kDegree, angle_key(-150.0)));
    CHECK(off_closed_form(lesson, flat, -150.0 * kDegree) < kClosed);
}

TEST_CASE("A driver that begins with the start holds what no start value moves", "[lessons][start]") {
    const std::string arm = "format = 1\ntitle = \"arm\"\n" + body_text("upper", 0.0, 0.0, 0.0) +
                            body_text("lower", 1.0, 0.0, 0.0) +
                            hinge_text("A", "ground", "upper", 0.0, 0.0, angle_key(30.0)) +
                            hinge_text("B", "upper", "lower", 1.0, 0.0, "") +
                            "[[driver]]\nname = \"motor\"\njoint = \"B\"\nquantity = \"angle\"\n"
                            "from_start = true\npolynomial_deg = [0, 90]\n[motion]\nto_s = 1\n";
    const State state = start_state(lesson_of(arm).mechanism);
    const Vec3 along(std::cos(30.0 * kDegree), std::sin(30.0 * kDegree), 0.0);
    CHECK((rotation_matrix(state.p[2]).col(0) - along).norm() < kClosed);
}
