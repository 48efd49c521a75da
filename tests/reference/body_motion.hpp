#pragma once

#include "tests/reference/scene.hpp"

/// Positions and motions of bodies, the equations of joints between them, and the forces on them.
namespace jw::reference {

struct BodyMotion {
    Vec3 r = Vec3::Zero();
    Mat3 A = Mat3::Identity();
    Vec3 v = Vec3::Zero();
    Vec3 omega = Vec3::Zero();  ///< global
};
using Motions = std::vector<BodyMotion>;

/// One equation between two bodies: phi = 0, J_i·(v_i, ω_i) + J_j·(v_j, ω_j) = 0, J·(accelerations) = gamma.
struct Row {
    int i = 0;
    int j = 0;
    Vec3 v_i = Vec3::Zero();
    Vec3 w_i = Vec3::Zero();
    Vec3 v_j = Vec3::Zero();
    Vec3 w_j = Vec3::Zero();
    Real phi = 0.0L;
    Real gamma = 0.0L;
};

/// A joint with its vectors fixed in the two bodies.
class JointRows {
public:
    JointRows(const Joint& joint, const Scene& scene);
    void append(const Motions& motions, std::vector<Row>& rows) const;

private:
    void same_point(const Motions& motions, std::vector<Row>& rows) const;
    void perpendicular(const Motions& motions, const Vec3& a, const Vec3& b, std::vector<Row>& rows) const;
    void no_way_along(const Motions& motions, const Vec3& a, std::vector<Row>& rows) const;

    JointKind kind_;
    int i_, j_;
    Vec3 P_i_, P_j_;
    Mat3 frame_i_, frame_j_;  ///< columns: two sides and the axis, equal in both bodies at t = 0
    Vec3 arm_i_, arm_j_;      ///< of a universal joint
};

struct Wrench {
    Vec3 force = Vec3::Zero();
    Vec3 torque = Vec3::Zero();  ///< about the centre of mass
};

/// Gravity, the constant torque and the springs.
void add_loads(const Scene& scene, const Motions& motions, std::vector<Wrench>& wrenches);

/// Start of the scene.
Motions start_motions(const Scene& scene);

/// Point fixed in body `b` that was at `global` at t = 0, in the body's frame.
inline Vec3 local_point(const Scene& scene, int b, const Vec3& global) {
    const Body& body = scene.bodies[static_cast<std::size_t>(b)];
    return rotation(body.p).transpose() * (global - body.r);
}

}  // namespace jw::reference
