#include "core/model/transformed.hpp"

namespace jw {

Mechanism moved_rigidly(Mechanism mechanism, const Vec4& p, const Vec3& r) {
    const Mat3 A = rotation_matrix(p);
    for (Body& body : mechanism.bodies) {
        body.r = r + A * body.r;
        body.p = product(p, body.p);
        body.r_dot = A * body.r_dot;
    }
    return mechanism;
}

Mechanism scaled(Mechanism mechanism, double factor) {
    for (Body& body : mechanism.bodies) {
        body.r *= factor;
        body.r_dot *= factor;
    }
    for (Joint& joint : mechanism.joints) {
        JointGeometry& g = joint.geometry;
        for (double* length : {&g.length, &g.alpha, &g.d_0, &g.radii[0], &g.radii[1]}) { *length *= factor; }
        if (g.displacement_dot_start) { *g.displacement_dot_start *= factor; }
        g.curve.constant *= factor;
        g.curve.linear *= factor;
        for (Curve::Harmonic& h : g.curve.harmonics) { h = {factor * h.cos, factor * h.sin}; }
        g.P_i_local *= factor;
        g.P_j_local *= factor;
    }
    return mechanism;
}

}  // namespace jw
