#include <catch2/catch.hpp>

#include <Eigen/LU>

#include "core/motion/tree/tree_equations.hpp"
#include "tests/support/driven.hpp"
#include "tests/support/random_dynamics.hpp"

using namespace jw;

namespace {

std::vector<double> flat_of(const StateLayout& equations, const std::vector<double>& y) {
    std::vector<double> flat(static_cast<std::size_t>(kNumbersPerBody * equations.bodies()));
    equations.to_flat(y.data(), flat.data());
    return flat;
}

/// Rates of the flat state when y moves at ẏ, by differences of sixth order.
std::vector<double> flat_rates(
    const MotionEquations& equations, const std::vector<double>& y, const std::vector<double>& y_dot) {
    constexpr double h = 1e-3;
    std::vector<double> out;
    for (const auto& [steps, weight] : {std::pair{1, 45.0}, std::pair{2, -9.0}, std::pair{3, 1.0}}) {
        for (const int sign : {1, -1}) {
            std::vector<double> there = y;
            for (std::size_t k = 0; k < y.size(); ++k) { there[k] += sign * steps * h * y_dot[k]; }
            const std::vector<double> flat = flat_of(equations, there);
            out.resize(flat.size(), 0.0);
            for (std::size_t k = 0; k < flat.size(); ++k) { out[k] += sign * weight * flat[k] / (60.0 * h); }
        }
    }
    return out;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
    REQUIRE(a.size() == b.size());
    double largest = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) { largest = std::max(largest, std::abs(a[k] - b[k])); }
    return largest;
}

/// Sets the products of inertia in every J' to zero, for which the equations have a shorter form.
void turn_to_principal_axes(Centroidal& scene) {
    for (std::optional<MassProperties>& own : scene.loads.masses) {
        if (own) { own->J_local = Mat3(own->J_local.diagonal().asDiagonal()); }
    }
}

/// A pose and a motion away from the start that the tree is made of.
std::vector<double> moved(
    test::Random& random, TreeEquations& tree, const std::vector<double>& start, double t) {
    std::vector<double> y(static_cast<std::size_t>(tree.size()));
    tree.from_flat(start.data(), y.data());
    tree.choose_rows(t, y.data());
    for (double& number : y) { number += random.number(-0.1, 0.1); }
    tree.project(t, y.data());
    return y;
}

}  // namespace

TEST_CASE("In joint coordinates the joints of the tree hold whatever the numbers are", "[core][dynamics]") {
    for (unsigned seed = 1; seed <= 10; ++seed) {
        CAPTURE(seed);
        test::Random random(seed);
        Mechanism mechanism = moved_rigidly(test::random_tree(random), random.unit_p(), random.vector());
        // a body cannot hang from single equations or from links without mass
        std::erase_if(mechanism.joints, [](const Joint& joint) { return !joint.type->can_carry(); });
        const Centroidal scene = centroidal(mechanism, test::random_loads(random, mechanism));
        TreeEquations tree(scene, test::flat_of(scene, test::random_moment(random, scene, 0.0)));
        CHECK(tree.rows() == 0);
        std::vector<double> y(static_cast<std::size_t>(tree.size()));
        for (double& number : y) { number = random.number(-2.0, 2.0); }
        const std::vector<double> flat = flat_of(tree, y);
        const auto block = block_equations(scene);
        block->choose_rows(0.0, flat.data());
        const auto [position, velocity] = block->violation(0.0, flat.data());
        // rounding of a few products in a row
        CHECK(position < 1e-13);
        CHECK(velocity < 1e-12);
    }
}

TEST_CASE("A state goes to joint coordinates and back", "[core][dynamics]") {
    test::Random random(3);
    for (const Mechanism& mechanism : test::mechanisms_of_all_kinds(random)) {
        const Centroidal scene = centroidal(mechanism, test::random_loads(random, mechanism));
        const std::vector<double> start = test::flat_of(scene, test::random_moment(random, scene, 0.3));
        const TreeEquations tree(scene, start);
        std::vector<double> y(static_cast<std::size_t>(tree.size()));
        tree.from_flat(start.data(), y.data());
        // the moment satisfies its constraints to 1e-11
        CHECK(largest_difference(flat_of(tree, y), start) < 1e-10);
    }
}

TEST_CASE("Where along its axis the point of a joint was typed does not matter", "[core][dynamics]") {
    constexpr double far = 1e4;
    for (unsigned seed = 1; seed <= 10; ++seed) {
        CAPTURE(seed);
        test::Random random(seed);
        const Mechanism near = moved_rigidly(test::random_tree(random), random.unit_p(), random.vector());
        const Loads loads = test::random_loads(random, near);
        Mechanism moved_off = near;
        for (Joint& joint : moved_off.joints) {
            JointGeometry& g = joint.geometry;
            const std::string_view type = joint.type->name;
            const bool turns_about_a_point =
                type == "spherical" || type == "s" || type == "universal" || !joint.type->can_carry();
            if (turns_about_a_point) { continue; }
            const Mat3 A_i = rotation_matrix(near.bodies[at(joint.body_i)].p);
            const Mat3 A_j = rotation_matrix(near.bodies[at(joint.body_j)].p);
            const bool anywhere = type == "prismatic" || type == "fixed";
            const Vec3 way = far * (anywhere ? random.vector().normalized() : Vec3(A_i * g.s_i_local));
            g.P_i_local += A_i.transpose() * way;
            g.P_j_local += A_j.transpose() * way;
        }
        const Centroidal scene = centroidal(near, loads);
        const Centroidal scene_off = centroidal(moved_off, loads);
        const std::vector<double> start = test::flat_of(scene, test::random_moment(random, scene, 0.0));
        TreeEquations tree(scene, start);
        TreeEquations tree_off(scene_off, start);
        REQUIRE(tree.size() == tree_off.size());
        std::vector<double> y(static_cast<std::size_t>(tree.size()));
        for (double& number : y) { number = random.number(-1.0, 1.0); }
        std::vector<double> y_dot(y.size());
        std::vector<double> y_dot_off(y.size());
        tree.evaluate(0.0, y.data(), y_dot.data());
        tree_off.evaluate(0.0, y.data(), y_dot_off.data());
        double size = 1.0;
        for (const double rate : y_dot) { size = std::max(size, std::abs(rate)); }
        // places of 1e4 m have a rounding of 1e-12 m; inertias there would have lost eight digits
        CHECK(largest_difference(y_dot, y_dot_off) < 1e-10 * size);
    }
}

TEST_CASE("Joint coordinates are the same to the last bit whatever registers there are", "[core][dynamics]") {
    test::Random random(8);
    for (const Mechanism& mechanism : test::mechanisms_of_all_kinds(random)) {
        const Centroidal scene = centroidal(mechanism, test::random_loads(random, mechanism));
        const std::vector<double> start = test::flat_of(scene, test::random_moment(random, scene, 0.3));
        const auto numbers_with = [&](Registers registers) {
            test::Random same(4);
            TreeEquations tree(scene, start, registers);
            std::vector<double> y = moved(same, tree, start, 0.3);
            std::vector<double> y_dot(y.size());
            tree.evaluate(0.3, y.data(), y_dot.data());
            y.insert(y.end(), y_dot.begin(), y_dot.end());
            return y;
        };
        const std::vector<double> wide = numbers_with(widest_registers());
        const std::vector<double> narrow = numbers_with(Registers::narrow);
        CHECK(wide == narrow);
    }
}

TEST_CASE("Joint coordinates move the bodies as the equations of the bodies do", "[core][dynamics]") {
    for (unsigned seed = 1; seed <= 5; ++seed) {
        test::Random random(seed);
        int number = 0;
        for (const Mechanism& mechanism : test::mechanisms_of_all_kinds(random)) {
            CAPTURE(seed, number++);
            Centroidal scene = centroidal(mechanism, test::random_loads(random, mechanism));
            if (seed % 2 == 0) { turn_to_principal_axes(scene); }
            const double t = 0.3;
            TreeEquations tree(scene, test::flat_of(scene, test::random_moment(random, scene, t)));
            const std::vector<double> y =
                moved(random, tree, test::flat_of(scene, test::random_moment(random, scene, t)), t);
            const std::vector<double> flat = flat_of(tree, y);

            const auto block = block_equations(scene);
            block->choose_rows(t, flat.data());
            const auto [position, velocity] = block->violation(t, flat.data());
            CHECK(position < 1e-12);
            CHECK(velocity < 1e-11);
            CHECK(
                block->rows() - block->rows_left_out() ==
                6 * block->bodies() - (tree.joints().velocities() - (tree.rows() - tree.rows_left_out())));

            std::vector<double> block_dot(flat.size());
            std::vector<double> y_dot(y.size());
            block->evaluate(t, flat.data(), block_dot.data());
            tree.evaluate(t, y.data(), y_dot.data());
            double size = 1.0;
            for (const double rate : block_dot) { size = std::max(size, std::abs(rate)); }
            // differences of sixth order: (h ω)⁶ with accelerations of 100 at most, and rounding / h
            CHECK(largest_difference(flat_rates(tree, y, y_dot), block_dot) < 1e-9 * size);
        }
    }
}

TEST_CASE("Rows that begin late are factored like any others", "[core][dynamics]") {
    test::Random random(5);
    for (const int size : {1, 2, 7, 20}) {
        std::vector<int> first;
        for (int k = 0; k < size; ++k) {
            first.push_back(std::max(0, k - static_cast<int>(random.number(0.0, 5.0))));
        }
        EnvelopeMatrix matrix(first);
        MatrixX dense = MatrixX::Zero(size, size);
        for (int a = 0; a < size; ++a) {
            for (int b = first[static_cast<std::size_t>(a)]; b <= a; ++b) {
                // five neighbours on both sides: their sum stays below the diagonal
                dense(a, b) = dense(b, a) = matrix(a, b) = a == b ? 12.0 : random.number(-1.0, 1.0);
            }
        }
        VectorX x(size);
        for (double& number : x) { number = random.number(-1.0, 1.0); }
        const VectorX exact = dense.fullPivLu().solve(x);
        matrix.factor();
        matrix.solve(x.data());
        CHECK((x - exact).norm() < 1e-14 * exact.norm() + 1e-15);
    }
}
