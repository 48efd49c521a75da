#include <catch2/catch.hpp>

#include "core/motion/tree/tree_equations.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/driven.hpp"
#include "tests/support/random_dynamics.hpp"

using namespace jw;

namespace {

std::vector<Mechanism> tree_loops_and_screw(test::Random& random) {
    return {
        test::random_tree(random), test::driven(test::four_bar_at(0.7), 0, 1.0), test::bricard(1.2),
        test::screw(0.7, 0.25, ScrewAngleForm::rotation)};
}

}  // namespace

TEST_CASE(
    "An evaluation of the block equations allocates nothing, nor does a projection", "[core][allocation]") {
    test::Random random(2);
    for (const Mechanism& mechanism : tree_loops_and_screw(random)) {
        const Centroidal scene = centroidal(mechanism, test::random_loads(random, mechanism));
        const std::unique_ptr<MotionEquations> equations = block_equations(scene);
        std::vector<double> y = test::flat_of(scene, test::random_moment(random, scene, 0.0, 0.02));
        std::vector<double> y_dot(y.size());
        equations->choose_rows(0.0, y.data());

        const long before = test::allocations();
        equations->evaluate(0.0, y.data(), y_dot.data());
        CHECK(test::allocations() == before);
        y.front() += 1e-3;
        CHECK(equations->project(0.0, y.data()) > 1e-5);
        CHECK(test::allocations() == before);
        CHECK(equations->violation(0.0, y.data()).first < 1e-10);
    }
}

TEST_CASE(
    "An evaluation in joint coordinates allocates nothing, nor does a projection", "[core][allocation]") {
    test::Random random(2);
    for (const Mechanism& mechanism : tree_loops_and_screw(random)) {
        const Centroidal scene = centroidal(mechanism, test::random_loads(random, mechanism));
        std::vector<double> flat = test::flat_of(scene, test::random_moment(random, scene, 0.0, 0.02));
        TreeEquations tree(scene, flat);
        std::vector<double> y(static_cast<std::size_t>(tree.size()));
        std::vector<double> y_dot(y.size());
        tree.from_flat(flat.data(), y.data());
        tree.choose_rows(0.0, y.data());

        const long before = test::allocations();
        tree.evaluate(0.0, y.data(), y_dot.data());
        y.front() += 1e-3;
        tree.project(0.0, y.data());
        tree.to_flat(y.data(), flat.data());
        CHECK(test::allocations() == before);
        CHECK(tree.violation(0.0, y.data()).first < 1e-12);
    }
}
