#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <variant>
#include <vector>

#include "core/equations/system.hpp"
#include "core/jets/drivers.hpp"

/// Constraint equations for the equations of motion: grouped by the pair of bodies that they link, without
/// artificial coordinates (which have no mass).
namespace jw {

/// Angle of a screw, including whole turns, at a moment of a motion.
struct TurnsSoFar {
    double t;      ///< [s]
    double theta;  ///< [rad]
    double rate;   ///< [rad/s]
};

/// Screw without its coordinate θ: Φ = (d - d0) - α (θ - θ0) [m], with θ the angle from u_i to u_j.
struct ScrewTurned {
    static constexpr int kEquations = 1;
    DisplacementMeasure displacement;
    AngleMeasure angle;
    double alpha;    ///< [m/rad]
    double d_0;      ///< [m]
    double theta_0;  ///< [rad]
    /// Turns of the angle so far. Two directions determine their angle up to whole turns only. During a
    /// motion these are counted from here by the rate; a pose alone has as many as fit its displacement best.
    std::optional<TurnsSoFar> so_far = std::nullopt;

    /// Φ [m] of an advance [m] and an angle known up to whole turns [rad] at time t [s].
    double residual(double advanced, double turned, double t) const;
    /// Φ [m] of a pose alone, at most half a turn's displacement.
    double residual_up_to_turns(double phi) const {
        return std::remainder(phi, 2.0 * std::numbers::pi * alpha);
    }
};

inline double ScrewTurned::residual(double advanced, double turned, double t) const {
    const auto missing = [&](double theta) { return advanced - d_0 - alpha * (theta - theta_0); };
    if (!so_far) { return residual_up_to_turns(missing(turned)); }
    const double expected = so_far->theta + so_far->rate * (t - so_far->t);
    return missing(expected + std::remainder(turned - expected, 2.0 * std::numbers::pi));
}

/// Driver: a measure minus a function of time. θ of a screw is driven as its angle.
struct Driven {
    static constexpr int kEquations = 1;
    Measure measure;
    TimeFunction function;
};

using LinkPrimitive = std::variant<N1, N2, N2J, P1, P2, S, Distance, N1Pair, N2Pair, ScrewTurned, Driven>;

/// Equations of one primitive between two bodies, in the rows of its link from `first_row` on.
struct LinkEquation {
    LinkPrimitive primitive;
    int driver = -1;        ///< index in the mechanism, -1 for an equation of a joint
    unsigned left_out = 0;  ///< bit k: component k has no row
    int first_row = 0;
    int rows = 0;
};

/// Link: rows of a joint (or a driver) between two bodies, which are factored together.
struct Link {
    int joint = -1;   ///< index in the mechanism, -1 for a driver
    int driver = -1;  ///< index in the mechanism, -1 for a joint
    int body_i = 0;
    int body_j = 0;
    std::vector<LinkEquation> equations;
    int rows = 0;
};

/// Converts all joints and drivers to links of at most `kMostRows` rows. p1 and p2 under the rule (or with
/// all three equations) become their n1 / n2 pair, which has condition 1 for every axis, so that no row has
/// to be switched on the way. Forms chosen by hand are kept.
inline constexpr int kMostRows = 6;
std::vector<Link> links_of(const Mechanism& mechanism);

/// Moves the rows of drivers into links between the same bodies where these have room.
std::vector<Link> with_drivers_joined(std::vector<Link> links);

/// Φ without whole turns of a screw, which a pose does not determine.
double up_to_turns(const LinkPrimitive& primitive, double phi);

/// Sets the turns of a screw at `t` [s] from bodies with their motion set; does nothing for other primitives.
/// Source of a screw's turns: at a start the displacement determines them; after that they are counted by the
/// rates at both ends of a step.
enum class Turns { of_start, of_motion };
void tell_turns(
    LinkPrimitive& primitive, Turns turns, double t, const BodyKinematics<OmegaLocal>& i,
    const BodyKinematics<OmegaLocal>& j);

/// Evaluates the rows of a primitive: value and, depending on K, Jacobian or motion. Calls `f(jet, f_dot,
/// f_ddot)`; f_dot and f_ddot are those of a driver's function, else 0.
template <Content K, class C, class F>
void visit_rows(
    const LinkPrimitive& primitive, const BodyKinematics<C>& i, const BodyKinematics<C>& j, double t, F&& f) {
    std::visit(
        [&](const auto& p) {
            using P = std::decay_t<decltype(p)>;
            if constexpr (std::is_same_v<P, ScrewTurned>) {
                const auto displacement = measured<K>(p.displacement, i, j, Theta{});
                const auto angle = measured<K>(p.angle, i, j, Theta{});
                auto jet = displacement - scaled(p.alpha, angle);
                jet.value(0) = p.residual(displacement.value(0), angle.value(0), t);
                f(jet, 0.0, 0.0);
            } else if constexpr (std::is_same_v<P, Driven>) {
                std::visit(
                    [&](const auto& measure) {
                        auto jet = measured<K>(measure, i, j, Theta{});
                        const TimeFunction::Value target = target_of(p.measure, p.function, t);
                        jet.value(0) = driver_residual(p.measure, jet.value(0), target.f);
                        f(jet, target.f_dot, target.f_ddot);
                    },
                    p.measure);
            } else {
                f(equations<K>(p, i, j, Theta{}), 0.0, 0.0);
            }
        },
        primitive);
}

}  // namespace jw
