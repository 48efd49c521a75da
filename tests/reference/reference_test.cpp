#include <catch2/catch.hpp>

#include "tests/reference/closed_forms.hpp"
#include "tests/reference/formulations.hpp"
#include "tests/reference/scenes.hpp"
#include "tests/reference/stored.hpp"

namespace jw::reference {
namespace {

Trajectory stored(const std::string& name) {
    const auto file = std::filesystem::path(JW_SOURCE_ROOT) / "lessons" / "reference" / (name + ".csv");
    return read_trajectory(file).value_or(Trajectory{});
}

// files hold 16 digits of up to 18 m; ways of most scenes are 1e-16 m apart. The free body passes its
// separatrix at 0.003 rad/s: each of its nine turns multiplies rounding, to 5e-13 m among nine ways
constexpr double kAgreed = 2e-15;
constexpr double kAgreedFreeBody = 1e-12;

double allowed(const Scene& scene) {
    return scene.name == "free-asymmetric-body" ? kAgreedFreeBody : kAgreed;
}

/// Scenes that together take less than a second.
std::vector<Scene> cheap_scenes() {
    return {simple_pendulum(),     four_bars(1),
            four_bars(4),          andrews(),
            bricard_falling(),     chain(4, JointKind::revolute),
            spinning_top(),        spatial_slider_crank_falling(),
            free_asymmetric_body()};
}

/// End position of the point as published by others who computed these scenes; NaN: not given.
struct End {
    const char* name;
    Vec3 r;
    Real error;  ///< half a unit of the last digit given, or the error of the other program
};

// clang-format off
const Real kNone = std::nanl("");
const End kEnds[] = {
    {"simple-pendulum", {-0.295850422283221L, -0.955234278925772L, 0.0L}, 1e-15L},
    {"four-bar-1", {0.478385057760971L, 0.878150178791209L, 0.0L}, 1e-15L},
    {"four-bar-4", {0.251385506951622L, kNone, 0.0L}, 1e-15L},
    {"four-bar-16", {0.192465372486931L, kNone, 0.0L}, 1e-15L},
    {"four-bar-40", {0.180512226686729L, kNone, 0.0L}, 1e-15L},
    {"andrews", {-0.005208504722297L, 0.004676695260311L, 0.0L}, 1e-15L},
    {"bricard-falling", {0.999999963806L, -1.000269012697L, 0.999730951120L}, 1e-12L},
    {"governor", {0.0408888676L, -0.0287767355L, 0.619622917061L}, 1e-10L},
    // the list these were taken from has ...783464 in x, two digits in the wrong order
    {"chain-revolute-4", {-2.874729784463L, 0.805742245130L, 1.181061769846L}, 3e-12L},
    {"chain-revolute-16", {-6.200367620996L, -13.780780273368L, -1.828194771765L}, 1e-12L},
    {"chain-spherical-4", {-1.517379684648L, 0.453886859532L, 3.260786311263L}, 1e-12L},
    {"chain-spherical-16", {-11.109223802811L, -11.234590750691L, -1.251050701962L}, 1e-12L},
};
// clang-format on

}  // namespace

TEST_CASE("Every scene has a stored reference that starts at its point", "[reference]") {
    for (const Scene& scene : all_scenes()) {
        CAPTURE(scene.name);
        const Trajectory trajectory = stored(scene.name);
        REQUIRE(trajectory.size() == kIntervals + 1);
        CHECK((trajectory.front().r - scene.point).norm() < 1e-16L);
    }
}

TEST_CASE("The stored references end where other programs ended", "[reference]") {
    for (const End& end : kEnds) {
        CAPTURE(end.name);
        const Trajectory trajectory = stored(end.name);
        REQUIRE(!trajectory.empty());
        for (int k = 0; k < 3; ++k) {
            if (std::isnan(end.r[k])) { continue; }
            CHECK(std::abs(trajectory.back().r[k] - end.r[k]) <= 1.5L * end.error);
        }
    }
}

TEST_CASE("Joint coordinates and extrapolation give the stored references", "[reference]") {
    for (const Scene& scene : cheap_scenes()) {
        CAPTURE(scene.name);
        const Method method = scene.passes_singular ? Method::runge_kutta_fehlberg : Method::extrapolation;
        const Real tolerance = scene.passes_singular ? 1e-18L : scene.finest;
        const Trajectory found = integrate(*joint_coordinates(scene), scene.duration, method, tolerance);
        CHECK(static_cast<double>(largest_distance(found, stored(scene.name))) < allowed(scene));
    }
}

TEST_CASE("Absolute coordinates and Runge-Kutta-Fehlberg give the stored references", "[reference]") {
    for (const Scene& scene : cheap_scenes()) {
        // many bodies, and E's three joints: seconds
        if (scene.passes_singular || scene.name == "andrews") { continue; }
        CAPTURE(scene.name);
        const Trajectory found =
            integrate(*absolute_coordinates(scene), scene.duration, Method::runge_kutta_fehlberg, 1e-17L);
        CHECK(static_cast<double>(largest_distance(found, stored(scene.name))) < allowed(scene));
    }
}

TEST_CASE("Elliptic functions give the stored references", "[reference]") {
    int solved = 0;
    for (const Scene& scene : all_scenes()) {
        const auto found = closed_form(scene);
        if (!found) { continue; }
        ++solved;
        CAPTURE(scene.name);
        CHECK(static_cast<double>(largest_distance(*found, stored(scene.name))) < 1e-15);
    }
    CHECK(solved == 7);
}

TEST_CASE("Stored velocities are the derivatives of the stored positions", "[reference]") {
    // smooth on the scale of the samples: differences of eighth order over 0.1 s are off by 3e-3 m/s at most,
    // speeds are up to 4 m/s
    for (const char* name : {"simple-pendulum", "bricard-falling", "governor"}) {
        CAPTURE(name);
        const Trajectory s = stored(name);
        REQUIRE(s.size() == kIntervals + 1);
        Real most = 0.0L;
        for (std::size_t k = 10; k + 4 < s.size(); ++k) {
            const auto pair = [&](std::size_t n) -> Vec3 { return s[k + n].r - s[k - n].r; };
            const Vec3 slope =
                (672.0L * pair(1) - 168.0L * pair(2) + 32.0L * pair(3) - 3.0L * pair(4)) / (840.0L * 0.1L);
            most = std::max(most, (slope - s[k].v).norm());
        }
        CHECK(static_cast<double>(most) < 1e-2);
    }
}

TEST_CASE("Andrews' crank passes the angle published for 0.03 s", "[reference]") {
    // IVP test set: beta, good to about 1e-10 of itself; ours changes by less than 1e-16 m with tolerance
    const Trajectory trajectory = stored("andrews");
    REQUIRE(trajectory.size() == kIntervals + 1);
    const Real beta = 15.81077119629904L;
    const Vec3 F = 0.007L * Vec3(std::cos(beta), std::sin(beta), 0.0L);
    CHECK((trajectory[60].r - F).norm() < 0.007L * 2e-9L);
}

TEST_CASE("A wrong mass moves the end of a chain by more than the references allow", "[reference]") {
    Scene scene = chain(4, JointKind::revolute);
    scene.bodies[2].mass *= 1.0L + 1e-9L;
    const Trajectory found =
        integrate(*joint_coordinates(scene), scene.duration, Method::extrapolation, 1e-14L);
    CHECK(largest_distance(found, stored(scene.name)) > 1000.0L * kAgreed);
}

}  // namespace jw::reference
