#include "core/motion/start_velocities.hpp"

#include <algorithm>

#include "core/equations/measure_jet.hpp"
#include "core/jets/body_kinematics.hpp"
#include "core/jets/euler_parameters.hpp"
#include "core/motion/flat_state.hpp"
#include "core/numerics/svd.hpp"

namespace jw {

namespace {

// dense free motions of 300 columns take about as long to compute as the motion
constexpr Eigen::Index kMostBodies = 50;
// four typed digits: a difference above their rounding is another velocity
constexpr double kTyped = 1e-4;
// a given velocity that requires others a million times as fast is not kept: the pose is singular for it
constexpr double kFollows = 1e-6;

/// Conditions of the given velocities on the velocities of a flat state: rows * change = missing.
class GivenVelocities {
public:
    GivenVelocities(const Mechanism& given, const Centroidal& scene, const std::vector<double>& y)
        : length_(extent(given)),
          fastest_(fastest_given_velocity(given)),
          order_of_body_(given.bodies.size(), -1) {
        const std::vector<int> moving = moving_bodies_of(given);
        rows_.resize(0, static_cast<Eigen::Index>(6 * moving.size()));
        for (std::size_t m = 0; m < moving.size(); ++m) {
            order_of_body_[at(moving[m])] = static_cast<Eigen::Index>(m);
            add(given.bodies[at(moving[m])], scene.centres[at(moving[m])], body_numbers(y.data(), m),
                static_cast<Eigen::Index>(6 * m));
        }
        const auto [state, motion] = unpacked(scene.mechanism, moving, y.data());
        for (const Joint& joint : scene.mechanism.joints) {
            const JointGeometry& g = joint.geometry;
            if (g.angle_dot_start) { add(joint, angle_of(joint), *g.angle_dot_start, state, motion); }
            if (g.displacement_dot_start) {
                add(joint, displacement_of(joint), *g.displacement_dot_start, state, motion);
            }
        }
    }

    const MatrixX& rows() const { return rows_; }        ///< [conditions, 6 x moving bodies]
    const VectorX& missing() const { return missing_; }  ///< in extents per second and rad/s
    bool has_rates() const { return !rates_.empty(); }

    /// True if each condition is met to the typed digits: velocities of bodies relative to the fastest given
    /// one, a rate relative to itself.
    bool is_met(const VectorX& missing) const {
        const auto rates = static_cast<Eigen::Index>(rates_.size());
        const Eigen::Index of_bodies = missing.size() - rates;
        for (Eigen::Index k = 0; k < rates; ++k) {
            if (!keeps_rate(std::abs(missing(of_bodies + k)), rates_[at(k)], fastest_)) { return false; }
        }
        return (missing.head(of_bodies).cwiseAbs().array() <= kTyped * fastest_).all();
    }

    /// Largest velocity of a body in a motion, in the same units.
    double fastest_in(const VectorX& six) const {
        double fastest = 0.0;
        for (Eigen::Index b = 0; b < six.size(); b += 6) {
            fastest = std::max({fastest, six.segment<3>(b).norm() / length_, six.segment<3>(b + 3).norm()});
        }
        return fastest;
    }

private:
    /// Appends `count` zero rows. @return index of the first one
    Eigen::Index next(Eigen::Index count) {
        const Eigen::Index first = missing_.size();
        rows_.conservativeResize(first + count, Eigen::NoChange);
        rows_.bottomRows(count).setZero();
        missing_.conservativeResize(first + count);
        return first;
    }

    /// Adds the conditions of a body, whose six columns begin with `first`.
    void add(const Body& body, const Vec3& centre, const double* numbers, Eigen::Index first) {
        const Vec3 omega_local = vec3(numbers + 10);
        if (!body.omega_local.isZero(0.0)) {
            const Eigen::Index row = next(3);
            rows_.block<3, 3>(row, first + 3).setIdentity();
            missing_.segment<3>(row) = body.omega_local - omega_local;
        }
        if (!body.r_dot.isZero(0.0)) {
            // in the frame as given, the centre moves by ω × A c in addition
            const Mat3 by_turning = rotation_matrix(vec4(numbers + 3)) * tilde(centre);
            const Eigen::Index row = next(3);
            rows_.block<3, 3>(row, first) = Mat3::Identity() / length_;
            rows_.block<3, 3>(row, first + 3) = by_turning / length_;
            missing_.segment<3>(row) = (body.r_dot - vec3(numbers + 7) - by_turning * omega_local) / length_;
        }
    }

    /// Adds the condition that a measure of a joint has the given rate.
    void add(
        const Joint& joint, const Measure& measure, double rate, const State& state, const Motion& motion) {
        const auto body = [&](int b) {
            return kinematics_at<OmegaLocal>(
                state.r[at(b)], state.p[at(b)], motion.r_dot[at(b)], motion.omega_local[at(b)]);
        };
        const MeasureJet jet = jet_of(measure, body(joint.body_i), body(joint.body_j), Theta{});
        const double unit = unit_of(measure, length_);
        const Eigen::Index row = next(1);
        const auto put = [&](int b, const MeasureJet::Row& by) {
            const Eigen::Index order = order_of_body_[at(b)];
            if (order >= 0) { rows_.block<1, 6>(row, 6 * order) = by / unit; }
        };
        put(joint.body_i, jet.by_i);
        put(joint.body_j, jet.by_j);
        missing_(row) = (rate - jet.rate) / unit;
        rates_.push_back(std::abs(rate) / unit);
    }

    double length_;
    double fastest_;                           ///< largest given velocity
    std::vector<Eigen::Index> order_of_body_;  ///< index among the moving bodies; -1 for a fixed one
    MatrixX rows_;
    VectorX missing_;
    std::vector<double> rates_;  ///< sizes of the given rates of joints, which are the last conditions
};

}  // namespace

double fastest_given_velocity(const Mechanism& mechanism) {
    const double length = extent(mechanism);
    double fastest = 0.0;
    for (const Body& body : mechanism.bodies) {
        fastest = std::max({fastest, body.r_dot.norm() / length, body.omega_local.norm()});
    }
    for (const Joint& joint : mechanism.joints) {
        const JointGeometry& g = joint.geometry;
        fastest = std::max(
            {fastest, std::abs(g.angle_dot_start.value_or(0.0)),
             std::abs(g.displacement_dot_start.value_or(0.0)) / length});
    }
    return fastest;
}

void keep_given_velocities(
    const Mechanism& given, const Centroidal& scene, DrivableEquations& equations, std::vector<double>& y) {
    const GivenVelocities asked(given, scene, y);
    const Eigen::Index bodies = asked.rows().cols() / 6;
    if (asked.missing().size() == 0 || asked.is_met(asked.missing())) { return; }
    if (bodies > (asked.has_rates() ? kMostBodiesWithRates : kMostBodies)) { return; }
    const MatrixX free = equations.free_motions(0.0, y.data());
    if (free.cols() == 0) { return; }
    // each singular vector is a motion that changes one combination of the conditions, and the shortest such
    // motion, since free motions are orthonormal in their metric
    const Svd svd = svd_of(asked.rows() * free);
    VectorX six = VectorX::Zero(free.rows());
    for (Eigen::Index k = 0; k < svd.sigma.size(); ++k) {
        const VectorX motion = free * svd.V.col(k);
        if (svd.sigma(k) <= kFollows * asked.fastest_in(motion)) { continue; }
        six += svd.U.col(k).dot(asked.missing()) / svd.sigma(k) * motion;
    }
    if (!asked.has_rates() && !asked.is_met(asked.rows() * six - asked.missing())) { return; }
    for (std::size_t m = 0; 6 * m < at(six.size()); ++m) {
        double* rates = body_numbers(y.data(), m) + 7;
        for (std::size_t k = 0; k < 6; ++k) { rates[k] += six(static_cast<Eigen::Index>(6 * m + k)); }
    }
}

}  // namespace jw
