#pragma once

#include <array>
#include <vector>

#include "core/kinematics/proof/parts.hpp"
#include "core/kinematics/proof/step_proof.hpp"

/// A step of a motion in the form that its proof needs: the equations at both ends, and the path between
/// them.
namespace jw {

/// Cubic path of one block of coordinates over a step, as its Bézier control points.
struct Path {
    std::array<Vec4, 4> control;
    TaylorSeries series{};
    double size = 0.0;  ///< largest control point: bound of |x|

    /// Point at a share of the step: 0 at its start, 1 at its end; above 1, on the same polynomial.
    Vec4 at(double share) const;
};

/// Values and rates of the equations at one end of a step.
struct StepEnd {
    double t = 0.0;
    State state;
    std::vector<Vec3> r_dot;
    std::vector<Vec3> omega_local;
    std::vector<Vec4> p_dot;
    std::vector<double> theta_dot;
    std::vector<BodyKinematics<ModifiedEulerParameters>> bodies;
    std::vector<Theta> thetas;  ///< per equation: its θ, the target of its driver, or the difference of both
    std::vector<double> phi;    ///< per equation: |Φ| / unit
    std::vector<double> rate;   ///< per equation: |Φ̇| / unit
};

class ProvedStep {
public:
    explicit ProvedStep(const System& system);

    /// Sets both ends; values at the start that the last step has computed are kept.
    void set(const PathEnd& from, const PathEnd& to);

    double length() const { return length_; }  ///< extent of the mechanism [m]
    const CoordinateTable& table() const { return table_; }
    const std::vector<ProvedEquation>& equations() const { return equations_; }
    const std::array<int, kBlocks>& blocks(int equation) const { return blocks_[at(equation)]; }
    const StepEnd& from() const { return ends_[0]; }
    const StepEnd& to() const { return ends_[1]; }
    double h() const { return ends_[1].t - ends_[0].t; }
    const Path& path(int coordinate) const { return paths_[at(coordinate)]; }
    /// Coordinates on the path at a share of the step, without normalisation: p need not have length 1.
    State state_at(double share) const;
    /// Pose to which the path leads if it continues for a time after the end of the step [s]: an estimate, in
    /// memory that the next call overwrites. It has neither velocities nor values of equations. The step must
    /// not have length 0.
    const StepEnd& ahead(double time);
    /// Bounds of the target of a driver over the step.
    const TaylorSeries& target(int equation) const { return targets_[at(equation)]; }

    /// Bound of |x - x̂| over the step, once it is proved.
    double error(int coordinate) const { return error_[at(coordinate)]; }
    void set_error(int coordinate, double error) { error_[at(coordinate)] = error; }

    /// Jacobian of an equation at an end, in memory that the next call for the equation overwrites.
    const EquationJacobian& jacobian_at(const StepEnd& end, int equation);

private:
    void set_pose(StepEnd& end, const PathEnd& pose) const;
    void set_end(StepEnd& end, const PathEnd& pose) const;
    Theta theta_of(const ProvedEquation& equation, const StepEnd& end) const;
    Path path_of_coordinates(const Coordinates& c) const;

    double length_;
    CoordinateTable table_;
    std::vector<ProvedEquation> equations_;
    std::vector<std::array<int, kBlocks>> blocks_;
    std::vector<EquationJacobian> jacobians_;
    std::array<StepEnd, 2> ends_;
    StepEnd ahead_;
    Motion still_;
    std::vector<Path> paths_;
    std::vector<TaylorSeries> targets_;
    std::vector<double> error_;
};

}  // namespace jw
