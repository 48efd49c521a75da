#include <catch2/catch.hpp>

#include "core/integrate/simulation.hpp"
#include "tests/support/driven_trees.hpp"
#include "tests/support/parallel_cranks.hpp"

/// All samples belong to one motion: between steps as at their ends, whole turns and branches included.
namespace jw {

namespace {

std::vector<SimulationSettings> ways(double tolerance) {
    std::vector<SimulationSettings> out;
    for (const Method method :
         {Method::explicit_5, Method::explicit_8, Method::implicit_5, Method::implicit_9}) {
        SimulationSettings settings;
        settings.method = method;
        settings.tolerance = tolerance;
        out.push_back(settings);
        if (entry_of(method).kind == MethodKind::radau) { continue; }
        settings.formulation = Formulation::bodies;
        out.push_back(settings);
    }
    return out;
}

std::vector<double> equal_times(double end, int count) {
    std::vector<double> times;
    for (int k = 0; k <= count; ++k) { times.push_back(end * k / count); }
    return times;
}

/// Largest distance of a body, and of its axes, from the place that its tree's drivers prescribe.
double distance(
    const test::DrivenTree& tree, const Centroidal& scene, double t, const std::vector<double>& y) {
    const std::vector<Eigen::Isometry3d> moved = tree.moved(t);
    double most = 0.0;
    for (std::size_t b = 1; b < moved.size(); ++b) {
        const Body& start = scene.mechanism.bodies[b];
        const double* numbers = body_numbers(y.data(), b - 1);
        const Mat3 A = rotation_matrix(vec4(numbers + 3).normalized());
        most = std::max(
            {most, (vec3(numbers) - moved[b] * start.r).norm(),
             (A - moved[b].linear() * rotation_matrix(start.p)).norm()});
    }
    return most;
}

}  // namespace

TEST_CASE("A tree with every joint driven is where the product of its joints' motions is", "[dynamics]") {
    constexpr double tolerance = 1e-8;
    for (unsigned seed = 0; seed < 40; ++seed) {
        test::Random random(seed);
        const test::DrivenTree tree = test::driven_tree(random, 2 + static_cast<int>(seed % 5));
        for (const SimulationSettings& settings : ways(tolerance)) {
            CAPTURE(seed, entry_of(settings.method).name, static_cast<int>(settings.formulation));
            Simulation simulation(tree.mechanism, tree.loads, settings);
            double most = 0.0;
            const auto outcome =
                simulation.run(equal_times(2.0, 40), [&](double t, const std::vector<double>& y) {
                    most = std::max(most, distance(tree, simulation.scene(), t, y));
                });
            CHECK_FALSE(outcome.failure);
            // up to six joints in a row, each off by the tolerance of a scene of 1 m, with arms of 3 m
            CHECK(most < 100.0 * tolerance);
        }
    }
}

TEST_CASE(
    "Cranks side by side pass all their singular positions as the pendulum that they are", "[dynamics]") {
    constexpr double duration = 1.5;
    for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
        for (unsigned seed = 0; seed < 8; ++seed) {
            test::Random random(seed + 100);
            const int count = 2 + static_cast<int>(seed % 4);
            const test::ParallelCranks cranks = test::parallel_cranks(random, count);
            const std::vector<double> times = equal_times(duration, 300);
            const auto angles = cranks.angles(times);
            double fastest = 0.0;
            for (const auto& [angle, rate] : angles) { fastest = std::max(fastest, std::abs(rate)); }
            const double length = extent(cranks.mechanism);
            for (const SimulationSettings& settings : ways(tolerance)) {
                CAPTURE(
                    tolerance, seed, entry_of(settings.method).name, static_cast<int>(settings.formulation));
                Simulation simulation(cranks.mechanism, cranks.loads, settings);
                const auto equations = block_equations(simulation.scene());
                equations->choose_rows(0.0, flat_start(simulation.scene().mechanism).data());
                double off = 0.0;
                std::pair<double, double> violation{0.0, 0.0};
                std::size_t k = 0;
                const auto outcome = simulation.run(times, [&](double t, const std::vector<double>& y) {
                    for (std::size_t b = 0; b < cranks.arms.size(); ++b) {
                        const Vec3 r = vec3(body_numbers(y.data(), b));
                        off = std::max(off, (r - cranks.centre(b, angles[k][0])).norm() / length);
                    }
                    const auto [phi, rate] = equations->violation(t, y.data());
                    violation = {std::max(violation.first, phi), std::max(violation.second, rate / fastest)};
                    ++k;
                });
                CHECK_FALSE(outcome.failure);
                // some ten to three hundred steps; another branch is off by a tenth at least
                CHECK(off < 1000.0 * tolerance);
                // in the sizes of other equations than those that were integrated: twice the tolerance
                CHECK(violation.first < 2.0 * tolerance);
                CHECK(violation.second < 2.0 * tolerance);
            }
        }
    }
}

}  // namespace jw
