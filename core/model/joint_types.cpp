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

Wheel wheel(WheelLine line, bool of_j, const JointGeometry& g, double ratio) {
    return {
        line,
        of_j,
        g.s_i_local.normalized(),
        g.s_j_local.normalized(),
        of_j ? g.u_j_local : g.u_i_local,
        g.P_i_local,
        g.P_j_local,
        ratio};
}

OnCurve on_curve(int component, const JointGeometry& g) {
    return {Vec3::Unit(component), g.P_i_local, g.P_j_local, component_of(g.curve, component)};
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
        case Role::formula:
            return FormulaEquation{g.formula,   g.s_i_local, g.s_j_local, g.u_i_local, g.u_j_local,
                                   g.P_i_local, g.P_j_local, g.O_i_local, g.O_j_local};
        case Role::screw_advance:
        case Role::rack_advance:
            return ScrewAdvance{
                g.s_i_local.normalized(), g.P_i_local, g.P_j_local, g.alpha, g.d_0, g.theta_0};
        case Role::screw_angle:
            return ScrewAngle{g.s_i_local.normalized(), g.u_i_local, g.u_j_local, g.screw_angle_form};
        case Role::wheel_i: return wheel(WheelLine::centres, false, g, 1.0);
        case Role::wheel_j: return wheel(WheelLine::centres, true, g, g.ratio);
        case Role::bevel_i: return wheel(WheelLine::normal, false, g, 1.0);
        case Role::bevel_j: return wheel(WheelLine::normal, true, g, g.ratio);
        case Role::curve_x: return on_curve(0, g);
        case Role::curve_y: return on_curve(1, g);
        case Role::curve_z: return on_curve(2, g);
        case Role::rack_angle: return wheel(WheelLine::rack, true, g, 1.0);
    }
    throw std::invalid_argument("primitive_of: no such role");
}

}  // namespace jw
