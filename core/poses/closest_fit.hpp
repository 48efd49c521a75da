#pragma once

#include "core/equations/assembler.hpp"
#include "core/poses/least_squares.hpp"

/// Pose with the smallest residual, for equations that no pose satisfies.
namespace jw {

/// Φ and Φq in the scene's units, as functions of the state, with optional weights of the rows.
class ScaledEquations {
public:
    ScaledEquations(const System& system, double t)
        : assembler_(system), scaling_(scaling_of<OmegaLocal>(system)), t_(t) {}
    /// @param weights one per row; their squares weight the squares of residuals: if not all equations can
    /// be satisfied, one of weight 100 is off by 10⁻⁴ of the others
    ScaledEquations(const System& system, double t, const VectorX& weights) : ScaledEquations(system, t) {
        if (weights.size() > 0) { scaling_.row = scaling_.row.cwiseQuotient(weights).eval(); }
    }

    void look(const State& state) { assembler_.assemble_phi_and_jacobian(state, t_); }
    const VectorX& raw() const { return assembler_.phi(); }
    VectorX phi() const { return raw().cwiseQuotient(scaling_.row); }
    MatrixX jacobian() const {
        return scaling_.row.cwiseInverse().asDiagonal() * assembler_.jacobian() *
               scaling_.column.asDiagonal();
    }
    /// Half the derivative of ‖φ‖² in scaled columns.
    VectorX gradient() const {
        return (assembler_.jacobian().transpose() * phi().cwiseQuotient(scaling_.row))
            .cwiseProduct(scaling_.column);
    }
    Eigen::Index columns() const { return scaling_.column.size(); }
    /// State moved by `delta` in scaled columns, with no body turned by more than a Newton step allows.
    State moved(State state, const VectorX& delta) const;

private:
    Assembler<OmegaLocal> assembler_;
    Scaling scaling_;
    double t_;
};

/// Minimises ‖Φ‖, scaled and weighted, from `state`: damped steps (Levenberg-Marquardt); then Newton's method
/// on the gradient, since damped steps become very short where the equations contradict each other.
/// @param weights if empty, all rows have weight 1
State closest_fit(const System& system, State state, double t, const VectorX& weights = {});

}  // namespace jw
