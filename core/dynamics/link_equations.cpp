#include "core/dynamics/link_equations.hpp"

#include <bit>
#include <stdexcept>

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

/// The primitive of a constraint without its artificial coordinate; nothing for the angle row of a screw.
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

/// Appends to the last link if it is of the same joint and has room, else to a new one.
void append(std::vector<Link>& links, const Link& owner, LinkEquation equation) {
    equation.rows = equations_of(equation.primitive) - std::popcount(equation.left_out);
    const bool fits = !links.empty() && links.back().joint == owner.joint &&
                      links.back().driver == owner.driver && links.back().rows + equation.rows <= kMostRows;
    if (!fits) { links.push_back(owner); }
    Link& link = links.back();
    equation.first_row = link.rows;
    link.rows += equation.rows;
    link.equations.push_back(std::move(equation));
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
        const Link owner{c.joint, -1, c.body_i, c.body_j, {}, 0};
        append(links, owner, {std::move(*primitive), c.left_out(), 0, 0});
    }
    for (std::size_t d = 0; d < paired.drivers.size(); ++d) {
        const Driver& driver = paired.drivers[d];
        const Link owner{-1, static_cast<int>(d), driver.body_i, driver.body_j, {}, 0};
        append(links, owner, {Driven{without_theta(driver, paired), driver.function}, 0U, 0, 0});
    }
    return links;
}

}  // namespace jw
