#include "tests/bench/peers/read_scene.hpp"

#include <algorithm>

#include "core/jets/euler_parameters.hpp"
#include "core/motion/motion_equations.hpp"
#include "tests/reference/stored.hpp"

namespace jw::peers {

namespace {

std::optional<Kind> kind_of(const JointType& type) {
    if (type.name == "revolute") { return Kind::revolute; }
    if (type.name == "prismatic") { return Kind::prismatic; }
    if (type.name == "cylindrical") { return Kind::cylindrical; }
    if (type.name == "universal") { return Kind::universal; }
    if (type.name == "spherical" || type.name == "s") { return Kind::spherical; }
    if (type.name == "fixed") { return Kind::fixed; }
    return std::nullopt;
}

/// A start that satisfies the constraints, as the integrator would begin.
struct Start {
    State state;
    Motion motion;
};

Start projected_start(const Centroidal& centroidal) {
    const auto moving = moving_bodies_of(centroidal.mechanism);
    const auto equations = block_equations(centroidal);
    Start start{start_state(centroidal.mechanism), start_motion(centroidal.mechanism)};
    std::vector<double> y(static_cast<std::size_t>(equations->size()));
    pack(start.state, start.motion, moving, y.data());
    equations->choose_rows(0.0, y.data());
    equations->project(0.0, y.data());
    unpack(y.data(), moving, start.state, start.motion);
    return start;
}

int rank_of(const Centroidal& centroidal, const Start& start) {
    const auto equations = block_equations(centroidal);
    std::vector<double> y(static_cast<std::size_t>(equations->size()));
    pack(start.state, start.motion, moving_bodies_of(centroidal.mechanism), y.data());
    equations->choose_rows(0.0, y.data());
    return equations->rows() - equations->rows_left_out();
}

/// Joint from body i (parent) to body j, or the other way round.
PeerJoint placed(const Joint& joint, const State& state, bool reversed) {
    const auto i = static_cast<std::size_t>(joint.body_i);
    const auto j = static_cast<std::size_t>(joint.body_j);
    const Mat3 A_i = rotation_matrix(state.p[i]);
    const Mat3 A_j = rotation_matrix(state.p[j]);
    PeerJoint out{
        *kind_of(*joint.type),
        joint.body_i,
        joint.body_j,
        state.r[i] + A_i * joint.geometry.P_i_local,
        (A_i * joint.geometry.s_i_local).normalized(),
        (A_j * joint.geometry.s_j_local).normalized()};
    if (reversed) {
        std::swap(out.parent, out.child);
        std::swap(out.axis_parent, out.axis_child);
        if (out.kind == Kind::prismatic || out.kind == Kind::cylindrical) {
            out.point = state.r[j] + A_j * joint.geometry.P_j_local;
        }
    }
    return out;
}

/// Grows the tree from the ground: the nearest body first, ball joints last, since engines close loops with
/// them. The joints that are left over close loops.
void grow_tree(const Mechanism& mechanism, const State& state, PeerScene& scene, std::vector<int>& loops) {
    std::vector<int> depth(mechanism.bodies.size(), -1);
    std::vector<bool> used(mechanism.joints.size(), false);
    for (std::size_t b = 0; b < depth.size(); ++b) {
        if (mechanism.bodies[b].fixed) { depth[b] = 0; }
    }
    const auto depth_of = [&](int b) { return depth[static_cast<std::size_t>(b)]; };
    while (true) {
        int best = -1;
        int best_cost = 0;
        for (std::size_t k = 0; k < used.size(); ++k) {
            const Joint& joint = mechanism.joints[k];
            if (used[k] || (depth_of(joint.body_i) < 0) == (depth_of(joint.body_j) < 0)) { continue; }
            const bool ball = *kind_of(*joint.type) == Kind::spherical;
            const int cost = std::max(depth_of(joint.body_i), depth_of(joint.body_j)) + (ball ? 1000000 : 0);
            if (best < 0 || cost < best_cost) {
                best = static_cast<int>(k);
                best_cost = cost;
            }
        }
        if (best < 0) { break; }
        used[static_cast<std::size_t>(best)] = true;
        const Joint& joint = mechanism.joints[static_cast<std::size_t>(best)];
        const bool reversed = depth_of(joint.body_i) < 0;
        scene.tree.push_back(placed(joint, state, reversed));
        depth[static_cast<std::size_t>(scene.tree.back().child)] = depth_of(scene.tree.back().parent) + 1;
    }
    for (std::size_t b = 0; b < depth.size(); ++b) {
        if (depth[b] < 0) { scene.tree.push_back({Kind::free, 0, static_cast<int>(b)}); }
    }
    for (std::size_t k = 0; k < used.size(); ++k) {
        if (!used[k]) { loops.push_back(static_cast<int>(k)); }
    }
}

/// Adds loads in frames parallel to the global one. @return false if one is of a kind that an engine lacks
bool add_loads(const Loads& loads, const State& state, PeerScene& scene) {
    const auto A = [&](int body) { return rotation_matrix(state.p[static_cast<std::size_t>(body)]); };
    const auto constant = [](const TimeFunction& f) {
        return f.polynomial.size() <= 1 && f.harmonics.empty() && f.steps.empty() && !f.table;
    };
    for (const AppliedForce& f : loads.forces) {
        if (f.law || f.frame != Frame::global || !constant(f.magnitude) || !f.point_local.isZero(0.0)) {
            return false;
        }
        scene.wrenches.push_back({f.body, f.magnitude.at(0.0).f * f.direction, Vec3::Zero()});
    }
    for (const AppliedTorque& t : loads.torques) {
        if (t.law || t.frame != Frame::global || !constant(t.magnitude) || t.against >= 0) { return false; }
        scene.wrenches.push_back({t.body, Vec3::Zero(), t.magnitude.at(0.0).f * t.direction});
    }
    for (const Spring& s : loads.springs) {
        if (s.s_i_local) { return false; }
        scene.springs.push_back(
            {s.body_i, s.body_j, A(s.body_i) * s.P_i_local, A(s.body_j) * s.P_j_local, s.stiffness,
             s.free_length, s.damping});
    }
    return loads.rotational_springs.empty();
}

std::string objection_to(const Lesson& lesson) {
    if (!lesson.dynamics) { return "no dynamics"; }
    if (!lesson.dynamics->point) { return "no point to compare"; }
    if (!lesson.mechanism.drivers.empty()) { return "has drivers"; }
    const auto& bodies = lesson.mechanism.bodies;
    if (std::ranges::count(bodies, true, &Body::fixed) != 1) { return "has more than one fixed body"; }
    for (const Joint& joint : lesson.mechanism.joints) {
        if (!kind_of(*joint.type)) { return "has a joint of type " + std::string(joint.type->name); }
    }
    return {};
}

/// Adds joints that close loops, each with as few equations as suffice: fewer rows are faster.
std::string close_loops(
    const std::vector<int>& loops, const Start& start, Centroidal& centroidal, PeerScene& scene) {
    const int rank = rank_of(centroidal, start);
    for (const int k : loops) {
        Joint& joint = centroidal.mechanism.joints[static_cast<std::size_t>(k)];
        const PeerJoint closing = placed(joint, start.state, false);
        if (closing.kind != Kind::revolute && closing.kind != Kind::universal &&
            closing.kind != Kind::spherical) {
            return "closes a loop with a joint of type " + std::string(joint.type->name);
        }
        const JointType* full = joint.type;
        joint.type = find_joint_type("spherical");
        const bool enough = rank_of(centroidal, start) == rank;
        if (!enough) { joint.type = full; }
        scene.loops.push_back({closing, enough});
    }
    return {};
}

void add_bodies(const Centroidal& centroidal, const Start& start, PeerScene& scene) {
    for (std::size_t b = 0; b < centroidal.mechanism.bodies.size(); ++b) {
        const Mat3 A = rotation_matrix(start.state.p[b]);
        PeerBody body;
        body.name = centroidal.mechanism.bodies[b].name;
        body.r = start.state.r[b];
        if (!centroidal.mechanism.bodies[b].fixed) {
            body.v = start.motion.r_dot[b];
            body.omega = A * start.motion.omega_local[b];
            body.mass = centroidal.loads.masses[b]->mass;
            body.J = A * centroidal.loads.masses[b]->J_local * A.transpose();
        }
        scene.bodies.push_back(body);
    }
}

}  // namespace

std::optional<PeerScene> read_scene(
    const Lesson& lesson, const std::filesystem::path& reference, std::string& why_not) {
    why_not = objection_to(lesson);
    const auto stored = reference::read_trajectory(reference);
    if (why_not.empty() && !stored) { why_not = "no reference " + reference.filename().string(); }
    if (!why_not.empty()) { return std::nullopt; }

    const DynamicsPlan& plan = *lesson.dynamics;
    Centroidal centroidal = jw::centroidal(lesson.mechanism, plan.loads);
    const Start start = projected_start(centroidal);
    PeerScene scene;
    scene.lesson = &lesson;
    scene.name = reference.stem().string();
    scene.gravity = centroidal.loads.gravity;
    scene.duration = plan.duration;
    add_bodies(centroidal, start, scene);
    std::vector<int> loops;
    grow_tree(centroidal.mechanism, start.state, scene, loops);
    why_not = close_loops(loops, start, centroidal, scene);
    if (why_not.empty() && !add_loads(centroidal.loads, start.state, scene)) {
        why_not = "has a load that is not constant at a centre of mass";
    }
    if (!why_not.empty()) { return std::nullopt; }
    const auto body = static_cast<std::size_t>(plan.point->body);
    scene.body = plan.point->body;
    scene.point = start.state.r[body] +
                  rotation_matrix(start.state.p[body]) * (plan.point->point_local - centroidal.centres[body]);
    for (const auto& sample : *stored) { scene.reference.push_back(sample.r.cast<double>()); }
    return scene;
}

}  // namespace jw::peers
