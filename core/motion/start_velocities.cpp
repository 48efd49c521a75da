#include "core/motion/start_velocities.hpp"

#include <algorithm>

#include "core/jets/euler_parameters.hpp"
#include "core/motion/flat_state.hpp"
#include "core/numerics/svd.hpp"

namespace jw {

namespace {

constexpr Eigen::Index kMostColumns = 300;
// four typed digits: a difference above their rounding is another velocity
constexpr double kTyped = 1e-4;
// a given velocity that requires others a million times as fast is not kept: the pose is singular for it
constexpr double kFollows = 1e-6;

/// Conditions of the given velocities on the velocities of a flat state: rows * change = missing.
struct GivenVelocities {
    MatrixX rows;     ///< [3 x given vectors, 6 x moving bodies]
    VectorX missing;  ///< in extents per second and rad/s
    double fastest = 0.0;
};

GivenVelocities given_velocities(
    const Mechanism& given, const Centroidal& scene, const std::vector<double>& y) {
    const std::vector<int> moving = moving_bodies_of(given);
    const double length = extent(given);
    const auto columns = static_cast<Eigen::Index>(6 * moving.size());
    GivenVelocities out{MatrixX::Zero(columns, columns), VectorX::Zero(columns)};
    Eigen::Index count = 0;
    for (std::size_t m = 0; m < moving.size(); ++m) {
        const Body& body = given.bodies[at(moving[m])];
        const double* numbers = body_numbers(y.data(), m);
        const Vec3 r_dot = vec3(numbers + 7);
        const Vec3 omega_local = vec3(numbers + 10);
        const auto first = static_cast<Eigen::Index>(6 * m);
        if (!body.omega_local.isZero(0.0)) {
            out.rows.block<3, 3>(count, first + 3).setIdentity();
            out.missing.segment<3>(count) = body.omega_local - omega_local;
            out.fastest = std::max(out.fastest, body.omega_local.norm());
            count += 3;
        }
        if (!body.r_dot.isZero(0.0)) {
            // in the frame as given, the centre moves by ω × A c in addition
            const Mat3 by_turning = rotation_matrix(vec4(numbers + 3)) * tilde(scene.centres[at(moving[m])]);
            out.rows.block<3, 3>(count, first) = Mat3::Identity() / length;
            out.rows.block<3, 3>(count, first + 3) = by_turning / length;
            out.missing.segment<3>(count) = (body.r_dot - r_dot - by_turning * omega_local) / length;
            out.fastest = std::max(out.fastest, body.r_dot.norm() / length);
            count += 3;
        }
    }
    out.rows.conservativeResize(count, columns);
    out.missing.conservativeResize(count);
    return out;
}

}  // namespace

void keep_given_velocities(
    const Mechanism& given, const Centroidal& scene, DrivableEquations& equations, std::vector<double>& y) {
    const GivenVelocities asked = given_velocities(given, scene, y);
    const double allowed = kTyped * asked.fastest;
    const auto is_met = [&](const VectorX& missing) { return missing.lpNorm<Eigen::Infinity>() <= allowed; };
    if (asked.missing.size() == 0 || asked.rows.cols() > kMostColumns || is_met(asked.missing)) { return; }
    const MatrixX free = equations.free_motions(0.0, y.data());
    if (free.cols() == 0) { return; }
    const MatrixX of_free = asked.rows * free;
    const Svd svd = svd_of(of_free);
    const Eigen::Index rank = svd.rank(kFollows * svd.sigma(0));
    // the shortest combination of free motions, which are orthonormal in that metric
    const VectorX along = svd.U.leftCols(rank).transpose() * asked.missing;
    const VectorX change = svd.V.leftCols(rank) * along.cwiseQuotient(svd.sigma.head(rank));
    if (!is_met(of_free * change - asked.missing)) { return; }
    const VectorX six = free * change;
    for (std::size_t m = 0; 6 * m < at(six.size()); ++m) {
        double* rates = body_numbers(y.data(), m) + 7;
        for (std::size_t k = 0; k < 6; ++k) { rates[k] += six(static_cast<Eigen::Index>(6 * m + k)); }
    }
}

}  // namespace jw
