#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/motion/dense/dense_equations.hpp"
#include "core/motion/reactions.hpp"
#include "tests/hard/cases.hpp"
#include "tests/hard/dynamic_scene.hpp"
#include "tests/hard/shipped.hpp"

namespace jw::hard {

namespace {

/// Rows, in the given order, that the rows before them do not imply.
std::vector<int> pick(const MatrixX& jacobian, std::vector<int> order) {
    std::vector<int> rows;
    std::vector<VectorX> directions;
    for (const int row : order) {
        VectorX rest = jacobian.row(row).transpose();
        const double size = rest.norm();
        for (int twice = 0; twice < 2; ++twice) {
            for (const VectorX& d : directions) { rest -= d.dot(rest) * d; }
        }
        if (rest.norm() < 1e-9 * size) { continue; }
        directions.push_back(rest.normalized());
        rows.push_back(row);
    }
    return rows;
}

/// Wrenches of the joints on their bodies j, from λ with these rows (slide 25).
std::vector<Wrench> wrenches_with(
    std::vector<int> rows, const DenseEquations<OmegaGlobal>& e, const Reactions& joints,
    const State& state) {
    SaddlePoint saddle_point(scaling_of<OmegaGlobal>(e.system()));
    saddle_point.keep(std::move(rows));
    saddle_point.factor(e.mass_matrix(), e.jacobian());
    VectorX acceleration;
    VectorX lambda;
    saddle_point.solve(e.force(), e.right_side(), acceleration, lambda);

    std::vector<Wrench> out;
    for (const Reaction& reaction : joints.reactions) {
        const bool on_j = e.system().body_column(reaction.body_j, 3) >= 0;
        const int body = on_j ? reaction.body_j : reaction.body_i;
        Eigen::Matrix<double, 6, 1> six = Eigen::Matrix<double, 6, 1>::Zero();
        for (const Constraint& c : e.system().constraints()) {
            if (c.joint != reaction.joint) { continue; }
            const auto block = e.jacobian().block(c.first_row, e.system().body_column(body, 3), c.rows(), 6);
            six += block.transpose() * lambda.segment(c.first_row, c.rows());
        }
        const Vec3 force = six.head<3>();
        const Vec3 arm = reaction.point - state.r[static_cast<std::size_t>(body)];
        const double sign = on_j ? 1.0 : -1.0;
        out.push_back({sign * force, sign * (six.tail<3>() - arm.cross(force))});
    }
    return out;
}

/// Difference of two solutions, over components marked as unique and over the others [N, N m].
struct Apart {
    double unique = 0.0;
    double others = 0.0;
};

void compare(const Reaction& r, const Wrench& a, const Wrench& b, Apart& apart) {
    const Vec3 force = r.axes.transpose() * (a.force - b.force);
    const Vec3 torque = r.axes.transpose() * (a.torque - b.torque);
    for (std::size_t k = 0; k < 3; ++k) {
        const auto c = static_cast<Eigen::Index>(k);
        double& f = r.force_unique[k] ? apart.unique : apart.others;
        f = std::max(f, std::abs(force(c)));
        double& n = r.torque_unique[k] ? apart.unique : apart.others;
        n = std::max(n, std::abs(torque(c)));
    }
}

Apart apart(const Reactions& joints, const std::vector<Wrench>& a, const std::vector<Wrench>& b) {
    Apart out;
    for (std::size_t n = 0; n < a.size(); ++n) { compare(joints.reactions[n], a[n], b[n], out); }
    return out;
}

double not_unique(const Reactions& joints) {
    double count = 0.0;
    for (const Reaction& r : joints.reactions) {
        count += double(std::ranges::count(r.force_unique, false));
        count += double(std::ranges::count(r.torque_unique, false));
    }
    return count;
}

}  // namespace

/// The four-bar on an inclined table: its weight also acts across its plane.
Result which_reactions() {
    Lesson lesson = shipped_lesson("dynamics/four-bar-1.toml");
    lesson.dynamics->loads.gravity = Vec3(0.0, -9.0, -4.0);
    const Centroidal scene = centroidal_of(lesson);
    const std::vector<double> y = flat_start(scene.mechanism);
    std::vector<double> y_dot(y.size());
    DenseEquations<OmegaGlobal> e(scene);
    std::vector<double> in_global(y.size());
    e.from_flat(y.data(), in_global.data());
    e.evaluate(0.0, in_global.data(), y_dot.data());
    const State state = start_state(scene.mechanism);
    const Layout<OmegaGlobal> layout(e.system());
    const Reactions ours = find_reactions(
        scene, 0.0, state, start_motion(scene.mechanism), layout.acceleration_of(state, e.acceleration()));

    std::vector<int> order(static_cast<std::size_t>(e.rows()));
    std::iota(order.begin(), order.end(), 0);
    const std::vector<Wrench> first = wrenches_with(pick(e.jacobian(), order), e, ours, state);
    std::ranges::reverse(order);
    const std::vector<Wrench> last = wrenches_with(pick(e.jacobian(), order), e, ours, state);
    std::vector<Wrench> smallest;
    for (const Reaction& r : ours.reactions) { smallest.push_back(r.wrench); }
    const Apart picks = apart(ours, first, last);
    const Apart from_ours = apart(ours, first, smallest);

    Result result;
    result.naive =
        "the first 17 rows and the last 17 give the same motion but different forces in the joints, each "
        "with 15 digits. There is no reason to prefer one of them.";
    result.ours =
        "the smallest solution is shown with the family of all others, and every component is marked as "
        "unique or not. The unique components are the same for every choice of rows.";
    result.measurements = {
        of_naive("difference of two choices, components not unique [N, N m]", picks.others, at_least(0.1)),
        // rounding of forces of 30 N
        of_both(
            "difference, components marked unique [N, N m]", picks.unique, at_most(1e-11), from_ours.unique,
            at_most(1e-11)),
        // along x and y forces are unique, about z torques are zero
        of_ours("components marked unique, of 24", 24.0 - not_unique(ours), exactly(12)),
        of_ours("members of the family", double(ours.family.size()), exactly(3)),
        of_ours("part of M q̈ - Q that no reaction explains", ours.residual, at_most(1e-13)),
    };
    return result;
}

}  // namespace jw::hard
