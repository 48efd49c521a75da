#include "tests/bench/peers/sundials_callbacks.hpp"

#include <algorithm>

namespace jw::peers {

namespace {

constexpr int kDone = 0;
constexpr int kTryShorter = 1;
constexpr double kHuge = 1e100;

double* numbers(N_Vector vector) { return N_VGetArrayPointer(vector); }
CountedEquations& equations(void* user) { return *static_cast<CountedEquations*>(user); }

}  // namespace

int rate_of(double t, N_Vector y, N_Vector y_dot, void* user) {
    return equations(user).evaluate(t, numbers(y), numbers(y_dot)) ? kDone : kTryShorter;
}

int rate_or_huge(double t, N_Vector y, N_Vector y_dot, void* user) {
    if (rate_of(t, y, y_dot, user) != kDone) { N_VConst(kHuge, y_dot); }
    return kDone;
}

int residual_of(double t, N_Vector y, N_Vector y_dot, N_Vector residual, void* user) {
    const int status = rate_of(t, y, residual, user);
    N_VLinearSum(1.0, residual, -1.0, y_dot, residual);
    return status;
}

int error_weights(N_Vector, N_Vector weights, void* user) {
    const CountedEquations& of = equations(user);
    for (int k = 0; k < of.size(); ++k) {
        numbers(weights)[k] = 1.0 / (of.tolerance() * of.scales().of(static_cast<std::size_t>(k)));
    }
    return kDone;
}

int project_end(double t, N_Vector y, void* user) {
    equations(user).project_drifted(t, numbers(y));
    return kDone;
}

int correction_of_end(double t, N_Vector y, N_Vector correction, double, N_Vector, void* user) {
    std::copy_n(numbers(y), equations(user).size(), numbers(correction));
    equations(user).project_drifted(t, numbers(correction));
    N_VLinearSum(1.0, correction, -1.0, y, correction);
    return kDone;
}

void ignore_message(int, const char*, const char*, char*, void*) {}

}  // namespace jw::peers
