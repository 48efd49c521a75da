#include "core/poses/closest_fit.hpp"

#include <algorithm>
#include <cmath>

#include "core/eigen/decompositions.hpp"
#include "core/poses/newton.hpp"

namespace jw {

namespace {

constexpr int kDampedSteps = 200;  // linear convergence at worst; enough for three digits of the fit
constexpr int kNewtonSteps = 40;   // quadratic convergence at the end; before, half a radian at a time
constexpr int kStepsAcross = 10;   // descent across a valley: quadratic from the start
// central differences of the gradient: truncation h² = 1e-10 and rounding 1e-16 / h both far below the
// curvatures that matter, which are of the size of the gap
constexpr double kDifference = 1e-5;
// each Newton step costs two gradients per column and an eigenvalue problem
constexpr Eigen::Index kMostColumns = 200;
constexpr double kShortest = 1e-6;  // share of a step; if even this gives no decrease, no step does
constexpr int kRounds = 3;       // rounds of damped and Newton steps: if one stops early, the other continues
constexpr double kFlat = 1e-12;  // relative to ‖φ‖: rounding of the gradient
constexpr double kSettled = 1e-6;  // relative to ‖φ‖: far below the gradient that counts as a closest fit
// relative to the largest: along a smaller curvature, nothing is gained. Below the curvature of a valley,
// almost nothing is gained, since the gap of a loop hardly depends on the position of the loop, and every
// step along the valley climbs its walls a little
constexpr double kFlatCurvature = 1e-9;
constexpr double kValley = 1e-4;

State descended(ScaledEquations& equations, State state) {
    equations.look(state);
    VectorX phi = equations.phi();
    MatrixX J = equations.jacobian();
    double damping = 1e-3;
    for (int k = 0; k < kDampedSteps && damping < 1e12; ++k) {
        MatrixX normal = J.transpose() * J;
        normal.diagonal().array() += damping * std::max(1.0, normal.diagonal().maxCoeff());
        State trial = equations.moved(state, normal.ldlt().solve(-J.transpose() * phi));
        equations.look(trial);
        const VectorX trial_phi = equations.phi();
        if (!trial_phi.allFinite() || trial_phi.norm() >= phi.norm()) {
            damping *= 4.0;
            continue;
        }
        state = std::move(trial);
        phi = trial_phi;
        J = equations.jacobian();
        damping = std::max(0.3 * damping, 1e-12);
    }
    return state;
}

/// Second derivatives of ½ ‖φ‖², including those of Φ.
MatrixX curvature_at(ScaledEquations& equations, const State& state) {
    const Eigen::Index n = equations.columns();
    MatrixX curvature(n, n);
    for (Eigen::Index k = 0; k < n; ++k) {
        const VectorX delta = kDifference * VectorX::Unit(n, k);
        equations.look(equations.moved(state, delta));
        curvature.col(k) = equations.gradient();
        equations.look(equations.moved(state, -delta));
        curvature.col(k) -= equations.gradient();
    }
    return (curvature + curvature.transpose()) / (4.0 * kDifference);
}

/// Newton's method on the gradient: with the curvature of Φ, it continues where damped steps become very
/// short. Directions of negative curvature are followed downhill.
/// @param flat curvature relative to the largest below which no step is taken
State polished(ScaledEquations& equations, State state, int steps, double flat) {
    equations.look(state);
    for (int k = 0; k < steps; ++k) {
        const VectorX gradient = equations.gradient();
        const double norm = equations.phi().norm();
        if (!(gradient.norm() > kFlat * norm)) { break; }
        const Eigen::SelfAdjointEigenSolver<MatrixX> eigen(curvature_at(equations, state));
        const VectorX size = eigen.eigenvalues().cwiseAbs();
        const double least = flat * size.maxCoeff();
        const VectorX along = eigen.eigenvectors().transpose() * gradient;
        const VectorX step =
            -eigen.eigenvectors() * (size.array() > least).select(along.cwiseQuotient(size), 0.0).matrix();
        bool lower = false;
        for (double share = 1.0; share > kShortest && !lower; share *= 0.25) {
            State trial = equations.moved(state, share * step);
            equations.look(trial);
            lower = equations.phi().norm() < norm;
            if (lower) { state = std::move(trial); }
        }
        if (!lower) { break; }
    }
    return state;
}

}  // namespace

State ScaledEquations::moved(State state, const VectorX& delta) const {
    VectorX step = delta.cwiseProduct(scaling_.column);
    const double turn = assembler_.layout().largest_turn(step);
    if (turn > kLargestTurn) { step *= kLargestTurn / turn; }
    assembler_.layout().advance(state, step);
    return state;
}

State closest_fit(const System& system, State state, double t, const VectorX& weights) {
    ScaledEquations equations(system, t, weights);
    for (int round = 0; round < kRounds; ++round) {
        state = descended(equations, std::move(state));
        if (equations.columns() > kMostColumns) { break; }
        state = polished(equations, std::move(state), kNewtonSteps, kFlatCurvature);
        state = polished(equations, std::move(state), kStepsAcross, kValley);
        equations.look(state);
        if (equations.gradient().norm() <= kSettled * equations.phi().norm()) { break; }
    }
    return state;
}

}  // namespace jw
