#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

/// Tableaux of explicit Runge-Kutta methods.
namespace jw {

/// Tableau of y_new = y + h Σ b_s k_s,  k_s = f(t + c_s h, y + h Σ a_sm k_m).
struct RungeKuttaTable {
    static constexpr int kMostStages = 12;
    using Row = std::array<double, kMostStages>;

    int stages = 0;
    int order = 0;
    std::array<Row, kMostStages> a{};
    Row b{};
    Row c{};
    /// Weights of the error estimate h Σ e_s k_s, zero if the method has none; of an 8(5,3) pair those of
    /// order five.
    Row e{};
    Row e_third{};  ///< weights of order three of an 8(5,3) pair, else zero

    /// True if the last stage is evaluated at the end of the step and is the first stage of the next (FSAL).
    bool is_first_same_as_last() const { return a[static_cast<std::size_t>(stages) - 1] == b; }
};

/// Takes one step of ẏ = f(t, y) by a tableau, independently of the integrators. `f(t, y, y_dot)` fills
/// y_dot.
template <class F>
void take_step(const RungeKuttaTable& table, const F& f, double t, double h, std::vector<double>& y) {
    const auto stages = static_cast<std::size_t>(table.stages);
    std::vector<std::vector<double>> k(stages, std::vector<double>(y.size()));
    const auto moved = [&](const RungeKuttaTable::Row& factors, std::size_t count) {
        std::vector<double> out = y;
        for (std::size_t m = 0; m < count; ++m) {
            for (std::size_t n = 0; n < y.size(); ++n) { out[n] += h * factors[m] * k[m][n]; }
        }
        return out;
    };
    for (std::size_t s = 0; s < stages; ++s) {
        const std::vector<double> at_stage = moved(table.a[s], s);
        f(t + table.c[s] * h, at_stage.data(), k[s].data());
    }
    y = moved(table.b, stages);
}

/// Explicit Euler, order 1.
const RungeKuttaTable& explicit_euler();
/// Classical Runge-Kutta, order 4.
const RungeKuttaTable& runge_kutta_4();
/// Dormand-Prince 5(4).
const RungeKuttaTable& dormand_prince_54();
/// Dormand-Prince 8(5,3) with Hairer's error estimate.
const RungeKuttaTable& dormand_prince_853();

}  // namespace jw
