#include "core/equations/link_equations.hpp"

#include <algorithm>
#include <bit>

namespace jw {

namespace {

int equations_of(const LinkPrimitive& primitive) {
    return std::visit([](const auto& p) { return p.kEquations; }, primitive);
}

bool form_is_free(const Joint& joint) {
    return joint.without.empty() &&
           (joint.parallel_form == ParallelForm::rule || joint.parallel_form == ParallelForm::all_three);
}

ScrewTurned screw_turned(const Joint& joint) {
    const JointGeometry& g = joint.geometry;
    return {displacement_of(joint), angle_of(joint), g.alpha, g.d_0, g.theta_0};
}

/// Primitive of a constraint without its artificial coordinate; none for the angle row of a screw.
std::optional<LinkPrimitive> link_primitive(const Constraint& c, const Joint& joint) {
    return std::visit(
        [&](const auto& p) -> std::optional<LinkPrimitive> {
            using P = std::decay_t<decltype(p)>;
            if constexpr (std::is_same_v<P, ScrewAdvance>) {
                return screw_turned(joint);
            } else if constexpr (std::is_same_v<P, ScrewAngle>) {
                return std::nullopt;
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
        const int rows = equations_of(*primitive) - std::popcount(c.left_out());
        append(link_of_joint(links, c, rows), {std::move(*primitive), -1, c.left_out(), 0, 0});
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

double up_to_turns(const LinkPrimitive& primitive, double phi) {
    const auto* screw = std::get_if<ScrewTurned>(&primitive);
    return screw != nullptr ? screw->residual_up_to_turns(phi) : phi;
}

void tell_turns(
    LinkPrimitive& primitive, Turns turns, double t, const BodyKinematics<OmegaLocal>& i,
    const BodyKinematics<OmegaLocal>& j) {
    auto* screw = std::get_if<ScrewTurned>(&primitive);
    if (screw == nullptr) { return; }
    const auto angle = measured<Content::motion>(screw->angle, i, j, Theta{});
    const double rate = angle.rate(0);
    double expected = 0.0;
    if (turns == Turns::of_motion && screw->so_far) {
        const TurnsSoFar& before = *screw->so_far;
        expected = before.theta + 0.5 * (before.rate + rate) * (t - before.t);
    } else {
        const double displacement = measured<Content::motion>(screw->displacement, i, j, Theta{}).value(0);
        expected = screw->theta_0 + (displacement - screw->d_0) / screw->alpha;
    }
    const double theta = expected + std::remainder(angle.value(0) - expected, 2.0 * std::numbers::pi);
    screw->so_far = TurnsSoFar{t, theta, rate};
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
