#include "core/dynamics/motion_equations.hpp"

namespace jw {

bool raise_rank(MotionEquations& equations, double t, const double* y) {
    const int left_out = equations.rows_left_out();
    if (!equations.choose_rows(t, y)) { return false; }
    if (equations.rows_left_out() < left_out) { return true; }
    equations.take_back_rows();
    return false;
}

}  // namespace jw
