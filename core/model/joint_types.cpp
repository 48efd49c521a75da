#include "core/model/joint_types.hpp"

#include <stdexcept>

#include <Eigen/Geometry>

namespace jw {

namespace {

Primitive parallel_axes(const JointGeometry& g, ParallelForm form) {
    if (form != ParallelForm::pair) { return P1{g.s_i_local, g.s_j_local}; }
    const Vec3 a = perpendicular_to(g.s_i_local);
    return N1Pair{a, g.s_i_local.normalized().cross(a), g.s_j_local};
}

Primitive parallel_distance(const JointGeometry& g, ParallelForm form) {
    if (form != ParallelForm::pair) { return P2{g.s_i_local, g.P_i_local, g.P_j_local}; }
    const Vec3 a = perpendicular_to(g.s_i_local);
    return N2Pair{a, g.s_i_local.normalized().cross(a), g.P_i_local, g.P_j_local};
}

}  // namespace

Primitive primitive_of(Role role, const JointGeometry& g, ParallelForm form) {
    switch (role) {
        case Role::same_point: return S{g.P_i_local, g.P_j_local};
        case Role::axes_parallel: return parallel_axes(g, form);
        case Role::distance_parallel: return parallel_distance(g, form);
        case Role::axes_perpendicular: return N1{g.s_i_local, g.s_j_local};
        case Role::distance_perpendicular: return N2{g.s_i_local, g.P_i_local, g.P_j_local};
        case Role::distance_perpendicular_j: return N2J{g.s_j_local, g.P_i_local, g.P_j_local};
        case Role::sides_perpendicular: return N1{g.h_i_local, g.h_j_local};
        case Role::length: return Distance{g.P_i_local, g.P_j_local, g.length};
        case Role::screw_advance:
            return ScrewAdvance{
                g.s_i_local.normalized(), g.P_i_local, g.P_j_local, g.alpha, g.d_0, g.theta_0};
        case Role::screw_angle:
            return ScrewAngle{g.s_i_local.normalized(), g.u_i_local, g.u_j_local, g.screw_angle_form};
    }
    throw std::invalid_argument("primitive_of: no such role");
}

}  // namespace jw
