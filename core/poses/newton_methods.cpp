#include "core/poses/newton_methods.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/elementary/elementary.hpp"
#include "core/poses/damped_step.hpp"

namespace jw {

namespace {

// number of trials: steps with some λ, accepted or not
constexpr int kMostTrials = 200;
constexpr double kFirstDamping = 1e-3;
constexpr double kLargestDamping = 1e12;    // a step of 1e-12 of the gradient no longer reduces anything
constexpr double kSmallestDamping = 1e-15;  // rounding of JᵀJ
constexpr double kDampingFactor = 10.0;
// in units of the tolerance: a residual this far above rounding still has two digits for the logarithm
constexpr double kRoundings = 10.0;

bool is_finite(const State& state) {
    return std::ranges::all_of(state.r, [](const Vec3& r) { return r.allFinite(); }) &&
           std::ranges::all_of(state.p, [](const Vec4& p) { return p.allFinite(); }) &&
           std::ranges::all_of(state.theta, [](double theta) { return std::isfinite(theta); });
}

bool is_finite(const NewtonIterate& i) {
    return is_finite(i.state) && std::isfinite(i.phi_norm) && std::isfinite(i.residual) &&
           std::isfinite(i.delta_norm) && std::isfinite(i.turn);
}

std::optional<double> measured_order(const std::vector<NewtonIterate>& iterates, double rounding) {
    for (std::size_t last = iterates.size(); last-- > 2;) {
        const double e1 = iterates[last - 2].residual;
        const double e2 = iterates[last - 1].residual;
        const double e3 = iterates[last].residual;
        if (e3 > rounding && e3 < e2 && e2 < e1) {
            return elementary::log(e3 / e2) / elementary::log(e2 / e1);
        }
    }
    return std::nullopt;
}

StepRule rule_of(NewtonMethod method) {
    switch (method) {
        case NewtonMethod::plain: return StepRule::whole;
        case NewtonMethod::damped: return StepRule::line_search;
        case NewtonMethod::stepwise_limited:
        case NewtonMethod::levenberg_marquardt: break;
    }
    return StepRule::limited;
}

/// @return true if it has converged
template <class C>
bool run_stepper(NewtonStepper<C>& stepper, std::vector<NewtonIterate>& iterates) {
    while (!stepper.outcome()) {
        NewtonIterate iterate{stepper.state()};
        const NewtonStep step = stepper.step();
        iterate.phi_norm = step.phi_norm;
        iterate.residual = step.residual;
        iterate.delta_norm = step.delta_norm;
        iterate.turn = step.turn;
        iterate.fraction = step.fraction;
        if (!is_finite(iterate)) { return false; }
        iterates.push_back(std::move(iterate));
    }
    return stepper.outcome()->converged;
}

template <class C>
class LevenbergMarquardt {
public:
    LevenbergMarquardt(const System& system, double t, bool normalisation_rows)
        : assembler_(system, normalisation_rows),
          scaling_(scaling_of<C>(system, normalisation_rows)),
          t_(t) {}

    /// @return true if it has converged
    bool run(State state, double tolerance, std::vector<NewtonIterate>& iterates) {
        NewtonIterate now = looked_at(std::move(state));
        double damping = kFirstDamping;
        const auto ended = [&] {
            return now.residual <= tolerance || damping > kLargestDamping || scaling_.column.size() == 0;
        };
        for (int trial = 0; trial < kMostTrials && is_finite(now) && !ended(); ++trial) {
            const NewtonIterate next = looked_at(stepped(now, damping));
            if (is_finite(next) && norm_ < norm_before_) {
                iterates.push_back(std::exchange(now, next));
                damping = std::max(damping / kDampingFactor, kSmallestDamping);
            } else {
                damping *= kDampingFactor;
                look(now.state);
            }
        }
        if (!is_finite(now)) { return false; }
        now.delta_norm = now.turn = now.damping = 0.0;
        iterates.push_back(now);
        // if no step reduces ‖Φ‖, the numbers of the lesson do not close better
        return now.residual <= (damping > kLargestDamping ? kFloorTolerance : tolerance);
    }

private:
    void look(const State& state) {
        assembler_.assemble_phi_and_jacobian(state, t_);
        phi_ = assembler_.phi().cwiseQuotient(scaling_.row);
        norm_ = phi_.norm();
    }

    NewtonIterate looked_at(State state) {
        look(state);
        NewtonIterate iterate{std::move(state)};
        iterate.phi_norm = assembler_.phi().norm();
        iterate.residual = phi_.size() == 0 ? 0.0 : phi_.cwiseAbs().maxCoeff();
        return iterate;
    }

    /// State after a step with λ = `damping` from `now`, where Φ and Φq are assembled; the step is recorded
    /// in `now`.
    State stepped(NewtonIterate& now, double damping) {
        const VectorX delta = damped_step(assembler_.sparse_jacobian(), scaling_, phi_, damping);
        norm_before_ = norm_;
        now.delta_norm = delta.norm();
        now.turn = assembler_.layout().largest_turn(delta);
        now.damping = damping;
        State state = now.state;
        assembler_.layout().advance(state, delta);
        return state;
    }

    Assembler<C> assembler_;
    Scaling scaling_;
    double t_;
    VectorX phi_;
    double norm_ = 0.0;
    double norm_before_ = 0.0;
};

}  // namespace

template <class C>
NewtonTrace trace_newton(
    const System& system, const State& start, double t, NewtonMethod method, bool normalisation_rows) {
    NewtonTrace trace;
    trace.method = method;
    if (!is_finite(start)) { return trace; }
    const double tolerance = residual_tolerance(system, start);
    if (method == NewtonMethod::levenberg_marquardt) {
        LevenbergMarquardt<C> fit(system, t, normalisation_rows);
        trace.converged = fit.run(start, tolerance, trace.iterates);
    } else {
        NewtonStepper<C> stepper(system, {rule_of(method), normalisation_rows});
        stepper.start(start, t);
        trace.converged = run_stepper(stepper, trace.iterates);
    }
    if (!trace.converged) { return trace; }
    trace.wrong_branch = find_wrong_branch(system, trace.iterates.back().state, intended_sides(system));
    trace.order = measured_order(trace.iterates, kRoundings * tolerance);
    return trace;
}

template NewtonTrace trace_newton<TrueEulerParameters>(
    const System&, const State&, double, NewtonMethod, bool);
template NewtonTrace trace_newton<ModifiedEulerParameters>(
    const System&, const State&, double, NewtonMethod, bool);
template NewtonTrace trace_newton<OmegaLocal>(const System&, const State&, double, NewtonMethod, bool);
template NewtonTrace trace_newton<OmegaGlobal>(const System&, const State&, double, NewtonMethod, bool);

}  // namespace jw
