#include "core/motion/carriers.hpp"

#include <algorithm>
#include <cmath>

#include "core/jets/body_kinematics.hpp"
#include "core/numerics/svd.hpp"
#include "core/numerics/variants.hpp"
#include "core/poses/rank.hpp"

namespace jw {

namespace {

using Vec6 = Eigen::Matrix<double, 6, 1>;
using Bodies = std::vector<BodyKinematics<OmegaGlobal>>;

Place place_of_joint(const Joint& joint, const Bodies& bodies) {
    const JointGeometry& g = joint.geometry;
    const auto& i = bodies[at(joint.body_i)];
    const auto& j = bodies[at(joint.body_j)];
    const Vec3 point = j.r + j.A * g.P_j_local;
    if (!joint.type->uses(Role::length)) { return {point, i.A * g.s_i_local}; }
    return {point, point - i.r - i.A * g.P_i_local};
}

Place place_of_driver(const Driver& driver, const Mechanism& mechanism, const Bodies& bodies) {
    if (driver.joint >= 0) { return place_of_joint(mechanism.joints[at(driver.joint)], bodies); }
    const auto& i = bodies[at(driver.body_i)];
    const auto& j = bodies[at(driver.body_j)];
    return std::visit(
        Overloaded{
            [&](const AngleMeasure& m) -> Place {
                return {j.r, i.A * m.s_i_local};
            },
            [&](const DisplacementMeasure& m) -> Place {
                return {j.r + j.A * m.B_j_local, i.A * m.s_i_local};
            },
            [&](const SquaredDistanceMeasure& m) -> Place {
                const Vec3 point = j.r + j.A * m.P_j_local;
                return {point, point - i.r - i.A * m.P_i_local};
            },
            [&](const CoordinateMeasure&) -> Place {
                return {j.r, Vec3::UnitZ()};
            },
            [&](const ThetaMeasure&) -> Place {
                return {j.r, Vec3::UnitZ()};
            },
        },
        driver.measure);
}

/// Block of one row and one body as a force, and as a torque about the body's centre of mass divided by ℓ.
template <class Block>
Vec6 pull_of(const Block& row, double length) {
    Vec6 pull = row.transpose();
    pull.tail<3>() /= length;
    return pull;
}

/// Wrenches of λ = 1 in each row, on body j at the point and on all bodies.
struct Pulls {
    MatrixX wrench;
    MatrixX equilibrium;
    double violation = 0.0;
};
Pulls pulls_of(const Link& link, const Vec3& point, const Situation& s) {
    const auto& i = s.bodies[at(link.body_i)];
    const auto& j = s.bodies[at(link.body_j)];
    Pulls out{MatrixX::Zero(6, link.rows), MatrixX::Zero(s.size, link.rows)};
    VectorX phi = VectorX::Zero(link.rows);
    const auto add = [&](int body, int row, const Vec6& pull) {
        const int first = s.first_of_body[at(body)];
        if (first >= 0) { out.equilibrium.col(row).segment<6>(first) += pull; }
    };
    for (const LinkEquation& equation : link.equations) {
        visit_rows<Content::jacobian>(equation.primitive, i, j, s.t, [&](const auto& jet, double, double) {
            using J = std::decay_t<decltype(jet)>;
            int row = equation.first_row;
            for (int k = 0; k < J::kDim; ++k) {
                if (((equation.left_out >> k) & 1U) != 0) { continue; }
                phi(row) = jet.value(k);
                if constexpr ((J::kSides & kBodyI) != 0) {
                    add(link.body_i, row, pull_of(jet.block_i.row(k), s.length));
                }
                if constexpr ((J::kSides & kBodyJ) != 0) {
                    Vec6 pull = pull_of(jet.block_j.row(k), s.length);
                    add(link.body_j, row, pull);
                    pull.tail<3>() -= (point - j.r).cross(pull.head<3>()) / s.length;
                    out.wrench.col(row) = pull;
                }
                ++row;
            }
        });
    }
    for (Eigen::Index row = 0; row < phi.size(); ++row) {
        const double change = s.length * out.equilibrium.col(row).norm();
        if (change > 0.0) { out.violation = std::max(out.violation, std::abs(phi(row)) / change); }
    }
    return out;
}

}  // namespace

Situation::Situation(const Centroidal& centroidal, double time, const State& state)
    : scene(&centroidal), t(time), length(extent(centroidal.mechanism)) {
    for (std::size_t b = 0; b < state.r.size(); ++b) {
        bodies.push_back(kinematics_at<OmegaGlobal>(state.r[b], state.p[b]));
        const bool fixed = centroidal.mechanism.bodies[b].fixed;
        first_of_body.push_back(fixed ? -1 : static_cast<int>(size));
        size += fixed ? 0 : 6;
    }
}

Place place_of(const Link& link, const Situation& situation) {
    const Mechanism& mechanism = situation.scene->mechanism;
    if (link.joint >= 0) { return place_of_joint(mechanism.joints[at(link.joint)], situation.bodies); }
    return place_of_driver(mechanism.drivers[at(link.driver)], mechanism, situation.bodies);
}

Carrier carrier_of(const Link& link, const Vec3& point, const Situation& situation) {
    const Pulls pulls = pulls_of(link, point, situation);
    // unit columns: the size of a row does not matter
    const VectorX size = pulls.wrench.colwise().norm().transpose();
    const VectorX inverse = (size.array() > 0.0).select(size.cwiseInverse(), 0.0);
    const Svd svd = svd_of(pulls.wrench * inverse.asDiagonal());
    const Eigen::Index rank = svd.rank(kRankThreshold);
    const MatrixX lambda =
        inverse.asDiagonal() * svd.V.leftCols(rank) * svd.sigma.head(rank).cwiseInverse().asDiagonal();
    return {svd.U.leftCols(rank), pulls.equilibrium * lambda, lambda, pulls.violation};
}

}  // namespace jw
