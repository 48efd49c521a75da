#pragma once

#include <stdexcept>

#include "core/motion/dense/dense_equations.hpp"
#include "tests/support/driven.hpp"
#include "tests/support/scenes.hpp"

/// Mechanisms with masses and loads, and states that they can be in.
namespace jw::test {

/// Sizes differ by up to ten times; J' is turned against the body frame, the centre is not at the origin.
inline MassProperties random_mass(Random& random) {
    MassProperties m;
    m.mass = random.number(0.3, 3.0);
    m.centre_local = random.vector(0.3);
    const Mat3 axes = rotation_matrix(random.unit_p());
    const Vec3 moments(random.number(0.05, 0.5), random.number(0.05, 0.5), random.number(0.05, 0.5));
    m.J_local = axes * moments.asDiagonal() * axes.transpose();
    return m;
}

inline std::vector<std::optional<MassProperties>> random_masses(Random& random, const Mechanism& mechanism) {
    std::vector<std::optional<MassProperties>> masses;
    for (const Body& body : mechanism.bodies) {
        masses.push_back(body.fixed ? std::nullopt : std::optional(random_mass(random)));
    }
    return masses;
}

/// Springs without damping between neighbours in the list of bodies and about the first hinge.
inline Loads random_conservative_loads(Random& random, const Mechanism& mechanism) {
    Loads loads;
    loads.masses = random_masses(random, mechanism);
    loads.gravity = random.vector(9.81);
    for (int b = 1; b < static_cast<int>(mechanism.bodies.size()); ++b) {
        loads.springs.push_back(
            {b - 1, b, random.vector(), random.vector(), random.number(1.0, 20.0), random.number(0.2, 1.0),
             0.0});
    }
    if (mechanism.bodies.size() > 1) {
        // along an axis, with numbers of its own, so that others stay what they were
        Random along(static_cast<unsigned>(mechanism.bodies.size()));
        const int last = static_cast<int>(mechanism.bodies.size()) - 1;
        loads.springs.push_back(
            {last - 1, last, along.vector(), along.vector(), along.number(1.0, 20.0), along.number(), 0.0,
             along.direction()});
        loads.bushings.push_back(random_bushing(along, last - 1, last));
        // its torque jumps where the bodies turn by half a turn against each other
        loads.bushings.back().rotational_stiffness.setZero();
    }
    for (const Joint& joint : mechanism.joints) {
        if (joint.type->name != "revolute" && joint.type->name != "cylindrical") { continue; }
        loads.rotational_springs.push_back(
            {joint.body_i, joint.body_j, angle_of(joint), random.number(1.0, 5.0), random.number(-0.5, 0.5),
             0.0});
        break;
    }
    return loads;
}

/// t + Σ sin x of what some springs measure: a distance, a displacement, an angle, and their rates.
inline LoadLaw law_of_all(const Loads& loads) {
    using Kind = FormulaStep::Kind;
    LoadLaw law{{"t", {{Kind::variable, LoadLaw::index_of_time}}}, {}};
    for (const Spring& s : {loads.springs.front(), loads.springs.back()}) {
        law.quantities.push_back({"length", Spring{s.body_i, s.body_j, s.P_i_local, s.P_j_local}});
        std::get<Spring>(law.quantities.back().measured).s_i_local = s.s_i_local;
    }
    for (const RotationalSpring& s : loads.rotational_springs) {
        RotationalSpring angle{s.body_i, s.body_j, s.angle};
        angle.is_read = true;
        law.quantities.push_back({"angle", angle});
    }
    for (std::size_t k = 0; k < law.quantities.size(); ++k) {
        for (const int derivative : {0, 1}) {
            const auto index = static_cast<double>(LoadLaw::index_of(k, derivative));
            law.formula.steps.insert(
                law.formula.steps.end(), {{Kind::variable, index}, {Kind::sine}, {Kind::sum}});
        }
    }
    return law;
}

/// All kinds: dampers, forces and torques in both frames, growing and swinging in time.
inline Loads random_loads(Random& random, const Mechanism& mechanism) {
    Loads loads = random_conservative_loads(random, mechanism);
    for (Spring& spring : loads.springs) {
        spring.damping = random.number(0.0, 2.0);
        spring.friction = {spring.damping, 8.0};
    }
    for (RotationalSpring& spring : loads.rotational_springs) {
        spring.damping = random.number(0.0, 2.0);
        spring.friction = {spring.damping, 9.0};
    }
    for (Bushing& bushing : loads.bushings) { bushing.damping = Vec3(0.3, 1.1, 0.7); }
    for (int b = 0; b < static_cast<int>(mechanism.bodies.size()); ++b) {
        for (const Frame frame : {Frame::global, Frame::local}) {
            loads.forces.push_back({b, random.vector(), random.direction(), frame, random_function(random)});
            loads.torques.push_back({b, random.direction(), frame, random_function(random), b - 1});
        }
    }
    if (!loads.springs.empty()) { loads.forces.back().law = loads.torques.back().law = law_of_all(loads); }
    return loads;
}

/// A joint of every type, each with a body of its own on one of the bodies before; ground is body 0.
inline Mechanism random_tree(Random& random) {
    SceneBuilder scene;
    for (const JointType& type : kJointTypes) {
        const double bodies = static_cast<double>(scene.mechanism.bodies.size());
        const int before = static_cast<int>(random.number(0.0, 0.999 * bodies));
        const int body = scene.add_body(std::string(type.name), random.vector(2.0));
        const Vec3 axis = random.direction();
        if (type.has_distance()) {
            const Vec3 from = random.vector();
            scene.add_link(type.name, before, body, from, random.vector() + Vec3(3.0, 0.0, 0.0), axis);
            continue;
        }
        if (type.has_own_coordinate()) {
            scene.add_any_wheels(type.name, before, body, random.vector(), axis);
            continue;
        }
        Joint& joint = scene.add_joint(type.name, before, body, random.vector(2.0), axis);
        if (type.uses(Role::axes_perpendicular)) {
            joint.geometry.s_j_local = scene.local(body, perpendicular_to(axis));
        }
        joint.geometry.alpha = random.number(0.1, 0.5);
    }
    return scene.mechanism;
}

/// A random tree whose bodies are linked once more, any body with any other: drivers of angles,
/// displacements and distances, single equations and a ball that closes a loop. Almost every link meets on
/// the way to the ground at a body that moves itself.
inline Mechanism random_linked_tree(Random& random) {
    SceneBuilder scene;
    scene.mechanism = random_tree(random);
    const Mechanism tree = scene.mechanism;
    const auto body_count = static_cast<double>(tree.bodies.size());
    const auto any_body = [&] { return static_cast<int>(random.number(0.0, 0.999 * body_count)); };
    const auto any_two = [&] {
        std::pair<int, int> two{any_body(), any_body()};
        while (two.first == two.second) { two.second = any_body(); }
        return two;
    };
    const auto start = [&](const Measure& measure, int i, int j) {
        return evaluate_measure(measure, i, j, -1, start_state(tree), start_motion(tree), zero_motion(tree))
            .value;
    };
    const auto drive = [&](const std::string& name, int joint, int i, int j, const Measure& measure) {
        const double f = start(measure, i, j);
        const bool squared = std::holds_alternative<SquaredDistanceMeasure>(measure);
        scene.mechanism.drivers.push_back(
            {name, joint, i, j, measure,
             polynomial({squared ? std::sqrt(f) : f, random.number(), random.number()})});
    };
    for (int k = 0; k < static_cast<int>(tree.joints.size()); ++k) {
        const Joint& joint = tree.joints[static_cast<std::size_t>(k)];
        const bool turns = joint.type->name == "revolute" || joint.type->name == "cylindrical";
        if (turns) { drive("angle " + joint.name, k, joint.body_i, joint.body_j, angle_of(joint)); }
        const bool shifts = joint.type->name == "prismatic";
        if (shifts) { drive("way " + joint.name, k, joint.body_i, joint.body_j, displacement_of(joint)); }
    }
    const auto [rod_i, rod_j] = any_two();
    drive("rod", -1, rod_i, rod_j, SquaredDistanceMeasure{random.vector(), random.vector()});
    const auto [strut_i, strut_j] = any_two();
    scene.add_distance(strut_i, strut_j, random.vector(2.0), random.vector(2.0) + Vec3(3.0, 0.0, 0.0));
    const auto [n1_i, n1_j] = any_two();
    const Vec3 axis = random.direction();
    scene.add_joint("n1", n1_i, n1_j, random.vector(), axis).geometry.s_j_local =
        scene.local(n1_j, perpendicular_to(axis));
    const auto [ball_i, ball_j] = any_two();
    scene.add_joint("spherical", ball_i, ball_j, random.vector(2.0), random.direction());
    return scene.mechanism;
}

/// Trees with a joint of every type, loops with and without redundant rows, drivers; the whole scene
/// anywhere.
inline std::vector<Mechanism> mechanisms_of_all_kinds(Random& random) {
    std::vector<Mechanism> out{
        random_tree(random),
        four_bar_at(0.7),
        driven(four_bar_at(1.1), 0, 1.5, 0.4),
        bennett(1.0),
        bricard(1.2),
        rssr(0.7),
        cardan(0.5, 0.3),
        double_cardan(0.4, 0.3),
        slider_crank(0.5, 1.5, 0.8),
        driven(slider_crank(0.5, 1.5, 0.8), 0, -2.0),
        screw(0.7, 0.25, ScrewAngleForm::rotation),
        driven(screw(0.7, 0.25, ScrewAngleForm::rotation), 0, 3.0, 1.0),
        planetary_gear(-1.25, 0.3),
        differential(),
        driven(rack_and_pinion(0.4), 0, -2.0)};
    for (Mechanism& mechanism : out) {
        mechanism = moved_rigidly(mechanism, random.unit_p(), random.vector());
    }
    return out;
}

/// State and motion of the centroidal frames.
struct Moment {
    State state;
    Motion motion;
};

/// Flat state of the moving bodies, as the equations of motion use it.
inline std::vector<double> flat_of(const Centroidal& scene, const Moment& moment) {
    const std::vector<int> moving = moving_bodies_of(scene.mechanism);
    std::vector<double> y(kNumbersPerBody * moving.size());
    pack(moment.state, moment.motion, moving, y.data());
    return y;
}

inline std::vector<BodyKinematics<OmegaLocal>> bodies_of(const Moment& moment) {
    std::vector<BodyKinematics<OmegaLocal>> out(moment.state.r.size());
    for (std::size_t b = 0; b < out.size(); ++b) {
        out[b].r = moment.state.r[b];
        out[b].p = moment.state.p[b];
        out[b].A = OmegaLocal::rotation(out[b].p);
        out[b].r_dot = moment.motion.r_dot[b];
        OmegaLocal::set_motion(out[b], moment.motion.omega_local[b]);
    }
    return out;
}

inline std::vector<BodyForce> forces_of(const Loads& loads, const Moment& moment, double t = 0.0) {
    std::vector<BodyForce> out(moment.state.r.size());
    add_forces(loads, bodies_of(moment), t, out);
    return out;
}

/// Near the start pose, on the constraints and moving along them, at time `t`.
inline Moment random_moment(Random& random, const Centroidal& scene, double t, double distance = 0.1) {
    const Mechanism& mechanism = scene.mechanism;
    Moment out{
        disturbed(mechanism, start_state(mechanism), random, distance, distance), zero_motion(mechanism)};
    for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
        if (mechanism.bodies[b].fixed) { continue; }
        out.motion.r_dot[b] = random.vector();
        out.motion.omega_local[b] = random.vector(2.0);
    }
    DenseEquations<OmegaLocal> equations(scene);
    std::vector<double> y(static_cast<std::size_t>(equations.size()));
    equations.pack(out.state, out.motion, y.data());
    // by rows chosen at the start pose: off the constraints none repeats another
    equations.project(t, y.data());
    const auto [position, velocity] = equations.violation(t, y.data());
    if (!(position + velocity < 1e-11)) {
        throw std::runtime_error("no such moment: Newton does not converge");
    }
    equations.unpack(y.data(), out.state, out.motion);
    return out;
}

/// r̈ and ω̇' from ẏ: they stand where ṙ and ω' stand in y.
template <class C>
Motion accelerations_of(
    const DenseEquations<C>& equations, std::vector<double> y, const std::vector<double>& y_dot,
    Moment moment) {
    constexpr std::size_t numbers = DenseEquations<C>::kNumbers;
    for (std::size_t k = 0; k < y.size(); ++k) {
        if (k % numbers >= 7) { y[k] = y_dot[k]; }
    }
    equations.unpack(y.data(), moment.state, moment.motion);
    return moment.motion;
}

/// Accelerations by the dense equations of motion in a coordinate choice.
template <class C>
Motion dense_accelerations(
    const Centroidal& scene, const Moment& moment, double t, const Baumgarte& baumgarte = {}) {
    DenseEquations<C> equations(scene, baumgarte);
    std::vector<double> y(static_cast<std::size_t>(equations.size()));
    std::vector<double> y_dot(y.size());
    equations.pack(moment.state, moment.motion, y.data());
    equations.choose_rows(t, y.data());
    equations.evaluate(t, y.data(), y_dot.data());
    return accelerations_of(equations, y, y_dot, moment);
}

/// Two bodies anywhere, moving anyhow.
struct Pair {
    Mechanism mechanism;
    Moment moment;
};
inline Pair random_pair(unsigned seed) {
    Random random(seed);
    Pair out;
    out.mechanism.bodies = {random_body(random, "i"), random_body(random, "j")};
    out.moment = {start_state(out.mechanism), start_motion(out.mechanism)};
    return out;
}

inline Loads without_loads(const Mechanism& mechanism, unsigned seed) {
    Random random(seed);
    Loads loads;
    loads.masses = random_masses(random, mechanism);
    return loads;
}

}  // namespace jw::test
