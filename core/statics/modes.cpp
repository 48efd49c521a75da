#include "core/statics/modes.hpp"

#include <algorithm>

namespace jw {

namespace {

using Complex = std::complex<double>;

// K comes from differences: 1e-12 of the loads, and a factor of a hundred for what is added up
constexpr double kRounding = 1e-10;
// eigenvalues of a matrix of 2n rows that is not symmetric, by Eigen's QR iteration
constexpr double kRateRounding = 1e-9;

/// Shape of a mode from its coordinates along the freedoms, its largest movement 1.
Mode mode_of(const FreeForces& forces, Complex s, const Eigen::VectorXcd& z) {
    VectorX real = forces.free() * z.real();
    VectorX late = forces.free() * z.imag();
    const double size = std::max(forces.movement(real), forces.movement(late));
    if (size > 0.0) {
        real /= size;
        late /= size;
    }
    return {
        s, forces.layout().motion_of(forces.state(), real), forces.layout().motion_of(forces.state(), late)};
}

/// Turns the phase of complex coordinates so that the largest of them is real and positive.
Eigen::VectorXcd in_phase(const Eigen::VectorXcd& z) {
    Eigen::Index largest = 0;
    z.cwiseAbs().maxCoeff(&largest);
    return z * (std::conj(z(largest)) / std::abs(z(largest)));
}

/// Modes without damping, K symmetric: s² = -λ.
void add_undamped(const FreeForces& forces, const MatrixX& K, double rounding, std::vector<Mode>& modes) {
    const Eigen::SelfAdjointEigenSolver<MatrixX> eigen(K);
    for (Eigen::Index k = 0; k < K.cols(); ++k) {
        const double lambda = eigen.eigenvalues()(k);
        Complex s;
        if (lambda > rounding) { s = {0.0, std::sqrt(lambda)}; }
        if (lambda < -rounding) { s = std::sqrt(-lambda); }
        modes.push_back(mode_of(forces, s, in_phase(eigen.eigenvectors().col(k).cast<Complex>())));
    }
}

/// Modes of z̈ + C ż + K z = 0, one of each pair of conjugate ones; one that stands for each freedom without
/// stiffness.
void add_any(
    const FreeForces& forces, const MatrixX& K, const MatrixX& C, double rounding, Eigen::Index soft,
    std::vector<Mode>& modes) {
    const Eigen::Index n = K.cols();
    MatrixX first_order = MatrixX::Zero(2 * n, 2 * n);
    first_order.topRightCorner(n, n).setIdentity();
    first_order.bottomLeftCorner(n, n) = -K;
    first_order.bottomRightCorner(n, n) = -C;
    const Eigen::EigenSolver<MatrixX> eigen(first_order);
    for (Eigen::Index k = 0; k < 2 * n; ++k) {
        Complex s = eigen.eigenvalues()(k);
        if (s.imag() < 0.0) { continue; }
        if (std::norm(s) <= rounding) {
            // without a damper, a double root, which rounding of K splits
            if (--soft < 0) { continue; }
            s = 0.0;
        }
        modes.push_back(mode_of(forces, s, in_phase(eigen.eigenvectors().col(k).head(n))));
    }
}

Stability by_potential(const VectorX& lambda, double rounding) {
    if (lambda.size() == 0 || lambda.minCoeff() > rounding) { return Stability::stable; }
    return lambda.minCoeff() < -rounding ? Stability::unstable : Stability::cannot_tell;
}

Stability by_rates(const std::vector<Mode>& modes, double rounding) {
    Stability verdict = Stability::stable;
    for (const Mode& mode : modes) {
        if (mode.s.real() > rounding) { return Stability::unstable; }
        if (mode.s.real() > -rounding) { verdict = Stability::cannot_tell; }
    }
    return verdict;
}

}  // namespace

SmallMotions small_motions(FreeForces& forces) {
    SmallMotions out;
    const MatrixX K = forces.stiffness(4);
    const MatrixX C = forces.damping();
    const MatrixX symmetric = 0.5 * (K + K.transpose());
    const double size = std::max(K.norm(), forces.stiffness_size());
    const double rounding = kRounding * size;
    out.is_conservative = (K - symmetric).norm() <= rounding;
    out.is_damped = C.norm() > kRounding * std::sqrt(size);
    if (K.cols() == 0) {
        out.stability = Stability::stable;
        return out;
    }
    const VectorX lambda =
        Eigen::SelfAdjointEigenSolver<MatrixX>(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
    if (out.is_conservative && !out.is_damped) {
        add_undamped(forces, symmetric, rounding, out.modes);
    } else {
        add_any(forces, K, C, rounding, (lambda.array().abs() <= rounding).count(), out.modes);
    }
    if (out.is_conservative) {
        // dampers only take energy: they change no verdict of the potential (Kelvin, Tait, Chetaev)
        out.stability = by_potential(lambda, rounding);
    } else {
        double fastest = 0.0;
        for (const Mode& mode : out.modes) { fastest = std::max(fastest, std::abs(mode.s)); }
        out.stability = by_rates(out.modes, kRateRounding * fastest);
    }
    std::ranges::stable_sort(out.modes, [](const Mode& a, const Mode& b) {
        const bool a_grows = a.s.real() > 0.0;
        const bool b_grows = b.s.real() > 0.0;
        return a_grows != b_grows ? a_grows : std::abs(a.s) < std::abs(b.s);
    });
    return out;
}

}  // namespace jw
