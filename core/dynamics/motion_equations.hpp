#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <span>
#include <utility>

#include "core/dynamics/flat_state.hpp"
#include "core/dynamics/loads.hpp"

/// The equations of motion as a first-order system ẏ = f(t, y).
///
///   M q̈ - Φqᵀ λ = Q,   Φq q̈ = γ
///
/// y holds for every moving body its r, p, ṙ, ω' of the centroidal frame (flat_state.hpp).
/// @source slides 18-19 and 24; signs in docs/notation.md
namespace jw {

/// Baumgarte's stabilisation: γ - 2 α Φ̇ - β² Φ instead of γ. α = β is critical damping.
struct Baumgarte {
    double alpha = 0.0;  ///< [1/s]
    double beta = 0.0;   ///< [1/s]
};

/// What one evaluation says about the rows in use.
struct RowsVerdict {
    /// Smallest pivot of Φq M⁻¹ Φqᵀ, each by its row's own size: the square of the sine between a row and
    /// those before it. It falls as (distance)² to a singular position.
    double smallest_pivot = 1.0;
    double violation = 0.0;  ///< largest |Φ| of the rows kept, each by the size of its equation
    double left_out = 0.0;   ///< the same of rows left out, where they are evaluated besides; else 0
};

/// A moving body's pose, velocity and acceleration, of its centre of mass and along the global axes, and a
/// motion δ that the constraints leave free, drawn at random. All of it as the equations of motion in use
/// have it.
struct ProbedBody {
    Vec3 r = Vec3::Zero();   ///< [m]
    Vec4 p = Vec4::Unit(0);  ///< set where somebody asks for e0 ... e3
    Mat3 A = Mat3::Identity();
    Vec3 r_dot = Vec3::Zero();      ///< [m/s]
    Vec3 omega = Vec3::Zero();      ///< [rad/s]
    Vec3 r_ddot = Vec3::Zero();     ///< [m/s²]
    Vec3 alpha = Vec3::Zero();      ///< ω̇ [rad/s²]
    Vec3 free_way = Vec3::Zero();   ///< δ: of the centre of mass [any unit]
    Vec3 free_turn = Vec3::Zero();  ///< likewise
};

/// How far accelerations are from the equations of motion, by the size of what is added up in each.
struct AccelerationResidual {
    double forces = 0.0;       ///< |δᵀ (M q̈ - Q)| for a free motion δ
    double constraints = 0.0;  ///< largest |Φq (q̈ + δ) - γ|
    double drift = 0.0;  ///< largest |Φ| and |Φ̇| [by extent, and by the time in which a body moves by it]
    int joint = -1;      ///< with the largest residual of `constraints`, -1: a driver's
    int driver = -1;
};

class MotionEquations {
public:
    MotionEquations() = default;
    virtual ~MotionEquations() = default;
    MotionEquations(const MotionEquations&) = delete;
    MotionEquations& operator=(const MotionEquations&) = delete;

    virtual int size() const = 0;
    /// That move.
    virtual int bodies() const { return size() / kNumbersPerBody; }
    /// Of every number of y.
    virtual std::vector<NumberScale> scales() const { return flat_scales(size(), kNumbersPerBody); }
    /// y in the numbers of flat_state.hpp, and back; the same unless a coordinate choice has others.
    virtual void to_flat(const double* y, double* flat) const { std::copy_n(y, size(), flat); }
    virtual void from_flat(const double* flat, double* y) const { std::copy_n(flat, size(), y); }

    /// What can be interpolated between states: numbers of positions, r and p of every body unless a
    /// coordinate choice has others.
    virtual int interpolated() const { return kPositionsPerBody * bodies(); }
    /// All of them, then their rates, then half their second derivatives.
    virtual void derivatives(const double* y, const double* y_dot, double* out) const {
        flat_derivatives(y, y_dot, bodies(), out);
    }
    /// The y that has these numbers and rates, and the flat state.
    virtual void state_of(const double* value, const double* rate, double* y) const {
        flat_state_of(value, rate, bodies(), y);
    }
    virtual void flat_of(const double* value, const double* rate, double* flat) const {
        flat_state_of(value, rate, bodies(), flat);
    }

    /// ẏ at y, with the rows kept now.
    virtual RowsVerdict evaluate(double t, const double* y, double* y_dot) = 0;
    /// Moves y to the nearest state (in the metric of M) that satisfies the constraints and their rates, p
    /// unit.
    /// @return how far the worst position equation was off before, by the size of its equation
    virtual double project(double t, double* y) = 0;
    /// Chooses anew which rows are kept, of those that repeat each other, at y. @return true if they changed
    virtual bool choose_rows(double t, const double* y) = 0;
    /// Chooses others where the rule for p1 and p2 asks for them at y, whatever the pivots say: once a pair
    /// has lost its rank, bodies may leave the branch without any kept row saying so. @return true if it did
    virtual bool follow_rule(double /*t*/, const double* /*y*/) { return false; }
    /// Turn of a body within a step up to which a choice of that rule stays good, and turns are counted
    /// [rad].
    virtual double most_turn() const { return std::numeric_limits<double>::infinity(); }
    /// Of the last factorisation, by `evaluate` or `project`; see RowsVerdict.
    virtual double smallest_pivot() const { return 1.0; }
    /// The rows before the last choice.
    virtual void take_back_rows() {}
    /// A motion begins at y, which satisfies the constraints. Bodies tell the angle of a screw up to whole
    /// turns only: here they are those that its displacement says.
    virtual void begin_turns(double /*t*/, const double* /*y*/) {}
    /// The motion has come to y: turns are counted on from where they were told last, by the rates.
    virtual void follow_turns(double /*t*/, const double* /*y*/) {}
    /// Largest |Φ| and |Φq q̇ - ν| over all rows, those left out included, by the size of their equations. Of
    /// y alone: whatever turns were counted.
    virtual std::pair<double, double> violation(double t, const double* y) = 0;
    /// Kinetic and potential energy (gravity and springs) [J].
    virtual double kinetic_energy(const double* y) const = 0;
    virtual double potential_energy(const double* y) const = 0;

    virtual int rows() const = 0;
    virtual int rows_left_out() const = 0;

    /// Poses, velocities and accelerations of the moving bodies at y, where it goes on with ẏ as `evaluate`
    /// gave it. @param bodies one per moving body
    virtual void motion_of_bodies(
        double t, const double* y, const double* y_dot, std::span<ProbedBody> bodies);
    /// Random numbers that `free_motion` is made of.
    virtual int velocities() const { return 6 * bodies(); }
    /// Sets δ of every body, a motion with Φq δ = 0 at y made of `drawn`, `velocities()` numbers between -1
    /// and 1. Zero where nothing is free. @return false if these equations cannot say
    virtual bool free_motion(
        double /*t*/, const double* /*y*/, std::span<const double> /*drawn*/,
        std::span<ProbedBody> /*bodies*/) {
        return false;
    }
};

/// Turn of a body within a step up to which the nearest of all whole turns is the right one [rad]: samples
/// are taken up to two steps behind, and bodies that turn against each other stay within half a turn.
inline constexpr double kCountedTurn = 0.75;

/// Chooses rows at y and keeps the choice only if there are more of them. @return whether there are
bool raise_rank(MotionEquations& equations, double t, const double* y);

/// Share of itself, squared, above which a row surely is independent of others.
inline constexpr double kSurelyIndependent = 1e-2;

/// Equations with what independent coordinates and driven mechanisms need besides.
class DrivableEquations : public MotionEquations {
public:
    /// Motions that the constraints allow at y: columns of six numbers per body (ṙ, ω'), orthonormal in the
    /// metric of M, or in one of lengths where masses are far apart. Dense, for small mechanisms.
    virtual MatrixX free_motions(double t, const double* y) = 0;
    /// Accelerations of the last `evaluate` once more, from what they leave of Φq q̈ = γ: twice the digits
    /// near singular positions.
    virtual void refine(double* y_dot) = 0;
    /// Light bodies carry heavy ones, so that digits would be lost in Φq M⁻¹ Φqᵀ; known from `choose_rows`
    /// on.
    virtual bool masses_are_apart() const = 0;
    /// Masses play no part in `project` from the next choice of rows on: for mechanisms that are driven
    /// altogether, so that one pose and one motion meet the equations. Heavy bodies would hide there how well
    /// light ones are held.
    virtual void forget_masses() = 0;
    /// Whether the rows of y, taken one node after the other, leave no pivot below `kSurelyIndependent`: then
    /// a choice of rows costs no more than an evaluation. The rows kept before are lost.
    virtual bool rows_are_sound(double t, const double* y) = 0;
    /// Pivots are compared with those of the last factorisation from now on.
    virtual void keep_pivots() = 0;
    /// Smallest share that is left of any of them: where small pivots stand beside large ones, the smallest
    /// says nothing of the others.
    virtual double share_of_pivots() const = 0;
    /// The function of a driver of the mechanism becomes f0 + f1 t.
    virtual void set_driver(int driver, double f0, double f1) = 0;
};

/// Block-sparse equations of motion in (r, ω'): cost linear in the bodies for chains and rows of loops, no
/// allocation per evaluation. `centroidal` must outlive the result.
std::unique_ptr<DrivableEquations> block_equations(
    const Centroidal& centroidal, const Baumgarte& baumgarte = {});

}  // namespace jw
