#include "tests/reference/body_motion.hpp"

namespace jw::reference {

namespace {

const BodyMotion& of(const Motions& motions, int body) { return motions[static_cast<std::size_t>(body)]; }

/// Right-handed frame of an axis and two sides perpendicular to it.
Mat3 frame_about(const Vec3& axis) {
    const Vec3 a = axis.normalized();
    Eigen::Index least = 0;
    a.cwiseAbs().minCoeff(&least);
    Mat3 frame;
    frame.col(2) = a;
    frame.col(0) = a.cross(Vec3::Unit(least)).normalized();
    frame.col(1) = a.cross(frame.col(0));
    return frame;
}

}  // namespace

JointRows::JointRows(const Joint& joint, const Scene& scene) : kind_(joint.kind), i_(joint.i), j_(joint.j) {
    const Mat3 to_i = rotation(scene.bodies[static_cast<std::size_t>(i_)].p).transpose();
    const Mat3 to_j = rotation(scene.bodies[static_cast<std::size_t>(j_)].p).transpose();
    P_i_ = local_point(scene, i_, joint.point);
    P_j_ = local_point(scene, j_, joint.point);
    frame_i_ = to_i * frame_about(joint.axis);
    frame_j_ = to_j * frame_about(joint.axis);
    arm_i_ = to_i * joint.axis.normalized();
    arm_j_ = to_j * joint.axis_j.normalized();
}

void JointRows::append(const Motions& motions, std::vector<Row>& rows) const {
    if (kind_ == JointKind::prismatic) {
        no_way_along(motions, frame_i_.col(0), rows);
        no_way_along(motions, frame_i_.col(1), rows);
        for (int k = 0; k < 3; ++k) {
            perpendicular(motions, frame_i_.col(k), frame_j_.col((k + 1) % 3), rows);
        }
        return;
    }
    same_point(motions, rows);
    if (kind_ == JointKind::revolute) {
        perpendicular(motions, frame_i_.col(0), frame_j_.col(2), rows);
        perpendicular(motions, frame_i_.col(1), frame_j_.col(2), rows);
    }
    if (kind_ == JointKind::universal) { perpendicular(motions, arm_i_, arm_j_, rows); }
}

/// r_i + s_i = r_j + s_j
void JointRows::same_point(const Motions& motions, std::vector<Row>& rows) const {
    const BodyMotion& i = of(motions, i_);
    const BodyMotion& j = of(motions, j_);
    const Vec3 s_i = i.A * P_i_;
    const Vec3 s_j = j.A * P_j_;
    const Vec3 phi = i.r + s_i - j.r - s_j;
    const Vec3 bias = i.omega.cross(i.omega.cross(s_i)) - j.omega.cross(j.omega.cross(s_j));
    for (int k = 0; k < 3; ++k) {
        const Vec3 e = Vec3::Unit(k);
        rows.push_back({i_, j_, e, s_i.cross(e), -e, -s_j.cross(e), phi[k], -bias[k]});
    }
}

/// a·b = 0, a in body i, b in body j
void JointRows::perpendicular(
    const Motions& motions, const Vec3& a_local, const Vec3& b_local, std::vector<Row>& rows) const {
    const BodyMotion& i = of(motions, i_);
    const BodyMotion& j = of(motions, j_);
    const Vec3 a = i.A * a_local;
    const Vec3 b = j.A * b_local;
    const Vec3 a_dot = i.omega.cross(a);
    const Vec3 b_dot = j.omega.cross(b);
    const Real bias = i.omega.cross(a_dot).dot(b) + 2.0L * a_dot.dot(b_dot) + a.dot(j.omega.cross(b_dot));
    rows.push_back({i_, j_, Vec3::Zero(), a.cross(b), Vec3::Zero(), b.cross(a), a.dot(b), -bias});
}

/// a·d = 0, a in body i, d from the point of i to that of j
void JointRows::no_way_along(const Motions& motions, const Vec3& a_local, std::vector<Row>& rows) const {
    const BodyMotion& i = of(motions, i_);
    const BodyMotion& j = of(motions, j_);
    const Vec3 a = i.A * a_local;
    const Vec3 a_dot = i.omega.cross(a);
    const Vec3 s_i = i.A * P_i_;
    const Vec3 s_j = j.A * P_j_;
    const Vec3 d = j.r + s_j - i.r - s_i;
    const Vec3 d_dot = j.v + j.omega.cross(s_j) - i.v - i.omega.cross(s_i);
    const Vec3 d_bias = j.omega.cross(j.omega.cross(s_j)) - i.omega.cross(i.omega.cross(s_i));
    const Real bias = i.omega.cross(a_dot).dot(d) + 2.0L * a_dot.dot(d_dot) + a.dot(d_bias);
    rows.push_back({i_, j_, -a, a.cross(d) - s_i.cross(a), a, s_j.cross(a), a.dot(d), -bias});
}

void add_loads(const Scene& scene, const Motions& motions, std::vector<Wrench>& wrenches) {
    for (std::size_t b = 1; b < motions.size(); ++b) {
        wrenches[b].force += scene.bodies[b].mass * scene.gravity;
    }
    if (scene.driven > 0) { wrenches[static_cast<std::size_t>(scene.driven)].torque += scene.torque; }
    for (const Spring& spring : scene.springs) {
        const BodyMotion& i = of(motions, spring.i);
        const BodyMotion& j = of(motions, spring.j);
        const Vec3 s_i = i.A * local_point(scene, spring.i, spring.P_i);
        const Vec3 s_j = j.A * local_point(scene, spring.j, spring.P_j);
        const Vec3 d = j.r + s_j - i.r - s_i;
        const Vec3 d_dot = j.v + j.omega.cross(s_j) - i.v - i.omega.cross(s_i);
        const Real length = d.norm();
        const Vec3 u = d / length;
        const Vec3 pull = (spring.k * (length - spring.free_length) + spring.c * u.dot(d_dot)) * u;
        Wrench& on_i = wrenches[static_cast<std::size_t>(spring.i)];
        Wrench& on_j = wrenches[static_cast<std::size_t>(spring.j)];
        on_i.force += pull;
        on_i.torque += s_i.cross(pull);
        on_j.force -= pull;
        on_j.torque -= s_j.cross(pull);
    }
}

Motions start_motions(const Scene& scene) {
    Motions motions;
    for (const Body& body : scene.bodies) {
        motions.push_back({body.r, rotation(body.p), body.v, body.omega});
    }
    return motions;
}

}  // namespace jw::reference
