#pragma once

#include <vector>

#include "core/motion/flat_state.hpp"
#include "tests/reference/general/mechanics.hpp"
#include "tests/support/random_dynamics.hpp"

/// States and accelerations of core (flat, centroidal, double) and of the reference solver (long double).
namespace jw::test {

/// A flat state of core as bodies of the reference.
inline reference::general::PlacedBodies placed_of(
    const Centroidal& scene, const std::vector<double>& flat,
    const reference::general::PlacedBodies& before) {
    reference::general::PlacedBodies placed = before;
    const std::vector<int> moving = moving_bodies_of(scene.mechanism);
    for (std::size_t m = 0; m < moving.size(); ++m) {
        const double* numbers = body_numbers(flat.data(), m);
        auto& body = placed[at(moving[m])];
        body.c = vec3(numbers).cast<long double>();
        body.p = vec4(numbers + 3).cast<long double>().normalized();
        body.A = reference::rotation(body.p);
        body.v = vec3(numbers + 7).cast<long double>();
        body.omega = body.A * vec3(numbers + 10).cast<long double>();
    }
    return placed;
}

/// Accelerations as core expresses them: r̈ of the centres of mass and ω̇'.
inline Motion motion_of(
    const reference::general::Accelerations& a, const reference::general::PlacedBodies& placed) {
    Motion out;
    for (std::size_t b = 0; b < a.v_dot.size(); ++b) {
        out.r_dot.push_back(a.v_dot[b].cast<double>());
        out.omega_local.push_back((placed[b].A.transpose() * a.omega_dot[b]).cast<double>());
    }
    return out;
}

/// Scale of accelerations [1/s²]: the largest one with or without the constraints, at least 1.
inline double size_of(const reference::general::Accelerations& a, double length) {
    long double size = 1.0L;
    for (std::size_t b = 0; b < a.v_dot.size(); ++b) {
        size = std::max(
            {size, a.v_dot[b].norm() / length, a.omega_dot[b].norm(), a.free_v_dot[b].norm() / length,
             a.free_omega_dot[b].norm()});
    }
    return static_cast<double>(size);
}

/// Largest difference of two motions, lengths in units of the scene.
inline double difference_of(const Motion& a, const Motion& b, double length) {
    double most = 0.0;
    for (std::size_t k = 0; k < a.r_dot.size(); ++k) {
        const double way = (a.r_dot[k] - b.r_dot[k]).norm() / length;
        const double turn = (a.omega_local[k] - b.omega_local[k]).norm();
        // NaN counts as a large difference
        if (!(std::max(way, turn) <= most)) {
            most = std::isfinite(way + turn) ? std::max(way, turn) : HUGE_VAL;
        }
    }
    return most;
}

}  // namespace jw::test
