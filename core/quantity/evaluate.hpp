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

/// Quantities at an instant: the one place where they are evaluated.
namespace jw {

/// Known state of a mechanism at one time. Expensive results are computed when first asked for, once.
class Instant {
public:
    double t = 0.0;  ///< [s]
    std::shared_ptr<const System> system;
    State state;
    Motion velocity;
    /// Whole turns of every joint that the motion has made (FollowedAngles); empty: only a pose is known, and
    /// angles lie in (-π, π].
    std::vector<int> turns;
    std::optional<Motion> acceleration;  ///< nothing: not known, so there are no second derivatives
    /// Masses and forces, if there are any.
    std::shared_ptr<const Centroidal> scene;
    /// r̈, ω̇' of the centroidal frames; nothing: found from `acceleration`.
    std::optional<Motion> centroidal_acceleration;
    /// Energies as the run of this instant summed them; if absent they are computed from the state.
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

/// Why a quantity has no value, or no derivative.
enum class Absence {
    none,
    no_masses,        ///< the instant has no scene
    no_acceleration,  ///< nothing says how it moves on
    no_derivative,    ///< it has none, or none that is found
    not_unique,       ///< equations that repeat each other leave it open
    not_there,        ///< its joint or driver takes no part
    no_motion_of_it,  ///< a reaction that does not hold the motion: the pose is none of it
    rank_lost,        ///< a pair that has lost rank has no condition
    singular          ///< a root of 0 has no rate
};

/// A quantity with its rate and acceleration; NaN where there is none.
struct QuantityValue {
    static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    std::array<double, 3> derivatives{kNone, kNone, kNone};
    std::array<Absence, 3> absences{Absence::none, Absence::no_derivative, Absence::no_derivative};

    double value() const { return derivatives[0]; }
    double rate() const { return derivatives[1]; }
    double acceleration() const { return derivatives[2]; }
};

/// @param highest derivative that is asked for: others may be left out
QuantityValue evaluate(const Quantity& quantity, const Instant& instant, int highest = 2);

}  // namespace jw
