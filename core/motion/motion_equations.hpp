#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <span>
#include <utility>

#include "core/motion/flat_state.hpp"
#include "core/motion/loads.hpp"

/// The equations of motion as a first-order system ẏ = f(t, y).
///
///   M q̈ - Φqᵀ λ = Q,   Φq q̈ = γ
///
/// The state y holds r, p, ṙ, ω' of the centroidal frame of every moving body (flat_state.hpp).
/// @source slides 18-19 and 24; signs in docs/notation.md
namespace jw {

/// Baumgarte's stabilisation: γ - 2 α Φ̇ - β² Φ instead of γ. α = β is critical damping.
struct Baumgarte {
    double alpha = 0.0;  ///< [1/s]
    double beta = 0.0;   ///< [1/s]
};

/// Verdict of one evaluation on the rows in use.
struct RowsVerdict {
    /// Smallest pivot of Φq M⁻¹ Φqᵀ, each divided by its row's own size: the square of the sine of the angle
    /// between a row and those before it. It falls as (distance)² towards a singular position.
    double smallest_pivot = 1.0;
    double violation = 0.0;  ///< largest |Φ| of the kept rows, each divided by the size of its equation
    double left_out = 0.0;   ///< the same for the rows left out, if they are evaluated too; otherwise 0
};

/// Pose, velocity and acceleration of a moving body, at its centre of mass and along the global axes, and a
/// random motion δ that the constraints leave free: all as computed by the equations of motion in use.
struct ProbedBody {
    Vec3 r = Vec3::Zero();   ///< [m]
    Vec4 p = Vec4::Unit(0);  ///< set only where a driver prescribes one of e0 ... e3
    Mat3 A = Mat3::Identity();
    Vec3 r_dot = Vec3::Zero();      ///< [m/s]
    Vec3 omega = Vec3::Zero();      ///< [rad/s]
    Vec3 r_ddot = Vec3::Zero();     ///< [m/s²]
    Vec3 alpha = Vec3::Zero();      ///< ω̇ [rad/s²]
    Vec3 free_way = Vec3::Zero();   ///< δ of the centre of mass [any unit]
    Vec3 free_turn = Vec3::Zero();  ///< δ of the rotation [rad in that unit]
};

/// Residuals of accelerations in the equations of motion, each divided by the size of the terms that are
/// added.
struct AccelerationResidual {
    double forces = 0.0;       ///< |δᵀ (M q̈ - Q)| for a free motion δ
    double constraints = 0.0;  ///< largest |Φq (q̈ + δ) - γ|
    double drift = 0.0;        ///< largest |Φ| [extent] and |Φ̇| [speed of the fastest body]
    int joint = -1;            ///< joint with the largest residual of `constraints`; -1: it is of a driver
    int driver = -1;
};

/// Meaning of the numbers of y: their count and scales, the flat state that they represent, and the numbers
/// that are interpolated between two states.
class StateLayout {
public:
    StateLayout() = default;
    virtual ~StateLayout() = default;
    StateLayout(const StateLayout&) = delete;
    StateLayout& operator=(const StateLayout&) = delete;

    /// Length of y.
    virtual int size() const = 0;
    /// Number of moving bodies.
    virtual int bodies() const { return size() / kNumbersPerBody; }
    /// Scale of every number of y.
    virtual std::vector<NumberScale> scales() const { return flat_scales(size(), kNumbersPerBody); }
    /// Convert y to the numbers of flat_state.hpp and back; the identity unless a coordinate choice has other
    /// numbers.
    virtual void to_flat(const double* y, double* flat) const { std::copy_n(y, size(), flat); }
    virtual void from_flat(const double* flat, double* y) const { std::copy_n(flat, size(), y); }

    /// Number of positions, which are interpolated between states: r and p of every body unless a coordinate
    /// choice has others.
    virtual int interpolated() const { return kPositionsPerBody * bodies(); }
    /// Writes all positions, then their rates, then half their second derivatives.
    virtual void derivatives(const double* y, const double* y_dot, double* out) const {
        flat_derivatives(y, y_dot, bodies(), out);
    }
    /// Computes y, or the flat state, from positions and their rates.
    virtual void state_of(const double* value, const double* rate, double* y) const {
        flat_state_of(value, rate, bodies(), y);
    }
    virtual void flat_of(const double* value, const double* rate, double* flat) const {
        flat_state_of(value, rate, bodies(), flat);
    }
};

/// Choice of the constraint equations kept as independent at a state, and count of the turns of screws.
class RowSelector : public StateLayout {
public:
    /// Chooses independent rows at y. @return true if the choice changed
    virtual bool choose_rows(double t, const double* y) = 0;
    /// Applies the rule for p1 and p2 at y, for any pivots: once a pair has lost its rank, bodies may leave
    /// the branch without any kept row showing it. @return true if the choice changed
    virtual bool follow_rule(double /*t*/, const double* /*y*/) { return false; }
    /// Largest rotation of a body within a step for which the choice of that rule stays valid and turns are
    /// counted correctly [rad].
    virtual double most_turn() const { return std::numeric_limits<double>::infinity(); }
    /// True if turns are counted by the rates at the start of a step: then no body may turn by more than
    /// kCountedTurn in it.
    virtual bool counts_turns() const { return false; }
    /// Smallest pivot of the last factorisation, by `evaluate` or `project`; see RowsVerdict.
    virtual double smallest_pivot() const { return 1.0; }
    /// Restores the rows from before the last choice.
    virtual void take_back_rows() {}
    /// Starts a motion at y, which satisfies the constraints. Poses determine the angle of a screw up to
    /// whole turns only; here the displacement of the screw gives the turns.
    virtual void begin_turns(double /*t*/, const double* /*y*/) {}
    /// Continues the count of turns from the last state to y, the next one of the motion, by the rates.
    virtual void follow_turns(double /*t*/, const double* /*y*/) {}
    /// Number of constraint equations, and of those left out as redundant.
    virtual int rows() const = 0;
    virtual int rows_left_out() const = 0;
};

/// Interface of all forms of the equations of motion: ẏ = f(t, y), projection, and data for the certificate.
class MotionEquations : public RowSelector {
public:
    /// Computes ẏ at y with the current choice of rows.
    virtual RowsVerdict evaluate(double t, const double* y, double* y_dot) = 0;
    /// Projects y onto Φ = 0 and Φ̇ = 0 in the metric of M; p becomes unit.
    /// @return largest |Φ| before, each divided by the size of its equation
    virtual double project(double t, double* y) = 0;
    /// Largest |Φ| and |Φq q̇ - ν| over all rows, including those left out, each divided by the size of its
    /// equation. Depends on y alone, not on the turns counted so far.
    virtual std::pair<double, double> violation(double t, const double* y) = 0;

    /// Computes poses, velocities and accelerations of the moving bodies at y, with ẏ from `evaluate`.
    /// @param bodies one per moving body
    virtual void motion_of_bodies(
        double t, const double* y, const double* y_dot, std::span<ProbedBody> bodies);
    /// Number of velocities, and of random numbers that `free_motion` takes.
    virtual int velocities() const { return 6 * bodies(); }
    /// Sets δ of every body: a motion with Φq δ = 0 at y made from `drawn`, `velocities()` numbers between -1
    /// and 1. Zero where nothing is free. @return false if these equations cannot provide it
    virtual bool free_motion(
        double /*t*/, const double* /*y*/, std::span<const double> /*drawn*/,
        std::span<ProbedBody> /*bodies*/) {
        return false;
    }
};

/// Largest rotation of a body within a step for which the nearest number of whole turns is the right one
/// [rad]: a sample may lie two steps before the last state, and two bodies that turn against each other stay
/// within half a turn in that time.
inline constexpr double kCountedTurn = 0.75;

/// Chooses rows at y and keeps the choice only if it has more rows. @return true if it has
bool raise_rank(MotionEquations& equations, double t, const double* y);

/// Pivot above which a row is surely independent of the rows before it.
inline constexpr double kSurelyIndependent = 1e-2;

/// Equations of motion with the operations that independent coordinates and driven mechanisms need.
class DrivableEquations : public MotionEquations {
public:
    /// Motions that the constraints allow at y: columns of six numbers per body (ṙ, ω'), orthonormal in the
    /// metric of M, or of lengths where masses are far apart. Dense, for small mechanisms.
    virtual MatrixX free_motions(double t, const double* y) = 0;
    /// Refines the accelerations of the last `evaluate` by their residual in Φq q̈ = γ: twice the digits near
    /// singular positions.
    virtual void refine(double* y_dot) = 0;
    /// Computes ẏ of a mechanism whose rows leave no freedom, as `evaluate` and `refine` would, by the
    /// factorisation of the last `project`: for a pose that `project` has hardly moved, and masses that are
    /// not far apart.
    virtual RowsVerdict evaluate_driven(double t, const double* y, double* y_dot) = 0;
    /// True if light bodies carry heavy ones, so that Φq M⁻¹ Φqᵀ would lose digits; known after
    /// `choose_rows`.
    virtual bool masses_are_apart() const = 0;
    /// Makes `project` independent of the masses from the next choice of rows on: for fully driven
    /// mechanisms, where exactly one pose and one motion satisfy the equations. There heavy bodies would hide
    /// how well light ones are constrained.
    virtual void forget_masses() = 0;
    /// True if the rows at y, taken node after node, have no pivot below `kSurelyIndependent`; then a choice
    /// of rows costs no more than an evaluation. The previous choice is lost.
    virtual bool rows_are_sound(double t, const double* y) = 0;
    /// Stores the pivots of the last factorisation as the reference of `share_of_pivots`.
    virtual void keep_pivots() = 0;
    /// Smallest ratio of a pivot to its reference: where small pivots stand beside large ones, the smallest
    /// pivot alone says nothing about the others.
    virtual double share_of_pivots() const = 0;
    /// Replaces the function of a driver of the mechanism by f0 + f1 t.
    virtual void set_driver(int driver, double f0, double f1) = 0;
};

/// Block-sparse equations of motion in (r, ω'): cost linear in the bodies for chains and rows of loops, no
/// allocation per evaluation. `centroidal` must outlive the result.
std::unique_ptr<DrivableEquations> block_equations(
    const Centroidal& centroidal, const Baumgarte& baumgarte = {});

}  // namespace jw
