#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <variant>
#include <vector>

#include "core/equations/inlined_visit.hpp"
#include "core/equations/system.hpp"
#include "core/jets/drivers.hpp"

/// Constraint equations for the equations of motion: grouped by the pair of bodies that they link, without
/// artificial coordinates (which have no mass).
namespace jw {

/// Angle including whole turns, at a moment of a motion. Two directions determine their angle only up to
/// whole turns; during a motion the turns are counted by means of the rate.
struct TurnsSoFar {
    double t;      ///< [s]
    double theta;  ///< [rad]
    double rate;   ///< [rad/s]

    /// Angle known up to whole turns [rad], with the number of turns that brings it nearest to `expected`.
    static double nearest(double turned, double expected) {
        return expected + std::remainder(turned - expected, 2.0 * std::numbers::pi);
    }
    double angle_at(double time, double turned) const { return nearest(turned, theta + rate * (time - t)); }
};

/// Screw or rack without its coordinate θ: Φ = (d - d0) - α (θ - θ0) [m], with θ the angle of its bodies.
template <class Angle>
struct AdvanceTurned {
    static constexpr int kEquations = 1;
    DisplacementMeasure displacement;
    Angle angle;
    double alpha;    ///< [m/rad]
    double d_0;      ///< [m]
    double theta_0;  ///< [rad]
    /// Turns of the angle so far; if absent, the number of turns that fits the displacement best is used.
    std::optional<TurnsSoFar> so_far = std::nullopt;

    /// Φ [m] of an advance [m] and an angle known up to whole turns [rad] at time t [s].
    double residual(double advanced, double turned, double t) const {
        const auto missing = [&](double theta) { return advanced - d_0 - alpha * (theta - theta_0); };
        return so_far ? missing(so_far->angle_at(t, turned)) : residual_up_to_turns(missing(turned));
    }
    /// Φ [m] of a pose alone, at most half a turn's displacement.
    double residual_up_to_turns(double phi) const {
        return std::remainder(phi, 2.0 * std::numbers::pi * alpha);
    }
    /// θ that belongs to the displacement [rad].
    double theta_of(double advanced) const { return theta_0 + (advanced - d_0) / alpha; }
};
using ScrewTurned = AdvanceTurned<AngleMeasure>;
using RackTurned = AdvanceTurned<Wheel>;

/// Gear or belt without its coordinate θ: Φ = θ_j - ratio θ_i [rad], with the angles of its wheels, up to
/// whole turns of wheel j.
struct GearTurned {
    static constexpr int kEquations = 1;
    Wheel i;
    Wheel j;
    /// Turns of θ_i so far; if absent, the number of turns that fits θ_j best is used.
    std::optional<TurnsSoFar> so_far = std::nullopt;

    double residual(double turned_i, double turned_j, double t) const {
        if (!so_far) { return residual_up_to_turns(turned_j - j.ratio * turned_i); }
        return std::remainder(turned_j - j.ratio * so_far->angle_at(t, turned_i), 2.0 * std::numbers::pi);
    }
    double residual_up_to_turns(double phi) const {
        constexpr double turn = 2.0 * std::numbers::pi;
        return std::remainder(phi - turn * j.ratio * turns_of_mesh(phi, j.ratio), turn);
    }
};

/// Point of body j on a curve of body i, without its coordinate θ: the two components of d - c(θ) [m]
/// perpendicular to the curve at its nearest point.
struct CurveFollowed {
    static constexpr int kEquations = 2;
    Curve curve;
    Vec3 P_i_local;
    Vec3 P_j_local;
    /// Axis along which the point is free, if that component is taken out by hand: then the curve has no
    /// extent along it, and only the first row counts.
    Vec3 free_axis = Vec3::Zero();
    /// Parameter of the nearest point so far; if absent, the whole curve is searched.
    std::optional<TurnsSoFar> so_far = std::nullopt;
    /// Direction of the first row so far; it is continued without a turn about the curve.
    Vec3 side = Vec3::Zero();

    /// Direction of the first row where the curve has this tangent.
    Vec3 side_at(const Vec3& tangent) const {
        if (!free_axis.isZero(0.0)) { return free_axis.cross(tangent); }
        const Vec3 across = side - side.dot(tangent) * tangent;
        constexpr double clear = 0.3;  // far from parallel to the curve
        return across.norm() > clear ? Vec3(across.normalized()) : perpendicular_to(tangent);
    }
    double parameter(const Vec3& d_local, double t) const {
        if (!so_far) { return curve.nearest(d_local); }
        return curve.followed(d_local, so_far->theta + so_far->rate * (t - so_far->t));
    }
    double residual_up_to_turns(double phi) const { return phi; }
};

/// d in the frame of body i [m], without its part along the free axis.
template <class C>
Vec3 d_local_of(const CurveFollowed& c, const BodyKinematics<C>& i, const BodyKinematics<C>& j) {
    const Vec3 d = i.A.transpose() * (j.r + j.A * c.P_j_local - i.r) - c.P_i_local;
    return d - c.free_axis.dot(d) * c.free_axis;
}

/// The rows of a point on a curve, along directions that follow the curve without turning about it: neither
/// depends on θ to first order, on the curve or beside it. Few scenes have them, so they are not inlined.
template <Content K, class C>
[[gnu::noinline]] auto rows_of(
    const CurveFollowed& c, const BodyKinematics<C>& i, const BodyKinematics<C>& j, double t) {
    const Curve::Point at_u = c.curve.at(c.parameter(d_local_of(c, i, j), t));
    const Vec3 tangent = at_u.c_u.normalized();
    const Vec3 a = c.side_at(tangent);
    const Vec3 b = tangent.cross(a);
    const auto d = vector_between<K>(i, c.P_i_local, j, c.P_j_local);
    auto jet = stacked(dot(arm<K, kBodyI>(i, a), d), dot(arm<K, kBodyI>(i, b), d));
    jet.value(0) -= a.dot(at_u.c);
    jet.value(1) -= b.dot(at_u.c);
    if constexpr (K == Content::motion) {
        // the directions turn towards the tangent as the curve bends
        const double size = at_u.c_u.norm();
        const double along = dot(arm<K, kBodyI>(i, tangent), d).rate(0);
        const double rate = along / size;
        jet.bias(0) -= rate * rate * a.dot(at_u.c_uu);
        jet.bias(1) -= rate * rate * b.dot(at_u.c_uu);
    }
    return jet;
}

/// True for equations whose angles have turns that must be counted.
template <class P>
concept CountsTurns = requires(const P& primitive) {
    primitive.so_far;
};

/// Driver: a measure minus a function of time. θ of a screw is driven as its angle.
struct Driven {
    static constexpr int kEquations = 1;
    Measure measure;
    TimeFunction function;
};

using LinkPrimitive = std::variant<
    N1, N2, N2J, P1, P2, S, Distance, N1Pair, N2Pair, FormulaEquation, ScrewTurned, RackTurned, GearTurned,
    CurveFollowed, Driven>;

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
/// to be switched during a motion. Forms chosen by hand are kept.
inline constexpr int kMostRows = 6;
std::vector<Link> links_of(const Mechanism& mechanism);

/// Moves the rows of drivers into links between the same bodies where these have room.
std::vector<Link> with_drivers_joined(std::vector<Link> links);

/// True if the turns of an equation's angle are counted.
bool counts_turns(const LinkPrimitive& primitive);

/// Φ without whole turns, which a pose does not determine.
double up_to_turns(const LinkPrimitive& primitive, double phi);

/// Source of turns: at a start the pose determines them; after that they are counted by the rates at both
/// ends of a step.
enum class Turns { of_start, of_motion };
/// Sets the turns at `t` [s] from bodies with their motion set; does nothing for primitives that have none.
void tell_turns(
    LinkPrimitive& primitive, Turns turns, double t, const BodyKinematics<OmegaLocal>& i,
    const BodyKinematics<OmegaLocal>& j);

/// Evaluates the rows of a primitive: value and, depending on K, Jacobian or motion. Calls `f(jet, f_dot,
/// f_ddot)`; f_dot and f_ddot are those of a driver's function, else 0.
template <Content K, class C, class F>
void visit_rows(
    const LinkPrimitive& primitive, const BodyKinematics<C>& i, const BodyKinematics<C>& j, double t, F&& f) {
    visit_inlined(
        [&](const auto& p) {
            using P = std::decay_t<decltype(p)>;
            if constexpr (std::is_same_v<P, ScrewTurned> || std::is_same_v<P, RackTurned>) {
                const auto displacement = measured<K>(p.displacement, i, j, Theta{});
                const auto angle = measured<K>(p.angle, i, j, Theta{});
                auto jet = displacement - scaled(p.alpha, angle);
                jet.value(0) = p.residual(displacement.value(0), angle.value(0), t);
                f(jet, 0.0, 0.0);
            } else if constexpr (std::is_same_v<P, CurveFollowed>) {
                f(rows_of<K>(p, i, j, t), 0.0, 0.0);
            } else if constexpr (std::is_same_v<P, GearTurned>) {
                const auto angle_i = measured<K>(p.i, i, j, Theta{});
                const auto angle_j = measured<K>(p.j, i, j, Theta{});
                auto jet = angle_j - scaled(p.j.ratio, angle_i);
                jet.value(0) = p.residual(angle_i.value(0), angle_j.value(0), t);
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
