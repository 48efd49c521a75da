#pragma once

#include <memory>
#include <vector>

#include "core/motion/loads.hpp"

namespace jw {

/// True if a load depends on whole turns of an angle: they are counted along a motion.
bool depends_on_turns(const Loads& loads);

/// Twists of rotational springs along a motion in which the turns of joints are counted (FollowedAngles): two
/// of its poses may lie several turns of a spring apart.
class SpringTurns {
public:
    /// @param scene may be null
    /// @param begin pose at which the count begins, see begin_turns
    /// @param turns whole turns of every joint there
    SpringTurns(std::shared_ptr<const Centroidal> scene, const State& begin, const std::vector<int>& turns);

    /// The scene at another pose of the motion; null for null.
    std::shared_ptr<const Centroidal> at(const State& state, const std::vector<int>& turns) const;

private:
    struct Turning {
        std::size_t joint = 0;
        int theta = -1;      ///< index of its θ, which includes turns
        double begin = 0.0;  ///< angle at the beginning, with turns [rad]
    };
    double angle_of(const Turning& turning, const State& state, const std::vector<int>& turns) const;

    std::shared_ptr<const Centroidal> scene_;  ///< its springs are twisted as at the beginning
    std::vector<Turning> turning_;             ///< one per angle of for_each_angle
};

}  // namespace jw
