#include <cmath>

#include "core/eigen/decompositions.hpp"
#include "core/motion/dense/dense_equations.hpp"
#include "tests/hard/cases.hpp"
#include "tests/hard/dynamic_scene.hpp"
#include "tests/hard/shipped.hpp"

namespace jw::hard {

namespace {

using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
using LongVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

/// The lesson with masses of 1e-9, 1e9, 1e-9 ... times its own.
Lesson with_masses_apart(Lesson lesson) {
    double factor = 1e-9;
    for (auto& mass : lesson.dynamics->loads.masses) {
        if (!mass) { continue; }
        mass->mass *= factor;
        mass->J_local *= factor;
        factor = 1.0 / factor;
    }
    return lesson;
}

/// Equations of slide 24 at the start, with independent rows only.
struct Written {
    MatrixX mass, jacobian;
    VectorX force, gamma;
};
Written written(const Centroidal& scene, const std::vector<double>& y) {
    DenseEquations<OmegaLocal> equations(scene);
    std::vector<double> y_dot(y.size());
    equations.evaluate(0.0, y.data(), y_dot.data());
    const Eigen::ColPivHouseholderQR<MatrixX> qr(equations.jacobian().transpose());
    const int rank = equations.rows() - equations.rows_left_out();
    Written out{equations.mass_matrix(), MatrixX(rank, qr.rows()), equations.force(), VectorX(rank)};
    for (int k = 0; k < rank; ++k) {
        const auto row = qr.colsPermutation().indices()(k);
        out.jacobian.row(k) = equations.jacobian().row(row);
        out.gamma(k) = equations.right_side()(row);
    }
    return out;
}

/// The whole matrix in long double: 64 bits, and pivots that do not mix heavy and light.
VectorX true_accelerations(const Written& w) {
    const Eigen::Index n = w.mass.rows();
    const Eigen::Index m = w.jacobian.rows();
    LongMatrix whole = LongMatrix::Zero(n + m, n + m);
    whole.topLeftCorner(n, n) = w.mass.cast<long double>();
    whole.bottomLeftCorner(m, n) = w.jacobian.cast<long double>();
    whole.topRightCorner(n, m) = w.jacobian.transpose().cast<long double>();
    LongVector right(n + m);
    right << w.force.cast<long double>(), w.gamma.cast<long double>();
    return LongVector(whole.partialPivLu().solve(right)).head(n).cast<double>();
}

/// Accelerations with λ from Φq M⁻¹ Φqᵀ, as most programs compute them.
VectorX by_schur_complement(const Written& w) {
    const VectorX inverse_mass = w.mass.diagonal().cwiseInverse();  // J' of these rods is diagonal
    const MatrixX schur = w.jacobian * inverse_mass.asDiagonal() * w.jacobian.transpose();
    const VectorX free = inverse_mass.cwiseProduct(w.force);
    const VectorX lambda = schur.partialPivLu().solve(w.gamma - w.jacobian * free);
    return free + inverse_mass.cwiseProduct(w.jacobian.transpose() * lambda);
}

/// Rank of Φq M⁻¹ Φqᵀ with the usual relative threshold: it depends on the masses.
double rank_by_mass(const Written& w) {
    const MatrixX schur = w.jacobian * w.mass.diagonal().cwiseInverse().asDiagonal() * w.jacobian.transpose();
    Eigen::FullPivLU<MatrixX> lu(schur);
    lu.setThreshold(1e-12);
    return double(lu.rank());
}

double largest(const VectorX& x) {
    const double value = x.cwiseAbs().maxCoeff();
    return std::isfinite(value) ? value : HUGE_VAL;
}

}  // namespace

Result masses_eighteen_decades_apart() {
    DynamicScene scene = shipped_scene("dynamics/bricard-falling.toml");
    scene.lesson = with_masses_apart(scene.lesson);
    const Centroidal centroidal = centroidal_of(scene.lesson);
    const std::vector<double> y = flat_start(centroidal.mechanism);
    const Written w = written(centroidal, y);
    const VectorX truth = true_accelerations(w);
    const VectorX naive = by_schur_complement(w);

    const auto equations = block_equations(centroidal);
    std::vector<double> y_dot(y.size());
    equations->choose_rows(0.0, y.data());
    equations->evaluate(0.0, y.data(), y_dot.data());
    VectorX ours(truth.size());
    for (Eigen::Index k = 0; k < ours.size(); ++k) {
        ours(k) = y_dot[static_cast<std::size_t>(kNumbersPerBody * (k / 6) + 7 + k % 6)];
    }
    const Trajectory run = run_of(scene, adaptive(Method::explicit_8, 1e-9), 0.1);

    const double size = largest(truth);
    Result result;
    result.naive =
        "1/m of a heavy body is lost in rounding beside 1/m of the light body that carries it. No digit is "
        "right, and no message says so.";
    result.ours =
        "masses do not affect the rank; where light bodies carry heavy ones, the whole matrix is solved with "
        "pivoting.";
    result.measurements = {
        of_both(
            "rank found, of 29", rank_by_mass(w), at_most(28.0),
            double(equations->rows() - equations->rows_left_out()), exactly(29)),
        // 16 digits, less the two that the condition of Φq, 1e2, costs
        of_both(
            "error of accelerations, by the largest", largest(naive - truth) / size, at_least(1e-2),
            largest(ours - truth) / size, at_most(1e-12)),
        of_both(
            "largest |Φq q̈ - γ|, by the largest q̈", largest(w.jacobian * naive - w.gamma) / size, any(),
            largest(w.jacobian * ours - w.gamma) / size, at_most(1e-12)),
        // the tolerance is 1e-9 a step, and a step loses energy of some hundred times that
        of_ours("change of energy in 1 s, by the kinetic energy", run.energy, at_most(1e-6)),
        of_ours("constraints off by at most, in 1 s", run.violation, at_most(1e-9)),
    };
    return result;
}

}  // namespace jw::hard
