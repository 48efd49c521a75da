#include <catch2/catch.hpp>

#include "core/motion/certificate.hpp"
#include "core/motion/tree/tree_equations.hpp"
#include "tests/support/driven.hpp"
#include "tests/support/random_dynamics.hpp"

/// Trees with additional links: rows between two bodies whose common ancestor moves itself.

using namespace jw;

namespace {

constexpr double kTime = 0.05;

/// A linked tree with its loads, on its constraints near its start pose.
struct LinkedScene {
    test::Random random;
    Centroidal scene;
    std::vector<double> start;
};

/// Random linked trees; the few that have no pose nearby at the time of the test are skipped.
class LinkedScenes {
public:
    LinkedScene next() {
        for (;;) {
            LinkedScene linked{test::Random(++seed), {}, {}};
            test::Random& random = linked.random;
            Mechanism mechanism =
                moved_rigidly(test::random_linked_tree(random), random.unit_p(), random.vector());
            // height of the last body, which hangs on one that moves
            mechanism.drivers.push_back(
                {"height", -1, 0, static_cast<int>(mechanism.bodies.size()) - 1, CoordinateMeasure{2},
                 test::polynomial({mechanism.bodies.back().r.z(), random.number(), random.number()})});
            Loads loads = test::random_loads(random, mechanism);
            loads.masses.back()->centre_local.setZero();  // a driven coordinate is that of the centre
            linked.scene = centroidal(mechanism, loads);
            if (find_moment(linked)) { return linked; }
            REQUIRE(++left_out < 200);
        }
    }

    unsigned seed = 0;

private:
    /// True if a moment satisfies the equation of p1 that is left out, too; random_moment does not test it.
    static bool find_moment(LinkedScene& linked) {
        constexpr double nearby = 0.02;
        try {
            linked.start =
                test::flat_of(linked.scene, test::random_moment(linked.random, linked.scene, kTime, nearby));
        } catch (const std::runtime_error&) { return false; }
        const auto block = block_equations(linked.scene);
        block->choose_rows(kTime, linked.start.data());
        return block->violation(kTime, linked.start.data()).first < 1e-10;
    }

    int left_out = 0;
};

std::vector<ProbedBody> probed(
    MotionEquations& equations, Certificate& certificate, const std::vector<double>& y,
    const std::vector<double>& y_dot) {
    std::vector<ProbedBody> bodies(static_cast<std::size_t>(equations.bodies()));
    equations.motion_of_bodies(kTime, y.data(), y_dot.data(), bodies);
    REQUIRE(equations.free_motion(kTime, y.data(), certificate.draw(equations.velocities()), bodies));
    return bodies;
}

double largest(const AccelerationResidual& residual) {
    return std::max(residual.forces, residual.constraints);
}

}  // namespace

TEST_CASE(
    "Joint coordinates move linked trees as the equations of the bodies do", "[core][dynamics][linked]") {
    LinkedScenes scenes;
    for (int number = 0; number < 300; ++number) {
        const LinkedScene linked = scenes.next();
        CAPTURE(scenes.seed);
        TreeEquations tree(linked.scene, linked.start);
        std::vector<double> y(static_cast<std::size_t>(tree.size()));
        tree.from_flat(linked.start.data(), y.data());
        tree.choose_rows(kTime, y.data());
        std::vector<double> y_dot(y.size());
        tree.evaluate(kTime, y.data(), y_dot.data());
        std::vector<ProbedBody> bodies(static_cast<std::size_t>(tree.bodies()));
        tree.motion_of_bodies(kTime, y.data(), y_dot.data(), bodies);

        const auto block = block_equations(linked.scene);
        block->choose_rows(kTime, linked.start.data());
        std::vector<double> block_dot(linked.start.size());
        block->evaluate(kTime, linked.start.data(), block_dot.data());
        double size = 1.0;
        double off = 0.0;
        for (std::size_t m = 0; m < bodies.size(); ++m) {
            const Vec3 r_ddot = vec3(body_numbers(block_dot.data(), m) + 7);
            const Vec3 alpha = bodies[m].A * vec3(body_numbers(block_dot.data(), m) + 10);
            size = std::max({size, r_ddot.norm(), alpha.norm()});
            off = std::max({off, (bodies[m].r_ddot - r_ddot).norm(), (bodies[m].alpha - alpha).norm()});
        }
        // rounding, 1e-16, times the condition of the matrix of λ
        const double condition = 1.0 / std::min(block->smallest_pivot(), tree.smallest_pivot());
        CAPTURE(condition, size);
        CHECK(off < 1e-12 * condition * size);
    }
}

TEST_CASE("Right accelerations are certified in every form of the equations", "[core][dynamics][linked]") {
    LinkedScenes scenes;
    for (int number = 0; number < 100; ++number) {
        const LinkedScene linked = scenes.next();
        CAPTURE(scenes.seed);
        Certificate certificate(linked.scene, {});
        TreeEquations tree(linked.scene, linked.start);
        std::vector<double> y(static_cast<std::size_t>(tree.size()));
        std::vector<double> y_dot(y.size());
        tree.from_flat(linked.start.data(), y.data());
        tree.choose_rows(kTime, y.data());
        tree.project(kTime, y.data());
        tree.evaluate(kTime, y.data(), y_dot.data());
        const AccelerationResidual by_joints = certificate.check(kTime, probed(tree, certificate, y, y_dot));

        const auto block = block_equations(linked.scene);
        std::vector<double> block_dot(linked.start.size());
        block->choose_rows(kTime, linked.start.data());
        block->evaluate(kTime, linked.start.data(), block_dot.data());
        const AccelerationResidual by_bodies =
            certificate.check(kTime, probed(*block, certificate, linked.start, block_dot));
        CHECK(largest(by_joints) < 1e-9);
        CHECK(largest(by_bodies) < 1e-9);
    }
}

TEST_CASE("Wrong accelerations are not certified", "[core][dynamics][linked]") {
    LinkedScenes scenes;
    for (int number = 0; number < 100; ++number) {
        LinkedScene linked = scenes.next();
        CAPTURE(scenes.seed);
        Certificate certificate(linked.scene, {});
        TreeEquations tree(linked.scene, linked.start);
        std::vector<double> y(static_cast<std::size_t>(tree.size()));
        std::vector<double> y_dot(y.size());
        tree.from_flat(linked.start.data(), y.data());
        tree.choose_rows(kTime, y.data());
        tree.project(kTime, y.data());
        tree.evaluate(kTime, y.data(), y_dot.data());
        double size = 0.0;
        for (const double rate : y_dot) { size = std::max(size, std::abs(rate)); }
        // any one joint
        const int joint = static_cast<int>(linked.random.number(0.0, 0.999 * tree.velocities()));
        y_dot[static_cast<std::size_t>(tree.joints().positions() + joint)] += 1e-3 * size;
        CHECK(largest(certificate.check(kTime, probed(tree, certificate, y, y_dot))) > 1e-7);
    }
}
