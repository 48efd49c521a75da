#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/equations/assembler.hpp"
#include "core/model/mechanism.hpp"
#include "core/model/transformed.hpp"
#include "core/poses/rank.hpp"
#include "tests/support/random_mechanisms.hpp"

/// Mechanisms put together in code from global points and axes at their assembled pose.
namespace jw::test {

class SceneBuilder {
public:
    /// Ground: body 0, fixed, its frame turned and moved so that nothing is tested in a global frame only.
    SceneBuilder() { mechanism.bodies.push_back(body_at("ground", Vec3(0.2, -0.1, 0.3), true)); }

    /// @return its index; the frame is turned differently for every body
    int add_body(const std::string& name, const Vec3& r) {
        mechanism.bodies.push_back(body_at(name, r, false));
        return static_cast<int>(mechanism.bodies.size()) - 1;
    }

    /// Joint at a global point, both bodies sharing the axis; u_i = u_j and h_i, h_j perpendicular. A formula
    /// is one of a few that hold there.
    Joint& add_joint(std::string_view type, int i, int j, const Vec3& point, const Vec3& axis) {
        Joint joint;
        joint.name = "joint " + std::to_string(mechanism.joints.size());
        joint.type = find_joint_type(type);
        joint.body_i = i;
        joint.body_j = j;
        JointGeometry& g = joint.geometry;
        const Vec3 unit = axis.normalized();
        g.P_i_local = local_point(i, point);
        g.P_j_local = local_point(j, point);
        g.s_i_local = local(i, unit);
        g.s_j_local = local(j, unit);
        g.u_i_local = g.h_i_local = local(i, perpendicular_to(unit));
        g.u_j_local = local(j, perpendicular_to(unit));
        g.h_j_local = local(j, unit.cross(perpendicular_to(unit)));
        if (joint.type->has_formula()) {
            g.formula = formula_at_joint(mechanism.joints.size() + static_cast<std::size_t>(i));
        }
        mechanism.joints.push_back(joint);
        return mechanism.joints.back();
    }

    Joint& add_universal(int i, int j, const Vec3& point, const Vec3& arm_i, const Vec3& arm_j) {
        Joint& joint = add_joint("universal", i, j, point, arm_i);
        joint.geometry.s_j_local = local(j, arm_j.normalized());
        return joint;
    }

    Joint& add_distance(int i, int j, const Vec3& point_i, const Vec3& point_j) {
        return add_link("distance", i, j, point_i, point_j, Vec3::UnitZ());
    }

    /// A link without mass between two points: its axes across the link, those of crossed ones across each
    /// other, as near to `axis` as that allows.
    Joint& add_link(
        std::string_view type, int i, int j, const Vec3& point_i, const Vec3& point_j, const Vec3& axis) {
        const Vec3 d = point_j - point_i;
        const Vec3 across = axis - axis.dot(d) / d.squaredNorm() * d;
        const bool any_axis = !find_joint_type(type)->uses(kAxisI);
        Joint& joint = add_joint(type, i, j, point_i, any_axis ? axis : across);
        JointGeometry& g = joint.geometry;
        if (joint.type->uses(Role::axes_perpendicular)) {
            g.s_j_local = local(j, d.cross(across).normalized());
        }
        g.P_j_local = local_point(j, point_j);
        g.length = d.norm();
        return joint;
    }

    /// Wheels that mesh in this pose with θ = 0: both u lie on their line. A rack has its direction in place
    /// of the axis of i.
    Joint& add_wheels(
        std::string_view type, int i, int j, const Vec3& centre_i, const Vec3& centre_j, const Vec3& axis_i,
        const Vec3& axis_j, double ratio) {
        Joint& joint = add_joint(type, i, j, centre_i, axis_i);
        JointGeometry& g = joint.geometry;
        const Vec3 s_i = axis_i.normalized();
        const Vec3 s_j = axis_j.normalized();
        const Vec3 d = centre_j - centre_i;
        g.P_j_local = local_point(j, centre_j);
        g.s_j_local = local(j, s_j);
        Vec3 line = s_i;
        if (joint.type->uses(Role::wheel_i)) { line = d - s_i.dot(d) * s_i; }
        if (joint.type->uses(Role::bevel_i)) { line = s_i.cross(s_j); }
        if (!joint.type->uses(Role::rack_angle)) { g.u_i_local = local(i, line.normalized()); }
        g.u_j_local = local(j, line.normalized());
        g.ratio = g.alpha = ratio;
        g.d_0 = s_i.dot(d);
        return joint;
    }
    /// A point of j on a curve of i, at this pose at the parameter θ.
    Joint& add_curve(int i, int j, const Vec3& point, double theta, Curve curve) {
        Joint& joint = add_joint("curve", i, j, point, Vec3::UnitZ());
        joint.geometry.P_i_local -= curve.at(theta).c;
        joint.geometry.theta_start = theta;
        joint.geometry.curve = std::move(curve);
        return joint;
    }

    /// Wheels or a curve in any place, so large that bodies which nothing else holds keep their line:
    /// parallel axes, or two that are not.
    Joint& add_any_wheels(
        std::string_view type, int i, int j, const Vec3& centre, const Vec3& axis, double size = 3.0) {
        if (find_joint_type(type)->uses(Role::curve_x)) {
            Curve curve{
                Vec3::Zero(),
                0.2 * size * axis.normalized(),
                {{size * Vec3(1.0, 0.0, 0.2), size * Vec3(0.0, 1.2, 0.0)}}};
            return add_curve(i, j, centre, 0.4, std::move(curve));
        }
        const Vec3 across = perpendicular_to(axis);
        const bool is_parallel = find_joint_type(type)->uses(Role::wheel_i);
        const bool is_bevel = find_joint_type(type)->uses(Role::bevel_i);
        const Vec3 axis_j = is_parallel ? axis : is_bevel ? Vec3(across + 0.4 * axis) : across;
        return add_wheels(type, i, j, centre, centre + size * across + 0.1 * size * axis, axis, axis_j, -1.5);
    }

    /// Sets the global directions (at this pose) from which the joint's angle is measured.
    void measure_angle(Joint& joint, const Vec3& u_i, const Vec3& u_j) const {
        joint.geometry.u_i_local = local(joint.body_i, u_i.normalized());
        joint.geometry.u_j_local = local(joint.body_j, u_j.normalized());
    }

    Vec3 local(int body, const Vec3& v) const { return rotation_matrix(at(body).p).transpose() * v; }
    Vec3 local_point(int body, const Vec3& point) const { return local(body, point - at(body).r); }

    Mechanism mechanism;

private:
    /// Equations of axes and points that coincide.
    static ScalarFormula formula_at_joint(std::size_t which) {
        using namespace authored;
        using enum FormulaVector;
        const std::array left{dot(s_i, u_j), dot(s_i, d), sine(dot(s_i, u_j)) + dot(u_i, d)};
        return equation(left[which % left.size()], 0.0);
    }

    const Body& at(int body) const { return mechanism.bodies[static_cast<std::size_t>(body)]; }
    Body body_at(const std::string& name, const Vec3& r, bool fixed) const {
        Body body;
        body.name = name;
        body.fixed = fixed;
        body.r = r;
        const double k = 1.0 + static_cast<double>(mechanism.bodies.size());
        body.p = euler_parameters_of(Vec3(1.0, -k, 0.5), 0.4 * k);
        return body;
    }
};

/// Prescribes the angle of a joint.
inline Driver& drive_angle(Mechanism& mechanism, int joint, TimeFunction function) {
    const Joint& j = mechanism.joints[static_cast<std::size_t>(joint)];
    mechanism.drivers.push_back(
        {"driver of " + j.name, joint, j.body_i, j.body_j, angle_of(j), std::move(function)});
    return mechanism.drivers.back();
}

/// c0 + c1 t + c2 t²
inline TimeFunction polynomial(std::vector<double> coefficients) {
    TimeFunction function;
    function.polynomial = std::move(coefficients);
    return function;
}

/// Moving bodies off their place by up to `distance` [m] and `turn` [rad] in every coordinate.
inline State disturbed(
    const Mechanism& mechanism, State state, Random& random, double distance, double turn) {
    for (std::size_t b = 0; b < state.r.size(); ++b) {
        if (mechanism.bodies[b].fixed) { continue; }
        state.r[b] += random.vector(distance);
        state.p[b] = turned_local(state.p[b], random.vector(turn));
    }
    return state;
}

/// Rank of all equations at the mechanism's start pose.
inline RankReport rank_of(const Mechanism& mechanism, double t = 0.0) {
    const System system(mechanism, everything(mechanism));
    Assembler<OmegaLocal> assembler(system);
    assembler.assemble_phi_and_jacobian(start_state(mechanism), t);
    return analyse_rank(system, assembler.jacobian(), assembler.phi());
}

/// Φq of all equations at the start pose in a coordinate choice, with its normalisation rows.
template <class C>
SparseRows sparse_jacobian_of(const Mechanism& mechanism) {
    const System system(mechanism, everything(mechanism));
    Assembler<C> assembler(system);
    assembler.assemble_phi_and_jacobian(start_state(mechanism), 0.0);
    return assembler.sparse_jacobian();
}
template <class C>
MatrixX jacobian_of(const Mechanism& mechanism) {
    const SparseRows sparse = sparse_jacobian_of<C>(mechanism);
    MatrixX jacobian(static_cast<Eigen::Index>(sparse.rows.size()), sparse.columns);
    sparse.write(jacobian);
    return jacobian;
}

}  // namespace jw::test
