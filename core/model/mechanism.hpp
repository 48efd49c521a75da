#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/jets/drivers.hpp"
#include "core/model/joint_types.hpp"

/// A mechanism as data: bodies, joints and drivers, each a plain value.
namespace jw {

/// A rigid body and its start estimate. A fixed body has no unknowns.
struct Body {
    std::string name;
    bool fixed = false;
    Vec3 r = Vec3::Zero();            ///< [m]
    Vec4 p = Vec4::Unit(0);           ///< used as it is: unit only to the digits that the author typed
    Vec3 r_dot = Vec3::Zero();        ///< [m/s]
    Vec3 omega_local = Vec3::Zero();  ///< [rad/s]
};

/// One equation of a joint: a component of the primitive with this role.
struct EquationOut {
    Role role = Role::same_point;
    int component = 0;  ///< 0, 1, 2 = x, y, z; of a pair form 0, 1

    bool operator==(const EquationOut&) const = default;
};

struct Joint {
    std::string name;
    const JointType* type = nullptr;  ///< entry of kJointTypes
    int body_i = 0;
    int body_j = 0;
    JointGeometry geometry;
    ParallelForm parallel_form = ParallelForm::rule;
    /// Equations taken out by hand, whatever the form; an equation that the joint lacks has no effect.
    std::vector<EquationOut> without;
};

/// Prescribes a measure between two bodies as a function of time.
struct Driver {
    std::string name;
    int joint = -1;  ///< joint along which it acts, -1 for a distance or a coordinate
    int body_i = 0;
    int body_j = 0;
    Measure measure;
    TimeFunction function;
};

/// Verdict on the rank of all joints together, where it depends on the digits of typed numbers.
struct TypedVerdict {
    int rank_as_typed = 0;
    int rank = 0;                 ///< of the mechanism that was meant
    double misfit = 0.0;          ///< largest |Φ| of the mechanism as typed along the meant motion, scaled
    double share = 0.0;           ///< largest change of a number, in half units of its last digit
    std::string short_of_digits;  ///< name of the number or key that decides the rank; empty: several do
    /// True: a mechanism within the digits has `rank` along a motion of finite length. False: no such
    /// mechanism was found, and the rank is not known.
    bool is_told = false;
};

struct Mechanism {
    std::vector<Body> bodies;
    std::vector<Joint> joints;
    std::vector<Driver> drivers;
    std::optional<TypedVerdict> typed;  ///< set if the rank of the joints depends on their digits

    int moving_bodies_count() const;
    /// Joint index -> index of its artificial coordinate, -1 where it has none.
    std::vector<int> theta_indices() const;
    int thetas_count() const;
};

/// Positions: one r [m] and p per body, one θ [rad] per joint that has one, in the order of the mechanism.
struct State {
    std::vector<Vec3> r;
    std::vector<Vec4> p;
    std::vector<double> theta;
};

/// Velocities (or, where said, accelerations) in the order of State: ṙ [m/s], ω' [rad/s], θ̇.
struct Motion {
    std::vector<Vec3> r_dot;
    std::vector<Vec3> omega_local;
    std::vector<double> theta_dot;
};

/// Poses of the bodies as the mechanism's author gave them; every θ is 0.
State start_poses(const Mechanism& mechanism);
/// The state as the mechanism's author gave it; θ is measured unless given.
State start_state(const Mechanism& mechanism);
/// Velocities as given; θ̇ is that of the bodies unless given.
Motion start_motion(const Mechanism& mechanism);
/// All zero, of the mechanism's size.
Motion zero_motion(const Mechanism& mechanism);

/// Right-handed angle from u_i to u_j about s_i of a joint at `state`, in (-π, π].
double relative_angle(const Joint& joint, const State& state);

/// Rate of this angle, s_iᵀ (ω_j - ω_i) [rad/s].
double angle_rate(const Joint& joint, const State& state, const Motion& motion);

/// Acceleration of this angle, s_iᵀ (ω̇_j - ω̇_i) + (ω_i x s_i)ᵀ (ω_j - ω_i) [rad/s²].
/// @param acceleration  ω̇' instead of ω'
double angle_acceleration(
    const Joint& joint, const State& state, const Motion& motion, const Motion& acceleration);

/// Angle that the artificial coordinate of a joint follows [rad]: for a screw from u_i to u_j, for wheels
/// from their line to u of the first wheel, in (-π, π]; for a curve, the parameter of its nearest point.
double artificial_angle(const Joint& joint, const State& state);
/// Artificial coordinate nearest to an expected value: with whole turns, or by Newton's method on the curve.
double artificial_angle_near(const Joint& joint, const State& state, double expected);
/// Artificial coordinate with the turns that the pose determines: by the advance of a screw or a rack, by the
/// other wheel of a gear. Of values that differ by whole turns of both wheels, the nearest to 0.
double artificial_angle_with_turns(const Joint& joint, const State& state);
/// Rate of the artificial coordinate at `theta` [rad/s]; 0 where the line of the wheels has no direction.
double artificial_rate(const Joint& joint, const State& state, const Motion& motion, double theta);
/// Its acceleration [rad/s²]. @param acceleration  ω̇' and r̈ instead of ω' and ṙ
double artificial_acceleration(
    const Joint& joint, const State& state, const Motion& motion, const Motion& acceleration, double theta);

/// Wheel whose angle is the θ of a joint; none if θ is another angle.
std::optional<Wheel> first_wheel(const Joint& joint);
/// Wheel that follows the first one; none if the joint has no second wheel.
std::optional<Wheel> second_wheel(const Joint& joint);

/// Whole turns k of the first wheel for which `turned` - 2π k ratio is nearest to whole turns of the second
/// wheel; of equally near ones, the smallest.
int turns_of_mesh(double turned, double ratio);

/// The joint's measures for drivers and quantities.
AngleMeasure angle_of(const Joint& joint);
DisplacementMeasure displacement_of(const Joint& joint);

/// A length typical of the mechanism's arms and distances [m], never 0; see unit_of_length.
double extent(const Mechanism& mechanism);

/// Power of 1000 nearest to the extent (mm, m, km ...) [m]. Equations and unknowns are measured in this unit
/// wherever sizes are compared, so that verdicts do not depend on the size of the machine.
double unit_of_length(const Mechanism& mechanism);

}  // namespace jw
