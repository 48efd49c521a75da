#include <catch2/catch.hpp>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "core/equations/assembler.hpp"
#include "core/motion/tree/tree_equations.hpp"
#include "tests/support/driven.hpp"
#include "tests/support/random_dynamics.hpp"

/// Rows of loops compared with dense matrices of the bodies.
using namespace jw;

namespace {

/// Three hinges in a row, a body that hangs from nothing, and three rods that close loops.
struct Rods {
    static constexpr int kHinges = 3;
    Mechanism mechanism;
    Loads loads;
};

Rods rods(test::Random& random) {
    test::SceneBuilder scene;
    for (int b = 0; b < 4; ++b) { scene.add_body("body " + std::to_string(b + 1), random.vector(2.0)); }
    for (int b = 0; b < Rods::kHinges; ++b) {
        scene.add_joint("revolute", b, b + 1, random.vector(2.0), random.direction());
    }
    scene.add_distance(0, 2, random.vector(2.0), random.vector(2.0) + Vec3(3.0, 0.0, 0.0));
    scene.add_distance(1, 4, random.vector(2.0), random.vector(2.0) + Vec3(0.0, 3.0, 0.0));
    scene.add_distance(4, 3, random.vector(2.0), random.vector(2.0) + Vec3(0.0, 0.0, 3.0));
    Rods out;
    out.mechanism = scene.mechanism;
    out.loads.masses = test::random_masses(random, out.mechanism);
    return out;
}

/// Φ and Φq of everything, in (r, ω') of the centres of mass.
struct Dense {
    VectorX phi;
    MatrixX jacobian;
};

Dense dense_at(const Mechanism& mechanism, const State& state) {
    const System system(mechanism, everything(mechanism));
    Assembler<OmegaLocal> assembler(system);
    assembler.assemble_phi_and_jacobian(state, 0.0);
    return {assembler.phi(), assembler.jacobian()};
}

MatrixX mass_matrix(const Centroidal& scene) {
    const auto bodies = static_cast<Eigen::Index>(scene.mechanism.bodies.size()) - 1;
    MatrixX M = MatrixX::Zero(6 * bodies, 6 * bodies);
    for (Eigen::Index b = 0; b < bodies; ++b) {
        const MassProperties& own = *scene.loads.masses[at(b + 1)];
        M.block<3, 3>(6 * b, 6 * b) = own.mass * Mat3::Identity();
        M.block<3, 3>(6 * b + 3, 6 * b + 3) = own.J_local;
    }
    return M;
}

/// Smallest pivot of R (M on the motions that the hinges allow)⁻¹ Rᵀ, relative to the size of R M⁻¹ Rᵀ.
double smallest_pivot(const Centroidal& scene, const MatrixX& hinges, const MatrixX& R) {
    const MatrixX N = Eigen::FullPivLU<MatrixX>(hinges).kernel();
    const MatrixX M = mass_matrix(scene);
    const MatrixX RN = R * N;
    MatrixX G = RN * (N.transpose() * M * N).llt().solve(RN.transpose());
    const VectorX sizes = (R * M.llt().solve(R.transpose())).diagonal();
    double smallest = 1.0;
    for (Eigen::Index k = 0; k < G.rows(); ++k) {
        smallest = std::min(smallest, G(k, k) / sizes(k));
        const Eigen::Index rest = G.rows() - k - 1;
        const VectorX column = G.col(k).tail(rest);
        G.bottomRightCorner(rest, rest) -= column * column.transpose() / G(k, k);
    }
    return smallest;
}

std::vector<double> start_in(TreeEquations& tree, const std::vector<double>& flat) {
    std::vector<double> y(at(tree.size()));
    tree.from_flat(flat.data(), y.data());
    tree.choose_rows(0.0, y.data());
    return y;
}

}  // namespace

TEST_CASE(
    "The smallest pivot of rows of loops is that of the dense matrices", "[core][dynamics][tree_rows]") {
    const auto seed = GENERATE(range(1U, 6U));
    CAPTURE(seed);
    test::Random random(seed);
    const Rods scene = rods(random);
    const Centroidal moved = centroidal(scene.mechanism, scene.loads);
    TreeEquations tree(moved, flat_start(moved.mechanism));
    const std::vector<double> y = start_in(tree, flat_start(moved.mechanism));
    std::vector<double> y_dot(y.size());
    tree.evaluate(0.0, y.data(), y_dot.data());
    const MatrixX all = dense_at(moved.mechanism, start_state(moved.mechanism)).jacobian;
    const double expected = smallest_pivot(moved, all.topRows(5 * Rods::kHinges), all.bottomRows(3));
    // sizes are those of the rows at the pose where they were chosen, which is this one; rounding only
    CHECK(tree.smallest_pivot() == Approx(expected).epsilon(1e-9));
}

TEST_CASE(
    "A row between bodies without other constraints keeps its full size", "[core][dynamics][tree_rows]") {
    test::Random random(7);
    test::SceneBuilder scene;
    scene.add_body("body", random.vector());
    Loads loads;
    const auto pivot = [&] {
        loads.masses = test::random_masses(random, scene.mechanism);
        const Centroidal moved = centroidal(scene.mechanism, loads);
        TreeEquations tree(moved, flat_start(moved.mechanism));
        const std::vector<double> y = start_in(tree, flat_start(moved.mechanism));
        std::vector<double> y_dot(y.size());
        tree.evaluate(0.0, y.data(), y_dot.data());
        return tree.smallest_pivot();
    };
    CHECK(pivot() == 1.0);
    scene.add_distance(0, 1, random.vector(), random.vector() + Vec3(3.0, 0.0, 0.0));
    CHECK(pivot() == Approx(1.0).epsilon(1e-12));
}

TEST_CASE("Rows of loops are off by the sizes of their equations", "[core][dynamics][tree_rows]") {
    const auto seed = GENERATE(range(1U, 6U));
    CAPTURE(seed);
    test::Random random(seed);
    const Rods scene = rods(random);
    const Centroidal moved = centroidal(scene.mechanism, scene.loads);
    TreeEquations tree(moved, flat_start(moved.mechanism));
    std::vector<double> y = start_in(tree, flat_start(moved.mechanism));
    const Dense start = dense_at(moved.mechanism, start_state(moved.mechanism));
    std::vector<double> y_dot(y.size());
    tree.evaluate(0.0, y.data(), y_dot.data());

    // another pose, for which the evaluated numbers do not hold
    for (double& number : y) { number += random.number(-0.05, 0.05); }
    std::vector<double> flat(at(kNumbersPerBody * tree.bodies()));
    tree.to_flat(y.data(), flat.data());
    State state = start_state(moved.mechanism);
    Motion motion = start_motion(moved.mechanism);
    unpack(flat.data(), moving_bodies_of(moved.mechanism), state, motion);
    const Dense there = dense_at(moved.mechanism, state);
    VectorX velocities(24);
    for (Eigen::Index b = 0; b < 4; ++b) {
        velocities.segment<3>(6 * b) = motion.r_dot[at(b + 1)];
        velocities.segment<3>(6 * b + 3) = motion.omega_local[at(b + 1)];
    }
    // the size of a row is its change when bodies move by one extent
    const double L = extent(moved.mechanism);
    double off = 0.0;
    double rate_off = 0.0;
    for (Eigen::Index k = 5 * Rods::kHinges; k < there.jacobian.rows(); ++k) {
        double square = 0.0;
        for (Eigen::Index b = 0; b < 4; ++b) {
            square += start.jacobian.row(k).segment<3>(6 * b).squaredNorm() +
                      start.jacobian.row(k).segment<3>(6 * b + 3).squaredNorm() / (L * L);
        }
        const double unit = L * std::sqrt(square);
        off = std::max(off, std::abs(there.phi(k)) / unit);
        rate_off = std::max(rate_off, std::abs(there.jacobian.row(k).dot(velocities)) / unit);
    }
    const auto [found, found_rate] = tree.violation(0.0, y.data());
    CHECK(found == Approx(off).epsilon(1e-9));
    CHECK(found_rate == Approx(rate_off).epsilon(1e-9));
    // the projection reports the same
    CHECK(tree.project(0.0, y.data()) == Approx(off).epsilon(1e-9));
    const auto [left, left_rate] = tree.violation(0.0, y.data());
    CHECK(left < 1e-14);
    CHECK(left_rate < 1e-13);
}

TEST_CASE(
    "Rows of loops that repeat others are left out of joint coordinates", "[core][dynamics][tree_rows]") {
    struct Loop {
        Mechanism mechanism;
        int kept;  ///< freedoms of its tree minus its own
    };
    const auto [mechanism, kept] = GENERATE(
        Loop{test::four_bar_at(0.7), 2}, Loop{test::driven(test::four_bar_at(0.7), 0, 1.5), 3},
        Loop{test::bennett(1.0), 2}, Loop{test::bricard(1.2), 4});
    test::Random random(3);
    Loads loads;
    loads.masses = test::random_masses(random, mechanism);
    const Centroidal scene = centroidal(mechanism, loads);
    TreeEquations tree(scene, flat_start(scene.mechanism));
    start_in(tree, flat_start(scene.mechanism));
    CHECK(tree.rows() - tree.rows_left_out() == kept);
}

TEST_CASE("Products of the rows of loops are counted joint by joint", "[core][dynamics][tree_rows]") {
    // loops that share nothing but the ground
    Mechanism mechanism = test::four_bar_at(0.7);
    const Mechanism one = mechanism;
    const int count = GENERATE(1, 2);
    CAPTURE(count);
    const auto bodies = static_cast<int>(one.bodies.size()) - 1;
    for (int loop = 1; loop < count; ++loop) {
        mechanism.bodies.insert(mechanism.bodies.end(), one.bodies.begin() + 1, one.bodies.end());
        for (Joint joint : one.joints) {
            for (int* body : {&joint.body_i, &joint.body_j}) { *body += *body > 0 ? loop * bodies : 0; }
            mechanism.joints.push_back(joint);
        }
    }
    test::Random random(3);
    Loads loads;
    loads.masses = test::random_masses(random, mechanism);
    const Centroidal scene = centroidal(mechanism, loads);
    const TreeEquations tree(scene, flat_start(scene.mechanism));
    // each of the rows of a cut joint is felt by the three hinges of its tree, and reaches its first row
    const double hinges = 3.0;
    const double rows = tree.rows() / count;
    const double kept = 0.5;
    double expected = 0.5 * hinges * (kept * rows) * (kept * rows);
    for (double k = 0.0; k < rows; ++k) { expected += kept * (50.0 * hinges + 0.5 * kept * k * kept * k); }
    CHECK(tree.products_of_rows(kept) == Approx(count * expected).epsilon(1e-12));
}
