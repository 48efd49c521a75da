#include <array>

#include "tests/reference/closed_forms.hpp"

namespace jw::reference {

Jacobi jacobi(Real x, Real k) {
    std::array<Real, 16> a{};
    std::array<Real, 16> c{};
    a[0] = 1.0L;
    c[0] = k;
    Real b = std::sqrt((1.0L - k) * (1.0L + k));
    std::size_t n = 0;
    // c halves its digits at every step: 16 are never needed
    while (c[n] > 1e-20L && n + 1 < a.size()) {
        a[n + 1] = (a[n] + b) / 2.0L;
        c[n + 1] = (a[n] - b) / 2.0L;
        b = std::sqrt(a[n] * b);
        ++n;
    }
    // few turns only, so that the amplitude keeps its digits
    const Real period = 2.0L * kPi / a[n];
    x -= period * std::round(x / period);
    Real phi = std::ldexp(a[n] * x, static_cast<int>(n));
    for (; n > 0; --n) { phi = (phi + std::asin(c[n] / a[n] * std::sin(phi))) / 2.0L; }
    const Real sn = std::sin(phi);
    return {sn, std::cos(phi), std::sqrt((1.0L - k * sn) * (1.0L + k * sn))};
}

Real quarter_period(Real k) {
    Real a = 1.0L;
    Real b = std::sqrt((1.0L - k) * (1.0L + k));
    while (std::abs(a - b) > 1e-19L * a) {
        const Real mean = (a + b) / 2.0L;
        b = std::sqrt(a * b);
        if (mean == a) { break; }
        a = mean;
    }
    return kPi / (2.0L * a);
}

Real inverse_sn(Real s, Real c, Real k) {
    // R_F(x, y, z) by duplication: the three differ by a factor of 4 less each time
    Real x = c * c;
    Real y = (1.0L - k * s) * (1.0L + k * s);
    Real z = 1.0L;
    for (int n = 0; n < 40; ++n) {
        const Real shift = std::sqrt(x * y) + std::sqrt(y * z) + std::sqrt(z * x);
        x = (x + shift) / 4.0L;
        y = (y + shift) / 4.0L;
        z = (z + shift) / 4.0L;
    }
    return s / std::sqrt((x + y + z) / 3.0L);
}

}  // namespace jw::reference
