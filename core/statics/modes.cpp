#include "core/statics/modes.hpp"

#include <algorithm>
#include <numeric>
#include <span>

#include "core/numerics/svd.hpp"

namespace jw {

namespace {

using Complex = std::complex<double>;

// K comes from differences: 1e-12 of the loads, and a factor of a hundred for sums
constexpr double kRounding = 1e-10;
// of the largest entry: rounding of eigenvalues, for any number of freedoms that is practical
constexpr double kEigenRounding = 1e-13;
// share of |s| below which a real part is rounding: K has ten digits, and a double root halves them only
// where motions begin to grow
constexpr double kRateRounding = 1e-8;

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

/// K along the freedoms, with its eigenvalues if it is symmetric, else with its singular values: both are
/// zero along the freedoms without stiffness. `errors` bounds the error of each.
struct Stiffness {
    MatrixX K;
    bool is_symmetric = true;
    VectorX lambda;
    MatrixX vectors;
    VectorX errors;

    bool is_soft(Eigen::Index k) const { return std::abs(lambda(k)) <= errors(k); }
    Eigen::Index soft() const { return (lambda.cwiseAbs().array() <= errors.array()).count(); }
};

bool is_symmetric(const FreeForces& forces, const MatrixX& K) {
    const double largest = K.cwiseAbs().maxCoeff();
    const VectorX errors = stiffness_errors(forces, forces.free(), largest);
    for (Eigen::Index a = 0; a < K.rows(); ++a) {
        for (Eigen::Index b = 0; b < a; ++b) {
            const double size = std::sqrt(
                (errors(a) + kRounding * std::abs(K(a, a))) * (errors(b) + kRounding * std::abs(K(b, b))));
            if (std::abs(K(a, b) - K(b, a)) > 2.0 * size + kEigenRounding * largest) { return false; }
        }
    }
    return true;
}

Stiffness stiffness_of(FreeForces& forces) {
    const auto symmetric = [](const MatrixX& K) { return MatrixX(0.5 * (K + K.transpose())); };
    const Eigen::SelfAdjointEigenSolver<MatrixX> first(symmetric(forces.stiffness()));
    forces.turn(first.eigenvectors());
    Stiffness out;
    out.K = forces.stiffness();
    out.is_symmetric = is_symmetric(forces, out.K);
    if (out.is_symmetric) {
        const Eigen::SelfAdjointEigenSolver<MatrixX> eigen(symmetric(out.K));
        out.lambda = eigen.eigenvalues();
        out.vectors = eigen.eigenvectors();
    } else {
        const Svd svd = svd_of(out.K);
        out.lambda = svd.sigma;
        out.vectors = svd.V;
    }
    out.errors = stiffness_errors(forces, forces.free() * out.vectors, out.lambda.cwiseAbs().maxCoeff());
    return out;
}

/// Modes without damping, K symmetric: s² = -λ.
void add_undamped(const FreeForces& forces, const Stiffness& stiffness, std::vector<Mode>& modes) {
    for (Eigen::Index k = 0; k < stiffness.lambda.size(); ++k) {
        const double lambda = stiffness.lambda(k);
        Complex s;
        if (!stiffness.is_soft(k)) {
            s = lambda > 0.0 ? Complex(0.0, std::sqrt(lambda)) : std::sqrt(-lambda);
        }
        modes.push_back(mode_of(forces, s, in_phase(stiffness.vectors.col(k).cast<Complex>())));
    }
}

/// Number of freedoms without stiffness and without damping.
Eigen::Index undamped_among_soft(const Stiffness& stiffness, const MatrixX& C) {
    MatrixX soft(C.rows(), stiffness.soft());
    for (Eigen::Index k = 0, next = 0; k < C.rows(); ++k) {
        if (stiffness.is_soft(k)) { soft.col(next++) = stiffness.vectors.col(k); }
    }
    if (soft.cols() == 0) { return 0; }
    const MatrixX damping = soft.transpose() * C * soft;
    const VectorX sizes =
        Eigen::SelfAdjointEigenSolver<MatrixX>(MatrixX(damping.transpose() * damping), Eigen::EigenvaluesOnly)
            .eigenvalues();
    const double zero = kEigenRounding * C.squaredNorm();
    return (sizes.array() <= zero).count();
}

/// Adds the modes of z̈ + C ż + K z = 0, one of each conjugate pair.
/// @return the size of the matrix whose eigenvalues they are
double add_any(
    const FreeForces& forces, const Stiffness& stiffness, const MatrixX& C, std::vector<Mode>& modes) {
    const Eigen::Index n = C.cols();
    // unknowns (Ω z, ż) with Ω near the frequencies: entries of K of very different sizes would cost digits
    const VectorX omega =
        stiffness.K.diagonal().cwiseAbs().cwiseMax(stiffness.errors.cwiseMax(1e-300)).cwiseSqrt();
    MatrixX first_order = MatrixX::Zero(2 * n, 2 * n);
    first_order.topRightCorner(n, n) = omega.asDiagonal();
    first_order.bottomLeftCorner(n, n) = -stiffness.K * omega.cwiseInverse().asDiagonal();
    first_order.bottomRightCorner(n, n) = -C;
    const Eigen::EigenSolver<MatrixX> eigen(first_order);
    std::vector<Eigen::Index> order(static_cast<std::size_t>(2 * n));
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](Eigen::Index k) { return std::abs(eigen.eigenvalues()(k)); });
    // a freedom without stiffness has s = 0, twice where it is not damped, which rounding of K splits
    for (Eigen::Index k = 0; k < n; ++k) {
        if (!stiffness.is_soft(k)) { continue; }
        modes.push_back(mode_of(forces, 0.0, in_phase(stiffness.vectors.col(k).cast<Complex>())));
    }
    const Eigen::Index zeros = stiffness.soft() + undamped_among_soft(stiffness, C);
    for (const Eigen::Index k : std::span(order).subspan(static_cast<std::size_t>(zeros))) {
        const Complex s = eigen.eigenvalues()(k);
        if (s.imag() < 0.0) { continue; }
        const Eigen::VectorXcd z = eigen.eigenvectors().col(k).head(n).cwiseQuotient(omega.cast<Complex>());
        modes.push_back(mode_of(forces, s, in_phase(z)));
    }
    return first_order.norm();
}

Stability by_potential(const Stiffness& stiffness) {
    Stability verdict = Stability::stable;
    for (Eigen::Index k = 0; k < stiffness.lambda.size(); ++k) {
        if (stiffness.is_soft(k)) {
            verdict = Stability::cannot_tell;
        } else if (stiffness.lambda(k) < 0.0) {
            return Stability::unstable;
        }
    }
    return verdict;
}

Stability by_rates(const std::vector<Mode>& modes, double size) {
    Stability verdict = Stability::stable;
    for (const Mode& mode : modes) {
        const double rounding = kRateRounding * std::abs(mode.s) + kEigenRounding * size;
        if (mode.s.real() > rounding) { return Stability::unstable; }
        if (mode.s.real() > -rounding) { verdict = Stability::cannot_tell; }
    }
    return verdict;
}

}  // namespace

VectorX stiffness_errors(const FreeForces& forces, const MatrixX& shapes, double largest) {
    VectorX errors(shapes.cols());
    for (Eigen::Index k = 0; k < shapes.cols(); ++k) {
        errors(k) = kRounding * forces.stiffness_of_sizes(shapes.col(k)) + kEigenRounding * largest;
    }
    return errors;
}

SmallMotions small_motions(FreeForces& forces) {
    SmallMotions out;
    if (forces.freedoms() == 0) {
        out.stability = Stability::stable;
        return out;
    }
    const Stiffness stiffness = stiffness_of(forces);
    const MatrixX C = forces.damping();
    if (!forces.has_smooth_laws()) {
        out.at_kink = true;
        return out;
    }
    out.is_conservative = stiffness.is_symmetric;
    // without dampers, forces at both velocities are the same numbers
    out.is_damped = C.cwiseAbs().maxCoeff() > 0.0;
    double size = 0.0;
    if (out.is_conservative && !out.is_damped) {
        add_undamped(forces, stiffness, out.modes);
    } else {
        size = add_any(forces, stiffness, C, out.modes);
    }
    // dampers only take energy: they change no verdict of the potential (Kelvin, Tait, Chetaev)
    const bool may_be_fed = !out.is_conservative || (out.is_damped && forces.has_laws_of_rates());
    out.stability = may_be_fed ? by_rates(out.modes, size) : by_potential(stiffness);
    std::ranges::stable_sort(out.modes, [](const Mode& a, const Mode& b) {
        // that of an oscillation may be rounding
        constexpr double rounding = 1e-6;
        const bool a_grows = a.s.real() > rounding * std::abs(a.s);
        const bool b_grows = b.s.real() > rounding * std::abs(b.s);
        return a_grows != b_grows ? a_grows : std::abs(a.s) < std::abs(b.s);
    });
    return out;
}

}  // namespace jw
