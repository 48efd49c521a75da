#include <array>

#include "tests/reference/closed_forms.hpp"

namespace jw::reference {

Jacobi jacobi(Real x, const Modulus& modulus) {
    std::array<Real, 16> a{};
    std::array<Real, 16> c{};
    a[0] = 1.0L;
    c[0] = modulus.k;
    Real b = modulus.k_prime;
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
    const Real cn = std::cos(phi);
    return {std::sin(phi), cn, std::hypot(modulus.k_prime, modulus.k * cn)};
}

Real quarter_period(const Modulus& modulus) {
    Real a = 1.0L;
    Real b = modulus.k_prime;
    while (std::abs(a - b) > 1e-19L * a) {
        const Real mean = (a + b) / 2.0L;
        b = std::sqrt(a * b);
        if (mean == a) { break; }
        a = mean;
    }
    return kPi / (2.0L * a);
}

Real inverse_sn(Real s, Real c, const Modulus& modulus) {
    // R_F(x, y, z) by duplication: the three differ by a factor of 4 less each time
    Real x = c * c;
    Real y = modulus.k_prime * modulus.k_prime + modulus.k * modulus.k * c * c;
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
