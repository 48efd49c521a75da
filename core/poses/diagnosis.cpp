#include "core/poses/diagnosis.hpp"

#include <algorithm>
#include <cmath>

#include "core/elementary/elementary.hpp"
#include "core/numerics/svd.hpp"
#include "core/poses/closest_fit.hpp"
#include "core/poses/newton.hpp"
#include "core/poses/rank.hpp"

namespace jw {

namespace {

constexpr double kFlatGradient = 1e-5;  // relative to |Φq||Φ|: the residual cannot be reduced further
// directions below this share of the largest singular value count as lost if the residual is as large: a loop
// that does not close because of its typed digits slides along them without end
constexpr double kLargestSlack = 1e-3;
constexpr double kLostSingularValue = 1e-6;  // relative to the largest, at the closest fit
// if the gradient vanishes at a maximum or a saddle point (parallel arms of a universal joint, a rod without
// length), a perturbation of this size [scene's unit, rad] lets the descent continue; from a closest fit, the
// descent comes back
constexpr double kPush = 1e-2;
constexpr double kClearlyLower = 0.9;  // of ‖Φ‖: far beyond the digits in which two fits differ

struct Fit {
    State state;
    VectorX phi;  // scaled
    VectorX raw;
    double flatness = 0.0;
    double smallest_singular_value = 0.0;
};

/// Evaluates the quality of the fit at `state`, and whether it can be improved.
Fit fit_at(const System& system, State state, double t) {
    for (Vec4& p : state.p) { p.normalize(); }
    ScaledEquations equations(system, t);
    equations.look(state);
    Fit fit{std::move(state), equations.phi(), equations.raw(), 1.0, 0.0};
    if (!fit.phi.allFinite()) { return fit; }
    const Svd svd = svd_of(equations.jacobian());
    if (!svd.sound) {
        fit.smallest_singular_value = 1.0;  // not available
        return fit;
    }
    const VectorX& sigma = svd.sigma;
    const double slack = std::min(kErrorFactor * fit.phi.cwiseAbs().maxCoeff(), kLargestSlack);
    const VectorX gradient =
        (sigma.array() > slack * sigma(0)).select(sigma.cwiseProduct(svd.U.transpose() * fit.phi), 0.0);
    fit.flatness = gradient.norm() / std::max(sigma(0) * fit.phi.norm(), 1e-300);
    // smallest value of those that should not vanish: without redundancy, the last ratio above rounding
    for (const double s : sigma) {
        if (s > 1e-12 * sigma(0)) { fit.smallest_singular_value = s / sigma(0); }
    }
    return fit;
}

Fit closest_fit_from(const System& system, const State& start, const State& reached, double t) {
    const Fit fit = fit_at(system, reached, t);
    return fit.flatness < kFlatGradient ? fit : fit_at(system, closest_fit(system, start, t), t);
}

/// True if the fit improves after a perturbation: then it was not a closest fit.
bool gives_way(const System& system, const Fit& fit, double t) {
    // at a maximum, the residual has the size of the parts; a smaller residual comes from typed digits
    if (fit.phi.cwiseAbs().maxCoeff() < kLargestSlack) { return false; }
    ScaledEquations equations(system, t);
    VectorX push(Layout<OmegaLocal>(system).columns());
    // no two entries are equal, so that the perturbation breaks every symmetry of the scene
    for (Eigen::Index k = 0; k < push.size(); ++k) {
        push(k) = kPush * elementary::cos(1.0 + 2.4 * static_cast<double>(k));
    }
    equations.look(closest_fit(system, equations.moved(fit.state, push), t));
    return equations.phi().norm() < kClearlyLower * fit.phi.norm();
}

/// First row whose value or derivatives do not exist at `state`, if there is one.
std::optional<int> row_without_value(const System& system, const State& state, double t) {
    ScaledEquations equations(system, t);
    equations.look(state);
    const MatrixX jacobian = equations.jacobian();
    for (Eigen::Index row = 0; row < jacobian.rows(); ++row) {
        if (!std::isfinite(equations.raw()(row)) || !jacobian.row(row).allFinite()) {
            return static_cast<int>(row);
        }
    }
    return std::nullopt;
}

}  // namespace

PositionFailure diagnose(
    const System& system, const State& start, const State& reached, double t, int iterations) {
    if (const auto row = row_without_value(system, start, t)) {
        return {FailureCause::no_value, *row, 0.0, HUGE_VAL, 0.0, iterations, std::nullopt, t};
    }
    const Fit fit = closest_fit_from(system, start, reached, t);
    PositionFailure failure;
    Eigen::Index row = 0;
    failure.residual = fit.phi.cwiseAbs().maxCoeff(&row);
    failure.row = static_cast<int>(row);
    failure.value = fit.raw(row);
    failure.smallest_singular_value = fit.smallest_singular_value;
    failure.iterations = iterations;
    failure.t = t;
    if (failure.residual > kFloorTolerance && fit.flatness < kFlatGradient) {
        failure.cause = gives_way(system, fit, t) ? FailureCause::singular : FailureCause::cannot_close;
        if (failure.cause == FailureCause::cannot_close) {
            failure.contradiction = find_contradiction(system, start, fit.state, t);
        }
    } else if (fit.smallest_singular_value < kLostSingularValue) {
        failure.cause = FailureCause::singular;
    }
    return failure;
}

}  // namespace jw
