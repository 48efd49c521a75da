#pragma once

#include <array>
#include <span>

/// Explicit Runge-Kutta methods as tables.
namespace jw {

/// y_new = y + h Σ b_s k_s,  k_s = f(t + c_s h, y + h Σ a_sm k_m).
struct RungeKuttaTable {
    static constexpr int kMostStages = 12;
    using Row = std::array<double, kMostStages>;

    int stages = 0;
    int order = 0;
    std::array<Row, kMostStages> a{};
    Row b{};
    Row c{};
    /// Local error h Σ e_s k_s; all zero where the method has none. Of an 8(5,3) pair the fifth-order one.
    Row e{};
    Row e_third{};  ///< third-order error of an 8(5,3) pair, else zero
    bool has_error = false;
};

/// First order.
const RungeKuttaTable& explicit_euler();
/// The classical one of fourth order.
const RungeKuttaTable& runge_kutta_4();
/// Dormand and Prince 5(4).
const RungeKuttaTable& dormand_prince_54();
/// Dormand and Prince 8(5,3), Hairer's error estimate.
const RungeKuttaTable& dormand_prince_853();

}  // namespace jw
