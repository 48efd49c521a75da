#include <algorithm>
#include <cstdio>
#include <optional>

#include "tests/soak/motions.hpp"
#include "tests/soak/property.hpp"
#include "tests/soak/ways.hpp"
#include "tests/support/generators/to_model.hpp"

/// Trees that drivers move: the pose of every body is the product of the motions of its joints.
namespace jw::test {

namespace {

namespace general = reference::general;
using reference::Real;

constexpr double kDuration = 0.3;
// positions and velocities of every joint are within the tolerance of 1e-9 at samples (docs/dynamics.md);
// arms of six bodies in a row and rates within a step multiply that: up to 1e-7 was seen
constexpr double kAllowed = 1e-6;

/// Change of the angle or displacement of a driver since the start, and its rate.
struct Added {
    Real way = 0.0L;
    Real rate = 0.0L;
};

Added added_by(const general::TimeFunction& f, Real t) {
    const general::Taylor now = general::time_function(f, t);
    return {now.value - general::time_function(f, 0.0L).value, now.rate};
}

/// Turn about the axis of a joint and shift along it.
struct JointMotion {
    Added turn;
    Added shift;
};

/// @return nothing where a freedom of the joint is not driven
std::optional<JointMotion> motion_of_joint(const Mechanism& mechanism, int joint, Real t) {
    JointMotion out;
    int freedoms = mechanism.joints[at(joint)].type->dof;
    for (const Driver& driver : mechanism.drivers) {
        if (driver.joint != joint) { continue; }
        --freedoms;
        const Added added = added_by(equation_of_driver(mechanism, driver, 0).target, t);
        (std::holds_alternative<DisplacementMeasure>(driver.measure) ? out.shift : out.turn) = added;
    }
    if (freedoms != 0) { return std::nullopt; }
    const JointGeometry& g = mechanism.joints[at(joint)].geometry;
    // the generator drives the turn of a nut; its way along the thread follows
    if (mechanism.joints[at(joint)].type->name == "screw") {
        const Real alpha = g.alpha;
        out.shift = {alpha * out.turn.way, alpha * out.turn.rate};
    }
    return out;
}

/// Pose and velocities of a body at its origin rather than its centre of mass.
struct Limb {
    reference::Vec3 r = reference::Vec3::Zero();
    reference::Vec3 v = reference::Vec3::Zero();
    reference::Vec3 omega = reference::Vec3::Zero();
    reference::Mat3 A = reference::Mat3::Identity();
};

Limb start_of(const Body& body) {
    Limb out;
    out.r = body.r.cast<long double>();
    out.A = reference::rotation(body.p.cast<long double>());
    return out;
}

/// A(t) = A_i(t) · turn · A_iᵀ(0) A_j(0), and likewise the origin, about the point of the joint on body i.
Limb carried(
    const Limb& on, const Limb& on_start, const Limb& own_start, const Joint& joint, const JointMotion& m) {
    const reference::Vec3 s = joint.geometry.s_i_local.cast<long double>().normalized();
    const reference::Vec3 P = joint.geometry.P_i_local.cast<long double>();
    const reference::Mat3 turn = reference::rotation(reference::turn(s, m.turn.way));
    const reference::Vec3 before = on_start.A.transpose() * (own_start.r - on_start.r);
    const reference::Vec3 from_P = on.A * (turn * (before - P) + m.shift.way * s);
    const reference::Vec3 axis = on.A * s;
    Limb out;
    out.A = on.A * turn * (on_start.A.transpose() * own_start.A);
    out.r = on.r + on.A * P + from_P;
    out.omega = on.omega + m.turn.rate * axis;
    out.v = on.v + on.omega.cross(out.r - on.r) + m.turn.rate * axis.cross(from_P) + m.shift.rate * axis;
    return out;
}

/// @return nothing where a freedom is not driven
std::optional<general::PlacedBodies> expected_at(const Generated& generated, Real t) {
    const Mechanism& mechanism = generated.mechanism;
    if (mechanism.joints.size() + 1 != mechanism.bodies.size()) { return std::nullopt; }
    std::vector<Limb> limbs{start_of(mechanism.bodies[0])};
    general::PlacedBodies out(mechanism.bodies.size());
    for (std::size_t k = 0; k < mechanism.joints.size(); ++k) {
        const Joint& joint = mechanism.joints[k];
        const auto motion = motion_of_joint(mechanism, static_cast<int>(k), t);
        if (!motion) { return std::nullopt; }
        const std::size_t i = at(joint.body_i);
        limbs.push_back(carried(
            limbs[i], start_of(mechanism.bodies[i]), start_of(mechanism.bodies[k + 1]), joint, *motion));
        const Limb& limb = limbs.back();
        const reference::Vec3 centre = generated.loads.masses[k + 1]->centre_local.cast<long double>();
        general::Placed& placed = out[k + 1];
        placed.A = limb.A;
        placed.c = limb.r + limb.A * centre;
        placed.omega = limb.omega;
        placed.v = limb.v + limb.omega.cross(limb.A * centre);
    }
    return out;
}

double apart(const general::PlacedBodies& found, const general::PlacedBodies& expected, double length) {
    Real fastest = 1.0L;
    for (const general::Placed& body : expected) {
        fastest = std::max({fastest, body.v.norm() / length, body.omega.norm()});
    }
    double most = 0.0;
    for (std::size_t b = 1; b < found.size(); ++b) {
        const general::Placed& a = found[b];
        const general::Placed& e = expected[b];
        const Real pose = std::max((a.c - e.c).norm() / length, (a.A - e.A).norm());
        const Real rate = std::max((a.v - e.v).norm() / length, (a.omega - e.omega).norm()) / fastest;
        const auto here = static_cast<double>(std::max(pose, rate));
        if (!(here <= most)) { most = std::isfinite(here) ? here : HUGE_VAL; }
    }
    return most;
}

/// Says where the run ends early, or by how much it is off.
std::string wrong_by(const Generated& generated, Way way, const std::vector<double>& times) {
    way.settings.tolerance = 1e-9;
    way.settings.most_steps = 20000;
    Simulation simulation(generated.mechanism, generated.loads, way.settings);
    double most = 0.0;
    const auto outcome = simulation.run(times, [&](double t, const std::vector<double>& y) {
        const general::PlacedBodies expected = *expected_at(generated, t);
        most = std::max(most, apart(placed_of(simulation.scene(), y, expected), expected, generated.length));
    });
    if (!outcome.failure && most <= kAllowed) { return ""; }
    char text[160];
    std::snprintf(text, sizeof text, "%s is %.2g of the scene off", way.name.c_str(), most);
    return outcome.failure ? way.name + " ends at " + std::to_string(outcome.failure->t) + " s" : text;
}

}  // namespace

Recipe driven_tree(Recipe recipe) {
    recipe = without_rows_by_hand(recipe);
    recipe.joints.clear();
    recipe.drivers.clear();
    recipe.drive_all = true;
    recipe.afloat = false;
    for (BodyRecipe& body : recipe.bodies) {
        const int number = std::max(0, body.joint);
        // numbers of kJointTypes, and of those that the families allow
        constexpr int first = 2;  // revolute, cylindrical, prismatic, screw, fixed
        constexpr int count = 5;
        const bool is_known = number >= first && number < first + count;
        body.joint = recipe.family == Family::planar       ? number % 3
                     : recipe.family == Family::concurrent ? 0
                     : is_known                            ? number
                                                           : first + number % count;
    }
    return recipe;
}

Verdict joints_multiply(const Generated& generated) {
    if (!expected_at(generated, 0.0L)) { return not_asked("something is left free"); }
    const std::vector<double> times = with_events(generated, {0.0, 0.1, 0.2, kDuration});
    for (const Way& way : ways()) {
        const std::string wrong = wrong_by(generated, way, times);
        if (!wrong.empty()) { return fails(wrong); }
    }
    return holds();
}

}  // namespace jw::test
