#include <cstdio>

#include "core/motion/reactions.hpp"
#include "tests/soak/motions.hpp"
#include "tests/soak/property.hpp"
#include "tests/support/generators/to_model.hpp"

namespace jw::test {

namespace {

namespace general = reference::general;

/// Force and torque about the centre of mass that reactions put on every body, global.
struct Pushed {
    std::vector<Vec3> force;
    std::vector<Vec3> torque;
};

Pushed pushed_by(const Reactions& reactions, const general::PlacedBodies& placed) {
    Pushed out{
        std::vector<Vec3>(placed.size(), Vec3::Zero()), std::vector<Vec3>(placed.size(), Vec3::Zero())};
    for (const Reaction& reaction : reactions.reactions) {
        const auto push = [&](int body, double sign) {
            const Vec3 arm = reaction.point - placed[at(body)].c.cast<double>();
            out.force[at(body)] += sign * reaction.wrench.force;
            out.torque[at(body)] += sign * (reaction.wrench.torque + arm.cross(reaction.wrench.force));
        };
        push(reaction.body_j, 1.0);
        push(reaction.body_i, -1.0);
    }
    return out;
}

}  // namespace

Verdict reactions_balance(const Generated& generated) {
    if (!(generated.condition < 1e4)) { return not_asked("too near to a singular pose"); }
    const Centroidal scene = centroidal(generated.mechanism, generated.loads);
    general::Mechanics reference(model_of(generated.mechanism, generated.loads));
    const reference::VecX y = reference.start();
    const general::Accelerations a = reference.accelerations_at(y);
    const general::PlacedBodies placed = reference.bodies_at(y);
    const Reactions reactions = find_reactions(
        scene, 0.0, start_state(scene.mechanism), start_motion(scene.mechanism), motion_of(a, placed));
    const Pushed pushed = pushed_by(reactions, placed);

    // forces of the constraints on every body, by the reference: M (a - M⁻¹ Q)
    double off = 0.0;
    double size = 0.0;
    for (std::size_t b = 0; b < placed.size(); ++b) {
        if (reference.model().bodies[b].fixed) { continue; }
        const general::Body& body = reference.model().bodies[b];
        const reference::Mat3 J = placed[b].A * body.J * placed[b].A.transpose();
        const Vec3 force = (body.mass * (a.v_dot[b] - a.free_v_dot[b])).cast<double>();
        const Vec3 torque = (J * (a.omega_dot[b] - a.free_omega_dot[b])).cast<double>();
        const double length = generated.length;
        off = std::max({off, (pushed.force[b] - force).norm(), (pushed.torque[b] - torque).norm() / length});
        // a scene that nothing moves has no forces but rounding: 1 / s² at least, as in size_of
        const auto accelerated = static_cast<double>(a.v_dot[b].norm() + a.free_v_dot[b].norm());
        const double weight = static_cast<double>(body.mass) * std::max(accelerated, length);
        size = std::max({size, weight, force.norm(), torque.norm() / length});
    }
    for (const Reaction& reaction : reactions.reactions) {
        size = std::max(size, reaction.wrench.force.norm());
    }
    // rounding of a least-squares solution: its condition, and ten for the worst of many. Near a line or a
    // pole a joint's directions are known to rounding divided by the distance from it.
    const double limit = 1e-12 * generated.condition * std::pow(10.0, generated.recipe.near);
    if (off <= limit * size) { return holds(); }
    char text[120];
    std::snprintf(text, sizeof text, "reactions miss Newton and Euler by %.2g of their size", off / size);
    return fails(text);
}

}  // namespace jw::test
