#pragma once

#include "core/jets/drivers.hpp"

/// A measure in (r, ω') with all terms that velocities and accelerations need.
namespace jw {

struct MeasureJet {
    using Row = Eigen::Matrix<double, 1, 6>;

    double value = 0.0;
    double rate = 0.0;
    double bias = 0.0;       ///< the part of the second derivative that is quadratic in the velocities
    Row by_i = Row::Zero();  ///< gradient by r and turn of body i; zero if the measure depends on neither
    Row by_j = Row::Zero();
    double by_theta = 0.0;
};

/// @param i, j with their motion set
inline MeasureJet jet_of(
    const Measure& measure, const BodyKinematics<OmegaLocal>& i, const BodyKinematics<OmegaLocal>& j,
    Theta theta) {
    return std::visit(
        [&](const auto& m) {
            const auto motion = measured<Content::motion>(m, i, j, theta);
            const auto gradient = measured<Content::jacobian>(m, i, j, theta);
            using J = std::decay_t<decltype(gradient)>;
            MeasureJet out;
            out.value = motion.value(0);
            out.rate = motion.rate(0);
            out.bias = motion.bias(0);
            if constexpr ((J::kSides & kBodyI) != 0) { out.by_i = gradient.block_i; }
            if constexpr ((J::kSides & kBodyJ) != 0) { out.by_j = gradient.block_j; }
            if constexpr ((J::kSides & kTheta) != 0) { out.by_theta = gradient.block_theta(0); }
            return out;
        },
        measure);
}

}  // namespace jw
