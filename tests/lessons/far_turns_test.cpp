#include <cmath>
#include <numbers>

#include "tests/lessons/dynamics_paths.hpp"
#include "tests/lessons/support.hpp"
#include "tests/support/dynamics_scenes.hpp"

/// Large rotations: springs over several turns, axes that leave their pair of rows, drivers that leave no
/// freedom.
namespace jw {

using test::all_ways;
using test::lesson_of;
using test::Path;
using test::path_of;
using test::points_of;

namespace {

/// A disc or a nut on the z axis.
std::string on_an_axis(const std::string& joint, const std::string& motion, const std::string& rest) {
    return "format = 1\ntitle = \"On an axis\"\n"
           "[[body]]\nname = \"disc\"\nmass = 1\ninertia = [0.1, 0.1, 0.2]\n" +
           motion +
           "\n[[joint]]\nname = \"h\"\nbodies = [\"ground\", \"disc\"]\nat = [0, 0, 0]\naxis = [0, 0, 1]\n" +
           joint +
           "\n[dynamics]\ngravity = [0, 0, 0]\nduration = 3\npoint = { body = \"disc\", point = [0.1, 0, 0] "
           "}\n" +
           rest;
}

}  // namespace

TEST_CASE("A rotational spring is wound beyond half a turn, and over many", "[dynamics][springs]") {
    struct Wound {
        const char* joint;
        const char* motion;
        double omega;    ///< at the start [rad/s]
        double inertia;  ///< that the spring feels [kg m²]
    };
    // 200 degrees; and four turns on a thread of 0.1 m a turn, whose mass moves along
    const double along = 0.1 / (2.0 * std::numbers::pi);
    const Wound hinge{"type = \"revolute\"", "omega_local_rad_per_s = [0, 0, 5.52]", 5.52, 0.2};
    const Wound screw{
        "type = \"screw\"\npitch = 0.1",
        "omega_local_rad_per_s = [0, 0, 40]\nvelocity = [0, 0, 0.6366197723675814]", 40.0,
        0.2 + along * along};
    for (const Wound& wound : {hinge, screw}) {
        const Lesson lesson = lesson_of(
            on_an_axis(wound.joint, wound.motion, "[[rotational_spring]]\njoint = \"h\"\nstiffness = 0.5\n"));
        const double frequency = std::sqrt(0.5 / wound.inertia);
        for (const SimulationSettings& settings : all_ways(1e-9)) {
            CAPTURE(wound.joint, entry_of(settings.method).name, settings.dense.has_value());
            const Path path = path_of(lesson, settings, {0.0, 0.7, 1.5, 3.0});
            REQUIRE_FALSE(path.failed);
            for (const auto& [k, t] : {std::pair<std::size_t, double>{1, 0.7}, {2, 1.5}, {3, 3.0}}) {
                // a hundred to two hundred steps, each within 1e-9 of the fastest turn
                const double exact = wound.omega * std::cos(frequency * t);
                CHECK(std::abs(path.states[k][12] - exact) < 2e-7 * wound.omega);
                CHECK(std::abs(path.energies[k] - path.energies[0]) < 1e-6 * path.energies[0]);
            }
        }
    }
}

TEST_CASE("Kept pairs follow their axes through all directions in every choice", "[dynamics][dense]") {
    // after a quarter turn of an axis, the pair of rows that was chosen at the start loses rank
    const Lesson chain = test::chain(test::ChainJoint::revolute, 4);
    for (const SimulationSettings& settings : all_ways(1e-7)) {
        CAPTURE(entry_of(settings.method).name, settings.dense ? static_cast<int>(*settings.dense) : -1);
        const Path path = path_of(chain, settings, {0.0, 2.0});
        REQUIRE_FALSE(path.failed);
        const Vec3 end = points_of(chain, path).back();
        CHECK((end - *chain.dynamics->point_at_end).norm() < 2e-5);
    }
}

TEST_CASE(
    "Where a driver leaves nothing free, no method passes over what lies between", "[dynamics][radau]") {
    // two turns and a rest: an implicit method has no error of its own that limits its steps
    const Lesson crank = lesson_of(
        "format = 1\ntitle = \"Driven crank-rocker\"\n"
        "[[body]]\nname = \"crank\"\nposition = [0, 0, 0.15]\nmass = 1\ninertia = [0.01, 0.01, 0.01]\n"
        "[[body]]\nname = \"coupler\"\nposition = [0.6, 0, 0.55]\nmass = 1\ninertia = [0.1, 0.1, 0.1]\n"
        "[[body]]\nname = \"rocker\"\nposition = [1.1, 0, 0.4]\nmass = 1\ninertia = [0.1, 0.1, 0.1]\n"
        "[[joint]]\nname = \"A\"\ntype = \"revolute\"\nbodies = [\"ground\", \"crank\"]\nat = [0, 0, 0]\n"
        "axis = [0, -1, 0]\n"
        "[[joint]]\nname = \"B\"\ntype = \"revolute\"\nbodies = [\"crank\", \"coupler\"]\nat = [0, 0, 0.3]\n"
        "axis = [0, -1, 0]\n"
        "[[joint]]\nname = \"C\"\ntype = \"revolute\"\nbodies = [\"coupler\", \"rocker\"]\n"
        "at = [1.2, 0, 0.8]\naxis = [0, -1, 0]\n"
        "[[joint]]\nname = \"D\"\ntype = \"revolute\"\nbodies = [\"rocker\", \"ground\"]\nat = [1, 0, 0]\n"
        "axis = [0, -1, 0]\n"
        "[[driver]]\nname = \"motor\"\njoint = \"A\"\nquantity = \"angle\"\nfrom_start = true\n"
        "step = { from_deg = 0, to_deg = 720, start_s = 0.1, end_s = 2 }\n"
        "[dynamics]\ngravity = [0, 0, -9.81]\nduration = 2.5\n"
        "point = { body = \"rocker\", point = [0.1, 0, 0] }\n");
    std::vector<double> times;
    for (int k = 0; k <= 50; ++k) { times.push_back(0.05 * k); }
    SimulationSettings settings;
    settings.tolerance = 1e-10;
    const std::vector<Vec3> explicit_path = points_of(crank, path_of(crank, settings, times));
    for (const Method method : {Method::implicit_5, Method::implicit_9}) {
        settings.method = method;
        const Path path = path_of(crank, settings, times);
        REQUIRE_FALSE(path.failed);
        const std::vector<Vec3> points = points_of(crank, path);
        for (std::size_t k = 0; k < points.size(); ++k) {
            CHECK((points[k] - explicit_path[k]).norm() < 1e-8);
        }
    }
}

TEST_CASE("An implicit method passes a singular position or says that it cannot", "[dynamics][radau]") {
    const Lesson four_bar = test::n_four_bar(1);
    for (const double tolerance : {1e-6, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12}) {
        CAPTURE(tolerance);
        SimulationSettings settings;
        settings.method = Method::implicit_9;
        settings.tolerance = tolerance;
        const Path path = path_of(four_bar, settings, {0.0, 0.5, 0.7, 0.8, 1.5, 3.0, 10.0});
        if (tolerance > 1e-9) { REQUIRE_FALSE(path.failed); }
        // all results before the end are right: 40 J move
        for (const double energy : path.energies) { CHECK(std::abs(energy - path.energies[0]) < 1e-3); }
    }
}

}  // namespace jw
