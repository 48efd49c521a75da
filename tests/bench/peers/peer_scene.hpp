#pragma once

#include <string>
#include <vector>

#include "core/numerics/linear.hpp"

/// A lesson of dynamics as other engines want it: a tree of joints, the joints that close loops, everything
/// global at the start pose. Body frames stand at the centres of mass, parallel to the global one.
///
/// Simbody's headers are no C++20: this file and sweep.hpp must be C++17.
namespace jw {
struct Lesson;
}

namespace jw::peers {

enum class Kind { revolute, prismatic, cylindrical, universal, spherical, fixed, free };

struct PeerBody {
    std::string name;
    double mass = 0.0;
    Mat3 J = Mat3::Identity();  ///< about the centre, global axes
    Vec3 r = Vec3::Zero();
    Vec3 v = Vec3::Zero();
    Vec3 omega = Vec3::Zero();
};

struct PeerJoint {
    Kind kind = Kind::free;
    int parent = 0;
    int child = 0;
    Vec3 point = Vec3::Zero();
    Vec3 axis_parent = Vec3::UnitZ();
    Vec3 axis_child = Vec3::UnitX();  ///< differs from axis_parent for a universal joint only
};

/// A joint that closes a loop.
struct PeerLoop {
    PeerJoint joint;
    bool point_is_enough = true;  ///< the rest of the mechanism holds its axes
};

/// Spring and damper between points given from the bodies' centres.
struct PeerSpring {
    int body_i = 0;
    int body_j = 0;
    Vec3 P_i = Vec3::Zero();
    Vec3 P_j = Vec3::Zero();
    double stiffness = 0.0;
    double free_length = 0.0;
    double damping = 0.0;
};

/// A constant global force at the centre of mass and a constant global torque.
struct PeerWrench {
    int body = 0;
    Vec3 force = Vec3::Zero();
    Vec3 torque = Vec3::Zero();
};

struct PeerScene {
    std::string name;
    Vec3 gravity = Vec3::Zero();
    std::vector<PeerBody> bodies;  ///< [0] is the ground
    std::vector<PeerJoint> tree;   ///< one per moving body, parents first
    std::vector<PeerLoop> loops;
    std::vector<PeerSpring> springs;
    std::vector<PeerWrench> wrenches;
    double duration = 1.0;
    int body = 1;
    Vec3 point = Vec3::Zero();
    std::vector<Vec3> reference;     ///< of the point at 101 equal times
    const Lesson* lesson = nullptr;  ///< what it was read from
};

inline Vec3 from_centre(const PeerScene& scene, int body, const Vec3& point) {
    return point - scene.bodies[static_cast<std::size_t>(body)].r;
}

/// Velocity of a point of a body at the start.
inline Vec3 velocity_at(const PeerScene& scene, int body, const Vec3& point) {
    const PeerBody& b = scene.bodies[static_cast<std::size_t>(body)];
    return b.v + b.omega.cross(point - b.r);
}

}  // namespace jw::peers
