#pragma once

#include <nvector/nvector_serial.h>

#include "tests/bench/peers/counted_equations.hpp"

/// Callbacks of SUNDIALS; `user` is the CountedEquations. Status 0 is success, 1 asks for a shorter step.
namespace jw::peers {

int rate_of(double t, N_Vector y, N_Vector y_dot, void* user);
/// Rate for explicit methods, which cannot ask for a shorter step: a value that is not finite becomes so
/// large that no step passes.
int rate_or_huge(double t, N_Vector y, N_Vector y_dot, void* user);
/// f(t, y) - ẏ.
int residual_of(double t, N_Vector y, N_Vector y_dot, N_Vector residual, void* user);
/// 1 / error that a step may make, in the sizes that our own errors are compared with.
int error_weights(N_Vector y, N_Vector weights, void* user);
/// The end of a step, back onto the constraints.
int project_end(double t, N_Vector y, void* user);
/// Projection as CVODE wants it: as a correction.
int correction_of_end(double t, N_Vector y, N_Vector correction, double, N_Vector, void* user);
/// Drops the message: the row of a run says that it failed.
void ignore_message(int, const char*, const char*, char*, void*);

}  // namespace jw::peers
