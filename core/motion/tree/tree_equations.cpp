#include "core/motion/tree/tree_equations.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace jw {

namespace {

State start_of(const Mechanism& mechanism, const std::vector<double>& flat) {
    State state = start_state(mechanism);
    Motion ignored = start_motion(mechanism);
    unpack(flat.data(), moving_bodies_of(mechanism), state, ignored);
    return state;
}

/// Links of the cut joints and of the drivers.
std::vector<Link> links_left_by(const JointTree& tree, const Mechanism& mechanism) {
    std::vector<Link> links = links_of(mechanism);
    std::erase_if(links, [&](const Link& link) {
        const bool rigid = mechanism.bodies[at(link.body_i)].fixed && mechanism.bodies[at(link.body_j)].fixed;
        return rigid || (link.joint >= 0 && tree.has_joint(link.joint));
    });
    return links;
}

/// Measure of a driver that prescribes a coordinate of one body, else nullptr. All other equations depend
/// only on the relative pose of their two bodies.
const CoordinateMeasure* coordinate_asked_by(const LinkEquation& equation) {
    const auto* driven = std::get_if<Driven>(&equation.primitive);
    return driven != nullptr ? std::get_if<CoordinateMeasure>(&driven->measure) : nullptr;
}

}  // namespace

TreeEquations::TreeEquations(const Centroidal& scene, const std::vector<double>& start, Registers registers)
    : scene_(&scene),
      extent_(extent(scene.mechanism)),
      moving_(moving_bodies_of(scene.mechanism)),
      tree_(scene, start_of(scene.mechanism, start), registers),
      y_(at(size()), 0.0),
      links_(links_left_by(joints(), scene.mechanism)),
      bodies_(scene.mechanism.bodies.size()),
      needs_motion_(bodies_.size(), false),
      forces_(bodies_.size()) {
    std::vector<bool> pose_counts(bodies_.size(), false);
    const auto mark = [&](const auto& load) { pose_counts[at(load.body)] = true; };
    std::ranges::for_each(scene.loads.forces, mark);
    std::ranges::for_each(scene.loads.torques, mark);
    for (const AppliedTorque& torque : scene.loads.torques) {
        if (torque.against >= 0) { pose_counts[at(torque.against)] = true; }
    }
    const auto mark_both = [&](const auto& both) {
        for (const int body : {both.body_i, both.body_j}) {
            pose_counts[at(body)] = needs_motion_[at(body)] = true;
        }
    };
    std::ranges::for_each(scene.loads.springs, mark_both);
    for_each_angle(scene.loads, mark_both);
    for_each_measuring<Spring>(scene.loads, mark_both);
    std::ranges::for_each(scene.loads.bushings, mark_both);
    std::ranges::for_each(links_, mark_both);
    std::ranges::copy_if(moving_, std::back_inserter(looked_at_), [&](int b) { return pose_counts[at(b)]; });
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const Body& body = scene.mechanism.bodies[b];
        bodies_[b].r = body.r;
        bodies_[b].p = body.p;
        bodies_[b].A = OmegaLocal::rotation(body.p);
    }
    for (const Link& link : links_) {
        for (const LinkEquation& equation : link.equations) {
            counts_turns_ = counts_turns_ || jw::counts_turns(equation.primitive);
            Row row;
            const CoordinateMeasure* asked = coordinate_asked_by(equation);
            needs_p_ = needs_p_ || (asked != nullptr && asked->coordinate >= 3);
            row.node_i = asked != nullptr ? 0 : tree_.node_of(link.body_i);
            row.node_j = tree_.node_of(link.body_j);
            row.path = tree_.path(row.node_i, row.node_j);
            groups_.push_back({&link, &equation, static_cast<int>(rows_.size())});
            for (int k = 0; k < equation.rows; ++k) {
                row.first_e = e_of_rows_.size();
                e_of_rows_.resize(e_of_rows_.size() + row.path.size(), 0.0);
                rows_.push_back(row);
            }
        }
    }
    e_by_D_ = e_of_rows_;
    evaluated_y_.assign(y_.size(), 0.0);
    evaluated_y_dot_ = evaluated_y_;
}

/// Sets the poses of bodies that loads and equations refer to, and their motion if it is needed.
// all calls inlined: calls for products of 3 x 3 matrices would take a fifth of an evaluation with springs
[[gnu::flatten]] void TreeEquations::set_bodies(const double* y) {
    if (needs_p_) { tree_.find_p(y); }
    for (const int b : looked_at_) {
        const Node& node = tree_.node(tree_.node_of(b));
        BodyKinematics<OmegaLocal>& body = bodies_[at(b)];
        body.r = node.centre();
        if (needs_p_) { body.p = node.p; }
        body.A = mat3(node.A);
        if (!needs_motion_[at(b)]) { continue; }
        body.r_dot = node.velocity_of_centre();
        OmegaLocal::set_motion(body, node.omega_local());
    }
}

/// Counts the turns of screws that close loops; those of the tree have their angle as a coordinate.
void TreeEquations::tell_turns_at(Turns turns, double t, const double* y) {
    if (!counts_turns_) { return; }
    place(y);
    set_bodies(y);
    for (Link& link : links_) {
        for (LinkEquation& equation : link.equations) {
            tell_turns(equation.primitive, turns, t, bodies_[at(link.body_i)], bodies_[at(link.body_j)]);
        }
    }
}

void TreeEquations::place(const double* y) const {
    is_evaluated_ = false;
    tree_.place(y);
    tree_.move(y);
}

RowsVerdict TreeEquations::evaluate(double t, const double* y, double* y_dot) {
    place(y);
    set_bodies(y);
    std::ranges::fill(forces_, BodyForce{});
    add_forces(scene_->loads, bodies_, t, forces_);
    tree_.set_inertias_and_wrenches(forces_);
    tree_.fold();
    RowsVerdict verdict;
    if (!rows_.empty()) {
        evaluate_rows(t, kept_groups_);
        factor_rows();
        for (std::size_t k = 0; k < kept_.size(); ++k) {
            const Row& row = rows_[at(kept_[k])];
            lambda_[k] = row.gamma - tree_.drift_along(row.node_i, row.on_i) -
                         tree_.drift_along(row.node_j, row.on_j) - along_row(row);
        }
        add_answer_of_rows();
        verdict = {smallest_pivot_, largest_of_kept_rows(&Row::phi), 0.0};
    }
    tree_.unfold();
    write_rates(y, y_dot);
    std::copy_n(y, size(), evaluated_y_.data());
    evaluated_t_ = t;
    is_evaluated_ = true;
    return verdict;
}

bool TreeEquations::is_evaluated_at(double t, const double* y) const {
    return is_evaluated_ && t == evaluated_t_ && std::equal(evaluated_y_.begin(), evaluated_y_.end(), y);
}

void TreeEquations::stay_at(double t, const double* y) {
    if (!is_evaluated_at(t, y)) { evaluate(t, y, evaluated_y_dot_.data()); }
}

void TreeEquations::motion_of_bodies(
    double t, const double* y, const double* y_dot, std::span<ProbedBody> bodies) {
    stay_at(t, y);
    tree_.accelerate(y_dot + joints().positions());
    if (needs_p_) { tree_.find_p(y); }
    for (std::size_t m = 0; m < bodies.size(); ++m) {
        const Node& node = tree_.node(tree_.node_of(moving_[m]));
        ProbedBody& body = bodies[m];
        const Vec3 arm = vec3(node.own_arm);
        body.r = vec3(node.r) + arm;
        if (needs_p_) { body.p = node.p; }
        body.A = mat3(node.A);
        body.omega = vec3(node.velocity.angular);
        body.r_dot = vec3(node.velocity.linear) + body.omega.cross(arm);
        body.alpha = vec3(node.acceleration.angular) + vec3(node.bias.angular);
        body.r_ddot = vec3(node.acceleration.linear) + vec3(node.bias.linear) + body.alpha.cross(arm) +
                      vec3(node.inwards);
    }
}

/// Moves the tree by random forces, subject to the kept rows.
bool TreeEquations::free_motion(
    double t, const double* y, std::span<const double> drawn, std::span<ProbedBody> bodies) {
    if (velocities() <= static_cast<int>(kept_.size())) {
        for (ProbedBody& body : bodies) { body.free_way = body.free_turn = Vec3::Zero(); }
        return true;
    }
    stay_at(t, y);
    is_evaluated_ = false;
    tree_.set_forces(drawn, extent_);
    for (std::size_t k = 0; k < kept_.size(); ++k) { lambda_[k] = -along_row(rows_[at(kept_[k])]); }
    add_answer_of_rows();
    tree_.unfold();
    for (std::size_t m = 0; m < bodies.size(); ++m) {
        const Node& node = tree_.node(tree_.node_of(moving_[m]));
        const Vec3 turn = vec3(node.acceleration.angular);
        bodies[m].free_way = vec3(node.acceleration.linear) + turn.cross(vec3(node.own_arm));
        bodies[m].free_turn = turn;
    }
    return true;
}

/// Row of E D⁻¹ e.
double TreeEquations::along_row(const Row& row) const {
    double sum = 0.0;
    const double* e_by_D = e_by_D_.data() + row.first_e;
    for (const int u : row.path) { sum += *e_by_D++ * tree_.e()[at(u)]; }
    return sum;
}

void TreeEquations::write_rates(const double* y, double* y_dot) const {
    joints().for_each_part(
        [&](int q, int q_dot) { y_dot[q] = y[q_dot]; },
        [&](int r, int r_dot) { vec3(y_dot + r) = vec3(y + r_dot); },
        [&](int p, int omega) { vec4(y_dot + p) = p_dot_of_omega_local(vec4(y + p), vec3(y + omega)); });
    std::ranges::copy(tree_.u_dot(), y_dot + joints().positions());
}

}  // namespace jw
