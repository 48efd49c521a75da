#include "core/kinematics/paths/cubic_path.hpp"

#include <cmath>

namespace jw {

State middle_of(const System& system, const PathEnd& from, const PathEnd& to) {
    const double h = to.t - from.t;
    State middle = *from.state;
    for (const int body : system.moving_bodies()) {
        const auto b = static_cast<std::size_t>(body);
        const Vec4& p0 = from.state->p[b];
        // p and -p are the same pose: the nearer one is used
        const Vec4 p1 = p0.dot(to.state->p[b]) < 0.0 ? Vec4(-to.state->p[b]) : to.state->p[b];
        const Vec4 p_dot0 = p_dot_of_omega_local(p0, from.velocity->omega_local[b]);
        const Vec4 p_dot1 = p_dot_of_omega_local(p1, to.velocity->omega_local[b]);
        middle.r[b] = 0.5 * (from.state->r[b] + to.state->r[b]) +
                      h / 8.0 * (from.velocity->r_dot[b] - to.velocity->r_dot[b]);
        middle.p[b] = (0.5 * (p0 + p1) + h / 8.0 * (p_dot0 - p_dot1)).normalized();
    }
    for (const int theta : system.active_thetas()) {
        const auto k = static_cast<std::size_t>(theta);
        middle.theta[k] = 0.5 * (from.state->theta[k] + to.state->theta[k]) +
                          h / 8.0 * (from.velocity->theta_dot[k] - to.velocity->theta_dot[k]);
    }
    return middle;
}

bool satisfies(Assembler<OmegaLocal>& assembler, const State& state, double t, double tolerance) {
    assembler.assemble_phi_and_jacobian(state, t);
    const VectorX& phi = assembler.phi();
    for (int row = 0; row < static_cast<int>(phi.size()); ++row) {
        // negated, so that NaN fails
        if (!(std::abs(phi(row)) <= tolerance * assembler.system().row_unit(row))) { return false; }
    }
    return true;
}

}  // namespace jw
