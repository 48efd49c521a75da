#include "core/equations/link_equations.hpp"

#include <algorithm>
#include <bit>
#include <iterator>

namespace jw {

namespace {

int equations_of(const LinkPrimitive& primitive) {
    return std::visit([](const auto& p) { return p.kEquations; }, primitive);
}

bool form_is_free(const Joint& joint) {
    return joint.without.empty() &&
           (joint.parallel_form == ParallelForm::rule || joint.parallel_form == ParallelForm::all_three);
}

LinkPrimitive advance_turned(const Joint& joint) {
    const JointGeometry& g = joint.geometry;
    const DisplacementMeasure d = displacement_of(joint);
    if (const std::optional<Wheel> wheel = first_wheel(joint)) {
        return RackTurned{d, *wheel, g.alpha, g.d_0, g.theta_0};
    }
    return ScrewTurned{d, angle_of(joint), g.alpha, g.d_0, g.theta_0};
}

/// Equations with θ that are taken out by hand.
std::vector<EquationOut> thetas_out(const Joint& joint) {
    std::vector<EquationOut> out;
    std::ranges::copy_if(
        joint.without, std::back_inserter(out), [](const EquationOut& e) { return has_theta(e.role); });
    return out;
}

CurveFollowed curve_followed(const Joint& joint) {
    const JointGeometry& g = joint.geometry;
    CurveFollowed out{g.curve, g.P_i_local, g.P_j_local};
    for (const EquationOut& e : thetas_out(joint)) {
        const int component = static_cast<int>(e.role) - static_cast<int>(Role::curve_x);
        out.free_axis = Vec3::Unit(component);
        out.curve.constant(component) = out.curve.linear(component) = 0.0;
        for (Curve::Harmonic& h : out.curve.harmonics) { h.cos(component) = h.sin(component) = 0.0; }
    }
    return out;
}

/// Bit k: component k of a constraint has no row in its link. If one of the two equations of a screw or of
/// wheels is taken out, the other one only determines θ, and no row is left.
unsigned left_out_of(const Constraint& c, const Joint& joint) {
    const auto out = thetas_out(joint).size();
    if (!has_theta(c.role) || out == 0) { return c.left_out(); }
    return joint.type->has_curve() && out == 1 ? 2U : ~0U;
}

/// Primitive of a constraint without its artificial coordinate; none for the row that ties θ to the bodies.
std::optional<LinkPrimitive> link_primitive(const Constraint& c, const Joint& joint) {
    return std::visit(
        [&](const auto& p) -> std::optional<LinkPrimitive> {
            using P = std::decay_t<decltype(p)>;
            if constexpr (std::is_same_v<P, ScrewAdvance>) {
                return advance_turned(joint);
            } else if constexpr (std::is_same_v<P, ScrewAngle>) {
                return std::nullopt;
            } else if constexpr (std::is_same_v<P, OnCurve>) {
                // one primitive has both rows of the curve
                if (c.role != Role::curve_x) { return std::nullopt; }
                return curve_followed(joint);
            } else if constexpr (std::is_same_v<P, Wheel>) {
                if (!is_second_wheel(c.role)) { return std::nullopt; }
                return GearTurned{*first_wheel(joint), p};
            } else {
                return p;
            }
        },
        c.primitive);
}

void append(Link& link, LinkEquation equation) {
    equation.rows = equations_of(equation.primitive) - std::popcount(equation.left_out);
    equation.first_row = link.rows;
    link.rows += equation.rows;
    link.equations.push_back(std::move(equation));
}

/// Link for another equation of a joint: the last one if it belongs to the same joint and has room, else a
/// new one.
Link& link_of_joint(std::vector<Link>& links, const Constraint& c, int rows) {
    if (links.empty() || links.back().joint != c.joint || links.back().rows + rows > kMostRows) {
        links.push_back({c.joint, -1, c.body_i, c.body_j, {}, 0});
    }
    return links.back();
}

Measure without_theta(const Driver& driver, const Mechanism& mechanism) {
    if (!std::holds_alternative<ThetaMeasure>(driver.measure)) { return driver.measure; }
    return angle_of(mechanism.joints[static_cast<std::size_t>(driver.joint)]);
}

}  // namespace

std::vector<Link> links_of(const Mechanism& mechanism) {
    Mechanism paired = mechanism;
    for (Joint& joint : paired.joints) {
        if (form_is_free(joint)) { joint.parallel_form = ParallelForm::pair; }
    }
    const System system(paired, everything(paired));
    std::vector<Link> links;
    for (const Constraint& c : system.constraints()) {
        const Joint& joint = paired.joints[static_cast<std::size_t>(c.joint)];
        std::optional<LinkPrimitive> primitive = link_primitive(c, joint);
        if (!primitive) { continue; }
        const unsigned all = (1U << equations_of(*primitive)) - 1U;
        const unsigned left_out = left_out_of(c, joint) & all;
        if (left_out == all) { continue; }
        const int rows = equations_of(*primitive) - std::popcount(left_out);
        append(link_of_joint(links, c, rows), {std::move(*primitive), -1, left_out, 0, 0});
    }
    for (std::size_t d = 0; d < paired.drivers.size(); ++d) {
        const Driver& driver = paired.drivers[d];
        links.push_back({-1, static_cast<int>(d), driver.body_i, driver.body_j, {}, 0});
        append(
            links.back(),
            {Driven{without_theta(driver, paired), driver.function}, static_cast<int>(d), 0U, 0, 0});
    }
    return links;
}

bool counts_turns(const LinkPrimitive& primitive) {
    return std::visit([](const auto& p) { return CountsTurns<std::decay_t<decltype(p)>>; }, primitive);
}

double up_to_turns(const LinkPrimitive& primitive, double phi) {
    return std::visit(
        [&](const auto& p) {
            if constexpr (CountsTurns<std::decay_t<decltype(p)>>) {
                return p.residual_up_to_turns(phi);
            } else {
                return phi;
            }
        },
        primitive);
}

namespace {

/// Angle whose turns are counted, and its rate.
struct CountedAngle {
    double value;  ///< up to whole turns [rad]
    double rate;
};

template <class J>
CountedAngle counted(const J& jet) {
    return {jet.value(0), jet.rate(0)};
}

template <class Angle>
CountedAngle counted_angle(
    const AdvanceTurned<Angle>& advance, const BodyKinematics<OmegaLocal>& i,
    const BodyKinematics<OmegaLocal>& j) {
    return counted(measured<Content::motion>(advance.angle, i, j, Theta{}));
}

CountedAngle counted_angle(
    const GearTurned& gear, const BodyKinematics<OmegaLocal>& i, const BodyKinematics<OmegaLocal>& j) {
    return counted(measured<Content::motion>(gear.i, i, j, Theta{}));
}

/// The parameter of a curve and its rate.
CountedAngle parameter_at(
    const CurveFollowed& c, double u, const BodyKinematics<OmegaLocal>& i,
    const BodyKinematics<OmegaLocal>& j) {
    const Vec3 c_u = c.curve.at(u).c_u;
    const DisplacementMeasure along{c_u, c.P_i_local, c.P_j_local};
    return {u, measured<Content::motion>(along, i, j, Theta{}).rate(0) / c_u.squaredNorm()};
}

/// Angle of a pose alone, given up to whole turns, with the turns that the rest of the pose determines.
template <class Angle>
double angle_of_pose(
    const AdvanceTurned<Angle>& advance, double turned, const BodyKinematics<OmegaLocal>& i,
    const BodyKinematics<OmegaLocal>& j) {
    const double d = measured<Content::motion>(advance.displacement, i, j, Theta{}).value(0);
    return TurnsSoFar::nearest(turned, advance.theta_of(d));
}

double angle_of_pose(
    const GearTurned& gear, double turned, const BodyKinematics<OmegaLocal>& i,
    const BodyKinematics<OmegaLocal>& j) {
    const double other = measured<Content::motion>(gear.j, i, j, Theta{}).value(0);
    return turned + 2.0 * std::numbers::pi * turns_of_mesh(other - gear.j.ratio * turned, gear.j.ratio);
}

}  // namespace

void tell_turns(
    LinkPrimitive& primitive, Turns turns, double t, const BodyKinematics<OmegaLocal>& i,
    const BodyKinematics<OmegaLocal>& j) {
    std::visit(
        [&](auto& p) {
            using P = std::decay_t<decltype(p)>;
            const bool follows = turns == Turns::of_motion;
            if constexpr (std::is_same_v<P, CurveFollowed>) {
                const Vec3 d = d_local_of(p, i, j);
                const CountedAngle u =
                    parameter_at(p, follows ? p.parameter(d, t) : p.curve.nearest(d), i, j);
                p.so_far = TurnsSoFar{t, u.value, u.rate};
                p.side = p.side_at(p.curve.at(u.value).c_u.normalized());
            } else if constexpr (CountsTurns<P>) {
                const CountedAngle angle = counted_angle(p, i, j);
                double theta = 0.0;
                if (follows && p.so_far) {
                    const TurnsSoFar& before = *p.so_far;
                    theta = TurnsSoFar::nearest(
                        angle.value, before.theta + 0.5 * (before.rate + angle.rate) * (t - before.t));
                } else {
                    theta = angle_of_pose(p, angle.value, i, j);
                }
                p.so_far = TurnsSoFar{t, theta, angle.rate};
            }
        },
        primitive);
}

std::vector<Link> with_drivers_joined(std::vector<Link> links) {
    std::vector<Link> joined;
    for (Link& link : links) {
        const auto host = std::ranges::find_if(joined, [&](const Link& other) {
            return link.joint < 0 && link.body_i == other.body_i && link.body_j == other.body_j &&
                   link.rows + other.rows <= kMostRows;
        });
        if (host == joined.end()) {
            joined.push_back(std::move(link));
            continue;
        }
        for (LinkEquation& equation : link.equations) { append(*host, std::move(equation)); }
    }
    return joined;
}

}  // namespace jw
