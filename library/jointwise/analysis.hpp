#pragma once

#include <functional>
#include <stdexcept>

#include "jointwise/mechanism.hpp"

/// Computations on a mechanism: poses, equations, rank, velocities, accelerations, motion.
namespace jointwise {
inline namespace JOINTWISE_ABI {

/// Coordinates of the equations: (r, p) with the true or the modified derivatives, (r, ω'), (r, ω).
enum class Coordinates { true_euler_parameters, modified_euler_parameters, omega_local, omega_global };

/// Positions at a time: r and p of each body, the angle of each screw.
struct Pose {
    double t = 0.0;             ///< [s]
    std::vector<Vector3> r;     ///< [m]
    std::vector<Vector4> p;     ///< Euler parameters
    std::vector<double> theta;  ///< artificial coordinates of screws [rad]
};

/// Velocities, or accelerations under the same names.
struct Rates {
    std::vector<Vector3> r_dot;        ///< [m/s]
    std::vector<Vector3> omega_local;  ///< in the frame of the body [rad/s]
    std::vector<double> theta_dot;     ///< [rad/s]
};

/// The numerical methods did not reach a result; `what()` names the time and the joint.
class NotReached : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The pose given as the start estimate, whether it satisfies the equations or not.
Pose start_pose(const Mechanism& mechanism);
Rates start_rates(const Mechanism& mechanism);

/// Assembles the mechanism at a time: Φ(q, t) = 0, beginning at the start estimate. @throws NotReached
Pose assemble(const Mechanism& mechanism, double t = 0.0);
/// The same, beginning at another estimate.
Pose assemble(const Mechanism& mechanism, const Pose& estimate, double t);

/// Equations of all joints and drivers at a pose: Φ, Φq, and the right sides of Φq q̇ = ν and Φq q̈ = γ. Each
/// moving body has seven or six columns; the angles of screws follow.
struct Equations {
    std::vector<std::string> rows;  ///< "hinge.p1.y", one per row
    Eigen::VectorXd phi;
    Eigen::MatrixXd jacobian;
    Eigen::VectorXd nu;
    Eigen::VectorXd gamma;
};
Equations equations_at(
    const Mechanism& mechanism, const Pose& pose, const Rates& velocities,
    Coordinates coordinates = Coordinates::modified_euler_parameters);

/// Verdict on the rank of Φq at a pose, in (r, ω') coordinates.
struct Rank {
    int rows = 0;
    int columns = 0;
    int rank = 0;
    int freedoms = 0;                 ///< columns - rank
    int redundant = 0;                ///< rows - rank
    int by_counting = 0;              ///< freedoms according to Grübler
    bool decided = true;              ///< false: a singular value is within its error of the threshold
    Eigen::VectorXd singular_values;  ///< scaled, largest first; empty for very large mechanisms
    std::vector<std::string> redundant_rows;
    Eigen::MatrixXd free_motions;  ///< one per column
};
Rank rank_at(const Mechanism& mechanism, const Pose& pose);

/// Velocities that satisfy Φq q̇ = ν; if they are not unique, the smallest. @throws NotReached if equations
/// contradict each other
Rates velocities_at(const Mechanism& mechanism, const Pose& pose);
/// Accelerations r̈, ω̇', θ̈ with Φq q̈ = γ; if they are not unique, the smallest.
Rates accelerations_at(const Mechanism& mechanism, const Pose& pose, const Rates& velocities);

/// A moment of a motion.
struct Moment {
    Pose pose;
    Rates velocity;
    Rates acceleration;
    double energy = 0.0;  ///< kinetic and potential [J]; 0 in `follow`
};

/// Motion that the drivers prescribe, at ascending times. @throws NotReached
std::vector<Moment> follow(const Mechanism& mechanism, const std::vector<double>& times);

struct Simulation {
    std::string method = "explicit-8";  ///< as for `jointwise simulate --method`
    double tolerance = 1e-6;            ///< for adaptive methods
    double step = 1e-3;                 ///< for the other methods [s]
    /// Called every few hundred steps; false ends the run with NotReached.
    std::function<bool()> go_on = {};
};
/// Motion by masses and forces, from t = 0 through the ascending times. Every moving body needs a mass.
/// @throws NotReached if it ends early
std::vector<Moment> simulate(
    const Mechanism& mechanism, const std::vector<double>& times, const Simulation& settings = {});

}  // namespace JOINTWISE_ABI
}  // namespace jointwise
