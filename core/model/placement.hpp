#pragma once

#include "core/model/mechanism.hpp"

/// Joints placed by vectors in the global frame at the start pose of their bodies: for lessons, the library
/// and experiments.
namespace jw {

/// Largest |cosine| of two vectors that count as perpendicular: typed with four digits (0.06 deg).
inline constexpr double kPerpendicular = 1e-3;

bool is_perpendicular(const Vec3& a, const Vec3& b);

/// Rotation matrix of a body at the start, p normalised.
Mat3 rotation_of(const Body& body);

/// Vectors that the primitives of a type use.
struct JointNeeds {
    explicit JointNeeds(const JointType& type)
        : two_points(!type.uses(Role::same_point)),
          points(type.uses(kPoints) || type.uses(kD) || type.uses(Role::bevel_i)),
          right_angle(type.uses(Role::axes_perpendicular) || type.uses(Role::rack_angle)),
          arms(right_angle || type.uses(Role::bevel_i)),
          axis_j(type.uses(kAxisJ)),
          axis(type.uses(kAxisI)),
          sides(type.uses(kSidesH) || type.has_marks()) {}

    bool two_points;   ///< the points of i and j need not coincide
    bool points;       ///< points are used; for bevel gears only in pictures
    bool right_angle;  ///< the vectors of the two bodies are perpendicular
    bool arms;         ///< the vectors of the two bodies are not parallel
    bool axis_j;       ///< a vector in body j too
    bool axis;
    bool sides;
};

/// Two bodies at their start poses, and the rotation from the global frame to theirs.
struct BodyPair {
    const Body* i;
    const Body* j;
    bool sound = true;  ///< false: the poses are not known

    Vec3 point_i(const Vec3& global) const { return vector_i(global - i->r); }
    Vec3 point_j(const Vec3& global) const { return vector_j(global - j->r); }
    Vec3 vector_i(const Vec3& global) const { return rotation_of(*i).transpose() * global; }
    Vec3 vector_j(const Vec3& global) const { return rotation_of(*j).transpose() * global; }
    /// d from the point of i to that of j, global [m].
    Vec3 d(const Vec3& P_i_local, const Vec3& P_j_local) const {
        return j->r + rotation_of(*j) * P_j_local - i->r - rotation_of(*i) * P_i_local;
    }
    /// The axis of i, global, a unit vector.
    Vec3 axis_i(const JointGeometry& geometry) const;
};

/// The line of a joint's wheels at the start pose, global: a unit vector perpendicular to the axes of its
/// wheels, or none if there is no such line.
std::optional<Vec3> wheel_line(const BodyPair& pair, const JointType& type, const JointGeometry& geometry);

/// Sets the sides of wheels: both lie on the line of the wheels at the start.
void set_marks(const BodyPair& pair, const Vec3& line, JointGeometry& geometry);

/// Sets the sides of a joint whose axes are set, from one unit vector perpendicular to the axis of i:
/// u_i = u_j if the joint has an angle, otherwise h_j = axis × h_i. If the axes are not parallel at the
/// start, the axis of j is first turned onto that of i in the shortest way.
/// @param side  global
void set_sides(const BodyPair& pair, const JointType& type, const Vec3& side, JointGeometry& geometry);

/// Angle from u_i to u_j at the start, or the estimate that was given [rad].
double start_angle(const BodyPair& pair, const JointGeometry& geometry);
/// Angle that θ of a joint follows at the start, or the estimate that was given [rad].
double start_theta(const BodyPair& pair, const JointType& type, const JointGeometry& geometry);
/// s_i·d at the start [m].
double start_displacement(const BodyPair& pair, const JointGeometry& geometry);

}  // namespace jw
