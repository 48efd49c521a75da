#pragma once

#include <string>

#include "tests/reference/real.hpp"

/// A mechanism as it stands at t = 0, everything in the global frame. Body 0 is the ground.
namespace jw::reference {

/// A body; its frame is at the centre of mass, along the principal axes.
struct Body {
    Real mass = 0.0L;
    Vec3 J = Vec3::Ones();  ///< principal moments of inertia [kg m²]
    Vec3 r = Vec3::Zero();
    Vec4 p = Vec4::Unit(0);
    Vec3 v = Vec3::Zero();
    Vec3 omega = Vec3::Zero();  ///< global [rad/s]
};

enum class JointKind { revolute, prismatic, spherical, universal };

struct Joint {
    JointKind kind = JointKind::revolute;
    int i = 0;  ///< nearer to the ground
    int j = 0;
    Vec3 point = Vec3::Zero();
    Vec3 axis = Vec3::UnitZ();    ///< universal: the arm on i
    Vec3 axis_j = Vec3::UnitZ();  ///< universal: the arm on j
    bool closes_loop = false;     ///< no coordinate of its own: j is reached by another joint
    int same_as = -1;             ///< its angle is `sense` times that of this joint, -1: its own
    Real sense = 1.0L;
};

/// Spring that pulls with k (l - l0) + c dl/dt.
struct Spring {
    int i = 0;
    int j = 0;
    Vec3 P_i = Vec3::Zero();
    Vec3 P_j = Vec3::Zero();
    Real k = 0.0L;
    Real c = 0.0L;
    Real free_length = 0.0L;
};

struct Scene {
    std::string name;
    std::string what;  ///< description in one line
    std::vector<Body> bodies = std::vector<Body>(1);
    std::vector<Joint> joints;  ///< a joint that brings a body comes after those of the bodies before it
    std::vector<Spring> springs;
    Vec3 gravity = Vec3::Zero();
    int driven = 0;              ///< body under a constant torque, 0: none
    Vec3 torque = Vec3::Zero();  ///< [N m]
    Real duration = 1.0L;        ///< [s]
    int body = 1;                ///< body that the point belongs to
    Vec3 point = Vec3::Zero();
    Real finest = 1e-16L;  ///< smallest tolerance that extrapolation can meet in spite of rounding
    /// Joint equations lose rank on the way: only joint coordinates get through.
    bool passes_singular = false;
};

/// Position and velocity of the scene's point.
struct Sample {
    Vec3 r = Vec3::Zero();
    Vec3 v = Vec3::Zero();
};

/// Samples at 101 equal times from 0 to the scene's duration.
using Trajectory = std::vector<Sample>;
inline constexpr int kIntervals = 100;

/// Largest distance of the points of two trajectories [m].
inline Real largest_distance(const Trajectory& a, const Trajectory& b) {
    Real most = a.size() == b.size() ? 0.0L : HUGE_VALL;
    for (std::size_t k = 0; k < a.size() && k < b.size(); ++k) {
        const Real distance = (a[k].r - b[k].r).norm();
        most = distance <= most ? most : distance;  // NaN wins
    }
    return most;
}

}  // namespace jw::reference
