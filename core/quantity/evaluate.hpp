#pragma once

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "core/motion/forces.hpp"
#include "core/motion/reactions.hpp"
#include "core/poses/rank.hpp"
#include "core/quantity/quantity.hpp"

/// Quantities at an instant; they are evaluated only here.
namespace jw {

/// Known state of a mechanism at one time. Expensive results are computed once, when first requested.
class Instant {
public:
    double t = 0.0;  ///< [s]
    std::shared_ptr<const System> system;
    State state;
    Motion velocity;
    /// Whole turns that every joint has made in the motion (FollowedAngles); empty: only a pose is known, and
    /// angles lie in (-π, π].
    std::vector<int> turns;
    std::optional<Motion> acceleration;  ///< nothing: not known, so second derivatives are missing
    /// Masses and forces, if there are any.
    std::shared_ptr<const Centroidal> scene;
    /// r̈, ω̇' of the centroidal frames; nothing: computed from `acceleration`.
    std::optional<Motion> centroidal_acceleration;
    /// Energies as summed by the run of this instant; if absent, they are computed from the state.
    std::optional<Energy> energy;

    const RankReport& rank() const;
    /// @throws std::logic_error without a scene or an acceleration
    const Reactions& reactions() const;
    /// @throws std::logic_error without a scene
    Energy find_energy() const;
    /// Acceleration of the centroidal frames. @throws std::logic_error without a scene or an acceleration
    Motion find_centroidal_acceleration() const;

private:
    mutable std::optional<RankReport> rank_;
    mutable std::optional<Reactions> reactions_;
};

/// Why a quantity does not have a value, or a derivative.
enum class Absence {
    none,
    no_masses,        ///< the instant has no scene
    no_acceleration,  ///< the acceleration at the instant is not known
    no_derivative,    ///< the derivative does not exist, or is not computed
    not_unique,       ///< redundant equations leave it undetermined
    not_there,        ///< its joint or driver does not take part
    no_motion_of_it,  ///< reactions cannot balance the loads: the pose is not part of the motion
    rank_lost,        ///< a pair that has lost rank has no condition
    singular          ///< the rate of a root does not exist at 0
};

/// A quantity with its rate and acceleration; NaN where one is missing.
struct QuantityValue {
    static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    std::array<double, 3> derivatives{kNone, kNone, kNone};
    std::array<Absence, 3> absences{Absence::none, Absence::no_derivative, Absence::no_derivative};

    double value() const { return derivatives[0]; }
    double rate() const { return derivatives[1]; }
    double acceleration() const { return derivatives[2]; }
};

/// @param highest  highest derivative that is needed: higher ones may be left out
QuantityValue evaluate(const Quantity& quantity, const Instant& instant, int highest = 2);

}  // namespace jw
