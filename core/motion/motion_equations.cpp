#include "core/motion/motion_equations.hpp"

namespace jw {

void MotionEquations::motion_of_bodies(
    double /*t*/, const double* y, const double* y_dot, std::span<ProbedBody> bodies) {
    for (std::size_t m = 0; m < bodies.size(); ++m) {
        const double* numbers = body_numbers(y, m);
        const double* rates = body_numbers(y_dot, m);
        ProbedBody& body = bodies[m];
        body.r = vec3(numbers);
        body.p = vec4(numbers + 3);
        body.A = homogeneous_rotation_matrix(body.p);
        body.r_dot = vec3(numbers + 7);
        body.omega = body.A * vec3(numbers + 10);
        body.r_ddot = vec3(rates + 7);
        body.alpha = body.A * vec3(rates + 10);
    }
}

bool raise_rank(MotionEquations& equations, double t, const double* y) {
    const int left_out = equations.rows_left_out();
    if (!equations.choose_rows(t, y)) { return false; }
    if (equations.rows_left_out() < left_out) { return true; }
    equations.take_back_rows();
    return false;
}

}  // namespace jw
