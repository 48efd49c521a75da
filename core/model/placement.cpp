#include "core/model/placement.hpp"

#include <cmath>

#include <Eigen/Geometry>

#include "core/jets/euler_parameters.hpp"

namespace jw {

bool is_perpendicular(const Vec3& a, const Vec3& b) {
    return std::abs(a.normalized().dot(b.normalized())) <= kPerpendicular;
}

Mat3 rotation_of(const Body& body) { return rotation_matrix(body.p.normalized()); }

Vec3 BodyPair::axis_i(const JointGeometry& geometry) const {
    return rotation_of(*i) * geometry.s_i_local.normalized();
}

void set_sides(const BodyPair& pair, const JointType& type, const Vec3& side, JointGeometry& geometry) {
    const Vec3 axis = pair.axis_i(geometry);
    const Vec3 axis_j = rotation_of(*pair.j) * geometry.s_j_local.normalized();
    const Vec4 p = euler_parameters_between(axis, axis_j);
    const Mat3 back = Eigen::Quaterniond(p(0), p(1), p(2), p(3)).toRotationMatrix();
    const bool is_same = type.has_angle() || type.has_formula();
    const Vec3 other = is_same ? side : axis.cross(side);
    // a joint has one side vector in each body: u, from which its angle is measured, or the h of its n1
    geometry.h_i_local = geometry.u_i_local = pair.vector_i(side);
    geometry.h_j_local = geometry.u_j_local = pair.vector_j(back * other);
}

std::optional<Vec3> wheel_line(const BodyPair& pair, const JointType& type, const JointGeometry& geometry) {
    const Vec3 axis = pair.axis_i(geometry);
    const Vec3 axis_j = rotation_of(*pair.j) * geometry.s_j_local.normalized();
    Vec3 line = axis;  // the line of a rack is its direction
    double size = 1.0;
    if (type.uses(Role::wheel_i)) {
        const Vec3 d = pair.d(geometry.P_i_local, geometry.P_j_local);
        line = d - axis.dot(d) * axis;
        size = d.norm();
    } else if (type.uses(Role::bevel_i)) {
        line = axis.cross(axis_j);
    }
    if (!(line.norm() > kPerpendicular * size)) { return std::nullopt; }
    return line.normalized();
}

void set_marks(const BodyPair& pair, const Vec3& line, JointGeometry& geometry) {
    const auto across = [](const Vec3& v, const Vec3& axis) {
        const Vec3 s = axis.normalized();
        const Vec3 rest = v - s.dot(v) * s;
        // the direction of a rack is the line itself: any perpendicular will do
        return rest.norm() > kPerpendicular ? Vec3(rest.normalized()) : perpendicular_to(s);
    };
    geometry.h_i_local = geometry.u_i_local = across(pair.vector_i(line), geometry.s_i_local);
    geometry.h_j_local = geometry.u_j_local = across(pair.vector_j(line), geometry.s_j_local);
}

double start_angle(const BodyPair& pair, const JointGeometry& geometry) {
    if (geometry.theta_start) { return *geometry.theta_start; }
    Joint joint;
    joint.geometry = geometry;
    joint.body_j = 1;
    return relative_angle(joint, State{{pair.i->r, pair.j->r}, {pair.i->p, pair.j->p}, {}});
}

double start_theta(const BodyPair& pair, const JointType& type, const JointGeometry& geometry) {
    if (geometry.theta_start) { return *geometry.theta_start; }
    Joint joint;
    joint.type = &type;
    joint.geometry = geometry;
    joint.body_j = 1;
    return artificial_angle(joint, State{{pair.i->r, pair.j->r}, {pair.i->p, pair.j->p}, {}});
}

double start_displacement(const BodyPair& pair, const JointGeometry& geometry) {
    return pair.d(geometry.P_i_local, geometry.P_j_local).dot(pair.axis_i(geometry));
}

}  // namespace jw
