#include "core/integrate/stiffness.hpp"

#include <cmath>

#include "core/integrate/time_stepper.hpp"

namespace jw {

namespace {

// stability limits of DOPRI5 and DOP853 on the negative real axis, a little below 3.3 and 6.2
constexpr double kEdge5 = 3.25;
constexpr double kEdge8 = 6.1;
// on the imaginary axis, where undamped springs and light bodies between heavy ones oscillate, the stability
// limits are smaller; besides, the estimate is a lower bound
constexpr double kPartOfEdge = 0.5;
// weight of a step: about a hundred steps of one kind decide
constexpr double kFading = 0.02;
// share of the scales below which the two states differ by rounding only
constexpr double kRounding = 1e-14;

/// Index of the last stage at the end of the step whose state is not the result itself; 0 if there is none.
std::size_t stage_to_compare(const RungeKuttaTable& table) {
    constexpr double rounding = 1e-12;
    for (auto s = static_cast<std::size_t>(table.stages) - 1; s > 0; --s) {
        if (std::abs(table.c[s] - 1.0) < rounding && table.a[s] != table.b) { return s; }
    }
    return 0;
}

}  // namespace

StiffnessTest::StiffnessTest(const RungeKuttaTable& table) {
    const bool has_estimate = table.e != RungeKuttaTable::Row{};
    if (!has_estimate) { return; }
    stage_ = stage_to_compare(table);
    edge_ = kPartOfEdge * (table.order >= 8 ? kEdge8 : kEdge5);
}

void StiffnessTest::take(
    double h, const std::vector<double>& k_stage, const std::vector<double>& y,
    const std::vector<double>& y_dot, const StateScales& scales) {
    double rates = 0.0;
    double states = 0.0;
    for (std::size_t k = 0; k < y.size(); ++k) {
        const double rate = (y_dot[k] - k_stage[k]) / scales.of(k);
        const double state = (y[k] - y_stage_[k]) / scales.of(k);
        rates += rate * rate;
        states += state * state;
    }
    const double apart = std::sqrt(states);
    const bool at_edge = apart > kRounding && h * std::sqrt(rates) > edge_ * apart;
    share_ += kFading * ((at_edge ? 1.0 : 0.0) - share_);
}

}  // namespace jw
