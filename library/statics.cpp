#include "jointwise/statics.hpp"

#include <array>

#include "core/motion/forces.hpp"
#include "core/statics/equilibrium.hpp"
#include "library/convert.hpp"
#include "library/inside.hpp"

namespace jointwise {
inline namespace JOINTWISE_ABI {

namespace {

/// Reasons why a search ended, in the order of RestOutcome::Failure.
constexpr std::array kEnds{
    "",
    "the forces do not change along the motion, and nothing resists them",
    "it is far from the start, or only short steps are proved to stay on the branch",
    "no step along the forces is proved to stay on the branch",
    "a law has no value there",
    "no step decreases the forces"};
static_assert(kEnds.size() == static_cast<std::size_t>(jw::RestOutcome::Failure::no_descent) + 1);

static_assert(static_cast<int>(Stability::unstable) == static_cast<int>(jw::Stability::unstable));
static_assert(static_cast<int>(Stability::not_known) == static_cast<int>(jw::Stability::cannot_tell));
static_assert(static_cast<int>(Seek::nearest) == static_cast<int>(jw::Seek::nearest));

}  // namespace

Equilibrium find_equilibrium(const Mechanism& mechanism, Seek seek) {
    const auto& [inside, loads] = mechanism.inside();
    const jw::Centroidal scene = jw::centroidal(inside, loads);
    const jw::State start = scene.to_centroidal(state_of(inside, assemble(mechanism)));
    const jw::RestOutcome found = jw::find_equilibrium(scene, start, 0.0, static_cast<jw::Seek>(seek));
    if (found.failure != jw::RestOutcome::Failure::none) {
        throw NotReached(
            "jointwise: no equilibrium was found in " + std::to_string(found.steps) +
            " steps: " + kEnds[static_cast<std::size_t>(found.failure)]);
    }
    const jw::Motion still = jw::zero_motion(inside);
    const auto rates = [&](const jw::Motion& motion) {
        return rates_of(scene.as_given(found.state, motion));
    };
    Equilibrium out;
    out.moment = {
        pose_of(scene.as_given(found.state), 0.0), rates_of(still), rates_of(still),
        jw::potential_energy(found.loads, jw::kinematics_of(found.state))};
    out.stability = static_cast<Stability>(found.motions.stability);
    out.freedoms = found.freedoms;
    out.steps = found.steps;
    out.residual = found.residual;
    for (const jw::Mode& mode : found.motions.modes) {
        out.small_motions.push_back({mode.s, rates(mode.shape), rates(mode.shape_late)});
    }
    return out;
}

}  // namespace JOINTWISE_ABI
}  // namespace jointwise
